// What opening a file costs: how often a stop is looked at while it is read, and what is built of a few words.
#include "pipeline/formats/text/read_budget.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <iterator>

#include <fmt/format.h>

#include "pipeline/formats/model_reader.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/formats/text/stoppable_text.h"
#include "pipeline/formats/toml/toml_scene.h"
#include "pipeline/scene/mesh/make_mesh.h"
#include "tests/support/files.h"
#include "tests/support/gltf_files.h"
#include "tests/support/looks.h"
#include "tests/support/model_files.h"

namespace pipeline {
namespace {

using test::Looks;

constexpr int kTriangles = 20'000;

std::string description() {
    std::string text = fmt::format("{} {}\n", 3 * kTriangles, kTriangles);
    for (int i = 0; i < 3 * kTriangles; ++i) text += test::cornerText(i / 3, i % 3) + "\n";
    for (int i = 0; i < kTriangles; ++i) text += fmt::format("3 {} {} {}\n", 3 * i, 3 * i + 1, 3 * i + 2);
    return text + "1 1 1 0.5 10\n";
}

std::string tomlMesh() {
    std::string vertices, polygons;
    for (int i = 0; i < kTriangles; ++i) {
        vertices += fmt::format("[{0}, 0, 0], [{0}, 1, 0], [{0}, 0, 1],\n", i);
        polygons += fmt::format("[{}, {}, {}],\n", 3 * i, 3 * i + 1, 3 * i + 2);
    }
    return fmt::format("[[object]]\nvertices = [{}]\npolygons = [{}]\n", vertices, polygons);
}

std::string gltf() {
    std::string bytes;
    for (int i = 0; i < kTriangles; ++i)
        bytes += test::bytesOf<float>({float(i), 0, 0, float(i + 1), 0, 0, float(i), 1, 0});
    test::Parts parts = test::squareParts();
    parts["buffers"] = fmt::format(R"([{{"byteLength": {}, "uri": "{}"}}])", bytes.size(), test::dataUri(bytes));
    parts["bufferViews"] = fmt::format(R"([{{"buffer": 0, "byteLength": {}}}])", bytes.size());
    parts["accessors"] =
        fmt::format(R"([{{"bufferView": 0, "componentType": 5126, "count": {}, "type": "VEC3"}}])", 3 * kTriangles);
    parts["meshes"] = R"([{"primitives": [{"attributes": {"POSITION": 0}}]}])";
    return test::fileOf(parts);
}

// One polygon whose outline is a comb: concave at every second corner.
std::string comb() {
    constexpr int kTeeth = 10'000;
    std::string text, face = "f";
    for (int i = 0; i < kTeeth; ++i) text += fmt::format("v {} 1 0\nv {} {} 0\n", i, i + 0.5, i % 2 == 0 ? 0.5 : 0.25);
    text += fmt::format("v {} -1 0\nv 0 -1 0\n", kTeeth);
    for (int i = 2 * kTeeth + 2; i > 0; --i) face += fmt::format(" {}", i);
    return text + face + "\n";
}

struct LongFile {
    const char* name;
    std::string (*text)();
};

class StopWhileReading : public testing::TestWithParam<LongFile> {
protected:
    StopWhileReading() { test::writeText(file, GetParam().text()); }
    test::TemporaryFolder folder;
    std::filesystem::path file = folder / GetParam().name;
};

// An item is a microsecond's work at most: 10 looks are 41 ms.
TEST_P(StopWhileReading, IsSeenAtTheNextLook) {
    Looks whole;
    ASSERT_TRUE(readScene(file, {{}, Looks::stop()}));
    const std::size_t looks = Looks::count();
    EXPECT_GE(looks, 20u) << "of so many triangles";
    EXPECT_GE(Looks::items(), std::size_t(6 * kTriangles)) << "reading and making a mesh both look";
    for (int part = 0; part <= 8; ++part) {
        const std::size_t at = 1 + part * (looks - 1) / 8;
        const Looks stopping(at);
        const auto scene = readScene(file, {{}, Looks::stop()});
        ASSERT_FALSE(scene) << at;
        EXPECT_EQ(format(scene.errors()), file.string() + ": reading was stopped\n");
        EXPECT_LE(Looks::count(), at + 10);
    }
}

std::string ball() { return "[[object]]\nshape = \"sphere\"\ntessellation = 200\n"; }
std::string teapot() { return "[[object]]\nshape = \"teapot\"\ntessellation = 64\n"; }
std::string obj() { return test::objText(kTriangles); }
std::string plyText() { return test::plyText(kTriangles); }
std::string plyBytes() { return test::plyBytes(kTriangles); }
std::string stlText() { return test::stlText(kTriangles); }
std::string stlBytes() { return test::stlBytes(kTriangles); }

INSTANTIATE_TEST_SUITE_P(Formats, StopWhileReading,
                         testing::Values(LongFile{"a.obj", obj}, LongFile{"comb.obj", comb}, LongFile{"a.ply", plyText},
                                         LongFile{"b.ply", plyBytes}, LongFile{"a.stl", stlText},
                                         LongFile{"b.stl", stlBytes}, LongFile{"a.gltf", gltf},
                                         LongFile{"a.des", description}, LongFile{"mesh.toml", tomlMesh},
                                         LongFile{"ball.toml", ball}, LongFile{"teapot.toml", teapot}),
                         [](const auto& which) {
                             std::string name = which.param.name;
                             std::ranges::replace(name, '.', '_');
                             return name;
                         });

// Loads from memory, and counts.
struct CountingLoader {
    std::map<std::string, std::string, std::less<>> files;
    std::shared_ptr<int> loads = std::make_shared<int>(0);
    Result<NamedFile> operator()(std::string_view name) const {
        ++*loads;
        const auto found = files.find(std::filesystem::path(name).lexically_normal().string());
        if (found == files.end()) return Error{{}, "no such file"};
        return NamedFile{found->second, std::string(name)};
    }
};

std::string times(int count, std::string_view text) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
}

TEST(ReadBudget, AMaterialFileIsReadOnceHoweverOftenItIsNamed) {
    const CountingLoader load{{{"a.mtl", "newmtl m\nKd 1 0 0\n"}}};
    const std::string text = times(1000, "mtllib a.mtl\nmtllib ./a.mtl\nmtllib b/../a.mtl\nmtllib a.mtl a.mtl\n") +
                             "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n";
    const auto model = readModel({text, "m.obj"}, ".obj", load);
    ASSERT_TRUE(model) << format(model.errors());
    EXPECT_EQ(model->objects[0].material.diffuse, Vec3d(1, 0, 0));
    EXPECT_LE(*load.loads, 8) << "each spelling once, and other readings of the one with a space";
}

TEST(ReadBudget, AMeshAndAModelAreReadAndBuiltOnceHoweverOftenTheyAreNamed) {
    const CountingLoader load{{{"a.des", "3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n1 1 1 0.5 10\n"},
                               {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}}};
    for (const char* named : {"mesh = \"a.des\"", "model = \"a.obj\""}) {
        *load.loads = 0;
        const std::string other = std::string(named).insert(std::string_view(named).find('a'), "b/.././");
        const auto scene =
            readTomlScene({times(50, fmt::format("[[object]]\n{}\n[[object]]\n{}\n", named, other)), "s.toml"}, load);
        ASSERT_TRUE(scene) << format(scene.errors());
        ASSERT_EQ(scene->objects.size(), 100u);
        EXPECT_EQ(*load.loads, 1) << named;
        for (const Object& object : scene->objects) EXPECT_EQ(object.mesh, scene->objects[0].mesh);
    }
}

const FileLoader kNoFiles = [](std::string_view) -> Result<NamedFile> { return Error{}; };

// 300 spheres of 2 · 4 · 256 · 511 triangles pass 2^27 at the 129th, whose table begins in line 3 · 128 + 1.
TEST(ReadBudget, ShapesAreCountedBeforeTheFirstIsBuilt) {
    const Looks looks;
    const std::string text = times(300, "[[object]]\nshape = \"sphere\"\ntessellation = 256\n");
    const auto scene = readTomlScene({text, "s.toml", {{}, Looks::stop()}}, kNoFiles);
    ASSERT_FALSE(scene);
    EXPECT_EQ(format(scene.errors()),
              "s.toml:385:1: all objects up to this one have too many vertices or triangles, expected at most "
              "134 217 728 of each\n");
    EXPECT_LT(Looks::items(), 4 * text.size()) << "the text has been read, and no sphere built";
}

// Sixteen spheres of different fineness are more than 64 KiB may ask for; one mesh for all equal ones is not.
TEST(ReadBudget, DifferentShapesAreCountedAgainstTheSizeOfTheFile) {
    std::string different, equal;
    for (int i = 0; i < 16; ++i) {
        different += fmt::format("[[object]]\nshape = \"sphere\"\ntessellation = {}\n", 256 - i);
        equal += "[[object]]\nshape = \"sphere\"\ntessellation = 100\n";
    }
    const Looks looks;
    const auto refused = readTomlScene({different, "s.toml", {{}, Looks::stop()}}, kNoFiles);
    ASSERT_FALSE(refused);
    // 4 n (2 n - 1) + 2 for n = 256 … 252 are 523266 + 519182 + 515114 + 511062 + 507026 = 2575650.
    EXPECT_EQ(
        format(refused.errors()),
        "s.toml:13:1: the different shapes up to this one have 2 575 650 vertices, expected at most 2 359 296 in a "
        "file of this size: less tessellation\n");
    EXPECT_LT(Looks::items(), 4 * different.size());
    const auto scene = readTomlScene({equal, "s.toml"}, kNoFiles);
    ASSERT_TRUE(scene) << format(scene.errors());
    EXPECT_EQ(scene->objects.front().mesh, scene->objects.back().mesh);
}

TEST(ReadBudget, AnyOneShapeIsWithinIt) {
    for (std::size_t kind = 0; kind < kShapeCount; ++kind)
        EXPECT_LE(mostVerticesOf({static_cast<ShapeKind>(kind), 256}), ReadBudget::kVerticesPerPiece);
}

TEST(ReadBudget, ShapesHaveAsManyVerticesAsWereCounted) {
    for (std::size_t kind = 0; kind < kShapeCount; ++kind)
        for (const int n : {1, 2, 3, 8, 17}) {
            const Shape shape{static_cast<ShapeKind>(kind), n};
            const auto mesh = makeShape(shape);
            EXPECT_LE(mesh->positions.size(), mostVerticesOf(shape)) << name(shape.kind) << n;
            EXPECT_LE(mesh->triangles.size(), mostTrianglesOf(shape)) << name(shape.kind) << n;
            if (shape.kind == ShapeKind::Teapot) continue;
            EXPECT_EQ(mesh->positions.size(), mostVerticesOf(shape)) << name(shape.kind) << n;
            EXPECT_EQ(mesh->triangles.size(), mostTrianglesOf(shape)) << name(shape.kind) << n;
        }
}

// 4000 nodes of one mesh of 2000 vertices, in some 100 KB: 8 million vertices.
TEST(ReadBudget, NodesThatRepeatAMeshAreCountedAgainstTheSizeOfTheFile) {
    constexpr int kNodes = 4000, kVertices = 2000;
    const std::string bytes(std::size_t(12 * kVertices), '\0');
    test::Parts parts = test::squareParts();
    parts["buffers"] = fmt::format(R"([{{"byteLength": {}, "uri": "{}"}}])", bytes.size(), test::dataUri(bytes));
    parts["bufferViews"] = fmt::format(R"([{{"buffer": 0, "byteLength": {}}}])", bytes.size());
    parts["accessors"] =
        fmt::format(R"([{{"bufferView": 0, "componentType": 5126, "count": {}, "type": "VEC3"}}])", kVertices);
    parts["meshes"] = R"([{"primitives": [{"attributes": {"POSITION": 0}}]}])";
    std::string nodes = "{\"mesh\": 0}", numbers = "0";
    for (int i = 1; i < kNodes; ++i) nodes += ", {\"mesh\": 0}", numbers += fmt::format(", {}", i);
    parts["nodes"] = "[" + nodes + "]";
    parts["scenes"] = "[{\"nodes\": [" + numbers + "]}]";
    const std::string text = test::fileOf(parts);
    ASSERT_LT(text.size(), 2 * ReadBudget::kPiece);
    const auto model = readModel({text, "m.gltf"}, ".gltf", kNoFiles);
    ASSERT_FALSE(model);
    EXPECT_NE(format(model.errors()).find("in a file of this size"), std::string::npos) << format(model.errors());
}

TEST(ReadBudget, ReadingEndsWithTheFirstErrorsOfAFileAndSaysSo) {
    std::string text;
    for (int i = 0; i < 5000; ++i) text += fmt::format("k{} = 1\n", 9999 - i);
    const auto scene = readTomlScene({text, "s.toml"}, kNoFiles);
    ASSERT_FALSE(scene);
    ASSERT_EQ(scene.errors().size(), kMaxErrors);
    for (int i = 0; i < int(kMaxErrors); ++i) EXPECT_EQ(scene.errors()[std::size_t(i)].where.line, i + 1);
    EXPECT_TRUE(format(scene.errors()).ends_with("These are the first errors; there may be more.\n"));
}

TEST(StoppableText, GivesTheWholeTextAndEndsWhereItIsStopped) {
    std::string text;
    for (int i = 0; i < 5000; ++i) text += fmt::format("line {}\n", i);
    StoppableBuffer whole(text, {});
    std::istream stream(&whole);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), text);
    stream.clear(), stream.seekg(4090);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), text.substr(4090));

    const Looks stopping(3);
    StoppableBuffer half(text, Looks::stop());
    std::istream ended(&half);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(ended), {}).size(), 2 * StopCheck::kItemsPerLook);
}

}  // namespace
}  // namespace pipeline
