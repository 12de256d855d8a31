// What the exact verifier says, by hand and against choices tried one by one; and our rasterizer against it.
#include <gtest/gtest.h>

#include <limits>

#include "pipeline/compare/coverage_verifier.h"
#include "tests/support/scenes.h"
#include "tests/support/sweep.h"
#include "tests/support/triangles.h"

namespace pipeline::foreign {
namespace {

Coverage of(const test::ScreenTriangle& triangle, int bits, glm::ivec2 pixel, Snapping snapping = Snapping::Nearest) {
    return CoverageVerifier::make(triangle, bits, snapping)->at(pixel);
}

TEST(CoverageVerifier, ASampleOnAnEdgeIsFreeAndOneInsideIsForced) {
    // The left edge x = 2.5 runs through the centres of column 2; vertices are on the grid for every number of bits.
    const test::ScreenTriangle triangle{{{2.5, 0}, {10.5, 0}, {2.5, 8}}};
    for (int bits = 1; bits <= 16; ++bits) {
        EXPECT_EQ(of(triangle, bits, {1, 3}), Coverage::Forbidden) << bits;
        EXPECT_EQ(of(triangle, bits, {2, 3}), Coverage::Free) << bits;
        EXPECT_EQ(of(triangle, bits, {3, 3}), Coverage::Forced) << bits;
        EXPECT_EQ(of({triangle[1], triangle[0], triangle[2]}, bits, {3, 3}), Coverage::Forced) << bits << ", turned";
    }
}

TEST(CoverageVerifier, AVertexBetweenTwoPointsOfTheGridMayGoToEither) {
    // With one bit the grid has steps of a half: x = 2.25 is as near to 2 as to 2.5. Column 2's centres, at 2.5, are
    // inside or on the edge: covered in the first case, free in the second, so free in all.
    const test::ScreenTriangle tie{{{2.25, -20}, {40, 0}, {2.25, 20}}};
    EXPECT_EQ(of(tie, 1, {2, 0}), Coverage::Free);
    EXPECT_EQ(of(tie, 1, {1, 0}), Coverage::Forbidden);  // 1.5 is left of both
    EXPECT_EQ(of(tie, 2, {2, 0}), Coverage::Forced);     // 2.25 is on the grid of quarters
    // At 2.3 the nearest half is 2.5 alone; whoever truncates takes 2.
    const test::ScreenTriangle near{{{2.3, -20}, {40, 0}, {2.3, 20}}};
    EXPECT_EQ(of(near, 1, {2, 0}), Coverage::Free);                     // on the edge
    const test::ScreenTriangle over{{{2.6, -20}, {40, 0}, {2.6, 20}}};  // 2.5, truncated too; 3 rounded up
    EXPECT_EQ(of(over, 2, {2, 0}), Coverage::Free);                     // 2.5 is the nearest quarter
    EXPECT_EQ(of(over, 8, {2, 0}), Coverage::Forbidden);
    EXPECT_EQ(of(over, 1, {2, 0}, Snapping::Within), Coverage::Free);
    EXPECT_EQ(of(over, 1, {3, 0}, Snapping::Within), Coverage::Forced);  // 3.5 is right of 3
}

TEST(CoverageVerifier, ATriangleWithoutAreaCoversNothing) {
    EXPECT_EQ(of({{{0, 0}, {8, 8}, {4, 4}}}, 8, {2, 2}), Coverage::Forbidden);
    // Snapped to one point.
    EXPECT_EQ(of({{{0.51, 0.5}, {0.5, 0.51}, {0.49, 0.49}}}, 4, {0, 0}), Coverage::Forbidden);
    EXPECT_EQ(of({{{0.51, 0.5}, {0.5, 0.51}, {0.49, 0.49}}}, 4, {0, 0}, Snapping::Within), Coverage::Free);
}

TEST(CoverageVerifier, TakesNoVertexThatItCannotHoldExactly) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), far = std::nextafter(CoverageVerifier::kReach, 1e300);
    EXPECT_FALSE(CoverageVerifier::make({{{nan, 0}, {1, 0}, {0, 1}}}, 8));
    EXPECT_FALSE(CoverageVerifier::make({{{0, 0}, {1, -far}, {0, 1}}}, 8));
    // At its reach 64 bits would have overflowed: the picture's middle is inside.
    const double r = CoverageVerifier::kReach;
    EXPECT_EQ(of({{{-r, -r}, {r, -r}, {0, r}}}, 16, {0, 0}), Coverage::Forced);
    EXPECT_EQ(of({{{-r, -r}, {r, -r}, {0, r}}}, 16, {0, 2000000000}), Coverage::Forced);
}

// Every choice of every vertex is one triangle whose coverage is decided in 64-bit integers with both fill rules.
TEST(CoverageVerifier, AgreesWithChoicesTriedOneByOne) {
    for (unsigned seed = 0; seed < 400; ++seed) {
        const int bits = 1 + int(seed % 4);  // coarse grids have ties
        const auto places = std::int64_t(1) << bits;
        for (const test::ScreenTriangle& t : test::randomTriangles(seed, 10, 6, 3, bits + 2)) {
            for (int y = -1; y < 7; ++y) {
                for (int x = -1; x < 7; ++x) {
                    bool always = true, never = true;
                    for (int choice = 0; choice < 64; ++choice) {
                        glm::i64vec2 p[3];
                        for (int i = 0; i < 3; ++i)
                            for (int c = 0; c < 2; ++c) {
                                const double at = t[std::size_t(i)][c] * double(places);
                                const bool up = ((choice >> (2 * i + c)) & 1) != 0;
                                p[i][c] = std::int64_t(up ? std::floor(at + 0.5) : std::ceil(at - 0.5));
                            }
                        // In half steps, so that the centre is a whole number.
                        const glm::i64vec2 s(places * (2 * x + 1), places * (2 * y + 1));
                        const auto edge = [&](glm::i64vec2 a, glm::i64vec2 b, glm::i64vec2 at) {
                            return (b.x - a.x) * (at.y - 2 * a.y) - (b.y - a.y) * (at.x - 2 * a.x);
                        };
                        const std::int64_t area = edge(p[0], p[1], std::int64_t(2) * p[2]);
                        bool open = area != 0, closed = area != 0;
                        for (int i = 0; i < 3; ++i) {
                            const std::int64_t e = edge(p[i], p[(i + 1) % 3], s) * (area < 0 ? -1 : 1);
                            open = open && e > 0, closed = closed && e >= 0;
                        }
                        always = always && open, never = never && !closed;
                    }
                    const Coverage expected = always ? Coverage::Forced : never ? Coverage::Forbidden : Coverage::Free;
                    ASSERT_EQ(of(t, bits, {x, y}), expected) << "seed " << seed << " at " << x << ' ' << y;
                }
            }
        }
    }
}

TEST(CoverageVerifier, WithinLeavesFreeWhateverFinerGridsDecideBothWays) {
    for (unsigned seed = 0; seed < 300; ++seed) {
        for (const test::ScreenTriangle& t : test::randomTriangles(seed, 10, 6, 3, 12)) {
            for (int y = -1; y < 7; ++y)
                for (int x = -1; x < 7; ++x) {
                    const Coverage wide = of(t, 2, {x, y}, Snapping::Within);
                    for (int bits = 2; bits <= 16; ++bits) {
                        if (wide == Coverage::Free) break;
                        ASSERT_EQ(wide, of(t, bits, {x, y})) << seed << " at " << x << ' ' << y;
                    }
                }
        }
    }
}

constexpr int kSide = 32;
constexpr std::size_t kTogether = 32;

// One world unit is a pixel; the i-th triangle is i units nearer than the first.
Scene sceneOf(const std::vector<test::ScreenTriangle>& triangles, int bits, Precision precision) {
    std::vector<std::vector<std::uint32_t>> polygons;
    std::vector<Vec3d> points;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (const glm::dvec2 p : triangles[i]) points.push_back({p.x, kSide - p.y, double(i)});
        const auto at = std::uint32_t(3 * i);
        polygons.push_back({at, at + 1, at + 2});
    }
    Scene scene;
    scene.objects = {{"triangles", test::mesh(VertexVectors(points), polygons), {}, {}}};
    scene.camera.kind = CameraKind::LookAt, scene.camera.projection = ProjectionKind::Orthographic;
    scene.camera.up = {0, 1, 0}, scene.camera.height = kSide;
    scene.camera.target = {kSide / 2.0, kSide / 2.0, 0}, scene.camera.eye = {kSide / 2.0, kSide / 2.0, 64};
    scene.camera.near = 1, scene.camera.far = 100;
    scene.settings.cull = CullMode::None, scene.settings.subPixelBits = bits, scene.settings.precision = precision;
    scene.settings.width = scene.settings.height = kSide;
    return scene;
}

std::vector<int> idsOf(const FramePtr& frame) {
    const AnyBuffer seen = *frame->buffer({BufferId::PolygonId});
    std::vector<int> ids(seen.count());
    for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = int(seen.flat(i));
    return ids;
}

// A million triangles in a long run. Their coordinates have at most 24 bits, so that vertices are where they were meant in
// float too: those that are far away have fewer places behind the point.
TEST(CoverageVerifier, FindsNoViolationInOurRasterizerAtAnyNumberOfBits) {
    test::CoverageViolations found;
    for (const std::size_t i : test::sweep(1000000 / kTogether)) {
        const int bits = 1 + int(i % 16);
        const bool isFar = i / 16 % 2 != 0;
        const auto triangles = test::randomTriangles(unsigned(i), kTogether, kSide, isFar ? 4000 : 31, isFar ? 11 : 17);
        const Precision precision = i / 32 % 2 ? Precision::Double : Precision::Float;
        const FramePtr frame = test::frameOf(sceneOf(triangles, bits, precision), setOf({BufferId::PolygonId}), 1);
        const AnyBuffer screen = *frame->buffer({BufferId::VerticesScreen});
        for (std::size_t v = 0; v < 3 * kTogether; ++v)
            for (int c = 0; c < 2; ++c)
                ASSERT_EQ(screen.flat(3 * v + std::size_t(c)), triangles[v / 3][v % 3][c]) << i << ", vertex " << v;
        found.add(triangles, idsOf(frame), kSide, bits);
        ASSERT_EQ(found.missing, 0u) << "frame " << i << ", " << bits << " bits";
        ASSERT_EQ(found.extra, 0u) << "frame " << i << ", " << bits << " bits";
    }
    EXPECT_GT(found.decided, 10000u);
}

// The same pictures, judged by a grid that is not theirs.
TEST(CoverageVerifier, FindsViolationsWhereTheGridIsAnother) {
    test::CoverageViolations found;
    for (unsigned i = 0; i < 50; ++i) {
        const auto triangles = test::randomTriangles(i, kTogether, kSide, 31, 17);
        found.add(triangles, idsOf(test::frameOf(sceneOf(triangles, 4, Precision::Float))), kSide, 8);
    }
    EXPECT_GT(found.missing, 10u);
    EXPECT_GT(found.extra, 10u);
}

}  // namespace
}  // namespace pipeline::foreign
