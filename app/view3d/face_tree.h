#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "app/view3d/orbit_camera.h"
#include "pipeline/study/ray_tree.h"

namespace app {

// Boxes within boxes around the faces of a mesh, so that a ray looks at few of them. Unlike pipeline::rays::TriangleTree
// it holds no corners, of which a mesh that is on show has millions already, and leaves it to others what meets a face.
class FaceTree {
public:
    // corners(i): of face i; one that has no place is on no ray.
    using Corners = std::function<std::array<Vec3d, 3>(std::uint32_t face)>;
    FaceTree(std::uint32_t faces, const Corners& corners);

    // Calls meet(face) for all faces that a ray may meet no farther away than what meet has returned last.
    template <class Meet>
    void along(const Ray& ray, Meet meet) const {
        const pipeline::rays::TriangleRay<double> line({ray.origin, ray.direction});
        double farthest = std::numeric_limits<double>::infinity();
        std::vector<std::uint32_t> open;
        if (!m_nodes.empty()) open.push_back(0);
        while (!open.empty()) {
            const Node& node = m_nodes[open.back()];
            const auto at = open.back();
            open.pop_back();
            if (!line.meetsBox(node.min, node.max, 0, farthest)) continue;
            if (node.count == 0) {
                open.push_back(node.other);
                open.push_back(at + 1);
                continue;
            }
            for (std::uint32_t i = 0; i < node.count; ++i) farthest = meet(m_faces[node.other + i]);
        }
    }

private:
    struct Node {
        Vec3d min, max;
        std::uint32_t other = 0;  // the second part, the first one being next to this; of a leaf, its first face
        std::uint32_t count = 0;  // faces of a leaf
    };
    struct Box;
    void build(std::vector<Box>& boxes, std::uint32_t begin, std::uint32_t end, double air);

    std::vector<Node> m_nodes;
    std::vector<std::uint32_t> m_faces;
};

}  // namespace app
