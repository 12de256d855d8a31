#include "app/drawing3d/view_mesh.h"

#include <algorithm>
#include <numeric>

#include "app/drawing3d/handles.h"
#include "app/frames/large_frame.h"

namespace app {

using pipeline::BufferId;
using pipeline::Frame;

namespace {

template <class Visit>
void forEachEdge(const pipeline::Topology& topology, const std::stop_token& stop, Visit visit) {
    for (std::size_t p = 0; p < topology.polygonCount() && !stop.stop_requested(); ++p) {
        const auto corners = topology.corners(p);
        for (std::size_t i = 0; i < corners.size(); ++i)
            visit(std::minmax({corners[i], corners[(i + 1) % corners.size()]}));
    }
}

// Sorted at one vertex after the other, where few begin: all at once takes longer, and cannot be stopped.
void addEdges(const pipeline::Topology& topology, const std::stop_token& stop, ViewMesh& mesh) {
    std::vector<std::uint32_t> begins(topology.vertexCount() + 1, 0);
    forEachEdge(topology, stop, [&](const auto& edge) { ++begins[edge.first + 1]; });
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    std::vector<std::uint32_t> ends(begins.back()), next(begins.begin(), begins.end() - 1);
    forEachEdge(topology, stop, [&](const auto& edge) { ends[next[edge.first]++] = edge.second; });
    for (std::uint32_t v = 0; v + 1 < begins.size() && !stop.stop_requested(); ++v) {
        const std::span from(ends.data() + begins[v], ends.data() + begins[v + 1]);
        std::ranges::sort(from);
        const auto rest = std::ranges::unique(from);
        for (const std::uint32_t end : std::span(from.begin(), rest.begin())) mesh.edges.emplace_back(v, end);
    }
    for (const auto& [a, b] : mesh.edges) mesh.meanEdge += glm::length(mesh.positions[a] - mesh.positions[b]);
    if (!mesh.edges.empty()) mesh.meanEdge /= double(mesh.edges.size());
}

void addObjectBounds(const pipeline::Topology& topology, ViewMesh& mesh) {
    for (std::size_t i = 0; i + 1 < topology.firstVertex.size(); ++i) {
        const auto points =
            std::span<const Vec3d>(mesh.positions)
                .subspan(topology.firstVertex[i], topology.firstVertex[i + 1] - topology.firstVertex[i]);
        const auto box = pipeline::boundingBox(points);
        mesh.objects.push_back(box ? ObjectBounds{*box, *pipeline::boundingSphere(points)} : ObjectBounds{});
    }
}

}  // namespace

Vec3d row3(const pipeline::AnyBuffer& buffer, std::size_t row) {
    return {buffer.flat(3 * row), buffer.flat(3 * row + 1), buffer.flat(3 * row + 2)};
}

pipeline::rays::Corners<double> cornersOf(const ViewMesh& mesh, std::uint32_t face) {
    const auto& v = mesh.faces[face].vertices;
    return {mesh.positions[v[0]], mesh.positions[v[1]], mesh.positions[v[2]]};
}

void addPolygons(const Frame& frame, const ViewMesh* before, const std::stop_token& stop, ViewMesh& mesh,
                 Bounds& bounds) {
    const pipeline::Topology& topology = frame.topology();
    const auto world = frame.buffer({BufferId::VerticesWorld});
    if (!world || world->rows() != topology.vertexCount()) return;
    mesh.positions.reserve(topology.vertexCount());
    for (std::size_t i = 0; i < topology.vertexCount(); ++i) {
        mesh.positions.push_back(row3(*world, i));
        bounds.add(mesh.positions.back());
    }
    mesh.topology = frame.sharedTopology();
    if (before && before->topology == mesh.topology && before->positions == mesh.positions) {
        mesh.edges = before->edges, mesh.meanEdge = before->meanEdge, mesh.objects = before->objects;
    } else {
        addEdges(topology, stop, mesh);
        addObjectBounds(topology, mesh);
    }
    if (stop.stop_requested()) return;
    mesh.faces.reserve(topology.triangles.size());
    for (std::size_t t = 0; t < topology.triangles.size(); ++t) {
        const auto& v = topology.triangles[t].vertices;
        mesh.faces.push_back({{v[0], v[1], v[2]}, std::int32_t(topology.polygonOf(t))});
    }
    const bool isSame = before && before->topology == mesh.topology && before->positions == mesh.positions;
    if (isSame && before->tree) {
        mesh.tree = before->tree, mesh.coarse = before->coarse;
    } else if (mesh.faces.size() > kManyTriangles) {
        constexpr int kCells = 96;  // some pixels each in a view of usual size
        auto coarse = coarseMesh(mesh.positions, topology.triangles, kCells);
        if (2 * coarse.size() < mesh.faces.size())
            mesh.coarse = std::make_shared<const std::vector<CoarseFace>>(std::move(coarse));
        constexpr std::uint32_t kLeaf = 8;  // faces: rays are few here
        mesh.tree = std::make_shared<const FaceTree>(pipeline::rays::makeTree<double>(
            std::uint32_t(mesh.faces.size()), [&](std::uint32_t face) { return cornersOf(mesh, face); }, kLeaf, stop));
    }
}

void addNormals(const Frame& frame, const std::stop_token& stop, ViewMesh& mesh) {
    if (mesh.positions.empty()) return;
    const auto read = [&](BufferId id, std::size_t count, std::vector<glm::vec3>& to) {
        const auto normals = frame.buffer({id});
        if (!normals) return;
        to.reserve(count);
        for (std::size_t i = 0; i < count && !stop.stop_requested(); ++i) {
            const Vec3d normal = row3(*normals, i);
            to.emplace_back(finite(normal) ? normal : Vec3d(0.0));
        }
    };
    read(BufferId::PolygonsNormal, frame.topology().polygonCount(), mesh.polygonNormals);
    read(BufferId::VerticesNormal, mesh.positions.size(), mesh.vertexNormals);
}

}  // namespace app
