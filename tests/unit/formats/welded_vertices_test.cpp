#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "pipeline/formats/welded_vertices.h"

namespace pipeline {
namespace {

// A map of the numbers themselves says which vertices are equal: a reference that shares nothing with a set of numbers
// of vertices. So many that the set grows several times.
TEST(WeldedVertices, AreThoseOfAMapByValue) {
    for (const bool byNormal : {false, true}) {
        std::mt19937 random(1);
        std::uniform_int_distribution<int> small(-12, 12);
        Mesh mesh;
        WeldedVertices vertices(mesh, byNormal);
        std::map<std::array<double, 6>, std::uint32_t> expected;
        for (int i = 0; i < 100'000; ++i) {
            const int x = small(random), y = small(random), z = small(random);
            const Vec3d position = Vec3d(x, y, z) / 3.0;
            const Vec3d normal = byNormal ? Vec3d(0, 0, small(random) % 2) : Vec3d(0.0);
            const auto next = static_cast<std::uint32_t>(expected.size());
            const auto [place, isNew] =
                expected.try_emplace({position.x, position.y, position.z, normal.x, normal.y, normal.z}, next);
            ASSERT_EQ(vertices.at(position, normal), place->second);
        }
        ASSERT_EQ(mesh.positions.size(), expected.size());
        EXPECT_EQ(mesh.normals.size(), byNormal ? expected.size() : 0);
        for (const auto& [key, number] : expected) {
            EXPECT_EQ(mesh.positions[number], Vec3d(key[0], key[1], key[2]));
            if (byNormal) {
                EXPECT_EQ(mesh.normals[number], Vec3d(key[3], key[4], key[5]));
            }
        }
    }
}

// Numbers that differ in their last bit are two, though the mesh keeps its first vertices in float.
TEST(WeldedVertices, AreToldApartByTheirLastBit) {
    Mesh mesh;
    WeldedVertices vertices(mesh, false);
    const double next = 1 + std::numeric_limits<double>::epsilon();
    EXPECT_EQ(vertices.at(Vec3d(1, 0, 0)), 0);
    EXPECT_EQ(vertices.at(Vec3d(next, 0, 0)), 1);
    EXPECT_EQ(vertices.at(Vec3d(1, 0, 0)), 0);
    EXPECT_EQ(vertices.at(Vec3d(next, 0, 0)), 1);
    EXPECT_EQ(vertices.at(Vec3d(1, -0.0, 0)), 0);
    EXPECT_EQ(vertices.at(Vec3d(-0.0)), 2);
    EXPECT_EQ(vertices.at(Vec3d(0.0)), 2);
    EXPECT_FALSE(std::signbit(mesh.positions[2].x)) << "-0 becomes 0";
}

TEST(WeldedVertices, OfAnotherMeshBeginAnew) {
    Mesh mesh;
    WeldedVertices vertices(mesh, false);
    EXPECT_EQ(vertices.at(Vec3d(1.0)), 0);
    EXPECT_EQ(vertices.at(Vec3d(2.0)), 1);
    vertices.clear(), mesh = {};
    EXPECT_EQ(vertices.at(Vec3d(2.0)), 0);
    EXPECT_EQ(mesh.positions.size(), 1);
}

}  // namespace
}  // namespace pipeline
