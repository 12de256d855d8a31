#include "app/view3d/face_tree.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr std::uint32_t kLeaf = 8;  // faces

}  // namespace

struct FaceTree::Box {
    Vec3d min, max;
    std::uint32_t face;
};

FaceTree::FaceTree(std::uint32_t faces, const Corners& corners) {
    std::vector<Box> boxes;
    boxes.reserve(faces);
    double largest = 0;
    for (std::uint32_t i = 0; i < faces; ++i) {
        const auto [a, b, c] = corners(i);
        const Vec3d min = glm::min(a, glm::min(b, c)), max = glm::max(a, glm::max(b, c));
        const double reach = glm::length(a) + glm::length(b) + glm::length(c);  // NaN and infinity show in a sum
        if (!std::isfinite(reach)) continue;
        largest = std::max(largest, reach);
        boxes.push_back({min, max, i});
    }
    m_faces.reserve(boxes.size());
    // Rounding must not lead a ray past a box that holds a face on it.
    if (!boxes.empty()) build(boxes, 0, std::uint32_t(boxes.size()), 1e-12 * largest);
}

void FaceTree::build(std::vector<Box>& boxes, std::uint32_t begin, std::uint32_t end, double air) {
    Vec3d min = boxes[begin].min, max = boxes[begin].max;
    for (std::uint32_t i = begin; i < end; ++i) min = glm::min(min, boxes[i].min), max = glm::max(max, boxes[i].max);
    const auto at = m_nodes.size();
    m_nodes.push_back({min - air, max + air});
    if (end - begin <= kLeaf) {
        m_nodes[at].other = std::uint32_t(m_faces.size()), m_nodes[at].count = end - begin;
        for (std::uint32_t i = begin; i < end; ++i) m_faces.push_back(boxes[i].face);
        return;
    }
    // Half of them on each side, by their middles along the longest side.
    const Vec3d size = max - min;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(
        boxes.begin() + begin, boxes.begin() + middle, boxes.begin() + end,
        [axis](const Box& a, const Box& b) { return a.min[axis] + a.max[axis] < b.min[axis] + b.max[axis]; });
    build(boxes, begin, middle, air);
    m_nodes[at].other = std::uint32_t(m_nodes.size());
    build(boxes, middle, end, air);
}

}  // namespace app
