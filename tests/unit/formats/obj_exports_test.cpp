// OBJ and MTL files as programs write them and as they come out of archives: a fault beside the geometry costs what it
// concerns, never the geometry, and is said once with a count and the first place. Places are counted by eye.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include <fmt/format.h>

#include "pipeline/formats/model_reader.h"
#include "pipeline/formats/scene_reader.h"
#include "tests/support/files.h"

namespace pipeline {
namespace {

const std::string kTriangles = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";  // four lines of vertices

FileLoader filesNamed(std::map<std::string, std::string, std::less<>> files) {
    return [files = std::move(files)](std::string_view name) -> Result<NamedFile> {
        const auto file = files.find(name);
        if (file == files.end()) return Error{{}, fmt::format("\"{}\": no such file", name), {}};
        return NamedFile{file->second, file->first};
    };
}

LoadedModel modelOf(std::string_view text, const FileLoader& load = filesNamed({})) {
    const Result<LoadedModel> model = readModel({text, "m.obj"}, ".obj", load);
    EXPECT_TRUE(model) << (model ? "" : format(model.errors())) << text;
    return model ? *model : LoadedModel{};
}

std::string remarksOf(const LoadedModel& model) {
    std::string text;
    for (const Remark& remark : model.remarks) text += remark.about + ": " + remark.text + "\n";
    return text;
}

std::size_t polygonsOf(const LoadedModel& model) {
    std::size_t count = 0;
    for (const Object& object : model.objects) count += object.mesh->polygonCount();
    return count;
}

Material materialOf(std::string_view mtl) {
    const LoadedModel model =
        modelOf("mtllib a.mtl\n" + kTriangles + "usemtl a\nf 1 2 3\n", filesNamed({{"a.mtl", std::string(mtl)}}));
    return model.objects.empty() ? Material{} : model.objects[0].material;
}

TEST(ObjExports, MaterialFileThatIsMissingCostsItsMaterials) {
    const LoadedModel model = modelOf("mtllib gone.mtl\n" + kTriangles + "usemtl paint\nf 1 2 3\nf 1 3 4\n");
    EXPECT_EQ(polygonsOf(model), 2u);
    EXPECT_EQ(model.objects.at(0).material, Material());
    EXPECT_EQ(remarksOf(model),
              "m.obj:1: \"gone.mtl\": no such file. Faces with its materials have the default material.\n");
}

TEST(ObjExports, ManyMissingMaterialFilesAreOneRemark) {
    std::string text = kTriangles;
    for (int i = 0; i < 100; ++i) text += fmt::format("mtllib gone{}.mtl\nmtllib gone0.mtl\n", i);
    EXPECT_EQ(
        remarksOf(modelOf(text + "f 1 2 3\n")),
        "m.obj:5: \"gone0.mtl\": no such file. Faces with its materials have the default material. The same holds "
        "for 99 further material files.\n");
}

TEST(ObjExports, MaterialFileIsReadOnce) {
    int reads = 0;
    const FileLoader load = [&](std::string_view) -> Result<NamedFile> {
        ++reads;
        return NamedFile{"newmtl a\nKd 1 0 0\n", "a.mtl"};
    };
    std::string text = kTriangles;
    for (int i = 0; i < 1000; ++i) text += "mtllib a.mtl\n";
    EXPECT_EQ(modelOf(text + "usemtl a\nf 1 2 3\n", load).objects.at(0).material.diffuse, Vec3d(1, 0, 0));
    EXPECT_EQ(reads, 1);
}

TEST(ObjExports, OfSeveralMaterialFilesTheOthersAreRead) {
    const LoadedModel model = modelOf("mtllib gone.mtl a.mtl\n" + kTriangles + "usemtl a\nf 1 2 3\n",
                                      filesNamed({{"a.mtl", "newmtl a\nKd 1 0 0\n"}}));
    EXPECT_EQ(model.objects.at(0).material.diffuse, Vec3d(1, 0, 0));
    EXPECT_EQ(remarksOf(model),
              "m.obj:1: \"gone.mtl\": no such file. Faces with its materials have the default material.\n");
}

TEST(ObjExports, MtllibWithoutANameOrWithAModelIsSaid) {
    EXPECT_EQ(remarksOf(modelOf("mtllib\n" + kTriangles + "f 1 2 3\n")), "m.obj:1: mtllib names no file.\n");
    EXPECT_EQ(remarksOf(modelOf("mtllib m.obj\n" + kTriangles + "f 1 2 3\n")),
              "m.obj:1: \"m.obj\" is a model and no file of materials. Faces with its materials have the default "
              "material.\n")
        << "or each line of a file would read the file once more";
}

TEST(ObjExports, FacesWithAMaterialThatNoFileGivesHaveTheDefault) {
    const FileLoader load = filesNamed({{"a.mtl", "newmtl red\nKd 1 0 0\n"}});
    const LoadedModel model =
        modelOf("mtllib a.mtl\n" + kTriangles + "usemtl red\nf 1 2 3\nusemtl gone\nf 1 3 4\nf 2 3 4\n", load);
    ASSERT_EQ(model.objects.size(), 2u);
    EXPECT_EQ(model.objects[0].material.diffuse, Vec3d(1, 0, 0));
    EXPECT_EQ(model.objects[1].material, Material());
    EXPECT_EQ(remarksOf(model),
              "m.obj:9: 2 faces with a material that no material file gives are shown with the default material.\n");
}

TEST(ObjExports, MaterialsWithoutANameAndInAnotherCase) {
    const FileLoader load = filesNamed({{"a.mtl", "newmtl \nKd 1 0 0\nnewmtl Sky Blue\nKd 0 0 1\n"}});
    const LoadedModel model = modelOf(
        "mtllib a.mtl\n" + kTriangles + "usemtl \nf 1 2 3\no b\nusemtl sky blue \nf 1 3 4\no c\nusemtl\nf 2 3 4\n",
        load);
    ASSERT_EQ(model.objects.size(), 3u);
    EXPECT_EQ(model.objects[0].material.diffuse, Vec3d(1, 0, 0));
    EXPECT_EQ(model.objects[1].material.diffuse, Vec3d(0, 0, 1));
    EXPECT_EQ(model.objects[2].material.diffuse, Vec3d(1, 0, 0));
    EXPECT_EQ(remarksOf(model), "");
}

TEST(ObjExports, CommentsAndQuotesAroundNames) {
    const FileLoader load = filesNamed({{"my a.mtl", "newmtl red\nKd 1 0 0\nnewmtl steel #2\nKd 0 0 1\n"}});
    const LoadedModel model = modelOf("mtllib \"my a.mtl\"\n" + kTriangles +
                                          "usemtl red  # as paint\nf 1 2 3\no b\nusemtl steel #2\nf 1 3 4 # last\n",
                                      load);
    ASSERT_EQ(model.objects.size(), 2u);
    EXPECT_EQ(model.objects[0].material.diffuse, Vec3d(1, 0, 0));
    EXPECT_EQ(model.objects[1].material.diffuse, Vec3d(0, 0, 1));
    const FileLoader plain = filesNamed({{"a.mtl", "newmtl red\nKd 1 0 0\n"}});
    const LoadedModel commented = modelOf("mtllib a.mtl # of 2004\n" + kTriangles + "usemtl red\nf 1 2 3\n", plain);
    EXPECT_EQ(commented.objects.at(0).material.diffuse, Vec3d(1, 0, 0));
    EXPECT_EQ(remarksOf(commented), "");
}

TEST(ObjExports, NothingBehindASlashIsNoNormal) {
    for (const std::string face : {"f 1// 2// 3//", "f 1/ 2/ 3/", "f 1/5/ 2/6/ 3/7/"}) {
        const LoadedModel model = modelOf(kTriangles + "vn 0 0 1\n" + face + "\n");
        EXPECT_EQ(polygonsOf(model), 1u) << face;
        EXPECT_TRUE(model.objects.at(0).mesh->normals.empty()) << face;
        EXPECT_EQ(remarksOf(model), "") << face;
    }
}

TEST(ObjExports, NormalsThatAreNoneCountAsMissing) {
    for (const std::string normal :
         {"nan nan nan", "-nan(ind) -nan(ind) -nan(ind)", "-1.#IND 0 0", "1e999 0 0", "0 0 0", "0 1", "x y z"}) {
        const LoadedModel model =
            modelOf(kTriangles + "vn 0 0 1\nvn " + normal + "\nf 1//1 2//1 3//1\no b\nf 1//1 3//2 4//2\n");
        ASSERT_EQ(model.objects.size(), 2u) << normal;
        EXPECT_EQ(model.objects[0].mesh->normals.size(), 3u) << normal;
        EXPECT_TRUE(model.objects[1].mesh->normals.empty()) << normal;
        EXPECT_EQ(remarksOf(model),
                  "m.obj:6: 1 normal without a direction is taken as missing.\n"
                  "m.obj:9: 1 object with normals at some corners and none at others is shown without the file's "
                  "normals.\n")
            << normal;
    }
}

TEST(ObjExports, NormalsThatTheFileHasNotCountAsMissing) {
    const LoadedModel model = modelOf(kTriangles + "vn 0 0 1\nf 1//1 2//7 3//-2\nf 1//1 3//1 4//1\n");
    EXPECT_EQ(polygonsOf(model), 2u);
    EXPECT_EQ(model.remarks.at(0).text,
              "2 normals of corners, named by a number that the file has not above, are taken as missing.");
}

TEST(ObjExports, PictureCoordinatesAreNotLookedAt) {
    const LoadedModel model = modelOf(kTriangles + "vt nan inf\nvt -1.#IND00 x\nvt\nf 1/1 2/2 3/99\n");
    EXPECT_EQ(polygonsOf(model), 1u);
    EXPECT_EQ(remarksOf(model), "");
}

TEST(ObjExports, FacesOfFewCornersAreLeftOut) {
    const LoadedModel model = modelOf(kTriangles + "f 1 2 3\nf 1 2\nf 1\nf\nf 1 1 2\n");
    EXPECT_EQ(polygonsOf(model), 1u);
    EXPECT_EQ(remarksOf(model),
              "m.obj:6: 4 polygons have fewer than three different corners, and so no area; they are left out.\n");
}

TEST(ObjExports, WhatIsNoPolygonIsCounted) {
    const LoadedModel model = modelOf(
        "v 0 0 0 1 0 0\nv 1 0 0 0.5 1 0 0\nv 1 1 0 1\np 1 2\nl 1 2\nl 2 3\ncstype bspline\ncurv 0 1 1 2\n"
        "parm u 0 1\nend\nsurf 0 1 0 1 1 2 3\ncall other.obj\ncsh rm x\nf 1 2 3\nwhat 1\nlod 3\n");
    EXPECT_EQ(polygonsOf(model), 1u);
    EXPECT_EQ(remarksOf(model),
              "m.obj:4: 1 statement of points is left out.\n"
              "m.obj:5: 2 statements of lines are left out.\n"
              "m.obj:8: 2 curve and surface statements are left out.\n"
              "m.obj:12: 2 call or csh statements are left out: other files and commands are never run.\n"
              "m.obj:15: 1 statement that OBJ files do not have, as \"what\", is left out.\n");
}

TEST(ObjExports, AFileOfLinesAloneSaysSo) {
    const Result<LoadedModel> model = readModel({kTriangles + "l 1 2\nl 2 3\n", "m.obj"}, ".obj", filesNamed({}));
    ASSERT_FALSE(model);
    EXPECT_EQ(format(model.errors()),
              "m.obj: found no polygon; 2 statements of lines are left out, expected a model with polygons\n");
}

TEST(ObjExports, GroupsAreObjectsWhereNoODividesTheFile) {
    const LoadedModel model = modelOf(kTriangles + "g left arm\nf 1 2 3\ng right\nf 1 3 4\ng left arm\nf 2 3 4\n");
    ASSERT_EQ(model.objects.size(), 2u);
    EXPECT_EQ(model.objects[0].name, "left arm");
    EXPECT_EQ(model.objects[0].mesh->polygonCount(), 2u);
    EXPECT_EQ(model.objects[1].name, "right");
    const LoadedModel divided = modelOf(kTriangles + "o house\ng left\nf 1 2 3\ng right\nf 1 3 4\n");
    ASSERT_EQ(divided.objects.size(), 1u);
    EXPECT_EQ(divided.objects[0].name, "house");
    EXPECT_EQ(modelOf(kTriangles + "g\nf 1 2 3\n").objects.at(0).name, "m");
}

TEST(ObjExports, GroupsBeyondTheMostAreOneObject) {
    std::string text = kTriangles;
    for (int i = 0; i < 5000; ++i) text += fmt::format("g g{}\nf 1 2 3\n", i);
    const LoadedModel model = modelOf(text);
    EXPECT_EQ(model.objects.size(), 4097u);
    EXPECT_EQ(polygonsOf(model), 5000u);
    EXPECT_EQ(remarksOf(model), fmt::format("m.obj:{}: 904 group statements beyond 4096 groups are joined to one "
                                            "object.\n",
                                            5 + 2 * 4096));
}

TEST(ObjExports, BytesOfZeroAtTheEnd) {
    const LoadedModel model =
        modelOf(kTriangles + "f 1 2 3" + std::string(3, '\0') + "\r\nf 1 3 4\n\x1A" + std::string(512, '\0'));
    EXPECT_EQ(polygonsOf(model), 2u);
    EXPECT_EQ(remarksOf(model), "");
}

TEST(ObjExports, DecimalCommaIsNamed) {
    const Result<LoadedModel> model =
        readModel({"v 0 0 0\nv 2,5 0 0\nv 0 3 0\nf 1 2 3\n", "m.obj"}, ".obj", filesNamed({}));
    ASSERT_FALSE(model);
    EXPECT_EQ(
        format(model.errors()),
        "m.obj:2:3: found \"2,5\", expected x of vertex 2, a number from -1e9 to 1e9; write the decimal point as in "
        "2.5\n");
}

// A fold of two unit squares, z = 0 and x = 1, along the edge from (1, 0, 0) to (1, 1, 0).
const std::string kFold = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 -1\nv 1 1 -1\n";
const std::string kFloor = "f 1 2 3 4\n", kWall = "f 3 2 5 6\n";

TEST(ObjExports, SmoothingGroupsSumTheNormalsWithinThem) {
    const Vec3d floor(0, 0, 1), wall(1, 0, 0), between = glm::normalize(floor + wall);
    const LoadedModel one = modelOf(kFold + "s 1\n" + kFloor + kWall);
    const Mesh& smooth = *one.objects.at(0).mesh;
    ASSERT_EQ(smooth.normals.size(), 6u);
    EXPECT_EQ(smooth.normals[0], floor);
    EXPECT_NEAR(glm::length(smooth.normals[1] - between), 0, 4e-16);
    EXPECT_NEAR(glm::length(smooth.normals[2] - between), 0, 4e-16);
    EXPECT_EQ(smooth.normals[4], wall);

    for (const std::string other : {"s off\n", "s 0\n", "s 2\n"}) {
        const LoadedModel two = modelOf(kFold + "s 1\n" + kFloor + other + kWall);
        const Mesh& sharp = *two.objects.at(0).mesh;
        ASSERT_EQ(sharp.normals.size(), 8u) << other;
        for (const std::uint32_t corner : sharp.polygon(0)) EXPECT_EQ(sharp.normals[corner], floor) << other;
        for (const std::uint32_t corner : sharp.polygon(1)) EXPECT_EQ(sharp.normals[corner], wall) << other;
    }
}

TEST(ObjExports, SmoothingGoesOnAcrossMaterials) {
    const LoadedModel model = modelOf(kFold + "s 1\nusemtl a\n" + kFloor + "usemtl b\n" + kWall);
    ASSERT_EQ(model.objects.size(), 2u);
    const Vec3d between = glm::normalize(Vec3d(1, 0, 1));
    EXPECT_NEAR(glm::length(model.objects[0].mesh->normals[1] - between), 0, 4e-16);
    EXPECT_NEAR(glm::length(model.objects[1].mesh->normals[0] - between), 0, 4e-16);
}

TEST(ObjExports, WithoutASmoothingGroupNothingIsSmoothed) {
    EXPECT_TRUE(modelOf(kFold + "s off\n" + kFloor + kWall).objects.at(0).mesh->normals.empty());
    EXPECT_TRUE(modelOf(kFold + kFloor + kWall).objects.at(0).mesh->normals.empty());
}

TEST(ObjExports, NormalsOfTheFileComeBeforeSmoothingGroups) {
    const LoadedModel model = modelOf(kFold + "vn 0 1 0\ns 1\nf 1//1 2//1 3//1 4//1\no b\n" + kWall);
    EXPECT_EQ(model.objects.at(0).mesh->normals[1], Vec3d(0, 1, 0));
    EXPECT_EQ(model.objects.at(1).mesh->normals[0], Vec3d(1, 0, 0));
}

// The two sides of a sheet in one group: their normals cancel, and each has its own.
TEST(ObjExports, OpposedNormalsOfASmoothingGroupFallBackToTheFaces) {
    const LoadedModel model = modelOf(kTriangles + "s 1\nf 1 2 3 4\nf 4 3 2 1\n");
    const Mesh& mesh = *model.objects.at(0).mesh;
    for (const std::uint32_t corner : mesh.polygon(0)) EXPECT_EQ(mesh.normals[corner], Vec3d(0, 0, 1));
    for (const std::uint32_t corner : mesh.polygon(1)) EXPECT_EQ(mesh.normals[corner], Vec3d(0, 0, -1));
}

TEST(MtlExports, WrongNumbersKeepTheDefault) {
    const std::string mtl =
        "Kd 1 1 1\nnewmtl a\nKd 0 nan 0\nKs 0,5 0 0\nNs -1\nKe spectral x.rfl\nd -halo 0.5\nKa 0 1 0\n";
    const LoadedModel model =
        modelOf("mtllib a.mtl\n" + kTriangles + "usemtl a\nf 1 2 3\n", filesNamed({{"a.mtl", mtl}}));
    Material expected;
    expected.ambient = {0, 1, 0};
    EXPECT_EQ(model.objects.at(0).material, expected);
    EXPECT_EQ(remarksOf(model),
              "a.mtl:1: 1 coefficient before the first newmtl is left out.\n"
              "a.mtl:3: 3 coefficients without a number in its range are left out; the default stays.\n"
              "a.mtl:6: 1 colour given as spectral or xyz is left out.\n"
              "a.mtl:7: 1 opacity given as -halo is left out.\n");
}

// Exporters write Kd 0 where a picture gives the colour. Without the picture the surface would be black.
TEST(MtlExports, PicturesAreSaidAndLeaveNoBlackSurface) {
    const std::string mtl = "newmtl a\nKd 0 0 0\nmap_Kd -s 1 1 1 wood.png\nmap_Bump b.png\n";
    const LoadedModel model =
        modelOf("mtllib a.mtl\n" + kTriangles + "usemtl a\nf 1 2 3\n", filesNamed({{"a.mtl", mtl}}));
    EXPECT_EQ(model.objects.at(0).material, Material());
    EXPECT_EQ(remarksOf(model),
              "a.mtl:3: 2 pictures on surfaces are left out.\n"
              "a.mtl:1: 1 material with a picture and Kd 0 is shown with Kd 0.7 instead of black.\n");
    EXPECT_EQ(materialOf("newmtl a\nKd 0 0 0\n").diffuse, Vec3d(0)) << "black is a colour";
}

// 3ds Max, VCGlib and MeshLab write Tr for the opacity: read as transparency, nothing of such a file is seen.
TEST(MtlExports, TrIsOpacityWhereNothingElseMakesSense) {
    EXPECT_EQ(materialOf("newmtl a\nTr 1\n").alpha, 1);
    EXPECT_EQ(materialOf("newmtl a\nTr 0.25\nnewmtl b\nTr 1\n").alpha, 0.25);
    EXPECT_EQ(materialOf("newmtl a\nTr 0.25\nnewmtl b\nd 1\nTr 1\n").alpha, 0.25) << "d and Tr are equal";
    // As the format's later versions have it.
    EXPECT_EQ(materialOf("newmtl a\nTr 0.25\n").alpha, 0.75);
    EXPECT_EQ(materialOf("newmtl a\nTr 1\nnewmtl b\nTr 0\n").alpha, 0);
    EXPECT_EQ(materialOf("newmtl a\nTr 0.25\nnewmtl b\nd 0.9\nTr 0.1\n").alpha, 0.75);
    const LoadedModel model = modelOf("mtllib a.mtl\n" + kTriangles + "usemtl a\nf 1 2 3\n",
                                      filesNamed({{"a.mtl", "newmtl a\nKd 1 0 0\nTr 1.000000\n"}}));
    EXPECT_EQ(remarksOf(model),
              "a.mtl:3: 1 material with Tr is shown with Tr as opacity, for as transparency it would hide surfaces; "
              "material.#.alpha changes it.\n");
}

std::string utf16(std::string_view text, bool bigEndian) {
    std::string units = bigEndian ? "\xFE\xFF" : "\xFF\xFE";
    for (const char c : text) units += bigEndian ? std::string{'\0', c} : std::string{c, '\0'};
    return units;
}

TEST(Utf16, ModelsMaterialsAndScenesAreRead) {
    const test::TemporaryFolder folder;
    for (const bool bigEndian : {false, true}) {
        test::writeText(folder / "a.mtl", utf16("newmtl a\nKd 1 0 0\n", bigEndian));
        test::writeText(folder / "m.obj",
                        utf16("mtllib a.mtl\r\n" + kTriangles + "usemtl a\r\nf 1 2 3\r\n", bigEndian));
        const Result<Scene> model = readScene(folder / "m.obj");
        ASSERT_TRUE(model) << format(model.errors());
        EXPECT_EQ(model->objects[0].material.diffuse, Vec3d(1, 0, 0));
        EXPECT_EQ(model->objects[0].mesh->polygonPlaces[0], (TextPosition{7, 1}));
        test::writeText(folder / "s.toml", utf16("title = \"x\"\n[[object]]\nshape = \"box\"\n", bigEndian));
        const Result<Scene> scene = readScene(folder / "s.toml");
        ASSERT_TRUE(scene) << format(scene.errors());
        EXPECT_EQ(scene->objects.size(), 1u);
    }
}

// Larger than a piece that is read at a time, with a name in characters of one, two and four bytes in it.
TEST(Utf16, IsReadPieceByPiece) {
    const test::TemporaryFolder folder;
    std::string text = kTriangles;
    for (int i = 0; i < 200'000; ++i) text += fmt::format("f 1 2 {}\n", i % 2 + 3);
    std::string file = utf16(text + "o ", false);
    file += std::string("\xE9\0", 2) + std::string("\x3D\xD8\x00\xDE", 4);  // é and U+1F600
    file += utf16("\nf 1 2 3\n", false).substr(2);
    test::writeText(folder / "m.obj", file);
    const Result<Scene> scene = readScene(folder / "m.obj");
    ASSERT_TRUE(scene) << format(scene.errors());
    ASSERT_EQ(scene->objects.size(), 2u);
    EXPECT_EQ(scene->objects[0].mesh->polygonCount(), 200'000u);
    EXPECT_EQ(scene->objects[1].name, "\xC3\xA9\xF0\x9F\x98\x80");
}

}  // namespace
}  // namespace pipeline
