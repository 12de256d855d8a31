#include "pipeline/study/ray_tree.h"

#include <array>
#include <utility>

namespace pipeline::rays {
namespace {

constexpr std::uint32_t kLeaf = 4;  // triangles that are not parted any more

template <class Real>
Vec3<Real> middle(const RayTriangle<Real>& t) {
    return (t.corners[0] + t.corners[1] + t.corners[2]) / Real(3);
}

}  // namespace

template <class Real>
TriangleTree<Real> makeTree(std::vector<RayTriangle<Real>> triangles) {
    TriangleTree<Real> tree;
    tree.triangles = std::move(triangles);
    if (tree.triangles.empty()) return tree;
    tree.nodes.push_back({{}, {}, 0, std::uint32_t(tree.triangles.size())});
    for (std::size_t at = 0; at < tree.nodes.size(); ++at) {
        auto node = tree.nodes[at];
        const auto begin = tree.triangles.begin() + node.first, end = begin + node.count;
        node.low = Vec3<Real>(kInfinity<Real>), node.high = -node.low;
        Vec3<Real> low = node.low, high = node.high;  // around the triangles' middles
        for (auto t = begin; t != end; ++t) {
            for (const Vec3<Real>& corner : t->corners)
                node.low = glm::min(node.low, corner), node.high = glm::max(node.high, corner);
            low = glm::min(low, middle(*t)), high = glm::max(high, middle(*t));
        }
        if (node.count > kLeaf) {
            const Vec3<Real> side = high - low;
            const int axis = side.x >= side.y && side.x >= side.z ? 0 : side.y >= side.z ? 1 : 2;
            const std::uint32_t half = node.count / 2;
            std::nth_element(begin, begin + half, end, [&](const RayTriangle<Real>& a, const RayTriangle<Real>& b) {
                return middle(a)[axis] < middle(b)[axis];
            });
            const auto child = std::uint32_t(tree.nodes.size());
            tree.nodes.push_back({{}, {}, node.first, half});
            tree.nodes.push_back({{}, {}, node.first + half, node.count - half});
            node.first = child, node.count = 0;
        }
        tree.nodes[at] = node;
    }
    return tree;
}

template <class Real>
TriangleRay<Real>::TriangleRay(const Ray<Real>& ray) : m_ray(ray) {
    const Vec3<Real> a = glm::abs(ray.direction);
    m_z = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    m_x = (m_z + 1) % 3, m_y = (m_z + 2) % 3;
    if (ray.direction[m_z] < 0) std::swap(m_x, m_y);  // keeps the winding
    m_shear = Vec3<Real>(ray.direction[m_x], ray.direction[m_y], Real(1)) / ray.direction[m_z];
}

template <class Real>
bool TriangleRay<Real>::meets(const RayTriangle<Real>& triangle, Real& t, Vec3<Real>& weights) const {
    std::array<Vec3<Real>, 3> p;  // sheared so that the ray runs along z
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3<Real> from = triangle.corners[i] - m_ray.origin;
        const Real z = from[m_z];
        p[i] = {from[m_x] - m_shear.x * z, from[m_y] - m_shear.y * z, m_shear.z * z};
    }
    // The two products change places with the direction of an edge, and their difference its sign: exactly.
    const Vec3<Real> e{p[2].x * p[1].y - p[2].y * p[1].x, p[0].x * p[2].y - p[0].y * p[2].x,
                       p[1].x * p[0].y - p[1].y * p[0].x};
    const bool inside = (e.x >= 0 && e.y >= 0 && e.z >= 0) || (e.x <= 0 && e.y <= 0 && e.z <= 0);
    const Real sum = e.x + e.y + e.z;
    if (!inside || sum == 0) return false;
    weights = e / sum;
    t = weights.x * p[0].z + weights.y * p[1].z + weights.z * p[2].z;
    return true;
}

template <class Real>
bool TriangleRay<Real>::meetsBox(const Vec3<Real>& low, const Vec3<Real>& high, Real begin, Real end) const {
    // Of the far side a few roundings more: T. Ize, "Robust BVH ray traversal", JCGT 2013.
    constexpr Real kMore = 1 + 8 * std::numeric_limits<Real>::epsilon();
    for (int axis = 0; axis < 3; ++axis) {
        const Real o = m_ray.origin[axis], d = m_ray.direction[axis];
        if (d == 0) {
            if (o < low[axis] || o > high[axis]) return false;
            continue;
        }
        Real a = (low[axis] - o) / d, b = (high[axis] - o) / d;
        if (a > b) std::swap(a, b);
        begin = std::max(begin, a >= 0 ? a / kMore : a * kMore);
        end = std::min(end, b >= 0 ? b * kMore : b / kMore);
    }
    return begin <= end;
}

#define SHADESCOPE_INSTANTIATE(Real)                                      \
    template TriangleTree<Real> makeTree(std::vector<RayTriangle<Real>>); \
    template class TriangleRay<Real>;
SHADESCOPE_INSTANTIATE(double)
SHADESCOPE_INSTANTIATE(long double)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline::rays
