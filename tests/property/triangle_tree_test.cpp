// The tree of boxes that leads a ray to few of many triangles: it finds what looking at all of them finds.
#include "pipeline/core/triangle_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace pipeline::rays {
namespace {

template <class Real>
struct TriangleTreeProperty : testing::Test {
    struct Numbered {
        Corners<Real> corners;
        std::uint32_t id;  // whatever the order is
    };
    struct Hit {
        Real t = std::numeric_limits<Real>::infinity();
        std::uint32_t id = ~0u;
        Vec3<Real> weights{0};
        bool operator==(const Hit&) const = default;
    };

    std::mt19937 random{7};
    Real any(double low, double high) { return Real(std::uniform_real_distribution<double>(low, high)(random)); }
    Vec3<Real> anywhere(double reach) { return {any(-reach, reach), any(-reach, reach), any(-reach, reach)}; }

    // Up to 0.2 wide in a cube of 2 around `middle`. Every tenth is the same as the one before it, every ninth has no
    // area, some share a corner with the one before, one has no place.
    std::vector<Numbered> soup(Vec3<Real> middle) {
        std::vector<Numbered> triangles;
        for (std::uint32_t i = 0; i < 3000; ++i) {
            const Vec3<Real> at = middle + anywhere(1);
            Corners<Real> corners{at + anywhere(0.1), at + anywhere(0.1), at + anywhere(0.1)};
            if (i % 10 == 9) corners = triangles.back().corners;
            if (i % 9 == 8) corners[2] = (corners[0] + corners[1]) / Real(2);
            if (i % 7 == 6) corners[0] = triangles.back().corners[1];
            triangles.push_back({corners, i});
        }
        triangles[1234].corners[1].y = std::numeric_limits<Real>::quiet_NaN();
        return triangles;
    }
    // Through the soup, along an axis, from a triangle's corner, and from far away through one.
    Ray<Real> anyRay(int i, const std::vector<Numbered>& triangles) {
        const Corners<Real>& corners = triangles[std::size_t(any(0, 1000))].corners;
        switch (i % 4) {
            case 0: return {corners[0] + anywhere(1), anywhere(1)};
            case 1: {
                Ray<Real> ray{corners[1], Vec3<Real>(0)};
                ray.direction[i % 3] = i % 8 == 1 ? Real(-2) : Real(0.5);
                return ray;
            }
            case 2: return {corners[0], corners[2] - corners[0] + anywhere(0.1)};
            default: {
                const Vec3<Real> from = anywhere(1000);
                return {from, (corners[0] + corners[1] + corners[2]) / Real(3) - from};
            }
        }
    }

    // Of two at the same t the lower id.
    static void meet(const TriangleRay<Real>& line, const Numbered& triangle, Hit& first) {
        Real t;
        Vec3<Real> weights;
        if (!line.meets(triangle.corners, t, weights) || !(t >= 0)) return;
        if (t < first.t || (t == first.t && triangle.id < first.id)) first = {t, triangle.id, weights};
    }
    static Hit byLookingAtAll(const std::vector<Numbered>& triangles, const Ray<Real>& ray) {
        const TriangleRay<Real> line(ray);
        Hit first;
        for (const Numbered& triangle : triangles) meet(line, triangle, first);
        return first;
    }
    static Hit byTree(const std::vector<Numbered>& triangles, const TriangleTree<Real>& tree, const Ray<Real>& ray) {
        const TriangleRay<Real> line(ray);
        Hit first;
        forEachNear(tree, line, Real(0), first.t, [&](std::uint32_t place, Real& end) {
            meet(line, triangles[tree.order[place]], first);
            end = first.t;
            return false;
        });
        return first;
    }
    static TriangleTree<Real> treeOf(const std::vector<Numbered>& triangles, std::uint32_t leaf) {
        return makeTree<Real>(
            std::uint32_t(triangles.size()), [&](std::uint32_t i) { return triangles[i].corners; }, leaf);
    }
};
using Reals = testing::Types<double, long double>;
TYPED_TEST_SUITE(TriangleTreeProperty, Reals);

// To the last bit, in whatever order the triangles come, and however many are left in a leaf.
TYPED_TEST(TriangleTreeProperty, FindsTheFirstTriangleThatLookingAtAllFinds) {
    using Real = TypeParam;
    for (const Vec3<Real> middle : {Vec3<Real>(0), Vec3<Real>(1e5, -3e4, 2e5)}) {
        auto triangles = this->soup(middle);
        int hits = 0;
        for (const std::uint32_t leaf : {1u, 4u, 8u, 5000u}) {
            std::ranges::shuffle(triangles, this->random);
            const auto tree = this->treeOf(triangles, leaf);
            EXPECT_EQ(tree.order.size(), triangles.size() - 1) << "without the one that has no place";
            for (int i = 0; i < 500; ++i) {
                const Ray<Real> ray = this->anyRay(i, triangles);
                const auto expected = this->byLookingAtAll(triangles, ray), found = this->byTree(triangles, tree, ray);
                ASSERT_EQ(found.id, expected.id) << "ray " << i << ", leaves of " << leaf;
                EXPECT_EQ(found, expected);
                hits += found.id != ~0u;
            }
        }
        EXPECT_GT(hits, 500);
    }
}

// By number, not by time: of a flat grid of 40 000 triangles a ray across it looks at those around it.
TYPED_TEST(TriangleTreeProperty, LooksAtFewTriangles) {
    using Real = TypeParam;
    constexpr std::uint32_t kSide = 200;
    const auto tree = makeTree<Real>(
        kSide * kSide,
        [](std::uint32_t i) {
            const Vec3<Real> corner(Real(i % kSide), Real(i / kSide), 0);
            return Corners<Real>{corner, corner + Vec3<Real>(1, 0, 0), corner + Vec3<Real>(0, 1, 0)};
        },
        8);
    std::set<std::uint32_t> seen;
    const TriangleRay<Real> line({{Real(100.3), Real(50.3), 10}, {0, 0, -1}});
    EXPECT_FALSE(forEachNear(tree, line, Real(0), Real(100), [&](std::uint32_t place, Real&) {
        seen.insert(tree.order[place]);
        return false;
    }));
    EXPECT_TRUE(seen.contains(50 * kSide + 100));
    EXPECT_LE(seen.size(), 8u) << "those of one box";
    EXPECT_TRUE(forEachNear(tree, line, Real(0), Real(100), [](std::uint32_t, Real&) { return true; }));
    EXPECT_FALSE(forEachNear(tree, line, Real(0), Real(9), [](std::uint32_t, Real&) { return true; })) << "ends before";
}

TYPED_TEST(TriangleTreeProperty, StoppedThereIsNothing) {
    using Real = TypeParam;
    std::stop_source stop;
    const auto make = [&] {
        return makeTree<Real>(
            100,
            [](std::uint32_t i) {
                return Corners<Real>{Vec3<Real>(Real(i)), Vec3<Real>(0), Vec3<Real>(1)};
            },
            4, stop.get_token());
    };
    EXPECT_FALSE(make().nodes.empty());
    stop.request_stop();
    EXPECT_TRUE(make().nodes.empty());
}

TYPED_TEST(TriangleTreeProperty, OfNothingThereIsNothing) {
    using Real = TypeParam;
    const auto tree = makeTree<Real>(0, [](std::uint32_t) { return Corners<Real>{}; });
    EXPECT_TRUE(tree.nodes.empty());
    EXPECT_FALSE(forEachNear(tree, TriangleRay<Real>({{}, {0, 0, 1}}), Real(0), Real(1),
                             [](std::uint32_t, Real&) { return true; }));
}

}  // namespace
}  // namespace pipeline::rays
