#include "pipeline/study/study.h"

#include <algorithm>

namespace pipeline {

std::string_view name(ErrorKind kind) {
    constexpr std::array<std::string_view, kErrorKinds> kNames{"model", "arithmetic", "storage"};
    return kNames[index(kind)];
}

bool TimeSamples::empty() const {
    return std::ranges::all_of(processes, [](const std::vector<double>& samples) { return samples.empty(); });
}

SampleSummary TimeSamples::summary() const {
    std::vector<double> all, medians;
    for (const std::vector<double>& samples : processes) {
        all.insert(all.end(), samples.begin(), samples.end());
        if (!samples.empty()) medians.push_back(summarize(samples).median);
    }
    SampleSummary summary = summarize(std::move(all));
    if (summary.medianInterval && medians.size() > 1) {
        const auto [least, most] = std::ranges::minmax(medians);
        const auto between = summarize(medians).medianInterval.value_or(std::pair(least, most));
        auto& [low, high] = *summary.medianInterval;
        low = std::min(low, between.first), high = std::max(high, between.second);
    }
    return summary;
}

namespace {

const ErrorRow* rowOf(const std::vector<ErrorRow>& rows, const ErrorChoice& choice) {
    for (const ErrorRow& row : rows)
        if (row.buffer == choice.buffer && row.measure == choice.measure) return &row;
    return nullptr;
}
std::optional<double> errorIn(const std::vector<ErrorRow>& rows, const ErrorChoice& choice) {
    const ErrorRow* const row = rowOf(rows, choice);
    return row ? row->value[index(choice.kind)] : std::nullopt;
}

}  // namespace

std::optional<double> StudyPoint::error(const ErrorChoice& choice) const { return errorIn(errors, choice); }

std::optional<std::pair<double, double>> StudyPoint::drawn(const ErrorChoice& choice) const {
    const ErrorRow* const row = rowOf(errors, choice);
    return row && choice.kind == ErrorKind::Model ? row->drawn : std::nullopt;
}

std::optional<double> StudyReport::errorBar(const ErrorChoice& of) const { return errorIn(errorBars, of); }

}  // namespace pipeline
