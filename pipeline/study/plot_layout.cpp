#include "pipeline/study/plot_layout.h"

#include <cmath>

#include "pipeline/study/plot_text.h"

namespace pipeline {

namespace {

using Place = Vec2<double>;
using Anchor = PlotText::Anchor;

void setAxes(PlotLayout& layout) {
    double xLow = 0, xHigh = 0, yLow = 0, yHigh = 0;
    eachPoint(layout.plot, [&](std::size_t, const PlotPoint& point) {
        // An interval may reach to 0; the axis then ends at the median.
        const double low = point.xLow > 0 ? point.xLow : point.x;
        xLow = layout.anyPoint ? std::min(xLow, low) : low;
        xHigh = std::max(xHigh, point.xHigh);
        layout.anyPoint = true;
        if (point.y > 0) {
            const double least = point.yLow > 0 ? point.yLow : point.y;
            yLow = layout.anyError ? std::min(yLow, least) : least;
            yHigh = std::max(yHigh, point.yHigh);
            layout.anyError = true;
        } else {
            layout.zeroRow = 2.2 * layout.u;
        }
    });
    if (layout.anyPoint) layout.x = axisAround(xLow, xHigh);
    if (!layout.anyError) return;
    // Seen where it matters: a decade below the smallest error, and above.
    if (const double bar = layout.plot.referenceError; std::isfinite(bar) && bar > yLow / 10) {
        yLow = std::min(yLow, bar);
        yHigh = std::max(yHigh, bar);
    }
    layout.y = axisAround(yLow, yHigh);
}

std::vector<Tick> yTicks(const PlotLayout& layout) {
    return ticksOf(layout.y, std::max(2, static_cast<int>((layout.area.bottom - layout.area.top) / (2 * layout.u))),
                   0.1);
}

void setArea(PlotLayout& layout, const PlotSize& size) {
    const double u = layout.u;
    layout.area.top = 4.2 * u;
    layout.area.bottom = size.height - 3.6 * u;
    layout.y.start = layout.area.bottom - layout.zeroRow;
    layout.y.end = layout.area.top;
    double widest = textWidth("0", layout.tickSize());
    if (layout.anyError)
        for (const Tick& tick : yTicks(layout)) widest = std::max(widest, textWidth(tick.label, layout.tickSize()));
    double names = 2 * u;
    for (const PlotSeries& series : layout.plot.series)
        names =
            std::max({names, textWidth(series.name, 1.05 * u) + 1.5 * u, textWidth(series.note, 0.8 * u) + 1.5 * u});
    const double most = 0.24 * size.width;
    const double column = layout.plot.omissions.empty() ? std::min(names, most) : most;
    layout.area.left = 2.4 * u + widest;
    layout.area.right = size.width - column - 0.6 * u;
    layout.column = {layout.area.right + 0.8 * u, layout.area.top, size.width - 0.4 * u, layout.area.bottom};
    layout.x.start = layout.area.left;
    layout.x.end = layout.area.right;
    layout.labels =
        LabelPlacer({layout.area.left + 2, layout.area.top + 2, size.width - 0.4 * u, layout.area.bottom - 2});
}

void drawAxes(PlotLayout& layout) {
    const PlotBox& area = layout.area;
    const double u = layout.u, size = layout.tickSize();
    layout.line({{area.left, area.bottom}, {area.right, area.bottom}}, PlotRole::Secondary, u / 14);
    layout.line({{area.left, area.top}, {area.left, area.bottom}}, PlotRole::Secondary, u / 14);
    if (layout.anyPoint) {
        double end = 0;  // of the label before
        for (const Tick& tick :
             ticksOf(layout.x, std::max(2, static_cast<int>((area.right - area.left) / (4 * u))), 1e-3)) {
            const double x = layout.x.place(tick.value), half = textWidth(tick.label, size) / 2;
            layout.line({{x, area.top}, {x, area.bottom}}, PlotRole::Grid, u / 16);
            if (x - half < end) continue;
            layout.text({x, area.bottom + 1.25 * u}, Anchor::Middle, tick.label, size, PlotRole::Secondary);
            end = x + half + 0.4 * u;
        }
    }
    if (layout.anyError) {
        for (const Tick& tick : yTicks(layout)) {
            const double y = layout.y.place(tick.value);
            layout.line({{area.left, y}, {area.right, y}}, PlotRole::Grid, u / 16);
            // Its own row is the zero's.
            if (layout.zeroRow > 0 && y > area.bottom - layout.zeroRow + 1) continue;
            layout.text({area.left - 0.5 * u, y + 0.3 * u}, Anchor::End, tick.label, size, PlotRole::Secondary);
        }
    }
    if (layout.zeroRow > 0) {
        const double y = area.bottom - layout.zeroRow;
        layout.line({{area.left, y}, {area.right, y}}, PlotRole::Secondary, u / 16, PlotDash::Dashed);
        layout.text({area.left - 0.5 * u, area.bottom - layout.zeroRow / 2 + 0.3 * u}, Anchor::End, "0", size,
                    PlotRole::Secondary);
    }
    // Below the axis nothing stands beside it.
    const double middle = (area.left + area.right) / 2;
    const double room = 2 * std::min(middle - 0.4 * u, layout.column.right - middle);
    layout.text({middle, area.bottom + 2.75 * u}, Anchor::Middle, elided(layout.plot.xLabel, 0.9 * u, room), 0.9 * u,
                PlotRole::Text);
    PlotText& label = layout.drawing.texts.emplace_back();
    label = {{1.3 * u, (area.top + area.bottom) / 2},
             Anchor::Middle,
             elided(layout.plot.yLabel, 0.9 * u, area.bottom - area.top),
             0.9 * u,
             false,
             true,
             PlotInk{PlotRole::Text, 0}};
}

// Lines along which error × time is the same: a step down costs as much as it gains.
void drawEqualProducts(PlotLayout& layout) {
    const auto log = [](double value) { return std::log10(value); };
    const double low = log(layout.x.low) + log(layout.y.low), high = log(layout.x.high) + log(layout.y.high);
    const double step = std::max(1.0, std::ceil((high - low) / 6));
    for (double k = std::ceil(low / step) * step; k < high; k += step) {
        const double from = std::max(log(layout.x.low), k - log(layout.y.high));
        const double to = std::min(log(layout.x.high), k - log(layout.y.low));
        if (to - from < 0.02) continue;
        const auto place = [&](double t) {
            return Place{layout.x.place(std::pow(10, t)), layout.y.place(std::pow(10, k - t))};
        };
        layout.line({place(from), place(to)}, PlotRole::Equal, layout.u / 12, PlotDash::Dotted);
    }
}

// What the marks mean, at the right end of the title's row; without the last where there is no room.
void drawKey(PlotLayout& layout) {
    const double u = layout.u, size = 0.8 * u, y = 1.5 * u;
    bool anyDominated = false;
    eachPoint(layout.plot, [&](std::size_t, const PlotPoint& point) { anyDominated = anyDominated || !point.onFront; });
    const auto has = [&](PlotRole role) {
        return std::ranges::any_of(layout.drawing.lines, [&](const PlotLine& line) { return line.ink.role == role; });
    };
    std::vector<std::string> entries;
    if (layout.anyPoint) entries.push_back("Pareto front");
    if (anyDominated) entries.push_back("dominated");
    if (has(PlotRole::Equal)) entries.emplace_back("equal error \u00d7 time");
    const auto width = [&](const std::string& words) { return textWidth(words, size) + 3.4 * u; };
    double left = layout.drawing.width + 0.6 * u;
    for (const std::string& words : entries) left -= width(words);
    const double end = 1.6 * u + textWidth(layout.plot.title, 1.15 * u);
    for (; left < end && !entries.empty(); entries.pop_back()) left += width(entries.back());
    for (const std::string& words : entries) {
        const Place at{left, y - 0.3 * size};
        if (words == "Pareto front")
            layout.line({{at.x, at.y - 0.35 * u},
                         {at.x + 0.9 * u, at.y - 0.35 * u},
                         {at.x + 0.9 * u, at.y + 0.35 * u},
                         {at.x + 1.8 * u, at.y + 0.35 * u}},
                        PlotRole::Front, u / 8);
        else if (words == "dominated")
            layout.drawing.markers.push_back(
                {{at.x + 1.2 * u, at.y}, PlotShape::Disc, layout.markerSize(), false, {PlotRole::Secondary, 0}, {}});
        else
            layout.line({at, {at.x + 1.8 * u, at.y}}, PlotRole::Equal, u / 12, PlotDash::Dotted);
        layout.text({left + 2.2 * u, y}, Anchor::Start, words, size, PlotRole::Secondary);
        left += width(words);
    }
}

void drawTitle(PlotLayout& layout) {
    const double u = layout.u, width = layout.drawing.width - 1.2 * u;
    layout.text({0.6 * u, 1.6 * u}, Anchor::Start, elided(layout.plot.title, 1.15 * u, width), 1.15 * u, PlotRole::Text,
                true);
    layout.text({0.6 * u, 3 * u}, Anchor::Start, elided(layout.plot.subtitle, 0.85 * u, width), 0.85 * u,
                PlotRole::Secondary);
}

// Where there is nothing to plot, why.
void drawEmptiness(PlotLayout& layout) {
    const PlotBox& area = layout.area;
    const bool isMeasured = !layout.plot.series.empty() || !layout.plot.omissions.empty();
    const std::string words = !isMeasured        ? "Nothing has been measured yet."
                              : !layout.anyPoint ? "No setting has both a time and this error."
                              : !layout.anyError ? "Every error is exactly 0."
                                                 : "";
    if (!words.empty())
        layout.text({(area.left + area.right) / 2, (area.top + area.bottom) / 2}, Anchor::Middle,
                    elided(words, layout.u, area.right - area.left), layout.u, PlotRole::Secondary);
}

}  // namespace

PlotDrawing layOut(const Plot& plot, const PlotSize& size) {
    PlotLayout layout{plot, size.text};
    layout.drawing.width = size.width;
    layout.drawing.height = size.height;
    setAxes(layout);
    setArea(layout, size);
    drawAxes(layout);
    if (layout.anyError) drawEqualProducts(layout);
    drawTitle(layout);
    drawKey(layout);
    drawEmptiness(layout);
    drawOmissions(layout);
    if (layout.anyPoint) {
        drawFront(layout);
        drawCurves(layout);
        drawNames(layout);
    }
    if (layout.anyError) drawReferenceError(layout);
    return std::move(layout.drawing);
}

}  // namespace pipeline
