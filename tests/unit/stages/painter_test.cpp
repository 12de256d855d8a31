#include "pipeline/stages/painter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "pipeline/inspect/pixel_report.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

// Polygons in front of an eye at the origin that looks along +y with z up.
Scene lookingAt(std::vector<std::shared_ptr<const Mesh>> meshes) {
    Scene scene;
    scene.settings.width = scene.settings.height = 64;
    scene.settings.precision = Precision::Double;
    scene.settings.cull = CullMode::None;
    scene.settings.visibility = Visibility::Painter;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, 0, 0}, scene.camera.target = {0, 1, 0}, scene.camera.fovY = 60;
    scene.camera.near = 1, scene.camera.far = 100;
    scene.ambient.intensity = 100;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const double shade = double(i + 1) / double(meshes.size());
        scene.objects.push_back({"object", meshes[i], {}, {Vec3d(shade), Vec3d(0), 1}});
    }
    return scene;
}

// Three bars around the line of sight, each before the next and behind the one before: from point i of a triangle,
// where it is at y = 9, to beyond point i + 1, where it is at y = 11.
Scene cycle() {
    std::vector<std::shared_ptr<const Mesh>> bars;
    for (int i = 0; i < 3; ++i) {
        const double angle = i * 2 * 3.14159265358979323846 / 3;
        const auto turned = [&](double x, double y, double z) {
            return Vec3d(x * std::cos(angle) - z * std::sin(angle), y, x * std::sin(angle) + z * std::cos(angle));
        };
        bars.push_back(test::mesh({turned(-4, 9, -1.5), turned(4, 11, -1.5), turned(4, 11, -0.5), turned(-4, 9, -0.5)},
                                  {{0, 1, 2, 3}}));
    }
    return lookingAt(bars);
}

Scene with(Scene scene, Visibility visibility, bool split = true) {
    scene.settings.visibility = visibility;
    scene.settings.split = split;
    return scene;
}

// Pixels in which the two differ although their depths tell the polygons apart.
int differences(const Scene& painted, const Scene& reference) {
    const FramePtr a = test::frameOf(painted), b = test::frameOf(reference);
    const AnyBuffer idA = *a->buffer({BufferId::PolygonId}), idB = *b->buffer({BufferId::PolygonId});
    const AnyBuffer zA = *a->buffer({BufferId::ZView}), zB = *b->buffer({BufferId::ZView});
    const AnyBuffer colorA = *a->buffer({BufferId::Color}), colorB = *b->buffer({BufferId::Color});
    int count = 0;
    for (std::size_t i = 0; i < idA.count(); ++i) {
        const double rounding = 1e-12 * std::abs(zB.flat(i));
        if (idA.flat(i) != idB.flat(i)) {
            count += !(std::abs(zA.flat(i) - zB.flat(i)) <= rounding);
            continue;
        }
        for (std::size_t c = 0; c < 3; ++c) count += colorA.flat(3 * i + c) != colorB.flat(3 * i + c);
    }
    return count;
}

TEST(Painter, SplitBarsThatOverlapInACycleLookAsInTheZBuffer) {
    EXPECT_EQ(differences(cycle(), with(cycle(), Visibility::ZBuffer)), 0);
}

// Sorted by mean depth all three tie, so they are painted by number: bar 2 over bar 0 although bar 0 is nearer at one
// of their crossings.
TEST(Painter, WithoutSplittingACycleIsWrong) {
    EXPECT_GT(differences(with(cycle(), Visibility::Painter, false), with(cycle(), Visibility::ZBuffer)), 0);
}

// Planes y = 10 + x and y = 10 - x: the seam is in the middle of the picture, at x = 0.
TEST(Painter, IntersectingPolygonsAreSplitAtTheirSeam) {
    const Scene scene = lookingAt({test::mesh({{-3, 7, -3}, {3, 13, -3}, {3, 13, 3}, {-3, 7, 3}}, {{0, 1, 2, 3}}),
                                   test::mesh({{-3, 13, -3}, {3, 7, -3}, {3, 7, 3}, {-3, 13, 3}}, {{0, 1, 2, 3}})});
    EXPECT_EQ(differences(scene, with(scene, Visibility::ZBuffer)), 0);
    const AnyBuffer id = *test::frameOf(scene)->buffer({BufferId::PolygonId});
    EXPECT_EQ(id.value(31, 32), 0);
    EXPECT_EQ(id.value(32, 32), 1);
    // Without splitting one of them covers the other on both sides.
    const AnyBuffer whole = *test::frameOf(with(scene, Visibility::Painter, false))->buffer({BufferId::PolygonId});
    EXPECT_EQ(whole.value(31, 32), whole.value(32, 32));
}

TEST(Painter, RandomScenesLookAsInTheZBuffer) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        Scene scene = test::randomScene(seed);
        scene.settings.precision = Precision::Double;
        scene.settings.depthFormat = DepthFormat::Linear;
        EXPECT_EQ(differences(with(scene, Visibility::Painter), with(scene, Visibility::ZBuffer)), 0) << seed;
    }
}

// Triangles that cross each other or not, seen along the axis that their depths are in.
Scene looseTriangles(const std::vector<std::array<Vec3d, 3>>& triangles) {
    std::vector<std::shared_ptr<const Mesh>> meshes;
    for (const std::array<Vec3d, 3>& c : triangles) meshes.push_back(test::mesh({c[0], c[1], c[2]}, {{0, 1, 2}}));
    Scene scene = lookingAt(meshes);
    scene.camera.eye = {0, 0, 7}, scene.camera.target = {0, 0, 0}, scene.camera.up = {0, 1, 0};
    scene.camera.projection = ProjectionKind::Orthographic, scene.camera.height = 4;
    return scene;
}

// Here polygon 0 is cut by the plane of polygon 2, and the part behind that overlaps it in the picture no more, though
// the boxes around the two do: it need not wait for it.
TEST(Painter, APieceNeedNotWaitForWhatItsBoxAloneOverlaps) {
    const Scene scene =
        looseTriangles({{Vec3d(1.064, 1.503, 1.049), {0.121, 1.616, -0.051}, {1.422, 0.504, -0.026}},
                        {Vec3d(0.255, -0.868, -1.99), {-1.965, 1.311, -0.819}, {1.659, 1.247, 1.277}},
                        {Vec3d(-0.055, 0.572, -0.377), {-0.757, -1.393, -1.833}, {1.995, -1.546, -0.304}}});
    EXPECT_EQ(differences(scene, with(scene, Visibility::ZBuffer)), 0);
}

TEST(Painter, LooseTrianglesLookAsInTheZBuffer) {
    for (unsigned seed = 0; seed < 600; ++seed) {
        std::mt19937 random(seed);
        // Of some, corners stand on a coarse grid, so that planes and outlines coincide.
        const double step = seed % 2 ? 0.5 : 0x1p-20;
        const auto number = [&] {
            const double whole = double(random()) / double(std::mt19937::max()) * 4 - 2;
            return step * std::round(whole / step);
        };
        std::vector<std::array<Vec3d, 3>> triangles(3 + seed % 20);
        for (auto& triangle : triangles)
            for (Vec3d& corner : triangle) corner = {number(), number(), number()};
        const Scene scene = looseTriangles(triangles);
        EXPECT_EQ(differences(scene, with(scene, Visibility::ZBuffer)), 0) << seed;
    }
}

TEST(Painter, TheOrderDoesNotDependOnThreadsOrChance) {
    const FramePtr first = test::frameOf(cycle(), test::everyBuffer(), 1);
    for (int run = 0; run < 100; ++run) {
        const FramePtr again = test::frameOf(cycle(), test::everyBuffer(), 1 + run % 4);
        ASSERT_EQ(test::firstDifference(*first, *again), "") << run;
    }
}

// Squares at different depths have one right order, whatever their numbers.
TEST(Painter, ShuffledPolygonsGiveTheSamePicture) {
    std::vector<std::shared_ptr<const Mesh>> squares;
    for (int i = 0; i < 9; ++i) {
        const double x = i % 3 - 1, z = i / 3 - 1, y = 8 + i;
        squares.push_back(
            test::mesh({{x - 2, y, z - 2}, {x + 2, y, z - 2}, {x + 2, y, z + 2}, {x - 2, y, z + 2}}, {{0, 1, 2, 3}}));
    }
    for (const bool split : {false, true}) {
        Scene scene = with(lookingAt(squares), Visibility::Painter, split);
        const FramePtr before = test::frameOf(scene);
        std::mt19937 random(3);
        for (int run = 0; run < 10; ++run) {
            std::shuffle(scene.objects.begin(), scene.objects.end(), random);
            const FramePtr after = test::frameOf(scene);
            const AnyBuffer a = *before->buffer({BufferId::Color}), b = *after->buffer({BufferId::Color});
            for (std::size_t i = 0; i < a.count(); ++i) ASSERT_EQ(a.flat(i), b.flat(i)) << run << ' ' << i;
        }
    }
}

PaintTriangle flat(double depth, std::uint32_t polygon) {
    return {{{glm::i64vec2(0, 0), glm::i64vec2(10 * kSubPixels, 0), glm::i64vec2(0, 10 * kSubPixels)}},
            {depth, depth, depth},
            depth,
            polygon};
}

std::vector<std::uint32_t> numbers(const PaintingOrder& order) {
    std::vector<std::uint32_t> out;
    for (const PaintPiece& piece : order.pieces) out.push_back(piece.triangle);
    return out;
}

TEST(PaintingOrder, FarthestFirstAndTiesByNumber) {
    const std::vector<PaintTriangle> triangles{flat(5, 0), flat(9, 1), flat(5, 2), flat(7, 3)};
    for (const bool split : {false, true}) {
        const PaintingOrder order = paintingOrder(triangles, split);
        EXPECT_EQ(numbers(order), (std::vector<std::uint32_t>{1, 3, 0, 2}));
        EXPECT_EQ(order.splits, 0u);
    }
}

// The first reaches farther back than the second, but is before it where both are seen: the mean misleads, too.
TEST(PaintingOrder, KeepsPolygonsWholeThatHaveAnOrder) {
    PaintTriangle slope{{{glm::i64vec2(0, 0), glm::i64vec2(100 * kSubPixels, 0), glm::i64vec2(0, 10 * kSubPixels)}},
                        {1, 21, 1},
                        7.7,
                        0};
    PaintTriangle small = flat(4, 1);
    const std::vector<PaintTriangle> triangles{slope, small};
    const PaintingOrder order = paintingOrder(triangles, true);
    EXPECT_EQ(order.splits, 0u);
    EXPECT_EQ(numbers(order), (std::vector<std::uint32_t>{1, 0}));
    EXPECT_EQ(numbers(paintingOrder(triangles, false)), (std::vector<std::uint32_t>{0, 1}));
}

TEST(PaintingOrder, EveryPixelBelongsToOnePieceOfATriangle) {
    PaintTriangle tilted = flat(5, 0);
    tilted.depth = {3, 7, 5};
    const std::vector<PaintTriangle> triangles{tilted, flat(5, 1)};
    const PaintingOrder order = paintingOrder(triangles, true);
    ASSERT_EQ(order.splits, 1u);
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 10; ++x)
            for (std::uint32_t t = 0; t < 2; ++t)
                EXPECT_EQ(std::ranges::count_if(order.pieces,
                                                [&](const auto& p) {
                                                    return p.triangle == t && order.has(p, {x, y});
                                                }),
                          1);
}

PaintTriangle triangleAt(std::array<glm::i64vec2, 3> pixels, std::array<double, 3> depth, std::uint32_t polygon) {
    for (glm::i64vec2& corner : pixels) corner *= std::int64_t(kSubPixels);
    return {{pixels}, depth, (depth[0] + depth[1] + depth[2]) / 3, polygon};
}

// A hundred triangles side by side, of the same depths: none is behind another, and the n-th to be painted is compared
// with the 100 - n that are left. Ten take 99 + 98 + ... + 90 = 945 comparisons, and the eleventh's 89 pass 1000.
TEST(PaintingOrder, AtTheLimitTheRestIsPaintedWithoutBeingCompared) {
    std::vector<PaintTriangle> triangles;
    for (std::uint32_t i = 0; i < 100; ++i)
        triangles.push_back(triangleAt({{{4 * i, 0}, {4 * i + 2, 0}, {4 * i, 2}}}, {1, 9, 9}, i));
    const PaintingOrder whole = paintingOrder(triangles, true), limited = paintingOrder(triangles, true, {}, 1000);
    EXPECT_EQ(whole.compared, 4950u);
    EXPECT_EQ(whole.unordered, 0u);
    EXPECT_EQ(limited.compared, 1000u);
    EXPECT_EQ(limited.unordered, 90u);
    EXPECT_EQ(numbers(limited), numbers(whole)) << "the farthest first, which is right here";
}

// Three bars along the sides of a triangle, from depth 10 where each begins to 20 to 22 where it ends: each ends behind
// the beginning of the next. Compared are 0 with 1, which is before it, and with 2, which is behind it and goes first;
// 2 with 0 and 1, which goes first; and 1 with 0, which closes the cycle. The sixth comparison finds that 1 crosses the
// plane of 0: (90, 3) is before it, 10 < 20.8, and (40, 89) behind, 21 > 14.8.
TEST(PaintingOrder, TheSearchForASplitInACycleCountsToo) {
    const std::vector<PaintTriangle> bars{triangleAt({{{0, 15}, {100, 20}, {0, 25}}}, {10, 22, 10}, 0),
                                          triangleAt({{{94, 5}, {40, 89}, {86, 1}}}, {10, 21, 10}, 1),
                                          triangleAt({{{56, 92}, {10, 3}, {64, 87}}}, {10, 20, 10}, 2)};
    const PaintingOrder before = paintingOrder(bars, true, {}, 5), after = paintingOrder(bars, true, {}, 6);
    EXPECT_EQ(before.splits, 0u);
    EXPECT_EQ(numbers(before), (std::vector<std::uint32_t>{1, 2, 0})) << "those that wait, the last first";
    EXPECT_EQ(before.unordered, 3u);
    EXPECT_EQ(after.splits, 1u);
    EXPECT_EQ(after.unordered, 4u);
    EXPECT_EQ(paintingOrder(bars, true).unordered, 0u);
}

TEST(PaintingOrder, StoppedItComparesNothing) {
    std::stop_source stop;
    stop.request_stop();
    const std::vector<PaintTriangle> triangles{flat(5, 0), flat(9, 1), flat(5, 2)};
    const PaintingOrder order = paintingOrder(triangles, true, stop.get_token());
    EXPECT_EQ(order.compared, 0u);
    EXPECT_EQ(order.pieces.size(), 3u);
}

TEST(Painter, HasNoDepthBufferAndSaysWhy) {
    const FramePtr frame = test::frameOf(cycle());
    EXPECT_FALSE(frame->buffer({BufferId::Depth}));
    EXPECT_EQ(frame->whyAbsent({BufferId::Depth}), "The painter's algorithm compares no depths.");
    EXPECT_TRUE(frame->buffer({BufferId::ZView}));
}

// Every fragment is written, and the last one is what the frame shows.
TEST(Painter, TheLedgerShowsTheOrderOfPainting) {
    const FramePtr frame = test::frameOf(cycle());
    const AnyBuffer overdraw = *frame->buffer({BufferId::Overdraw});
    for (int y = 0; y < 64; y += 3)
        for (int x = 0; x < 64; x += 3) {
            const PixelReport r = inspectPixel(*frame, {x, y});
            ASSERT_EQ(double(r.fragments.size()), overdraw.value(std::size_t(x), std::size_t(y)));
            for (std::size_t i = 0; i < r.fragments.size(); ++i)
                ASSERT_EQ(name(r.fragments[i].verdict),
                          i + 1 == r.fragments.size() ? "painted last, stays" : "painted over");
            if (!r.fragments.empty()) {
                ASSERT_EQ(r.fragments.back().polygon, r.polygon);
            }
        }
}

}  // namespace
}  // namespace pipeline
