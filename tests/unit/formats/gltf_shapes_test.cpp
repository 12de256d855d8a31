// glTF: the shapes, places and materials that files stand for.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "pipeline/formats/model_reader.h"
#include "pipeline/stages/transform.h"
#include "tests/support/gltf_files.h"

namespace pipeline {
namespace {

using test::bytesOf, test::dataUri, test::fileOf, test::filesOf, test::Parts, test::squareParts;

LoadedModel shapesOf(const std::string& text, std::string_view extension = ".gltf") {
    const Result<LoadedModel> model = readModel({text, "m"}, extension, filesOf({}));
    EXPECT_TRUE(model) << (model ? "" : format(model.errors()));
    return model ? *model : LoadedModel{};
}

// In the world, where z points up.
Vec3d placeOf(const Object& object, std::uint32_t vertex) {
    return toWorld(makeObjectMatrix(object.transform), object.mesh->positions[vertex]);
}
Vec3d normalOf(const Object& object, std::uint32_t vertex) {
    return normalMatrix(makeObjectMatrix(object.transform)) * object.mesh->normals[vertex];
}

using Position = std::array<double, 3>;
// Polygons as their corners' places, each from its smallest corner on, so that the order does not count.
std::multiset<std::vector<Position>> polygonsOf(const Object& object) {
    std::multiset<std::vector<Position>> polygons;
    for (std::size_t i = 0; i < object.mesh->polygonCount(); ++i) {
        std::vector<Position> places;
        for (const std::uint32_t corner : object.mesh->polygon(i)) {
            const Vec3d p = placeOf(object, corner);
            places.push_back({p.x, p.y, p.z});
        }
        std::ranges::rotate(places, std::ranges::min_element(places));
        polygons.insert(places);
    }
    return polygons;
}

// The square with other corners, indices and mode.
std::string drawn(int mode, const std::string& positions, const std::string& indices) {
    Parts parts = squareParts();
    const std::size_t corners = positions.size() / 12;
    parts["accessors"] = fmt::format(
        R"([{{"bufferView": 0, "componentType": 5126, "count": {}, "type": "VEC3"}},
            {{"bufferView": 1, "componentType": 5121, "count": {}, "type": "SCALAR"}}])",
        corners, indices.size());
    parts["bufferViews"] =
        fmt::format(R"([{{"buffer": 0, "byteLength": {0}}}, {{"buffer": 0, "byteOffset": {0}, "byteLength": {1}}}])",
                    positions.size(), indices.size());
    parts["buffers"] = fmt::format(R"([{{"byteLength": {}, "uri": "{}"}}])", positions.size() + indices.size(),
                                   dataUri(positions + indices));
    parts["meshes"] =
        fmt::format(R"([{{"primitives": [{{"attributes": {{"POSITION": 0}}, "indices": 1, "mode": {}}}]}}])", mode);
    return fileOf(parts);
}

// Corners in the file's plane z = 0, which is our y = 0, seen from -y: x to the right, z up.
const std::string kZigzag = bytesOf<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0});

std::string indicesOf(std::initializer_list<std::uint8_t> indices) { return bytesOf<std::uint8_t>(indices); }

TEST(GltfShapes, StripAndFanFaceAsTheirFirstTriangle) {
    // Counter-clockwise as seen: (0,0) (1,0) (0,1), then (1,0) (1,1) (0,1), then (0,1) (1,1) (0,2).
    const std::multiset<std::vector<Position>> strip{
        {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 0, 1}, {1, 0, 0}, {1, 0, 1}}, {{0, 0, 1}, {1, 0, 1}, {0, 0, 2}}};
    EXPECT_EQ(polygonsOf(shapesOf(drawn(5, kZigzag, indicesOf({0, 1, 2, 3, 4}))).objects.at(0)), strip);
    const std::multiset<std::vector<Position>> fan{{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}},
                                                   {{0, 0, 0}, {1, 0, 1}, {0, 0, 2}}};
    EXPECT_EQ(polygonsOf(shapesOf(drawn(6, kZigzag, indicesOf({0, 1, 3, 4}))).objects.at(0)), fan);
    // A strip goes round a corner by triangles without area, which are left out.
    EXPECT_EQ(shapesOf(drawn(5, kZigzag, indicesOf({0, 1, 2, 2, 1, 3}))).objects.at(0).mesh->polygonCount(), 2u);
}

TEST(GltfShapes, PointsAndLinesAreLeftOut) {
    for (const int mode : {0, 1, 2, 3}) {
        const Result<LoadedModel> model =
            readModel({drawn(mode, kZigzag, indicesOf({0, 1, 2})), "m"}, ".gltf", filesOf({}));
        ASSERT_FALSE(model);
        EXPECT_TRUE(format(model.errors()).starts_with("m: found no polygon; "))
            << "and why: " << format(model.errors());
    }
}

TEST(GltfShapes, NodesMoveTurnScaleAndMirror) {
    // Their file's x, y, z; a quarter turn about the file's y takes x to -z, which is our +y.
    const auto corner = [](const std::string& node, std::uint32_t i) {
        const LoadedModel model = shapesOf(fileOf("nodes", "[" + node + "]"));
        return placeOf(model.objects.at(0), i);
    };
    EXPECT_EQ(corner(R"({"mesh": 0, "translation": [1, 2, 3]})", 0), Vec3d(1, -3, 2));
    EXPECT_EQ(corner(R"({"mesh": 0, "scale": [2, 3, 4], "translation": [1, 0, 0]})", 2), Vec3d(3, 0, 3));
    EXPECT_EQ(corner(R"({"mesh": 0, "matrix": [2,0,0,0, 0,3,0,0, 0,0,4,0, 5,6,7,1]})", 2), Vec3d(7, -7, 9));
    const Vec3d turned = corner(R"({"mesh": 0, "rotation": [0, 0.7071067811865476, 0, 0.7071067811865476]})", 1);
    EXPECT_NEAR(glm::length(turned - Vec3d(0, 1, 0)), 0, 1e-15);
    // A quaternion of any length turns as one of length 1.
    const Vec3d unscaled = corner(R"({"mesh": 0, "rotation": [0, 0.5, 0, 0.5]})", 1);
    EXPECT_NEAR(glm::length(unscaled - Vec3d(0, 1, 0)), 0, 1e-15);
    // The parent's transform comes last: scaled, then moved.
    EXPECT_EQ(
        polygonsOf(shapesOf(fileOf("nodes", R"([{"children": [1], "translation": [1, 0, 0]},
                                                     {"mesh": 0, "scale": [2, 2, 2]}])"))
                       .objects.at(0)),
        (std::multiset<std::vector<Position>>{{{1, 0, 0}, {3, 0, 0}, {3, 0, 2}}, {{1, 0, 0}, {3, 0, 2}, {1, 0, 2}}}));
}

TEST(GltfShapes, MirroredNodeKeepsItsOutside) {
    Parts parts = squareParts();
    parts["meshes"] = R"([{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 2}, "indices": 1}]}])";
    parts["nodes"] = R"([{"mesh": 0, "scale": [-1, 1, 1]}])";
    const LoadedModel model = shapesOf(fileOf(parts));
    const Mesh& mesh = *model.objects.at(0).mesh;
    EXPECT_EQ(polygonsOf(model.objects[0]), (std::multiset<std::vector<Position>>{{{-1, 0, 0}, {0, 0, 0}, {-1, 0, 1}},
                                                                                  {{-1, 0, 1}, {0, 0, 0}, {0, 0, 1}}}));
    // The square still faces -y, as its normals say.
    for (std::size_t i = 0; i < mesh.polygonCount(); ++i) {
        const auto at = [&](std::size_t k) { return placeOf(model.objects[0], mesh.polygon(i)[k]); };
        EXPECT_LT(glm::cross(at(1) - at(0), at(2) - at(0)).y, 0);
    }
    for (std::uint32_t i = 0; i < 4; ++i) EXPECT_EQ(normalOf(model.objects[0], i), Vec3d(0, -1, 0));
}

TEST(GltfShapes, NormalsOfASlantedNodeAreInverseTransposed) {
    // The normal (1, 0, 1) / √2 under a scale of (1, 1, 1/2) becomes (1, 0, 2) / √5, ours (1, -2, 0) / √5.
    Parts parts = squareParts();
    const std::string slanted = bytesOf<float>({1, 0, 1, 1, 0, 1, 1, 0, 1, 1, 0, 1});
    parts["buffers"] =
        fmt::format(R"([{{"byteLength": 108, "uri": "{}"}}])", dataUri(test::kSquare + test::kIndices + slanted));
    parts["meshes"] = R"([{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 2}, "indices": 1}]}])";
    parts["nodes"] = R"([{"mesh": 0, "scale": [1, 1, 0.5]}])";
    const Vec3d normal = normalOf(shapesOf(fileOf(parts)).objects.at(0), 0);
    EXPECT_NEAR(glm::length(normal - Vec3d(1, -2, 0) / std::sqrt(5.0)), 0, 1e-15);
}

TEST(GltfShapes, DeepTreesAndTooDeepOnes) {
    const auto chain = [](int levels) {
        std::string nodes;
        for (int i = 0; i + 1 < levels; ++i)
            nodes += fmt::format(R"({{"children": [{}], "translation": [1, 0, 0]}}, )", i + 1);
        return fileOf("nodes", "[" + nodes + R"({"mesh": 0}])");
    };
    EXPECT_EQ(shapesOf(chain(1000)).objects.at(0).mesh->positions[0], Vec3d(999, 0, 0));
    const Result<LoadedModel> tooDeep = readModel({chain(1100), "m"}, ".gltf", filesOf({}));
    ASSERT_FALSE(tooDeep);
    EXPECT_EQ(format(tooDeep.errors()), "m: /nodes/1024 stands below 1024 others, expected at most 1024 levels\n");
}

TEST(GltfShapes, SameMeshAgainAndAgainIsLimited) {
    // 65 536 instances are as many objects as a scene can have; one more is refused.
    std::string nodes, roots;
    for (int i = 0; i <= 65536; ++i) {
        nodes += R"({"mesh": 0},)";
        roots += fmt::format("{},", i);
    }
    Parts parts = squareParts();
    parts["nodes"] = "[" + nodes.substr(0, nodes.size() - 1) + "]";
    parts["scenes"] = R"([{"nodes": [)" + roots.substr(0, roots.size() - 1) + "]}]";
    const Result<LoadedModel> model = readModel({fileOf(parts), "m"}, ".gltf", filesOf({}));
    ASSERT_FALSE(model);
    EXPECT_EQ(format(model.errors()), "m: more than 65 536 objects\n");
}

TEST(GltfShapes, BoxIsThatOfAnObjFile) {
    std::string obj, indices, positions;
    for (int i = 0; i < 8; ++i) {  // x, y, z of ours; the file's are x, z, -y
        const float x = float(i & 1), y = float(i >> 1 & 1), z = float(i >> 2);
        obj += fmt::format("v {} {} {}\n", x, y, z);
        positions += bytesOf<float>({x, z, -y});
    }
    for (const std::array<int, 4>& side :
         {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
        for (const int k : {1, 2}) {
            obj += fmt::format("f {} {} {}\n", side[0] + 1, side[std::size_t(k)] + 1, side[std::size_t(k) + 1] + 1);
            for (const int corner : {side[0], side[std::size_t(k)], side[std::size_t(k) + 1]})
                indices += static_cast<char>(corner);
        }
    const LoadedModel fromObj = shapesOf(obj, ".obj"), fromGltf = shapesOf(drawn(4, positions, indices));
    EXPECT_EQ(polygonsOf(fromObj.objects.at(0)), polygonsOf(fromGltf.objects.at(0)));
    EXPECT_TRUE(fromGltf.objects[0].mesh->facts.closed);
    EXPECT_TRUE(fromGltf.objects[0].mesh->facts.convex);
}

TEST(GltfShapes, VerticesThatDifferInNothingThatIsReadAreOne) {
    // Two triangles with six vertices of their own: a square with four.
    const std::string six = bytesOf<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0});
    EXPECT_EQ(shapesOf(drawn(4, six, indicesOf({0, 1, 2, 3, 4, 5}))).objects.at(0).mesh->positions.size(), 4u);
}

TEST(GltfShapes, QuantizedPositions) {
    Parts parts = squareParts();
    parts["extensionsUsed"] = parts["extensionsRequired"] = R"(["KHR_mesh_quantization"])";
    parts["meshes"] = R"([{"primitives": [{"attributes": {"POSITION": 0}}]}])";
    parts["accessors"] =
        R"([{"bufferView": 0, "componentType": 5120, "count": 3, "type": "VEC3", "normalized": true}])";
    parts["bufferViews"] = R"([{"buffer": 0, "byteLength": 12, "byteStride": 4}])";
    const std::string bytes = bytesOf<std::int8_t>({0, 0, 0, 99, 127, 0, 0, 99, -128, 127, 0, 99});
    parts["buffers"] = fmt::format(R"([{{"byteLength": 12, "uri": "{}"}}])", dataUri(bytes));
    EXPECT_EQ(polygonsOf(shapesOf(fileOf(parts)).objects.at(0)),
              (std::multiset<std::vector<Position>>{{{-1, 0, 1}, {0, 0, 0}, {1, 0, 0}}}));
    // Without the extension positions are floats.
    parts["extensionsUsed"] = parts["extensionsRequired"] = "";
    const Result<LoadedModel> model = readModel({fileOf(parts), "m"}, ".gltf", filesOf({}));
    ASSERT_FALSE(model);
    EXPECT_EQ(format(model.errors()),
              "m: /accessors/0/componentType is 5120, expected 5126 for /meshes/0/primitives/0/attributes/POSITION\n");
}

TEST(GltfShapes, MaterialsByTheManualsFormulas) {
    Parts parts = squareParts();
    parts["meshes"] = R"([{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}])";
    parts["materials"] = R"([{"name": "red", "emissiveFactor": [0, 0, 0.5], "pbrMetallicRoughness":
        {"baseColorFactor": [1, 0.5, 0, 1], "metallicFactor": 0.5, "roughnessFactor": 0.5}}])";
    const Material material = shapesOf(fileOf(parts)).objects.at(0).material;
    EXPECT_EQ(material.diffuse, Vec3d(0.5, 0.25, 0));
    EXPECT_EQ(material.specular, Vec3d(0.52, 0.27, 0.02));  // 0.04 / 2 + baseColor / 2
    EXPECT_EQ(material.ambient, Vec3d(1, 0.5, 0));
    EXPECT_EQ(material.emission, Vec3d(0, 0, 0.5));
    EXPECT_EQ(material.exponent, 30);  // α = 1/4: 2 · 16 - 2
    for (const auto& [roughness, exponent] : {std::pair{"0", 10000.0}, {"0.01", 10000.0}, {"1", 1.0}}) {
        parts["materials"] = fmt::format(R"([{{"pbrMetallicRoughness": {{"roughnessFactor": {}}}}}])", roughness);
        EXPECT_EQ(shapesOf(fileOf(parts)).objects.at(0).material.exponent, exponent);
    }
}

// Base colours with an alpha of 0.25: the mode says what it means, and without one it means nothing.
TEST(GltfShapes, AlphaByItsMode) {
    Parts parts = squareParts();
    parts["meshes"] = R"([{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}])";
    for (const auto& [mode, alpha] : {std::pair{"", 1.0},
                                      {R"(, "alphaMode": "OPAQUE")", 1.0},
                                      {R"(, "alphaMode": "BLEND")", 0.25},
                                      {R"(, "alphaMode": "MASK")", 0.0},
                                      {R"(, "alphaMode": "MASK", "alphaCutoff": 0.25)", 1.0}}) {
        parts["materials"] =
            fmt::format(R"([{{"pbrMetallicRoughness": {{"baseColorFactor": [1, 1, 1, 0.25]}}{}}}])", mode);
        EXPECT_EQ(shapesOf(fileOf(parts)).objects.at(0).material.alpha, alpha) << mode;
    }
    parts["materials"] = R"([{"alphaMode": "GLASS"}])";
    const LoadedModel model = shapesOf(fileOf(parts));  // nothing of the shape depends on it
    EXPECT_EQ(model.objects.at(0).material.alpha, 1);
    EXPECT_EQ(model.remarks.at(0).text,
              "/materials/0/alphaMode is \"GLASS\", expected OPAQUE, MASK or BLEND: what the material has there is not "
              "read (1 material).");
}

TEST(GltfShapes, RemarksAboutWhatIsNotRead) {
    Parts parts = squareParts();
    parts["meshes"] = R"([{"primitives": [{"attributes": {"POSITION": 0, "COLOR_0": 0}, "indices": 1, "material": 0,
                                           "targets": [{}]}, {"attributes": {"POSITION": 0}, "mode": 0}]}])";
    parts["nodes"] = R"([{"mesh": 0, "skin": 0}])";
    parts["materials"] = R"([{"doubleSided": true, "normalTexture": {"index": 0}, "emissiveTexture": {"index": 0}}])";
    parts["extensionsUsed"] = R"(["KHR_lights_punctual"])";
    parts["animations"] = "[]";
    parts["cameras"] = "[]";
    const LoadedModel model = shapesOf(fileOf(parts));
    std::set<std::string> starts;
    for (const Remark& remark : model.remarks) {
        EXPECT_EQ(remark.about, "m");
        starts.insert(remark.text.substr(0, remark.text.find(' ', remark.text.find(' ') + 1)));
    }
    EXPECT_EQ(starts, (std::set<std::string>{"A material", "Animations are", "Morph targets", "Pictures on",
                                             "Points and", "Skins are", "What a"}));
    EXPECT_EQ(model.remarks.size(), starts.size());  // the two pictures have one remark
}

// glTF 2.0, 3.7.2.1: a primitive without normals is flat, also beside one that has some. Two triangles in planes of their
// own: (0, 0, 1) and (1, 0, 0) share the edge from (0, 0, 0) to (0, 1, 0), of which each then has its own vertices.
TEST(GltfShapes, APrimitiveWithoutNormalsIsFlatBesideOthers) {
    const std::string positions = bytesOf<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}), normals = test::kNormals;
    const std::string indices = bytesOf<std::uint16_t>({0, 1, 2, 0, 2, 3});
    Parts parts = squareParts();
    parts["buffers"] = fmt::format(R"([{{"byteLength": 108, "uri": "{}"}}])", dataUri(positions + indices + normals));
    const auto withFirst = [&](const char* attributes) {
        parts["meshes"] = fmt::format(R"([{{"primitives": [{{"attributes": {}, "indices": 1}},
                                                          {{"attributes": {{"POSITION": 0}}, "indices": 1}}]}}])",
                                      attributes);
        return shapesOf(fileOf(parts));
    };
    const LoadedModel model = withFirst(R"({"POSITION": 0, "NORMAL": 2})");
    ASSERT_EQ(model.objects.size(), 2u);
    EXPECT_EQ(model.objects[0].mesh->positions.size(), 4u);
    const Mesh& flat = *model.objects[1].mesh;
    ASSERT_EQ(flat.positions.size(), 6u);
    ASSERT_EQ(flat.normals.size(), 6u);
    const Vec3d expected[]{{0, 0, 1}, {1, 0, 0}};
    for (std::size_t i = 0; i < 2; ++i)
        for (const std::uint32_t corner : flat.polygon(i)) EXPECT_EQ(Vec3d(flat.normals[corner]), expected[i]);
    // Where none has normals the scene's own shading is flat.
    EXPECT_TRUE(withFirst(R"({"POSITION": 0})").objects[1].mesh->normals.empty());
}

}  // namespace
}  // namespace pipeline
