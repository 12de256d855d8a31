// Concave polygons of many corners: split into triangles that cover each point once, in steps that grow with n log n.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "pipeline/scene/mesh/ear_clipper.h"
#include "pipeline/scene/mesh/index_set.h"
#include "pipeline/scene/mesh/mesh.h"

namespace pipeline {
namespace {

using Outline = std::vector<Vec2<double>>;

double areaOf(const Outline& points) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2<double>&a = points[i], &b = points[i + 1 == points.size() ? 0 : i + 1];
        sum += (a.x - points[0].x) * (b.y - points[0].y) - (a.y - points[0].y) * (b.x - points[0].x);
    }
    return sum / 2;
}

// A band of half the distance between its turns, counter-clockwise: out along one side and back along the other.
Outline spiral(std::size_t corners, double turns) {
    Outline points;
    const std::size_t half = corners / 2;
    const auto at = [&](std::size_t i, double shift) {
        const double t = static_cast<double>(i) / static_cast<double>(half - 1);
        const double angle = 2 * std::numbers::pi * turns * t, radius = 0.2 + turns * t / 5 + shift;
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    };
    for (std::size_t i = 0; i < half; ++i) at(i, 0.1);
    for (std::size_t i = half; i-- > 0;) at(i, 0);
    return points;
}

// Right angles alone: at any time two of its corners can be cut off.
Outline squareSpiral(int turns) {
    Outline outside, inside;
    double x = 0, y = 0;
    for (int i = 0; i < 4 * turns; ++i) {
        const double length = i / 2 + 1, right[] = {1, 0, -1, 0}, up[] = {0, 1, 0, -1};
        x += length * right[i % 4], y += length * up[i % 4];
        // The corner's two sides are along the diagonal between what it comes from and what it goes to.
        const double dx = right[i % 4] - right[(i + 1) % 4], dy = up[i % 4] - up[(i + 1) % 4];
        outside.emplace_back(x + dx / 4, y + dy / 4);
        inside.emplace_back(x - dx / 4, y - dy / 4);
    }
    outside.insert(outside.end(), inside.rbegin(), inside.rend());
    return outside;
}

Outline comb(std::size_t teeth) {
    Outline points;
    for (std::size_t i = 0; i < teeth; ++i) {
        points.emplace_back(double(i), -1);
        points.emplace_back(double(i) + 0.5, 1000);
    }
    points.emplace_back(double(teeth), -1);
    points.emplace_back(double(teeth) / 2, -2);
    std::ranges::reverse(points);
    return points;
}

// A square with holes, each entered along a bridge that is walked there and back.
Outline plate(int side) {
    Outline points{{0, 0}, {double(side), 0}, {double(side), double(side)}};
    for (int row = side - 1; row >= 0; --row) {
        points.emplace_back(0, row + 0.5);
        for (int column = 0; column < side; ++column) {
            // Reached at the left, walked clockwise; the way on begins at the right.
            points.emplace_back(column + 0.25, row + 0.5);
            points.emplace_back(column + 0.5, row + 0.75);
            points.emplace_back(column + 0.75, row + 0.5);
        }
        for (int column = side - 1; column >= 0; --column) {
            points.emplace_back(column + 0.75, row + 0.5);
            points.emplace_back(column + 0.5, row + 0.25);
            points.emplace_back(column + 0.25, row + 0.5);
        }
        points.emplace_back(0, row + 0.5);
    }
    points.insert(points.begin() + 3, {0, double(side)});
    return points;
}

struct Split {
    bool done = false;
    double all = 0, reversed = 0;  // area of its triangles, and of those that turn right
    std::size_t triangles = 0, steps = 0;
};
Split split(const Outline& points) {
    constexpr std::size_t kWork = 1'000'000'000;
    std::size_t left = kWork;
    std::vector<glm::uvec3> triangles;
    Split result;
    // Coordinates here are a few units, or a thousand: no rounding of theirs is above 2^-43.
    StopCheck never{Stop()};
    result.done = EarClipper(points, 0x1p-43, left, never).clip(triangles);
    for (const glm::uvec3& t : triangles) {
        const double area = areaOf({points[t.x], points[t.y], points[t.z]});
        result.all += std::abs(area);
        if (area < 0) result.reversed -= area;
    }
    result.triangles = triangles.size(), result.steps = kWork - left;
    return result;
}

// n - 2 triangles of a positive sense whose areas add up to the polygon's cover it once.
void expectCoveredOnce(const Outline& points) {
    const Split result = split(points);
    EXPECT_TRUE(result.done);
    EXPECT_EQ(result.triangles, points.size() - 2);
    EXPECT_NEAR(result.all / areaOf(points), 1, 1e-9);
    EXPECT_LE(result.reversed, 1e-12 * areaOf(points));
    const double n = static_cast<double>(points.size());
    EXPECT_LE(double(result.steps), 100 * n * std::log2(n)) << points.size() << " corners";
}

TEST(SplitPolygons, SpiralsOfManyCornersAreCoveredOnce) {
    for (const std::size_t corners : {1000, 8000, 100'000}) expectCoveredOnce(spiral(corners, 3));
    expectCoveredOnce(spiral(8000, 30));
}

TEST(SplitPolygons, SquareSpiralsAreCoveredOnce) {
    for (const int turns : {2, 100, 5000}) expectCoveredOnce(squareSpiral(turns));
}

TEST(SplitPolygons, CombsAreCoveredOnce) {
    for (const std::size_t teeth : {3, 100, 20'000}) expectCoveredOnce(comb(teeth));
}

TEST(SplitPolygons, PlatesWithHolesAreCoveredOnce) {
    for (const int side : {1, 5, 60}) {
        const Outline points = plate(side);
        EXPECT_NEAR(areaOf(points), side * side * (1 - 0.125), 1e-6);
        expectCoveredOnce(points);
    }
}

TEST(SplitPolygons, ARandomStarIsCoveredOnce) {
    constexpr std::size_t kCorners = 20'000;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> radius(1, 10);
    Outline points;
    for (std::size_t i = 0; i < kCorners; ++i) {
        const double angle = 2 * std::numbers::pi * double(i) / double(kCorners), r = radius(random);
        points.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    expectCoveredOnce(points);
}

TEST(SplitPolygons, WorkThatIsUsedUpEndsIt) {
    const Outline points = spiral(8000, 3);
    std::size_t left = 10'000;
    std::vector<glm::uvec3> triangles;
    StopCheck never{Stop()};
    EXPECT_FALSE(EarClipper(points, 0x1p-43, left, never).clip(triangles));
    EXPECT_EQ(left, 0u);
    EXPECT_LT(triangles.size(), points.size() - 2);
}

TEST(SplitPolygons, AMeshSaysWhichPolygonsItDidNotSplit) {
    const auto meshOf = [](const Outline& points) {
        Mesh mesh;
        std::vector<std::uint32_t> polygon;
        for (const Vec2<double>& p : points) {
            polygon.push_back(static_cast<std::uint32_t>(polygon.size()));
            mesh.positions.push_back(Vec3d(p.x, p.y, 0));
        }
        mesh.addPolygon(polygon);
        return makeMesh(std::move(mesh));
    };
    const auto right = meshOf(spiral(100'000, 3));
    EXPECT_EQ(right->facts.concave, 1);
    EXPECT_EQ(right->facts.unsplit, 0);
    // A bow-tie: its outline crosses itself.
    const auto crossed = meshOf({{0, 0}, {3, 2}, {3, 0}, {0, 1}});
    EXPECT_EQ(crossed->facts.concave, 1);
    EXPECT_EQ(crossed->facts.unsplit, 1);
}

TEST(IndexSet, FindsTheNextOneAndBeginsAnew) {
    std::mt19937 random(7);
    for (const std::uint32_t n : {1u, 64u, 65u, 5000u}) {
        IndexSet set(n);
        std::vector<bool> has(n, false);
        EXPECT_EQ(set.from(0), IndexSet::kNone);
        for (int step = 0; step < 2000; ++step) {
            const std::uint32_t i = static_cast<std::uint32_t>(random() % n);
            has[i] = step % 3 != 0;
            has[i] ? set.insert(i) : set.erase(i);
            const std::uint32_t from = static_cast<std::uint32_t>(random() % n);
            std::uint32_t expected = IndexSet::kNone;
            for (std::uint32_t k = 0; k < n && expected == IndexSet::kNone; ++k)
                if (has[(from + k) % n]) expected = (from + k) % n;
            ASSERT_EQ(set.from(from), expected);
        }
    }
}

}  // namespace
}  // namespace pipeline
