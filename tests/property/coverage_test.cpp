// Coverage: two polygons that share an edge never both cover a sample, and never both miss it.
#include <gtest/gtest.h>

#include "pipeline/stages/rasterize.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

using Counts = Buffer2D<int>;

constexpr int kPixel = 65536, kHalf = kPixel / 2;  // units of a snapped corner

void draw(const SnappedTriangle& triangle, Counts& counts) {
    SnappedTriangle t = triangle;
    if (t.area2() < 0) std::swap(t.corners[1], t.corners[2]);
    if (t.area2() == 0) return;
    forEachCovered(t, {{0, 0}, counts.size}, [&](glm::ivec2 pixel, const auto&) { ++counts.at(pixel); });
}

// What the rule says for one sample, worked out edge by edge with no span arithmetic.
bool covered(SnappedTriangle t, glm::ivec2 pixel) {
    if (t.area2() < 0) std::swap(t.corners[1], t.corners[2]);
    if (t.area2() == 0) return false;
    const std::int64_t x = pixel.x * kPixel + kHalf, y = pixel.y * kPixel + kHalf;
    for (int i = 0; i < 3; ++i) {
        const glm::i64vec2 p = t.corners[std::size_t(i)], q = t.corners[std::size_t((i + 1) % 3)];
        const std::int64_t cross = (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
        const bool left = q.y < p.y, top = q.y == p.y && q.x > p.x;
        if (cross < 0 || (cross == 0 && !left && !top)) return false;
    }
    return true;
}

TEST(Coverage, EqualsTheRuleSampleBySample) {
    std::mt19937 random(1);
    for (int i = 0; i < 3000; ++i) {
        const int step = i % 3 == 0 ? kHalf : i % 3 == 1 ? kHalf / 2 : 1;  // many corners and edges on pixel centres
        SnappedTriangle t;
        for (auto& corner : t.corners)
            corner = {(int(random() % 2300000) - 500000) / step * step,
                      (int(random() % 2300000) - 500000) / step * step};
        Counts counts({20, 20}, 0);
        draw(t, counts);
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < 20; ++x) ASSERT_EQ(counts.at({x, y}), int(covered(t, {x, y}))) << "triangle " << i;
    }
}

// Both triangles on the two sides of one edge, the edge in each of 64 directions through pixel centres, in
// both windings: every sample of their union once.
TEST(Coverage, OneSharedEdgeInEveryOrientation) {
    const glm::i64vec2 centre{16 * kPixel + kHalf, 16 * kPixel + kHalf};
    for (int dx = -8; dx <= 8; ++dx) {
        for (int dy = -8; dy <= 8; ++dy) {
            if (dx == 0 && dy == 0) continue;
            const glm::i64vec2 along{dx * kPixel, dy * kPixel}, across{-dy * kPixel, dx * kPixel};
            const SnappedTriangle one{{centre - along, centre + along, centre + across}};
            const SnappedTriangle other{{centre - along, centre + along, centre - across}};
            const SnappedTriangle turned{{centre + along, centre - along, centre - across}};
            Counts counts({33, 33}, 0), same({33, 33}, 0);
            draw(one, counts), draw(other, counts);
            draw(one, same), draw(turned, same);
            ASSERT_EQ(counts.pixels, same.pixels);
            // The square that they make is convex: strictly inside it every sample is covered once.
            for (int y = 0; y < 33; ++y)
                for (int x = 0; x < 33; ++x) {
                    const glm::i64vec2 d = glm::i64vec2(x * kPixel + kHalf, y * kPixel + kHalf) - centre;
                    const auto u = std::abs(d.x * along.x + d.y * along.y),
                               v = std::abs(d.x * across.x + d.y * across.y);
                    const auto reach = along.x * along.x + along.y * along.y;
                    const int least = u + v < reach ? 1 : 0, most = u + v > reach ? 0 : 1;  // on the outline: either
                    ASSERT_GE(counts.at({x, y}), least) << dx << ' ' << dy << " at " << x << ' ' << y;
                    ASSERT_LE(counts.at({x, y}), most) << dx << ' ' << dy << " at " << x << ' ' << y;
                }
        }
    }
}

// Seen from outside, a ray that enters a closed mesh leaves it: with culling off, every covered pixel of a
// convex one gets exactly two fragments. A hole or an overlap would make it one or three.
TEST(Coverage, AClosedMeshLeavesNoHoleAndNoOverlap) {
    for (unsigned seed = 0; seed < 30; ++seed) {
        Scene scene = test::randomScene(seed);
        scene.objects.resize(1);
        scene.objects[0].mesh = test::sphere(1, 3 + int(seed % 20), 3 + int(seed % 31));
        scene.objects[0].transform.translation = Vec3d(0);
        scene.objects[0].material.alpha = 1;
        scene.settings.cull = CullMode::None;
        scene.settings.width = 320, scene.settings.height = 240;
        scene.settings.precision = seed % 2 ? Precision::Float : Precision::Double;
        if (glm::length(scene.camera.eye) < 3) scene.camera.eye = {0, -4, 1};
        const FramePtr frame = test::frameOf(scene);
        const AnyBuffer overdraw = *frame->buffer({BufferId::Overdraw});
        std::size_t twice = 0;
        for (std::size_t i = 0; i < overdraw.count(); ++i) {
            ASSERT_TRUE(overdraw.flat(i) == 0 || overdraw.flat(i) == 2) << "seed " << seed << " pixel " << i;
            twice += overdraw.flat(i) == 2;
        }
        EXPECT_GT(twice, 100u) << seed;
    }
}

// A polygon cut by the near plane: coverage equals that of the polygon cut by hand.
TEST(Coverage, NearClippingEqualsThePolygonCutByHand) {
    // The floor z = -1 from y = -2 (behind the eye) to y = 10, seen from the origin along +y, near plane at y = 1.
    Scene scene;
    scene.settings.cull = CullMode::None;
    scene.settings.width = 160, scene.settings.height = 120;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, 0, 0}, scene.camera.target = {0, 1, 0}, scene.camera.fovY = 90;
    scene.camera.near = 1, scene.camera.far = 100;
    const auto floor = [&](double y) {
        return test::mesh({{-3, y, -1}, {3, y, -1}, {3, 10, -1}, {-3, 10, -1}}, {{0, 1, 2, 3}});
    };
    scene.objects = {{"floor", floor(-2), {}, {}}};
    const FramePtr clipped = test::frameOf(scene);
    EXPECT_EQ(clipped->buffer({BufferId::PolygonsVerdict})->flat(0), 9);  // clipped
    scene.objects = {{"floor", floor(1), {}, {}}};
    const FramePtr byHand = test::frameOf(scene);
    const AnyBuffer a = *clipped->buffer({BufferId::ObjectId}), b = *byHand->buffer({BufferId::ObjectId});
    const AnyBuffer za = *clipped->buffer({BufferId::ZView}), zb = *byHand->buffer({BufferId::ZView});
    int covered = 0;
    for (std::size_t i = 0; i < a.count(); ++i) {
        ASSERT_EQ(a.flat(i), b.flat(i)) << i;
        if (a.flat(i) < 0) continue;
        ++covered;
        ASSERT_NEAR(za.flat(i) / zb.flat(i), 1, 1e-4);
    }
    EXPECT_GT(covered, 2000);
}

}  // namespace
}  // namespace pipeline
