// The penumbra of an area light where geometry says.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pipeline/inspect/pixel_report.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

constexpr double kHeight = 4, kBlocker = 1, kWidth = 2;  // of the light and the blocker above the floor; of the light

// A floor z = 0 under the half plane x < 0 at height d = 1, under a light at height H = 4 around x = 0. Seen from
// below, so that the blocker hides nothing: 2 x 2 world units on 100 x 100 pixels.
Scene halfPlane(int samples, double lightHeight) {
    Scene scene;
    scene.settings.width = scene.settings.height = 100;
    scene.settings.shadowSize = 512;
    scene.settings.cull = CullMode::None;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.projection = ProjectionKind::Orthographic;
    scene.camera.eye = {0, 0, -20}, scene.camera.target = {0, 0, 0}, scene.camera.up = {0, 1, 0};
    scene.camera.height = 2;
    const auto across = [](double left, double right, double z) {
        return test::mesh({{left, -8, z}, {right, -8, z}, {right, 8, z}, {left, 8, z}}, {{0, 1, 2, 3}});
    };
    scene.objects = {{"floor", across(-8, 8, 0), {}, {}}, {"blocker", across(-8, 0, kBlocker), {}, {}}};
    Light light{LightKind::Area, {0, 0, kHeight}, 100, Vec3d(1), true};
    light.area = {{0, 0, -1}, kWidth, lightHeight, samples};
    scene.lights = {light};
    return scene;
}

// From the floor's point x the line to the light's point s passes height d at x + (s - x) d / H. It is free where that
// is not below 0: s >= -x (H / d - 1). So of a light from -w/2 to w/2 the share 1/2 + x (H / d - 1) / w is seen.
double visibleShare(double x) { return std::clamp(0.5 + x * (kHeight / kBlocker - 1) / kWidth, 0.0, 1.0); }

// Sampled in N cells' centres the share errs by at most 1 / (2 N). Each sample's own edge is drawn on texels of
// 2 H / size on the floor: it lies at most one of them beside the true one.
TEST(SoftShadow, OfAStraightEdgeIsTheVisibleShareOfTheLight) {
    double last = 1;
    for (const int samples : {1, 2, 4, 8, 16}) {
        const FramePtr frame = test::frameOf(halfPlane(samples, 0));
        const AnyBuffer shadow = *frame->buffer({BufferId::Shadow, 0}), place = *frame->buffer({BufferId::Position});
        const double texel = 2 * kHeight / 512, slope = (kHeight / kBlocker - 1) / kWidth;
        double worst = 0;
        int umbra = 0, penumbra = 0, lit = 0;
        for (std::size_t i = 0; i < shadow.count(); ++i) {
            const double x = place.flat(3 * i), s = shadow.flat(i);
            worst = std::max(worst, std::abs(s - visibleShare(x)));
            ASSERT_NEAR(s * samples, std::round(s * samples), 1e-5) << "not a count of samples";
            if (x < -1.0 / 3 - texel) {
                ASSERT_EQ(s, 0) << x;
            }
            if (x > 1.0 / 3 + texel) {
                ASSERT_EQ(s, 1) << x;
            }
            umbra += s == 0, lit += s == 1, penumbra += s > 0 && s < 1;
        }
        EXPECT_LE(worst, 0.5 / samples + texel * slope) << samples;
        EXPECT_GT(worst, 0.4 / samples) << samples;  // the bound is reached: fewer samples are not enough
        EXPECT_LT(worst, last);
        last = worst;
        // A third of the picture each; of the penumbra 1 / N look lit or dark.
        EXPECT_NEAR(penumbra, 10000.0 / 3 * (1 - 1.0 / samples), 300) << samples;
        EXPECT_NEAR(umbra, 10000.0 / 3 * (1 + 0.5 / samples), 300) << samples;
        EXPECT_NEAR(lit, 10000.0 / 3 * (1 + 0.5 / samples), 300) << samples;
    }
}

// The edge runs along the light's other side: rows of samples all say the same.
TEST(SoftShadow, AlongTheEdgeTheLightsExtentDoesNotMatter) {
    const AnyBuffer line = *test::frameOf(halfPlane(4, 0))->buffer({BufferId::Shadow, 0});
    const AnyBuffer area = *test::frameOf(halfPlane(4, 1))->buffer({BufferId::Shadow, 0});
    for (std::size_t i = 0; i < line.count(); ++i) ASSERT_EQ(line.flat(i), area.flat(i)) << i;
}

TEST(SoftShadow, APixelTellsUmbraFromPenumbra) {
    const FramePtr frame = test::frameOf(halfPlane(4, 1));
    const AnyBuffer place = *frame->buffer({BufferId::Position});
    const auto textAt = [&](double x) {
        std::size_t best = 0;
        for (std::size_t i = 0; i < 100; ++i)
            if (std::abs(place.flat(3 * i) - x) < std::abs(place.flat(3 * best) - x)) best = i;
        return toText(*frame, inspectPixel(*frame, {int(best), 0}));
    };
    EXPECT_NE(textAt(-0.5).find("light 0      umbra\n"), std::string::npos) << textAt(-0.5);
    EXPECT_NE(textAt(-0.5).find("In the umbra of light 0: only the ambient term counts."), std::string::npos);
    EXPECT_NE(textAt(0.5).find("light 0      lit\n"), std::string::npos);
    // The middle: half of the light, two of four columns.
    EXPECT_NE(textAt(0).find("light 0      penumbra (S = 0.50)\n"), std::string::npos) << textAt(0);
}

}  // namespace
}  // namespace pipeline
