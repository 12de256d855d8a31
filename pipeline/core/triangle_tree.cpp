#include "pipeline/core/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pipeline::rays {
namespace {

template <class Real>
inline constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

template <class Real>
struct Box {
    Vec3<Real> low{kInfinity<Real>}, high{-kInfinity<Real>};
    void add(Vec3<Real> point) { low = glm::min(low, point), high = glm::max(high, point); }
    int longestSide() const {
        const Vec3<Real> side = high - low;
        return side.x >= side.y && side.x >= side.z ? 0 : side.y >= side.z ? 1 : 2;
    }
};

// Where a triangle is, for as long as the tree is made.
template <class Real>
struct Place {
    Vec3<Real> middle;
    std::uint32_t triangle;
};

template <class Real>
std::vector<Place<Real>> placesOf(std::uint32_t count, const std::function<Corners<Real>(std::uint32_t)>& corners) {
    std::vector<Place<Real>> places;
    places.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Corners<Real> c = corners(i);
        const Vec3<Real> middle = (c[0] + c[1] + c[2]) / Real(3);
        if (std::isfinite(middle.x + middle.y + middle.z)) places.push_back({middle, i});
    }
    return places;
}

// The box of a leaf, with room for what rounding does to a triangle that the ray meets at its border.
template <class Real>
Box<Real> leafBox(const TriangleTree<Real>& tree, const typename TriangleTree<Real>::Node& leaf,
                  const std::function<Corners<Real>(std::uint32_t)>& corners) {
    Box<Real> box;
    for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i)
        for (const Vec3<Real>& corner : corners(tree.order[i])) box.add(corner);
    const Vec3<Real> reach = glm::max(glm::abs(box.low), glm::abs(box.high));
    const Real air = 16 * std::numeric_limits<Real>::epsilon() * std::max({reach.x, reach.y, reach.z});
    return {box.low - air, box.high + air};
}

}  // namespace

template <class Real>
TriangleTree<Real> makeTree(std::uint32_t count, const std::function<Corners<Real>(std::uint32_t)>& corners,
                            std::uint32_t leaf, const Stop& stop) {
    TriangleTree<Real> tree;
    std::vector<Place<Real>> places = placesOf(count, corners);
    if (places.empty()) return tree;
    tree.nodes.push_back({{}, {}, 0, std::uint32_t(places.size())});
    for (std::size_t at = 0; at < tree.nodes.size(); ++at) {
        if (stop.stop_requested()) return {};
        const auto [low, high, first, size] = tree.nodes[at];
        if (size <= leaf) continue;
        const auto begin = places.begin() + first;
        Box<Real> middles;
        for (auto place = begin; place != begin + size; ++place) middles.add(place->middle);
        const std::uint32_t half = size / 2;
        std::nth_element(begin, begin + half, begin + size,
                         [axis = middles.longestSide()](const Place<Real>& a, const Place<Real>& b) {
                             return a.middle[axis] < b.middle[axis];
                         });
        tree.nodes[at].first = std::uint32_t(tree.nodes.size()), tree.nodes[at].count = 0;
        tree.nodes.push_back({{}, {}, first, half});
        tree.nodes.push_back({{}, {}, first + half, size - half});
    }
    for (const Place<Real>& place : places) tree.order.push_back(place.triangle);
    // A node stands before its children.
    for (std::size_t at = tree.nodes.size(); at-- > 0;) {
        if (stop.stop_requested()) return {};
        auto& node = tree.nodes[at];
        Box<Real> box;
        if (node.count > 0)
            box = leafBox(tree, node, corners);
        else
            for (const auto& child : {tree.nodes[node.first], tree.nodes[node.first + 1]})
                box.add(child.low), box.add(child.high);
        node.low = box.low, node.high = box.high;
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
bool TriangleRay<Real>::meets(const Corners<Real>& triangle, Real& t, Vec3<Real>& weights) const {
    std::array<Vec3<Real>, 3> p;  // sheared so that the ray runs along z
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3<Real> from = triangle[i] - m_ray.origin;
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

#define SHADESCOPE_INSTANTIATE(Real)                                                                        \
    template TriangleTree<Real> makeTree(std::uint32_t, const std::function<Corners<Real>(std::uint32_t)>&, \
                                         std::uint32_t, const Stop&);                                       \
    template class TriangleRay<Real>;
SHADESCOPE_INSTANTIATE(double)
SHADESCOPE_INSTANTIATE(long double)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline::rays
