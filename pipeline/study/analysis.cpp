#include "pipeline/study/analysis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/core/number.h"
#include "pipeline/study/analysis_text.h"
#include "pipeline/study/errors.h"

namespace pipeline {

namespace {

std::optional<double> numberOf(const std::string& text) {
    const std::optional<double> value = readNumber(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

bool isNumeric(const SweepAxis& axis) {
    return std::ranges::all_of(axis.values, [](const std::string& value) { return numberOf(value).has_value(); });
}

// A value says by itself what it is, like "gouraud", or needs its axis's name: numbers, "on", and
// what another axis has too.
std::string named(const std::vector<SweepAxis>& axes, std::size_t axis, const std::string& value) {
    bool needsName = numberOf(value) || value == "on" || value == "off";
    for (std::size_t other = 0; other < axes.size(); ++other)
        if (other != axis) needsName = needsName || std::ranges::count(axes[other].values, value) > 0;
    return needsName ? fmt::format("{} {}", withinSentence(axes[axis].label), value) : value;
}

// The values of the axes that `chosen` picks, joined.
template <class Chosen>
std::string nameOf(const std::vector<SweepAxis>& axes, const std::vector<std::string>& values, Chosen chosen) {
    std::string text;
    for (std::size_t axis = 0; axis < axes.size() && axis < values.size(); ++axis) {
        if (!chosen(axis)) continue;
        if (!text.empty()) text += ", ";
        text += named(axes, axis, values[axis]);
    }
    return text;
}

// whyNone: why the study has no such error of some points; empty.
PointAnalysis placePoint(const StudyPoint& point, const ErrorChoice& choice, const std::string& whyNone) {
    PointAnalysis result;
    if (!point.frame.empty()) {
        const SampleSummary summary = point.frame.summary();
        result.time = summary.median;
        if (summary.medianInterval) {
            result.interval = *summary.medianInterval;
        } else {
            result.interval = {summary.min, summary.min};
            for (const auto& process : point.frame.processes)
                for (const double sample : process) result.interval.second = std::max(result.interval.second, sample);
        }
    }
    const std::optional<double> error = isError(choice.measure) ? point.error(choice) : std::nullopt;
    if (error && std::isfinite(*error) && *error >= 0) result.error = error, result.drawn = point.drawn(choice);
    if (const auto leftOut = leftOutOf(choice)) result.leftOut = point.error(*leftOut);
    if (!point.failure.empty())
        result.missing = point.failure;
    else if (!result.time || !(*result.time > 0))
        result.missing = "no time was measured";
    else if (!isError(choice.measure))
        result.missing = "of this measure more is better: it is no error";
    else if (!error && result.leftOut)
        result.missing = "no pixel shows what the reference shows";
    else if (!error)
        result.missing = whyNone.empty() ? "it has no such error" : whyNone;
    else if (!result.error)
        result.missing = "its error is not a finite number";
    return result;
}

bool dominates(const PointAnalysis& a, const PointAnalysis& b) {
    const double aLeftOut = a.leftOut.value_or(0), bLeftOut = b.leftOut.value_or(0);
    if (*a.error > *b.error || aLeftOut > bLeftOut) return false;
    if (*a.error < *b.error || aLeftOut < bLeftOut) return a.timeGroup <= b.timeGroup;
    // Nothing but the time speaks for it: the two must be told apart by more than chance.
    return a.timeGroup < b.timeGroup && a.interval.second < b.interval.first;
}

void groupTimes(StudyAnalysis& analysis) {
    double first = 0;
    std::size_t group = 0;
    for (const std::size_t i : analysis.byTime) {
        const double time = *analysis.points[i].time;
        if (first == 0) first = time;
        if (time > first * (1 + kSameTime)) first = time, ++group;
        analysis.points[i].timeGroup = group;
    }
}

void findFront(StudyAnalysis& analysis) {
    groupTimes(analysis);
    std::vector<PointAnalysis>& points = analysis.points;
    std::vector<bool> dominated(points.size(), false);
    for (const std::size_t i : analysis.byTime)
        dominated[i] = std::ranges::any_of(analysis.byTime,
                                           [&](std::size_t j) { return i != j && dominates(points[j], points[i]); });
    for (const std::size_t i : analysis.byTime) {
        if (!dominated[i]) {
            analysis.front.push_back(i);
            continue;
        }
        std::optional<std::size_t> best;
        for (const std::size_t j : analysis.byTime) {
            if (i == j || !dominates(points[j], points[i])) continue;
            const auto rank = [&](std::size_t k) { return std::pair(bool(dominated[k]), *points[k].error); };
            if (!best || rank(j) < rank(*best)) best = j;
        }
        points[i].dominatedBy = best;
    }
}

void findCurves(const StudyReport& report, StudyAnalysis& analysis) {
    const auto makesMethods = [&](std::size_t axis) {
        return axis != analysis.refined && report.axes[axis].values.size() > 1;
    };
    for (std::size_t i = 0; i < report.points.size(); ++i) {
        const std::string method = nameOf(report.axes, report.points[i].values, makesMethods);
        auto curve = std::ranges::find(analysis.curves, method, &MethodCurve::name);
        if (curve == analysis.curves.end()) curve = analysis.curves.insert(curve, {method, {}, {}});
        analysis.points[i].curve = static_cast<std::size_t>(curve - analysis.curves.begin());
        if (analysis.points[i].placed()) curve->points.push_back(i);
    }
    if (!analysis.refined) return;
    const std::size_t axis = *analysis.refined;
    for (MethodCurve& curve : analysis.curves) {
        std::ranges::stable_sort(curve.points, {},
                                 [&](std::size_t i) { return numberOf(report.points[i].values[axis]).value_or(0); });
        std::vector<std::optional<double>> widths;
        std::vector<double> errors;
        for (const std::size_t i : curve.points) {
            widths.push_back(stepWidth(report.axes[axis], report.points[i].values[axis]));
            errors.push_back(*analysis.points[i].error);
        }
        curve.order = observedOrder(widths, errors);
    }
}

// Student's t of 97.5 %, for so many degrees of freedom >= 1.
double studentQuantile(std::size_t freedom) {
    constexpr double kTable[]{12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228};
    // Beyond, Cornish and Fisher's series, 1937: within 0.001.
    return freedom <= std::size(kTable) ? kTable[freedom - 1]
                                        : 1.960 + 2.372 / double(freedom) + 2.82 / (double(freedom) * double(freedom));
}

// The smallest of 1, 2, 5 times a power of ten that is not below value > 0.
double roundUp(double value) {
    const double decade = std::floor(std::log10(value));
    for (int exponent = static_cast<int>(decade) - 1;; ++exponent)
        for (const double digit : {1.0, 2.0, 5.0})
            // A quotient of exact powers is rounded once: 5e-4, not 5.000000000000001e-4.
            if (const double limit =
                    exponent < 0 ? digit / std::pow(10.0, -exponent) : digit * std::pow(10.0, exponent);
                limit >= value || !std::isfinite(limit))
                return limit;
}

}  // namespace

bool leavesOutPixels(const StudyAnalysis& analysis) {
    return std::ranges::any_of(analysis.points, [](const PointAnalysis& point) { return bool(point.leftOut); });
}

bool isError(std::string_view measure) { return measure != "PSNR" && measure != "mean SSIM"; }

std::optional<std::size_t> refinedAxis(const std::vector<SweepAxis>& axes) {
    for (std::size_t axis = axes.size(); axis-- > 0;)
        if (axes[axis].values.size() > 1 && isNumeric(axes[axis])) return axis;
    return std::nullopt;
}

std::optional<double> stepWidth(const SweepAxis& axis, const std::string& value) {
    const std::optional<double> number = numberOf(value);
    if (!number) return std::nullopt;
    const std::string_view key = axis.key;
    if (key.ends_with("bits")) return std::exp2(-*number);
    const std::string_view last = key.substr(key.find_last_of('.') + 1);
    // The picture's width is one, a light's is a length.
    const bool isResolution = last == "tessellation" || last == "samples" || key == "antialiasing" ||
                              key == "shadow.size" || key == "width" || key == "height";
    return isResolution && *number > 0 ? std::optional(1 / *number) : std::nullopt;
}

ObservedOrder observedOrder(const std::vector<std::optional<double>>& widths, const std::vector<double>& errors) {
    ObservedOrder order;
    std::vector<std::pair<double, double>> logs;  // of width and error
    const auto known = [&](std::size_t i) { return widths[i] && *widths[i] > 0 && errors[i] > 0; };
    for (std::size_t i = 0; i < errors.size(); ++i) {
        if (known(i)) logs.emplace_back(std::log(*widths[i]), std::log(errors[i]));
        if (i == 0) continue;
        std::optional<double>& step = order.steps.emplace_back();
        if (known(i - 1) && known(i) && *widths[i - 1] != *widths[i])
            step = std::log(errors[i - 1] / errors[i]) / std::log(*widths[i - 1] / *widths[i]);
    }

    double meanX = 0, meanY = 0, xx = 0, xy = 0;
    for (const auto& [x, y] : logs) {
        meanX += x / static_cast<double>(logs.size());
        meanY += y / static_cast<double>(logs.size());
    }
    for (const auto& [x, y] : logs) {
        xx += (x - meanX) * (x - meanX);
        xy += (x - meanX) * (y - meanY);
    }
    if (xx > 0) order.fit = xy / xx;
    if (xx > 0 && logs.size() > 2) {
        double rest = 0;  // sum of squares that the line leaves
        for (const auto& [x, y] : logs) {
            const double off = y - meanY - *order.fit * (x - meanX);
            rest += off * off;
        }
        const auto freedom = double(logs.size() - 2);
        order.within = studentQuantile(logs.size() - 2) * std::sqrt(rest / freedom / xx);
    }
    return order;
}

StudyAnalysis analyse(const StudyReport& report, const ErrorChoice& choice) {
    StudyAnalysis analysis;
    analysis.choice = choice;
    analysis.refined = refinedAxis(report.axes);
    // Of a model's error it says why a better reference was not taken, not why a point has none.
    const std::size_t kind = index(choice.kind);
    const bool explains = choice.kind != ErrorKind::Model || report.references[kind].empty();
    const std::string whyNone = explains ? report.whyNone[kind] : std::string();
    for (std::size_t i = 0; i < report.points.size(); ++i) {
        const StudyPoint& point = report.points[i];
        PointAnalysis& placed = analysis.points.emplace_back(placePoint(point, choice, whyNone));
        placed.label =
            nameOf(report.axes, point.values, [&](std::size_t a) { return report.axes[a].values.size() > 1; });
        if (analysis.refined) placed.step = point.values[*analysis.refined];
        if (placed.placed()) analysis.byTime.push_back(i);
        for (const ErrorRow& row : point.errors)
            if (row.buffer == choice.buffer && row.measure == choice.measure) analysis.unit = row.unit;
    }
    std::ranges::stable_sort(analysis.byTime, {}, [&](std::size_t i) {
        return std::pair(*analysis.points[i].time, *analysis.points[i].error);
    });
    findFront(analysis);
    findCurves(report, analysis);
    return analysis;
}

std::optional<std::size_t> cheapestWithin(const StudyAnalysis& analysis, double error) {
    for (const std::size_t i : analysis.byTime)
        if (*analysis.points[i].error <= error) return i;
    return std::nullopt;
}

std::optional<std::size_t> bestWithin(const StudyAnalysis& analysis, double milliseconds) {
    const auto wrong = [&](std::size_t i) {
        return std::pair(*analysis.points[i].error, analysis.points[i].leftOut.value_or(0));
    };
    std::optional<std::size_t> best;
    for (const std::size_t i : analysis.byTime)
        if (*analysis.points[i].time <= milliseconds && (!best || wrong(i) < wrong(*best))) best = i;
    return best;
}

std::optional<StudyLimits> middleOfFront(const StudyAnalysis& analysis) {
    if (analysis.front.empty()) return std::nullopt;
    const PointAnalysis& middle = analysis.points[analysis.front[analysis.front.size() / 2]];
    return StudyLimits{*middle.error > 0 ? roundUp(*middle.error) : 0, roundUp(*middle.time)};
}

std::vector<ErrorChoice> choicesOf(const StudyReport& report) {
    std::vector<ErrorChoice> choices;
    for (const StudyPoint& point : report.points)
        for (const ErrorRow& row : point.errors)
            for (std::size_t kind = 0; kind < kErrorKinds; ++kind) {
                const ErrorChoice choice{row.buffer, row.measure, static_cast<ErrorKind>(kind)};
                if (row.value[kind] && isError(row.measure) && std::ranges::find(choices, choice) == choices.end())
                    choices.push_back(choice);
            }
    return choices;
}

}  // namespace pipeline
