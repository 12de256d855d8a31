#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "pipeline/inspect/pixel_report.h"
#include "pipeline/inspect/shadow_blocker.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

std::shared_ptr<const Mesh> square(double half, double z) {
    return test::mesh({{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}}, {{0, 1, 2, 3}});
}

// A lid of half side 1 at z = 2 over a floor at z = 0, the light straight above. Seen obliquely, so that the floor under
// the lid comes into sight.
Scene lidOverFloor() {
    Scene scene;
    scene.settings.width = 100, scene.settings.height = 100, scene.settings.shadowSize = 64;
    scene.settings.cull = CullMode::None;
    scene.camera.kind = CameraKind::LookAt, scene.camera.projection = ProjectionKind::Orthographic;
    scene.camera.eye = {0, -10, 10}, scene.camera.height = 10;
    scene.objects.push_back({"floor", square(4, 0), {}, {}});
    scene.objects.push_back({"lid", square(1, 2), {}, {}});
    scene.lights.push_back({LightKind::AtInfinity, {0, 0, 1}, 1, Vec3d(1), true});
    return scene;
}

// The view is along (0, 1, -1)/√2, ten world units high in 100 rows: the world's origin stands in the middle, under the
// lid and behind nothing, for the lid at z = 2 is seen √2 higher, 14 rows up.
TEST(ShadowEvents, AnswerTheLecturesComparisonInNumbers) {
    const FramePtr frame = test::frameOf(lidOverFloor());
    const PixelReport floor = inspectPixel(*frame, {50, 52});
    ASSERT_EQ(floor.fragments.size(), 1u);
    ASSERT_EQ(floor.fragments[0].shadows.size(), 1u);
    // z' counts from the plane nearest to the light, that of the lid: the floor stands at 2, the lid at 0.
    const std::string& shadowed = floor.fragments[0].shadows[0];
    EXPECT_EQ(shadowed.find("light 0: z' 2.000000 > Z'["), 0u) << shadowed;
    EXPECT_NE(shadowed.find("] 0.000000 + "), std::string::npos) << shadowed;
    EXPECT_NE(shadowed.find(": in shadow, only the ambient term"), std::string::npos) << shadowed;
    EXPECT_EQ(floor.shadow[0], 0);
    // The equation's note has the same numbers, and names the lid, polygon 1.
    const std::string numbers = shadowed.substr(9, shadowed.find(": in shadow") - 9);
    EXPECT_EQ(floor.evaluations[0].lights[0].note,
              "In the shadow of polygon 1 of lid, before light 0: only the ambient term counts (" + numbers + ").");
    EXPECT_EQ(blockersOf(*frame, floor), std::vector<int>{1});

    const PixelReport beside = inspectPixel(*frame, {50, 70});
    ASSERT_EQ(beside.fragments.size(), 1u);
    EXPECT_EQ(beside.fragments[0].shadows[0].find("light 0: z' 2.000000 ≤ Z'["), 0u) << beside.fragments[0].shadows[0];
    EXPECT_EQ(beside.shadow[0], 1);
}

// In the order of the loop: the floor comes first and is asked about its shadow, the lid comes after it, is nearer and
// is asked as well; drawn the other way round the floor is not nearer, and nobody asks.
TEST(ShadowEvents, ComeWhereAFragmentWins) {
    Scene scene = lidOverFloor();
    const glm::ivec2 onLid{50, 50 - 14};
    const PixelReport both = inspectPixel(*test::frameOf(scene), onLid);
    ASSERT_EQ(both.fragments.size(), 2u);
    EXPECT_FALSE(both.fragments[0].shadows.empty());
    EXPECT_FALSE(both.fragments[1].shadows.empty());
    std::swap(scene.objects[0], scene.objects[1]);
    const PixelReport swapped = inspectPixel(*test::frameOf(scene), onLid);
    ASSERT_EQ(swapped.fragments.size(), 2u);
    EXPECT_FALSE(swapped.fragments[0].shadows.empty());
    EXPECT_TRUE(swapped.fragments[1].shadows.empty());
}

TEST(ShadowEvents, FacingAwayNeedsNoComparison) {
    Scene scene = lidOverFloor();
    scene.lights[0].position = {0, 0, -1};
    const PixelReport r = inspectPixel(*test::frameOf(scene), {50, 70});
    EXPECT_EQ(r.fragments[0].shadows[0], "light 0: the polygon faces away: only the ambient term");
    scene.settings.model = Model::OpenGl;
    EXPECT_TRUE(inspectPixel(*test::frameOf(scene), {50, 70}).fragments[0].shadows.empty());
}

// Without a bias what a texel holds and what is compared with it differ in the last digits, which are then shown.
TEST(ShadowEvents, TheNumbersShowTheirRelation) {
    Scene scene = lidOverFloor();
    // Turned, and straight under the light as before: every place on the floor is as deep but for rounding.
    for (Object& object : scene.objects) object.transform.rotation = {30, 0, 0};
    scene.lights[0].position = {0, -0.5, std::sqrt(0.75)};
    scene.settings.shadowBias = ShadowBias::Constant, scene.settings.shadowBiasValue = 0;
    const FramePtr frame = test::frameOf(scene);
    int compared = 0, shadowed = 0;
    for (int y = 0; y < 100; y += 3)
        for (int x = 0; x < 100; x += 3)
            for (const FragmentReport& fragment : inspectPixel(*frame, {x, y}).fragments)
                for (const std::string& text : fragment.shadows) {
                    double z = 0, stored = 0, bias = 0;
                    char relation[4]{};
                    if (std::sscanf(text.c_str(), "light 0: z' %lf %3s Z'[%*d][%*d] %lf + %lf", &z, relation, &stored,
                                    &bias) != 4)
                        continue;
                    ++compared, shadowed += relation[0] == '>';
                    ASSERT_EQ(z > stored + bias, relation[0] == '>') << text;
                }
    EXPECT_GT(compared, 300);
    EXPECT_GT(shadowed, 30);
}

}  // namespace
}  // namespace pipeline
