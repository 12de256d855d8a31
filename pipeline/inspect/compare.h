#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/core/stop.h"
#include "pipeline/run/frame.h"

namespace pipeline {

// How two numbers differ: a is what is looked at, b what it is compared with. The names are those
// of image viewers. The relative ones divide by the larger of the two magnitudes, so that nothing
// small has to be added to a divisor: they are at most 2, and 4.
enum class DifferenceMetric : std::uint8_t { Error, Absolute, Squared, RelativeAbsolute, RelativeSquared };

struct MetricInfo {
    DifferenceMetric id;
    std::string_view name;     // "RAE"
    std::string_view words;    // "relative absolute error"
    std::string_view formula;  // "|A − B| / max(|A|, |B|)"
};
inline constexpr std::size_t kMetricCount = 5;
std::span<const MetricInfo, kMetricCount> metricTable();  // in the order of the enumerators

// Of two finite numbers. Finite, but where their difference or its square is beyond double's range.
double difference(DifferenceMetric metric, double a, double b);

// Why two buffers have no difference, one sentence; empty where they have one. They need the same
// shape and stand on the same kind of thing.
std::string whyNotComparable(const AnyBuffer& a, const AnyBuffer& b);

// How a buffer differs from another one, element by element: pixels, texels, vertices or polygons.
struct BufferDifference {
    // One number an element, float64: of several channels the one with the largest magnitude. For
    // names (polygon_id, verdicts) 1 where they are not the same. NaN where one of the two has no
    // finite number, or drew nothing; 0 where both drew nothing.
    AnyBuffer values;
    std::vector<bool> drawn;   // by at least one of the two; empty: all
    std::size_t compared = 0;  // elements with numbers on both sides
    std::size_t differing = 0;
    std::size_t oneSided = 0;  // of the differing ones, those where a number is on one side alone
    double largest = 0;        // magnitude, over the compared elements
    double mean = 0;           // of the magnitudes, over the compared elements
    // Index of the element with the largest difference; the first of equals. Where no number
    // differs the first one-sided element. Nothing where all are the same.
    std::optional<std::size_t> worst;
};

// What watches a comparison. share: of what is compared, 0 to 1. Stopped, it gives what it has so far.
struct CompareControl {
    Stop stop{};
    std::function<void(double share)> progress{};
};

// channel -1: all of them. drawnA and drawnB say which elements hold something; empty: all do.
// Two equal infinities, and NaN on both sides, are the same. whyNotComparable(a, b) must be empty.
BufferDifference compareBuffers(const AnyBuffer& a, const AnyBuffer& b, int channel, DifferenceMetric metric,
                                const std::vector<bool>& drawnA, const std::vector<bool>& drawnB,
                                const CompareControl& control = {});

// Made by compareBuffers.
bool isDifference(const BufferInfo& info);

// One buffer of two frames, by the metric AE over all its channels.
struct StageDifference {
    BufferName buffer;
    std::size_t elements = 0, differing = 0, oneSided = 0;
    double largest = 0;
    std::optional<std::size_t> worst{};
    std::string why{};  // why they cannot be compared; then the rest is 0
};
StageDifference stageDifference(const Frame& a, const Frame& b, const BufferName& name);  // both must hold it
// Against a buffer that belongs to no frame, read from a file; the frame must hold the one of its name.
StageDifference stageDifference(const Frame& a, const AnyBuffer& b);

}  // namespace pipeline
