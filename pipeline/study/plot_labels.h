#pragma once
#include <optional>
#include <vector>

#include "pipeline/core/real.h"

namespace pipeline {

// A rectangle in points.
struct PlotBox {
    double left = 0, top = 0, right = 0, bottom = 0;
    bool overlaps(const PlotBox& other) const;
    bool holds(const PlotBox& other) const;
};

// Finds free places for texts beside points: none overlaps what stands already, and of the free
// places one is taken that the fewest lines cross.
class LabelPlacer {
public:
    explicit LabelPlacer(const PlotBox& within) : m_within(within) {}

    void block(const PlotBox& box) { m_blocked.push_back(box); }
    void line(Vec2<double> from, Vec2<double> to) { m_lines.push_back({from, to}); }

    // The place of a box of this size beside a marker; nothing where none is free. It is blocked
    // from then on. `rightFirst`: to the right where nothing speaks against it, as names at a
    // curve's end.
    std::optional<PlotBox> place(Vec2<double> marker, double markerSize, double width, double height, bool rightFirst);
    // The highest free place in a column, from its top on; blocked from then on.
    std::optional<PlotBox> placeIn(const PlotBox& column, double width, double height);

private:
    struct Segment {
        Vec2<double> from, to;
    };
    bool isFree(const PlotBox& box) const;
    double cost(const PlotBox& box) const;

    PlotBox m_within;
    std::vector<PlotBox> m_blocked;
    std::vector<Segment> m_lines;
};

}  // namespace pipeline
