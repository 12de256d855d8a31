#pragma once
#include <array>
#include <optional>
#include <stop_token>
#include <vector>

#include "pipeline/core/stage.h"
#include "pipeline/export/json/json_value.h"

namespace app {

// How the time of a frame, and of each of its stages, grows with the scene: a sphere of more and more polygons in one
// picture, and one sphere in larger and larger pictures. Phong shaded, computed from nothing; the fastest of the
// repetitions counts, for nothing makes a frame faster than it is.
struct ScalingOptions {
    int repeats = 5, threads = 0;
    std::stop_token stop{};
};

struct ScalingSeries {
    const char* over = "";                                          // "polygons", "pixels"
    std::vector<double> sizes;                                      // as many as were measured
    std::vector<double> frame;                                      // ms
    std::array<std::vector<double>, pipeline::kStageCount> stages;  // ms; empty where left out
};

// Nothing when stopped.
std::optional<std::array<ScalingSeries, 2>> measureScaling(const ScalingOptions& options);

// p of t = c n^p, by least squares in logarithms over the larger half of the sizes, where what a frame costs at least
// counts for less. At least two sizes, all above 0.
double growthExponent(const std::vector<double>& sizes, const std::vector<double>& times);

void printScaling(const std::array<ScalingSeries, 2>& series);
pipeline::Json scalingJson(const std::array<ScalingSeries, 2>& series);

}  // namespace app
