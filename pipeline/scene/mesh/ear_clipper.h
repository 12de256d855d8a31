#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/core/stop.h"
#include "pipeline/scene/mesh/index_set.h"
#include "pipeline/scene/mesh/point_tree.h"

namespace pipeline {

// Triangulates a simple polygon by cutting off corners that hold no other vertex
// (G. Meisters, "Polygons have ears", American Mathematical Monthly 1975).
//
// A corner that is no ear becomes one only when a neighbour is cut off: the ear would cover a part of the outside, and the
// outside only grows. So n corners are tried 3 n times at most, each in a tree of the vertices: time n log n for outlines
// as people draw them. Most sets of corners are found to be the same as by trying all of them in turn.
class EarClipper {
public:
    // points: counter-clockwise, at least 3. Takes what it compares off `work`.
    EarClipper(const std::vector<Vec2<double>>& points, double quantum, std::size_t& work, StopCheck& check);

    // False, with `triangles` unfinished, where the outline crosses itself or the work is used up, and once it
    // is stopped.
    bool clip(std::vector<glm::uvec3>& triangles);

private:
    int cornerTurn(std::uint32_t i) const {
        return turn(m_points[m_previous[i]], m_points[i], m_points[m_next[i]], m_quantum);
    }
    void update(std::uint32_t i);
    bool isEar(std::uint32_t i, bool lenient);
    std::uint32_t findEar(std::uint32_t from);

    const std::vector<Vec2<double>>& m_points;
    double m_quantum;
    std::vector<std::uint32_t> m_previous, m_next;
    PointTree m_blockers;             // only a corner that does not turn left can lie in an ear, or on its new edge
    IndexSet m_untried, m_untouched;  // corners that may be ears, and ears where touching is allowed
    std::size_t& m_work;
    StopCheck& m_check;
};

}  // namespace pipeline
