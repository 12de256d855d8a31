// Shadows where geometry says: a box on a floor, a light whose shadow is worked out by hand.
#include <gtest/gtest.h>

#include "pipeline/scene/view.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

// A box 2 x 2 x 2 on the floor z = 0, centred on the origin, seen from straight above (orthographic,
// 10 x 10 world units on 200 x 200 pixels: 0.05 world units a pixel).
Scene boxOnFloor(LightKind kind, Vec3d light) {
    Scene scene;
    scene.settings.width = scene.settings.height = 200;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.projection = ProjectionKind::Orthographic;
    scene.camera.eye = {0, 0, 20}, scene.camera.target = {0, 0, 0}, scene.camera.up = {0, 1, 0};
    scene.camera.height = 10;
    Object floor{"floor", test::mesh({{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}}, {{0, 1, 2, 3}}), {}, {}};
    Object box{"box", test::box({-1, -1, 0}, {1, 1, 2}), {}, {}};
    scene.objects = {floor, box};
    scene.lights.push_back({kind, light, 1, Vec3d(1), true});
    return scene;
}

// Counts the floor pixels whose shadow factor is not what inShadow(world x, world y) says, leaving out
// those within `border` world units of the shadow's outline.
template <class InShadow, class NearOutline>
int wrongPixels(const Scene& scene, InShadow inShadow, NearOutline nearOutline, int* shadowed) {
    const FramePtr frame = test::frameOf(scene);
    const AnyBuffer shadow = *frame->buffer({BufferId::Shadow, 0}), object = *frame->buffer({BufferId::ObjectId});
    int wrong = 0;
    *shadowed = 0;
    for (std::size_t j = 0; j < 200; ++j) {
        for (std::size_t i = 0; i < 200; ++i) {
            if (object.value(i, j) != 0) continue;
            const double x = (double(i) + 0.5) * 0.05 - 5, y = 5 - (double(j) + 0.5) * 0.05;
            *shadowed += shadow.value(i, j) == 0;
            if (!nearOutline(x, y)) wrong += shadow.value(i, j) != (inShadow(x, y) ? 0 : 1);
        }
    }
    return wrong;
}

// Light at infinity from (1, 0, 1): a point at height h throws its shadow h to the left. The box's shadow on
// the floor is x from -3 to -1 beside it, y from -1 to 1: 2 x 2 units, 1600 pixels.
TEST(ShadowGeometry, LightAtInfinity) {
    for (const Precision precision : {Precision::Float, Precision::Double}) {
        Scene scene = boxOnFloor(LightKind::AtInfinity, {1, 0, 1});
        scene.settings.precision = precision;
        int shadowed = 0;
        // Two texels: the buffer's 1024 texels span at most sqrt 2 · 10 + 2 units.
        const double border = 2 * 16.2 / 1024;
        const int wrong = wrongPixels(
            scene, [](double x, double y) { return x > -3 && x < -1 && std::abs(y) < 1; },
            [&](double x, double y) {
                return std::abs(x + 3) < border || std::abs(x + 1) < border || std::abs(std::abs(y) - 1) < border;
            },
            &shadowed);
        EXPECT_EQ(wrong, 0);
        EXPECT_NEAR(shadowed, 1600, 80);  // two texels along an outline of 8 units
    }
}

// Point light at (4, 0, 4): from the light's height 4, the box's top at height 2 is halfway to the floor, so
// its corners (±1, ±1, 2) fall on 2 (x, y) - (4, 0): x from -6 to -2, y from -2 to 2. With the box's own
// footprint the shadow is the convex hull of both; on the floor outside the footprint.
TEST(ShadowGeometry, PointLight) {
    Scene scene = boxOnFloor(LightKind::Point, {4, 0, 4});
    const auto inHull = [](double x, double y, double grow) {
        // Between x = -6 and 1, below the line through (-2, 2) and (1, 1), which is y = (4 - x) / 3; that line also
        // runs through the light's foot (4, 0).
        const double limit = x < -2 ? 2 : (4 - x) / 3;
        return x > -6 - grow && x < 1 + grow && std::abs(y) < limit + grow;
    };
    int shadowed = 0;
    // A face of 90 degrees and 1024 texels: 2 · 4 / 1024 units a texel straight below, up to 6 times that at a
    // distance of 10 along the floor.
    const double border = 0.1;
    const int wrong = wrongPixels(
        scene, [&](double x, double y) { return inHull(x, y, 0); },
        [&](double x, double y) { return inHull(x, y, border) != inHull(x, y, -border); }, &shadowed);
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(shadowed, 1600);
}

// With no bias a plane shadows itself in stripes; with the closed form it never does, at any angle.
TEST(ShadowGeometry, TheClosedFormBiasLeavesNoAcne) {
    for (const double height : {0.05, 0.3, 1.0, 5.0}) {  // light 0.6 to 79 degrees above the floor
        Scene scene = boxOnFloor(LightKind::AtInfinity, {1, 0.37, height});
        scene.objects.pop_back();
        scene.objects.push_back(scene.objects[0]);  // two coplanar floors: not a convex object alone
        scene.settings.shadowSize = 128;
        const auto shadowedPixels = [&] {
            const FramePtr frame = test::frameOf(scene);
            const AnyBuffer shadow = *frame->buffer({BufferId::Shadow, 0});
            int count = 0;
            for (std::size_t i = 0; i < shadow.count(); ++i) count += shadow.flat(i) < 1;
            return count;
        };
        EXPECT_EQ(shadowedPixels(), 0) << height;
        scene.settings.shadowBias = ShadowBias::Constant;
        scene.settings.shadowBiasValue = 0;
        EXPECT_GT(shadowedPixels(), 8000) << height;  // about half of 40 000
    }
}

}  // namespace
}  // namespace pipeline
