#include "pipeline/study/plot_labels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pipeline {

namespace {

// The length of the part of a segment within a box. Y.-D. Liang, B. A. Barsky, "A new concept and
// method for line clipping", ACM Transactions on Graphics 3(1), 1984.
double lengthWithin(Vec2<double> from, Vec2<double> to, const PlotBox& box) {
    const Vec2<double> d = to - from;
    double enter = 0, leave = 1;
    const std::array<std::pair<double, double>, 4> sides{
        {{-d.x, from.x - box.left}, {d.x, box.right - from.x}, {-d.y, from.y - box.top}, {d.y, box.bottom - from.y}}};
    for (const auto& [p, q] : sides) {
        if (p == 0) {
            if (q < 0) return 0;
        } else if (p < 0) {
            enter = std::max(enter, q / p);
        } else {
            leave = std::min(leave, q / p);
        }
    }
    return enter < leave ? (leave - enter) * std::hypot(d.x, d.y) : 0;
}

struct Direction {
    double x, y;  // from the marker to the box's nearest side; 0 centres it
};
constexpr std::array kDirections{Direction{1, -1}, Direction{-1, -1}, Direction{1, 1},  Direction{-1, 1},
                                 Direction{1, 0},  Direction{-1, 0},  Direction{0, -1}, Direction{0, 1}};

}  // namespace

bool PlotBox::overlaps(const PlotBox& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
}

bool PlotBox::holds(const PlotBox& other) const {
    return left <= other.left && other.right <= right && top <= other.top && other.bottom <= bottom;
}

bool LabelPlacer::isFree(const PlotBox& box) const {
    return std::ranges::none_of(m_blocked, [&](const PlotBox& other) { return box.overlaps(other); });
}

double LabelPlacer::cost(const PlotBox& box) const {
    double crossed = 0;
    for (const Segment& segment : m_lines) crossed += lengthWithin(segment.from, segment.to, box);
    return crossed;
}

std::optional<PlotBox> LabelPlacer::place(Vec2<double> marker, double markerSize, double width, double height,
                                          bool rightFirst) {
    std::optional<PlotBox> best;
    double bestCost = 0;
    for (const double distance : {0.75, 1.5, 2.5}) {
        for (std::size_t i = 0; i < kDirections.size(); ++i) {
            const Direction& direction = kDirections[i];
            // Diagonal boxes come closer: their corner is what is near.
            const double gap = markerSize * distance * (direction.x != 0 && direction.y != 0 ? 0.7 : 1);
            PlotBox box;
            box.left = direction.x > 0   ? marker.x + gap
                       : direction.x < 0 ? marker.x - gap - width
                                         : marker.x - width / 2;
            box.top = direction.y > 0   ? marker.y + gap
                      : direction.y < 0 ? marker.y - gap - height
                                        : marker.y - height / 2;
            box.right = box.left + width;
            box.bottom = box.top + height;
            if (!m_within.holds(box) || !isFree(box)) continue;
            const bool right = direction.x > 0 && direction.y == 0;
            const double order = rightFirst && right ? -8 : static_cast<double>(i);
            const double boxCost = cost(box) + 6 * distance * markerSize / 10 + order;
            if (!best || boxCost < bestCost) {
                best = box;
                bestCost = boxCost;
            }
        }
    }
    if (best) m_blocked.push_back(*best);
    return best;
}

std::optional<PlotBox> LabelPlacer::placeIn(const PlotBox& column, double width, double height) {
    for (double top = column.top; top + height <= column.bottom; top += height / 4) {
        const PlotBox box{column.left, top, column.left + width, top + height};
        if (!isFree(box)) continue;
        m_blocked.push_back(box);
        return box;
    }
    return std::nullopt;
}

}  // namespace pipeline
