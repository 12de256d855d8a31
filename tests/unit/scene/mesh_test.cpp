#include "pipeline/scene/mesh/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "pipeline/scene/mesh/make_mesh.h"
#include "pipeline/scene/mesh/topology.h"
#include "tests/support/looks.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

using Polygons = std::vector<std::vector<std::uint32_t>>;

Mesh rawMesh(VertexVectors positions, const Polygons& polygons) {
    Mesh mesh;
    mesh.positions = std::move(positions);
    for (const std::vector<std::uint32_t>& polygon : polygons) mesh.addPolygon(polygon);
    return mesh;
}

Polygons polygonsOf(const Mesh& mesh) {
    Polygons polygons;
    for (std::size_t i = 0; i < mesh.polygonCount(); ++i)
        polygons.emplace_back(mesh.polygon(i).begin(), mesh.polygon(i).end());
    return polygons;
}

// One polygon through all positions in order.
Mesh rawPolygon(std::vector<Vec3d> positions) {
    std::vector<std::uint32_t> polygon(positions.size());
    for (std::size_t i = 0; i < polygon.size(); ++i) polygon[i] = static_cast<std::uint32_t>(i);
    return rawMesh(std::move(positions), {polygon});
}

Mesh rawBox(Vec3d low, Vec3d high) {
    std::vector<Vec3d> positions;
    for (int i = 0; i < 8; ++i)
        positions.emplace_back(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
    return rawMesh(positions, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

Mesh rawPyramid() {  // lecture 1
    return rawMesh({{0, 0, 0}, {150, 0, 0}, {150, 150, 0}, {0, 150, 0}, {75, 75, 150}},
                   {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 4, 3}, {0, 3, 2, 1}});
}

Vec3d doubledArea(const Mesh& mesh, const Triangle& triangle) {
    const Vec3d& a = mesh.positions[triangle.vertices[0]];
    return glm::cross(mesh.positions[triangle.vertices[1]] - a, mesh.positions[triangle.vertices[2]] - a);
}

// The area of the triangles, and of those that face against `up`: a triangulation without
// overlap has the polygon's area in the first and nothing in the second.
struct Areas {
    double all = 0, reversed = 0;
};
Areas triangleAreas(const Mesh& mesh, Vec3d up) {
    Areas areas;
    for (const Triangle& triangle : mesh.triangles) {
        const double area = glm::dot(doubledArea(mesh, triangle), up) / 2;
        areas.all += std::abs(area);
        if (area < 0) areas.reversed -= area;
    }
    return areas;
}

// A star with teeth of random length around the z axis: concave at nearly every second corner.
std::vector<Vec3d> star(std::size_t corners, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> radius(1, 10);
    std::vector<Vec3d> points;
    for (std::size_t i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
        const double r = radius(random);
        points.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
    }
    return points;
}

double shoelace(const std::vector<Vec3d>& points) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3d &a = points[i], &b = points[(i + 1) % points.size()];
        sum += a.x * b.y - a.y * b.x;
    }
    return sum / 2;
}

TEST(Mesh, PyramidOfLectureOneIsClosedAndConvex) {
    const auto mesh = makeMesh(rawPyramid());
    EXPECT_TRUE(mesh->facts.closed);
    EXPECT_TRUE(mesh->facts.convex);
    EXPECT_EQ(mesh->facts.nonPlanar + mesh->facts.concave + mesh->facts.degenerate, 0);
    // Four triangles and a base of four vertices, split by a fan from its first vertex.
    ASSERT_EQ(mesh->triangles.size(), 6u);
    EXPECT_EQ(mesh->firstTriangle, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 6}));
    const Triangle& last = mesh->triangles[5];
    EXPECT_EQ(std::vector(last.vertices, last.vertices + 3), (std::vector<std::uint32_t>{0, 2, 1}));
    EXPECT_EQ(mesh->polygonOf(5), 4u);
}

TEST(Mesh, MissingFaceOpensIt) {
    Polygons polygons = polygonsOf(rawPyramid());
    polygons.pop_back();
    const auto open = makeMesh(rawMesh(rawPyramid().positions, polygons));
    EXPECT_FALSE(open->facts.closed);
    EXPECT_FALSE(open->facts.convex);
}

TEST(Mesh, FaceTurnedInsideOutOpensIt) {
    Polygons polygons = polygonsOf(rawPyramid());
    std::swap(polygons[0][0], polygons[0][1]);
    EXPECT_FALSE(makeMesh(rawMesh(rawPyramid().positions, polygons))->facts.closed);
}

TEST(Mesh, MeshInsideOutIsClosedButNotConvex) {
    Polygons polygons = polygonsOf(rawPyramid());
    for (std::vector<std::uint32_t>& polygon : polygons) std::ranges::reverse(polygon);
    const auto insideOut = makeMesh(rawMesh(rawPyramid().positions, polygons));
    EXPECT_TRUE(insideOut->facts.closed);
    EXPECT_FALSE(insideOut->facts.convex);
}

TEST(Mesh, TwoBoxesInOneMeshAreNotConvex) {
    Mesh mesh = rawBox(Vec3d(0), Vec3d(1));
    const Mesh other = rawBox(Vec3d(3), Vec3d(4));
    for (std::vector<std::uint32_t>& polygon : polygonsOf(other)) {
        for (std::uint32_t& corner : polygon) corner += 8;
        mesh.addPolygon(polygon);
    }
    for (const Vec3d& p : other.positions) mesh.positions.push_back(p);
    const auto boxes = makeMesh(std::move(mesh));
    EXPECT_TRUE(boxes->facts.closed);
    EXPECT_FALSE(boxes->facts.convex);
}

TEST(Mesh, DentIsNotConvexHoweverShallow) {
    // A box whose top has its middle raised (convex) or lowered (not convex) by 1e-9 of its side.
    for (const double dent : {1e-9, -1e-9}) {
        const auto mesh = makeMesh(rawMesh({{0, 0, 0},
                                            {1, 0, 0},
                                            {1, 1, 0},
                                            {0, 1, 0},
                                            {0, 0, 1},
                                            {1, 0, 1},
                                            {1, 1, 1},
                                            {0, 1, 1},
                                            {0.5, 0.5, 1 + dent}},
                                           {{0, 3, 2, 1},
                                            {0, 1, 5, 4},
                                            {1, 2, 6, 5},
                                            {2, 3, 7, 6},
                                            {3, 0, 4, 7},
                                            {4, 5, 8},
                                            {5, 6, 8},
                                            {6, 7, 8},
                                            {7, 4, 8}}));
        EXPECT_TRUE(mesh->facts.closed);
        EXPECT_EQ(mesh->facts.convex, dent > 0) << dent;
    }
}

TEST(Mesh, TurnedBoxStaysConvexThoughItsCornersAreRounded) {
    Mesh mesh = rawBox({-1, -2, -3}, {1, 2, 3});
    const double c = std::cos(0.7), s = std::sin(0.7);
    test::moveVertices(mesh, [&](Vec3d p) { return Vec3d(c * p.x - s * p.y + 100, s * p.x + c * p.y, p.z); });
    test::moveVertices(mesh, [&](Vec3d p) { return Vec3d(p.x, c * p.y - s * p.z, s * p.y + c * p.z - 1000); });
    EXPECT_TRUE(makeMesh(std::move(mesh))->facts.convex);
}

TEST(Mesh, ConvexityIsGivenUpForLargeMeshes) {
    // A prism with 1500 sides: 3000 vertices, 1502 polygons, 4.5 million pairs.
    const std::uint32_t n = 1500;
    std::vector<Vec3d> positions;
    Polygons polygons(2);
    for (const double z : {0.0, 1.0})
        for (std::uint32_t i = 0; i < n; ++i)
            positions.emplace_back(std::cos(2 * std::numbers::pi * i / n), std::sin(2 * std::numbers::pi * i / n), z);
    for (std::uint32_t i = 0; i < n; ++i) {
        polygons[0].push_back(n - 1 - i);
        polygons[1].push_back(n + i);
        polygons.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
    }
    const auto prism = makeMesh(rawMesh(positions, polygons));
    EXPECT_TRUE(prism->facts.closed);
    EXPECT_EQ(prism->facts.concave, 0);
    EXPECT_FALSE(prism->facts.convex);
}

// A notch that a fan would cover: 4 x 4 less a triangle of base 4 and height 3, 16 - 6 = 10.
TEST(Mesh, ConcavePolygonKeepsItsNotch) {
    const std::vector<Vec2<double>> outline{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}};
    for (int axis = 0; axis < 3; ++axis)
        for (const bool reversed : {false, true}) {
            std::vector<Vec3d> points;
            for (const Vec2<double>& p : outline) {
                Vec3d q{0.0};
                q[(axis + 1) % 3] = p.x;
                q[(axis + 2) % 3] = p.y;
                q[axis] = 7;
                points.push_back(q);
            }
            if (reversed) std::reverse(points.begin(), points.end());
            Vec3d up{0.0};
            up[axis] = reversed ? -1 : 1;
            const auto mesh = makeMesh(rawPolygon(points));
            EXPECT_EQ(mesh->facts.concave, 1);
            EXPECT_EQ(mesh->facts.nonPlanar, 0);
            EXPECT_EQ(mesh->triangles.size(), 3u);
            EXPECT_EQ(triangleAreas(*mesh, up).all, 10);
            EXPECT_EQ(triangleAreas(*mesh, up).reversed, 0);
        }
}

TEST(Mesh, StarsAreCoveredOnce) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        const std::vector<Vec3d> points = star(5 + seed, seed);
        const auto mesh = makeMesh(rawPolygon(points));
        const Areas areas = triangleAreas(*mesh, {0, 0, 1});
        EXPECT_EQ(mesh->triangles.size(), points.size() - 2);
        EXPECT_NEAR(areas.all, shoelace(points), 1e-11) << "seed " << seed;
        EXPECT_LE(areas.reversed, 1e-12) << "seed " << seed;
    }
}

TEST(Mesh, HoleWithABridgeStaysOpen) {
    // A 4 x 4 square around a 2 x 2 hole; the bridge between (0,0) and (1,1) is walked twice.
    const auto mesh =
        makeMesh(rawMesh({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}},
                         {{0, 1, 2, 3, 0, 4, 5, 6, 7, 4}}));
    EXPECT_EQ(mesh->triangles.size(), 8u);
    EXPECT_EQ(triangleAreas(*mesh, {0, 0, 1}).all, 12);
}

TEST(Mesh, StraightCornersStayOnEdgesOfTriangles) {
    // A square with a vertex in the middle of each side, the first one included. A triangle
    // without area would leave a vertex on the inside of another triangle's edge.
    const auto mesh =
        makeMesh(rawPolygon({{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}, {0, 0, 0}}));
    EXPECT_EQ(mesh->facts.concave, 0);
    EXPECT_EQ(triangleAreas(*mesh, {0, 0, 1}).all, 4);
    for (const Triangle& triangle : mesh->triangles) EXPECT_GT(doubledArea(*mesh, triangle).z, 0);
}

TEST(Mesh, OutlineThatCrossesItselfCountsAsConcave) {
    // Bow-ties, with and without area left over, in each coordinate plane; a pentagram turns
    // left at every corner.
    for (int axis = 0; axis < 3; ++axis)
        for (const double top : {1.0, 3.0}) {
            std::vector<Vec3d> points(4, Vec3d(0.0));
            const double u[] = {0, 1, 0, top}, v[] = {0, 0, 1, top};
            for (std::size_t i = 0; i < 4; ++i) {
                points[i][(axis + 1) % 3] = u[i];
                points[i][(axis + 2) % 3] = v[i];
            }
            const auto bowTie = makeMesh(rawPolygon(points));
            EXPECT_EQ(bowTie->facts.concave, 1);
            EXPECT_EQ(bowTie->facts.degenerate, top == 1 ? 1 : 0);  // the two halves cancel
            EXPECT_EQ(bowTie->triangles.size(), 2u);
        }
    std::vector<Vec3d> pentagram;
    for (int i = 0; i < 5; ++i) {
        const double angle = 4 * std::numbers::pi * i / 5;
        pentagram.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    const auto mesh = makeMesh(rawPolygon(pentagram));
    EXPECT_EQ(mesh->facts.concave, 1);
    EXPECT_EQ(mesh->triangles.size(), 3u);
}

TEST(Mesh, PolygonOffItsPlaneIsReported) {
    const auto quad = [](double h) {
        return makeMesh(rawPolygon({{0, 0, 0}, {1, 0, 0}, {1, 1, h}, {0, 1, 0}}))->facts.nonPlanar;
    };
    EXPECT_EQ(quad(0), 0);
    EXPECT_EQ(quad(1e-7), 0);  // within what six digits leave
    EXPECT_EQ(quad(1e-3), 1);
    EXPECT_EQ(quad(1), 1);
    // The same corner far away, where a coordinate has only 1e-3 left: rounding explains it.
    const Vec3d far(1e13, 1e13, 1e13);
    std::vector<Vec3d> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.002}, {0, 1, 0}};
    for (Vec3d& p : points) p += far;
    EXPECT_EQ(makeMesh(rawPolygon(points))->facts.nonPlanar, 0);
}

TEST(Mesh, PolygonWithoutAreaIsDegenerate) {
    EXPECT_EQ(makeMesh(rawPolygon({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}))->facts.degenerate, 1);
    EXPECT_EQ(makeMesh(rawPolygon({{0.1, 0.3, 0.7}, {0.2, 0.6, 1.4}, {0.3, 0.9, 2.1}}))->facts.degenerate, 1);
    EXPECT_EQ(makeMesh(rawPolygon({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {2, 0, 0}}))->facts.degenerate, 1);
    EXPECT_EQ(makeMesh(rawPolygon({{0, 0, 0}, {1, 0, 0}, {0, 1e-9, 0}}))->facts.degenerate, 0);
    EXPECT_EQ(makeMesh(rawPolygon({{0, 0, 0}, {1e-200, 0, 0}, {0, 1e-200, 0}}))->facts.degenerate, 0);
    EXPECT_EQ(makeMesh(rawPolygon({{-1e308, 0, 0}, {1e308, 0, 0}, {0, 1e308, 0}}))->facts.degenerate, 0);
}

TEST(Mesh, HundredThousandCornersTakeLinearTime) {
    const std::size_t n = 100'000;
    std::vector<Vec3d> circle;
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
        circle.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    const test::Looks looks;
    const auto mesh = makeMesh(rawPolygon(circle), test::Looks::stop());
    EXPECT_EQ(mesh->facts.concave, 0);
    ASSERT_EQ(mesh->triangles.size(), n - 2);
    for (std::size_t i = 0; i < n - 2; i += 9973) {  // a fan from the first vertex
        EXPECT_EQ(mesh->triangles[i].vertices[0], 0u);
        EXPECT_EQ(mesh->triangles[i].vertices[1], i + 1);
    }
    EXPECT_GE(test::Looks::items(), n);
    EXPECT_LE(test::Looks::items(), 10 * n) << "of the corners each step of makeMesh looks at";
}

TEST(Mesh, LargeConcavePolygonsAreAllSplit) {
    const std::vector<Vec3d> points = star(20'000, 1);
    std::vector<std::uint32_t> polygon(points.size());
    for (std::size_t i = 0; i < polygon.size(); ++i) polygon[i] = static_cast<std::uint32_t>(i);
    const auto mesh = makeMesh(rawMesh(points, Polygons(3, polygon)));
    EXPECT_EQ(mesh->triangles.size(), 3 * (points.size() - 2));
    EXPECT_EQ(mesh->facts.concave, 3);
    EXPECT_EQ(mesh->facts.unsplit, 0);
    EXPECT_NEAR(triangleAreas(*mesh, {0, 0, 1}).all / (3 * shoelace(points)), 1, 1e-12);
}

TEST(Mesh, ScalingByAPowerOfTwoChangesNothing) {
    std::vector<Mesh> meshes{rawPyramid(), rawBox({-0.1, 0.3, 7.7}, {0.7, 0.9, 9.1}), rawPolygon(star(50, 3)),
                             rawPolygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 1e-3}, {0, 1, 0}}),
                             rawPolygon({{0.1, 0.3, 0.7}, {0.2, 0.6, 1.4}, {0.3, 0.9, 2.1}})};
    for (const Mesh& raw : meshes) {
        const auto mesh = makeMesh(raw);
        for (const int exponent : {-900, -40, -1, 1, 40, 900}) {
            Mesh scaled = raw;
            test::moveVertices(scaled, [&](Vec3d p) { return std::ldexp(1.0, exponent) * p; });
            const auto other = makeMesh(std::move(scaled));
            EXPECT_EQ(mesh->facts.closed, other->facts.closed);
            EXPECT_EQ(mesh->facts.convex, other->facts.convex);
            EXPECT_EQ(mesh->facts.nonPlanar, other->facts.nonPlanar);
            EXPECT_EQ(mesh->facts.concave, other->facts.concave);
            EXPECT_EQ(mesh->facts.degenerate, other->facts.degenerate);
            ASSERT_EQ(mesh->triangles.size(), other->triangles.size());
            for (std::size_t i = 0; i < mesh->triangles.size(); ++i)
                EXPECT_TRUE(std::ranges::equal(mesh->triangles[i].vertices, other->triangles[i].vertices));
        }
    }
}

TEST(Mesh, NoPolygonsIsNeitherClosedNorConvex) {
    const auto mesh = makeMesh(rawMesh({{0, 0, 0}}, {}));
    EXPECT_EQ(mesh->polygonCount(), 0u);
    EXPECT_FALSE(mesh->facts.closed);
    EXPECT_FALSE(mesh->facts.convex);
}

// Ten million triangles are to stand in a few hundred megabytes. Of a closed mesh of triangles alone there are twice as
// many triangles as vertices (E = 3 T / 2 in V - E + T = 2): 12 bytes a triangle, and 12 a vertex are 6 more.
TEST(Mesh, OfTrianglesAloneHoldsEighteenBytesATriangle) {
    constexpr std::uint32_t kAround = 64;  // a torus: two triangles a vertex, exactly
    Mesh mesh;
    const auto at = [](std::uint32_t i, std::uint32_t j) { return i % kAround * kAround + j % kAround; };
    for (std::uint32_t i = 0; i < kAround; ++i)
        for (std::uint32_t j = 0; j < kAround; ++j) {
            mesh.positions.push_back(Vec3d(i, j, i * j));
            mesh.addPolygon(std::array{at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.addPolygon(std::array{at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    const auto made = makeMesh(std::move(mesh));
    EXPECT_TRUE(made->facts.closed);
    const auto bytes = [](const auto&... lists) { return (... + (lists.capacity() * sizeof(lists[0]))); };
    const std::size_t vertices = made->positions.bytes() + made->normals.bytes();
    EXPECT_EQ(vertices + bytes(made->triangles) + bytes(made->polygonPlaces, made->corners, made->firstCorner) +
                  bytes(made->firstTriangle, made->polygons),
              18 * made->polygonCount());
    // And one object's topology holds nothing beside the mesh.
    const Topology topology = makeTopology({made});
    EXPECT_EQ(bytes(topology.polygonObject, topology.ownTriangles, topology.ownPolygons), 0u);
    EXPECT_EQ(topology.triangles.data(), made->triangles.data());
}

// The first polygon that is no triangle makes lists of corners of them all; each stays what it was.
TEST(Mesh, KeepsItsPolygonsWhenOneIsNoTriangle) {
    Mesh mesh = rawMesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 2, 3}});
    EXPECT_TRUE(mesh.hasTrianglesAlone());
    EXPECT_EQ(polygonsOf(mesh), (Polygons{{0, 1, 2}, {0, 2, 3}}));
    mesh.addPolygon(std::array{0u, 4u, 2u, 3u});
    mesh.addPolygon(std::array{1u, 4u, 2u});
    EXPECT_FALSE(mesh.hasTrianglesAlone());
    EXPECT_EQ(polygonsOf(mesh), (Polygons{{0, 1, 2}, {0, 2, 3}, {0, 4, 2, 3}, {1, 4, 2}}));
    mesh.renumberVertices(std::array{4u, 3u, 2u, 1u, 0u});
    EXPECT_EQ(polygonsOf(mesh), (Polygons{{4, 3, 2}, {4, 2, 1}, {4, 0, 2, 1}, {3, 0, 2}}));
}

}  // namespace
}  // namespace pipeline
