// The ray caster where closed forms say what is seen, how far away, and how much light gets there.
#include "pipeline/study/ray_caster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/scenes.h"

namespace pipeline {
namespace {

// Seen along -z from (0, 0, 20), orthographic, `side` world units on 100 x 100 pixels, y up.
Scene fromAbove(double side) {
    Scene scene;
    scene.settings.width = scene.settings.height = 100;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.projection = ProjectionKind::Orthographic;
    scene.camera.eye = {0, 0, 20}, scene.camera.target = {0, 0, 0}, scene.camera.up = {0, 1, 0};
    scene.camera.height = side;
    scene.lights.push_back({LightKind::AtInfinity, {0, 0, 1}, 1, Vec3d(1), true});
    return scene;
}

Object shape(ShapeKind kind, ObjectTransform transform = {}, int tessellation = 4) {
    return {name(kind).data(), makeShape({kind, tessellation}), transform, {}, {}, Shape{kind, tessellation}};
}

Picture exactPicture(const Scene& scene) {
    EXPECT_EQ(whyNoRays(scene, RaySurfaces::Exact), "");
    return rayCast(scene, RaySurfaces::Exact, 0)->picture;
}

// From (0, -5, 0) along +y with a vertical field of view of 30 degrees, 2 tan 15° / 100 view units a pixel. A direction
// (x, 1, z) meets the unit sphere where |(0, -5, 0) + t (x, 1, z)| = 1: with q = 1 + x² + z², q t² - 10 t + 24 = 0, so
// where 25 >= 24 q, at t = (5 - sqrt(25 - 24 q)) / q. t is z_view; the normal is the point itself.
TEST(RayCaster, ASphereHasItsSilhouetteDepthAndNormal) {
    Scene scene = fromAbove(1);
    scene.camera.projection = ProjectionKind::Perspective;
    scene.camera.eye = {0, -5, 0}, scene.camera.up = {0, 0, 1}, scene.camera.fovY = 30;
    scene.objects = {shape(ShapeKind::Sphere)};
    const Picture picture = exactPicture(scene);
    const double pixel = 2 * std::tan(std::acos(-1.0) / 12) / 100;
    int seen = 0;
    for (int j = 0; j < 100; ++j)
        for (int i = 0; i < 100; ++i) {
            const double x = (i + 0.5 - 50) * pixel, z = (50 - j - 0.5) * pixel, q = 1 + x * x + z * z;
            const double discriminant = 25 - 24 * q;
            ASSERT_EQ(picture.object.at({i, j}), discriminant >= 0 ? 0 : -1) << i << ", " << j;
            if (discriminant < 0) continue;
            ++seen;
            const double t = (5 - std::sqrt(discriminant)) / q;
            const Vec3d p = t * Vec3d(x, 1, z) - Vec3d(0, 5, 0);
            ASSERT_NEAR(picture.zView.at({i, j}), t, 1e-13);
            ASSERT_LT(glm::length(picture.normal.at({i, j}) - p), 1e-13);
        }
    EXPECT_GT(seen, 4000);
}

// Scaled by (3, -2, 1) the unit sphere is x²/9 + y²/4 + z² = 1, its normal along (x/9, y/4, z), whatever is mirrored;
// then turned by 90 degrees about z, so that it is x²/4 + y²/9 + z² = 1. From above it is 4 x 6 units.
TEST(RayCaster, AnEllipsoidsNormalsGoWithTheInverseTranspose) {
    Scene scene = fromAbove(8);
    scene.objects = {shape(ShapeKind::Sphere, {{3, -2, 1}, {0, 0, 90}, {0, 0, 0}})};
    const Picture picture = exactPicture(scene);
    for (int j = 0; j < 100; ++j)
        for (int i = 0; i < 100; ++i) {
            const double x = (i + 0.5 - 50) * 0.08, y = (50 - j - 0.5) * 0.08, square = 1 - x * x / 4 - y * y / 9;
            ASSERT_EQ(picture.object.at({i, j}), square >= 0 ? 0 : -1) << i << ", " << j;
            if (square < 0) continue;
            const double z = std::sqrt(square);
            ASSERT_NEAR(picture.zView.at({i, j}), 20 - z, 1e-12);
            const Vec3d n = glm::normalize(Vec3d(x / 4, y / 9, z));
            ASSERT_LT(glm::length(picture.normal.at({i, j}) - n), 1e-11);
        }
}

// The ring around the z axis, R = 1 and r = 0.4: from above between the circles of radius 0.6 and 1.4, its height
// sqrt(0.16 - (sqrt(x² + y²) - 1)²).
TEST(RayCaster, ATorusIsSeenAsItsFormulaSays) {
    Scene scene = fromAbove(3);
    scene.objects = {shape(ShapeKind::Torus)};
    const Picture picture = exactPicture(scene);
    for (int j = 0; j < 100; ++j)
        for (int i = 0; i < 100; ++i) {
            const double x = (i + 0.5 - 50) * 0.03, y = (50 - j - 0.5) * 0.03, out = std::hypot(x, y) - 1;
            ASSERT_EQ(picture.object.at({i, j}), std::abs(out) <= 0.4 ? 0 : -1) << i << ", " << j;
            if (std::abs(out) > 0.4) continue;
            const double z = std::sqrt(0.16 - out * out);
            // z = sqrt(0.16 - out²) doubles the digits lost where it is small.
            ASSERT_NEAR(picture.zView.at({i, j}), 20 - z, 1e-14 / z + 1e-13);
            ASSERT_LT(glm::length(picture.normal.at({i, j}) - Vec3d(out * x / (1 + out), out * y / (1 + out), z) / 0.4),
                      1e-13 / z);
        }
}

// The cylinder's top is the disk of radius 1 at z = 1, the box's the square at z = 1/2; sideways the plane hides nothing.
TEST(RayCaster, CylinderBoxAndPlane) {
    const std::pair<ShapeKind, double> tops[]{{ShapeKind::Cylinder, 1}, {ShapeKind::Box, 0.5}, {ShapeKind::Plane, 0}};
    for (const auto& [kind, height] : tops) {
        Scene scene = fromAbove(3);
        scene.objects = {shape(kind)};
        const Picture picture = exactPicture(scene);
        for (int j = 0; j < 100; ++j)
            for (int i = 0; i < 100; ++i) {
                const double x = (i + 0.5 - 50) * 0.03, y = (50 - j - 0.5) * 0.03;
                const bool isOn =
                    kind == ShapeKind::Cylinder ? x * x + y * y <= 1 : std::abs(x) <= 0.5 && std::abs(y) <= 0.5;
                ASSERT_EQ(picture.object.at({i, j}), isOn ? 0 : -1) << name(kind) << " " << i << ", " << j;
                if (!isOn) continue;
                ASSERT_NEAR(picture.zView.at({i, j}), 20 - height, 1e-14 * 20);
                ASSERT_EQ(picture.normal.at({i, j}), Vec3d(0, 0, 1));
            }
    }
    // From below the plane shows its back: there for culling to drop.
    Scene below = fromAbove(3);
    below.camera.eye = {0, 0, -20};
    below.objects = {shape(ShapeKind::Plane)};
    EXPECT_EQ(std::ranges::count(exactPicture(below).object.pixels, 0), 0);
    below.settings.cull = CullMode::None;
    EXPECT_GT(std::ranges::count(exactPicture(below).object.pixels, 0), 1000);
}

// A sphere of radius r at height c over the plane z = 0, the light at infinity θ from the vertical: what it throws on the
// plane is an ellipse around (-c tan θ, 0) with semi-axes r / cos θ along the light's way and r across it.
TEST(RayCaster, ASpheresShadowOnAPlaneIsAnEllipse) {
    const double r = 0.75, c = 3, theta = 50 * std::acos(-1.0) / 180;
    Scene scene = fromAbove(12);
    scene.lights[0].position = {std::sin(theta), 0, std::cos(theta)};
    scene.objects = {shape(ShapeKind::Plane, {Vec3d(12), {}, {}}), shape(ShapeKind::Sphere, {Vec3d(r), {}, {0, 0, c}})};
    const Picture picture = exactPicture(scene);
    int dark = 0;
    for (int j = 0; j < 100; ++j)
        for (int i = 0; i < 100; ++i) {
            if (picture.object.at({i, j}) != 0) continue;
            const double x = (i + 0.5 - 50) * 0.12, y = (50 - j - 0.5) * 0.12;
            const double a = (x + c * std::tan(theta)) * std::cos(theta) / r, b = y / r;
            ASSERT_EQ(picture.shadow[0].at({i, j}), a * a + b * b <= 1 ? 0 : 1) << x << ", " << y;
            dark += picture.shadow[0].at({i, j}) == 0;
        }
    // π r² / cos θ = 2.749 square units of 0.0144.
    EXPECT_NEAR(dark, 2.749 / 0.0144, 10);
}

// What a lamp hangs on is not before it: in a room without walls all of the floor is lit.
TEST(RayCaster, ACeilingDoesNotShadowTheLampOnIt) {
    for (const LightKind kind : {LightKind::Point, LightKind::Area}) {
        Scene scene = fromAbove(12);
        scene.camera.eye = {0, 0, 5};
        scene.lights[0].kind = kind, scene.lights[0].position = {0.1, 0.2, 6};
        scene.objects = {shape(ShapeKind::Plane, {Vec3d(12), {}, {}}),
                         shape(ShapeKind::Plane, {Vec3d(12), {180, 0, 0}, {0, 0, 6}})};
        const Picture picture = exactPicture(scene);
        for (int j = 0; j < 100; ++j)
            for (int i = 0; i < 100; ++i) {
                ASSERT_EQ(picture.object.at({i, j}), 0);
                ASSERT_EQ(picture.shadow[0].at({i, j}), 1) << int(kind) << ": " << i << ", " << j;
            }
    }
}

// Lit along -x, the inner side of the ring that faces the light, at x < 0, lies behind the tube at x > 0: there every
// |y| < 1 is in the way, and on the inner side no other is. What is lit is the outer side at x > 0.
TEST(RayCaster, ATorusShadowsItself) {
    Scene scene = fromAbove(3);
    scene.lights[0].position = {1, 0, 0};
    scene.objects = {shape(ShapeKind::Torus)};
    const Picture picture = exactPicture(scene);
    int facingInDark = 0, lit = 0;
    for (std::size_t i = 0; i < picture.object.pixels.size(); ++i) {
        if (picture.object.pixels[i] != 0) continue;
        const Vec3d p = picture.position.pixels[i];
        const bool faces = picture.normal.pixels[i].x > 0, isInner = std::hypot(p.x, p.y) < 1;
        ASSERT_EQ(picture.shadow[0].pixels[i], faces && !isInner ? 1 : 0) << p.x << ", " << p.y << ", " << p.z;
        facingInDark += faces && isInner;
        lit += faces && !isInner;
    }
    // Half of the rings from 0.6 to 1 and from 1 to 1.4: 0.32 π and 0.48 π square units of 0.0009.
    EXPECT_NEAR(facingInDark, 1117, 30);
    EXPECT_NEAR(lit, 1676, 30);
}

// A half plane x < 0 at height d = 1 over a floor, under a light of width w = 2 at height H = 4: at the floor's x the
// share 1/2 + x (H / d - 1) / w of it is seen, so the penumbra is w d / (H - d) = 2/3 wide.
TEST(RayCaster, APenumbraIsARampOfItsWidth) {
    for (const double across : {0.0, 1.0}) {
        Scene scene = fromAbove(2);
        scene.settings.cull = CullMode::None;
        scene.camera.eye = {0, 0, -20};  // from below, so that the blocker hides nothing
        scene.objects = {shape(ShapeKind::Plane, {Vec3d(16), {}, {}}),
                         shape(ShapeKind::Plane, {Vec3d(16), {}, {-8, 0, 1}})};
        scene.lights[0] = {LightKind::Area, {0, 0, 4}, 1, Vec3d(1), true};
        scene.lights[0].area = {{0, 0, -1}, 2, across, 4};
        const Picture picture = exactPicture(scene);
        int penumbra = 0;
        for (std::size_t i = 0; i < picture.shadow[0].pixels.size(); ++i) {
            const double x = picture.position.pixels[i].x, seen = picture.shadow[0].pixels[i];
            ASSERT_NEAR(seen, std::clamp(0.5 + 1.5 * x, 0.0, 1.0), 1e-6) << x;
            penumbra += seen > 0 && seen < 1;
        }
        EXPECT_NEAR(penumbra, 10000 / 3, 100);
    }
}

// Lecture 1's pyramid: its polygons' own picture differs from the frame's at most where a pixel's centre lies so near an
// edge that snapping, by up to 1/512 pixel in x and in y at both of its ends, can move it across.
TEST(RayCaster, SeesThePyramidAsTheFrameDoes) {
    Scene scene = test::pyramid();
    scene.settings.precision = Precision::Double;
    const Picture picture = rayCast(scene, RaySurfaces::Polygons, 0)->picture;
    const FramePtr frame = test::frameOf(scene);
    const AnyBuffer ids = *frame->buffer({BufferId::ObjectId}), intensity = *frame->buffer({BufferId::Intensity});
    const AnyBuffer screen = *frame->buffer({BufferId::VerticesScreen}), z = *frame->buffer({BufferId::ZView});
    const Mesh& mesh = *scene.objects[0].mesh;
    const auto isNearEdge = [&](double x, double y) {
        for (std::size_t p = 0; p < mesh.polygonCount(); ++p) {
            const auto corners = mesh.polygon(p);
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const std::size_t a = corners[i], b = corners[(i + 1) % corners.size()];
                const double ax = screen.value(0, a, 0), ay = screen.value(0, a, 1);
                const double dx = screen.value(0, b, 0) - ax, dy = screen.value(0, b, 1) - ay;
                const double t = std::clamp(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
                if (std::hypot(x - ax - t * dx, y - ay - t * dy) < std::sqrt(2.0) / 512) return true;
            }
        }
        return false;
    };
    int seen = 0;
    for (std::size_t i = 0; i < ids.count(); ++i) {
        if (isNearEdge(double(i % 640) + 0.5, double(i / 640) + 0.5)) continue;
        ASSERT_EQ(ids.flat(i), picture.object.pixels[i]) << i % 640 << ", " << i / 640;
        if (ids.flat(i) < 0) continue;
        ++seen;
        for (std::size_t c = 0; c < 3; ++c)
            ASSERT_NEAR(intensity.flat(3 * i + c), picture.intensity.pixels[i][int(c)], 1e-12 * 120);
        // Depth by the snapped vertices' weights: the steepest face changes by about 5 units a pixel.
        ASSERT_NEAR(z.flat(i), picture.zView.pixels[i], 0.05);
    }
    EXPECT_GT(seen, 2000);
}

// Every shape, turned and stretched: its polygons come as close to it as they are fine.
TEST(RayCaster, FinePolygonsComeCloseToTheTrueSurface) {
    for (const ShapeKind kind :
         {ShapeKind::Plane, ShapeKind::Box, ShapeKind::Sphere, ShapeKind::Cylinder, ShapeKind::Torus}) {
        Scene scene = fromAbove(5);
        scene.settings.cull = CullMode::None;  // the mirrored plane shows its back
        scene.camera.eye = {3, -14, 12};
        scene.settings.shading = Shading::Phong;
        scene.settings.normalWeight = NormalWeight::Given;
        scene.lights[0].position = {1, -2, 3};
        scene.objects = {shape(kind, {{1.5, 1, -0.8}, {20, 30, 40}, {0.1, 0.2, 0.3}}, 64)};
        scene.objects[0].material.specular = Vec3d(0.5);
        const Picture exact = exactPicture(scene), polygons = rayCast(scene, RaySurfaces::Polygons, 0)->picture;
        int different = 0, seen = 0, dark = 0;
        for (std::size_t i = 0; i < exact.object.pixels.size(); ++i) {
            different += exact.object.pixels[i] != polygons.object.pixels[i];
            if (exact.object.pixels[i] < 0 || polygons.object.pixels[i] < 0) continue;
            ++seen;
            dark += exact.shadow[0].pixels[i] != polygons.shadow[0].pixels[i];
            // Sagitta of a piece of a quarter circle in 64, radius at most 1.5: 1.5 (1 - cos(π / 256)) = 1.1e-4, seen
            // at a slope of up to 60 or so towards the silhouette.
            ASSERT_NEAR(exact.zView.pixels[i], polygons.zView.pixels[i], 0.01) << name(kind);
            if (exact.shadow[0].pixels[i] == polygons.shadow[0].pixels[i]) {
                ASSERT_LT(glm::length(exact.intensity.pixels[i] - polygons.intensity.pixels[i]), 0.02) << name(kind);
            }
        }
        EXPECT_GT(seen, 300) << name(kind);
        EXPECT_LE(different, 6) << name(kind);
        EXPECT_LE(dark, seen / 50) << name(kind);
    }
}

TEST(RayCaster, SaysHowFarItMayBeWrongItself) {
    Scene scene = test::pyramid();
    const Reference reference = *rayCast(scene, RaySurfaces::Exact, 0);
    // Of each measure its own: no mean is above the largest.
    const auto barOf = [&](const char* buffer, std::string_view measure) {
        for (const ErrorRow& row : reference.errorBars)
            if (row.buffer == buffer && row.measure == measure) return *row.value[index(ErrorKind::Model)];
        ADD_FAILURE() << buffer << measure;
        return 0.0;
    };
    EXPECT_GT(barOf("intensity", "RMSE"), 0);
    EXPECT_LT(barOf("intensity", "RMSE"), barOf("intensity", "largest"));
    EXPECT_LT(barOf("intensity", "largest"), 1e-13);
    EXPECT_LT(barOf("normal", "largest angle"), 1e-12);
    EXPECT_EQ(barOf("shadow.0", "misclassified"), 0);
    EXPECT_EQ(reference.errorWhy.substr(0, 41), "against the same rays in long double, at ");
}

TEST(RayCaster, StopsWhenAsked) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(rayCast(test::pyramid(), RaySurfaces::Exact, 0, stop.get_token()));
}

TEST(RayCaster, SaysWhyThereIsNoReference) {
    Scene scene = test::pyramid();
    EXPECT_EQ(whyNoRays(scene, RaySurfaces::Exact), "");
    scene.settings.visibility = Visibility::Painter;
    EXPECT_NE(whyNoRays(scene, RaySurfaces::Exact), "");
    scene = test::pyramid();
    scene.objects[0].material.alpha = 0.5;
    EXPECT_NE(whyNoRays(scene, RaySurfaces::Polygons), "");
    scene = test::pyramid();
    scene.objects = {shape(ShapeKind::Teapot, {}, 2)};
    EXPECT_NE(whyNoRays(scene, RaySurfaces::Exact), "");
    EXPECT_EQ(whyNoRays(scene, RaySurfaces::Polygons), "");
    scene.objects = {shape(ShapeKind::Sphere, {{1, 1, 0}, {}, {}})};
    EXPECT_NE(whyNoRays(scene, RaySurfaces::Exact), "");
    // A triangle whose normals lean: part of something round that the file does not tell of.
    Mesh leaning = *test::mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    leaning.normals = {{0, 0, 1}, {0.5, 0, 1}, {0, 0, 1}};
    scene.objects = {{"leaning", makeMesh(leaning), {}, {}}};
    EXPECT_NE(whyNoRays(scene, RaySurfaces::Exact), "");
}

}  // namespace
}  // namespace pipeline
