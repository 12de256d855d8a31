#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "app/drawing3d/orbit_camera.h"
#include "tests/support/scenes.h"

namespace {

using app::OrbitCamera;
using app::Vec3d;

constexpr glm::dvec2 kSize{800, 600};

OrbitCamera slanted(bool orthographic) {
    OrbitCamera camera;
    camera.target = {10, -20, 5};
    camera.distance = 300;
    camera.orthographic = orthographic;
    app::lookAlong(camera, {-0.6, 0.5, -0.3});
    return camera;
}

std::array<Vec3d, 8> boxCorners() {
    std::array<Vec3d, 8> points;
    for (unsigned i = 0; i < 8; ++i) points[i] = {i & 1 ? 470 : 200, i & 2 ? 150 : 0, i & 4 ? 150 : 0};
    return points;
}

class EitherProjection : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(View3dCamera, EitherProjection, testing::Bool(),
                         [](const auto& kind) { return kind.param ? "orthographic" : "perspective"; });

}  // namespace

TEST_P(EitherProjection, ARayGoesThroughThePointThatItsPixelShows) {
    const OrbitCamera camera = slanted(GetParam());
    const Vec3d point{40, 15, -30};
    const app::Projected shown = app::project(camera, kSize, point);
    const app::Ray ray = app::rayThrough(camera, kSize, shown.at);
    const Vec3d away = glm::cross(point - ray.origin, ray.direction);
    EXPECT_NEAR(glm::length(away), 0, 1e-9);
}

TEST_P(EitherProjection, TheTargetIsInTheMiddleAndUpIsUp) {
    const OrbitCamera camera = slanted(GetParam());
    const auto middle = app::project(camera, kSize, camera.target);
    EXPECT_NEAR(middle.at.x, 400, 1e-9);
    EXPECT_NEAR(middle.at.y, 300, 1e-9);
    EXPECT_LT(app::project(camera, kSize, camera.target + Vec3d(0, 0, 10)).at.y, 300) << "+z points up the screen";
    EXPECT_NEAR(app::project(camera, kSize, camera.target + camera.unitsPerPixel(kSize.y) * camera.right).at.x, 401,
                1e-9);
}

// Every corner of the framed box lies inside the free margin, and at least one touches it.
TEST_P(EitherProjection, AFramedBoxFillsTheViewUpToItsMargin) {
    for (const glm::dvec2 size : {glm::dvec2(800, 600), glm::dvec2(300, 700)}) {
        OrbitCamera camera = slanted(GetParam());
        const auto corners = boxCorners();
        app::frame(camera, corners, size, 0.1);
        const double margin = 0.1 * std::min(size.x, size.y);
        double smallest = 1e9;
        for (const Vec3d& corner : corners) {
            const auto p = app::project(camera, size, corner);
            ASSERT_TRUE(p.inFront);
            smallest = std::min({smallest, p.at.x, p.at.y, size.x - p.at.x, size.y - p.at.y});
        }
        EXPECT_NEAR(smallest, margin, 1e-6);
    }
}

// Of 600 rows 180 are taken at the foot: the box ends there, and no later than 60 below the top.
TEST_P(EitherProjection, AFramedBoxStandsAboveWhatLiesAtTheFoot) {
    OrbitCamera camera = slanted(GetParam());
    const auto corners = boxCorners();
    app::frame(camera, corners, kSize, 0.1, 180);
    double top = 1e9, bottom = 0, side = 1e9;
    for (const Vec3d& corner : corners) {
        const auto p = app::project(camera, kSize, corner);
        top = std::min(top, p.at.y), bottom = std::max(bottom, p.at.y);
        side = std::min({side, p.at.x, kSize.x - p.at.x});
    }
    EXPECT_LE(bottom, 420 + 1e-6);
    EXPECT_GE(top, 60 - 1e-6);
    EXPECT_GE(side, 60 - 1e-6);
    EXPECT_TRUE(std::abs(side - 60) < 1e-6 || (std::abs(top - 60) < 1e-6 && std::abs(bottom - 420) < 1e-6))
        << "no smaller than it must be";

    OrbitCamera other = slanted(GetParam());
    app::frame(other, corners, kSize, 0.1);
    camera = slanted(GetParam());
    app::frame(camera, corners, kSize, 0.1, 60);
    EXPECT_EQ(camera, other) << "the margin is free already";
}

TEST(View3dCamera, ASinglePointIsFramedWithoutDividingByItsSize) {
    OrbitCamera camera;
    const Vec3d point{1e6, -2e6, 3e6};
    app::frame(camera, std::span(&point, 1), kSize);
    EXPECT_GT(camera.distance, 0);
    EXPECT_TRUE(std::isfinite(camera.distance));
    EXPECT_NEAR(app::project(camera, kSize, point).at.x, 400, 1e-3);
}

TEST_P(EitherProjection, ZoomKeepsWhatIsUnderTheCursor) {
    OrbitCamera camera = slanted(GetParam());
    const glm::dvec2 cursor{650, 120};
    const glm::dvec2 fromMiddle = cursor - kSize / 2.0;
    const Vec3d under =
        camera.target + camera.unitsPerPixel(kSize.y) * (fromMiddle.x * camera.right - fromMiddle.y * camera.up);
    const double before = camera.distance;
    app::zoomAt(camera, 0.5, cursor, kSize);
    EXPECT_NEAR(camera.distance, before / 2, 1e-9);
    EXPECT_NEAR(app::project(camera, kSize, under).at.x, cursor.x, 1e-9);
    EXPECT_NEAR(app::project(camera, kSize, under).at.y, cursor.y, 1e-9);
}

TEST_P(EitherProjection, PanMovesThePictureWithTheHand) {
    OrbitCamera camera = slanted(GetParam());
    const Vec3d point = camera.target;
    app::pan(camera, {30, -12}, kSize);
    EXPECT_NEAR(app::project(camera, kSize, point).at.x, 430, 1e-9);
    EXPECT_NEAR(app::project(camera, kSize, point).at.y, 288, 1e-9);
}

TEST(View3dCamera, OrbitKeepsTheTargetAndStopsAtTheTop) {
    OrbitCamera camera = slanted(false);
    for (int i = 0; i < 1000; ++i) app::orbit(camera, 7.3, 0.9);
    EXPECT_NEAR(app::project(camera, kSize, slanted(false).target).at.x, 400, 1e-6);
    EXPECT_NEAR(camera.forward.z, -1, 1e-9) << "looks straight down";
    EXPECT_NEAR(glm::length(camera.right), 1, 1e-12);
    EXPECT_NEAR(glm::dot(camera.right, camera.up), 0, 1e-12);
    app::orbit(camera, 0, -30);
    EXPECT_NEAR(camera.forward.z, -std::sin(glm::radians(60.0)), 1e-6) << "comes down again";
    EXPECT_GT(camera.up.z, 0);
}

TEST(View3dCamera, StraightDownHasNorthUp) {
    OrbitCamera camera;
    app::lookAlong(camera, {0, 0, -1});
    EXPECT_NEAR(camera.up.y, 1, 1e-12);
    EXPECT_NEAR(camera.right.x, 1, 1e-12);
}

// Lecture 1's formulas for its pyramid's apex (335, 75, 150), θ = 45°, φ = 60°, ρ = 1000, d = 200:
//   x_v = (−335 + 75) sin 45° = −183.8478;  y_v = −(335 + 75) cos 60° cos 45° + 150 sin 60° = −15.0531
//   z_v = 1000 − (335 + 75) sin 60° cos 45° − 150 cos 60° = 673.9273
//   x_s = 320 + 200 x_v / z_v = 265.4399;  y_s = 240 − 200 y_v / z_v = 244.4673
TEST(View3dCamera, FromTheEyeThePictureIsThePipelines) {
    const pipeline::View view = pipeline::makeView(test::pyramid());
    const OrbitCamera camera = app::fromEye(view, {335, 75, 75}, {640, 480});
    const auto apex = app::project(camera, {640, 480}, {335, 75, 150});
    EXPECT_NEAR(apex.at.x, 265.4400, 1e-3);
    EXPECT_NEAR(apex.at.y, 244.4672, 1e-3);
    // A wider window shows the same picture, smaller, in its middle: 400 / 640 of the size.
    const auto narrow = app::project(app::fromEye(view, {335, 75, 75}, {400, 480}), {400, 480}, {335, 75, 150});
    EXPECT_NEAR(narrow.at.x, 200 + (265.4400 - 320) * 0.625, 1e-3);
    EXPECT_NEAR(narrow.at.y, 240 + (244.4672 - 240) * 0.625, 1e-3);
}

TEST(View3dCamera, AFlightStartsAndEndsExactly) {
    const OrbitCamera a = slanted(false);
    OrbitCamera b = slanted(false);
    app::lookAlong(b, {0, 0, -1});
    b.distance = 30;
    EXPECT_EQ(app::between(a, b, 1), b);
    const OrbitCamera start = app::between(a, b, 0), half = app::between(a, b, 0.5);
    EXPECT_NEAR(glm::length(start.forward - a.forward), 0, 1e-12);
    EXPECT_NEAR(start.distance, 300, 1e-9);
    EXPECT_NEAR(half.distance, std::sqrt(300.0 * 30), 1e-9);
    EXPECT_NEAR(glm::dot(half.right, half.up), 0, 1e-12);
    EXPECT_NEAR(glm::length(glm::cross(half.right, half.up) + half.forward), 0, 1e-12);
}

// As far from each other as the coordinates that they come from are rounded.
TEST(View3dCamera, AtTheCameraItselfNothingIsInFrontAndEveryPlaceIsFinite) {
    for (const double away : {0.0, 1e3, 1e9}) {
        OrbitCamera camera = slanted(false);
        camera.target.x += away;
        const Vec3d position = camera.position();
        for (const Vec3d point : {position, position * (1 + 0x1p-52), position * (1 - 0x1p-52)}) {
            const app::Projected shown = app::project(camera, kSize, point);
            EXPECT_FALSE(shown.inFront) << away;
            EXPECT_TRUE(std::isfinite(shown.at.x) && std::isfinite(shown.at.y)) << away;
        }
        EXPECT_TRUE(app::project(camera, kSize, position + 1e-3 * camera.distance * camera.forward).inFront);
    }
}
