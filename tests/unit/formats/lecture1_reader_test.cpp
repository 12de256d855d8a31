// Lecture 1's two examples, to the letter: what must be in the scene is written out from the
// lecture's page.
#include <gtest/gtest.h>

#include "pipeline/formats/lecture/lecture_formats.h"
#include "pipeline/formats/scene_reader.h"

namespace pipeline {
namespace {

Scene pyramidScene() {
    const Result<Scene> scene = readScene(resourceFolder() / "scenes" / "pyramid.scene");
    EXPECT_TRUE(scene) << format(scene.errors());
    return scene ? *scene : Scene{};
}

TEST(LectureOneReader, ViewingParameters) {
    const Scene scene = pyramidScene();
    EXPECT_EQ(scene.name, "pyramid.scene");
    EXPECT_EQ(scene.file, (resourceFolder() / "scenes" / "pyramid.scene").string());
    EXPECT_EQ(scene.camera.kind, CameraKind::Spherical);
    EXPECT_EQ(scene.camera.screenDistance, 200);
    EXPECT_EQ(scene.camera.rho, 1000);
    EXPECT_EQ(scene.camera.theta, 45);
    EXPECT_EQ(scene.camera.phi, 60);
    EXPECT_EQ(scene.camera.pixelsPerUnit, 1);
}

TEST(LectureOneReader, Object) {
    const Scene scene = pyramidScene();
    ASSERT_EQ(scene.objects.size(), 1u);
    const Object& object = scene.objects[0];
    EXPECT_EQ(object.name, "pyramid");
    EXPECT_EQ(object.mesh->file, "pyramid.des");
    EXPECT_EQ(object.transform, (ObjectTransform{{1.8, 1.0, 1.0}, {0, 0, 0}, {200, 0, 0}}));
    EXPECT_EQ(object.material, (Material{{0.2, 0.5, 0.9}, {0.4, 0.4, 0.4}, 8, {0.2, 0.5, 0.9}}));
}

TEST(LectureOneReader, Lights) {
    const Scene scene = pyramidScene();
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0], (Light{LightKind::AtInfinity, {500, 500, 500}, 100, {1, 1, 1}, true}));
    EXPECT_EQ(scene.ambient, (AmbientLight{50, {1, 1, 1}}));
    EXPECT_EQ(scene.settings, Settings{});
}

TEST(LectureOneReader, VerticesAndPolygons) {
    const Scene scene = pyramidScene();
    ASSERT_EQ(scene.objects.size(), 1u);
    const Mesh& mesh = *scene.objects[0].mesh;
    EXPECT_EQ(mesh.positions, (std::vector<Vec3d>{{0, 0, 0}, {150, 0, 0}, {150, 150, 0}, {0, 150, 0}, {75, 75, 150}}));
    EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{0, 1, 4, 1, 2, 4, 2, 3, 4, 0, 4, 3, 0, 3, 2, 1}));
    EXPECT_EQ(mesh.firstCorner, (std::vector<std::uint32_t>{0, 3, 6, 9, 12, 16}));
    EXPECT_TRUE(mesh.facts.closed);
    EXPECT_TRUE(mesh.facts.convex);
}

// 3,(0,1,4), 3,(1,2,4), 3,(2,3,4), 3,(0,4,3), 4,(0,3,2,1)   line 11 of the file
// 1          12         23         34         45
TEST(LectureOneReader, PolygonsKnowTheirPlaces) {
    const Scene scene = pyramidScene();
    ASSERT_EQ(scene.objects.size(), 1u);
    EXPECT_EQ(scene.objects[0].mesh->polygonPlaces,
              (std::vector<TextPosition>{{11, 1}, {11, 12}, {11, 23}, {11, 34}, {11, 45}}));
}

TEST(LectureOneReader, BuiltInScenesCanBeRead) {
    ASSERT_FALSE(builtInScenes().empty());
    EXPECT_EQ(builtInScenes().front().name, "pyramid");
    for (const BuiltInScene& builtIn : builtInScenes()) {
        const Result<Scene> scene = readScene(builtIn.file);
        EXPECT_TRUE(scene) << (scene ? "" : format(scene.errors()));
        EXPECT_FALSE(builtIn.title.empty());
        EXPECT_TRUE(builtIn.look.ends_with('.'));
    }
}

TEST(LectureOneReader, ObjectDescriptionOpensAsAScene) {
    const Result<Scene> scene = readScene(resourceFolder() / "scenes" / "pyramid.des");
    ASSERT_TRUE(scene) << format(scene.errors());
    ASSERT_EQ(scene->objects.size(), 1u);
    EXPECT_EQ(scene->objects[0].name, "pyramid");
    EXPECT_EQ(scene->objects[0].mesh->file, "pyramid.des");
    // The box around the pyramid is 150 a side; its centre goes to the origin. Half its
    // diagonal is 75 sqrt(3), the eye is four times as far away.
    EXPECT_EQ(scene->objects[0].transform.translation, Vec3d(-75, -75, -75));
    EXPECT_DOUBLE_EQ(scene->camera.rho, 519.61524227066318806);
    EXPECT_EQ(scene->lights.size(), 1u);
}

TEST(LectureOneReader, OneFileUsedTwiceIsOneMesh) {
    const Result<Scene> scene = readScene(resourceFolder() / "scenes" / "two_pyramids.scene");
    ASSERT_TRUE(scene) << format(scene.errors());
    ASSERT_EQ(scene->objects.size(), 2u);
    EXPECT_EQ(scene->objects[0].mesh, scene->objects[1].mesh);
    EXPECT_EQ(scene->objects[0].name, "pyramid");
    EXPECT_EQ(scene->objects[1].name, "pyramid 2");
}

// The same numbers in other clothes.
TEST(LectureOneReader, SeparatorsLineEndsAndCommentsDoNotMatter) {
    const std::string plain = "3 1 0 0 0 1 0 0 0 1 0 3 0 1 2 0.2 0.5 0.9 0.4 8";
    const std::string variants[] = {
        "3, 1\n(0,0,0), (1,0,0), (0,1,0)\n3,(0,1,2)\n.2,.5,.9\n.4\n8\n",
        "3,1\r\n(0,0,0)\r\n(1,0,0)\r\n(0,1,0)\r\n3,(0,1,2)\r\n0.2 0.5 0.9\r\n0.4\r\n8",
        "3 1\r(0 0 0)\r1 0 0\r0 1 0\r3 0 1 2\r0.2 0.5 0.9 0.4 8\r",
        "\xEF\xBB\xBF"
        "3\t1\f0\v0 0 1 0 0 0 1 0 3 0 1 2 0.2 0.5 0.9 0.4 8",
        "//first\n3//three\n,,1((0,0,0)1,0,0)0 1 0 3(0 1 2)//corners\r0.2 0.5 0.9 //\n0.4 8// end",
        "+3 +1 -0 0. 0e5 +1 0.0 0 0 1e0 0 3 0 1 2 2e-1 5E-1 +9.0e-1 0.4 8.",
        "3 1 0 0 1e-999 1 0 0 0 1 -1e-400 3 0 1 2 0.2 0.5 0.9 0.4 8",
    };
    Errors errors;
    const ObjectDescription expected = readObjectDescription({plain, "plain"}, errors);
    ASSERT_TRUE(errors.empty()) << format(errors);
    for (const std::string& text : variants) {
        const ObjectDescription description = readObjectDescription({text, "variant"}, errors);
        EXPECT_TRUE(errors.empty()) << text << '\n' << format(errors);
        errors.clear();
        EXPECT_EQ(description.mesh.positions, expected.mesh.positions) << text;
        EXPECT_EQ(description.mesh.corners, expected.mesh.corners) << text;
        EXPECT_EQ(description.mesh.triangles, expected.mesh.triangles) << text;
        EXPECT_EQ(description.material, expected.material) << text;
    }
}

}  // namespace
}  // namespace pipeline
