// Models that are read piece by piece, for a file need not fit into memory. A piece is 64 KiB first and then 1 MiB, so
// that those here, of some MiB, take several.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "pipeline/formats/model_reader.h"
#include "pipeline/formats/scene_reader.h"
#include "tests/support/files.h"
#include "tests/support/gltf_files.h"
#include "tests/support/model_files.h"

namespace pipeline {
namespace {

namespace fs = std::filesystem;

const FileLoader kNoOtherFiles = [](std::string_view) -> Result<NamedFile> { return Error{{}, "no files", {}}; };

void expectTheSameModel(const std::vector<Object>& one, const std::vector<Object>& other) {
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
        const Mesh &a = *one[i].mesh, &b = *other[i].mesh;
        EXPECT_TRUE(a.positions == b.positions);
        EXPECT_TRUE(a.triangles == b.triangles);
        EXPECT_TRUE(a.corners == b.corners);
        EXPECT_TRUE(a.firstCorner == b.firstCorner);
        EXPECT_TRUE(a.polygonPlaces == b.polygonPlaces);
    }
}

class LargeModel : public testing::Test {
protected:
    // The same from a file as from a text that is in memory as a whole.
    void expectTheSameFromAFile(const std::string& text, const std::string& name) {
        test::writeText(folder / name, text);
        const Result<Scene> scene = readScene(folder / name);
        ASSERT_TRUE(scene) << format(scene.errors());
        const Result<LoadedModel> model = readModel({text, name}, fs::path(name).extension().string(), kNoOtherFiles);
        ASSERT_TRUE(model);
        EXPECT_GT(model->objects[0].mesh->polygonCount(), 1u);
        expectTheSameModel(scene->objects, model->objects);
    }
    test::TemporaryFolder folder;
};

TEST_F(LargeModel, IsTheSameReadInPieces) {
    constexpr int kMany = 40'000;
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        expectTheSameFromAFile(test::objText(kMany, end), "m.obj");
        expectTheSameFromAFile(test::plyText(kMany, end), "m.ply");
        expectTheSameFromAFile(test::stlText(kMany, end), "m.stl");
    }
    expectTheSameFromAFile(test::plyBytes(kMany), "m.ply");
    expectTheSameFromAFile(test::stlBytes(kMany), "m.stl");
}

// Every place of a line's end at the end of a piece: 64 KiB and what follows are multiples of 4, so that of lines of 4
// bytes after a comment of 0 to 3 more each one is met.
TEST_F(LargeModel, LosesNoLineBetweenPieces) {
    std::string lines;
    for (int i = 0; i < 700'000; ++i) lines += "#\\\r\n";
    for (int more = 0; more < 4; ++more) {
        const std::string text =
            std::string(std::size_t(more) + 1, '#') + "\n" + lines + "\nv 0 0 0\nv 1 0 0\nv 0 1 x\n";
        test::writeText(folder / "m.obj", text);
        const Result<Scene> scene = readScene(folder / "m.obj");
        ASSERT_FALSE(scene);
        // 700 000 lines after the first, an empty one, and the third vertex.
        EXPECT_EQ(scene.errors().front().where.line, 700'005);
        EXPECT_EQ(scene.errors().front().where.column, 7);
    }
}

TEST_F(LargeModel, OfAnySizeIsRead) {
    std::ofstream file(folder / "m.obj", std::ios::binary);
    const std::string comment = "# " + std::string(65'000, 'c') + "\n";
    for (std::size_t bytes = 0; bytes <= kMaxFileBytes; bytes += comment.size()) file << comment;
    file << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    file.close();
    ASSERT_GT(fs::file_size(folder / "m.obj"), kMaxFileBytes);
    const Result<Scene> scene = readScene(folder / "m.obj");
    ASSERT_TRUE(scene) << format(scene.errors());
    EXPECT_EQ(scene->objects[0].mesh->polygonCount(), 1u);
    test::writeText(folder / "s.toml", "[[object]]\nmodel = \"m.obj\"\n");
    EXPECT_TRUE(readScene(folder / "s.toml")) << "a scene may name it";
}

TEST_F(LargeModel, WithAnEndlessLineIsRefused) {
    test::writeText(folder / "m.obj", "v 0 0 0\n");
    fs::resize_file(folder / "m.obj", std::uintmax_t(kMaxFileBytes) + 1000);  // zeros, none of them on the disk
    const Result<Scene> scene = readScene(folder / "m.obj");
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.errors().front().found, "found a line of more than 268 435 456 bytes");
    EXPECT_EQ(scene.errors().front().where.line, 2);
}

TEST_F(LargeModel, AsGltfHasALimit) {
    test::writeText(folder / "m.gltf", "{}");
    fs::resize_file(folder / "m.gltf", std::uintmax_t(kMaxFileBytes) + 1);
    const Result<Scene> scene = readScene(folder / "m.gltf");
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.errors().front().found, "the file is larger than 268 435 456 bytes");
}

// A text whose first bytes are in memory, and the rest comes in pieces.
SourceText inPieces(std::string_view text, std::size_t start, std::size_t piece, std::size_t missing = 0) {
    const std::size_t size = text.size() - start;
    auto rest = std::make_unique<std::istringstream>(std::string(text.substr(start, size - missing)));
    return {text.substr(0, start), "m", {}, std::make_shared<FileTail>(std::move(rest), size, piece)};
}

// Pieces of a few bytes: everything is cut somewhere, the text's end falls together with a piece's, and errors name
// what was read before it.
TEST_F(LargeModel, IsTheSameHoweverItIsCut) {
    const std::pair<std::string, std::string> texts[]{
        {".obj", test::objText(20, "\r\n")},
        {".obj", test::objText(20) + "f 1 \\\n2 3 # and \\\r\nv 1 2"},
        {".obj", test::objText(20, "\r") + "f 1 2 3"},
        {".ply", test::plyText(20, "\r\n")},
        {".ply", test::plyText(20).substr(0, 700)},
        {".ply", test::plyBytes(20)},
        {".stl", test::stlText(20)},
        {".stl", test::stlText(20).substr(0, 2000)},
        {".stl", test::stlText(20, " ")},  // all on one line
        {".stl", test::stlBytes(40)},
    };
    for (const auto& [extension, text] : texts)
        for (const std::size_t start : {600, 601, 602, 603})  // what tells an STL file's form is in the beginning
            for (const std::size_t piece : {1, 2, 5, 64}) {
                const Result<LoadedModel> whole = readModel({text, "m"}, extension, kNoOtherFiles);
                const Result<LoadedModel> cut = readModel(inPieces(text, start, piece), extension, kNoOtherFiles);
                ASSERT_EQ(bool(whole), bool(cut)) << extension << start << piece;
                if (whole)
                    expectTheSameModel(whole->objects, cut->objects);
                else
                    EXPECT_EQ(format(whole.errors()), format(cut.errors()));
            }
}

// A file that is written anew while it is read.
TEST_F(LargeModel, ThatEndsEarlierThanTheFileSystemSaidIsRefused) {
    const auto readShort = [](const std::string& bytes, const std::string& extension) {
        return readModel(inPieces(bytes, 1000, 1 << 16, 500), extension, kNoOtherFiles);
    };
    const Result<LoadedModel> model = readShort(test::stlBytes(60'000), ".stl");
    ASSERT_FALSE(model);
    EXPECT_EQ(model.errors().front().found, "the file ends after 2 999 584 bytes");  // 84 + 60 000 × 50 - 500
    EXPECT_FALSE(readShort(test::plyBytes(60'000), ".ply"));
    EXPECT_FALSE(readShort(test::plyText(60'000), ".ply"));
    EXPECT_FALSE(readShort(test::stlText(60'000), ".stl"));
}

}  // namespace
}  // namespace pipeline
