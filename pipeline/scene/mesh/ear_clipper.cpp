#include "pipeline/scene/mesh/ear_clipper.h"

#include <algorithm>

namespace pipeline {

EarClipper::EarClipper(const std::vector<Vec2<double>>& points, double quantum, std::size_t& work, StopCheck& check)
    : m_points(points),
      m_quantum(quantum),
      m_previous(points.size()),
      m_next(points.size()),
      m_blockers(points, quantum),
      m_untried(points.size()),
      m_untouched(points.size()),
      m_work(work),
      m_check(check) {
    const auto n = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t i = 0; i < n; ++i) {
        m_previous[i] = i == 0 ? n - 1 : i - 1;
        m_next[i] = i + 1 == n ? 0 : i + 1;
    }
    for (std::uint32_t i = 0; i < n; ++i) update(i);
}

// After a neighbour is another one.
void EarClipper::update(std::uint32_t i) {
    m_blockers.set(i, cornerTurn(i) <= 0);
    m_untried.insert(i), m_untouched.insert(i);
}

bool EarClipper::clip(std::vector<glm::uvec3>& triangles) {
    std::uint32_t i = 0;
    for (std::size_t left = m_points.size(); left > 3; --left) {
        const std::uint32_t ear = findEar(i);
        if (ear == IndexSet::kNone) return false;
        const std::uint32_t before = m_previous[ear], after = m_next[ear];
        triangles.emplace_back(before, ear, after);
        m_blockers.set(ear, false);
        m_untried.erase(ear), m_untouched.erase(ear);
        m_next[before] = after;
        m_previous[after] = before;
        update(before);
        update(after);
        i = m_next[after];  // not the neighbour: triangles stay less thin
    }
    triangles.emplace_back(m_previous[i], i, m_next[i]);
    return cornerTurn(i) >= 0;
}

// The first from there on; where there is none, the first that touches something.
std::uint32_t EarClipper::findEar(std::uint32_t from) {
    for (const bool lenient : {false, true}) {
        IndexSet& candidates = lenient ? m_untouched : m_untried;
        for (std::uint32_t i = candidates.from(from); i != IndexSet::kNone; i = candidates.from(i)) {
            if (isEar(i, lenient)) return i;
            if (m_work == 0 || m_check.stopped(0)) return IndexSet::kNone;
            candidates.erase(i);
        }
    }
    return IndexSet::kNone;
}

// Lenient: touching is allowed, and so is an ear without area.
bool EarClipper::isEar(std::uint32_t i, bool lenient) {
    const Vec2<double>&a = m_points[m_previous[i]], &b = m_points[i], &c = m_points[m_next[i]];
    std::size_t visited = 1;
    const bool isOne = turn(a, b, c, m_quantum) >= (lenient ? 0 : 1) && !m_blockers.anyIn(a, b, c, !lenient, visited);
    m_work -= std::min(m_work, visited);
    return !m_check.stopped(visited) && isOne && m_work > 0;
}

}  // namespace pipeline
