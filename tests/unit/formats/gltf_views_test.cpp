// The cameras and lights of a glTF file, in place of those that the program adds.
#include "pipeline/formats/gltf/gltf_views.h"

#include <gtest/gtest.h>

#include "pipeline/formats/scene_reader.h"
#include "tests/support/files.h"
#include "tests/support/gltf_files.h"

namespace pipeline {
namespace {

// The square from (0, 0, 0) to (1, 1, 0) of the file, seen from 3 before its middle; in the scene, whose z is up and whose
// origin is its middle, that is (0, -3, 0). yfov π / 3 is 60°. The second camera is turned about x by 90°: it looks along
// the file's +y, which is the scene's +z.
struct GltfViewsTest : testing::Test {
    GltfViewsTest() {
        test::Parts parts = test::squareParts();
        parts["nodes"] = R"([{"mesh": 0, "children": [1, 2, 3, 4, 5]},
            {"camera": 0, "name": "from the front", "translation": [0.5, 0.5, 3]},
            {"camera": 1, "translation": [0.5, -2, 0], "rotation": [0.70710678118654752, 0, 0, 0.70710678118654752]},
            {"translation": [0.5, 0.5, 2], "extensions": {"KHR_lights_punctual": {"light": 0}}},
            {"rotation": [-0.70710678118654752, 0, 0, 0.70710678118654752],
             "extensions": {"KHR_lights_punctual": {"light": 1}}},
            {"translation": [0.5, 0.5, 4], "extensions": {"KHR_lights_punctual": {"light": 2}}}])";
        parts["cameras"] =
            R"([{"type": "perspective", "perspective": {"yfov": 1.0471975511965976, "znear": 0.5, "zfar": 9}},
                               {"type": "orthographic", "orthographic": {"xmag": 2, "ymag": 1.5, "znear": 0, "zfar": 5}}])";
        parts["extensionsUsed"] = R"(["KHR_lights_punctual"])";
        parts["extensions"] = R"({"KHR_lights_punctual": {"lights": [
            {"type": "point", "color": [1, 0.5, 0], "intensity": 4},
            {"type": "directional", "intensity": 2},
            {"type": "spot", "intensity": 16, "spot": {"outerConeAngle": 0.5235987755982988}}]}})";
        test::writeText(folder / "m.gltf", test::fileOf(parts));
        test::writeText(folder / "plain.gltf", test::fileOf(test::squareParts()));
    }
    Result<Scene> with(const char* name, const GltfViews& views) {
        return withGltfViews(readScene(folder / name).value(), folder / name, views);
    }
    const test::TemporaryFolder folder;
};

void expectNear(const Vec3d& is, const Vec3d& expected) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(is[c], expected[c], 1e-15) << c;
}

TEST_F(GltfViewsTest, ACameraIsTakenByItsNumber) {
    const auto first = with("m.gltf", {0, false});
    ASSERT_TRUE(first) << format(first.errors());
    EXPECT_EQ(first->camera.kind, CameraKind::LookAt);
    expectNear(first->camera.eye, {0, -3, 0});
    expectNear(first->camera.target - first->camera.eye, {0, 1, 0});
    expectNear(first->camera.up, {0, 0, 1});
    EXPECT_NEAR(first->camera.fovY, 60, 1e-13);
    EXPECT_EQ(first->camera.near, 0.5);
    EXPECT_EQ(first->camera.far, 9);
    EXPECT_EQ(first->lights.size(), 1u) << "that of the program stays";
    EXPECT_EQ(gltfCameras(folder / "m.gltf").value(), (std::vector<std::string>{"from the front", "camera 1"}));
    EXPECT_EQ(gltfCameras(folder / "plain.gltf").value(), std::vector<std::string>{});
    const auto second = with("m.gltf", {1, false});
    ASSERT_TRUE(second) << format(second.errors());
    EXPECT_EQ(second->camera.projection, ProjectionKind::Orthographic);
    EXPECT_EQ(second->camera.height, 3);
    expectNear(second->camera.target - second->camera.eye, {0, 0, 1});
    const auto third = with("m.gltf", {2, false});
    ASSERT_FALSE(third);
    EXPECT_EQ(format(third.errors()),
              (folder / "m.gltf").string() + ": the file has 2 cameras, expected --camera 0 to 1\n");
    EXPECT_FALSE(with("plain.gltf", {0, false}));
}

// At the middle: 4 candela from 2 away are 1, a directional light's lux are 2, 16 candela from 4 away 1. Together they are
// as bright as the program's light, of 100.
TEST_F(GltfViewsTest, LightsAreTakenTogether) {
    const auto lit = with("m.gltf", {{}, true});
    ASSERT_TRUE(lit) << format(lit.errors());
    ASSERT_EQ(lit->lights.size(), 3u);
    const Light &point = lit->lights[0], &far = lit->lights[1], &spot = lit->lights[2];
    EXPECT_EQ(point.kind, LightKind::Point);
    expectNear(point.position, {0, -2, 0});
    EXPECT_EQ(point.color, Vec3d(1, 0.5, 0));
    EXPECT_NEAR(point.intensity, 25, 1e-12);
    EXPECT_EQ(far.kind, LightKind::AtInfinity);
    expectNear(far.position, {0, 0, 1});  // turned about x by -90°, +z of the node is the file's +y
    EXPECT_NEAR(far.intensity, 50, 1e-12);
    EXPECT_NEAR(spot.intensity, 25, 1e-12);
    EXPECT_NEAR(spot.gl.spotCutoff, 30, 1e-13);
    expectNear(spot.gl.spotDirection, {0, 1, 0});
    const auto none = with("plain.gltf", {{}, true});
    ASSERT_FALSE(none);
    EXPECT_EQ(format(none.errors()),
              (folder / "plain.gltf").string() + ": the file has no light, expected no --lights\n");
}

TEST_F(GltfViewsTest, TheSceneSaysThatTheyAreThere) {
    std::string said;
    const Scene scene = readScene(folder / "m.gltf").value();
    for (const Remark& remark : scene.remarks) said += remark.text + '\n';
    EXPECT_NE(said.find("The file has 2 cameras; --camera 0 takes its first.\n"), std::string::npos) << said;
    EXPECT_NE(said.find("The file has 3 lights; --lights file takes them.\n"), std::string::npos) << said;
    EXPECT_EQ(said.find("is not read"), std::string::npos) << said;
}

TEST_F(GltfViewsTest, OtherFilesHaveNone) {
    test::writeText(folder / "m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto other = with("m.obj", {0, false});
    ASSERT_FALSE(other);
    EXPECT_NE(format(other.errors()).find("--camera takes what a glTF file has, expected a .gltf or .glb"),
              std::string::npos);
}

}  // namespace
}  // namespace pipeline
