#include <fmt/format.h>

#include <algorithm>

#include "app/web/core/core.h"
#include "app/web/core/progress.h"
#include "app/web/core/rays.h"
#include "pipeline/core/text.h"
#include "pipeline/export/json/study_json.h"
#include "pipeline/export/study/study_text.h"
#include "pipeline/study/analysis_text.h"
#include "pipeline/study/machine.h"
#include "pipeline/study/plot.h"
#include "pipeline/study/run_study.h"

// Error against run time of the open scene: point by point, then the times, all in this one process.

namespace pipeline {

// Of the machine the page says what it knows.
std::string machineName() { return {}; }
std::string compilerName() { return "Clang " __clang_version__ ", for WebAssembly"; }
double loadAverage() { return -1; }

}  // namespace pipeline

namespace web {

namespace {

struct OpenStudy {
    pipeline::StudyRequest request;
    pipeline::StudyReport report;
    std::unique_ptr<pipeline::ErrorFinder> finder;
};
OpenStudy s_study;

// Where no point has the error that the sweep is about: that of another kind, else the first there is.
void chooseError(pipeline::StudyReport& report) {
    const auto there = choicesOf(report);
    if (there.empty() || std::ranges::find(there, report.choice) != there.end()) return;
    const auto same = std::ranges::find_if(there, [&](const pipeline::ErrorChoice& one) {
        return one.buffer == report.choice.buffer && one.measure == report.choice.measure;
    });
    report.choice = same == there.end() ? there.front() : *same;
}

Json pointsJson(std::span<const glm::dvec2> points, glm::dvec2 from = {}, double scale = 1) {
    Json list = Json::array();
    for (const glm::dvec2& point : points) list.push_back({from.x + scale * point.x, from.y + scale * point.y});
    return list;
}

std::string_view roleName(pipeline::PlotRole role) {
    switch (role) {
        case pipeline::PlotRole::Text: return "text";
        case pipeline::PlotRole::Secondary: return "secondary";
        case pipeline::PlotRole::Grid: return "grid";
        case pipeline::PlotRole::Front: return "front";
        case pipeline::PlotRole::Equal: return "equal";
        case pipeline::PlotRole::Failed: return "failed";
        case pipeline::PlotRole::Series: return "series";
    }
    return {};
}
std::string inkName(pipeline::PlotInk ink) {
    const std::string number = std::to_string(ink.series % pipeline::kPlotColors);
    return std::string(roleName(ink.role)) + (ink.role == pipeline::PlotRole::Series ? number : "");
}

// The plot as what is drawn, in this order.
Json plotJson(const pipeline::PlotDrawing& drawing) {
    Json lines = Json::array(), markers = Json::array(), texts = Json::array();
    for (const pipeline::PlotLine& line : drawing.lines)
        lines.push_back({{"points", pointsJson(line.points)},
                         {"ink", inkName(line.ink)},
                         {"width", line.width},
                         {"dashes", dashes(line.dash)}});
    for (const pipeline::PlotMarker& marker : drawing.markers)
        markers.push_back({{"outline", pointsJson(outline(marker.shape), marker.at, marker.size)},  // none of a disc
                           {"at", {marker.at.x, marker.at.y}},
                           {"size", marker.size},
                           {"filled", marker.filled},
                           {"ink", inkName(marker.ink)}});
    for (const pipeline::PlotText& text : drawing.texts)
        texts.push_back({{"at", {text.at.x, text.at.y}},
                         {"anchor", text.anchor == pipeline::PlotText::Anchor::Start    ? "start"
                                    : text.anchor == pipeline::PlotText::Anchor::Middle ? "middle"
                                                                                        : "end"},
                         {"text", text.text},
                         {"size", text.size},
                         {"bold", text.bold},
                         {"upwards", text.upwards},
                         {"ink", inkName(text.ink)}});
    return {
        {"width", drawing.width}, {"height", drawing.height}, {"lines", lines}, {"markers", markers}, {"texts", texts}};
}

}  // namespace

bool castsRays() { return true; }

// The sweeps that have a name, and what the open scene lacks for one.
WEB_CALL(sweeps) int webSweeps() {
    Json list = Json::array();
    for (const pipeline::NamedSweep& one : pipeline::namedSweeps())
        list.push_back({{"name", one.name},
                        {"meaning", one.meaning},
                        {"needs", one.sweeps(*core().own.scene).empty() ? one.needs : std::string_view()}});
    return give(list);
}

// Begins a study: sweeps by lines, each as --sweep takes it. The values of its points.
WEB_CALL(study)
int webStudy(const char* text, int size, const char* machine, int machineSize, int warmups, int repeats) {
    if (!core().own.scene) return refuse("no scene is open");
    std::vector<std::string> texts;
    for (std::string_view rest = textAt(text, size); !rest.empty();) {
        texts.emplace_back(rest.substr(0, rest.find('\n')));
        rest.remove_prefix(std::min(rest.size(), texts.back().size() + 1));
    }
    auto sweep = parseSweeps(*core().own.scene, texts);
    if (!sweep) return refuse(sweep.errors());
    s_study.request = {core().own.scene, std::move(sweep).value(), {}, 1, warmups, repeats};
    s_study.report = beginStudy(s_study.request);
    s_study.report.machine = textAt(machine, machineSize), s_study.report.processes = 1;
    s_study.finder = std::make_unique<pipeline::ErrorFinder>(s_study.request);
    Json points = Json::array();
    for (const pipeline::StudyPoint& point : s_study.report.points)
        points.push_back(fmt::format("{}", fmt::join(point.values, ", ")));
    return give(points);
}

// Errors, counters and blame of a point.
WEB_CALL(study_point) int webStudyPoint(int number) {
    if (number < 0 || std::size_t(number) >= s_study.report.points.size()) return refuse("no such point");
    s_study.finder->find(s_study.report.points[std::size_t(number)], s_study.report, {});
    return give(true);
}

WEB_CALL(study_times) int webStudyTimes() {
    chooseError(s_study.report);
    const auto progress = [](int done, int all) { tellProgress("times", 5, done, all); };
    measureTimes(s_study.request, s_study.report.points, progress, {});
    return give(true);
}

// What was found: the file that `study -o` writes, what it prints, and for a page the plot, the table and the two answers.
WEB_CALL(study_report) int webStudyReport(double width, double height, double text) {
    const pipeline::StudyReport& report = s_study.report;
    const pipeline::StudyAnalysis analysis = analyse(report, report.choice);
    const pipeline::StudyLimits limits = middleOfFront(analysis).value_or(pipeline::StudyLimits());
    Json rows = Json::array();
    for (std::size_t i = 0; i < analysis.points.size(); ++i) {
        const pipeline::PointAnalysis& point = analysis.points[i];
        rows.push_back({{"label", point.label},
                        {"time", point.time ? pipeline::timeText(*point.time) : ""},
                        {"interval", intervalText(point)},
                        {"error", point.error ? pipeline::errorText(*point.error) : ""},
                        {"standing", standing(analysis, i)},
                        {"front", point.onFront()}});
    }
    return give({{"json", studyFileText(report)},
                 {"text", studyText(report, analysis, limits)},
                 {"measure", measureWithUnit(analysis)},
                 {"rows", rows},
                 {"answers", {cheapestSentence(analysis, limits.error), bestSentence(analysis, limits.milliseconds)}},
                 {"protocol", protocolText(report)},
                 {"reference", referenceText(report, report.choice.kind, report.choice)},
                 {"plot", plotJson(layOut(plotOf(report, analysis), {width, height, text}))}});
}

}  // namespace web
