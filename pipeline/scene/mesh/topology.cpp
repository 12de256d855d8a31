#include "pipeline/scene/mesh/topology.h"

#include <algorithm>

namespace pipeline {

std::size_t Topology::objectOfVertex(std::size_t vertex) const {
    const auto next = std::upper_bound(firstVertex.begin(), firstVertex.end(), vertex);
    return std::size_t(next - firstVertex.begin()) - 1;
}

Vec3d Topology::vertexColor(std::size_t vertex) const {
    const std::size_t object = objectOfVertex(vertex);
    const VertexVectors& colors = meshes[object]->colors;
    return colors.empty() ? Vec3d(1) : colors[vertex - firstVertex[object]];
}

bool hasVertexColors(const Scene& scene) {
    return std::ranges::any_of(scene.objects, [](const Object& object) { return !object.mesh->colors.empty(); });
}

std::size_t polygonCount(const Scene& scene) {
    std::size_t count = 0;
    for (const Object& object : scene.objects) count += object.mesh->polygonCount();
    return count;
}

VertexRange Topology::verticesOf(std::size_t begin, std::size_t end) const {
    VertexRange all{~std::uint32_t(0), 0};
    // The last object that begins at `begin` or before, as of those without triangles there may be many.
    auto object = std::size_t(std::ranges::upper_bound(firstTriangle, begin) - firstTriangle.begin()) - 1;
    for (; object < meshes.size() && firstTriangle[object] < end; ++object) {
        const std::vector<VertexRange>& ranges = meshes[object]->vertexRanges;
        const std::size_t from = begin - std::min<std::size_t>(begin, firstTriangle[object]);
        const std::size_t to = std::min<std::size_t>(end, firstTriangle[object + 1]) - firstTriangle[object];
        for (std::size_t i = from / Mesh::kRangeTriangles; i * Mesh::kRangeTriangles < to; ++i) {
            all.first = std::min(all.first, firstVertex[object] + ranges[i].first);
            all.last = std::max(all.last, firstVertex[object] + ranges[i].last);
        }
    }
    return all.last == 0 ? VertexRange{} : all;
}

std::vector<std::shared_ptr<const Mesh>> meshesOf(const Scene& scene) {
    std::vector<std::shared_ptr<const Mesh>> meshes;
    for (const Object& object : scene.objects) meshes.push_back(object.mesh);
    return meshes;
}

namespace {

// What is counted within the objects, counted over all of them.
void countOverAll(Topology& topology) {
    topology.ownTriangles.reserve(topology.firstTriangle.back());
    topology.polygonObject.reserve(topology.firstPolygon.back());
    for (std::size_t object = 0; object < topology.meshes.size(); ++object) {
        const Mesh& mesh = *topology.meshes[object];
        for (Triangle triangle : mesh.triangles) {
            for (std::uint32_t& vertex : triangle.vertices) vertex += topology.firstVertex[object];
            topology.ownTriangles.push_back(triangle);
        }
        topology.polygonObject.insert(topology.polygonObject.end(), mesh.polygonCount(), std::uint32_t(object));
    }
    topology.triangles = topology.ownTriangles;
    if (topology.firstTriangle.back() == topology.firstPolygon.back()) return;
    topology.ownPolygons.reserve(topology.firstTriangle.back());
    for (std::size_t object = 0; object < topology.meshes.size(); ++object) {
        const Mesh& mesh = *topology.meshes[object];
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            topology.ownPolygons.push_back(mesh.polygonOf(t) + topology.firstPolygon[object]);
    }
    topology.polygons = topology.ownPolygons;
}

}  // namespace

Topology makeTopology(std::vector<std::shared_ptr<const Mesh>> meshes) {
    Topology topology;
    topology.meshes = std::move(meshes);
    std::uint32_t vertices = 0, polygons = 0, triangles = 0;
    for (const auto& mesh : topology.meshes) {
        topology.firstVertex.push_back(vertices);
        topology.firstPolygon.push_back(polygons);
        topology.firstTriangle.push_back(triangles);
        vertices += std::uint32_t(mesh->positions.size());
        polygons += std::uint32_t(mesh->polygonCount());
        triangles += std::uint32_t(mesh->triangles.size());
    }
    topology.firstVertex.push_back(vertices);
    topology.firstPolygon.push_back(polygons);
    topology.firstTriangle.push_back(triangles);
    if (topology.meshes.size() == 1)
        topology.triangles = topology.meshes[0]->triangles, topology.polygons = topology.meshes[0]->polygons;
    else
        countOverAll(topology);
    return topology;
}

}  // namespace pipeline
