#include "pipeline/study/scanline_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/core/text.h"
#include "pipeline/study/plot_axis.h"

namespace pipeline {
namespace {

using Anchor = PlotText::Anchor;

constexpr PlotInk kGrid{PlotRole::Grid, 0}, kWords{PlotRole::Secondary, 0}, kText{PlotRole::Text, 0};
constexpr std::array<const char*, 3> kShadings{"flat", "Gouraud", "Phong"}, kChannels{"red", "green", "blue"};
constexpr double kLow = 16, kWide = 36;  // sizes of a label's text
constexpr double kBold = 1.1;            // how much wider bold letters are
constexpr std::array kShadingDashes{PlotDash::LongDash, PlotDash::Dashed, PlotDash::Solid};

// A linear axis from top to bottom.
struct Rows {
    double top = 0, bottom = 1, atTop = 0, atBottom = 1;
    double place(double value) const { return top + (bottom - top) * (value - atTop) / (atBottom - atTop); }
};

struct Layout {
    const ScanlinePlot& plot;
    double u;  // size of a label's text
    ScanlineAxes x;
    PlotDrawing drawing{};
    Rows depth{}, intensity{};
    double names = 0;  // the line above the plots, in which their names stand

    const ScanlineSection& section() const { return *plot.section; }
    void line(std::vector<Vec2<double>> points, PlotInk ink, double width, PlotDash dash = PlotDash::Solid) {
        drawing.lines.push_back({std::move(points), ink, width, dash});
    }
    void text(Vec2<double> at, Anchor anchor, std::string words, PlotInk ink, bool bold = false, bool upwards = false) {
        if (!words.empty()) drawing.texts.push_back({at, anchor, std::move(words), 0.9 * u, bold, upwards, ink});
    }
};

PlotInk inkOf(int polygon) { return {PlotRole::Series, std::size_t(polygon) % kPlotColors}; }
PlotInk inkOfShading(std::size_t i) { return {PlotRole::Series, i == 0 ? 3u : i == 1 ? 0u : 4u}; }
double widthOfShading(std::size_t i) { return i == 2 ? 2.4 : 1.8; }

bool hasIntensity(const ScanlineSection& section) {
    return std::ranges::any_of(section.intensity, [](const auto& values) { return !values.empty(); });
}

// The depths fill the upper part, nearest on top; the intensities the lower one. Beside each other both have all of the
// height, below a line for the numbers.
void placeAxes(Layout& l, const PlotSize& size) {
    const ScanlineSection& section = l.section();
    l.drawing.width = size.width, l.drawing.height = size.height;
    // A low plot keeps its height for the curves; what is written needs no less than this.
    const bool isLow = size.height < kLow * l.u;
    const double top = (l.x.isBeside ? 3
                        : isLow      ? 1.5
                                     : 1.8) *
                       l.u,
                 bottom = size.height - (isLow ? 1.7 : 2.2) * l.u, gap = (isLow ? 1.9 : 2.4) * l.u;
    l.names = top - 0.5 * l.u;
    const bool shares = hasIntensity(section) && !l.x.isBeside;
    const double middle = shares ? top + (isLow ? 0.5 : 0.55) * (bottom - top) : bottom;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    bool isSingle = true;
    for (const ScanlineRun& run : section.runs)
        for (const ScanlineRun::Sample& sample : run.samples) {
            low = std::min(low, sample.depth), high = std::max(high, sample.depth);
            isSingle = isSingle && double(float(sample.depth)) == sample.depth;
        }
    if (low > high) low = 0, high = 1;
    // Of one depth, but for rounding: that is no relief to fill the plot with.
    const double largest = std::max(std::abs(low), std::abs(high)), unit = isSingle ? 0x1p-24 : 0x1p-53;
    const bool isLevel = high - low <= 128 * unit * largest;
    const double margin = !isLevel ? 0.06 * (high - low) : largest > 0 ? 0x1p14 * unit * largest : 1;
    low -= margin, high += margin;
    l.depth = {top, shares ? middle - gap / 2 : bottom, section.nearIsLarger ? high : low,
               section.nearIsLarger ? low : high};
    double most = section.iMax > 0 ? section.iMax : 0;
    for (const auto& values : section.intensity)
        for (const Vec3d& value : values)
            if (std::isfinite(value[l.plot.channel])) most = std::max(most, value[l.plot.channel]);
    l.intensity = {shares ? middle + gap / 2 : top, bottom, most > 0 ? 1.05 * most : 1, 0};
}

// The depth at a column of pixels, where there is room for it with its polygon.
std::string depthAt(const Layout& l, int pixel, bool named = true) {
    std::string words = fmt::format("x {}", pixel);
    const auto winner = l.section().winnerAt(pixel);
    if (!winner) return words + (l.section().isShadedAt(pixel) ? ":  layers alone" : ":  nothing drawn");
    for (const ScanlineRun& run : l.section().runs)
        for (const ScanlineRun::Sample& sample : run.samples)
            if (run.polygon == *winner && sample.x == pixel && sample.stays)
                words += named ? fmt::format(":  polygon {} at {:.7g}", *winner, sample.depth)
                               : fmt::format(":  {:.7g}", sample.depth);
    return words;
}

// "flat 0.213": of a shading method, where it has a number there; else its name.
std::string intensityAt(const Layout& l, std::size_t shading, std::optional<int> pixel) {
    const auto& values = l.section().intensity[shading];
    if (!pixel || std::size_t(*pixel) >= values.size() || !std::isfinite(values[std::size_t(*pixel)][l.plot.channel]))
        return kShadings[shading];
    return fmt::format("{} {:.3f}", kShadings[shading], values[std::size_t(*pixel)][l.plot.channel]);
}

double widthOf(const Layout& l, const std::string& words) { return textWidth(words, 0.9 * l.u); }

// The first that has room; the last where none has.
std::string fitting(const Layout& l, double room, const std::vector<std::string>& words) {
    const auto fits = [&](const std::string& some) { return widthOf(l, some) <= room; };
    const auto found = std::ranges::find_if(words, fits);
    return found == words.end() ? words.back() : *found;
}

// The depth and the intensities at a column of pixels, with as many words as there is room for.
std::string numbersAt(const Layout& l, int pixel) {
    std::string numbers;
    for (std::size_t i = 0; i < kShadings.size(); ++i)
        if (const std::string number = intensityAt(l, i, pixel); number != kShadings[i])
            numbers += (numbers.empty() ? "" : ",  ") + number;
    const std::string named = depthAt(l, pixel), unnamed = depthAt(l, pixel, false), place = fmt::format("x {}", pixel);
    if (numbers.empty()) return fitting(l, l.x.depth.right, {named, unnamed, place});
    const std::string with = ",  " + numbers;
    return fitting(l, l.x.depth.right, {named + with, unnamed + with, place + with, numbers, unnamed, place});
}

// The shading methods above the intensities, each with a sample of its line, in sizes of a label's text.
struct Legend {
    double sample, gap;
    std::array<std::string, kShadings.size()> words;  // empty where a method has no values

    Legend(const Layout& l, std::optional<int> column, bool isNarrow)
        : sample(isNarrow ? 1.4 : 2.4), gap(isNarrow ? 0.5 : 0.8) {
        for (std::size_t i = 0; i < words.size(); ++i)
            if (!l.section().intensity[i].empty()) words[i] = intensityAt(l, i, column);
    }
    double width(const Layout& l) const {
        double sum = 0;
        for (const std::string& word : words)
            if (!word.empty()) sum += widthOf(l, word) + (0.4 + sample + gap) * l.u;
        return sum;
    }
};

// Above both plots, with the numbers of a column; or right of the axis' name, narrow where that has no room else.
Legend legendOf(const Layout& l, std::optional<int> column, const std::string& name) {
    if (l.x.isBeside) return {l, column, true};
    const Legend wide(l, std::nullopt, false);
    const double room = l.x.intensity.right - l.x.intensity.left;
    return widthOf(l, name) * kBold + wide.width(l) <= room ? wide : Legend(l, std::nullopt, true);
}

// The pixels along a plot's foot.
void drawColumns(Layout& l, const ScanlineAxis& axis, const std::vector<Rows>& plots) {
    const double foot = plots.back().bottom;
    const int across = std::max(2, int((axis.right - axis.left) / (4 * l.u)));
    for (const double x : roundSteps(axis.first, axis.last, across)) {
        if (x != std::floor(x)) continue;  // pixels have whole numbers
        const double at = axis.place(x + 0.5);
        if (at > axis.right) continue;
        for (const Rows& rows : plots) l.line({{at, rows.top}, {at, rows.bottom}}, kGrid, 1);
        l.text({at, foot + 1.2 * l.u}, Anchor::Middle, shortestText(x), kWords);
    }
    l.text({axis.right, foot + 1.2 * l.u}, Anchor::Start, "  x", kWords);
}

void drawRows(Layout& l, const Rows& axis, const ScanlineAxis& x, const std::string& name) {
    const int down = std::max(2, int((axis.bottom - axis.top) / (2 * l.u)));
    const auto [low, high] = std::minmax(axis.atTop, axis.atBottom);
    for (const double value : roundSteps(low, high, down)) {
        const double y = axis.place(value);
        l.line({{x.left, y}, {x.right, y}}, kGrid, 1);
        l.text({x.left - 0.5 * l.u, y + 0.3 * l.u}, Anchor::End, shortestText(value), kWords);
    }
    l.text({x.left, axis.top - 0.5 * l.u}, Anchor::Start, name, kText, true);
}

void drawLegend(Layout& l, const Legend& legend, std::optional<int> column) {
    double x = l.x.intensity.right;
    const double y = l.x.isBeside ? l.names - 1.4 * l.u : l.intensity.top - 0.5 * l.u;
    for (std::size_t i = kShadings.size(); i-- > 0;) {
        if (legend.words[i].empty()) continue;
        const PlotInk ink = inkOfShading(i);
        x -= widthOf(l, legend.words[i]);
        l.text({x, y}, Anchor::Start, legend.words[i], ink, true);  // beside its sample, whatever the font
        x -= 0.4 * l.u;
        const double begin = x - legend.sample * l.u;
        l.line({{begin, y - 0.3 * l.u}, {x, y - 0.3 * l.u}}, ink, widthOfShading(i), kShadingDashes[i]);
        x = begin - legend.gap * l.u;
    }
    if (!l.x.isBeside || !column) return;
    // At its left the depth there.
    const std::string told = fitting(
        l, x - l.x.depth.left, {depthAt(l, *column), depthAt(l, *column, false), fmt::format("x {}", *column), ""});
    l.text({l.x.depth.left, y}, Anchor::Start, told, kText);
}

void drawGrid(Layout& l, std::optional<int> column) {
    const ScanlineSection& section = l.section();
    const bool both = hasIntensity(section);
    if (l.x.isBeside || !both) drawColumns(l, l.x.depth, {l.depth});
    if (both)
        drawColumns(l, l.x.intensity, l.x.isBeside ? std::vector{l.intensity} : std::vector{l.depth, l.intensity});
    std::string depthName = section.storesDepth ? "depth, nearest on top" : "z_view, nearest on top";
    if (!l.x.isBeside && column) {
        const std::string told = numbersAt(l, *column);
        // The numbers stand in the same line, at its right; they come first where both have no room.
        const double room = l.x.depth.right - l.x.depth.left - widthOf(l, told) - l.u;
        if (widthOf(l, depthName) * kBold >= room) depthName.clear();
        l.text({l.x.depth.right, l.names}, Anchor::End, told, kText);
    }
    drawRows(l, l.depth, l.x.depth, depthName);
    if (!both) return;
    const std::string channel = kChannels[std::size_t(l.plot.channel)];
    std::string name = "intensity, " + channel;
    const Legend legend = legendOf(l, column, name);
    if (!l.x.isBeside)
        name = fitting(l, (l.x.intensity.right - l.x.intensity.left - legend.width(l)) / kBold, {name, channel, ""});
    drawRows(l, l.intensity, l.x.intensity, name);
    drawLegend(l, legend, column);
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
            const double y = l.depth.place(samples[at].depth + half * slope);
            points.push_back({l.x.depth.place(samples[at].x + 0.5 + half), std::clamp(y, l.depth.top, l.depth.bottom)});
        };
        beyond(i, i + 1 < samples.size() ? i + 1 : i - 1, -0.5);
        for (std::size_t k = i; k < end; ++k)
            points.push_back({l.x.depth.centre(samples[k].x), l.depth.place(samples[k].depth)});
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
                     length = l.x.depth.centre(run.samples.back().x) - l.x.depth.centre(run.samples.front().x);
        if (length < width) continue;
        const double x = l.x.depth.centre(middle.x), y = l.depth.place(middle.depth) - 0.45 * l.u;
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
    for (std::size_t i = kShadings.size(); i-- > 0;) {
        const auto& values = l.section().intensity[i];
        std::vector<Vec2<double>> run;
        const auto close = [&] {
            if (run.size() > 1) l.line(run, inkOfShading(i), widthOfShading(i), kShadingDashes[i]);
            run.clear();
        };
        for (int p = 0; p < int(values.size()); ++p) {
            const double value = values[std::size_t(p)][l.plot.channel];
            if (std::isfinite(value))
                run.push_back({l.x.intensity.centre(p), l.intensity.place(value)});
            else
                close();
        }
        close();
    }
}

void markColumn(Layout& l, int pixel, PlotInk ink, double width) {
    const auto mark = [&](const ScanlineAxis& axis, const Rows& rows) {
        if (pixel < axis.first || pixel >= axis.last) return;
        const double x = axis.centre(pixel);
        l.line({{x, rows.top}, {x, rows.bottom}}, ink, width);
    };
    mark(l.x.depth, l.depth);
    if (hasIntensity(l.section())) mark(l.x.intensity, l.intensity);
}

}  // namespace

int ScanlineAxis::pixelAt(double at) const {
    if (!(right > left)) return int(first);
    const double x = first + (last - first) * (at - left) / (right - left);
    return int(std::floor(std::clamp(x, first, last - 1)));
}

ScanlineAxes axesOf(const ScanlineSection& section, const PlotSize& size) {
    const auto [first, last] = section.extent();
    const int margin = std::max(2, (last - first) / 40);
    const double u = size.text, before = 5 * u, after = 2 * u;
    ScanlineAxes axes;
    axes.depth = {before, size.width - after, double(std::max(0, first - margin)),
                  double(std::min(section.width, last + 1 + margin))};
    axes.intensity = axes.depth;
    axes.isBeside = hasIntensity(section) && size.height < kLow * u && size.width > kWide * u;
    if (axes.isBeside) {
        axes.depth.right = before + (size.width - 2 * before - after) / 2;
        axes.intensity.left = axes.depth.right + before;
    }
    return axes;
}

PlotDrawing layOut(const ScanlinePlot& plot, const PlotSize& size) {
    Layout l{plot, size.text, axesOf(*plot.section, size)};
    placeAxes(l, size);
    const auto column = plot.hovered ? plot.hovered : plot.picked;
    drawGrid(l, column);
    if (plot.picked) markColumn(l, *plot.picked, {PlotRole::Front, 0}, 2);
    if (plot.hovered) markColumn(l, *plot.hovered, kWords, 1);
    for (const ScanlineRun& run : plot.section->runs) drawRun(l, run);
    nameRuns(l);
    drawIntensities(l);
    return std::move(l.drawing);
}

}  // namespace pipeline
