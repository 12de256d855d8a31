#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pipeline/core/real.h"

namespace pipeline {

// 1: a, b, c turn left, -1: right, 0: straight on, as far as rounding lets one tell. quantum: bound on the error of a
// coordinate.
inline int turn(const Vec2<double>& a, const Vec2<double>& b, const Vec2<double>& c, double quantum) {
    const Vec2<double> ab = b - a, bc = c - b;
    const double cross = ab.x * bc.y - ab.y * bc.x;
    const double error = 4 * quantum * (std::abs(ab.x) + std::abs(ab.y) + std::abs(bc.x) + std::abs(bc.y));
    return cross > error ? 1 : cross < -error ? -1 : 0;
}

// Points of the plane, each switched on or off, and whether one that is on lies in a triangle. A balanced tree of boxes
// (J. Bentley, "Multidimensional binary search trees used for associative searching", Communications of the ACM 1975).
class PointTree {
public:
    // points: must outlive the tree. All are off.
    explicit PointTree(const std::vector<Vec2<double>>& points, double quantum);

    bool isOn(std::uint32_t point) const { return m_on[point]; }
    void set(std::uint32_t point, bool on);

    // Whether a point that is on and is no corner of the triangle lies in it, which turns left. touching: on its edges
    // counts. visited: grows by the comparisons.
    bool anyIn(const Vec2<double>& a, const Vec2<double>& b, const Vec2<double>& c, bool touching,
               std::size_t& visited) const;

private:
    struct Node {
        Vec2<double> low{0.0}, high{0.0};
        std::uint32_t begin = 0, end = 0;  // in m_order
        std::uint32_t on = 0;              // of its points
    };
    static constexpr std::uint32_t kLeaf = 16;

    void build(std::size_t node, std::uint32_t begin, std::uint32_t end);
    bool isBeside(const Node& node, const Vec2<double>& a, const Vec2<double>& b) const;

    const std::vector<Vec2<double>>& m_points;
    double m_quantum;
    std::vector<Node> m_nodes;              // the children of node i are 2 i + 1 and 2 i + 2
    std::vector<std::uint32_t> m_order;     // points, node by node
    std::vector<std::uint32_t> m_leafNode;  // per point
    std::vector<bool> m_on;                 // per point
};

}  // namespace pipeline
