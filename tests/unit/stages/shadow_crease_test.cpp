// Shadow buffers where polygons are not planar, and where they meet in a crease that rises towards the light.
#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/stages/texel_test.h"
#include "pipeline/study/shadow_verdict.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

ShadowVerdicts judge(const Scene& scene) {
    const FramePtr frame = test::frameOf(scene, setOf({BufferId::Shadow, BufferId::Position}));
    return judgeShadows(*frame, exactShadows(scene, 0, 1).value()).value();
}
std::size_t count(const ShadowVerdicts& found, ShadowVerdict verdict) { return found.counts[std::size_t(verdict)]; }

// A saddle as one quad, or as the two triangles of the fan that it is drawn as.
Scene saddle(bool asTriangles) {
    Scene scene;
    scene.settings.width = scene.settings.height = 128;
    scene.settings.cull = CullMode::None;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0.4, -1.2, 2}, scene.camera.target = {0.5, 0.5, 0.1}, scene.camera.fovY = 40;
    std::vector<std::vector<std::uint32_t>> polygons{{0, 1, 2, 3}};
    if (asTriangles) polygons = {{0, 1, 2}, {0, 2, 3}};
    scene.objects.push_back({"saddle", test::mesh({{0, 0, 0}, {1, 0, 0.3}, {1, 1, 0}, {0, 1, 0.3}}, polygons), {}, {}});
    scene.lights.push_back({LightKind::AtInfinity, {5, 2, 6}, 100, Vec3d(1), true});
    return scene;
}

// One normal for both planes would leave a bias that is too small for the steeper of them.
TEST(ShadowCrease, APolygonThatIsNotPlanarIsShadowedLikeTheTrianglesItIsDrawnAs) {
    for (const Precision precision : {Precision::Float, Precision::Double})
        for (const LightKind kind : {LightKind::AtInfinity, LightKind::Point})
            for (const int size : {64, 256, 1024}) {
                Scene quad = saddle(false), triangles = saddle(true);
                for (Scene* scene : {&quad, &triangles}) {
                    scene->settings.precision = precision, scene->settings.shadowSize = size;
                    scene->lights[0].kind = kind;
                }
                const ShadowVerdicts found = judge(quad), expected = judge(triangles);
                EXPECT_GT(count(found, ShadowVerdict::Lit), 1000u);
                EXPECT_EQ(count(found, ShadowVerdict::Acne), 0u) << size;
                EXPECT_EQ(found.verdicts.pixels, expected.verdicts.pixels) << size;
            }
}

// A wall that leans towards the light on a ground, both as large as many texels. The light sees every point of both: z
// grows from the wall's top to the crease, and from there on along the ground. Turned, so that no texels lie along it.
Scene valley(double turn, LightKind kind) {
    Scene scene;
    scene.settings.width = scene.settings.height = 256;
    scene.settings.shading = Shading::Phong;
    scene.settings.cull = CullMode::None;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {-2, -3, 4}, scene.camera.target = {0, 0, 0}, scene.camera.fovY = 40;
    const double c = std::cos(turn), s = std::sin(turn);
    const auto at = [&](double x, double y, double z) { return Vec3d(c * x - s * y, s * x + c * y, z); };
    scene.objects.push_back(
        {"valley",
         test::mesh({at(-1, -1, 0), at(0, -1, 0), at(0, 1, 0), at(-1, 1, 0), at(0.4, -1, 1.2), at(0.4, 1, 1.2)},
                    {{0, 1, 2, 3}, {1, 4, 5, 2}}),
         {},
         {}});
    const Vec3d towards = at(-3, 1, 6);
    scene.lights.push_back({kind, towards, 100, Vec3d(1), true});
    return scene;
}

// The wall's z at a texel's centre beyond the crease is nearer than the ground's bias allows for; continued to the point
// it is not. At the ends of the crease the texels beside may hold nothing that tells the wall's slope: but for these all
// is lit.
TEST(ShadowCrease, ACreaseThatRisesTowardsTheLightIsLitOnBothSides) {
    for (const LightKind kind : {LightKind::AtInfinity, LightKind::Point})
        for (const Precision precision : {Precision::Float, Precision::Double})
            for (const double turn : {0.3, 0.5, 1.1})
                for (const int filter : {0, 1, 2})
                    for (const int size : {200, 512}) {
                        Scene scene = valley(turn, kind);
                        scene.settings.precision = precision, scene.settings.shadowFilter = filter;
                        scene.settings.shadowSize = size;
                        const FramePtr frame = test::frameOf(scene);
                        const AnyBuffer S = *frame->buffer({BufferId::Shadow, 0}),
                                        ids = *frame->buffer({BufferId::ObjectId});
                        const AnyBuffer place = *frame->buffer({BufferId::Position});
                        int seen = 0, dark = 0;
                        for (std::size_t i = 0; i < S.count(); ++i) {
                            const double along =
                                std::cos(turn) * place.flat(3 * i + 1) - std::sin(turn) * place.flat(3 * i);
                            if (ids.flat(i) != 0 || std::abs(along) > 0.7) continue;
                            ++seen, dark += S.flat(i) < 1;
                        }
                        EXPECT_GT(seen, 5000);
                        EXPECT_EQ(dark, 0) << "turn " << turn << ", filter " << filter << ", size " << size;
                    }
}

// Z' of a plane that recedes by 0.25 a column and 0.5 a row: 3 columns and 2 rows off it is farther by 1.75. Of one that
// comes nearer, of no surface beside it and at the buffer's edge nothing is added.
TEST(ShadowCrease, TheSurfaceThatATexelHoldsIsContinuedToThePoint) {
    Buffer2D<double> depth({8, 8}, 0);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) depth.at({x, y}) = 10 + 0.25 * x + 0.5 * y;
    EXPECT_EQ(heldSlope(depth, false, {4, 4}, {3.0, 2.0}), 1.75);
    EXPECT_EQ(heldSlope(depth, false, {4, 4}, {-3.0, -2.0}), 0);
    EXPECT_EQ(heldSlope(depth, false, {0, 0}, {3.0, 2.0}), 0);
    depth.at({3, 4}) = std::numeric_limits<double>::infinity();
    EXPECT_EQ(heldSlope(depth, false, {4, 4}, {3.0, 2.0}), 1);
    // 1/z is affine in perspective: 1/12, 1/10 beside it and 1/(1/12 - 1/60) = 15 one column on.
    depth.at({5, 5}) = 12, depth.at({4, 5}) = 10, depth.at({5, 4}) = 12;
    EXPECT_NEAR(heldSlope(depth, true, {5, 5}, {1.0, 0.0}), 15 - 12, 1e-13);
}

}  // namespace
}  // namespace pipeline
