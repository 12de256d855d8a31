// A mesh of triangles alone is held otherwise than one with a quadrilateral in it: the same with one appended must
// agree in what both have.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/support/scenes.h"

namespace pipeline {
namespace {

struct TrianglesAlone : testing::TestWithParam<unsigned> {
    static constexpr unsigned kScenes = 200, kShards = 10;
};
INSTANTIATE_TEST_SUITE_P(Shards, TrianglesAlone, testing::Range(0u, TrianglesAlone::kShards));

// A mesh whose polygons are the triangles of another one; a quadrilateral with four corners in one place, which has no
// area and is never drawn, after them.
std::shared_ptr<const Mesh> inTriangles(const Mesh& mesh, bool withQuad) {
    Mesh out;
    out.positions = mesh.positions;
    for (const Triangle& triangle : mesh.triangles) out.addPolygon(triangle.vertices);
    if (withQuad) {
        const auto first = std::uint32_t(out.positions.size());
        for (int i = 0; i < 4; ++i) out.positions.push_back(mesh.positions[0]);
        out.addPolygon(std::array{first, first + 1, first + 2, first + 3});
    }
    return makeMesh(std::move(out));
}

TEST_P(TrianglesAlone, HaveThePolygonsThatTheyHaveBesideAQuadrilateral) {
    for (unsigned seed = GetParam(); seed < kScenes; seed += kShards)
        for (const Object& object : test::randomScene(seed).objects) {
            const auto alone = inTriangles(*object.mesh, false), beside = inTriangles(*object.mesh, true);
            ASSERT_TRUE(alone->hasTrianglesAlone());
            ASSERT_FALSE(beside->hasTrianglesAlone());
            const std::size_t count = object.mesh->triangles.size();
            ASSERT_EQ(alone->polygonCount(), count);
            ASSERT_EQ(beside->polygonCount(), count + 1);
            EXPECT_EQ(alone->cornerCount() + 4, beside->cornerCount());
            EXPECT_EQ(alone->facts.degenerate + 1, beside->facts.degenerate);
            EXPECT_EQ(alone->facts.low, beside->facts.low);
            EXPECT_EQ(alone->facts.high, beside->facts.high);
            for (std::size_t i = 0; i < count; ++i) {
                EXPECT_TRUE(std::ranges::equal(alone->polygon(i), beside->polygon(i)));
                EXPECT_EQ(alone->firstTriangleOf(i), beside->firstTriangleOf(i));
                EXPECT_EQ(alone->triangles[i], beside->triangles[i]);
            }
            EXPECT_EQ(alone->firstTriangleOf(count), beside->firstTriangleOf(count));
        }
}

// The last object alone is changed: what is counted over all objects stays the same before it. Facts of a mesh, as that
// it is closed, leave work out and change no buffer.
TEST_P(TrianglesAlone, AreDrawnAsBesideAQuadrilateral) {
    for (unsigned seed = GetParam(); seed < kScenes; seed += kShards) {
        Scene scene = test::randomScene(seed);
        std::shared_ptr<const Mesh>& mesh = scene.objects.back().mesh;
        const std::shared_ptr<const Mesh> plain = mesh;
        mesh = inTriangles(*plain, false);
        const FramePtr alone = test::frameOf(scene, test::everyBuffer(), 1);
        mesh = inTriangles(*plain, true);
        const FramePtr beside = test::frameOf(scene, test::everyBuffer(), 1);
        for (const AnyBuffer& a : alone->buffers()) {
            const auto b = beside->buffer(a.name);
            ASSERT_TRUE(b) << seed << ": " << a.name.text();
            ASSERT_LE(a.count(), b->count()) << seed << ": " << a.name.text();
            for (std::size_t i = 0; i < a.count(); ++i) {
                const double x = a.flat(i), y = b->flat(i);
                ASSERT_TRUE(x == y || (x != x && y != y)) << seed << ": " << a.name.text() << " number " << i;
            }
        }
    }
}

}  // namespace
}  // namespace pipeline
