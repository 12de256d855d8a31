#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "pipeline/core/real.h"
#include "pipeline/core/stop.h"

// Which triangle a ray meets first, of many. The stages know no rays: the ray caster that they are measured by and the 3D
// views use this. Real is double, or long double.
namespace pipeline::rays {

// The places origin + t direction, t >= 0 unless said; the direction has any length.
template <class Real>
struct Ray {
    Vec3<Real> origin{0}, direction{0};
    Vec3<Real> at(Real t) const { return origin + t * direction; }
};

template <class Real>
using Corners = std::array<Vec3<Real>, 3>;

// Where the ray's line meets a triangle, t unbounded; nothing where it does not. Two triangles that share an edge never
// both miss a ray through it.
// S. Woop, C. Benthin and I. Wald, "Watertight ray/triangle intersection", JCGT 2013.
template <class Real>
class TriangleRay {
public:
    explicit TriangleRay(const Ray<Real>& ray);
    // weights: of the corners; they sum to 1.
    bool meets(const Corners<Real>& triangle, Real& t, Vec3<Real>& weights) const;
    // Whether the box is met with begin <= t <= end, or nearly.
    bool meetsBox(const Vec3<Real>& low, const Vec3<Real>& high, Real begin, Real end) const;

private:
    Ray<Real> m_ray;
    int m_x, m_y, m_z;  // axes; z is the direction's longest
    Vec3<Real> m_shear;
};

// Boxes within boxes around triangles, halved at the median of their middles along the longest side. It holds no corners,
// of which whoever makes it has as many as it likes, in its own form.
// J. Goldsmith and J. Salmon, "Automatic creation of object hierarchies for ray tracing", IEEE CG&A 1987.
template <class Real>
struct TriangleTree {
    struct Node {
        Vec3<Real> low{0}, high{0};
        std::uint32_t first = 0, count = 0;  // of its places in `order`; count 0: children at first and first + 1
    };
    std::vector<Node> nodes;
    std::vector<std::uint32_t> order;  // the triangles, those of a leaf next to each other
};

// corners(i): of triangle i of `count`; one that is not finite is in no box. leaf: triangles that are not parted any more;
// many cost a ray time, few cost memory. Empty when it is stopped.
template <class Real>
TriangleTree<Real> makeTree(std::uint32_t count, const std::function<Corners<Real>(std::uint32_t)>& corners,
                            std::uint32_t leaf = 4, const Stop& stop = {});

// Calls visit(place, end) for what stands in boxes that are met with begin <= t <= end, by its place in `order`; visit may
// bring `end` nearer. Stops when visit gives true, which is then the result.
template <class Real, class Visit>
bool forEachNear(const TriangleTree<Real>& tree, const TriangleRay<Real>& line, Real begin, Real end, Visit visit) {
    if (tree.nodes.empty()) return false;
    std::uint32_t waiting[64];  // halving leaves no more levels than an index has bits
    int count = 0;
    waiting[count++] = 0;
    while (count > 0) {
        const auto& node = tree.nodes[waiting[--count]];
        if (!line.meetsBox(node.low, node.high, begin, end)) continue;
        if (node.count == 0) {
            waiting[count++] = node.first + 1;
            waiting[count++] = node.first;
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
            if (visit(i, end)) return true;
    }
    return false;
}

}  // namespace pipeline::rays
