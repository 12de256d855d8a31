#include "pipeline/stages/transform.h"

#include <gtest/gtest.h>

#include "pipeline/core/angles.h"
#include "pipeline/plan/scene_remarks.h"
#include "pipeline/scene/settings_table.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

void expectNear(Vec3d a, Vec3d b, double tolerance) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance) << "component " << c;
}

TEST(Angles, AreExactAtRightAngles) {
    for (int turns : {-1000000, -1, 0, 1, 7}) {
        const double whole = 360.0 * turns;
        EXPECT_EQ(sinDegrees(whole), 0);
        EXPECT_EQ(cosDegrees(whole), 1);
        EXPECT_EQ(sinDegrees(whole + 90), 1);
        EXPECT_EQ(cosDegrees(whole + 90), 0);
        EXPECT_EQ(sinDegrees(whole + 180), 0);
        EXPECT_EQ(cosDegrees(whole + 180), -1);
        EXPECT_EQ(sinDegrees(whole - 90), -1);
    }
    EXPECT_NEAR(sinDegrees(30), 0.5, 1e-16);
    EXPECT_NEAR(cosDegrees(1e9), std::cos(std::fmod(1e9, 360.0) * 0.017453292519943295), 1e-14);
}

// Scale, then about x, then y, then z, then the translation: (1,0,0) scaled by 2 stays on x under the turn about
// x; about y by 90 it goes to -z (z towards x is the positive sense, so x goes to -z); about z nothing moves -z.
TEST(Transform, ScalesThenTurnsAboutXYZThenMoves) {
    const ObjectMatrix m = makeObjectMatrix({{2, 3, 4}, {90, 90, 90}, {10, 20, 30}});
    expectNear(toWorld(m, {1, 0, 0}), {10, 20, 28}, 1e-15);
    // (0,1,0): scaled (0,3,0); about x to (0,0,3); about y to (3,0,0); about z to (0,3,0).
    expectNear(toWorld(m, {0, 1, 0}), {10, 23, 30}, 1e-15);
}

// Lecture 1's cube: glRotate(20, 1,0,0), then glRotate(20, 0,1,0), so M = Rx Ry: with s = sin 20°, c = cos 20°
// Ry (1,0,0) = (c,0,-s), and Rx takes that to (c, s·s, -s·c); Ry leaves y, and Rx (0,1,0) = (0, c, s).
// The rotation does not count any more, and the axis' length does not matter.
TEST(Transform, TurnsAreAppliedLikeCallsOfGlRotate) {
    const double s = std::sin(0.3490658503988659), c = std::cos(0.3490658503988659);
    ObjectTransform cube{{2, 2, 2}, {45, 45, 45}, {0, 0, -3}};
    cube.turns = {{20, {1, 0, 0}}, {20, {0, 7, 0}}};
    const ObjectMatrix m = makeObjectMatrix(cube);
    expectNear(toWorld(m, {0.5, 0, 0}), {c, s * s, -s * c - 3}, 1e-15);
    expectNear(toWorld(m, {0, 0.5, 0}), {0, c, s - 3}, 1e-15);
}

TEST(Transform, AMirrorIsKnownByItsSign) {
    EXPECT_FALSE(makeObjectMatrix({{1, 1, 1}, {}, {}}).mirrors);
    EXPECT_TRUE(makeObjectMatrix({{-1, 1, 1}, {}, {}}).mirrors);
    EXPECT_FALSE(makeObjectMatrix({{-1, -1, 1}, {}, {}}).mirrors);
    EXPECT_TRUE(makeObjectMatrix({{-1e-200, -1e-200, -1e-200}, {}, {}}).mirrors);  // the product underflows
}

// Lecture 1's formulas, at places where a look-at matrix has no answer.
TEST(View, TheSphericalCameraHoldsAtThePoles) {
    Scene scene = test::pyramid();
    for (double phi : {0.0, 180.0, 1e-7, 90.0, 60.0}) {
        scene.camera.phi = phi, scene.camera.theta = 30;
        const View view = makeView(scene);
        const double st = 0.5, ct = std::sqrt(0.75), sp = sinDegrees(phi), cp = cosDegrees(phi);
        for (const Vec3d p : {Vec3d(1, 2, 3), Vec3d(-7, 0, 4)}) {
            const Vec3d d = p - view.eye;
            EXPECT_NEAR(glm::dot(view.right, d), -p.x * st + p.y * ct, 1e-12);
            EXPECT_NEAR(glm::dot(view.up, d), -p.x * cp * ct - p.y * cp * st + p.z * sp, 1e-12);
            EXPECT_NEAR(glm::dot(view.forward, d), 1000 - p.x * sp * ct - p.y * sp * st - p.z * cp, 1e-12);
        }
        EXPECT_NEAR(glm::length(glm::cross(view.right, view.up)), 1, 1e-15) << phi;
    }
}

TEST(View, LookingAlongUpFallsBackToAnotherAxis) {
    Scene scene = test::pyramid();
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, 0, 10}, scene.camera.target = {0, 0, 0}, scene.camera.up = {0, 0, 1};
    const View view = makeView(scene);
    EXPECT_NEAR(glm::length(view.right), 1, 1e-15);
    EXPECT_NEAR(glm::dot(view.right, view.forward), 0, 1e-15);
    EXPECT_NEAR(glm::dot(view.up, view.forward), 0, 1e-15);
}

// x right, y up, z away: from the origin along +y with +z up, right is +x.
TEST(View, IsLeftHanded) {
    Scene scene = test::pyramid();
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, 0, 0}, scene.camera.target = {0, 1, 0};
    const View view = makeView(scene);
    EXPECT_EQ(view.right, Vec3d(1, 0, 0));
    EXPECT_EQ(view.up, Vec3d(0, 0, 1));
    EXPECT_EQ(view.forward, Vec3d(0, 1, 0));
}

TEST(View, FindsTheWorldPointOfAPixel) {
    Scene scene = test::pyramid();
    for (ProjectionKind projection : {ProjectionKind::Perspective, ProjectionKind::Orthographic}) {
        scene.camera.projection = projection;
        const FramePtr frame = test::frameOf(scene);
        const View view = makeView(scene);
        const AnyBuffer screen = *frame->buffer({BufferId::VerticesScreen}),
                        z = *frame->buffer({BufferId::VerticesView});
        for (std::size_t i = 0; i < 5; ++i) {
            const Vec3d world = worldPoint(view, {screen.value(0, i, 0), screen.value(0, i, 1)}, z.value(0, i, 2));
            const AnyBuffer expected = *frame->buffer({BufferId::VerticesWorld});
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(world[c], expected.value(0, i, c), 2e-2);
        }
    }
}

TEST(View, NearAndFarHoldEveryVertexInFrontOfTheEye) {
    const View view = makeView(test::pyramid());
    EXPECT_LT(view.near, 620.329);  // z_view of vertices 2 and 0, the nearest and the farthest
    EXPECT_GT(view.near, 600);
    EXPECT_GT(view.far, 877.526);
    EXPECT_LT(view.far, 900);
}

// The pyramid stands 700 to 1000 in front of the eye, wholly beyond a plane that is given.
TEST(View, AChosenPlaneStaysBeyondTheOneThatIsGiven) {
    for (const ProjectionKind projection : {ProjectionKind::Perspective, ProjectionKind::Orthographic}) {
        Scene scene = test::pyramid();
        scene.camera.projection = projection;
        scene.settings.depthFormat = DepthFormat::Float;
        const View whole = makeView(scene);
        for (const auto& [near, far] : {std::pair(2000.0, 0.0), {whole.far, 0.0}, {0.0, 1.0}, {0.0, whole.near}}) {
            scene.camera.near = near, scene.camera.far = far;
            const View view = makeView(scene);
            EXPECT_LT(view.near, view.far);
            EXPECT_TRUE(near == 0 || view.near == near) << near;
            EXPECT_TRUE(far == 0 || view.far == far) << far;
            const FramePtr frame = test::frameOf(scene, setOf({BufferId::VerticesScreen, BufferId::Depth}));
            for (const BufferId id : {BufferId::VerticesScreen, BufferId::Depth})
                EXPECT_EQ(statistics(*frame->buffer({id})).nan, 0u);
        }
    }
}

// glOrtho takes any two planes, glFrustum none behind the eye.
TEST(View, OfAnOrthographicCameraThePlanesMayLieBehindTheEye) {
    Scene scene = test::pyramid();
    scene.camera.projection = ProjectionKind::Orthographic;
    for (const auto& [near, far] :
         {std::pair(-50.0, 2000.0), {-50.0, 0.0}, {-300.0, -200.0}, {-5000.0, -20.0}, {0.0, -20.0}}) {
        scene.camera.near = near, scene.camera.far = far;
        EXPECT_TRUE(checkScene(scene).empty()) << near;
        const View view = makeView(scene);
        EXPECT_LT(view.near, view.far);
        EXPECT_TRUE(near == 0 || view.near == near) << near;
        EXPECT_TRUE(far == 0 || view.far == far) << near << ", " << far;
    }
    scene.camera.near = -20, scene.camera.far = -50;
    EXPECT_FALSE(checkScene(scene).empty());
    scene.camera.far = 0, scene.camera.projection = ProjectionKind::Perspective;
    EXPECT_EQ(format(checkScene(scene)),
              "camera.near is -20, expected a distance above 0 in perspective, or 0 for one that is chosen\n");
}

// 5.3 in float lies 1.9e-7 beyond 5.3: a flat scene leaves no room between its planes but that for rounding.
TEST(View, AFlatSceneIsSeenFromAnyDistance) {
    Scene scene;
    scene.settings.width = scene.settings.height = 8;
    scene.camera.kind = CameraKind::LookAt, scene.camera.projection = ProjectionKind::Orthographic;
    scene.camera.up = {0, 1, 0}, scene.camera.height = 1;
    scene.objects.push_back(
        {"square", test::mesh({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {{0, 1, 2, 3}}), {}, {}});
    for (int tenths = 10; tenths < 160; ++tenths)
        for (const Vec3d shift : {Vec3d(0), Vec3d(3e4, 0, 7e5)}) {
            scene.objects[0].transform.translation = shift;
            scene.camera.eye = shift + Vec3d(0, 0, tenths * 0.1);
            scene.camera.target = shift;
            const AnyBuffer ids = *test::frameOf(scene)->buffer({BufferId::ObjectId});
            for (std::size_t i = 0; i < ids.count(); ++i) ASSERT_EQ(ids.flat(i), 0) << tenths;
        }
}

// Lecture 1: x_v = -x sin(theta) + y cos(theta), y_v = -x cos(phi) cos(theta) - y cos(phi) sin(theta) + z sin(phi). With
// rounded sines, three products and two sums an error of at most 6 half units of |p|.
TEST(View, NoDistanceOfTheEyeIsInXAndY) {
    const std::vector<Vec3d> points{{-0.7, -0.3, 0.11}, {0.9, -0.4, 0.3}, {0.1, 0.8, -0.2}};
    Scene scene = test::pyramid();
    scene.objects[0] = {"triangle", test::mesh(points, {{0, 1, 2}}), {}, {}};
    scene.settings.width = scene.settings.height = 64, scene.settings.cull = CullMode::None;
    scene.camera.theta = 33, scene.camera.phi = 50, scene.camera.screenDistance = 1000;
    const double st = sinDegrees(33), ct = cosDegrees(33), sp = sinDegrees(50), cp = cosDegrees(50);
    for (const double rho : {2.0, 1e3, 1e5, 1e9}) {
        scene.camera.rho = rho, scene.camera.pixelsPerUnit = rho / 50;
        const FramePtr frame = test::frameOf(scene);
        const AnyBuffer view = *frame->buffer({BufferId::VerticesView});
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec3d p = points[i];
            const double limit = 6 * 0x1p-24 * glm::length(p);
            EXPECT_NEAR(view.value(0, i, 0), -p.x * st + p.y * ct, limit) << rho;
            EXPECT_NEAR(view.value(0, i, 1), -p.x * cp * ct - p.y * cp * st + p.z * sp, limit) << rho;
        }
        // 20 pixels a unit, whatever the distance: half of |(p1 - p0) x (p2 - p0)| in view space is 0.5 units².
        const AnyBuffer ids = *frame->buffer({BufferId::ObjectId});
        int drawn = 0;
        for (std::size_t i = 0; i < ids.count(); ++i) drawn += ids.flat(i) == 0;
        EXPECT_GT(drawn, 100) << rho;
    }
}

// How far away an orthographic camera is does not matter, nor which of eye and target is.
TEST(View, AnOrthographicPictureIsTheSameFromAnyDistance) {
    Scene scene;
    scene.settings.width = scene.settings.height = 64;
    scene.camera.kind = CameraKind::LookAt, scene.camera.projection = ProjectionKind::Orthographic;
    scene.camera.height = 3;
    scene.objects.push_back({"box", test::box(Vec3d(-1), Vec3d(1)), {Vec3d(0.8), {10, 20, 30}}, {}});
    const Vec3d eye(6, -6.5, 4.75);
    const auto seenFrom = [&](Vec3d from, Vec3d target) {
        scene.camera.eye = from, scene.camera.target = target;
        return test::frameOf(scene);
    };
    const FramePtr near = seenFrom(eye, Vec3d(0));
    // The viewing direction has the same bits: powers of two, and products without rounding.
    for (const double factor : {0x1p7, 0x1p17, 0x1p24}) {
        const FramePtr far = seenFrom(factor * eye, Vec3d(0)), beyond = seenFrom(eye, (1 - factor) * eye);
        EXPECT_EQ(test::firstDifference(*near, *far, setOf({BufferId::PolygonId})), "") << factor;
        EXPECT_EQ(test::firstDifference(*near, *beyond, setOf({BufferId::PolygonId})), "") << factor;
    }
}

// A square of 2e-6 seen from 4.1e-6 away, with an opening of 50 degrees: 2 / (2 · 4.12 tan 25°) · 64 = 33.3 pixels wide and
// 33.3 cos 14° = 32.3 high, 1076 pixels. Behind it is one a million wide.
Scene smallBeforeLarge() {
    Scene scene;
    scene.settings.width = scene.settings.height = 64;
    scene.camera.kind = CameraKind::LookAt, scene.camera.fovY = 50;
    scene.camera.eye = {0, -1e-6, 4e-6}, scene.camera.target = {0, 0, 0}, scene.camera.up = {0, 1, 0};
    const auto square = [](double half, double z) {
        return test::mesh({{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}}, {{0, 1, 2, 3}});
    };
    scene.objects.push_back({"small", square(1e-6, 0), {}, {}});
    scene.objects.push_back({"large", square(1e6, -1e6), {}, {}});
    return scene;
}
int pixelsOf(const Frame& frame, int object) {
    const AnyBuffer ids = *frame.buffer({BufferId::ObjectId});
    int pixels = 0;
    for (std::size_t i = 0; i < ids.count(); ++i) pixels += ids.flat(i) == object;
    return pixels;
}

TEST(View, TheNearPlaneIsBeforeTheNearestPolygonWhereTheFormatAllows) {
    Scene scene = smallBeforeLarge();
    for (const Precision precision : {Precision::Float, Precision::Double}) {
        scene.settings.precision = precision;
        for (const DepthFormat format : {DepthFormat::Linear, DepthFormat::Reversed, DepthFormat::Infinite}) {
            scene.settings.depthFormat = format;
            const FramePtr frame = test::frameOf(scene);
            EXPECT_NEAR(pixelsOf(*frame, 0), 1076, 40) << int(format);
            EXPECT_GT(pixelsOf(*frame, 1), 2000) << int(format);
            EXPECT_EQ(test::buffersWithoutNumbers(*frame), "");
        }
    }
    // A step of 2^-24 z² / near would be larger than z: these keep their far end.
    scene.settings.depthFormat = DepthFormat::Float;
    EXPECT_EQ(pixelsOf(*test::frameOf(scene), 0), 0);
    EXPECT_GT(pixelsOf(*test::frameOf(scene), 1), 3000);
    const auto remarks = sceneRemarks(scene);
    EXPECT_TRUE(std::ranges::any_of(remarks, [](const Remark& r) {
        return r.about == "camera.near" && r.text.starts_with("1 object is nearer than ");
    }));
    scene.settings.depthFormat = DepthFormat::Linear;
    EXPECT_TRUE(std::ranges::none_of(sceneRemarks(scene), [](const Remark& r) { return r.about == "camera.near"; }));
}

// A ground that reaches behind the eye does not hide what is close before it.
TEST(View, TheNearPlaneIsBeforeTheNearestVertexAlsoWhereSomethingIsBehindTheEye) {
    Scene scene = smallBeforeLarge();
    scene.objects[1].mesh = test::mesh({{-1e3, -1e3, -1e3}, {1e3, -1e3, -1e3}, {0, -1e-3, 1e3}}, {{0, 1, 2}});
    scene.settings.cull = CullMode::None;
    EXPECT_NEAR(pixelsOf(*test::frameOf(scene), 0), 1076, 40);
}

TEST(Transform, AVertexBehindTheEyeHasNoPlaceOnTheScreen) {
    Scene scene = test::pyramid();
    scene.camera.rho = 100;  // among the vertices
    const FramePtr frame = test::frameOf(scene);
    const AnyBuffer view = *frame->buffer({BufferId::VerticesView}),
                    screen = *frame->buffer({BufferId::VerticesScreen});
    int behind = 0;
    for (std::size_t i = 0; i < 5; ++i) {
        if (view.value(0, i, 2) > 0) continue;
        ++behind;
        for (int c = 0; c < 3; ++c) EXPECT_EQ(screen.value(0, i, c), double(-1e30f));
    }
    EXPECT_GT(behind, 0);
    EXPECT_EQ(statistics(screen).withoutValue, std::size_t(behind));
    EXPECT_GT(statistics(screen).min, -1e10);
}

// Vertices at z_view = 1/4 (before the near plane), 4, 16 (beyond the far plane), 0 and -1. With fov 90 and 64 pixels a
// unit at z_view = 1 is 32 pixels long, so x = y = 1/8 is seen at 32 +- 4 / z_view. All are powers of two: no rounding.
TEST(Transform, AVertexThatAPlaneCutsOffIsProjectedLikeAnyOther) {
    Scene scene;
    scene.settings.width = scene.settings.height = 64;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, 0, 0}, scene.camera.target = {0, 0, -1}, scene.camera.up = {0, 1, 0};
    scene.camera.fovY = 90, scene.camera.near = 1, scene.camera.far = 8;
    const double h = 0.125;
    scene.objects.push_back(
        {"fan",
         test::mesh({{h, h, -0.25}, {h, h, -4}, {h, h, -16}, {h, h, 0}, {h, h, 1}}, {{0, 1, 2}, {2, 3, 4}}),
         {},
         {}});
    for (const Precision precision : {Precision::Float, Precision::Double}) {
        scene.settings.precision = precision;
        const AnyBuffer screen = *test::frameOf(scene)->buffer({BufferId::VerticesScreen});
        const double z[] = {0.25, 4, 16};
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(screen.value(0, i, 0), 32 + 4 / z[i]) << i;
            EXPECT_EQ(screen.value(0, i, 1), 32 - 4 / z[i]) << i;
            EXPECT_EQ(screen.value(0, i, 2), z[i]) << i;
        }
        for (std::size_t i = 3; i < 5; ++i)
            for (int c = 0; c < 3; ++c)
                EXPECT_EQ(screen.value(0, i, c), precision == Precision::Float ? double(-1e30f) : -1e30) << i;
        EXPECT_EQ(statistics(screen).withoutValue, 2u);
        EXPECT_EQ(statistics(screen).min, 0.25);
    }
}

// 2^-140 before the eye, 2^-4 beside it: 32 2^136 pixels are more than float holds, 3.4 2^126, and not more than double.
TEST(Transform, AVertexWhosePositionFloatCannotHoldHasNone) {
    Scene scene;
    scene.settings.width = scene.settings.height = 64;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, 0, 0}, scene.camera.target = {0, 0, -1}, scene.camera.up = {0, 1, 0};
    scene.camera.fovY = 90, scene.camera.near = 1, scene.camera.far = 8;
    scene.objects.push_back(
        {"triangle", test::mesh({{0.0625, 0, -0x1p-140}, {1, 1, -4}, {-1, 1, -4}}, {{0, 1, 2}}), {}, {}});
    const auto without = [&](Precision precision) {
        scene.settings.precision = precision;
        const BufferStatistics found = statistics(*test::frameOf(scene)->buffer({BufferId::VerticesScreen}));
        EXPECT_EQ(found.infinite, 0u);
        return found.withoutValue;
    };
    EXPECT_EQ(without(Precision::Float), 1u);
    EXPECT_EQ(without(Precision::Double), 0u);
}

}  // namespace
}  // namespace pipeline
