// Meshes of more vertices and triangles than are taken at once.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "pipeline/run/frame_data.h"
#include "pipeline/run/runner.h"
#include "pipeline/simd/set_up.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

// n × n vertices around z, in triangles; all numbers are floats. The last triangle is turned over where it is asked for.
Mesh torus(std::uint32_t n, bool turnsLast = false) {
    Mesh mesh;
    mesh.positions.reserve(std::size_t(n) * n), mesh.reservePolygons(std::size_t(2) * n * n, std::size_t(6) * n * n);
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < n; ++j) {
            const double u = 2 * std::numbers::pi * i / n, v = 2 * std::numbers::pi * j / n, r = 1 + 0.4 * std::cos(v);
            mesh.positions.push_back(glm::vec3(r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v)));
        }
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return i % n * n + j % n; };
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < n; ++j) {
            mesh.addPolygon(std::array{at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            const bool turns = turnsLast && i + 1 == n && j + 1 == n;
            mesh.addPolygon(turns ? std::array{at(i, j), at(i, j + 1), at(i + 1, j + 1)}
                                  : std::array{at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return mesh;
}

// n × n vertices of a sheet with waves, in triangles, row after row.
Mesh sheet(std::uint32_t n) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < n; ++j)
            mesh.positions.push_back(glm::vec3(2.0 * i / n - 1, 2.0 * j / n - 1, 0.3 * std::sin(20.0 * i * j / n / n)));
    for (std::uint32_t i = 0; i + 1 < n; ++i)
        for (std::uint32_t j = 0; j + 1 < n; ++j) {
            const std::uint32_t at = i * n + j;
            mesh.addPolygon(std::array{at, at + n, at + n + 1});
            mesh.addPolygon(std::array{at, at + n + 1, at + 1});
        }
    return mesh;
}

// 1025² vertices are more than 2^20. The last triangle's edges leave vertices of the first ones and of the last.
TEST(LargeMesh, IsClosedUnlessOneTriangleIsTurnedOver) {
    EXPECT_TRUE(makeMesh(torus(1025))->facts.closed);
    EXPECT_FALSE(makeMesh(torus(1025, true))->facts.closed);
}

TEST(LargeMesh, KnowsTheVerticesOfItsTriangles) {
    Scene scene;
    for (const std::uint32_t n : {3u, 70u, 5u}) {
        scene.objects.push_back({"torus", makeMesh(torus(n)), {}, {}});
        scene.objects.push_back({"nothing", std::make_shared<const Mesh>(), {}, {}});
    }
    const Topology topology = makeTopology(meshesOf(scene));
    const std::size_t count = topology.triangles.size();
    for (const auto& [begin, end] : {std::pair<std::size_t, std::size_t>{0, count},
                                     {0, 1},
                                     {17, 19},
                                     {18, 1030},
                                     {1024, 2048},
                                     {9000, count},
                                     {count - 1, count},
                                     {5, 5}}) {
        const VertexRange range = topology.verticesOf(begin, end);
        for (std::size_t t = begin; t < end; ++t)
            for (const std::uint32_t vertex : topology.triangles[t].vertices)
                ASSERT_TRUE(vertex >= range.first && vertex < range.last) << t;
        EXPECT_LE(range.last, topology.vertexCount());
    }
}

// Whether a light's vertices are snapped piece by piece or all at once, before: where neighbours stand far apart in the
// list.
void expectTheSameShadowInAnyOrder(const Mesh& inOrder) {
    Scene scene;
    scene.settings.width = scene.settings.height = 32, scene.settings.shadowSize = 256;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {1, 2, 5};
    scene.lights.push_back({LightKind::AtInfinity, {1, 2, 3}, 1, Vec3d(1), true});
    const auto frameOf = [&](Mesh mesh) {
        scene.objects = {{"object", makeMesh(std::move(mesh)), {}, {Vec3d(0.5), Vec3d(0.4), 9}}};
        return test::frameOf(scene, setOf({BufferId::ShadowBuffer}));
    };
    const auto snaps = [](const Frame& frame) {
        const FrameData<float>& data = *dataOf<float>(frame);
        const TransformOutput<float>& in = *data.transform;
        const SetUpInputs setUp{*in.topology, in.view, in.world, nullptr};
        return snapsSeldom(setUp, prepareSetUp(setUp));
    };
    std::vector<std::uint32_t> number(inOrder.positions.size());
    std::iota(number.begin(), number.end(), 0u);
    std::mt19937 random(7);
    for (std::size_t i = number.size(); i-- > 1;) std::swap(number[i], number[random() % (i + 1)]);
    Mesh shuffled = inOrder;
    shuffled.renumberVertices(number);
    for (std::size_t i = 0; i < number.size(); ++i) shuffled.positions.set(number[i], inOrder.positions[i]);
    const FramePtr one = frameOf(inOrder), other = frameOf(shuffled);
    EXPECT_TRUE(snaps(*one));
    EXPECT_FALSE(snaps(*other));
    const auto a = one->buffer({BufferId::ShadowBuffer, 0}), b = other->buffer({BufferId::ShadowBuffer, 0});
    ASSERT_TRUE(a && b);
    ASSERT_EQ(a->shape, b->shape);
    std::size_t covered = 0;
    for (std::size_t i = 0; i < a->count(); ++i) {
        ASSERT_EQ(a->flat(i), b->flat(i)) << i;
        covered += std::isfinite(a->flat(i));
    }
    EXPECT_GT(covered, 10'000u);
}

// 725² · 2 triangles are more than 32 pieces of 2^15, of which each is taken in two parts.
TEST(LargeMesh, ThrowsTheSameShadowWhateverTheOrderOfItsVertices) { expectTheSameShadowInAnyOrder(torus(725)); }

// Its last triangles fill no vector, for 299² · 2 is no multiple of 16, and ask for none of the first vertices: what stands
// beside them in their vector must not, either.
TEST(LargeMesh, ThrowsTheShadowOfItsLastTriangles) { expectTheSameShadowInAnyOrder(sheet(300)); }

}  // namespace
}  // namespace pipeline
