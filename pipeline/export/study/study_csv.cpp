#include "pipeline/export/study/study_csv.h"

#include <cmath>
#include <set>

#include "pipeline/core/csv.h"
#include "pipeline/core/text.h"

namespace pipeline {

namespace {

std::string field(const std::string& text) { return csvField(text); }
std::string field(std::optional<double> value) { return value && std::isfinite(*value) ? shortestText(*value) : ""; }

// Fields with a comma before each.
class Line {
public:
    template <class T>
    void add(const T& value) {
        m_text += ',' + field(value);
    }
    const std::string& text() const { return m_text; }

private:
    std::string m_text;
};

void addTimes(Line& line, const TimeSamples& samples) {
    std::optional<SampleSummary> summary;
    if (!samples.empty()) summary = samples.summary();
    const auto of = [&](auto value) { return summary ? std::optional<double>(value(*summary)) : std::nullopt; };
    line.add(of([](const SampleSummary& s) { return s.min; }));
    line.add(of([](const SampleSummary& s) { return s.median; }));
    line.add(of([](const SampleSummary& s) { return s.p95; }));
    const bool bounded = summary && summary->medianInterval;
    line.add(bounded ? std::optional(summary->medianInterval->first) : std::nullopt);
    line.add(bounded ? std::optional(summary->medianInterval->second) : std::nullopt);
}

}  // namespace

std::string studyCsv(const StudyReport& report) {
    std::set<std::string> counters;
    for (const StudyPoint& point : report.points)
        for (const auto& [what, count] : point.counters) counters.insert(what);

    std::string csv = "point";
    Line names;
    for (const SweepAxis& axis : report.axes) names.add(axis.key);
    for (const char* name : {"failure", "buffer", "stage", "measure", "unit"}) names.add(std::string(name));
    for (std::size_t kind = 0; kind < kErrorKinds; ++kind) names.add(std::string(name(static_cast<ErrorKind>(kind))));
    for (const char* name : {"model_low", "model_high", "reference_error"}) names.add(std::string(name));
    for (const char* name : {"ms_min", "ms_median", "ms_p95", "ms_median_low", "ms_median_high"})
        names.add(std::string(name));
    for (const StageId stage : kStages) names.add("ms_" + std::string(stageInfo(stage).name));
    names.add(std::string("megabytes"));
    for (const std::string& what : counters) names.add(what);
    csv += names.text() + "\r\n";

    for (const StudyPoint& point : report.points) {
        Line before, after;
        for (const std::string& value : point.values) before.add(value);
        before.add(point.failure);
        addTimes(after, point.frame);
        for (const TimeSamples& stage : point.stages)
            after.add(stage.empty() ? std::nullopt : std::optional(stage.summary().median));
        after.add(std::optional(point.megabytes));
        for (const std::string& what : counters) {
            const auto count = point.counters.find(what);
            after.add(count == point.counters.end() ? std::string() : std::to_string(count->second));
        }
        const std::string number = std::to_string(point.number);
        for (const ErrorRow& row : point.errors) {
            Line errors;
            errors.add(row.buffer);
            errors.add(std::string(stageInfo(row.stage).name));
            errors.add(row.measure);
            errors.add(row.unit);
            for (const std::optional<double>& value : row.value) errors.add(value);
            errors.add(row.drawn ? std::optional(row.drawn->first) : std::nullopt);
            errors.add(row.drawn ? std::optional(row.drawn->second) : std::nullopt);
            errors.add(report.errorBar({row.buffer, row.measure, ErrorKind::Model}));
            csv += number + before.text() + errors.text() + after.text() + "\r\n";
        }
        if (point.errors.empty()) csv += number + before.text() + ",,,,,,,,,," + after.text() + "\r\n";
    }
    return csv;
}

}  // namespace pipeline
