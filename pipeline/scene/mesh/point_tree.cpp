#include "pipeline/scene/mesh/point_tree.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace pipeline {

PointTree::PointTree(const std::vector<Vec2<double>>& points, double quantum)
    : m_points(points),
      m_quantum(quantum),
      m_order(points.size()),
      m_leafNode(points.size(), 0),
      m_on(points.size(), false) {
    std::iota(m_order.begin(), m_order.end(), 0);
    build(0, 0, static_cast<std::uint32_t>(points.size()));
}

// Halves until few are left, across the longer side of their box.
void PointTree::build(std::size_t node, std::uint32_t begin, std::uint32_t end) {
    if (m_nodes.size() <= node) m_nodes.resize(node + 1);
    Node made{.begin = begin, .end = end};
    made.low = made.high = m_points[m_order[begin]];
    for (std::uint32_t i = begin; i < end; ++i) {
        made.low = glm::min(made.low, m_points[m_order[i]]);
        made.high = glm::max(made.high, m_points[m_order[i]]);
    }
    m_nodes[node] = made;
    if (end - begin <= kLeaf) {
        for (std::uint32_t i = begin; i < end; ++i) m_leafNode[m_order[i]] = static_cast<std::uint32_t>(node);
        return;
    }
    const Vec2<double> side = made.high - made.low;
    const int axis = side.x > side.y ? 0 : 1;
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(m_order.begin() + begin, m_order.begin() + middle, m_order.begin() + end,
                     [&](std::uint32_t i, std::uint32_t j) { return m_points[i][axis] < m_points[j][axis]; });
    build(2 * node + 1, begin, middle);
    build(2 * node + 2, middle, end);
}

void PointTree::set(std::uint32_t point, bool on) {
    if (m_on[point] == on) return;
    m_on[point] = on;
    for (std::size_t node = m_leafNode[point];; node = (node - 1) / 2) {
        on ? ++m_nodes[node].on : --m_nodes[node].on;
        if (node == 0) return;
    }
}

// Whether all of a node's box is right of the edge, by twice what rounding can make of it.
bool PointTree::isBeside(const Node& node, const Vec2<double>& a, const Vec2<double>& b) const {
    const Vec2<double> ab = b - a;
    const Vec2<double> leftmost(ab.y < 0 ? node.high.x : node.low.x, ab.x > 0 ? node.high.y : node.low.y);
    const Vec2<double> to = leftmost - b, far = glm::max(glm::abs(node.low - b), glm::abs(node.high - b));
    const double error = 8 * m_quantum * (std::abs(ab.x) + std::abs(ab.y) + far.x + far.y);
    return ab.x * to.y - ab.y * to.x < -error;
}

bool PointTree::anyIn(const Vec2<double>& a, const Vec2<double>& b, const Vec2<double>& c, bool touching,
                      std::size_t& visited) const {
    const int least = touching ? 0 : 1;
    const auto lies = [&](const Vec2<double>& p) {
        if (p == a || p == b || p == c) return false;
        return turn(a, b, p, m_quantum) >= least && turn(b, c, p, m_quantum) >= least &&
               turn(c, a, p, m_quantum) >= least;
    };
    std::array<std::size_t, 64> stack;  // two a level, and 2^32 points at most
    std::size_t height = 0;
    stack[height++] = 0;
    while (height > 0) {
        const std::size_t at = stack[--height];
        const Node& node = m_nodes[at];
        ++visited;
        if (node.on == 0 || isBeside(node, a, b) || isBeside(node, b, c) || isBeside(node, c, a)) continue;
        if (node.end - node.begin > kLeaf) {
            stack[height++] = 2 * at + 2;
            stack[height++] = 2 * at + 1;
            continue;
        }
        visited += node.end - node.begin;
        for (std::uint32_t i = node.begin; i < node.end; ++i)
            if (m_on[m_order[i]] && lies(m_points[m_order[i]])) return true;
    }
    return false;
}

}  // namespace pipeline
