#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/drawing3d/arrow_shape.h"

namespace {

using app::Solid;
using app::Vec3d;
using app::VectorCode;

constexpr VectorCode kCodes[]{VectorCode::N, VectorCode::L, VectorCode::V, VectorCode::R, VectorCode::H};

// Six times the volume that a closed solid's triangles enclose; positive when they face outwards.
double sixVolumes(const Solid& solid) {
    double sum = 0;
    for (const glm::uvec3& t : solid.triangles)
        sum += glm::dot(solid.positions[t.x], glm::cross(solid.positions[t.y], solid.positions[t.z]));
    return sum;
}

double lowest(const Solid& solid) { return std::ranges::min_element(solid.positions, {}, &Vec3d::z)->z; }
double highest(const Solid& solid) { return std::ranges::max_element(solid.positions, {}, &Vec3d::z)->z; }

}  // namespace

TEST(View3dArrow, ReachesFromItsFootToItsLength) {
    for (const VectorCode code : kCodes) {
        const Solid solid = app::arrow(code, 120, 2, {});
        EXPECT_NEAR(lowest(solid), 0, 1e-9);
        EXPECT_NEAR(highest(solid), 120, 0.35);  // a ring and bars are drawn with flat sides
    }
}

TEST(View3dArrow, StandsWhereItIsPlacedAtItsScale) {
    const Vec3d along = glm::normalize(Vec3d(1, 2, -2));  // (1/3, 2/3, −2/3)
    const Solid solid = app::arrow(VectorCode::N, 60, 2, {{10, 20, 30}, along, {0, 0, 1}, 0.5});
    // The end: 60 pixels of half a unit along (1/3, 2/3, −2/3) from (10, 20, 30).
    const Vec3d end{20, 40, 10};
    double nearest = 1e9;
    for (const Vec3d& p : solid.positions) nearest = std::min(nearest, glm::length(p - end));
    EXPECT_NEAR(nearest, 0, 1e-9);
}

TEST(View3dArrow, FacesLookOutwards) {
    for (const VectorCode code : kCodes) EXPECT_GT(sixVolumes(app::arrow(code, 120, 2, {})), 0);
    EXPECT_GT(sixVolumes(app::ball({5, 6, 7}, 2)), 0);
    EXPECT_GT(sixVolumes(app::ring(6, 1)), 0);
    EXPECT_GT(sixVolumes(app::tube({1, 1, 1}, {4, 5, 6}, 1)), 0);
}

// A pen 4 wide: the pattern 4 1.7 is 16 on, 6.8 off; the last dash ends with the line.
TEST(View3dArrow, DashesAreTheDesignsInWidthsOfThePen) {
    const auto light = app::dashes(VectorCode::L, 50, 4);
    ASSERT_EQ(light.size(), 3u);
    EXPECT_NEAR(light[0].end, 16, 1e-12);
    EXPECT_NEAR(light[1].begin, 22.8, 1e-12);
    EXPECT_NEAR(light[1].end, 38.8, 1e-12);
    EXPECT_NEAR(light[2].end, 50, 1e-12);
    EXPECT_EQ(app::dashes(VectorCode::N, 50, 4).size(), 1u);
    // 4 1.25 1 1.25: a dash, a dot.
    const auto eye = app::dashes(VectorCode::V, 100, 1);
    EXPECT_NEAR(eye[0].end - eye[0].begin, 4, 1e-12);
    EXPECT_NEAR(eye[1].end - eye[1].begin, 1, 1e-12);
    EXPECT_NEAR(eye[2].begin, 7.5, 1e-12);
}

TEST(View3dArrow, AShortArrowIsItsTipAlone) {
    for (const VectorCode code : kCodes) {
        const Solid solid = app::arrow(code, 4, 2, {});
        EXPECT_LE(highest(solid), 4.2);
        EXPECT_GE(lowest(solid), -0.6);
        EXPECT_FALSE(solid.triangles.empty());
    }
}

// V's ring shows its hole whatever way the arrow points: all of it lies across the line of sight.
TEST(View3dArrow, TheRingFacesTheEye) {
    const Vec3d eye = glm::normalize(Vec3d(1, 1, 0.2));
    for (const Vec3d& along : {Vec3d(0, 0, 1), Vec3d(1, 0, 0), eye}) {
        const Solid solid = app::arrow(VectorCode::V, 100, 2, {{0, 0, 0}, along, eye, 1});
        // The tube of the ring has radius 1.4, its middle line 5.1; the shaft ends before it.
        const Vec3d middle = (100 - 6.5) * along;
        int inRing = 0;
        for (const Vec3d& p : solid.positions)
            if (glm::length(p - middle) < 6.5 + 1e-9 && glm::length(p - middle) > 3.6) {
                if (std::abs(glm::dot(p - middle, eye)) <= 1.4 + 1e-9) ++inRing;
            }
        EXPECT_GE(inRing, 28 * 10);
    }
}

TEST(View3dArrow, InflatedSurroundsTheSolid) {
    const Solid solid = app::ball({0, 0, 0}, 5, 20), larger = app::inflated(solid, 1);
    for (std::size_t i = 0; i < solid.positions.size(); ++i)
        EXPECT_GT(glm::length(larger.positions[i]), glm::length(solid.positions[i]) + 0.8);
}
