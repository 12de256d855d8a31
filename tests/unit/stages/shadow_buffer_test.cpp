#include "pipeline/stages/shadow_buffer.h"

#include <gtest/gtest.h>

#include "pipeline/stages/shadow_factor.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

Scene withLight(LightKind kind, Vec3d position) {
    Scene scene;
    scene.settings.width = scene.settings.height = 16;
    scene.settings.shadowSize = 64;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, 0, 30};
    scene.lights.push_back({kind, position, 1, Vec3d(1), true});
    return scene;
}

// A plane across the light at z' = 7 behind a small plate at z' = 0: z' counts from what is nearest to the light.
TEST(ShadowBuffer, HoldsTheDistanceOfTheClosestSurface) {
    Scene scene = withLight(LightKind::AtInfinity, {0, 0, 3});
    scene.objects.push_back(
        {"floor", test::mesh({{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}}, {{0, 1, 2, 3}}), {}, {}});
    scene.objects.push_back(
        {"plate", test::mesh({{-1, -1, 7}, {1, -1, 7}, {1, 1, 7}, {-1, 1, 7}}, {{0, 1, 2, 3}}), {}, {}});
    const AnyBuffer z = *test::frameOf(scene)->buffer({BufferId::ShadowBuffer, 0});
    ASSERT_EQ(z.shape, (std::vector<std::size_t>{64, 64}));
    EXPECT_EQ(z.value(32, 32), 0);
    EXPECT_EQ(z.value(3, 32), 7);
    EXPECT_TRUE(std::isinf(z.value(0, 0)));  // the border of a texel around everything
}

// A box 2 high, lit from above: its top stands at z' = 0, its bottom at 2; the sides have no area there. So it is for a
// box that is mirrored, whose polygons run the other way round.
TEST(ShadowBuffer, LeavesOutWhatFacesTheLightOrAway) {
    for (const double mirror : {1.0, -1.0}) {
        Scene scene = withLight(LightKind::AtInfinity, {0, 0, 1});
        scene.objects.push_back({"box", test::box({-1, -1, -1}, {1, 1, 1}), {}, {}});
        scene.objects[0].transform.scale.x = mirror;
        const auto depth = [&](ShadowCull cull) {
            scene.settings.shadowCull = cull;
            return test::frameOf(scene)->buffer({BufferId::ShadowBuffer, 0})->value(32, 32);
        };
        EXPECT_EQ(depth(ShadowCull::None), 0);
        EXPECT_EQ(depth(ShadowCull::Back), 0);
        EXPECT_EQ(depth(ShadowCull::Front), 2);
        scene.objects.push_back({"ghost", test::box({-1, -1, 2}, {1, 1, 3}), {}, {}});
        scene.objects[1].material.alpha = 0;  // as if it were not there
        EXPECT_EQ(depth(ShadowCull::Back), 0);
        EXPECT_EQ(depth(ShadowCull::Front), 2);
    }
}

// Every triangle faces the light or faces away, so that the nearer of what the two modes leave is what all of them have,
// bit by bit; clipped ones too, for the light stands amid them.
TEST(ShadowBuffer, OfBothSidesIsTheNearerOfEach) {
    std::size_t finite = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        Scene scene = test::smallScene(seed);
        scene.lights = {{seed % 2 ? LightKind::Point : LightKind::AtInfinity, {0.1, 0.2, 0.3}, 1, Vec3d(1), true}};
        scene.settings.model = Model::Phong, scene.settings.visibility = Visibility::ZBuffer;
        scene.settings.leaveOut = false;
        const auto depths = [&](ShadowCull cull) {
            scene.settings.shadowCull = cull;
            return *test::frameOf(scene)->buffer({BufferId::ShadowBuffer, 0});
        };
        const AnyBuffer all = depths(ShadowCull::None), fronts = depths(ShadowCull::Back),
                        backs = depths(ShadowCull::Front);
        for (std::size_t i = 0; i < all.count(); ++i) {
            ASSERT_EQ(all.flat(i), std::min(fronts.flat(i), backs.flat(i))) << "seed " << seed << ", texel " << i;
            finite += std::isfinite(all.flat(i));
        }
    }
    EXPECT_GT(finite, 1000u);
}

// A plate between a point light and a wall that faces it, across the seam of two faces (x = y), and larger than what the wall needs:
// the wall is in shadow everywhere, also where filtering reaches beyond the seam.
// Nor is one made because somebody asks for the buffers: what is estimated of memory has none.
TEST(ShadowBuffer, ALightThatCastsNoShadowHasNone) {
    Scene scene = test::pyramid();
    scene.lights.push_back(scene.lights[0]);
    scene.lights[1].castsShadow = false;
    const FramePtr frame = test::frameOf(scene, setOf({BufferId::ShadowBuffer}));
    EXPECT_TRUE(frame->buffer({BufferId::ShadowBuffer, 0}));
    EXPECT_FALSE(frame->buffer({BufferId::ShadowBuffer, 1}));
    EXPECT_EQ(frame->whyAbsent({BufferId::ShadowBuffer, 1}), "It casts no shadow.");
}

TEST(ShadowBuffer, FilteringReachesAcrossTheSeamsOfAPointLight) {
    Scene scene = withLight(LightKind::Point, {0, 0, 0});
    const Vec3d u = glm::normalize(Vec3d(1, 1, 0)), across = glm::normalize(Vec3d(-1, 1, 0)), up{0, 0, 1};
    const auto square = [&](double distance, double half) {
        const Vec3d middle = distance * u, a = half * across, b = half * up;
        return test::mesh({middle - a - b, middle + a - b, middle + a + b, middle - a + b}, {{3, 2, 1, 0}});
    };
    scene.objects.push_back({"plate", square(1, 2), {}, {}});
    scene.objects.push_back({"wall", square(3, 1), {}, {}});
    scene.camera.eye = 1.2 * u, scene.camera.target = 3.0 * u, scene.camera.up = up, scene.camera.fovY = 40;
    scene.settings.cull = CullMode::None;
    for (const int filter : {0, 1, 4}) {
        scene.settings.shadowFilter = filter;
        const FramePtr frame = test::frameOf(scene);
        const AnyBuffer shadow = *frame->buffer({BufferId::Shadow, 0}), ids = *frame->buffer({BufferId::ObjectId});
        int seen = 0;
        for (std::size_t i = 0; i < shadow.count(); ++i) {
            if (ids.flat(i) != 1) continue;
            EXPECT_EQ(shadow.flat(i), 0) << "filter " << filter << ", pixel " << i;
            ++seen;
        }
        EXPECT_GT(seen, 100);
    }
}

// A light in the middle of a hollow box of half sizes 2, 3, 4: each face sees its wall straight ahead.
TEST(ShadowBuffer, OfAPointLightLooksAllSixWays) {
    Scene scene = withLight(LightKind::Point, {0, 0, 0});
    scene.objects.push_back({"room", test::box({-2, -3, -4}, {2, 3, 4}), {}, {}});
    const AnyBuffer z = *test::frameOf(scene)->buffer({BufferId::ShadowBuffer, 0});
    ASSERT_EQ(z.shape, (std::vector<std::size_t>{6, 64, 64}));
    const double expected[]{2, 2, 3, 3, 4, 4};
    for (std::size_t face = 0; face < 6; ++face) EXPECT_NEAR(z.value(32, 64 * face + 32), expected[face], 1e-6);
    for (std::size_t i = 0; i < z.count(); ++i) ASSERT_TRUE(std::isfinite(z.flat(i))) << "a hole in the room at " << i;
}

// A texel of width w looks up at most half a texel away: on a plane of slope dz/du the depth there differs by
// at most w/2 |dz/du| on each axis. The bias is that, and 1/64 of it for snapping.
TEST(ShadowFactor, TheClosedFormBiasIsHalfATexelsSlope) {
    LightView<double> light;
    View face;
    face.perspective = false;
    face.scale = {10, 20};  // texels of 0.1 x 0.05 units
    face.forward = {0, 0, 1}, face.right = {1, 0, 0}, face.up = {0, 1, 0};
    light.faces = {face};
    const Vec3d normal = glm::normalize(Vec3d(3, 4, 1));  // dz/dx = -3, dz/dy = -4
    const ShadowTest<double> test = shadowTest(light, {ShadowBias::Automatic, 0, 0}, Vec3d(0), normal);
    EXPECT_NEAR(test.bias, 0.5 * (0.1 * 3 + 0.05 * 4) * (1 + 1.0 / 64), 1e-12);
    const ShadowTest<double> wide = shadowTest(light, {ShadowBias::Automatic, 0, 2}, Vec3d(0), normal);
    EXPECT_NEAR(wide.bias, (2.5 + 1.0 / 128) * (0.1 * 3 + 0.05 * 4), 1e-12);
}

// A polygon that lies as the face does has no slope: what keeps it from shadowing itself is the rounding of its z'.
TEST(ShadowFactor, ASlopesFactorLeavesTheRoundingAsItIs) {
    LightView<double> light;
    light.rounding = 0x1p-40;
    View face;
    face.perspective = false;
    face.forward = {0, 0, 1}, face.right = {1, 0, 0}, face.up = {0, 1, 0};
    light.faces = {face};
    for (const double factor : {0.0, 1.0, 1.5})
        EXPECT_EQ(shadowTest(light, {ShadowBias::Slope, factor, 0}, Vec3d(0), Vec3d(0, 0, -1)).bias, 0x1p-40);
    const Vec3d slanted = glm::normalize(Vec3d(3, 4, 1));
    EXPECT_EQ(shadowTest(light, {ShadowBias::Slope, 1, 0}, Vec3d(0), slanted).bias,
              shadowTest(light, {ShadowBias::Automatic, 0, 0}, Vec3d(0), slanted).bias);
}

TEST(ShadowFactor, FilteringCountsTexels) {
    LightView<double> light;
    View face;
    face.perspective = false;
    face.size = {4, 4};
    face.centre = {2, 2}, face.scale = {1, 1};
    face.forward = {0, 0, 1}, face.right = {1, 0, 0}, face.up = {0, 1, 0};
    light.faces = {face};
    light.depth.emplace_back(Buffer2D<double>(face.size, 1.0));
    for (int y = 0; y < 4; ++y) light.depth[0]->at({0, y}) = 9;  // one column of four lies behind the point
    const ShadowSettings constant{ShadowBias::Constant, 0, 1};
    // Texel (1, 1) and its 8 neighbours: the column x = 0 has 3 of the 9.
    EXPECT_EQ(litTexels(light, constant, Vec3d(-0.5, 0.5, 5), Vec3d(0, 0, -1)), 3);
    EXPECT_EQ(litTexels(light, constant, Vec3d(100, 0, 5), Vec3d(0, 0, -1)), 9);     // outside nothing is in the way
    EXPECT_EQ(litTexels(light, constant, Vec3d(-0.5, 0.5, 1), Vec3d(0, 0, -1)), 9);  // what a texel holds is lit
    // However far outside, and however wide the filter.
    const ShadowSettings wide{ShadowBias::Constant, 0, 2};
    EXPECT_EQ(litTexels(light, wide, Vec3d(1e12, 0, 5), Vec3d(0, 0, -1)), 25);
}

}  // namespace
}  // namespace pipeline
