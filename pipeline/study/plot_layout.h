#pragma once
#include <algorithm>

#include "pipeline/study/plot.h"
#include "pipeline/study/plot_axis.h"
#include "pipeline/study/plot_labels.h"

namespace pipeline {

// The parts of layOut, in the order in which they take their places.

// The layout while it is made: what is drawn so far, and the free places.
struct PlotLayout {
    const Plot& plot;
    double u;  // size of a label's text
    PlotDrawing drawing{};
    PlotBox area{};    // between the axes
    PlotBox column{};  // right of it
    LogAxis x{}, y{};
    double zeroRow = 0;                       // height at the foot of the area for errors of 0
    bool anyPoint = false, anyError = false;  // a point; an error above 0
    LabelPlacer labels{{}};

    double tickSize() const { return 0.85 * u; }
    double markerSize() const { return 0.8 * u; }
    Vec2<double> at(const PlotPoint& point) const {
        return {x.place(point.x), point.y > 0 ? y.place(point.y) : area.bottom - zeroRow / 2};
    }
    void text(Vec2<double> place, PlotText::Anchor anchor, std::string words, double size, PlotRole role,
              bool bold = false) {
        drawing.texts.push_back({place, anchor, std::move(words), size, bold, false, PlotInk{role, 0}});
    }
    void line(std::vector<Vec2<double>> points, PlotRole role, double width, PlotDash dash = PlotDash::Solid) {
        drawing.lines.push_back({std::move(points), PlotInk{role, 0}, width, dash});
    }
};

// Visits (series, point) of all.
template <class Visit>
void eachPoint(const Plot& plot, Visit visit) {
    for (std::size_t s = 0; s < plot.series.size(); ++s)
        for (const PlotPoint& point : plot.series[s].points) visit(s, point);
}

void drawReferenceError(PlotLayout& layout);
void drawFront(PlotLayout& layout);
void drawCurves(PlotLayout& layout);
void drawOmissions(PlotLayout& layout);
// Names of methods with their notes at the ends of curves, then labels of points, those of the front
// first; the names that found no place in a legend.
void drawNames(PlotLayout& layout);

}  // namespace pipeline
