// glTF: what small files written by hand become, and what wrong ones get.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "pipeline/formats/model_reader.h"
#include "pipeline/formats/model_scene.h"
#include "pipeline/stages/transform.h"
#include "tests/support/gltf_files.h"

namespace pipeline {
namespace {

using test::base64, test::bytesOf, test::dataUri, test::fileOf, test::filesOf, test::glbOf, test::Parts,
    test::squareParts, test::kSquare, test::kIndices, test::kNormals, test::kJson, test::kBin;

LoadedModel modelOf(const std::string& text, const FileLoader& load = filesOf({})) {
    const Result<LoadedModel> model = readModel({text, "m.gltf"}, ".gltf", load);
    EXPECT_TRUE(model) << (model ? "" : format(model.errors()));
    return model ? *model : LoadedModel{};
}

std::string gltfErrors(const std::string& text, const FileLoader& load = filesOf({})) {
    const Result<LoadedModel> model = readModel({text, "m.gltf"}, ".gltf", load);
    return model ? "" : format(model.errors());
}

TEST(GltfReader, SquareStandsUpright) {
    // (x, y, z) of the file, y up, is (x, -z, y) of ours: the plane z = 0 becomes y = 0, and what
    // faced +z faces -y.
    const LoadedModel model = modelOf(fileOf(squareParts()));
    ASSERT_EQ(model.objects.size(), 1u);
    const Mesh& mesh = *model.objects[0].mesh;
    EXPECT_EQ(model.objects[0].name, "square");
    EXPECT_EQ(mesh.file, "m.gltf");
    EXPECT_EQ(mesh.positions, (std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(model.objects[0].transform.up, UpAxis::Y);
    const ObjectMatrix matrix = makeObjectMatrix(model.objects[0].transform);
    const std::vector<Vec3d> upright{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(toWorld(matrix, mesh.positions[i]), upright[i]);
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{{0, 1, 2}}, {{0, 2, 3}}}));
    EXPECT_TRUE(mesh.normals.empty());
    EXPECT_TRUE(model.remarks.empty());
}

TEST(GltfReader, NormalsAreTheFiles) {
    const std::string text =
        fileOf("meshes", R"([{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 2}, "indices": 1}]}])");
    const LoadedModel model = modelOf(text);
    ASSERT_EQ(model.objects.size(), 1u);
    EXPECT_EQ(model.objects[0].mesh->normals, std::vector<Vec3d>(4, Vec3d(0, 0, 1)));

    const Result<Scene> scene = readModelScene({text, "m.gltf"}, filesOf({}));
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene->settings.normalWeight, NormalWeight::Given);
    EXPECT_EQ(scene->settings.shading, Shading::Phong);
    const Result<Scene> plain = readModelScene({fileOf(squareParts()), "m.gltf"}, filesOf({}));
    ASSERT_TRUE(plain);
    EXPECT_EQ(plain->settings.normalWeight, NormalWeight::Mean);
    EXPECT_EQ(plain->settings.shading, Shading::Flat);
}

TEST(GltfReader, BinaryFileAndFileBeside) {
    Parts parts = squareParts();
    parts["buffers"] = R"([{"byteLength": 108}])";
    const std::string bytes = kSquare + kIndices + kNormals;
    EXPECT_EQ(modelOf(glbOf({{kJson, fileOf(parts)}, {kBin, bytes}})).objects.size(), 1u);
    // Chunks are padded to four bytes; what follows the length is no part of the file.
    EXPECT_EQ(modelOf(glbOf({{kJson, fileOf(parts) + "   "}, {kBin, bytes + '\0'}}) + "rest").objects.size(), 1u);
    parts["buffers"] = R"([{"byteLength": 108, "uri": "my%20square.bin"}])";
    EXPECT_EQ(modelOf(fileOf(parts), filesOf({{"my square.bin", bytes}})).objects.size(), 1u);
}

TEST(GltfReader, BinaryFilesThatEndTooEarly) {
    const std::string bytes = kSquare + kIndices + kNormals;
    Parts parts = squareParts();
    parts["buffers"] = R"([{"byteLength": 108}])";
    const std::string glb = glbOf({{kJson, fileOf(parts)}, {kBin, bytes}});
    for (std::size_t size = 4; size < glb.size(); ++size) EXPECT_NE(gltfErrors(glb.substr(0, size)), "") << size;
    EXPECT_EQ(gltfErrors("glTF"), "m.gltf: the file ends after 4 bytes\n");
    EXPECT_EQ(gltfErrors("glTF" + bytesOf<std::uint32_t>({2, 4000000000u})),
              "m.gltf: 4 000 000 000 bytes announced, the file ends after 12\n");
    EXPECT_EQ(gltfErrors("glTF" + bytesOf<std::uint32_t>({1, 12})),
              "m.gltf: the file is of version 1 of binary glTF, expected version 2\n");
    EXPECT_EQ(gltfErrors("glTF" + bytesOf<std::uint32_t>({2, 20, 4000000000u}) + kJson),
              "m.gltf: a chunk of 4 000 000 000 bytes announced at byte 12, the file ends after 20\n");
    EXPECT_EQ(gltfErrors(glbOf({{kBin, bytes}})),
              "m.gltf: the file's first chunk is not JSON, expected a JSON chunk\n");
    EXPECT_EQ(gltfErrors(glbOf({{kJson, "{\"a\": x}"}})),
              "m.gltf: this is not JSON at byte 26, expected a glTF file\n");
}

TEST(GltfReader, PlacesInJson) {
    EXPECT_EQ(gltfErrors("{\n  \"ä\": x\n}"), "m.gltf:2:8: this is not JSON, expected a glTF file\n");
    EXPECT_EQ(gltfErrors("{\"asset\": 1e999}"), "m.gltf:1:15: this is not JSON, expected a glTF file\n");
    EXPECT_EQ(gltfErrors("{\"asset\": NaN}"), "m.gltf:1:11: this is not JSON, expected a glTF file\n");
    EXPECT_EQ(gltfErrors(""), "m.gltf:1:1: the JSON ends too early, expected a glTF file\n");
    EXPECT_EQ(gltfErrors("[1]"), "m.gltf:1:1: the JSON is an array of 1, expected an object\n");
    // As deep as a parser that calls itself could not go; and within a string, where brackets count nothing.
    const std::string deep(100'000, '[');
    EXPECT_EQ(gltfErrors(deep), "m.gltf:1:65: JSON nests more than 64 deep\n");
    EXPECT_EQ(gltfErrors(fileOf("copyright", "\"\\\"" + deep + "\"")), "");
    std::string many = "{\"a\": [0";
    for (int i = 0; i < 5'000'000; ++i) many += ",0";
    // { and [ count as values, and the text as one: comma 4 194 302, in column 9 + 2 · 4 194 301, is one too many.
    EXPECT_EQ(gltfErrors(many + "]}"), "m.gltf:1:8388611: JSON has more than 4 194 304 values\n");
}

// 1024 nodes that name a mesh of 1025 primitives, of which none leaves anything: 2^20 + 2^10 in a file of 30 KB.
TEST(GltfReader, NodesThatRepeatAMeshWithoutEndAreRefused) {
    std::string nodes, roots, primitives;
    for (int i = 0; i < 1024; ++i) {
        nodes += std::string(i ? "," : "") + R"({"mesh":0})";
        roots += (i ? "," : "") + std::to_string(i);
    }
    for (int i = 0; i < 1025; ++i) primitives += std::string(i ? "," : "") + R"({"mode":0})";
    const std::string text = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[)" + roots +
                             R"(]}],"nodes":[)" + nodes + R"(],"meshes":[{"primitives":[)" + primitives + "]}]}";
    EXPECT_EQ(gltfErrors(text), "m.gltf: the nodes have more than 1 048 576 primitives\n");
}

TEST(GltfReader, WhatIsRefused) {
    const std::string accessor = R"([{"bufferView": 0, "componentType": 5126, "count": %, "type": "VEC3"},
                                     {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}])";
    const auto counted = [&](const std::string& count) {
        std::string text = accessor;
        return fileOf("accessors", text.replace(text.find('%'), 1, count));
    };
    const auto view = [](const std::string& json) {
        return fileOf("bufferViews", "[" + json + R"(, {"buffer": 0, "byteOffset": 48, "byteLength": 12}])");
    };
    const auto buffer = [](const std::string& json) { return fileOf("buffers", "[" + json + "]"); };
    const auto primitive = [](const std::string& json) {
        return fileOf("meshes", R"([{"primitives": [{)" + json + "}]}]");
    };
    struct Case {
        std::string text, error;
    };
    const Case cases[] = {
        {fileOf("asset", ""), "/asset/version is missing, expected \"2.0\""},
        {fileOf("asset", R"({"version": "1.0"})"), "/asset/version is \"1.0\", expected \"2.0\""},
        {fileOf("asset", R"({"version": "2.0", "minVersion": "3.0"})"),
         "/asset/minVersion is \"3.0\", expected \"2.0\""},
        {fileOf("extensionsRequired", R"(["KHR_draco_mesh_compression"])"),
         "/extensionsRequired/0 is \"KHR_draco_mesh_compression\", which is not read, and the shape depends on it, "
         "expected a file that does not require it"},
        {fileOf("scenes", "[7]"), "/scenes/0 is 7, expected an object"},
        {fileOf("scenes", R"([{"nodes": [0, 1]}])"), "/scenes/0/nodes/1 is 1, expected an index of nodes, 0"},
        {fileOf("scenes", R"([{"nodes": [0, 0]}])"),
         "/scenes/0/nodes/1 is 0, expected a node that is no child and stands there once"},
        {fileOf("nodes", R"([{"mesh": 1}])"), "/nodes/0/mesh is 1, expected an index of meshes, 0"},
        {fileOf("nodes", R"([{"mesh": -1}])"), "/nodes/0/mesh is -1, expected an index of meshes, 0"},
        {fileOf("nodes", R"([{"mesh": 0.5}])"), "/nodes/0/mesh is 0.5, expected an index of meshes, 0"},
        {fileOf("nodes", "{}"), "/nodes is an object, expected an array"},
        {fileOf("nodes", R"([{"children": [1, 2]}, {"children": [2]}, {"mesh": 0}])"),
         "node 2 is a child of node 0 and of node 1, expected nodes that are a tree"},
        {fileOf("nodes", R"([{"mesh": 0}, {"children": [2]}, {"children": [1]}])"),
         "node 1 stands below itself, expected nodes that are a tree"},
        {fileOf("nodes", R"([{"children": [0]}])"),
         "/scenes/0/nodes/0 is 0, expected a node that is no child and stands there once"},
        {fileOf("nodes", R"([{"mesh": 0, "rotation": [0, 0, 0, 0]}])"),
         "/nodes/0/rotation is (0, 0, 0, 0), expected a quaternion of length 1"},
        {fileOf("nodes", R"([{"mesh": 0, "matrix": [1, 2]}])"),
         "/nodes/0/matrix is an array of 2, expected an array of 16 numbers"},
        {fileOf("nodes", R"([{"mesh": 0, "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,2]}])"),
         "/nodes/0/matrix is an array of 16, expected a matrix whose last row is 0 0 0 1"},
        {fileOf("nodes", R"([{"mesh": 0, "scale": [1, 1, "1"]}])"),
         "/nodes/0/scale/2 is \"1\", expected a number from -1e9 to 1e9"},
        {fileOf("nodes", R"([{"children": [1], "scale": [1e9, 1, 1]}, {"mesh": 0, "scale": [1e9, 1, 1]}])"),
         "/nodes/1 moves a vertex to (1e18, 0, 0), expected a number from -1e9 to 1e9"},
        {primitive(R"("attributes": {"POSITION": 9})"),
         "/meshes/0/primitives/0/attributes/POSITION is 9, expected an index of accessors, 0 to 2"},
        {primitive(R"("attributes": {"POSITION": 1})"),
         "/accessors/1/type is \"SCALAR\", expected \"VEC3\" for /meshes/0/primitives/0/attributes/POSITION"},
        {primitive(R"("attributes": {"POSITION": 0}, "indices": 0)"),
         "/accessors/0/type is \"VEC3\", expected \"SCALAR\" for /meshes/0/primitives/0/indices"},
        {primitive(R"("attributes": {"POSITION": 0}, "mode": 7)"),
         "/meshes/0/primitives/0/mode is 7, expected a whole number from 0 to 6"},
        {counted("5"), "/accessors/0/count is 5, /bufferViews/0 of 48 bytes has no room for as many"},
        {counted("4294967296"), "/accessors/0/count is 4294967296, expected a whole number from 1 to 134 217 728"},
        {counted("18446744073709551615"),
         "/accessors/0/count is 18446744073709551615, expected a whole number from 1 to 134 217 728"},
        {counted("134217728"), "/accessors/0/count is 134 217 728, /bufferViews/0 of 48 bytes has no room for as many"},
        {counted("0"), "/accessors/0/count is 0, expected a whole number from 1 to 134 217 728"},
        {counted(R"(4, "byteOffset": 1)"),
         "/accessors/0/count is 4, /bufferViews/0 of 48 bytes has no room for as many"},
        {counted(R"(4, "sparse": {"count": 5, "indices": {"bufferView": 1, "componentType": 5123},
                                  "values": {"bufferView": 0}})"),
         "/accessors/0/sparse/count is 5, expected a whole number from 1 to 4"},
        {counted(R"(4, "sparse": {"count": 2, "indices": {"bufferView": 0, "componentType": 5126},
                                  "values": {"bufferView": 0}})"),
         "/accessors/0/sparse/indices/componentType is 5126, expected 5121, 5123 or 5125 for indices"},
        // The indices 0, 1, 2, 0 do not rise.
        {counted(R"(4, "sparse": {"count": 4, "indices": {"bufferView": 1, "componentType": 5123},
                                  "values": {"bufferView": 0}})"),
         "element 3 of /accessors/0/sparse/indices is 0, expected numbers that rise, below 4"},
        {counted("3"), "element 5 of /accessors/1 is 3, expected a vertex index from 0 to 2"},
        {view(R"({"buffer": 1, "byteLength": 48})"), "/bufferViews/0/buffer is 1, expected an index of buffers, 0"},
        {view(R"({"buffer": 0})"), "/bufferViews/0/byteLength is missing, expected a number of bytes"},
        {view(R"({"buffer": 0, "byteOffset": 61, "byteLength": 48})"),
         "/bufferViews/0 ends beyond its buffer of 108 bytes"},
        {view(R"({"buffer": 0, "byteLength": 48, "byteStride": 8})"),
         "/bufferViews/0/byteStride is 8, expected at least 12, the bytes of an element of /accessors/0"},
        {view(R"({"buffer": 0, "byteLength": 48, "byteStride": 16})"),
         "/accessors/0/count is 4, /bufferViews/0 of 48 bytes has no room for as many"},
        {view(R"({"buffer": 0, "byteLength": 48, "byteStride": 3})"),
         "/bufferViews/0/byteStride is 3, expected at least 12, the bytes of an element of /accessors/0"},
        {buffer(R"({"byteLength": 108})"),
         "/buffers/0/uri is missing, expected a URI; only the first buffer of a .glb has none"},
        {buffer(R"({"byteLength": 108, "uri": "x.bin"})"), "/buffers/0/uri: \"x.bin\": no such file"},
        {buffer(R"({"byteLength": 108, "uri": "data:;base64,????"})"),
         "/buffers/0/uri is a data: URI that is not base64, expected data:application/octet-stream;base64,…"},
        {buffer(R"({"byteLength": 108, "uri": "data:;base64,AAAA"})"),
         "/buffers/0/byteLength is 108, its data end after 3 bytes"},
    };
    for (const Case& wrong : cases) EXPECT_EQ(gltfErrors(wrong.text), "m.gltf: " + wrong.error + "\n");
    for (const char* uri : {"http://a/b.bin", "file:///etc/passwd", "/etc/passwd", "../b.bin", "a/../../b.bin", "..",
                            "C:\\b.bin", "%2e%2e/b.bin", "a%", ""})
        EXPECT_EQ(
            gltfErrors(buffer(fmt::format(R"({{"byteLength": 108, "uri": "{}"}})",
                                          uri == std::string("C:\\b.bin") ? "C:\\\\b.bin" : uri))),
            fmt::format("m.gltf: /buffers/0/uri is \"{}\", expected a file in the model's folder, or a data: URI\n",
                        uri == std::string("C:\\b.bin") ? "C:\\\\b.bin" : uri));
}

TEST(GltfReader, NumbersThatAreNone) {
    for (const float value : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -2e9f}) {
        std::string bytes = kSquare + kIndices + kNormals;
        std::memcpy(bytes.data() + 20, &value, 4);  // the z of vertex 1
        EXPECT_TRUE(
            gltfErrors(fileOf("buffers", fmt::format(R"([{{"byteLength": 108, "uri": "{}"}}])", dataUri(bytes))))
                .starts_with("m.gltf: z of element 1 of /accessors/0 is "));
    }
}

}  // namespace
}  // namespace pipeline
