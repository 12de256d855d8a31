#include "pipeline/stages/cull.h"

#include <gtest/gtest.h>

#include "pipeline/run/frame_data.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

// One triangle seen from the origin along +y (z up), 100 x 100 pixels, 90 degrees: |x| and |z| < y is inside.
FramePtr frameOf(Vec3d a, Vec3d b, Vec3d c, Vec3d scale = Vec3d(1), CullMode mode = CullMode::Back) {
    Scene scene;
    scene.settings.width = scene.settings.height = 100;
    scene.settings.cull = mode;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, 0, 0}, scene.camera.target = {0, 1, 0}, scene.camera.fovY = 90;
    scene.camera.near = 1, scene.camera.far = 100;
    scene.objects = {{"t", test::mesh({a, b, c}, {{0, 1, 2}}), {scale, {}, {}}, {}}};
    return test::frameOf(scene);
}
Verdict verdictOf(Vec3d a, Vec3d b, Vec3d c, Vec3d scale = Vec3d(1), CullMode mode = CullMode::Back) {
    return Verdict(int(frameOf(a, b, c, scale, mode)->buffer({BufferId::PolygonsVerdict})->flat(0)));
}
std::optional<double> areaOf(Vec3d a, Vec3d b, Vec3d c, Vec3d scale = Vec3d(1), CullMode mode = CullMode::Back) {
    const FramePtr frame = frameOf(a, b, c, scale, mode);
    return readStages(*frame, [](const auto& data) { return signedArea(*data.transform, *data.cull, 0); });
}

constexpr Vec3d kA{-1, 10, -1}, kB{1, 10, -1}, kC{0, 10, 1};  // counter-clockwise seen from the origin

TEST(Cull, KeepsWhatFacesTheEye) {
    EXPECT_EQ(verdictOf(kA, kB, kC), Verdict::Kept);
    EXPECT_EQ(verdictOf(kA, kC, kB), Verdict::BackFacing);
    EXPECT_EQ(verdictOf(kA, kC, kB, Vec3d(1), CullMode::None), Verdict::Kept);
}

// A mirror turns the winding round; outward faces stay outward, so a front face stays one.
TEST(Cull, AMirroredFrontFaceIsStillAFrontFace) {
    EXPECT_EQ(verdictOf(kA, kB, kC, {-1, 1, 1}), Verdict::Kept);
    EXPECT_EQ(verdictOf(kA, kC, kB, {-1, 1, 1}), Verdict::BackFacing);
}

TEST(Cull, NamesThePlaneThatAPolygonLiesOutsideOf) {
    const auto moved = [](Vec3d by) { return verdictOf(kA + by, kB + by, kC + by); };
    EXPECT_EQ(moved({-30, 0, 0}), Verdict::OutsideLeft);
    EXPECT_EQ(moved({30, 0, 0}), Verdict::OutsideRight);
    EXPECT_EQ(moved({0, 0, 30}), Verdict::OutsideTop);
    EXPECT_EQ(moved({0, 0, -30}), Verdict::OutsideBottom);
    EXPECT_EQ(moved({0, -9.5, 0}), Verdict::OutsideNear);
    EXPECT_EQ(moved({0, -30, 0}), Verdict::OutsideNear);  // behind the eye
    EXPECT_EQ(moved({0, 91, 0}), Verdict::OutsideFar);
}

TEST(Cull, SaysWhatTheNearOrTheFarPlaneCuts) {
    // Its normal (0, 1, 30) points up, at the eye above it.
    EXPECT_EQ(verdictOf({1, 10, -1}, {-1, 10, -1}, {0, -5, -0.5}), Verdict::Clipped);
    EXPECT_EQ(verdictOf({-1, 10, -1}, {1, 10, -1}, {0, 200, 1}), Verdict::Clipped);
    EXPECT_EQ(verdictOf({-1000, 10, -1}, {1, 10, -1}, {0, 10, 1}), Verdict::Kept);  // the border is the rasterizer's
}

TEST(Cull, DropsWhatHasNoArea) {
    EXPECT_EQ(verdictOf(kA, kA, kB), Verdict::Degenerate);
    EXPECT_EQ(verdictOf({0, 10, 0}, {1, 11, 1}, {2, 12, 2}), Verdict::Degenerate);  // on one line
    // 10^-6 units at distance 10 and 5 pixels a unit: far below 1/256 pixel.
    EXPECT_EQ(verdictOf({0, 10, 0}, {1e-6, 10, 0}, {0, 10, 1e-6}), Verdict::Degenerate);
}

// Far beyond the border on both sides, where edge functions in 32 bits would overflow: cut at the guard band,
// and still in front of every pixel.
TEST(Cull, AnEnormousPolygonIsKept) {
    EXPECT_EQ(verdictOf({-1e7, 10, -1e7}, {1e7, 10, -1e7}, {0, 10, 1e7}), Verdict::Kept);
}

// 100 pixels across 20 units at distance 10: 5 px a unit; 2 x 2 units / 2 = 2 square units = 50 px².
TEST(Cull, SaysTheSignedAreaThatCulled) {
    const FramePtr frame = frameOf(kA, kC, kB);
    const std::string why = readStages(*frame, [](const auto& data) { return reason(*data.transform, *data.cull, 0); });
    EXPECT_EQ(why, "back-facing, signed area −50.0 px²");
}

TEST(Cull, FindsTheSignedAreaOfWhateverTheVerdictTookItFor) {
    EXPECT_EQ(areaOf(kA, kB, kC), 50);
    EXPECT_EQ(areaOf(kA, kC, kB), -50);
    EXPECT_EQ(areaOf(kA, kC, kB, Vec3d(1), CullMode::None), -50);
    EXPECT_EQ(areaOf(kA, kB, kC, {-1, 1, 1}), 50);  // mirroring undone
    const Vec3d beside{30, 0, 0};
    EXPECT_EQ(areaOf(kA + beside, kB + beside, kC + beside),
              std::nullopt);  // outside the right plane: no area was taken
}

}  // namespace
}  // namespace pipeline
