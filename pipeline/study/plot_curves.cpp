#include <fmt/format.h>

#include <array>
#include <cmath>

#include "pipeline/study/plot_layout.h"
#include "pipeline/study/plot_text.h"

namespace pipeline {

namespace {

using PlotPlace = Vec2<double>;
using Anchor = PlotText::Anchor;

constexpr std::array kShapes{PlotShape::Square,       PlotShape::Triangle, PlotShape::Disc,  PlotShape::Diamond,
                             PlotShape::TriangleDown, PlotShape::Pentagon, PlotShape::Cross, PlotShape::Star};
constexpr std::array kDashes{PlotDash::Dotted, PlotDash::Dashed, PlotDash::Solid, PlotDash::DashDot,
                             PlotDash::LongDash};

PlotInk seriesInk(std::size_t series) { return {PlotRole::Series, series % kPlotColors}; }

// "phong, order 1.91"
std::string inOneLine(const PlotSeries& series) {
    return series.name.empty() || series.note.empty() ? series.name + series.note
                                                      : fmt::format("{}, {}", series.name, series.note);
}

// False where the name has no place at its curve.
bool drawName(PlotLayout& layout, std::size_t s) {
    const PlotSeries& series = layout.plot.series[s];
    const double u = layout.u, widest = 0.28 * layout.drawing.width;
    const std::string name = elided(series.name, 1.05 * u, widest);
    const double nameHeight = name.empty() ? 0 : 1.2 * u, noteHeight = series.note.empty() ? 0 : 1.05 * u;
    const double width = std::max(textWidth(name, 1.05 * u), textWidth(series.note, 0.8 * u));
    const auto box =
        layout.labels.place(layout.at(series.points.back()), layout.markerSize(), width, nameHeight + noteHeight, true);
    if (!box) return false;
    if (!name.empty())
        layout.drawing.texts.push_back(
            {{box->left, box->top + 0.95 * u}, Anchor::Start, name, 1.05 * u, true, false, seriesInk(s)});
    if (!series.note.empty())
        layout.drawing.texts.push_back({{box->left, box->top + nameHeight + 0.8 * u},
                                        Anchor::Start,
                                        series.note,
                                        0.8 * u,
                                        false,
                                        false,
                                        seriesInk(s)});
    return true;
}

void drawLegend(PlotLayout& layout, const std::vector<std::size_t>& series) {
    const double u = layout.u, size = 0.8 * u, width = layout.column.right - layout.column.left;
    for (std::size_t i = 0; i < series.size(); ++i) {
        const auto box = layout.labels.placeIn(layout.column, width, 1.3 * u);
        if (!box) return;
        const double middle = (box->top + box->bottom) / 2;
        // The last free row says how many more there are.
        const bool last = i + 1 < series.size() && box->bottom + 1.3 * u > layout.column.bottom;
        const PlotSeries& which = layout.plot.series[series[i]];
        std::string words = last ? fmt::format("and {} more", series.size() - i) : inOneLine(which);
        if (!last && textWidth(words, size) > width - 1.3 * u) words = which.name;
        layout.drawing.texts.push_back({{box->left + 1.3 * u, middle + 0.3 * size},
                                        Anchor::Start,
                                        elided(words, size, width - 1.3 * u),
                                        size,
                                        false,
                                        false,
                                        last ? PlotInk{PlotRole::Secondary, 0} : seriesInk(series[i])});
        if (last) return;
        layout.drawing.markers.push_back({{box->left + 0.5 * u, middle},
                                          kShapes[series[i] % kShapes.size()],
                                          layout.markerSize(),
                                          true,
                                          seriesInk(series[i]),
                                          {}});
    }
}

void drawLabels(PlotLayout& layout, bool ofFront) {
    const double size = 0.8 * layout.u;
    eachPoint(layout.plot, [&](std::size_t, const PlotPoint& point) {
        if (point.onFront != ofFront || point.label.empty()) return;
        const auto box =
            layout.labels.place(layout.at(point), layout.markerSize(), textWidth(point.label, size), size, false);
        if (box)
            layout.text({box->left, box->bottom - 0.12 * size}, Anchor::Start, point.label, size, PlotRole::Secondary);
    });
}

}  // namespace

void drawReferenceError(PlotLayout& layout) {
    const double bar = layout.plot.referenceError, u = layout.u;
    if (!(bar >= layout.y.low && bar <= layout.y.high)) return;
    const double y = layout.y.place(bar);
    layout.line({{layout.area.left, y}, {layout.area.right, y}}, PlotRole::Secondary, u / 12, PlotDash::LongDash);
    const std::string words = "error of the reference itself";
    const double width = textWidth(words, 0.8 * u);
    if (const auto box = layout.labels.place({layout.area.left, y}, 0.4 * u, width, u, false))
        layout.text({box->left, box->bottom - 0.25 * u}, Anchor::Start, words, 0.8 * u, PlotRole::Secondary);
}

// Each point of the front is reached by going right to it and then down.
void drawFront(PlotLayout& layout) {
    std::vector<PlotPoint> front;
    eachPoint(layout.plot, [&](std::size_t, const PlotPoint& point) {
        if (point.onFront) front.push_back(point);
    });
    if (front.empty()) return;
    std::ranges::sort(front, {}, [](const PlotPoint& point) { return std::pair(point.x, point.y); });
    std::vector<PlotPlace> steps{{layout.at(front[0]).x, layout.area.top}};
    double lowest = layout.area.top;
    for (const PlotPoint& point : front) {
        const PlotPlace place = layout.at(point);
        if (place.y <= lowest) continue;  // by accident slower and not better
        steps.push_back({place.x, lowest});
        steps.push_back(place);
        lowest = place.y;
    }
    steps.push_back({layout.area.right, lowest});
    for (std::size_t i = 1; i < steps.size(); ++i) layout.labels.line(steps[i - 1], steps[i]);
    layout.line(std::move(steps), PlotRole::Front, layout.u / 8);
}

void drawCurves(PlotLayout& layout) {
    const double size = layout.markerSize();
    for (std::size_t s = 0; s < layout.plot.series.size(); ++s) {
        const PlotSeries& series = layout.plot.series[s];
        std::vector<PlotPlace> places;
        for (const PlotPoint& point : series.points) {
            const PlotPlace place = layout.at(point);
            if (!places.empty()) layout.labels.line(places.back(), place);
            places.push_back(place);
            layout.labels.block({place.x - size / 2, place.y - size / 2, place.x + size / 2, place.y + size / 2});
            layout.drawing.markers.push_back(
                {place, kShapes[s % kShapes.size()], size, point.onFront, seriesInk(s), point.point});
            // From one end to the other, with a cap across each.
            const auto interval = [&](PlotPlace from, PlotPlace to, PlotPlace cap) {
                if (std::abs(to.x - from.x) + std::abs(to.y - from.y) < size + 3) return;  // the marker would hide it
                for (auto&& bar : {std::vector<PlotPlace>{from, to}, std::vector<PlotPlace>{from - cap, from + cap},
                                   std::vector<PlotPlace>{to - cap, to + cap}})
                    layout.drawing.lines.push_back({bar, seriesInk(s), layout.u / 10, PlotDash::Solid});
                layout.labels.line(from, to);
            };
            const double left = layout.x.place(point.xLow > 0 ? point.xLow : point.x);
            interval({left, place.y}, {layout.x.place(point.xHigh), place.y}, {0, size / 3});
            if (!(point.y > 0)) continue;
            const double low = layout.y.place(point.yLow > 0 ? point.yLow : point.y);
            interval({place.x, low}, {place.x, layout.y.place(point.yHigh)}, {size / 3, 0});
        }
        if (places.size() > 1)
            layout.drawing.lines.push_back({places, seriesInk(s), layout.u / 7, kDashes[s % kDashes.size()]});
    }
}

void drawOmissions(PlotLayout& layout) {
    const double u = layout.u, size = 0.8 * u, width = layout.column.right - layout.column.left;
    double y = layout.column.top;
    const auto row = [&](const std::string& words, double indent, PlotRole role, bool bold) {
        layout.text({layout.column.left + indent, y + 0.9 * u}, Anchor::Start, elided(words, size, width - indent),
                    size, role, bold);
        y += 1.15 * u;
    };
    for (std::size_t i = 0; i < layout.plot.omissions.size(); ++i) {
        const PlotOmission& omission = layout.plot.omissions[i];
        const std::vector<std::string> why = wrapped(omission.why, size * 1.05, width - 1.1 * u, 3);
        const std::size_t shown = omission.labels.size() <= 4 ? omission.labels.size() : 3;
        // Half of the column stays for the names of curves.
        if (i > 0 && y + 1.15 * u * static_cast<double>(why.size() + shown + 1) >
                         (layout.column.top + layout.column.bottom) / 2) {
            row(fmt::format("and {} more reasons", layout.plot.omissions.size() - i), 0, PlotRole::Failed, true);
            break;
        }
        layout.drawing.markers.push_back({{layout.column.left + 0.4 * u, y + 0.6 * u},
                                          PlotShape::Triangle,
                                          0.7 * u,
                                          true,
                                          PlotInk{PlotRole::Failed, 0},
                                          {}});
        for (const std::string& words : why) row(words, 1.1 * u, PlotRole::Failed, true);
        for (std::size_t k = 0; k < shown; ++k) row(omission.labels[k], 1.1 * u, PlotRole::Secondary, false);
        if (shown < omission.labels.size())
            row(fmt::format("and {} more", omission.labels.size() - shown), 1.1 * u, PlotRole::Secondary, false);
        y += 0.5 * u;
    }
    if (!layout.plot.omissions.empty())
        layout.labels.block({layout.column.left, layout.column.top, layout.column.right, y});
}

void drawNames(PlotLayout& layout) {
    std::vector<std::size_t> nameless;
    for (std::size_t s = 0; s < layout.plot.series.size(); ++s) {
        const PlotSeries& series = layout.plot.series[s];
        if (series.points.empty() || inOneLine(series).empty()) continue;
        if (!drawName(layout, s)) nameless.push_back(s);
    }
    drawLegend(layout, nameless);
    drawLabels(layout, true);
    drawLabels(layout, false);
}

}  // namespace pipeline
