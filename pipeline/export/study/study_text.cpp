#include "pipeline/export/study/study_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/study/analysis_text.h"

namespace pipeline {

namespace {

std::size_t columnsOf(const std::string& text) {
    // Code points: of bytes 10xxxxxx none begins one.
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }));
}

// Columns as wide as their widest text; numbers end together.
class TextTable {
public:
    explicit TextTable(std::vector<bool> numbers) : m_numbers(std::move(numbers)) {}
    void row(std::vector<std::string> cells) { m_rows.push_back(std::move(cells)); }
    std::string text() const {
        std::vector<std::size_t> widths(m_numbers.size(), 0);
        for (const auto& row : m_rows)
            for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], columnsOf(row[i]));
        std::string text;
        for (const auto& row : m_rows) {
            std::string line;
            for (std::size_t i = 0; i < row.size(); ++i) {
                const std::string room(widths[i] - columnsOf(row[i]), ' ');
                line += "  " + (m_numbers[i] ? room + row[i] : row[i] + room);
            }
            text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
        }
        return text;
    }

private:
    std::vector<bool> m_numbers;
    std::vector<std::vector<std::string>> m_rows;
};

std::string pointTable(const StudyReport& report, const StudyAnalysis& analysis) {
    std::vector<bool> numbers;
    std::vector<std::string> head;
    for (std::size_t axis = 0; axis < report.axes.size(); ++axis) {
        numbers.push_back(axis == analysis.refined);
        head.push_back(report.axes[axis].label);
    }
    for (const char* name : {"ms", "95 % interval", "error"}) {
        numbers.push_back(true);
        head.emplace_back(name);
    }
    const bool withLeftOut = leavesOutPixels(analysis);
    if (withLeftOut) numbers.push_back(true), head.emplace_back(kLeftOut);
    numbers.push_back(false);
    head.emplace_back("beaten by");
    TextTable table(numbers);
    table.row(head);
    std::vector<std::size_t> order = analysis.byTime;
    for (std::size_t i = 0; i < analysis.points.size(); ++i)
        if (!analysis.points[i].placed()) order.push_back(i);
    for (const std::size_t i : order) {
        const PointAnalysis& point = analysis.points[i];
        std::vector<std::string> cells = report.points[i].values;
        cells.push_back(point.time ? timeText(*point.time) : "");
        cells.push_back(intervalText(point));
        cells.push_back(errorText(point));
        if (withLeftOut) cells.push_back(point.leftOut ? errorText(*point.leftOut) : "");
        cells.push_back(standing(analysis, i));
        table.row(std::move(cells));
    }
    return table.text();
}

std::string orderTable(const StudyReport& report, const StudyAnalysis& analysis) {
    TextTable table({false, true});
    table.row({"Observed order", "95 % interval"});
    bool any = false;
    for (const MethodCurve& curve : analysis.curves) {
        if (!curve.order.within) continue;
        any = true;
        table.row({curve.name.empty() ? "the only method" : curve.name, orderText(curve.order)});
    }
    if (!any) return {};
    return fmt::format("\n{}\n{}", orderMeaning(report.axes[*analysis.refined]), table.text());
}

}  // namespace

std::string orderMeaning(const SweepAxis& axis) {
    const std::string label = withinSentence(axis.label);
    return axis.key.ends_with("bits") ? fmt::format("Order p where the error falls with h^p, h = 2^\u2212{}.", label)
                                      : fmt::format("Order p where the error falls with h^p, h = 1 / {}.", label);
}

std::string intervalText(const PointAnalysis& point) {
    return point.time ? fmt::format("{} to {}", timeText(point.interval.first), timeText(point.interval.second)) : "";
}

std::string protocolText(const StudyReport& report) {
    const int frames = report.processes * report.repeats;
    const std::string each = frames == 1 ? "one frame" : fmt::format("median of {} frames", frames);
    std::string text =
        fmt::format("Times: {} ({} process{} of {}, each after {} that do not count), {}.", each, report.processes,
                    report.processes == 1 ? "" : "es", report.repeats, report.warmups, threadsText(report.threads));
    if (!report.machine.empty()) text += fmt::format(" {}.", report.machine);
    if (!report.compiler.empty()) text += fmt::format(" {}.", report.compiler);
    if (std::ranges::any_of(report.load, [](double load) { return load >= 0; }))
        text += fmt::format(" Load {:.1f} at most.", *std::ranges::max_element(report.load));
    if (frames < 6) text += " Of fewer than 6 frames the interval goes from the fastest to the slowest.";
    return text + fmt::format(" Differences below {:g} % count as none.", 100 * kSameTime);
}

std::string referenceText(const StudyReport& report, ErrorKind kind, const ErrorChoice& choice) {
    const std::size_t k = index(kind);
    if (report.references[k].empty()) {
        const std::string& why = report.whyNone[k];
        return fmt::format("{}: none{}{}", name(kind), why.empty() ? "" : ". ", why);
    }
    std::string text = fmt::format("{}: {}", name(kind), report.references[k]);
    if (const auto bar = report.errorBar(choice); bar && kind == choice.kind)
        text += fmt::format(", its own {} {}", measureText(choice), *bar > 0 ? errorText(*bar) : "0");
    if (kind == ErrorKind::Model && !report.errorWhy.empty()) text += fmt::format(" ({})", report.errorWhy);
    // Of some points, or instead of a better one.
    if (!report.whyNone[k].empty()) text += fmt::format("; {}", report.whyNone[k]);
    return text;
}

std::string studyText(const StudyReport& report, const StudyAnalysis& analysis, const StudyLimits& limits) {
    std::string text = fmt::format("{}, {}: {}, {} error\n\n", report.scene, pictureSizeText(report),
                                   measureWithUnit(analysis), name(analysis.choice.kind));
    text += pointTable(report, analysis) + orderTable(report, analysis);
    text += fmt::format("\n{}\n{}\n", cheapestSentence(analysis, limits.error),
                        bestSentence(analysis, limits.milliseconds));
    text += "\nReferences\n";
    for (std::size_t kind = 0; kind < kErrorKinds; ++kind)
        text += fmt::format("  {}\n", referenceText(report, static_cast<ErrorKind>(kind), analysis.choice));
    return text + protocolText(report) + "\n";
}

}  // namespace pipeline
