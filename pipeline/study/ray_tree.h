#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "pipeline/study/ray_math.h"

namespace pipeline::rays {

template <class Real>
struct RayTriangle {
    std::array<Vec3<Real>, 3> corners{};                  // world space
    std::uint32_t object = 0, polygon = 0, triangle = 0;  // polygon and triangle within the object's mesh
};

// Where a ray meets a triangle first.
template <class Real>
struct TriangleHit {
    Real t = kInfinity<Real>;
    std::uint32_t triangle = ~0u;  // index into TriangleTree::triangles
    Vec3<Real> weights{0};         // of its corners; they sum to 1
    bool any() const { return triangle != ~0u; }
};

// Triangles in a tree of boxes, halved at the median along their longest side.
// J. Goldsmith and J. Salmon, "Automatic creation of object hierarchies for ray tracing", IEEE CG&A 1987.
template <class Real>
struct TriangleTree {
    struct Node {
        Vec3<Real> low{0}, high{0};
        std::uint32_t first = 0, count = 0;  // of its triangles; count 0: children at first and first + 1
    };
    std::vector<RayTriangle<Real>> triangles;
    std::vector<Node> nodes;
};

template <class Real>
TriangleTree<Real> makeTree(std::vector<RayTriangle<Real>> triangles);

// Where the ray's line meets a triangle, t unbounded; nothing where it does not. Two triangles that share an edge never
// both miss a ray through it.
// S. Woop, C. Benthin and I. Wald, "Watertight ray/triangle intersection", JCGT 2013.
template <class Real>
class TriangleRay {
public:
    explicit TriangleRay(const Ray<Real>& ray);
    bool meets(const RayTriangle<Real>& triangle, Real& t, Vec3<Real>& weights) const;
    // Whether the box is met with begin <= t <= end, or nearly.
    bool meetsBox(const Vec3<Real>& low, const Vec3<Real>& high, Real begin, Real end) const;

private:
    Ray<Real> m_ray;
    int m_x, m_y, m_z;  // axes; z is the direction's longest
    Vec3<Real> m_shear;
};

// Calls visit(triangle's index, t, weights, end) for triangles that are met with begin <= t <= end; visit may bring `end`
// nearer. Stops when visit gives true, which is then the result.
template <class Real, class Visit>
bool forEachMet(const TriangleTree<Real>& tree, const Ray<Real>& ray, Real begin, Real end, Visit visit) {
    if (tree.nodes.empty()) return false;
    const TriangleRay<Real> line(ray);
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
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            Real t;
            Vec3<Real> weights;
            if (!line.meets(tree.triangles[i], t, weights) || !(t >= begin && t <= end)) continue;
            if (visit(i, t, weights, end)) return true;
        }
    }
    return false;
}

}  // namespace pipeline::rays
