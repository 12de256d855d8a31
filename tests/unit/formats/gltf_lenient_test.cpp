// glTF that is valid though seldom written so, and faults beside the geometry, which refuse nothing of it.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/formats/model_reader.h"
#include "tests/support/gltf_files.h"

namespace pipeline {
namespace {

using test::bytesOf, test::dataUri, test::fileOf, test::filesOf, test::glbOf, test::Parts, test::squareParts,
    test::kSquare, test::kIndices, test::kNormals, test::kJson, test::kBin;

LoadedModel modelOf(const std::string& text) {
    const Result<LoadedModel> model = readModel({text, "m.gltf"}, ".gltf", filesOf({}));
    EXPECT_TRUE(model) << (model ? "" : format(model.errors()));
    return model ? *model : LoadedModel{};
}
std::string errorsOf(const std::string& text) {
    const Result<LoadedModel> model = readModel({text, "m.gltf"}, ".gltf", filesOf({}));
    return model ? "" : format(model.errors());
}
bool hasRemark(const LoadedModel& model, std::string_view text) {
    return std::ranges::any_of(model.remarks, [&](const Remark& remark) { return remark.text == text; });
}
bool isSquare(const LoadedModel& model) {
    return model.objects.size() == 1 &&
           model.objects[0].mesh->positions == std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}} &&
           model.objects[0].mesh->polygonCount() == 2;
}

// JSON has numbers and no integers (RFC 8259, section 6): 5126.0 and 0.4e1 are 5126 and 4.
TEST(GltfLenient, IntegersMayBeWrittenWithAPointOrAnExponent) {
    EXPECT_TRUE(isSquare(
        modelOf(fileOf("accessors", R"([{"bufferView": 0.0, "componentType": 5126.0, "count": 0.4e1, "type": "VEC3"},
                                {"bufferView": 1e0, "componentType": 51.23e2, "count": 6.0, "type": "SCALAR"}])"))));
    EXPECT_TRUE(isSquare(modelOf(fileOf("nodes", R"([{"mesh": 0.0}])"))));
    EXPECT_EQ(errorsOf(fileOf("nodes", R"([{"mesh": -0.5}])")),
              "m.gltf: /nodes/0/mesh is -0.5, expected an index of meshes, 0\n");
    EXPECT_EQ(errorsOf(fileOf("nodes", R"([{"mesh": 1e300}])")),
              "m.gltf: /nodes/0/mesh is 1e300, expected an index of meshes, 0\n");
}

// Vertex 2 of the square moves to (5, 6, 7), the others stay.
TEST(GltfLenient, SparseAccessorsReplaceSomeElements) {
    Parts parts = squareParts();
    const std::string index = bytesOf<std::uint16_t>({2, 0}), value = bytesOf<float>({5, 6, 7});
    const auto withBase = [&](const std::string& base) {
        parts["accessors"] = R"([{)" + base + R"("componentType": 5126, "count": 4, "type": "VEC3",
                                  "sparse": {"count": 1, "indices": {"bufferView": 2, "componentType": 5123},
                                             "values": {"bufferView": 2, "byteOffset": 4}}},
                                {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}])";
        parts["bufferViews"] = R"([{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12},
                                   {"buffer": 0, "byteOffset": 60, "byteLength": 16}])";
        parts["buffers"] =
            fmt::format(R"([{{"byteLength": 76, "uri": "{}"}}])", dataUri(kSquare + kIndices + index + value));
        return modelOf(fileOf(parts));
    };
    EXPECT_EQ(withBase(R"("bufferView": 0, )").objects.at(0).mesh->positions,
              (std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {5, 6, 7}, {0, 1, 0}}));
    // Without a bufferView the others are 0 (section 5.1.1): both triangles lose their area.
    EXPECT_EQ(errorsOf(fileOf(parts)), "");
    parts["accessors"].replace(parts["accessors"].find(R"("bufferView": 0, )"), 17, "");
    EXPECT_TRUE(
        errorsOf(fileOf(parts)).starts_with("m.gltf: found no polygon; 2 polygons have fewer than three different "))
        << errorsOf(fileOf(parts));
}

// Normals of 0 have no direction: the square is there, without them.
TEST(GltfLenient, AccessorsWithoutABufferViewAreZeros) {
    Parts parts = squareParts();
    parts["meshes"] = R"([{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 2}, "indices": 1}]}])";
    parts["accessors"] = R"([{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                             {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"},
                             {"componentType": 5126, "count": 4, "type": "VEC3"}])";
    const LoadedModel model = modelOf(fileOf(parts));
    EXPECT_TRUE(isSquare(model));
    EXPECT_TRUE(model.objects[0].mesh->normals.empty());
    EXPECT_TRUE(hasRemark(model, "Some normals have no length; the normals of their object are not used (1 object)."));
}

// 2^27 zeros in 200 bytes: the count is not trusted.
TEST(GltfLenient, ElementsWithoutBytesAreLimited) {
    EXPECT_EQ(
        errorsOf(fileOf("accessors", R"([{"componentType": 5126, "count": 134217728, "type": "VEC3"},
                                               {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}])")),
        "m.gltf: up to /accessors/0 the file has 134 217 728 elements without bytes, expected at most 4 194 304\n");
}

// 1.0000001192092896 is the float after 1. What the file means by it is 1.
TEST(GltfLenient, RoundingErrorsRefuseNothing) {
    EXPECT_TRUE(isSquare(modelOf(fileOf("nodes", R"([{"mesh": 0, "rotation": [0, 0, 0, 1.0000001192092896]}])"))));
    EXPECT_TRUE(isSquare(
        modelOf(fileOf("nodes", R"([{"mesh": 0, "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1.0000001192092896]}])"))));
    Parts parts = squareParts();
    parts["meshes"] = R"([{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}])";
    parts["materials"] = R"([{"pbrMetallicRoughness": {"baseColorFactor": [1.0000001192092896, 0, -1e-9, 1],
                                                       "metallicFactor": 0}}])";
    const LoadedModel model = modelOf(fileOf(parts));
    EXPECT_TRUE(isSquare(model));
    EXPECT_EQ(model.objects[0].material.diffuse, Vec3d(1, 0, 0));
    EXPECT_TRUE(
        hasRemark(model, "A factor of a material lies beyond 0 to 1; it counts as the nearer of the two (2 factors)."));
}

// k_d and k_s are the diffuse and specular factors; with glossiness 1/2 α is 1/4, and n = 2 · 16 - 2.
TEST(GltfLenient, SpecularAndGlossinessTakeThePlaceOfMetallicRoughness) {
    Parts parts = squareParts();
    parts["meshes"] = R"([{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}])";
    parts["materials"] = R"([{"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}, "alphaMode": "BLEND",
        "extensions": {"KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [0.25, 0.5, 0.75, 0.5],
        "specularFactor": [0.125, 0.25, 0.5], "glossinessFactor": 0.5}}}])";
    parts["extensionsUsed"] = R"(["KHR_materials_pbrSpecularGlossiness"])";
    const LoadedModel model = modelOf(fileOf(parts));
    const Material& material = model.objects.at(0).material;
    EXPECT_EQ(material.diffuse, Vec3d(0.25, 0.5, 0.75));
    EXPECT_EQ(material.ambient, Vec3d(0.25, 0.5, 0.75));
    EXPECT_EQ(material.specular, Vec3d(0.125, 0.25, 0.5));
    EXPECT_EQ(material.exponent, 30);
    EXPECT_EQ(material.alpha, 0.5);
    EXPECT_TRUE(model.remarks.empty());
}

TEST(GltfLenient, RequiredExtensionsBesideTheGeometryAreLeftOut) {
    for (const char* name :
         {"KHR_texture_transform", "KHR_materials_unlit", "KHR_materials_transmission", "KHR_techniques_webgl"}) {
        Parts parts = squareParts();
        parts["extensionsRequired"] = parts["extensionsUsed"] = fmt::format(R"(["{}"])", name);
        const LoadedModel model = modelOf(fileOf(parts));
        EXPECT_TRUE(isSquare(model)) << name;
        ASSERT_EQ(model.remarks.size(), 1u) << name;
        EXPECT_EQ(model.remarks[0].text,
                  fmt::format("The file requires the extension \"{}\", which is not read; the shape "
                              "does not depend on it.",
                              name));
    }
    for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "EXT_mesh_gpu_instancing"})
        EXPECT_EQ(
            errorsOf(fileOf("extensionsRequired", fmt::format(R"(["{}"])", name))),
            fmt::format("m.gltf: /extensionsRequired/0 is \"{}\", which is not read, and the shape depends on it, "
                        "expected a file that does not require it\n",
                        name));
}

TEST(GltfLenient, FaultsBesideTheGeometryAreRemarks) {
    Parts parts = squareParts();
    parts["meshes"] =
        R"([{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 9}, "indices": 1, "material": 3}]}])";
    parts["nodes"] = R"([{"name": 7, "mesh": 0}])";
    LoadedModel model = modelOf(fileOf(parts));
    EXPECT_TRUE(isSquare(model));
    EXPECT_TRUE(model.objects[0].mesh->normals.empty());
    EXPECT_EQ(model.objects[0].material, Material());
    EXPECT_EQ(model.objects[0].name, "m");
    EXPECT_EQ(model.remarks.size(), 3u);
    // A triangle list of four corners ends within its second triangle; of two, within its first.
    parts["meshes"] = R"([{"primitives": [{"attributes": {"POSITION": 0}}]}])";
    model = modelOf(fileOf(parts));
    EXPECT_EQ(model.objects.at(0).mesh->polygonCount(), 1u);
    EXPECT_TRUE(hasRemark(model, "A primitive ends within a triangle; that one is left out (1 primitive)."));
}

TEST(GltfLenient, WithoutTheSceneThatIsShownTheFirstIs) {
    for (const char* scene : {"1", "\"hello\""}) EXPECT_TRUE(isSquare(modelOf(fileOf("scene", scene)))) << scene;
}

// A material with a picture that glows is no lamp: the factor 1 multiplies a picture that is not read.
TEST(GltfLenient, EmissionOfAPictureIsLeftOut) {
    Parts parts = squareParts();
    parts["meshes"] = R"([{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}])";
    parts["materials"] = R"([{"emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 0}}])";
    EXPECT_EQ(modelOf(fileOf(parts)).objects.at(0).material.emission, Vec3d(0));
    parts["materials"] = R"([{"emissiveFactor": [1, 1, 1]}])";
    EXPECT_EQ(modelOf(fileOf(parts)).objects.at(0).material.emission, Vec3d(1));
}

// Chunks are padded with spaces; some programs write zeros.
TEST(GltfLenient, JsonPaddedWithZerosIsRead) {
    Parts parts = squareParts();
    parts["buffers"] = R"([{"byteLength": 108}])";
    std::string json = fileOf(parts);
    json += std::string(4, '\0');
    EXPECT_TRUE(isSquare(modelOf(glbOf({{kJson, json}, {kBin, kSquare + kIndices + kNormals}}))));
}

}  // namespace
}  // namespace pipeline
