#include "pipeline/export/study/study_html.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/export/figure/plot_file.h"
#include "pipeline/export/html/html_text.h"
#include "pipeline/export/study/study_html_style.h"
#include "pipeline/export/study/study_text.h"
#include "pipeline/study/analysis_text.h"

namespace pipeline {

namespace {

std::string cell(std::string_view text) { return element("td", text); }
std::string number(std::string_view text) { return element("td class=n", text); }
std::string number(std::optional<double> value) { return number(value ? errorText(*value) : "\u2013"); }

std::string plotFigure(const StudyReport& report, const StudyAnalysis& analysis) {
    const PlotDrawing drawing = layOut(plotOf(report, analysis), {});
    return fmt::format(
        "<figure><picture><source media=\"(prefers-color-scheme: dark)\" srcset=\"{}\">"
        "<img src=\"{}\" width=\"{:.0f}\" height=\"{:.0f}\" alt=\"{}\"></picture></figure>\n",
        imageSource("svg+xml", plotSvg(drawing, PlotTheme::Dark)),
        imageSource("svg+xml", plotSvg(drawing, PlotTheme::Light)), drawing.width, drawing.height,
        escapedHtml(fmt::format("Plot of {} against the run time; its numbers stand in the table of points.",
                                measureText(analysis.choice))));
}

std::string htmlPointTable(const StudyReport& report, const StudyAnalysis& analysis) {
    const bool withLeftOut = leavesOutPixels(analysis);
    std::string html = "<h2>Points</h2>\n<table><thead><tr>";
    for (const SweepAxis& axis : report.axes) html += element("th", axis.label);
    html += "<th class=n>ms</th><th class=n>95 % interval</th>" + element("th class=n", measureWithUnit(analysis)) +
            (withLeftOut ? element("th class=n", kLeftOut) : "") + "<th>Beaten by</th></tr></thead>\n<tbody>\n";
    std::vector<std::size_t> order = analysis.byTime;
    for (std::size_t i = 0; i < analysis.points.size(); ++i)
        if (!analysis.points[i].placed()) order.push_back(i);
    for (const std::size_t i : order) {
        const PointAnalysis& point = analysis.points[i];
        html += point.placed() ? "<tr>" : "<tr class=failed>";
        for (const std::string& value : report.points[i].values) html += cell(value);
        html += number(point.time ? timeText(*point.time) : "\u2013") + number(intervalText(point)) +
                number(point.error ? errorText(point) : "\u2013") + (withLeftOut ? number(point.leftOut) : "") +
                element(point.onFront() ? "td class=front" : "td", standing(analysis, i)) + "</tr>\n";
    }
    return html + "</tbody></table>\n";
}

std::string htmlOrderTable(const StudyReport& report, const StudyAnalysis& analysis) {
    std::string rows;
    for (const MethodCurve& curve : analysis.curves) {
        if (!curve.order.within) continue;
        rows += "<tr>" + cell(curve.name.empty() ? "the only method" : curve.name) + number(orderText(curve.order)) +
                "</tr>\n";
    }
    if (rows.empty()) return {};
    return "<h2>Observed order</h2>\n" + element("p", orderMeaning(report.axes[*analysis.refined])) +
           "\n<table><thead><tr><th>Method</th><th class=n>all levels, least squares, "
           "95 % interval</th></tr></thead>\n<tbody>\n" +
           rows + "</tbody></table>\n";
}

std::string pictureFigures(const StudyPictures& pictures) {
    std::string html;
    const auto add = [&](const std::string& png, const std::string& caption) {
        if (png.empty()) return;
        html += fmt::format("<figure><img src=\"{}\" alt=\"{}\"><figcaption>{}</figcaption></figure>\n",
                            imageSource("png", png), escapedHtml(caption), escapedHtml(caption));
    };
    add(pictures.image, "Image");
    add(pictures.reference, "Reference");
    add(pictures.error,
        pictures.errorRange.empty() ? "Error, signed" : fmt::format("Error, signed, {}", pictures.errorRange));
    return html.empty() ? html : "<div class=pictures>\n" + html + "</div>\n";
}

std::string errorTable(const StudyPoint& point) {
    if (point.errors.empty()) return {};
    std::string html = "<table><thead><tr><th>Buffer</th><th>Stage</th><th>Measure</th>";
    for (std::size_t kind = 0; kind < kErrorKinds; ++kind)
        html += element("th class=n", name(static_cast<ErrorKind>(kind)));
    html += "</tr></thead>\n<tbody>\n";
    for (const ErrorRow& row : point.errors) {
        const std::string measure = row.unit.empty() ? row.measure : fmt::format("{}, {}", row.measure, row.unit);
        html += "<tr>" + element("td class=code", row.buffer) + cell(stageInfo(row.stage).label) + cell(measure);
        for (const std::optional<double>& value : row.value) html += number(value);
        html += "</tr>\n";
    }
    return html + "</tbody></table>\n";
}

std::string blameBars(const StudyPoint& point) {
    if (point.blame.empty()) return {};
    std::string html =
        "<h4>Which stage is to blame</h4>\n<p>Share of the frame\u2019s error that goes when one stage alone is "
        "replaced by "
        "its reference.</p>\n<table class=bars><tbody>\n";
    for (const StageBlame& blame : point.blame) {
        const double share = std::isfinite(blame.share) ? 100 * blame.share : 0;
        html += "<tr>" + cell(stageInfo(blame.stage).label) +
                fmt::format("<td class=bar><span style=\"width:{:.1f}%\"></span></td>", std::clamp(share, 0.0, 100.0)) +
                number(fmt::format("{}{:.0f} %", share <= -0.5 ? "\u2212" : "", std::abs(share))) + "</tr>\n";
    }
    return html + "</tbody></table>\n";
}

std::string stageTimes(const StudyPoint& point) {
    std::string rows;
    for (const StageId stage : kStages) {
        const TimeSamples& samples = point.stages[index(stage)];
        if (samples.empty()) continue;
        const SampleSummary times = samples.summary();
        rows += "<tr>" + cell(stageInfo(stage).label) + number(timeText(times.min)) + number(timeText(times.median)) +
                number(timeText(times.p95)) + "</tr>\n";
    }
    if (!rows.empty())
        rows =
            "<table><thead><tr><th>Stage</th><th class=n>least ms</th><th class=n>median</th><th class=n>95th "
            "percentile</th></tr></thead>\n<tbody>\n" +
            rows + "</tbody></table>\n";
    std::string counts;
    for (const auto& [what, count] : point.counters)
        counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", count, what);
    if (point.megabytes > 0)
        counts += fmt::format("{}{:.1f} MB in buffers", counts.empty() ? "" : ", ", point.megabytes);
    return counts.empty() ? rows : rows + element("p", counts + ".") + "\n";
}

// Every point with all that is known of it, folded but for the middle of the front.
std::string details(const StudyReport& report, const StudyAnalysis& analysis,
                    const std::vector<StudyPictures>& pictures) {
    std::string html = "<h2>Each point</h2>\n";
    const std::size_t open = analysis.front.empty() ? 0 : analysis.front[analysis.front.size() / 2];
    for (std::size_t i = 0; i < report.points.size(); ++i) {
        const PointAnalysis& point = analysis.points[i];
        const std::string label = point.label.empty() ? "The only setting" : point.label;
        html += fmt::format("<details{}><summary>{}</summary>\n", i == open ? " open" : "", escapedHtml(label));
        if (!report.points[i].failure.empty()) html += element("p class=failed", report.points[i].failure) + "\n";
        for (const StudyPictures& of : pictures)
            if (of.point == i) html += pictureFigures(of);
        html +=
            errorTable(report.points[i]) + blameBars(report.points[i]) + stageTimes(report.points[i]) + "</details>\n";
    }
    return html;
}

std::string settingsTable(const StudyReport& report) {
    if (report.settings.empty()) return {};
    std::string html = "<details><summary>Settings that the sweep does not change</summary>\n<table><tbody>\n";
    for (const auto& [key, value] : report.settings)
        html += "<tr>" + element("td class=code", key) + element("td class=n", value) + "</tr>\n";
    return html + "</tbody></table></details>\n";
}

}  // namespace

std::string studyHtml(const StudyReport& report, const StudyAnalysis& analysis, const StudyLimits& limits,
                      const std::vector<StudyPictures>& pictures) {
    std::string html =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n"
        "<meta name=\"color-scheme\" content=\"light dark\">\n";
    const std::string title = "Error against run time: " + report.scene;
    html += element("title", title) + "\n<style>" + std::string(kStudyStyle) + "</style>\n</head>\n<body>\n<main>\n" +
            element("h1", title) + "\n";
    html += element("p class=answer", cheapestSentence(analysis, limits.error)) + "\n" +
            element("p class=answer", bestSentence(analysis, limits.milliseconds)) + "\n";
    html += plotFigure(report, analysis) + htmlPointTable(report, analysis) + htmlOrderTable(report, analysis);
    html += details(report, analysis, pictures);
    html += "<h2>References</h2>\n<ul>\n";
    for (std::size_t kind = 0; kind < kErrorKinds; ++kind)
        html += element("li", referenceText(report, static_cast<ErrorKind>(kind), analysis.choice)) + "\n";
    html += "</ul>\n<h2>How it was measured</h2>\n" + element("p", protocolText(report)) + "\n" +
            element("p", fmt::format("{}{}, {}. Shadescope {}.", report.scene,
                                     report.file.empty() ? ", built in" : ", " + report.file, pictureSizeText(report),
                                     report.version)) +
            "\n";
    return html + settingsTable(report) + "</main>\n</body>\n</html>\n";
}

}  // namespace pipeline
