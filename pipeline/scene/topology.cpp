#include "pipeline/scene/topology.h"

#include <algorithm>

namespace pipeline {

std::size_t Topology::objectOfVertex(std::size_t vertex) const {
    const auto next = std::upper_bound(firstVertex.begin(), firstVertex.end(), vertex);
    return std::size_t(next - firstVertex.begin()) - 1;
}

std::vector<std::shared_ptr<const Mesh>> meshesOf(const Scene& scene) {
    std::vector<std::shared_ptr<const Mesh>> meshes;
    for (const Object& object : scene.objects) meshes.push_back(object.mesh);
    return meshes;
}

Topology makeTopology(std::vector<std::shared_ptr<const Mesh>> meshes) {
    Topology topology;
    topology.meshes = std::move(meshes);
    std::uint32_t vertices = 0, polygons = 0;
    for (std::size_t object = 0; object < topology.meshes.size(); ++object) {
        const Mesh& mesh = *topology.meshes[object];
        topology.firstVertex.push_back(vertices);
        topology.firstPolygon.push_back(polygons);
        topology.firstTriangle.push_back(std::uint32_t(topology.triangles.size()));
        for (Triangle triangle : mesh.triangles) {
            for (std::uint32_t& vertex : triangle.vertices) vertex += vertices;
            triangle.polygon += polygons;
            topology.triangles.push_back(triangle);
        }
        topology.polygonObject.insert(topology.polygonObject.end(), mesh.polygonCount(), std::uint32_t(object));
        vertices += std::uint32_t(mesh.positions.size());
        polygons += std::uint32_t(mesh.polygonCount());
    }
    topology.firstVertex.push_back(vertices);
    topology.firstPolygon.push_back(polygons);
    topology.firstTriangle.push_back(std::uint32_t(topology.triangles.size()));
    return topology;
}

}  // namespace pipeline
