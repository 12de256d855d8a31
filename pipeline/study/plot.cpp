#include "pipeline/study/plot.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/study/analysis_text.h"

namespace pipeline {

namespace {

std::string subtitle(const StudyReport& report, const StudyAnalysis& analysis) {
    const std::string& reference = report.references[index(analysis.choice.kind)];
    std::string text = fmt::format("{}, {}, {}, {} error", report.scene, pictureSizeText(report),
                                   threadsText(report.threads), name(analysis.choice.kind));
    if (!reference.empty()) text += " against " + reference;
    if (analysis.refined) text += "; numbers at points: " + withinSentence(report.axes[*analysis.refined].label);
    return text;
}

PlotSeries seriesOf(const MethodCurve& curve, const StudyAnalysis& analysis) {
    PlotSeries series;
    series.name = curve.name;
    if (curve.order.within) series.note = "order " + orderText(curve.order);
    for (const std::size_t i : curve.points) {
        const PointAnalysis& point = analysis.points[i];
        const auto [low, high] = point.drawn.value_or(std::pair(*point.error, *point.error));
        series.points.push_back({i, *point.time, *point.error, point.interval.first, point.interval.second, low, high,
                                 analysis.refined ? point.step : std::string(), point.onFront()});
    }
    return series;
}

}  // namespace

Plot plotOf(const StudyReport& report, const StudyAnalysis& analysis) {
    Plot plot;
    plot.title = "Error against run time";
    plot.subtitle = subtitle(report, analysis);
    plot.xLabel = "run time of the frame (ms, median)";
    plot.yLabel = measureWithUnit(analysis);
    plot.referenceError = report.errorBar(analysis.choice).value_or(0);
    for (const MethodCurve& curve : analysis.curves) plot.series.push_back(seriesOf(curve, analysis));
    for (const PointAnalysis& point : analysis.points) {
        if (point.placed()) continue;
        auto omission = std::ranges::find(plot.omissions, point.missing, &PlotOmission::why);
        if (omission == plot.omissions.end()) omission = plot.omissions.insert(omission, {point.missing, {}});
        omission->labels.push_back(point.label.empty() ? "the only setting" : point.label);
    }
    return plot;
}

}  // namespace pipeline
