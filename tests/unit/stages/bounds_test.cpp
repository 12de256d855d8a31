// Bounding boxes and spheres.
#include "pipeline/inspect/bounds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace pipeline {
namespace {

std::vector<Vec3d> cloud(std::mt19937& random, std::size_t count, Vec3d centre, Vec3d size) {
    std::uniform_real_distribution<double> side(-1, 1);
    std::vector<Vec3d> points;
    for (std::size_t i = 0; i < count; ++i)
        points.push_back(centre + size * Vec3d{side(random), side(random), side(random)});
    return points;
}

TEST(BoundingBox, TouchesThePointsOnEverySide) {
    // Lecture 1's pyramid in world space: x from 200 to 470, y from 0 to 150, z from 0 to 150.
    const std::vector<Vec3d> pyramid{{200, 0, 0}, {470, 0, 0}, {470, 150, 0}, {200, 150, 0}, {335, 75, 150}};
    EXPECT_EQ(boundingBox(pyramid), (BoundingBox{{200, 0, 0}, {470, 150, 150}}));
    EXPECT_FALSE(boundingBox({}));
    EXPECT_FALSE(boundingSphere({}));
}

// Two opposite corners of a cube of side 2 are √12 apart: no sphere with all eight is smaller.
TEST(BoundingSphere, OfACubeIsTheSmallest) {
    std::vector<Vec3d> cube;
    for (int i = 0; i < 8; ++i) cube.push_back({i & 1 ? 6 : 4, i & 2 ? 1 : -1, i & 4 ? 1 : -1});
    const auto sphere = boundingSphere(cube);
    EXPECT_NEAR(sphere->radius, std::sqrt(3.0), 1e-12);
    EXPECT_NEAR(glm::length(sphere->centre - Vec3d(5, 0, 0)), 0, 1e-12);
}

TEST(BoundingSphere, OfOnePointIsThatPoint) {
    const std::vector<Vec3d> one{{3, 4, 5}};
    EXPECT_EQ(boundingSphere(one), (BoundingSphere{{3, 4, 5}, 0}));
}

// Every point is inside, at any place and of any shape. The smallest sphere is at least half the
// largest distance between two points, and at most the box's half diagonal is ever needed.
TEST(BoundingSphere, HoldsEveryPointAndIsSmall) {
    std::mt19937 random(5);
    for (const double place : {0.0, 1e3, 1e9})
        for (const Vec3d size : {Vec3d(1), Vec3d(1, 1e-3, 1e3), Vec3d(1, 0, 0), Vec3d(1e-6)})
            for (const std::size_t count : {2, 3, 7, 200}) {
                const std::vector<Vec3d> points = cloud(random, count, Vec3d(place), size);
                const auto sphere = boundingSphere(points);
                const auto box = boundingBox(points);
                double widest = 0;
                for (const Vec3d& p : points) {
                    EXPECT_LE(glm::length(p - sphere->centre), sphere->radius);
                    EXPECT_TRUE(glm::all(glm::lessThanEqual(box->min, p)));
                    EXPECT_TRUE(glm::all(glm::lessThanEqual(p, box->max)));
                    for (const Vec3d& q : points) widest = std::max(widest, glm::length(p - q));
                }
                EXPECT_GE(sphere->radius, widest / 2 * (1 - 1e-9));
                EXPECT_LE(sphere->radius, glm::length(box->max - box->min) / 2 * (1 + 1e-9) + place * 1e-15);
            }
}

}  // namespace
}  // namespace pipeline
