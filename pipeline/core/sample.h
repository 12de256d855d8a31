#pragma once
#include <optional>
#include <utility>
#include <vector>

namespace pipeline {

// What repeated measurements say. The interval holds the true median with a probability of at
// least 95 %; nothing is assumed about how the values are distributed. It needs 6 values.
struct SampleSummary {
    double min = 0, median = 0;
    double p95 = 0;  // nearest rank: the smallest value that 95 % do not exceed
    std::optional<std::pair<double, double>> medianInterval;
};

// values: at least one.
SampleSummary summarize(std::vector<double> values);

}  // namespace pipeline
