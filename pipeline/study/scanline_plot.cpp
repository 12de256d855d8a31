#include "pipeline/study/scanline_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/core/text.h"

namespace pipeline {
namespace {

using Anchor = PlotText::Anchor;

constexpr PlotInk kGrid{PlotRole::Grid, 0}, kWords{PlotRole::Secondary, 0}, kText{PlotRole::Text, 0};
constexpr std::array<const char*, 3> kShadings{"flat", "Gouraud", "Phong"}, kChannels{"red", "green", "blue"};
constexpr std::array kDashes{PlotDash::LongDash, PlotDash::Dashed, PlotDash::Solid};

// 0, 20, 40, …: multiples of a round step, at most about `most`.
std::vector<double> roundSteps(double low, double high, int most) {
    const double span = high - low;
    if (!(span > 0)) return {low};
    const double power = std::pow(10.0, std::floor(std::log10(span / most)));
    double step = power;
    for (const double digit : {2.0, 5.0, 10.0})
        if (span / step > most) step = digit * power;
    std::vector<double> steps;
    for (double k = std::ceil(low / step); k * step <= high; ++k) steps.push_back(k * step);
    return steps;
}

// A linear axis from top to bottom.
struct Rows {
    double top = 0, bottom = 1, atTop = 0, atBottom = 1;
    double place(double value) const { return top + (bottom - top) * (value - atTop) / (atBottom - atTop); }
};

struct Layout {
    const ScanlinePlot& plot;
    double u;  // size of a label's text
    ScanlineAxis x;
    PlotDrawing drawing{};
    Rows depth{}, intensity{};

    const ScanlineSection& section() const { return *plot.section; }
    void line(std::vector<Vec2<double>> points, PlotInk ink, double width, PlotDash dash = PlotDash::Solid) {
        drawing.lines.push_back({std::move(points), ink, width, dash});
    }
    void text(Vec2<double> at, Anchor anchor, std::string words, PlotInk ink, bool bold = false, bool upwards = false) {
        drawing.texts.push_back({at, anchor, std::move(words), 0.9 * u, bold, upwards, ink});
    }
    double centre(int pixel) const { return x.place(pixel + 0.5); }
};

PlotInk inkOf(int polygon) { return {PlotRole::Series, std::size_t(polygon) % kPlotColors}; }

bool hasIntensity(const ScanlineSection& section) {
    return std::ranges::any_of(section.intensity, [](const auto& values) { return !values.empty(); });
}

// The depths fill the upper part, nearest on top; the intensities the lower one.
void placeAxes(Layout& l, const PlotSize& size) {
    const ScanlineSection& section = l.section();
    l.drawing.width = size.width, l.drawing.height = size.height;
    // A low plot keeps its height for the curves; what is written needs no less than this.
    const bool isLow = size.height < 16 * l.u;
    const double top = (isLow ? 1.5 : 1.8) * l.u, bottom = size.height - (isLow ? 1.7 : 2.2) * l.u,
                 gap = (isLow ? 1.9 : 2.4) * l.u;
    const bool both = hasIntensity(section);
    const double middle = both ? top + (isLow ? 0.5 : 0.55) * (bottom - top) : bottom;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const ScanlineRun& run : section.runs)
        for (const ScanlineRun::Sample& sample : run.samples)
            low = std::min(low, sample.depth), high = std::max(high, sample.depth);
    if (low > high) low = 0, high = 1;
    const double margin = high > low ? 0.06 * (high - low) : std::max(1.0, std::abs(high)) * 0.01;
    low -= margin, high += margin;
    l.depth = {top, both ? middle - gap / 2 : bottom, section.nearIsLarger ? high : low,
               section.nearIsLarger ? low : high};
    double most = section.iMax > 0 ? section.iMax : 0;
    for (const auto& values : section.intensity)
        for (const Vec3d& value : values)
            if (std::isfinite(value[l.plot.channel])) most = std::max(most, value[l.plot.channel]);
    l.intensity = {middle + gap / 2, bottom, most > 0 ? 1.05 * most : 1, 0};
}

// The numbers at a column of pixels.
std::string numbersAt(const Layout& l, int pixel) {
    std::string words = fmt::format("x {}", pixel);
    if (const auto winner = l.section().winnerAt(pixel)) {
        for (const ScanlineRun& run : l.section().runs)
            for (const ScanlineRun::Sample& sample : run.samples)
                if (run.polygon == *winner && sample.x == pixel && sample.stays)
                    words += fmt::format(":  polygon {} at {:.7g}", *winner, sample.depth);
    } else {
        words += ":  nothing drawn";
    }
    for (std::size_t i = 0; i < kShadings.size(); ++i) {
        const auto& values = l.section().intensity[i];
        if (std::size_t(pixel) >= values.size() || !std::isfinite(values[std::size_t(pixel)][l.plot.channel])) continue;
        words += fmt::format(",  {} {:.3f}", kShadings[i], values[std::size_t(pixel)][l.plot.channel]);
    }
    return words;
}

void drawGrid(Layout& l, const std::string& told) {
    const ScanlineSection& section = l.section();
    const bool both = hasIntensity(section);
    const double foot = both ? l.intensity.bottom : l.depth.bottom;
    const int across = std::max(2, int((l.x.right - l.x.left) / (4 * l.u)));
    for (const double x : roundSteps(l.x.first, l.x.last, across)) {
        if (x != std::floor(x)) continue;  // pixels have whole numbers
        const double at = l.x.place(x + 0.5);
        if (at > l.x.right) continue;
        l.line({{at, l.depth.top}, {at, l.depth.bottom}}, kGrid, 1);
        if (both) l.line({{at, l.intensity.top}, {at, l.intensity.bottom}}, kGrid, 1);
        l.text({at, foot + 1.2 * l.u}, Anchor::Middle, shortestText(x), kWords);
    }
    l.text({l.x.right, foot + 1.2 * l.u}, Anchor::Start, "  x", kWords);
    const auto rows = [&](const Rows& axis, const std::string& name) {
        const int down = std::max(2, int((axis.bottom - axis.top) / (2 * l.u)));
        const auto [low, high] = std::minmax(axis.atTop, axis.atBottom);
        for (const double value : roundSteps(low, high, down)) {
            const double y = axis.place(value);
            l.line({{l.x.left, y}, {l.x.right, y}}, kGrid, 1);
            l.text({l.x.left - 0.5 * l.u, y + 0.3 * l.u}, Anchor::End, fmt::format("{:.6g}", value), kWords);
        }
        if (!name.empty()) l.text({l.x.left, axis.top - 0.5 * l.u}, Anchor::Start, name, kText, true);
    };
    // The numbers under the cursor stand in the same line, at its right; they come first where both have no room.
    const std::string depthName = section.storesDepth ? "depth, nearest on top" : "z_view, nearest on top";
    const double room = l.x.right - l.x.left - textWidth(told, 0.9 * l.u) - l.u;
    rows(l.depth, textWidth(depthName, 0.9 * l.u) * 1.1 < room ? depthName : std::string());
    if (!told.empty()) l.text({l.x.right, l.depth.top - 0.5 * l.u}, Anchor::End, told, kText);
    if (both) rows(l.intensity, fmt::format("intensity, {}", kChannels[std::size_t(l.plot.channel)]));
}

// A run's parts, bold where the polygon is seen and dashed where it is not; each goes half a pixel beyond its ends.
void drawRun(Layout& l, const ScanlineRun& run) {
    const auto& samples = run.samples;
    for (std::size_t i = 0; i < samples.size();) {
        std::size_t end = i + 1;
        while (end < samples.size() && samples[end].stays == samples[i].stays) ++end;
        std::vector<Vec2<double>> points;
        // Depth is affine along a row but in perspective, where it is not far from it within half a pixel.
        const auto beyond = [&](std::size_t at, std::size_t neighbour, double half) {
            const double slope =
                neighbour < samples.size() && samples[neighbour].x != samples[at].x
                    ? (samples[neighbour].depth - samples[at].depth) / (samples[neighbour].x - samples[at].x)
                    : 0;
            points.push_back({l.x.place(samples[at].x + 0.5 + half), l.depth.place(samples[at].depth + half * slope)});
        };
        beyond(i, i + 1 < samples.size() ? i + 1 : i - 1, -0.5);
        for (std::size_t k = i; k < end; ++k)
            points.push_back({l.centre(samples[k].x), l.depth.place(samples[k].depth)});
        beyond(end - 1, end - 2, 0.5);
        l.line(std::move(points), inkOf(run.polygon), samples[i].stays ? 0.22 * l.u : 0.09 * l.u,
               samples[i].stays ? PlotDash::Solid : PlotDash::Dashed);
        i = end;
    }
}

// The number of its polygon above each run that is long enough, where no other number stands.
void nameRuns(Layout& l) {
    struct Box {
        double left, right, top, bottom;
    };
    std::vector<Box> taken;
    for (const ScanlineRun& run : l.section().runs) {
        const ScanlineRun::Sample& middle = run.samples[run.samples.size() / 2];
        const std::string name = fmt::format("{}", run.polygon);
        const double width = textWidth(name, 0.9 * l.u),
                     length = l.centre(run.samples.back().x) - l.centre(run.samples.front().x);
        if (length < width) continue;
        const double x = l.centre(middle.x), y = l.depth.place(middle.depth) - 0.45 * l.u;
        const Box box{x - width / 2, x + width / 2, y - 0.9 * l.u, y};
        const bool isFree = std::ranges::none_of(taken, [&](const Box& other) {
            return box.left < other.right && other.left < box.right && box.top < other.bottom && other.top < box.bottom;
        });
        if (!isFree || box.top < l.depth.top - 0.6 * l.u) continue;
        taken.push_back(box);
        l.text({x, y}, Anchor::Middle, name, inkOf(run.polygon), true);
    }
}

void drawIntensities(Layout& l) {
    double x = l.x.right;
    for (std::size_t i = kShadings.size(); i-- > 0;) {
        const auto& values = l.section().intensity[i];
        if (values.empty()) continue;
        const PlotInk ink{PlotRole::Series, i == 0 ? 3u : i == 1 ? 0u : 4u};
        std::vector<Vec2<double>> run;
        const auto close = [&] {
            if (run.size() > 1) l.line(run, ink, i == 2 ? 2.4 : 1.8, kDashes[i]);
            run.clear();
        };
        for (int p = 0; p < int(values.size()); ++p) {
            const double value = values[std::size_t(p)][l.plot.channel];
            if (std::isfinite(value))
                run.push_back({l.centre(p), l.intensity.place(value)});
            else
                close();
        }
        close();
        // The legend, right of the axis' name.
        l.text({x, l.intensity.top - 0.5 * l.u}, Anchor::End, kShadings[i], ink, true);
        x -= textWidth(kShadings[i], 0.9 * l.u) + 0.4 * l.u;
        l.line({{x - 2.4 * l.u, l.intensity.top - 0.8 * l.u}, {x, l.intensity.top - 0.8 * l.u}}, ink,
               i == 2 ? 2.4 : 1.8, kDashes[i]);
        x -= 3.2 * l.u;
    }
}

void markColumn(Layout& l, int pixel, PlotInk ink, double width) {
    if (pixel < l.x.first || pixel >= l.x.last) return;
    const double x = l.centre(pixel);
    l.line({{x, l.depth.top}, {x, l.depth.bottom}}, ink, width);
    if (hasIntensity(l.section())) l.line({{x, l.intensity.top}, {x, l.intensity.bottom}}, ink, width);
}

}  // namespace

int ScanlineAxis::pixelAt(double at) const {
    if (!(right > left)) return int(first);
    const double x = first + (last - first) * (at - left) / (right - left);
    return int(std::floor(std::clamp(x, first, last - 1)));
}

ScanlineAxis axisOf(const ScanlineSection& section, const PlotSize& size) {
    const auto [first, last] = section.extent();
    const int margin = std::max(2, (last - first) / 40);
    return {5 * size.text, size.width - 2 * size.text, double(std::max(0, first - margin)),
            double(std::min(section.width, last + 1 + margin))};
}

PlotDrawing layOut(const ScanlinePlot& plot, const PlotSize& size) {
    Layout l{plot, size.text, axisOf(*plot.section, size)};
    placeAxes(l, size);
    const auto column = plot.hovered ? plot.hovered : plot.picked;
    drawGrid(l, column ? numbersAt(l, *column) : std::string());
    if (plot.picked) markColumn(l, *plot.picked, {PlotRole::Front, 0}, 2);
    if (plot.hovered) markColumn(l, *plot.hovered, kWords, 1);
    for (const ScanlineRun& run : plot.section->runs) drawRun(l, run);
    nameRuns(l);
    drawIntensities(l);
    return std::move(l.drawing);
}

}  // namespace pipeline
