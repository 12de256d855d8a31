#include "app/check/check_plot_layout.h"

#include <algorithm>
#include <cmath>

#include "pipeline/core/text.h"
#include "pipeline/study/plot_axis.h"

namespace app {
namespace {

using namespace pipeline;
using Anchor = PlotText::Anchor;
using Place = Vec2<double>;

constexpr PlotInk kNaive{PlotRole::Failed, 0}, kOurs{PlotRole::Series, 4};
constexpr PlotInk kGrid{PlotRole::Grid, 0}, kWords{PlotRole::Secondary, 0}, kBound{PlotRole::Secondary, 0};

bool shown(double error) { return std::isfinite(error) && error >= 0; }

std::vector<Tick> linearTicks(double low, double high, int most) {
    std::vector<Tick> ticks;
    for (const double value : roundSteps(low, high, most)) ticks.push_back({value, shortestText(value)});
    return ticks;
}

struct Layout {
    const KnobPlot& plot;
    double u;  // size of a label's text
    PlotDrawing drawing{};
    double left = 0, right = 0, top = 0, bottom = 0;
    LogAxis y{};
    bool zeros = false;

    const check::Knob& knob() const { return plot.which->knob; }
    double zeroPlace() const { return bottom - u; }
    double xOf(double at) const {
        const LogAxis log{knob().low, knob().high, left, right};
        return knob().logarithmic ? log.place(at)
                                  : left + (right - left) * (at - knob().low) / (knob().high - knob().low);
    }
    double yOf(double error) const { return error > 0 ? y.place(error) : zeroPlace(); }
    void line(std::vector<Place> points, PlotInk ink, double width, PlotDash dash = PlotDash::Solid) {
        drawing.lines.push_back({std::move(points), ink, width, dash});
    }
    void text(Place at, Anchor anchor, std::string words, PlotInk ink, bool bold = false, bool upwards = false) {
        drawing.texts.push_back({at, anchor, std::move(words), 0.9 * u, bold, upwards, ink});
    }
};

std::string boundWords(const check::Case& which) { return "bound " + check::measured(which.bound, which.unit); }

void placeAxes(Layout& l, const PlotSize& size) {
    const check::Case& which = *l.plot.which;
    double smallest = 0, largest = 0;
    const auto take = [&](double error) {
        if (!shown(error)) return;
        if (error == 0) l.zeros = true;
        if (error > 0) smallest = smallest > 0 ? std::min(smallest, error) : error, largest = std::max(largest, error);
    };
    for (const KnobErrors& errors : l.plot.curve) take(errors.naive), take(errors.ours);
    if (l.plot.now) take(l.plot.now->naive), take(l.plot.now->ours);
    take(which.bound);
    l.drawing.width = size.width, l.drawing.height = size.height;
    l.left = 5.2 * l.u;
    l.right = size.width - std::max(5 * l.u, textWidth(boundWords(which), 0.9 * l.u) + 1.2 * l.u);
    l.top = 1.2 * l.u;
    l.bottom = size.height - 3.6 * l.u;
    l.y = smallest > 0 ? axisAround(smallest, largest) : LogAxis{0.1, 1};
    l.y.start = l.bottom - (l.zeros ? 2 * l.u : 0);
    l.y.end = l.top;
}

void drawAxes(Layout& l) {
    const check::Knob& knob = l.knob();
    const int across = std::max(2, int((l.right - l.left) / (5 * l.u)));
    const int down = std::max(2, int((l.y.start - l.y.end) / (2.2 * l.u)));
    // Numbers of one axis are all written as powers of ten, or none is.
    const double xPlain = knob.low >= 1 ? 1 : 1e5;
    const double yPlain = l.y.low >= 1e-3 && l.y.high <= 1e4 ? 1e-3 : 1e5;
    for (const Tick& tick : knob.logarithmic ? ticksOf({knob.low, knob.high, l.left, l.right}, across, xPlain)
                                             : linearTicks(knob.low, knob.high, across)) {
        const double x = l.xOf(tick.value);
        l.line({{x, l.top}, {x, l.bottom}}, kGrid, 1);
        l.text({x, l.bottom + 1.3 * l.u}, Anchor::Middle, tick.label, kWords);
    }
    const auto row = [&](double height, const std::string& label) {
        l.line({{l.left, height}, {l.right, height}}, kGrid, 1);
        l.text({l.left - 0.5 * l.u, height + 0.3 * l.u}, Anchor::End, label, kWords);
    };
    for (const Tick& tick : ticksOf(l.y, down, yPlain)) row(l.y.place(tick.value), tick.label);
    if (l.zeros) row(l.zeroPlace(), "0");
    const check::Case& which = *l.plot.which;
    const std::string unit = which.unit.empty() ? "" : " (" + std::string(which.unit) + ")";
    l.text({(l.left + l.right) / 2, l.bottom + 2.8 * l.u}, Anchor::Middle, std::string(knob.label), kWords);
    l.text({1.1 * l.u, (l.top + l.bottom) / 2}, Anchor::Middle, std::string(which.measure) + unit, kWords, false, true);
}

void drawCurve(Layout& l, double KnobErrors::*form, PlotInk ink, PlotDash dash) {
    std::vector<Place> run;
    const auto close = [&] {
        if (run.size() > 1) l.line(run, ink, 2, dash);
        run.clear();
    };
    for (const KnobErrors& errors : l.plot.curve) {
        if (shown(errors.*form))
            run.push_back({l.xOf(errors.at), l.yOf(errors.*form)});
        else
            close();
    }
    close();
}

// Names of the lines at their right ends, kept apart.
void drawNames(Layout& l) {
    struct Name {
        double height;
        std::string words;
        PlotInk ink;
        bool bold;
    };
    std::vector<Name> names;
    const auto add = [&](double KnobErrors::*form, const char* words, PlotInk ink) {
        const auto last = std::find_if(l.plot.curve.rbegin(), l.plot.curve.rend(),
                                       [&](const KnobErrors& errors) { return shown(errors.*form); });
        if (last != l.plot.curve.rend()) names.push_back({l.yOf((*last).*form), words, ink, true});
    };
    add(&KnobErrors::naive, "naive", kNaive);
    names.push_back({l.yOf(l.plot.which->bound), boundWords(*l.plot.which), kBound, false});
    add(&KnobErrors::ours, "ours", kOurs);
    std::ranges::stable_sort(names, {}, &Name::height);
    const double apart = 1.3 * l.u;
    for (std::size_t i = 1; i < names.size(); ++i)
        names[i].height = std::max(names[i].height, names[i - 1].height + apart);
    // What was pushed beneath the foot comes up again, and pushes the others.
    double most = l.bottom;
    for (std::size_t i = names.size(); i-- > 0; most = names[i].height - apart)
        names[i].height = std::min(names[i].height, most);
    for (Name& name : names)
        l.text({l.right + 0.8 * l.u, name.height + 0.3 * l.u}, Anchor::Start, std::move(name.words), name.ink,
               name.bold);
}

void drawNow(Layout& l) {
    const double x = l.xOf(std::clamp(l.plot.at, l.knob().low, l.knob().high));
    l.line({{x, l.top}, {x, l.bottom}}, {PlotRole::Text, 0}, 1);
    if (!l.plot.now) return;
    const KnobErrors& now = *l.plot.now;
    const bool before = x > (l.left + l.right) / 2;
    const bool naiveAbove = !shown(now.naive) || (shown(now.ours) && now.naive >= now.ours);
    const auto number = [&](double error, PlotInk ink, bool above) {
        // What is no number has no place: its word stands at the top.
        double height = shown(error) ? l.yOf(error) : l.top;
        if (shown(error)) l.drawing.markers.push_back({{x, height}, PlotShape::Disc, 0.75 * l.u, false, ink, {}});
        height = std::clamp(height + (above ? -0.6 : 1.2) * l.u, l.top + 0.9 * l.u, l.bottom - 0.2 * l.u);
        l.text({x + (before ? -0.7 : 0.7) * l.u, height}, before ? Anchor::End : Anchor::Start,
               check::measured(error, l.plot.which->unit), ink, true);
    };
    number(now.naive, kNaive, naiveAbove);
    number(now.ours, kOurs, !naiveAbove);
}

}  // namespace

PlotDrawing layOut(const KnobPlot& plot, const PlotSize& size) {
    Layout l{plot, size.text};
    placeAxes(l, size);
    drawAxes(l);
    const double bound = l.yOf(plot.which->bound);
    l.line({{l.left, bound}, {l.right, bound}}, kBound, 2, PlotDash::Dotted);
    drawCurve(l, &KnobErrors::naive, kNaive, PlotDash::Dashed);
    drawCurve(l, &KnobErrors::ours, kOurs, PlotDash::Solid);
    drawNames(l);
    drawNow(l);
    return std::move(l.drawing);
}

}  // namespace app
