#include "pipeline/scene/mesh/shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "pipeline/scene/mesh/make_mesh.h"
#include "pipeline/scene/mesh/same_shapes.h"

namespace pipeline {
namespace {

constexpr double kPi = std::numbers::pi;

struct Size {
    double area = 0, volume = 0;
};

// Of the triangles; the volume by the divergence theorem, positive where polygons face outwards.
Size measure(const Mesh& mesh) {
    Size size;
    for (const Triangle& t : mesh.triangles) {
        const Vec3d a = mesh.positions[t.vertices[0]], b = mesh.positions[t.vertices[1]],
                    c = mesh.positions[t.vertices[2]];
        size.area += glm::length(glm::cross(b - a, c - a)) / 2;
        size.volume += glm::dot(a, glm::cross(b, c)) / 6;
    }
    return size;
}

std::shared_ptr<const Mesh> make(ShapeKind kind, int n) { return makeShape({kind, n}); }

// What a shape's normal is at a vertex, from its equation.
Vec3d exactNormal(ShapeKind kind, Vec3d p, Vec3d given) {
    switch (kind) {
        case ShapeKind::Plane: return {0, 0, 1};
        case ShapeKind::Sphere: return p / glm::length(p);
        case ShapeKind::Cylinder: return given.z != 0 ? Vec3d(0, 0, p.z) : Vec3d(p.x, p.y, 0);
        case ShapeKind::Torus: {
            const double r = std::hypot(p.x, p.y);
            const Vec3d fromTube = p - Vec3d(p.x / r, p.y / r, 0);
            return fromTube / glm::length(fromTube);
        }
        case ShapeKind::Box: {  // along the axis whose coordinate is ±1/2; at an edge one of them
            Vec3d n(0.0);
            for (int k = 0; k < 3; ++k)
                if (given[k] != 0 && std::abs(p[k]) == 0.5) n[k] = p[k] > 0 ? 1 : -1;
            return n;
        }
        case ShapeKind::Teapot: break;
    }
    return given;
}

TEST(Shape, NormalsAreThoseOfTheEquation) {
    for (const ShapeKind kind :
         {ShapeKind::Plane, ShapeKind::Box, ShapeKind::Sphere, ShapeKind::Cylinder, ShapeKind::Torus})
        for (const int n : {1, 2, 7}) {
            const auto mesh = make(kind, n);
            ASSERT_EQ(mesh->normals.size(), mesh->positions.size());
            for (std::size_t i = 0; i < mesh->normals.size(); ++i) {
                const Vec3d exact = exactNormal(kind, mesh->positions[i], mesh->normals[i]);
                EXPECT_LE(glm::length(mesh->normals[i] - exact), 2e-15) << name(kind) << ' ' << n << ' ' << i;
            }
        }
}

TEST(Shape, NormalsAreOfLengthOneAndOnThePolygonsOutside) {
    for (std::size_t k = 0; k < kShapeCount; ++k)
        for (const int n : {1, 3, 16}) {
            const auto mesh = make(static_cast<ShapeKind>(k), n);
            for (const Vec3d& normal : mesh->normals) ASSERT_NEAR(glm::length(normal), 1, 1e-15);
            if (n < 3) continue;  // a very coarse polygon need not face the way of its corners
            EXPECT_EQ(mesh->facts.degenerate, 0) << name(static_cast<ShapeKind>(k)) << ' ' << n;
            for (const Triangle& t : mesh->triangles) {
                const Vec3d a = mesh->positions[t.vertices[0]], b = mesh->positions[t.vertices[1]],
                            c = mesh->positions[t.vertices[2]];
                Vec3d sum(0.0);
                for (const std::uint32_t v : t.vertices) sum += mesh->normals[v];
                // Half of a quadrilateral with three corners in line may have no area.
                EXPECT_GT(glm::dot(glm::cross(b - a, c - a), sum), -1e-15)
                    << name(static_cast<ShapeKind>(k)) << ' ' << n;
            }
        }
}

TEST(Shape, CountsFollowFromTheTessellation) {
    for (const int n : {1, 2, 5}) {
        const auto un = [](int count) { return static_cast<std::size_t>(count); };
        EXPECT_EQ(make(ShapeKind::Plane, n)->polygonCount(), un(n * n));
        EXPECT_EQ(make(ShapeKind::Box, n)->polygonCount(), un(6 * n * n));
        EXPECT_EQ(make(ShapeKind::Box, n)->positions.size(), un(6 * (n + 1) * (n + 1)));
        EXPECT_EQ(make(ShapeKind::Sphere, n)->polygonCount(), un(4 * n * 2 * n));
        // Two poles and 2n - 1 circles of 4n.
        EXPECT_EQ(make(ShapeKind::Sphere, n)->positions.size(), un(2 + (2 * n - 1) * 4 * n));
        EXPECT_EQ(make(ShapeKind::Torus, n)->polygonCount(), un(4 * n * 4 * n));
        EXPECT_EQ(make(ShapeKind::Torus, n)->positions.size(), un(4 * n * 4 * n));
        EXPECT_EQ(make(ShapeKind::Cylinder, n)->polygonCount(), un(3 * 4 * n * n));
        // Side (n + 1) · 4n; each cap its centre and n circles: the rims are there twice.
        EXPECT_EQ(make(ShapeKind::Cylinder, n)->positions.size(), un(4 * n * (n + 1) + 2 * (1 + 4 * n * n)));
        EXPECT_EQ(make(ShapeKind::Teapot, n)->polygonCount(), un(32 * n * n));
    }
    EXPECT_EQ(make(ShapeKind::Box, 1)->positions.size(), 24u);
}

TEST(Shape, SphereAndTorusAreClosed) {
    for (const int n : {1, 2, 9}) {
        EXPECT_TRUE(make(ShapeKind::Sphere, n)->facts.closed) << n;
        EXPECT_TRUE(make(ShapeKind::Torus, n)->facts.closed) << n;
        EXPECT_FALSE(make(ShapeKind::Plane, n)->facts.closed) << n;
    }
}

TEST(Shape, FlatShapesHaveTheirSizeAtOnce) {
    EXPECT_NEAR(measure(*make(ShapeKind::Plane, 3)).area, 1, 1e-14);
    EXPECT_NEAR(measure(*make(ShapeKind::Box, 3)).area, 6, 1e-13);
    EXPECT_NEAR(measure(*make(ShapeKind::Box, 3)).volume, 1, 1e-14);
}

// Twice the tessellation leaves a quarter of the error: h² with h the length of a piece.
// Sphere 4π and 4π/3; cylinder of radius 1 and height 2: 4π + 2π and 2π; torus 4π² R r and 2π² R r².
TEST(Shape, AreaAndVolumeConvergeWithTheSquareOfTheLength) {
    const struct {
        ShapeKind kind;
        Size exact;
    } cases[] = {{ShapeKind::Sphere, {4 * kPi, 4 * kPi / 3}},
                 {ShapeKind::Cylinder, {6 * kPi, 2 * kPi}},
                 {ShapeKind::Torus, {4 * kPi * kPi * 0.4, 2 * kPi * kPi * 0.16}}};
    for (const auto& [kind, exact] : cases) {
        const Size coarse = measure(*make(kind, 8)), fine = measure(*make(kind, 16));
        EXPECT_NEAR((exact.area - coarse.area) / (exact.area - fine.area), 4, 0.1) << name(kind);
        EXPECT_NEAR((exact.volume - coarse.volume) / (exact.volume - fine.volume), 4, 0.1) << name(kind);
    }
}

// From Newell's control points: the pot's body is 2 in radius, spout and handle reach 3.4 and -3,
// the knob ends at 3.15.
TEST(Shape, TeapotStandsOnItsBottomAndEndsAtItsKnob) {
    const auto mesh = make(ShapeKind::Teapot, 8);
    Vec3d low(10.0), high(-10.0);
    for (const Vec3d& p : mesh->positions) low = glm::min(low, p), high = glm::max(high, p);
    EXPECT_EQ(low.z, 0);
    EXPECT_DOUBLE_EQ(high.z, 3.15);
    EXPECT_NEAR(high.y, 2, 0.02);
    EXPECT_EQ(low.y, -high.y);
    EXPECT_EQ(low.x, -3);
    EXPECT_NEAR(high.x, 3.43, 0.03);
}

// At the knob and in the bottom's middle ∂v vanishes; the surface is smooth there and horizontal.
TEST(Shape, TeapotHasANormalWhereAPatchShrinksToAPoint) {
    const auto mesh = make(ShapeKind::Teapot, 4);
    int knobs = 0, bottoms = 0;
    for (std::size_t i = 0; i < mesh->positions.size(); ++i) {
        if (mesh->positions[i] == Vec3d(0, 0, 3.15)) {
            ++knobs;
            EXPECT_NEAR(mesh->normals[i].z, 1, 1e-15);
        }
        if (mesh->positions[i] == Vec3d(0.0)) {
            ++bottoms;
            EXPECT_NEAR(mesh->normals[i].z, -1, 1e-15);
        }
    }
    EXPECT_EQ(knobs, 1);  // one vertex for the four quarters
    EXPECT_EQ(bottoms, 1);
}

// The exact normal against a difference quotient of the surface: at a fine tessellation the normal
// of the polygons around an inner vertex comes near it.
TEST(Shape, TeapotNormalsAreThoseOfFinePolygons) {
    const auto mesh = make(ShapeKind::Teapot, 64);
    double worst = 1;
    for (std::size_t i = 0; i < mesh->polygonCount(); ++i) {
        const auto corners = mesh->polygon(i);
        const Vec3d a = mesh->positions[corners[0]], b = mesh->positions[corners[1]], c = mesh->positions[corners[2]];
        const Vec3d flat = glm::normalize(glm::cross(b - a, c - a));
        for (const std::uint32_t v : corners) worst = std::min(worst, glm::dot(flat, mesh->normals[v]));
    }
    EXPECT_GT(worst, 0.97);
}

TEST(Shape, IsMadeOnceWhileSameShapesLives) {
    const Shape ball{ShapeKind::Sphere, 3}, finer{ShapeKind::Sphere, 4};
    const auto before = makeShape(ball);
    {
        const SameShapes shapes;
        const auto first = makeShape(ball);
        EXPECT_NE(first, before);
        EXPECT_EQ(makeShape(ball), first);
        EXPECT_NE(makeShape(finer), first);
        std::stop_source stopped;
        stopped.request_stop();
        const Shape torus{ShapeKind::Torus, 8};
        const auto unfinished = makeShape(torus, stopped.get_token());
        EXPECT_NE(makeShape(torus), unfinished) << "a mesh that was stopped is of no use";
        {
            const SameShapes inner;
            EXPECT_NE(makeShape(ball), first);
        }
        EXPECT_EQ(makeShape(ball), first);
    }
    EXPECT_NE(makeShape(ball), makeShape(ball));
}

}  // namespace
}  // namespace pipeline
