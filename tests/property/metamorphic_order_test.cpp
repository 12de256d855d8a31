// A thousand scenes with their objects, and the polygons of every mesh, in another order; and on other numbers of threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "pipeline/inspect/replay.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

struct MetamorphicOrder : testing::TestWithParam<unsigned> {
    static constexpr unsigned kScenes = 1000, kShards = 10;
};
INSTANTIATE_TEST_SUITE_P(Shards, MetamorphicOrder, testing::Range(0u, MetamorphicOrder::kShards));

std::shared_ptr<const Mesh> shuffled(const Mesh& mesh, std::mt19937& random) {
    std::vector<std::size_t> order(mesh.polygonCount());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::shuffle(order.begin(), order.end(), random);
    Mesh out;
    out.positions = mesh.positions, out.normals = mesh.normals;
    for (const std::size_t p : order) out.addPolygon(mesh.polygon(p));
    return makeMesh(std::move(out));
}

// Normals that belong to vertices whatever their polygons: in sums over polygons the order would show.
std::shared_ptr<const Mesh> withNormals(const Mesh& mesh) {
    Mesh out = mesh;
    out.normals = out.positions;
    return makeMesh(std::move(out));
}

bool hasTie(std::vector<double> depths) {
    std::ranges::sort(depths);
    return std::ranges::adjacent_find(depths) != depths.end();
}
// Whether two fragments that reached a pixel, opaque or translucent, are equally far away.
bool hasTie(const Frame& frame, glm::ivec2 pixel) {
    return readStages(frame, [&](const auto& data) {
        std::vector<double> opaque, layers;
        for (const FragmentRecord& record : replayPixel(data, pixel)) opaque.push_back(record.depth);
        for (const auto& layer : replayLayers(data, pixel)) layers.push_back(layer.depth);
        return hasTie(opaque) || hasTie(layers);
    });
}

// Where nothing ties, the nearest fragment is the nearest in any order: all that is seen is the same, bit for bit.
TEST_P(MetamorphicOrder, ObjectsAndPolygonsInAnotherOrder) {
    constexpr BufferId kCompared[]{BufferId::Color,       BufferId::Intensity, BufferId::ZView,  BufferId::Depth,
                                   BufferId::Barycentric, BufferId::Normal,    BufferId::Layers, BufferId::Overdraw};
    std::size_t covered = 0, tied = 0;
    for (unsigned seed = GetParam(); seed < kScenes; seed += kShards) {
        std::mt19937 random(seed);
        Scene scene = test::smallScene(seed);
        scene.settings.normalWeight = NormalWeight::Given;
        scene.settings.translucency = Translucency::Exact;
        if (seed % 3 == 0) scene.settings.precision = Precision::Double;
        for (Object& object : scene.objects) object.mesh = withNormals(*object.mesh);
        Scene other = scene;
        for (Object& object : other.objects) object.mesh = shuffled(*object.mesh, random);
        std::shuffle(other.objects.begin(), other.objects.end(), random);
        const FramePtr a = test::frameOf(scene, test::everyBuffer(), 1);
        const FramePtr b = test::frameOf(other, test::everyBuffer(), 1);
        const auto same = [&](glm::ivec2 pixel) {
            for (const BufferId id : kCompared) {
                const AnyBuffer x = *a->buffer({id}), y = *b->buffer({id});
                for (int c = 0; c < x.channels(); ++c)
                    if (x.value(std::size_t(pixel.x), std::size_t(pixel.y), c) !=
                        y.value(std::size_t(pixel.x), std::size_t(pixel.y), c))
                        return false;
            }
            return true;
        };
        const AnyBuffer seen = *a->buffer({BufferId::ObjectId});
        for (int y = 0; y < scene.settings.height; ++y)
            for (int x = 0; x < scene.settings.width; ++x) {
                covered += seen.value(std::size_t(x), std::size_t(y)) >= 0;
                if (same({x, y})) continue;
                ASSERT_TRUE(hasTie(*a, {x, y})) << "seed " << seed << " at " << x << ' ' << y;
                ++tied;
            }
    }
    EXPECT_GT(covered, 10000u);
    EXPECT_LT(tied, covered / 8);  // 16 bits of depth, and polygons of which one lies in the other
}

// A vertex normal is a sum of m unit normals, made unit. Added in another order, two sums differ by at most
// 2 (m - 1) u m in each component (u half the spacing at 1; partial sums are at most m), in length by 2 √3 m² u; made
// unit by that over the sum's length s, and by 2 u from either side: at most (4 m² / s + 4) u.
TEST_P(MetamorphicOrder, VertexNormalsOfPolygonsInAnotherOrder) {
    constexpr double u = 0x1p-53;
    std::size_t compared = 0;
    for (unsigned seed = GetParam(); seed < kScenes; seed += kShards) {
        std::mt19937 random(seed);
        Scene scene = test::smallScene(seed);
        scene.settings.precision = Precision::Double;
        scene.settings.normalWeight = NormalWeight::Mean;
        const BufferSet wanted = setOf({BufferId::VerticesNormal, BufferId::PolygonsNormal});
        const FramePtr a = test::frameOf(scene, wanted, 1);
        Scene other = scene;
        for (Object& object : other.objects) object.mesh = shuffled(*object.mesh, random);
        const FramePtr b = test::frameOf(other, wanted, 1);
        const AnyBuffer n = *a->buffer({BufferId::VerticesNormal}), m = *b->buffer({BufferId::VerticesNormal});
        const AnyBuffer polygons = *a->buffer({BufferId::PolygonsNormal});
        std::vector<Vec3d> sum(n.count() / 3, Vec3d(0));
        std::vector<double> count(n.count() / 3, 0);
        const Topology& topology = a->topology();
        for (std::size_t p = 0; p < topology.polygonCount(); ++p)
            for (std::size_t i = 0; i < topology.corners(p).size(); ++i) {
                const std::uint32_t v = topology.corners(p)[i];
                sum[v] += Vec3d(polygons.flat(3 * p), polygons.flat(3 * p + 1), polygons.flat(3 * p + 2));
                ++count[v];
            }
        for (std::size_t v = 0; v < sum.size(); ++v) {
            const double s = glm::length(sum[v]);
            if (!(s > 1e-6)) continue;  // a sum that vanishes has no direction of its own
            const Vec3d difference{n.flat(3 * v) - m.flat(3 * v), n.flat(3 * v + 1) - m.flat(3 * v + 1),
                                   n.flat(3 * v + 2) - m.flat(3 * v + 2)};
            ASSERT_LE(glm::length(difference), (4 * count[v] * count[v] / s + 4) * u) << "seed " << seed;
            ++compared;
        }
    }
    EXPECT_GT(compared, 1000u);
}

// Tiles and ranges are handed to threads in an order that differs from run to run.
TEST_P(MetamorphicOrder, OnAnyNumberOfThreads) {
    for (unsigned seed = GetParam(); seed < kScenes; seed += kShards) {
        Scene scene = test::smallScene(seed);
        // Several tiles; every twentieth has so many that threads wake in time for their share.
        scene.settings.width += 2 * 64;
        if (seed / kShards % 20 == 0) scene.settings.width = 500, scene.settings.height = 300;
        scene.settings.visibility = seed % 5 == 0 ? Visibility::Painter : Visibility::ZBuffer;
        const BufferSet wanted = seed % 4 == 0 ? test::everyBuffer() : setOf({BufferId::Color, BufferId::Intensity});
        const FramePtr one = test::frameOf(scene, wanted, 1);
        for (const int threads : {2, 3, 5})
            ASSERT_EQ(test::firstDifference(*one, *test::frameOf(scene, wanted, threads), wanted), "")
                << "seed " << seed << ", " << threads << " threads";
    }
}

// A buffer holds doubles: what long double and 128 bits give differs there by one unit in the last place at most, and only
// where a number lies at the edge between two of them, as long as long double's own error is smaller. A depth passes about
// 30 roundings of lengths up to the scene's extent, 25 here: 2^-64 · 30 · 25 < 2^-54, and depths are 1 or more. An
// intensity has in V that error; the power makes n times dq of it, q = |R - V|²/2, dq = 2^-54 |R - V|, where only
// |R - V| < √(90 / n) counts: below √(90 n) 2^-54 <= 2^-40 for n <= 10^6; and normals that interpolation has shortened
// make it larger. So nearly all are within 2^-40 of what the lights can give.
TEST_P(MetamorphicOrder, ExtendedAndQuadAgree) {
    std::size_t covered = 0, differ = 0, brighter = 0;
    for (unsigned seed = GetParam(); seed < kScenes; seed += kShards) {
        Scene scene = test::smallScene(seed);
        scene.settings.width = 9, scene.settings.height = 7;
        scene.settings.depthFormat = DepthFormat::Linear;
        scene.camera.near = 1, scene.camera.far = 40;
        double brightest = 1 + scene.ambient.intensityIn(scene.settings.model);
        for (Light& light : scene.lights) {
            light.castsShadow = false, light.kind = LightKind::AtInfinity;
            brightest += 2 * light.intensity;
        }
        const BufferSet wanted = setOf({BufferId::ZView, BufferId::Intensity, BufferId::PolygonId});
        scene.settings.precision = Precision::Extended;
        const FramePtr extended = test::frameOf(scene, wanted, 1);
        scene.settings.precision = Precision::Quad;
        const FramePtr quad = test::frameOf(scene, wanted, 1);
        ASSERT_EQ(test::firstDifference(*extended, *quad, setOf({BufferId::PolygonId})), "") << "seed " << seed;
        const AnyBuffer a = *extended->buffer({BufferId::ZView}), b = *quad->buffer({BufferId::ZView});
        const AnyBuffer i = *extended->buffer({BufferId::Intensity}), j = *quad->buffer({BufferId::Intensity});
        for (std::size_t k = 0; k < a.count(); ++k) {
            if (!std::isfinite(a.flat(k))) continue;
            ++covered;
            differ += a.flat(k) != b.flat(k);
            ASSERT_LE(std::abs(a.flat(k) - b.flat(k)), 0x1p-52 * a.flat(k)) << "seed " << seed;
            for (std::size_t c = 3 * k; c < 3 * k + 3; ++c)
                brighter += std::abs(i.flat(c) - j.flat(c)) > 0x1p-40 * brightest;
        }
    }
    EXPECT_GT(covered, 500u);
    EXPECT_LT(differ, covered / 50);
    EXPECT_LT(brighter, covered / 500);
}

}  // namespace
}  // namespace pipeline
