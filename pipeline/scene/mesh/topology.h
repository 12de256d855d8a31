#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "pipeline/scene/scene.h"

namespace pipeline {

// The scene's meshes end to end: vertices, polygons and triangles counted over all objects in
// scene order, as every buffer counts them. Of one object it holds nothing that the mesh holds; of several 12 bytes a
// triangle, or 16 where not all polygons are triangles, and 4 a polygon.
struct Topology {
    std::vector<std::shared_ptr<const Mesh>> meshes;                      // one per object
    std::vector<std::uint32_t> firstVertex, firstPolygon, firstTriangle;  // per object, and one past the last
    std::span<const Triangle> triangles;                                  // vertices counted over all objects
    std::span<const std::uint32_t> polygons;   // per triangle; empty where every polygon is one, that of its number
    std::vector<std::uint32_t> polygonObject;  // per polygon; empty where there is one object
    std::vector<Triangle> ownTriangles;        // what `triangles` shows where there are several; else empty
    std::vector<std::uint32_t> ownPolygons;    // and what `polygons` shows

    // Among which vertices the corners of triangles [begin, end) lie, and of some triangles beside them.
    VertexRange verticesOf(std::size_t begin, std::size_t end) const;

    std::size_t vertexCount() const { return firstVertex.back(); }
    std::size_t polygonCount() const { return firstPolygon.back(); }
    std::size_t objectOfVertex(std::size_t vertex) const;
    // What a vertex' mesh gives as its colour; 1 where it gives none.
    Vec3d vertexColor(std::size_t vertex) const;
    std::uint32_t polygonOf(std::size_t triangle) const {
        return polygons.empty() ? std::uint32_t(triangle) : polygons[triangle];
    }
    std::uint32_t objectOfPolygon(std::size_t polygon) const {
        return polygonObject.empty() ? 0 : polygonObject[polygon];
    }

    Topology() = default;
    Topology(Topology&&) = default;  // moved, its own lists stay where they are; copied they would not
    Topology& operator=(Topology&&) = default;

    // A polygon's corners as indices within its object; add offset for the scene's.
    struct Corners {
        std::span<const std::uint32_t> local;
        std::uint32_t offset;
        std::size_t size() const { return local.size(); }
        std::uint32_t operator[](std::size_t i) const { return local[i] + offset; }
    };
    Corners corners(std::size_t polygon) const {
        const std::uint32_t object = objectOfPolygon(polygon);
        return {meshes[object]->polygon(polygon - firstPolygon[object]), firstVertex[object]};
    }
    // The triangles of a polygon stand together; the first of them.
    std::size_t firstTriangleOf(std::size_t polygon) const {
        const std::uint32_t object = objectOfPolygon(polygon);
        return firstTriangle[object] + meshes[object]->firstTriangleOf(polygon - firstPolygon[object]);
    }
    std::size_t triangleCountOf(std::size_t polygon) const { return corners(polygon).size() - 2; }
};

std::size_t polygonCount(const Scene& scene);
bool hasVertexColors(const Scene& scene);  // of an object at least
std::vector<std::shared_ptr<const Mesh>> meshesOf(const Scene& scene);
Topology makeTopology(std::vector<std::shared_ptr<const Mesh>> meshes);

}  // namespace pipeline
