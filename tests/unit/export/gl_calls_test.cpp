#include "pipeline/export/buffers/gl_calls.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/export/export_frame.h"
#include "tests/support/files.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

Scene lectureCube() {
    Scene scene = test::openGlCube();
    scene.settings.width = 64, scene.settings.height = 48;
    return scene;
}

std::vector<std::string> linesOf(const Scene& scene) {
    const auto calls = glCalls(*test::frameOf(scene));
    EXPECT_TRUE(calls) << format(calls.errors());
    std::vector<std::string> lines;
    if (calls) std::ranges::transform(*calls, std::back_inserter(lines), toC);
    return lines;
}

std::ptrdiff_t placeOf(const std::vector<std::string>& lines, const std::string& line) {
    const auto found = std::ranges::find(lines, line);
    EXPECT_NE(found, lines.end()) << line << " is missing";
    return found - lines.begin();
}

TEST(GlCalls, AreThoseOfTheLecture) {
    const auto lines = linesOf(lectureCube());
    for (const char* line : {"glShadeModel(GL_FLAT);", "glEnable(GL_DEPTH_TEST);", "glEnable(GL_LIGHTING);",
                             "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);", "glEnable(GL_LIGHT0);",
                             "glLightfv(GL_LIGHT0, GL_AMBIENT, (const GLfloat[]){0.3, 0.3, 0.3, 1});",
                             "glLightfv(GL_LIGHT0, GL_DIFFUSE, (const GLfloat[]){0.5, 0.5, 0.5, 1});",
                             "glLightfv(GL_LIGHT0, GL_POSITION, (const GLfloat[]){1, 1, 1, 0});",
                             "glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 20);"})
        placeOf(lines, line);
    EXPECT_EQ(std::ranges::count(lines, "glBegin(GL_POLYGON);"), 6);
    EXPECT_EQ(std::ranges::count(lines, "glEnd();"), 6);
}

// An L, whose pieces OpenGL is given one by one: not each of them has corner 0, and each is lit with its normal.
TEST(GlCalls, EveryPieceOfAFlatPolygonHasTheNormalOfItsFirstVertex) {
    Scene scene = lectureCube();
    scene.settings.normalWeight = NormalWeight::Given;
    Mesh own = *test::mesh({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}, {{0, 1, 2, 3, 4, 5}});
    for (std::size_t i = 0; i < 6; ++i) own.normals.push_back(i == 0 ? Vec3d(0, 0.6, 0.8) : Vec3d(0, 0, 1));
    scene.objects = {{"L", makeMesh(std::move(own)), {}, {}}};
    const auto lines = linesOf(scene);
    EXPECT_EQ(std::ranges::count(lines, "glBegin(GL_POLYGON);"), 4);
    EXPECT_EQ(std::ranges::count_if(lines, [](const std::string& l) { return l.starts_with("glNormal3d(0, 0.6"); }), 4);
    EXPECT_EQ(std::ranges::count_if(lines, [](const std::string& l) { return l.starts_with("glNormal3d"); }), 4);
}

TEST(GlCalls, SetTheAmbientLightThatOpenGlHasByItself) {
    Scene scene = lectureCube();
    scene.ambient.intensity.reset();
    placeOf(linesOf(scene), "glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (const GLfloat[]){0.2, 0.2, 0.2, 1});");
}

TEST(GlCalls, TurnInTheOrderInWhichTheyAreWritten) {
    const auto lines = linesOf(lectureCube());
    const auto moved = placeOf(lines, "glTranslated(0, 0, -3);");
    EXPECT_EQ(placeOf(lines, "glRotated(20, 1, 0, 0);"), moved + 1);
    EXPECT_EQ(placeOf(lines, "glRotated(20, 0, 1, 0);"), moved + 2);
}

// OpenGL applies the last call first: scale, then x, then y, then z, as the lecture's scene file.
TEST(GlCalls, RotateAboutXFirst) {
    Scene scene = lectureCube();
    scene.objects[0].transform.turns.clear();
    scene.objects[0].transform.rotation = {10, 20, 30};
    scene.objects[0].transform.scale = {1, 1, -2};
    const auto lines = linesOf(scene);
    const auto first = placeOf(lines, "glRotated(30, 0, 0, 1);");
    EXPECT_EQ(placeOf(lines, "glRotated(20, 0, 1, 0);"), first + 1);
    EXPECT_EQ(placeOf(lines, "glRotated(10, 1, 0, 0);"), first + 2);
    EXPECT_EQ(placeOf(lines, "glScaled(1, 1, -2);"), first + 3);
    EXPECT_LT(placeOf(lines, "glFrontFace(GL_CW);"), first);  // it mirrors
}

// Seen from the origin along -z with y up, eye space is world space.
TEST(GlCalls, PutTheEyeWhereTheCameraIs) {
    const auto calls = glCalls(*test::frameOf(lectureCube()));
    ASSERT_TRUE(calls);
    const auto matrix = std::ranges::find(*calls, "glLoadMatrixd", &GlCall::function);
    ASSERT_NE(matrix, calls->end());
    EXPECT_EQ(matrix->numbers, (std::vector<double>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}));
}

TEST(GlCalls, SetLightsInEyeSpaceWithoutTheCamera) {
    Scene scene = lectureCube();
    scene.lights[0].gl.space = LightSpace::Eye;
    const auto lines = linesOf(scene);
    const auto place = placeOf(lines, "glLightfv(GL_LIGHT0, GL_POSITION, (const GLfloat[]){1, 1, 1, 0});");
    EXPECT_EQ(lines[std::size_t(place - 1)], "glLoadIdentity();");
    EXPECT_EQ(lines[std::size_t(place - 2)], "glPushMatrix();");
}

TEST(GlCalls, ConcavePolygonsAreDrawnInPieces) {
    Scene scene = lectureCube();
    // An arrow head: the fan from its first corner would cover the notch.
    scene.objects[0].mesh = test::mesh({{-1, -1, 0}, {0, -0.5, 0}, {1, -1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
    EXPECT_EQ(std::ranges::count(linesOf(scene), "glBegin(GL_POLYGON);"), 2);

    // Of the two pieces one is without the polygon's first corner, by which flat shading goes; near a light, or seen
    // from nearby, another corner is of another brightness.
    const std::string refused =
        "cube has a concave polygon, each of whose pieces OpenGL shades by a corner of its own: set shading to gouraud";
    scene.settings.localViewer = true;
    EXPECT_EQ(glRefuses(scene), refused);
    scene.settings.localViewer = false;
    scene.lights[0].kind = LightKind::Point;
    EXPECT_EQ(glRefuses(scene), refused);
    scene.settings.shading = Shading::Gouraud;
    EXPECT_EQ(glRefuses(scene), "");
}

TEST(GlCalls, AreRefusedWhereOpenGlDrawsSomethingElse) {
    Scene scene = lectureCube();
    EXPECT_EQ(glRefuses(scene), "");
    scene.lights.resize(9, scene.lights[0]);
    EXPECT_EQ(glRefuses(scene), "OpenGL has 8 lights, the scene 9");
    scene.settings.shading = Shading::Phong;
    EXPECT_NE(glRefuses(scene).find("set shading to flat or gouraud"), std::string::npos);
    scene.settings.model = Model::Phong;
    EXPECT_NE(glRefuses(scene).find("set model to opengl"), std::string::npos);
    EXPECT_FALSE(glCalls(*test::frameOf(scene)));
}

// The calls enable the depth test, so that the order of drawing does not matter: not what the painter's algorithm shows.
TEST(GlCalls, RefuseThePaintersAlgorithm) {
    Scene scene = lectureCube();
    scene.settings.visibility = Visibility::Painter;
    EXPECT_EQ(glRefuses(scene),
              "OpenGL's calls test depths, which the painter's algorithm does not: set visibility to z-buffer");
    EXPECT_FALSE(glCalls(*test::frameOf(scene)));
}

TEST(GlCalls, ExportIsOneFunctionThatAsksForErrors) {
    const test::TemporaryFolder folder;
    Scene scene = lectureCube();
    scene.objects[0].name = "a */ \"cube\"";  // must end neither a comment nor a string
    const auto summary = exportFrame(*test::frameOf(scene), {folder.path(), {}, {"opengl"}, {}});
    ASSERT_TRUE(summary) << format(summary.errors());
    EXPECT_EQ(summary->files, (std::vector<std::string>{"cube.gl.c", "manifest.json"}));
    const std::string text = test::readText(folder / "cube.gl.c");
    EXPECT_NE(text.find("void drawScene(void)\n{\n"), std::string::npos);
    EXPECT_NE(text.find("glGetError()"), std::string::npos);
    EXPECT_NE(text.find("    checkError(\"Object 0: a _/ _cube_\");\n    glFlush();\n}\n"), std::string::npos);
    EXPECT_EQ(std::ranges::count(text, '{'), std::ranges::count(text, '}'));
}

TEST(GlCalls, ExportOfAnotherModelWritesNothing) {
    const test::TemporaryFolder folder;
    const auto summary = exportFrame(*test::frameOf(test::pyramid()), {folder / "out", {}, {"npy", "opengl"}, {}});
    ASSERT_FALSE(summary);
    EXPECT_NE(format(summary.errors()).find("set model to opengl"), std::string::npos);
    EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace pipeline
