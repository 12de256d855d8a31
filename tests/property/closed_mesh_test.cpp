// A thousand closed meshes, bent at random: no hole and no overlap. A ray that enters a closed surface leaves it again, so
// with culling off every sample has as many fragments of fronts as of backs; whatever bends the mesh, also through itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pipeline/stages/clip.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

struct ClosedMesh : testing::TestWithParam<unsigned> {
    static constexpr unsigned kMeshes = 1000, kShards = 10;
};
INSTANTIATE_TEST_SUITE_P(Shards, ClosedMesh, testing::Range(0u, ClosedMesh::kShards));

double between(std::mt19937& random, double low, double high) {
    return low + (high - low) * double(random()) / double(std::mt19937::max());
}
Vec3d inBox(std::mt19937& random, double half) {
    return {between(random, -half, half), between(random, -half, half), between(random, -half, half)};
}

// Polygons as triangles: a bent quadrilateral shows its front and its back at once, a triangle one of them.
std::shared_ptr<const Mesh> inTriangles(const Mesh& mesh, std::vector<Vec3d> positions) {
    std::vector<std::vector<std::uint32_t>> triangles;
    for (const Triangle& t : mesh.triangles) triangles.push_back({t.vertices[0], t.vertices[1], t.vertices[2]});
    return test::mesh(std::move(positions), std::move(triangles));
}

// A torus around z with a tube of radius 0.4 on a ring of radius 1.
std::shared_ptr<const Mesh> torus(int around, int along) {
    constexpr double kTurn = 6.283185307179586;
    std::vector<Vec3d> positions;
    std::vector<std::vector<std::uint32_t>> quads;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < along; ++j) {
            const double u = kTurn * i / around, v = kTurn * j / along, r = 1 + 0.4 * std::cos(v);
            positions.push_back({r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v)});
            const auto at = [&](int a, int b) { return std::uint32_t(a % around * along + b % along); };
            quads.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return test::mesh(std::move(positions), std::move(quads));
}

// A sphere, a box (a sphere pushed out onto it) or a torus, each vertex moved by up to `bend`.
std::shared_ptr<const Mesh> closedMesh(std::mt19937& random, double bend, bool fine) {
    const int a = 3 + int(random() % (fine ? 60 : 9)), b = 3 + int(random() % (fine ? 60 : 12));
    const auto kind = random() % 3;
    const auto whole = kind == 2 ? torus(a, b) : test::sphere(1, a, b);
    std::vector<Vec3d> positions = whole->positions.copy();
    for (Vec3d& p : positions) {
        if (kind == 1) p /= std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        p += inBox(random, bend);
    }
    return inTriangles(*whole, std::move(positions));
}

Scene sceneOf(std::shared_ptr<const Mesh> mesh, unsigned seed, std::mt19937& random) {
    Scene scene;
    scene.settings.width = 48 + int(random() % 40), scene.settings.height = 40 + int(random() % 30);
    scene.settings.precision = seed % 2 ? Precision::Float : Precision::Double;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, 0, 0}, scene.camera.target = {0, 1, 0};
    if (seed % 5 == 0) scene.camera.projection = ProjectionKind::Orthographic;
    Object object{"mesh", std::move(mesh), {}, {}};
    object.transform.rotation = inBox(random, 180);
    object.transform.scale = {between(random, 0.3, 1.5), between(random, 0.3, 1.5), between(random, 0.3, 1.5)};
    for (int axis = 0; axis < 3; ++axis)
        if (random() % 2) object.transform.scale[axis] *= -1;
    scene.objects = {object};
    return scene;
}

struct Fragments {
    std::vector<int> fronts, backs;  // per sample
};

Fragments fragmentsOf(Scene scene) {
    const auto counted = [&](CullMode cull) {
        scene.settings.cull = cull;
        FrameRequest request;
        request.wanted = setOf({BufferId::Overdraw});
        request.until = StageId::ZBuffer;
        request.threads = 1;
        const FramePtr frame = runFrame(std::make_shared<const Scene>(scene), request, {});
        const AnyBuffer overdraw = *frame->buffer({BufferId::Overdraw});
        std::vector<int> counts(overdraw.count());
        for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = int(overdraw.flat(i));
        return counts;
    };
    Fragments out{counted(CullMode::Back), counted(CullMode::None)};
    for (std::size_t i = 0; i < out.backs.size(); ++i) out.backs[i] -= out.fronts[i];
    return out;
}

// In front of the eye; every sixth of them runs far beyond the guard band at 2^20 pixels, every sixth is of polygons
// much smaller than a pixel.
TEST_P(ClosedMesh, FromOutsideHasAsManyFrontsAsBacks) {
    std::size_t covered = 0;
    for (unsigned seed = GetParam(); seed < kMeshes; seed += kShards) {
        std::mt19937 random(seed);
        const bool fine = seed % 6 == 1, huge = seed % 6 == 2;
        const double bend = between(random, 0, 0.4);
        const auto mesh = closedMesh(random, bend, fine);
        Scene scene = sceneOf(mesh, seed, random);
        ObjectTransform& t = scene.objects[0].transform;
        t.translation = {between(random, -0.5, 0.5), between(random, 4, 7), between(random, -0.5, 0.5)};
        if (fine) t.scale *= 0.3;
        if (huge) {
            t.rotation = {0, 0, 0};
            t.scale.x *= std::exp2(between(random, 15, 40));
            if (random() % 2) t.scale.z *= std::exp2(between(random, 15, 40));
        }
        const Fragments f = fragmentsOf(scene);
        for (std::size_t i = 0; i < f.fronts.size(); ++i) {
            ASSERT_EQ(f.fronts[i], f.backs[i]) << "seed " << seed << " sample " << i;
            covered += f.fronts[i] > 0;
        }
    }
    EXPECT_GT(covered, 5000u);
}

// From inside, with the eye where no vertex comes near: one more back than fronts at every sample.
TEST_P(ClosedMesh, FromInsideCoversThePicture) {
    for (unsigned seed = GetParam(); seed < kMeshes; seed += kShards) {
        std::mt19937 random(seed);
        const int rings = 3 + int(random() % 9), segments = 4 + int(random() % 20);
        const auto ball = test::sphere(1, rings, segments);
        std::vector<Vec3d> positions = ball->positions.copy();
        const bool spiky = seed % 3 == 0;
        for (Vec3d& p : positions) p *= spiky ? std::exp2(between(random, 0, 30)) : between(random, 1, 1.6);
        Scene scene = sceneOf(inTriangles(*ball, std::move(positions)), seed, random);
        scene.camera.projection = ProjectionKind::Perspective;
        scene.camera.near = 0x1p-20, scene.camera.far = 0x1p40;
        scene.camera.fovY = between(random, 20, 120);
        const Fragments f = fragmentsOf(scene);
        for (std::size_t i = 0; i < f.fronts.size(); ++i)
            ASSERT_EQ(f.backs[i], f.fronts[i] + 1) << "seed " << seed << " sample " << i;
    }
}

// Cut in two by a plane across the view, once as the far and once as the near plane: what one half leaves open at a
// sample, the other does too, the other way round.
TEST_P(ClosedMesh, CutInTwoClosesAgain) {
    std::size_t open = 0;
    for (unsigned seed = GetParam(); seed < kMeshes; seed += kShards) {
        std::mt19937 random(seed);
        const double bend = between(random, 0, 0.3);
        const auto mesh = closedMesh(random, bend, seed % 6 == 1);
        Scene scene = sceneOf(mesh, seed, random);
        scene.objects[0].transform.translation = {0, 4, 0};
        const double cut = between(random, 3.4, 4.6);
        scene.camera.near = 0.5, scene.camera.far = cut;
        const Fragments before = fragmentsOf(scene);
        scene.camera.near = cut, scene.camera.far = 20;
        const Fragments behind = fragmentsOf(scene);
        for (std::size_t i = 0; i < before.fronts.size(); ++i) {
            ASSERT_EQ(before.fronts[i] - before.backs[i], behind.backs[i] - behind.fronts[i])
                << "seed " << seed << " sample " << i;
            open += before.fronts[i] != before.backs[i];
        }
    }
    EXPECT_GT(open, 1000u);
}

// What keeps two neighbours together where they are cut, also where no sample would tell: the corners on their common
// edge, which one has from p to q and the other from q to p, are the same numbers.
TEST(ClippedEdge, IsCutAtOnePointFromEitherSide) {
    std::mt19937 random(11);
    View view;
    view.size = {64, 64}, view.centre = {32, 32}, view.scale = {77, 77};
    view.near = 1, view.far = 10;
    const auto point = [&] {
        const double wide = random() % 4 == 0 ? std::exp2(between(random, 10, 30)) : 3;
        return inBox(random, wide) + Vec3d(0, 0, between(random, -2, 12));
    };
    // Of a triangle's corners after clipping those in which its third corner has no weight: the ends of the edge.
    const auto endsOfEdge = [&](Vec3d a, Vec3d b, Vec3d c) {
        const ClippedTriangle<double> t = clipTriangle<double>(view, {a, b, c});
        std::vector<std::array<double, 3>> ends;
        for (std::size_t i = 0; i < t.count; ++i)
            if (t.corners[i].weights.z == 0)
                ends.push_back({t.corners[i].view.x, t.corners[i].view.y, t.corners[i].view.z});
        std::ranges::sort(ends);
        return ends;
    };
    int cut = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3d p = point(), q = point();
        const auto one = endsOfEdge(p, q, point()), other = endsOfEdge(q, p, point());
        if (one.empty() || other.empty()) continue;  // all of that triangle lies outside one plane
        ASSERT_EQ(one, other) << i;
        cut += one.front() != std::array{p.x, p.y, p.z} && one.front() != std::array{q.x, q.y, q.z};
    }
    EXPECT_GT(cut, 2000);
}

}  // namespace
}  // namespace pipeline
