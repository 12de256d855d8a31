#include "pipeline/scene/mesh/mesh.h"

#include <algorithm>
#include <cmath>

#include "pipeline/core/numerics.h"
#include "pipeline/scene/mesh/closed_mesh.h"
#include "pipeline/scene/mesh/ear_clipper.h"
#include "pipeline/scene/mesh/make_mesh.h"

namespace pipeline {
namespace {

constexpr double kRoundoff = 0x1p-53;  // largest relative error of one double operation
// How far a vertex may lie off its polygon's plane, as a fraction of the polygon's extent,
// before it is reported: text files carry about six digits.
constexpr double kPlanarTolerance = 1e-6;
// Comparisons spent on the concave polygons of a mesh before the rest is given up: half a second's work, and several
// times what outlines of any number of corners take.
constexpr std::size_t kEarWork = 50'000'000, kEarWorkPerCorner = 1024;
// Polygons times vertices up to which a mesh is examined for convexity.
constexpr double kMaxConvexWork = 4e6;

double sumOfComponents(const Vec3d& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

// A polygon moved to its first vertex and scaled by a power of two to coordinates within
// [-1, 1]: nothing overflows, and a mesh scaled by a power of two gives the same bits.
struct LocalPolygon {
    std::vector<Vec3d> points;
    double scale = 1;
    double quantum = 0;      // bound on the error of a coordinate, rounding of the input included
    Vec3d normal{0.0};       // Newell's: twice the area long
    Vec3d spread{0.0};       // the same sum of absolute values: what is left where areas cancel
    double normalError = 0;  // bound on the error of each component of `normal`

    bool hasArea() const { return largestComponent(normal) > normalError; }
};

// Newell's method on differences from the first vertex, so that a polygon far from the origin
// keeps its digits (I. Sutherland, R. Sproull, R. Schumacker, "A characterization of ten
// hidden-surface algorithms", Computing Surveys 1974).
void findNormal(LocalPolygon& polygon) {
    const std::vector<Vec3d>& points = polygon.points;
    polygon.normal = polygon.spread = Vec3d(0.0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3d& a = points[i];
        const Vec3d& b = points[i + 1 == points.size() ? 0 : i + 1];
        const Vec3d term{(a.y - b.y) * (a.z + b.z), (a.z - b.z) * (a.x + b.x), (a.x - b.x) * (a.y + b.y)};
        polygon.normal += term;
        polygon.spread += glm::abs(term);
    }
    const double count = static_cast<double>(points.size());
    polygon.normalError = count * (kRoundoff * largestComponent(polygon.spread) + 8 * polygon.quantum);
}

void gather(const Mesh& mesh, std::size_t index, LocalPolygon& polygon) {
    const std::span<const std::uint32_t> corners = mesh.polygon(index);
    const Vec3d first = mesh.positions[corners[0]];
    double magnitude = 0, extent = 0;
    polygon.points.clear();
    for (const std::uint32_t corner : corners) {
        const Vec3d& p = mesh.positions[corner];
        polygon.points.push_back(0.5 * p - 0.5 * first);  // halves: the difference cannot overflow
        magnitude = std::max(magnitude, largestComponent(p));
        extent = std::max(extent, largestComponent(polygon.points.back()));
    }
    int exponent = 0;
    std::frexp(extent, &exponent);
    polygon.scale = std::ldexp(1.0, std::min(-exponent, 1000));
    for (Vec3d& p : polygon.points) p *= polygon.scale;
    polygon.quantum = 8 * kRoundoff * (0.5 * magnitude * polygon.scale);
    findNormal(polygon);
}

bool isPlanar(const LocalPolygon& polygon) {
    if (polygon.points.size() == 3 || !polygon.hasArea()) return true;
    const double tolerance = kPlanarTolerance * glm::length(polygon.normal) + 3 * polygon.normalError +
                             polygon.quantum * sumOfComponents(polygon.normal);
    return std::ranges::all_of(polygon.points,
                               [&](const Vec3d& p) { return std::abs(glm::dot(polygon.normal, p)) <= tolerance; });
}

// The projection along the largest component of the normal, counter-clockwise.
void flatten(const LocalPolygon& polygon, std::vector<Vec2<double>>& points) {
    const Vec3d size = polygon.hasArea() ? glm::abs(polygon.normal) : polygon.spread;
    const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    int u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (polygon.normal[axis] < 0) std::swap(u, v);
    points.clear();
    for (const Vec3d& p : polygon.points) points.emplace_back(p[u], p[v]);
}

enum class Outline { StrictlyConvex, Convex, Concave };  // Convex: with corners that go straight on

// Turning left everywhere is not enough: a pentagram does. A convex outline also changes
// between going right and going left only twice.
Outline outlineOf(const std::vector<Vec2<double>>& points, double quantum) {
    const std::size_t n = points.size();
    bool straight = false;
    int changes = 0, firstHeading = 0, heading = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2<double>& a = points[i];
        const Vec2<double>& b = points[(i + 1) % n];
        const int corner = turn(a, b, points[(i + 2) % n], quantum);
        if (corner < 0) return Outline::Concave;
        straight |= corner == 0;
        const double along = std::abs(b.x - a.x) > 2 * quantum ? b.x - a.x : b.y - a.y;
        const int next = along > 0 ? 1 : along < 0 ? -1 : heading;
        changes += heading != 0 && next != heading;
        heading = next;
        if (firstHeading == 0) firstHeading = heading;
    }
    changes += heading != firstHeading;
    if (changes > 2) return Outline::Concave;
    return straight ? Outline::Convex : Outline::StrictlyConvex;
}

void fan(std::size_t cornerCount, std::vector<glm::uvec3>& triangles) {
    triangles.clear();
    for (std::uint32_t i = 1; i + 1 < cornerCount; ++i) triangles.emplace_back(0, i, i + 1);
}

// Splits a polygon into corner numbers. A fan takes linear time, but puts the straight corners
// beside its first vertex on an edge of no polygon; ears leave none there.
// isSplit: false where the triangles may overlap.
Outline triangulate(const LocalPolygon& polygon, std::vector<Vec2<double>>& flat, std::vector<glm::uvec3>& triangles,
                    std::size_t& work, StopCheck& check, bool& isSplit) {
    isSplit = true;
    fan(polygon.points.size(), triangles);
    if (polygon.points.size() == 3) return Outline::StrictlyConvex;
    flatten(polygon, flat);
    const Outline outline = outlineOf(flat, polygon.quantum);
    if (outline == Outline::StrictlyConvex) return outline;
    isSplit = polygon.hasArea();
    if (!isSplit) return outline;
    std::vector<glm::uvec3> ears;
    isSplit = EarClipper(flat, polygon.quantum, work, check).clip(ears);
    if (isSplit) triangles = std::move(ears);
    return outline;
}

// No vertex in front of the polygon's plane by more than rounding explains.
bool allBehind(const Mesh& mesh, std::size_t index, const LocalPolygon& polygon) {
    const Vec3d first = mesh.positions[mesh.polygon(index)[0]];
    const double firstSize = largestComponent(first);
    return std::ranges::all_of(mesh.positions, [&](const Vec3d& p) {
        const Vec3d offset = (0.5 * p - 0.5 * first) * polygon.scale;
        const double quantum = 8 * kRoundoff * (0.5 * std::max(firstSize, largestComponent(p)) * polygon.scale);
        const double bound = polygon.normalError * sumOfComponents(offset) + quantum * sumOfComponents(polygon.normal);
        return glm::dot(polygon.normal, offset) <= bound;  // false for NaN, too
    });
}

bool isConvex(const Mesh& mesh, LocalPolygon& scratch, StopCheck& check) {
    const MeshFacts& facts = mesh.facts;
    if (!facts.closed || facts.nonPlanar + facts.concave + facts.degenerate > 0) return false;
    if (static_cast<double>(mesh.polygonCount()) * static_cast<double>(mesh.positions.size()) > kMaxConvexWork)
        return false;
    for (std::size_t i = 0; i < mesh.polygonCount(); ++i) {
        gather(mesh, i, scratch);
        if (check.stopped(mesh.positions.size()) || !allBehind(mesh, i, scratch)) return false;
    }
    return true;
}

// No normal may vanish, overflow or become no number on its way to the world: the plan leaves out what would stand in.
bool hasOwnNormals(const Mesh& mesh, StopCheck& check) {
    return !mesh.normals.empty() && mesh.normals.size() == mesh.positions.size() &&
           std::ranges::all_of(mesh.normals, [&](const Vec3d& n) {
               if (check.stopped()) return false;
               const double largest = largestComponent(n);
               return largest > 0x1p-100 && largest < 0x1p100 && std::isfinite(glm::dot(n, n));
           });
}

std::vector<VertexRange> vertexRangesOf(std::span<const Triangle> triangles, StopCheck& check) {
    std::vector<VertexRange> ranges;
    for (std::size_t first = 0; first < triangles.size() && !check.stopped(Mesh::kRangeTriangles);
         first += Mesh::kRangeTriangles) {
        std::uint32_t least = triangles[first].vertices[0], most = least;
        for (const Triangle& triangle :
             triangles.subspan(first, std::min(Mesh::kRangeTriangles, triangles.size() - first))) {
            const auto& [a, b, c] = triangle.vertices;
            least = std::min({least, a, b, c}), most = std::max({most, a, b, c});
        }
        ranges.push_back({least, most + 1});
    }
    return ranges;
}

double offUnitOf(const Mesh& mesh, StopCheck& check) {
    double most = 0;
    for (const Vec3d& n : mesh.normals) {
        if (check.stopped()) break;
        const double off = offUnit(n);
        most = std::isfinite(off) ? std::max(most, off) : std::numeric_limits<double>::infinity();
    }
    return most;
}

// What the lists have kept to grow into: up to as much again, for as long as the mesh is there.
void giveBackReserves(Mesh& mesh) {
    mesh.positions.shrink_to_fit(), mesh.normals.shrink_to_fit(), mesh.colors.shrink_to_fit();
    mesh.polygonPlaces.shrink_to_fit();
    mesh.triangles.shrink_to_fit(), mesh.corners.shrink_to_fit(), mesh.firstCorner.shrink_to_fit();
}

}  // namespace

void Mesh::reservePolygons(std::size_t count, std::size_t cornersOfAll) {
    if (cornersOfAll == 3 * count) return triangles.reserve(count);
    corners.reserve(cornersOfAll), firstCorner.reserve(count + 1);
}

void Mesh::addPolygon(std::span<const std::uint32_t> polygon) {
    if (hasTrianglesAlone()) {
        if (polygon.size() == 3) {
            triangles.push_back({{polygon[0], polygon[1], polygon[2]}});
            return;
        }
        const std::vector<Triangle> before = std::move(triangles);
        triangles = {};
        firstCorner.push_back(0);
        for (const Triangle& triangle : before) addPolygon(triangle.vertices);
    }
    corners.insert(corners.end(), polygon.begin(), polygon.end());
    firstCorner.push_back(static_cast<std::uint32_t>(corners.size()));
}

void Mesh::renumberVertices(std::span<const std::uint32_t> number) {
    for (Triangle& triangle : triangles)
        for (std::uint32_t& vertex : triangle.vertices) vertex = number[vertex];
    for (std::uint32_t& corner : corners) corner = number[corner];
}

std::shared_ptr<const Mesh> makeMesh(Mesh mesh) { return makeMesh(std::move(mesh), {}); }

std::shared_ptr<const Mesh> makeMesh(Mesh mesh, const Stop& stop) {
    StopCheck check(stop);
    LocalPolygon polygon;
    std::vector<Vec2<double>> flat;
    std::vector<glm::uvec3> pieces;
    std::size_t work = kEarWork + kEarWorkPerCorner * mesh.cornerCount();
    const bool splits = !mesh.hasTrianglesAlone();
    mesh.facts = {};
    mesh.positions.dropSignsOfZero(), mesh.normals.dropSignsOfZero();
    giveBackReserves(mesh);
    if (splits) {
        mesh.triangles.clear();
        mesh.triangles.reserve(mesh.cornerCount() - 2 * mesh.polygonCount());  // a polygon of n corners has n - 2
        mesh.firstTriangle.reserve(mesh.polygonCount() + 1);
        mesh.firstTriangle.assign(1, 0);
        mesh.polygons.clear();
        mesh.polygons.reserve(mesh.triangles.capacity());
    }
    for (std::size_t i = 0; i < mesh.polygonCount(); ++i) {
        if (check.stopped(mesh.polygon(i).size())) return std::make_shared<const Mesh>();
        gather(mesh, i, polygon);
        bool isSplit = true;
        const Outline outline = triangulate(polygon, flat, pieces, work, check, isSplit);
        mesh.facts.concave += outline == Outline::Concave;
        mesh.facts.unsplit += outline == Outline::Concave && !isSplit;
        mesh.facts.degenerate += !polygon.hasArea();
        mesh.facts.nonPlanar += !isPlanar(polygon);
        if (!splits) continue;
        const std::span<const std::uint32_t> corners = mesh.polygon(i);
        for (const glm::uvec3& piece : pieces)
            mesh.triangles.push_back({{corners[piece.x], corners[piece.y], corners[piece.z]}});
        mesh.polygons.resize(mesh.triangles.size(), static_cast<std::uint32_t>(i));
        mesh.firstTriangle.push_back(static_cast<std::uint32_t>(mesh.triangles.size()));
    }
    if (!mesh.positions.empty()) mesh.facts.low = mesh.facts.high = mesh.positions[0];
    for (const Vec3d& p : mesh.positions) {
        if (check.stopped()) return std::make_shared<const Mesh>();
        mesh.facts.low = glm::min(mesh.facts.low, p), mesh.facts.high = glm::max(mesh.facts.high, p);
    }
    mesh.facts.ownNormals = hasOwnNormals(mesh, check), mesh.facts.offUnit = offUnitOf(mesh, check);
    mesh.vertexRanges = vertexRangesOf(mesh.triangles, check);
    mesh.facts.closed = edgeUseOf(mesh, check).closed;
    mesh.facts.convex = isConvex(mesh, polygon, check);
    if (check.stopped()) return std::make_shared<const Mesh>();
    return std::make_shared<const Mesh>(std::move(mesh));
}

}  // namespace pipeline
