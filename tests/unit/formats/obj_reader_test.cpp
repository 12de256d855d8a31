// OBJ and MTL: what small files written by hand become, and what wrong ones get. Places are
// counted by eye.
#include <gtest/gtest.h>

#include <map>

#include <fmt/format.h>

#include "pipeline/formats/model_reader.h"

namespace pipeline {
namespace {

FileLoader filesOf(std::map<std::string, std::string, std::less<>> files) {
    return [files = std::move(files)](std::string_view name) -> Result<NamedFile> {
        const auto file = files.find(name);
        if (file == files.end()) return Error{{}, fmt::format("\"{}\": no such file", name), {}};
        return NamedFile{file->second, file->first};
    };
}

std::vector<Object> objectsOf(std::string_view text, const FileLoader& load = filesOf({})) {
    const Result<LoadedModel> model = readModel({text, "m.obj"}, ".obj", load);
    EXPECT_TRUE(model) << (model ? "" : format(model.errors()));
    return model ? model->objects : std::vector<Object>{};
}

std::string objErrors(std::string_view text, const FileLoader& load = filesOf({})) {
    const Result<LoadedModel> model = readModel({text, "m.obj"}, ".obj", load);
    return model ? "" : format(model.errors());
}

std::vector<std::uint32_t> polygon(const Object& object, std::size_t i) {
    const auto corners = object.mesh->polygon(i);
    return {corners.begin(), corners.end()};
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
using Indices = std::vector<std::uint32_t>;

TEST(ObjReader, SaysHowManyPolygonsHaveNoArea) {
    const Result<LoadedModel> model =
        readModel({kSquare + "f 1 2 3 4\nf 1 1 2\no b\nf 3 3 3\nf 1 2 4\n", "m.obj"}, ".obj", filesOf({}));
    ASSERT_TRUE(model);
    EXPECT_EQ(model->remarks, (std::vector<Remark>{{"m.obj:6",
                                                    "2 polygons have fewer than three different corners, and "
                                                    "so no area; they are left out."}}));
}

TEST(ObjReader, QuadStaysAQuad) {
    const std::vector<Object> objects = objectsOf(kSquare + "f 1 2 3 4\n");
    ASSERT_EQ(objects.size(), 1u);
    EXPECT_EQ(objects[0].name, "m");
    EXPECT_EQ(objects[0].mesh->file, "m.obj");
    EXPECT_EQ(objects[0].mesh->positions, (std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(polygon(objects[0], 0), (Indices{0, 1, 2, 3}));
    EXPECT_EQ(objects[0].mesh->polygonPlaces, (std::vector<TextPosition>{{5, 1}}));
}

// While each normal has the number of its position the reader keeps no list of them. From the first other number on it
// does, of the corners before as well; and where a corner has none, the normals of the object are not used.
TEST(ObjReader, NormalsNumberedLikeTheirPositionsAndOtherwise) {
    const std::string file = kSquare + "vn 0 0 1\nvn 0 1 0\nvn 1 0 0\nf 1//1 2//2 3//3\n";
    const Vec3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    EXPECT_EQ(objectsOf(file)[0].mesh->normals, (std::vector<Vec3d>{z, y, x}));
    const std::vector<Object> other = objectsOf(file + "f 1//2 3//3 4//1\n");
    EXPECT_EQ(other[0].mesh->normals, (std::vector<Vec3d>{z, y, x, y, z}));
    EXPECT_EQ(polygon(other[0], 1), (Indices{3, 2, 4}));
    EXPECT_TRUE(objectsOf(file + "f 1 3 4\n")[0].mesh->normals.empty());
    EXPECT_TRUE(objectsOf(kSquare + "vn 0 0 1\nf 1 2 3\nf 1//1 3//1 4//1\n")[0].mesh->normals.empty());
}

TEST(ObjReader, ConcaveFaceIsNotCutOpen) {
    const auto objects = objectsOf("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6");
    ASSERT_EQ(objects.size(), 1u);
    EXPECT_EQ(polygon(objects[0], 0), (Indices{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(objects[0].mesh->facts.concave, 1);
    double area = 0;  // the L has 3 unit squares; a fan from its first corner as well, but with an overlap
    for (const Triangle& t : objects[0].mesh->triangles) {
        const auto at = [&](int i) { return objects[0].mesh->positions[t.vertices[i]]; };
        area += glm::length(glm::cross(at(1) - at(0), at(2) - at(0))) / 2;
    }
    EXPECT_DOUBLE_EQ(area, 3);
}

TEST(ObjReader, NegativeIndicesCountFromTheLast) {
    EXPECT_EQ(polygon(objectsOf(kSquare + "f -4 -3 -2 -1")[0], 0), (Indices{0, 1, 2, 3}));
    // Of those above: the fifth vertex is the last one now.
    EXPECT_EQ(objectsOf(kSquare + "v 5 5 5\nf -1 1 2")[0].mesh->positions[0], Vec3d(5, 5, 5));
}

TEST(ObjReader, LineEndsMarksCommentsAndContinuations) {
    for (const char* text :
         {"v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nf 1 2 3\r\n", "\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3",
          "v 0 0 0\rv 1 0 0\rv 1 1 0\rf 1 2 3", "v 0 0 0\rv 1 0 0\nv 1 1 0\r\nf 1 2 3\r",
          "v 0 0 0 # a\n\nv 1 0 \\\n 0\nv 1 1 0\nf\t1 2\\\r\n 3 #4"}) {
        const auto objects = objectsOf(text);
        ASSERT_EQ(objects.size(), 1u) << text;
        EXPECT_EQ(objects[0].mesh->positions, (std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}})) << text;
        EXPECT_EQ(polygon(objects[0], 0), (Indices{0, 1, 2})) << text;
    }
}

TEST(ObjReader, PositionWithTwoNormalsIsTwoVertices) {
    const auto objects = objectsOf(kSquare + "vn 0 0 2\nvn 0 3 0\nf 1//1 2//1 3//1\nf 1/7/1 3//2 4//1");
    ASSERT_EQ(objects.size(), 1u);
    EXPECT_EQ(polygon(objects[0], 0), (Indices{0, 1, 2}));
    EXPECT_EQ(polygon(objects[0], 1), (Indices{0, 3, 4}));
    EXPECT_EQ(objects[0].mesh->positions[2], objects[0].mesh->positions[3]);
    EXPECT_EQ(objects[0].mesh->normals, (std::vector<Vec3d>{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 1, 0}, {0, 0, 1}}));
}

TEST(ObjReader, PositionWithManyNormalsIsAVertexForEach) {
    // Three normals at position 1, each met twice; the second object begins anew.
    const auto objects = objectsOf(kSquare +
                                   "vn 1 0 0\nvn 0 1 0\nvn 0 0 1\n"
                                   "f 1//1 2//1 3//1\nf 1//2 2//1 3//1\nf 1//3 2//1 3//1\nf 1//2 3//1 4//1\n"
                                   "f 1//3 3//1 4//1\nf 1//1 3//1 4//1\no second\nf 1//3 2//3 3//3");
    ASSERT_EQ(objects.size(), 2u);
    const Mesh& mesh = *objects[0].mesh;
    EXPECT_EQ(mesh.positions.size(), 6u);
    EXPECT_EQ(polygon(objects[0], 1), (Indices{3, 1, 2}));
    EXPECT_EQ(polygon(objects[0], 3), (Indices{3, 2, 5}));
    EXPECT_EQ(polygon(objects[0], 4), (Indices{4, 2, 5}));
    EXPECT_EQ(polygon(objects[0], 5), (Indices{0, 2, 5}));
    EXPECT_EQ(mesh.normals[4], Vec3d(0, 0, 1));
    EXPECT_EQ(polygon(objects[1], 0), (Indices{0, 1, 2}));
    EXPECT_EQ(objects[1].mesh->normals[0], Vec3d(0, 0, 1));
}

TEST(ObjReader, NormalsThatAreNotThereForAllCornersAreLeftOut) {
    for (const char* faces : {"f 1//1 2//1 3//1\nf 1 3 4", "f 1//1 2//1 3//2"}) {
        const auto objects = objectsOf(kSquare + "vn 0 0 1\nvn 0 0 0\n" + faces);
        EXPECT_TRUE(objects[0].mesh->normals.empty()) << faces;
        EXPECT_EQ(objects[0].mesh->positions.size(), objects[0].mesh->polygonCount() + 2) << faces;
    }
}

TEST(ObjReader, OneObjectForEachMaterialWithinAnO) {
    const FileLoader load = filesOf({{"two colours.mtl",
                                      "newmtl red\nKd 1 0 0\nKa 0.5 0 0\nKs 0.25\nNs 32\nKe 0 0 1\nmap_Kd x.png\n"
                                      "newmtl light green\r\nKd 0 1 0\n"}});
    const auto objects = objectsOf("mtllib two colours.mtl\n" + kSquare +
                                       "o house\nusemtl red\nf 1 2 3\nusemtl light green\nf 1 3 4\n"
                                       "usemtl red\nf 2 3 4\no tree\nf 1 2 4\n",
                                   load);
    ASSERT_EQ(objects.size(), 3u);
    EXPECT_EQ(objects[0].name, "house, red");
    EXPECT_EQ(objects[0].mesh->polygonCount(), 2u);
    EXPECT_EQ(objects[1].name, "house, light green");
    EXPECT_EQ(objects[1].mesh->positions, (std::vector<Vec3d>{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(objects[2].name, "tree");
    const Material red{
        .diffuse = {1, 0, 0}, .specular = Vec3d(0.25), .exponent = 32, .ambient = {0.5, 0, 0}, .emission = {0, 0, 1}};
    EXPECT_EQ(objects[0].material, red);
    EXPECT_EQ(objects[2].material, red);
    EXPECT_EQ(objects[1].material.ambient, Vec3d(0, 1, 0)) << "Kd, where there is no Ka";
}

TEST(ObjReader, PointsLinesAndFacesWithoutAreaAreSkipped) {
    const auto objects = objectsOf(kSquare + "p 1\nl 1 2\nf 1 1 2\nf 1 2 1\nf 1 2 2 3 1\n");
    ASSERT_EQ(objects[0].mesh->polygonCount(), 1u);
    EXPECT_EQ(polygon(objects[0], 0), (Indices{0, 1, 2}));
}

TEST(ObjReader, IndexOutOfRange) {
    for (const std::string index : {"0", "5", "-5", "2147483648", "4294967297", "9223372036854775808",
                                    "99999999999999999999", "--1", "-+1", "1.0", "x", "nan"})
        EXPECT_EQ(
            objErrors(kSquare + "f 1 2 " + index),
            fmt::format("m.obj:5:7: found \"{}\", expected the index of a vertex above, 1 to 4 or -4 to -1\n", index));
    EXPECT_EQ(objErrors("f 1 2 3"), "m.obj:1:3: found \"1\", expected a vertex before the first index of one\n");
}

TEST(ObjReader, CoordinateThatIsNone) {
    for (const std::string number : {"nan", "inf", "-infinity", "1e999", "1e10", "x", "1,x"})
        EXPECT_EQ(objErrors(fmt::format("v 0 0 0\nv 0 {} 0\n", number)),
                  fmt::format("m.obj:2:5: found \"{}\", expected y of vertex 2, a number from -1e9 to 1e9\n", number));
    EXPECT_EQ(objErrors("v 1 2\r\n"),
              "m.obj:1:6: found the end of the line, expected z of vertex 1, a number from -1e9 to 1e9\n");
}

TEST(ObjReader, NoPolygons) {
    for (const char* text : {"", "\n", "v 0 0 0\n"})
        EXPECT_EQ(objErrors(text), "m.obj: found no polygon, expected a model with polygons\n");
    EXPECT_EQ(
        objErrors("PK\x03\x04"),
        "m.obj: found no polygon; 1 statement that OBJ files do not have, as \"PK\\x03\\x04\", is left out, expected "
        "a model with polygons\n");
}

TEST(ObjReader, ManyErrorsEnd) {
    std::string text = kSquare;
    for (int i = 0; i < 100; ++i) text += "f 1 2 9\n";
    const Result<LoadedModel> model = readModel({text, "m.obj"}, ".obj", filesOf({}));
    ASSERT_FALSE(model);
    EXPECT_EQ(model.errors().size(), kMaxErrors);
}

TEST(ModelReader, ExtensionsInAnyCase) {
    EXPECT_TRUE(isModel(".obj"));
    EXPECT_TRUE(isModel(".OBJ"));
    EXPECT_FALSE(isModel("obj"));
    EXPECT_FALSE(isModel(".des"));
}

}  // namespace
}  // namespace pipeline
