#include "pipeline/scene/mesh/vertex_vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/run/frame_data.h"
#include "pipeline/scene/mesh/shape.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

constexpr double kMostFloat = std::numeric_limits<float>::max(), kLeastFloat = std::numeric_limits<float>::denorm_min();

TEST(VertexVectors, WhatFloatHoldsTakesTwelveBytes) {
    // 0.5 + 2^-20 has 20 digits, of 24; the largest and the smallest float are floats.
    const VertexVectors of{{0.5 + 0x1p-20, -1, 3}, {kMostFloat, -kLeastFloat, 0}};
    EXPECT_EQ(of.bytes(), 2 * 12u);
    EXPECT_EQ(of.floats().size(), 2u);
    EXPECT_TRUE(of.doubles().empty());
    EXPECT_EQ(of[0], Vec3d(0.5 + 0x1p-20, -1, 3));
    EXPECT_EQ(of[1], Vec3d(kMostFloat, -kLeastFloat, 0));
}

TEST(VertexVectors, OneNumberThatFloatRoundsPutsAllInDouble) {
    // Of 25 digits, above the largest, below the smallest, and 0.1, which has no end in binary.
    for (const double rounded : {1 + 0x1p-24, 2 * kMostFloat, kLeastFloat / 2, 0.1})
        for (int axis = 0; axis < 3; ++axis) {
            Vec3d v(1.0);
            v[axis] = rounded;
            VertexVectors of{{1, 2, 3}};
            of.push_back(v);
            EXPECT_TRUE(of.floats().empty());
            EXPECT_EQ(of.doubles().size(), 2u);
            EXPECT_EQ(of.copy(), (std::vector<Vec3d>{{1, 2, 3}, v})) << rounded;
            VertexVectors changed{{1, 2, 3}, {4, 5, 6}};
            changed.set(0, v);
            EXPECT_EQ(changed.copy(), (std::vector<Vec3d>{v, {4, 5, 6}}));
        }
}

TEST(VertexVectors, SignOfZeroStays) {
    const VertexVectors of{{-0.0, 0.0, -0.0}};
    EXPECT_FALSE(of.floats().empty());
    EXPECT_TRUE(std::signbit(of[0].x) && !std::signbit(of[0].y) && std::signbit(of[0].z));
}

TEST(VertexVectors, WhatIsNoNumberStaysNone) {
    VertexVectors of{{1, 2, 3}};
    of.push_back(Vec3d(std::nan("")));
    EXPECT_TRUE(std::isnan(of[1].x) && of[0] == Vec3d(1, 2, 3));
}

TEST(VertexVectors, ShrinkingGoesBackToFloat) {
    VertexVectors of{{1, 2, 3}, {0.1, 0, 0}};
    of.resize(1);
    const VertexVectors narrow{{1, 2, 3}};
    EXPECT_EQ(of, narrow) << "the same vectors in another form";
    EXPECT_EQ(narrow, of);
    of.shrink_to_fit();
    EXPECT_EQ(of.bytes(), 12u);
    EXPECT_EQ(of, narrow);
    EXPECT_NE(of, (VertexVectors{{1, 2, 4}}));
    EXPECT_NE(of, (VertexVectors{{1, 2, 3}, {0.1, 0, 0}}));
}

TEST(VertexVectors, AreARangeOfValues) {
    static_assert(std::ranges::random_access_range<VertexVectors>);
    const VertexVectors of{{3, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    EXPECT_EQ((*std::ranges::min_element(of, {}, &Vec3d::x)), Vec3d(1, 0, 0));
    EXPECT_EQ(of.end() - of.begin(), 3);
    EXPECT_EQ(of.begin()[2], Vec3d(2, 0, 0));
    Vec3d sum(0.0);
    for (const Vec3d& v : of) sum += v;
    EXPECT_EQ(sum, Vec3d(6, 0, 0));
}

// A mesh is the same whichever way it came to its numbers.
TEST(VertexVectors, OfAMeshAreInFloatWhereTheyCanBe) {
    Mesh mesh;
    mesh.positions = {{0.1, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.positions.set(0, {0.5, 0, 0});
    mesh.addPolygon(std::array<std::uint32_t, 3>{0, 1, 2});
    EXPECT_EQ(makeMesh(mesh)->positions.floats().size(), 3u);
}

// Places and normals of a mesh whose numbers are floats, as the stages leave them: the vectors of pipeline/simd take either
// form as it stands, the stage's own text asks for one after the other.
TEST(VertexVectors, StagesGiveTheSameBitsFromFloatAndFromDouble) {
    Scene scene = test::spheres();
    scene.settings.normalWeight = NormalWeight::Given;
    scene.objects.resize(1);
    scene.objects[0].transform.rotation = {20, 30, 40};
    Mesh mesh = *makeShape({ShapeKind::Sphere, 8});
    const auto rounded = [](const VertexVectors& from) {
        VertexVectors out;
        for (const Vec3d& v : from) out.push_back(glm::vec3(v));
        return out;
    };
    mesh.positions = rounded(mesh.positions), mesh.normals = rounded(mesh.normals);
    // Those of another length than 1 are brought to it.
    for (std::size_t i = 0; i < mesh.normals.size(); i += 3) mesh.normals.set(i, 4.0 * mesh.normals[i]);
    const std::size_t count = mesh.positions.size();
    const auto leftBy = [&](std::size_t vertices) {
        scene.objects[0].mesh = makeMesh(mesh);
        const FramePtr frame = test::frameOf(scene, setOf({BufferId::Color}));
        const FrameData<float>& data = *dataOf<float>(*frame);
        TransformOutput<float> own = prepareTransform<float>(data.keys.transform);
        NormalsOutput<float> normals = prepareNormals(data.keys.normals, *data.transform);
        transform(data.keys.transform, 0, 0, vertices, own);
        unitVertexNormals(data.keys.normals, *data.transform, 0, 0, vertices, normals);
        EXPECT_EQ(data.transform->world, own.world);
        EXPECT_EQ(data.normals->vertex, normals.vertex);
        const auto first = [&](const VertexArray<float>& of) {
            return std::vector(of.begin(), of.begin() + std::ptrdiff_t(count));
        };
        return std::pair(first(own.world), first(normals.vertex));
    };
    ASSERT_FALSE(mesh.positions.floats().empty() || mesh.normals.floats().empty());
    const auto fromFloat = leftBy(count);
    // One more vertex that is no float, of no polygon, puts them all in double.
    mesh.positions.push_back(Vec3d(0.1)), mesh.normals.push_back(Vec3d(0.1));
    ASSERT_FALSE(mesh.positions.doubles().empty() || mesh.normals.doubles().empty());
    EXPECT_EQ(leftBy(count + 1), fromFloat);
}

}  // namespace
}  // namespace pipeline
