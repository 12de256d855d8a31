// OFF as courses and data sets have it, and files whose names say another format than they hold.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "pipeline/formats/model_reader.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/scene/scene.h"
#include "tests/support/files.h"

namespace pipeline {
namespace {

Result<LoadedModel> readAs(std::string_view text, std::string_view extension = ".off") {
    return readModel({text, "m"}, extension, [](std::string_view) -> Result<NamedFile> {
        return Error{{}, "none", {}};
    });
}
LoadedModel offModelOf(std::string_view text) {
    const Result<LoadedModel> model = readAs(text);
    EXPECT_TRUE(model) << (model ? "" : format(model.errors()));
    return model ? *model : LoadedModel{};
}
std::string readErrorsOf(std::string_view text, std::string_view extension = ".off") {
    const Result<LoadedModel> model = readAs(text, extension);
    return model ? "" : format(model.errors());
}
using Texts = std::vector<std::string>;
Texts offRemarksOf(const LoadedModel& model) {
    Texts texts;
    for (const Remark& remark : model.remarks) texts.push_back(remark.text);
    return texts;
}

// A tetrahedron, and a square below it, two vertices of which are the tetrahedron's.
const std::string kOffRows = "0 0 0\n1 0 0\n0 1 0\n0 0 1.5\n1 1 0\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n4 0 1 4 2\n";

TEST(OffReader, VerticesAndPolygonsWithAnyBeginning) {
    for (const char* head : {"OFF\n5 5 0\n", "OFF 5 5 0\n", "OFF5 5 0\n", "5 5 0\n",
                             "# by hand\nOFF\n# counts\n\n5 5 0\n", "OFF\n5 5\n", "COFF\n5 5 0\n", "OFF\n5\n5\n0\n"}) {
        const LoadedModel model = offModelOf(head + kOffRows);
        ASSERT_EQ(model.objects.size(), 1u) << head;
        const Mesh& mesh = *model.objects[0].mesh;
        EXPECT_EQ(mesh.positions, (std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1.5}, {1, 1, 0}}))
            << head;
        ASSERT_EQ(mesh.polygonCount(), 5u) << head;
        EXPECT_EQ(std::vector(mesh.polygon(1).begin(), mesh.polygon(1).end()), (std::vector<std::uint32_t>{0, 1, 3}));
        EXPECT_EQ(std::vector(mesh.polygon(4).begin(), mesh.polygon(4).end()),
                  (std::vector<std::uint32_t>{0, 1, 4, 2}));
        EXPECT_EQ(offRemarksOf(model), Texts{}) << head;
    }
    EXPECT_EQ(offModelOf("OFF\n5 5 0\n" + kOffRows).objects[0].mesh->polygonPlaces[4], (TextPosition{12, 1}));
}

// Shares of 1, or bytes where any is larger; normals before them, opacities behind.
TEST(OffReader, ColoursOfVertices) {
    const auto colors = [](std::string_view text) {
        const LoadedModel model = offModelOf(text);
        return model.objects.at(0).mesh->colors;
    };
    const std::vector<Vec3d> primaries{{1, 0, 0}, {0, 1, 0}, {0, 0, 0.2}};
    for (const char* text : {"COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 0 1 0 1\n0 1 0 0 0 .2 1\n3 0 1 2\n",
                             "COFF\n3 1 0\n0 0 0 255 0 0\n1 0 0 0 255 0 # green\n0 1 0 0 0 51 9\n3 0 1 2\n",
                             "CNOFF\n3 1 0\n0 0 0 0 0 1 1 0 0\n1 0 0 0 0 1 0 1 0\n0 1 0 0 0 1 0 0 .2\n3 0 1 2\n"}) {
        EXPECT_EQ(colors(text), primaries) << text;
        const bool inBytes = std::string_view(text).find("255") != std::string_view::npos;
        EXPECT_EQ(offRemarksOf(offModelOf(text)).size(), inBytes ? 1u : 0u) << text;
    }
    const std::string some = "COFF\n3 1 0\n0 0 0 1 0 0\n1 0 0 nan 0 0\n0 1 0 0.5\n3 0 1 2\n";
    EXPECT_EQ(colors(some), (std::vector<Vec3d>{{1, 0, 0}, {1, 1, 1}, {1, 1, 1}}));
    EXPECT_EQ(offRemarksOf(offModelOf(some)),
              Texts{"2 vertex lines without a colour of three numbers from 0 are read as 1 1 1."});
    EXPECT_TRUE(colors("COFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").empty());
}

TEST(OffReader, WhatIsLeftOutIsSaidWithACount) {
    const LoadedModel model =
        offModelOf("OFF\n3 3 0\n0 0 0 255 0 0 255\n1 0 0 0 255 0 255 # green\n0 1 0\n3 0 1 2 0.5 0.5 0.5\n2 0 1\n0\n");
    EXPECT_EQ(offRemarksOf(model),
              (Texts{"2 vertex lines with more than three numbers, as a colour or a normal, are read without them.",
                     "1 polygon with a colour is shown with the default material.",
                     "2 polygons have fewer than three different corners, and so no area; they are left out."}));
    EXPECT_EQ(model.remarks[0].about, "m:3");
    EXPECT_EQ(model.objects.at(0).mesh->polygonCount(), 1u);
}

TEST(OffReader, WhatIsNoSuchFileIsRefusedWithItsPlace) {
    EXPECT_EQ(readErrorsOf(""), "m: found the end of the file, expected OFF\n");
    EXPECT_EQ(readErrorsOf("hello\n3 1 0\n"), "m:1:1: found \"hello\", expected OFF\n");
    EXPECT_EQ(readErrorsOf("OFF BINARY\n3 1 0\n"),
              "m:1:1: found a binary OFF file, expected one of text: save it as OFF in ASCII, or as PLY\n");
    EXPECT_EQ(readErrorsOf("4OFF\n3 1 0\n"), "m:1:1: found \"4OFF\", expected OFF: vertices with three coordinates\n");
    EXPECT_EQ(readErrorsOf("OFF\n3 -1 0\n"),
              "m:2:3: found \"-1\", expected the number of polygons, from 0 to 134 217 728\n");
    EXPECT_EQ(readErrorsOf("OFF\n3 1 0\n0 0 0\n1 x 0\n"),
              "m:4:3: found \"x\", expected y of vertex 1, a number from -1e9 to 1e9\n");
    EXPECT_EQ(readErrorsOf("OFF\n3 1 0\n0 0 0\n1 0 1e10\n"),
              "m:4:5: found \"1e10\", expected z of vertex 1, a number from -1e9 to 1e9\n");
    EXPECT_EQ(readErrorsOf("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
              "m:6:7: found \"3\", expected a vertex index from 0 to 2\n");
    EXPECT_EQ(readErrorsOf("OFF\n134217728 1 0\n0 0 0\n").substr(0, 34), "m:3:6: found the end of the file, ");
    EXPECT_EQ(readErrorsOf("OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"),
              "m: found no polygon, expected a model with polygons\n");
}

// Whatever the name says: the first words tell.
TEST(FileFormats, AFileOfAnotherFormatThanItsNameSaysWhichOneItIs) {
    const std::string obj = "# by hand\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    EXPECT_EQ(readErrorsOf(obj, ".stl"),
              "m: found what a .obj file holds, expected what a .stl file holds: give the file the extension .obj\n");
    EXPECT_EQ(readErrorsOf("OFF\n5 5 0\n" + kOffRows, ".ply").substr(0, 33), "m: found what a .off file holds, ");
    EXPECT_EQ(
        readErrorsOf("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
                     "endfacet\nendsolid a\n",
                     ".obj")
            .substr(0, 33),
        "m: found what a .stl file holds, ");
    EXPECT_EQ(readErrorsOf("ply\nformat ascii 1.0\n", ".off").substr(0, 33), "m: found what a .ply file holds, ");
    EXPECT_EQ(readErrorsOf("{\"asset\": {\"version\": \"2.0\"}}", ".obj").substr(0, 34),
              "m: found what a .gltf file holds, ");
    // What is wrong in a file of the format that its name says is told as before.
    EXPECT_EQ(readErrorsOf("v 0 0 0\nv 1 0 0\nf 1 2 3\n", ".obj").substr(0, 21), "m:3:7: found \"3\", exp");
}

TEST(FileFormats, PackedFilesAreNamedAndToldToBeUnpacked) {
    const test::TemporaryFolder folder;
    const auto errorOf = [&](const std::string& name, std::string_view bytes) {
        test::writeText(folder / name, std::string(bytes));
        const auto scene = readScene(folder / name);
        return scene ? std::string() : scene.errors()[0].found + ", expected " + scene.errors()[0].expected;
    };
    using namespace std::string_view_literals;
    const std::string gzip =
        "found a file packed by gzip (.gz), expected the scene or model in it: unpack it first, as "
        "with gunzip";
    EXPECT_EQ(errorOf("bunny.obj.gz", "\x1f\x8b\x08\0\0\0\0\0\0\x03"sv), gzip);
    EXPECT_EQ(errorOf("bunny.ply", "\x1f\x8b\x08\0\0\0\0\0\0\x03"sv), gzip) << "by another name";
    EXPECT_EQ(errorOf("models.zip", "PK\3\4\x14\0\0\0"sv),
              "found a ZIP archive (.zip), expected the scene or model in it: unpack it first, as with unzip");
}

}  // namespace
}  // namespace pipeline
