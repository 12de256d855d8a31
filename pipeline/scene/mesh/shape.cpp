#include "pipeline/scene/mesh/shape.h"

#include <array>
#include <map>
#include <utility>

#include "pipeline/core/angles.h"
#include "pipeline/core/numerics.h"
#include "pipeline/scene/mesh/make_mesh.h"
#include "pipeline/scene/mesh/same_shapes.h"
#include "pipeline/scene/mesh/teapot.h"
#include "pipeline/scene/shape_stop.h"

namespace pipeline {
namespace {

using Index = std::uint32_t;

struct Point {
    Vec3d position, normal;  // normal: unit, outwards
};

// A rectangle of vertices, rows × columns, and which vertex of the mesh each one is.
struct Grid {
    int rows, columns;
    std::vector<Index> vertices;
    Grid(int r, int c) : rows(r), columns(c), vertices(std::size_t(r) * std::size_t(c)) {}
    Index& at(int row, int column) { return vertices[std::size_t(row) * std::size_t(columns) + std::size_t(column)]; }
};

class Builder {
public:
    explicit Builder(const Stop& stop) : m_stop(stop), m_check(stop) {}

    // Whether to give up, after so many more vertices.
    bool stopped(int vertices) { return m_check.stopped(static_cast<std::size_t>(vertices)); }

    Index add(const Point& point) {
        m_mesh.positions.push_back(point.position);
        m_mesh.normals.push_back(point.normal);
        return static_cast<Index>(m_mesh.positions.size() - 1);
    }

    // A polygon for each cell of the grid, its rows seen downwards and its columns to the right from
    // outside; the other way round when `turned`. Corners that are one vertex count once.
    void addCells(Grid& grid, bool turned = false) {
        for (int i = 0; i + 1 < grid.rows && !stopped(grid.columns); ++i)
            for (int j = 0; j + 1 < grid.columns; ++j) {
                const std::array corners{grid.at(i, j), grid.at(i + 1, j), grid.at(i + 1, j + 1), grid.at(i, j + 1)};
                std::array<Index, 4> polygon{};
                std::size_t count = 0;
                for (std::size_t k = 0; k < 4; ++k) {
                    const Index corner = corners[turned ? 3 - k : k];
                    if (count == 0 || (corner != polygon[count - 1] && corner != polygon[0])) polygon[count++] = corner;
                }
                m_mesh.addPolygon(std::span(polygon).first(count));
            }
    }

    std::shared_ptr<const Mesh> finish() {
        if (m_stop.stop_requested()) return std::make_shared<const Mesh>();
        return makeMesh(std::move(m_mesh), m_stop);
    }

private:
    Stop m_stop;
    StopCheck m_check;
    Mesh m_mesh;
};

// A flat square of side 1: down and right are unit vectors, outside is down × right.
void addSquare(Builder& builder, Vec3d center, Vec3d down, Vec3d right, int n) {
    Grid grid(n + 1, n + 1);
    for (int i = 0; i <= n && !builder.stopped(n); ++i)
        for (int j = 0; j <= n; ++j)
            grid.at(i, j) = builder.add(
                {center + (double(i) / n - 0.5) * down + (double(j) / n - 0.5) * right, glm::cross(down, right)});
    builder.addCells(grid);
}

void addBox(Builder& builder, int n) {
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-0.5, 0.5}) {
            Vec3d center(0.0), down(0.0), right(0.0);
            center[axis] = side;
            down[(axis + 1) % 3] = 1;
            right[(axis + 2) % 3] = side > 0 ? 1 : -1;
            addSquare(builder, center, down, right, n);
        }
}

// Quarter circles in n pieces: angle k of 0..4n.
Vec3d onCircle(int k, int n) {
    const double angle = 90.0 * k / n;
    return {cosDegrees(angle), sinDegrees(angle), 0};
}

// Rows around the z axis; the last column is the first one again. pointAt(row, direction) with the
// unit direction from the axis. Where a row shrinks onto the axis it is one vertex.
template <class PointAt>
Grid addRound(Builder& builder, int rows, int n, PointAt pointAt) {
    Grid grid(rows, 4 * n + 1);
    for (int i = 0; i < rows && !builder.stopped(4 * n); ++i) {
        const Point first = pointAt(i, onCircle(0, n));
        const bool shrunk = first.position.x == 0 && first.position.y == 0;
        for (int j = 0; j < 4 * n; ++j)
            grid.at(i, j) = shrunk && j > 0 ? grid.at(i, 0) : builder.add(pointAt(i, onCircle(j, n)));
        grid.at(i, 4 * n) = grid.at(i, 0);
    }
    return grid;
}

void addSphere(Builder& builder, int n) {
    Grid grid = addRound(builder, 2 * n + 1, n, [&](int i, Vec3d direction) {
        const Vec3d down = onCircle(i, n);  // x: along the axis, y: away from it
        const Vec3d position = down.y * direction + Vec3d(0, 0, down.x);
        return Point{position, normalized(position)};
    });
    builder.addCells(grid);
}

void addCylinder(Builder& builder, int n) {
    Grid side = addRound(builder, n + 1, n, [&](int i, Vec3d direction) {
        return Point{direction + Vec3d(0, 0, 1 - 2.0 * i / n), direction};
    });
    builder.addCells(side);
    for (const double z : {1.0, -1.0}) {
        Grid cap = addRound(builder, n + 1, n, [&](int i, Vec3d direction) {
            return Point{double(i) / n * direction + Vec3d(0, 0, z), {0, 0, z}};
        });
        builder.addCells(cap, z < 0);
    }
}

void addTorus(Builder& builder, int n) {
    constexpr double kTube = 0.4;
    Grid round = addRound(builder, 4 * n, n, [&](int i, Vec3d direction) {
        const Vec3d around = onCircle(i, n);  // from the top outwards and down
        const Vec3d normal = around.y * direction + Vec3d(0, 0, around.x);
        return Point{direction + kTube * normal, normalized(normal)};
    });
    Grid grid(4 * n + 1, 4 * n + 1);  // its last row is the first one again
    for (int i = 0; i <= 4 * n; ++i)
        for (int j = 0; j <= 4 * n; ++j) grid.at(i, j) = round.at(i % (4 * n), j);
    builder.addCells(grid);
}

// Σ weights · points.
Vec3d blend(const std::array<double, 4>& weights, const std::array<Vec3d, 4>& points) {
    return weights[0] * points[0] + weights[1] * points[1] + weights[2] * points[2] + weights[3] * points[3];
}

std::array<double, 4> bernstein(double t) {
    const double s = 1 - t;
    return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

// The derivative of a cubic Bézier curve, by differences: exactly 0 where its points are one.
Vec3d slope(double t, const std::array<Vec3d, 4>& p) {
    const double s = 1 - t;
    return 3.0 * (s * s * (p[1] - p[0]) + 2 * s * t * (p[2] - p[1]) + t * t * (p[3] - p[2]));
}

// Position and normal ∂v × ∂u of a patch. Where an edge has shrunk to a point, as at the lid's knob,
// ∂v is 0 there; close to it ∂v is as good as a multiple of ∂u∂v, which then gives the direction.
Point onPatch(const Patch& patch, double u, double v) {
    std::array<Vec3d, 4> alongV, slopes;  // per row: the row's curve at v, and its derivative
    for (std::size_t i = 0; i < 4; ++i) {
        alongV[i] = blend(bernstein(v), patch[i]);
        slopes[i] = slope(v, patch[i]);
    }
    const Vec3d du = slope(u, alongV), dv = blend(bernstein(u), slopes);
    const Vec3d across = dv == Vec3d(0.0) ? slope(u, slopes) : dv;
    return {blend(bernstein(u), alongV), normalized(glm::cross(across, du))};
}

// Makes vertices on the patches' edges one where position and normal agree: patches that meet
// smoothly share them, and mirrored ones do so bit by bit.
class Seams {
public:
    explicit Seams(Builder& builder) : m_builder(builder) {}

    Index add(const Point& point) {
        // Components of unit vectors that went through some twenty roundings.
        constexpr double kSame = 0x1p-44;
        const Vec3d p = point.position;
        auto& known = m_known[{p.x, p.y, p.z}];
        for (const auto& [normal, index] : known)
            if (largestComponent(normal - point.normal) <= kSame) return index;
        return known.emplace_back(point.normal, m_builder.add(point)).second;
    }

private:
    Builder& m_builder;
    std::map<std::array<double, 3>, std::vector<std::pair<Vec3d, Index>>> m_known;
};

void addPatch(Builder& builder, Seams& seams, const Patch& patch, Vec3d mirror, int n) {
    Grid grid(n + 1, n + 1);
    for (int i = 0; i <= n && !builder.stopped(n); ++i)
        for (int j = 0; j <= n; ++j) {
            Point point = onPatch(patch, double(i) / n, double(j) / n);
            point.position = point.position * mirror + Vec3d(0.0);  // + 0: no negative zeros on the seams
            point.normal = point.normal * mirror + Vec3d(0.0);
            const bool isEdge = i == 0 || i == n || j == 0 || j == n;
            grid.at(i, j) = isEdge ? seams.add(point) : builder.add(point);
        }
    // Outside is ∂v × ∂u; each mirror turns the order of a polygon's corners round.
    builder.addCells(grid, mirror.x * mirror.y > 0);
}

void addTeapot(Builder& builder, int n) {
    Seams seams(builder);
    for (const TeapotPatch& patch : teapotPatches())
        for (const double x : {1.0, -1.0})
            for (const double y : {1.0, -1.0})
                if (x > 0 || patch.mirrorX) addPatch(builder, seams, patch.points, {x, y, 1}, n);
}

constexpr std::size_t kTeapotPatches = 32;  // mirrored ones counted

thread_local ShapeStop* innermostStop = nullptr;

constexpr std::array<std::string_view, kShapeCount> kNames{"plane", "box", "sphere", "cylinder", "torus", "teapot"};

}  // namespace

ShapeStop::ShapeStop(Stop stop) : m_outer(innermostStop), m_stop(std::move(stop)) { innermostStop = this; }
ShapeStop::~ShapeStop() { innermostStop = m_outer; }
Stop ShapeStop::innermost() { return innermostStop ? innermostStop->m_stop : Stop(); }

std::string_view name(ShapeKind kind) { return kNames[static_cast<std::size_t>(kind)]; }

std::size_t mostVerticesOf(const Shape& shape) {
    const auto n = static_cast<std::size_t>(shape.tessellation);
    switch (shape.kind) {
        case ShapeKind::Plane: return (n + 1) * (n + 1);
        case ShapeKind::Box: return 6 * (n + 1) * (n + 1);
        case ShapeKind::Sphere: return 4 * n * (2 * n - 1) + 2;
        case ShapeKind::Cylinder: return 4 * n * (n + 1) + 2 * (4 * n * n + 1);
        case ShapeKind::Torus: return 16 * n * n;
        case ShapeKind::Teapot: return kTeapotPatches * (n + 1) * (n + 1);
    }
    return 0;
}

std::size_t mostTrianglesOf(const Shape& shape) {
    const auto n = static_cast<std::size_t>(shape.tessellation);
    switch (shape.kind) {
        case ShapeKind::Plane: return 2 * n * n;
        case ShapeKind::Box: return 12 * n * n;
        case ShapeKind::Sphere: return 8 * n * (2 * n - 1);
        case ShapeKind::Cylinder: return 8 * n * n + 2 * 4 * n * (2 * n - 1);
        case ShapeKind::Torus: return 32 * n * n;
        case ShapeKind::Teapot: return kTeapotPatches * 2 * n * n;
    }
    return 0;
}

std::shared_ptr<const Mesh> makeShape(const Shape& shape) { return makeShape(shape, ShapeStop::innermost()); }

std::shared_ptr<const Mesh> makeShape(const Shape& shape, const Stop& stop) {
    if (auto known = SameShapes::find(shape)) return known;
    Builder builder(stop);
    const int n = shape.tessellation;
    switch (shape.kind) {
        case ShapeKind::Plane: addSquare(builder, {}, {1, 0, 0}, {0, 1, 0}, n); break;
        case ShapeKind::Box: addBox(builder, n); break;
        case ShapeKind::Sphere: addSphere(builder, n); break;
        case ShapeKind::Cylinder: addCylinder(builder, n); break;
        case ShapeKind::Torus: addTorus(builder, n); break;
        case ShapeKind::Teapot: addTeapot(builder, n); break;
    }
    auto mesh = builder.finish();
    if (!stop.stop_requested()) SameShapes::keep(shape, mesh);
    return mesh;
}

}  // namespace pipeline
