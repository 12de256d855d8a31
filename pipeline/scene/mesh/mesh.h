#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "pipeline/core/real.h"
#include "pipeline/scene/mesh/vertex_vectors.h"

namespace pipeline {

struct TextPosition {  // from 1; 0 where nothing is known
    int line = 0;
    int column = 0;
    bool operator==(const TextPosition&) const = default;
};

// A piece of a polygon: three vertices of it, in the polygon's order.
struct Triangle {
    std::uint32_t vertices[3];
    bool operator==(const Triangle&) const = default;
};

// Numbers of vertices: [first, last).
struct VertexRange {
    std::uint32_t first = 0, last = 0;
};

// What makeMesh found out about a mesh. The plan leaves work out on the strength of it,
// so each fact is true only where it is certain.
struct MeshFacts {
    bool closed = false;  // every edge is used once in each direction
    bool convex = false;  // closed, and no vertex lies outside the plane of a polygon
    int nonPlanar = 0;    // polygons with a vertex off the plane of the others
    int concave = 0;      // polygons with a corner that turns the other way
    int unsplit = 0;  // of these, the ones whose triangles may overlap: the outline crosses itself, or costs too much
    int degenerate = 0;         // polygons without area
    bool ownNormals = false;    // every vertex has a normal, its largest component between 2^-100 and 2^100
    double offUnit = 0;         // the most that a normal's square differs from 1 by; infinity where one is not finite
    Vec3d low{0.0}, high{0.0};  // the box around all vertices, object space; 0 without vertices
};

// Polygons with any number of vertices >= 3, counter-clockwise seen from outside.
// Immutable once shared, so that its address is its identity: two scenes that hold the
// same pointer hold the same mesh.
struct Mesh {
    std::string file;  // as the scene names it; empty for a built-in shape, and where it stands in the scene's own
    VertexVectors positions;  // object space; 12 or 24 bytes a vertex
    // Per vertex, as the file or shape gives them; empty: none. Of neither any number is -0 once the mesh is made.
    VertexVectors normals;
    // Per vertex, red, green and blue from 0 up, as the file gives them; they multiply k_d and k_a. Empty: none.
    VertexVectors colors;
    std::vector<TextPosition> polygonPlaces;  // where each polygon stands there, 8 bytes; may be empty

    // Polygon by polygon, 12 bytes each. While all polygons are triangles these are the polygons, and the lists below
    // are empty; of others makeMesh finds them.
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> corners;        // vertex of each polygon corner, polygons end to end
    std::vector<std::uint32_t> firstCorner;    // per polygon, and one past the last
    std::vector<std::uint32_t> firstTriangle;  // likewise
    std::vector<std::uint32_t> polygons;       // per triangle, the one it is of

    MeshFacts facts;  // found by makeMesh
    // Likewise: which vertices the corners of every kRangeTriangles triangles lie among.
    static constexpr std::size_t kRangeTriangles = 1024;
    std::vector<VertexRange> vertexRanges;

    bool hasTrianglesAlone() const { return firstCorner.empty(); }
    std::size_t polygonCount() const { return hasTrianglesAlone() ? triangles.size() : firstCorner.size() - 1; }
    std::size_t cornerCount() const { return hasTrianglesAlone() ? 3 * triangles.size() : corners.size(); }
    std::span<const std::uint32_t> polygon(std::size_t i) const {
        if (hasTrianglesAlone()) return triangles[i].vertices;
        return std::span(corners).subspan(firstCorner[i], firstCorner[i + 1] - firstCorner[i]);
    }
    std::uint32_t polygonOf(std::size_t triangle) const {
        return polygons.empty() ? static_cast<std::uint32_t>(triangle) : polygons[triangle];
    }
    // The triangles of a polygon stand together; polygonCount() gives one past the last of all.
    std::size_t firstTriangleOf(std::size_t i) const { return hasTrianglesAlone() ? i : firstTriangle[i]; }

    void reservePolygons(std::size_t count, std::size_t cornersOfAll);
    // At least three corners, each the index of a vertex that is there or is still to come.
    void addPolygon(std::span<const std::uint32_t> polygon);
    void renumberVertices(std::span<const std::uint32_t> number);  // number[i]: what vertex i becomes
};

// Completes a mesh: splits polygons into triangles (a fan where the polygon is convex, ears where it is not; a fan again
// where an outline crosses itself) and finds the facts. Indices must be in range, polygons have >= 3 corners.
std::shared_ptr<const Mesh> makeMesh(Mesh mesh);

}  // namespace pipeline
