#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/core/sample.h"
#include "pipeline/core/stage.h"
#include "pipeline/run/frame.h"

namespace pipeline {

// What a study of error against run time found: made by study runs (pipeline/study/), read by the
// tables, plots and reports (pipeline/export/) and by the window.

// A setting, or the same setting of every light or object, and the values that it takes in turn.
struct SweepAxis {
    std::string key;                  // as --sweep names it: "shading", "tessellation"
    std::string label;                // for people: "Shading"
    std::vector<std::string> values;  // as formatSetting writes them: "flat", "16"
    bool operator==(const SweepAxis&) const = default;
};

// Where an error comes from.
//   Model       the picture against the true surfaces: tessellation, shading, sampling
//   Arithmetic  the same stages, computed exactly
//   Storage     what a buffer holds against what was to be stored in it
enum class ErrorKind : std::uint8_t { Model, Arithmetic, Storage };
inline constexpr std::size_t kErrorKinds = 3;
constexpr std::size_t index(ErrorKind kind) { return static_cast<std::size_t>(kind); }
std::string_view name(ErrorKind kind);  // "model"
// The median is beyond the outermost of n draws in 2 of 2^n cases.
inline constexpr unsigned kDraws = 6;

// One measure of one buffer.
struct ErrorRow {
    std::string buffer;   // "z_view", "shadow.0"
    StageId stage;        // that leaves the buffer
    std::string measure;  // "RMSE", "largest angle"
    std::string unit;     // "world units", "degrees", "pixels"; empty for a pure number
    // Nothing where the buffer has no such error, or the reference does not say.
    std::array<std::optional<double>, kErrorKinds> value{};
    // Of the model's error, where the samples of a pixel are drawn at random: its value is the median over kDraws draws, and
    // this the interval of the median, 97 %: from the least to the largest.
    std::optional<std::pair<double, double>> drawn{};
    bool operator==(const ErrorRow&) const = default;
};

// A measure of a buffer by name, one kind of error of it: what a plot shows.
struct ErrorChoice {
    std::string buffer = "intensity", measure = "RMSE";
    ErrorKind kind = ErrorKind::Model;
    bool operator==(const ErrorChoice&) const = default;
};

// Run times in milliseconds. One group of samples a process.
struct TimeSamples {
    std::vector<std::vector<double>> processes;
    bool empty() const;
    // Of all samples together; not empty. Frames of a process are alike: where there are several processes, the interval of the
    // median holds that of each process as well, but for the outermost ones of six and more (SampleSummary).
    SampleSummary summary() const;
    bool operator==(const TimeSamples&) const = default;
};

// How much of the frame's error goes when one stage alone is replaced by its reference.
struct StageBlame {
    StageId stage;
    double error = 0;  // RMSE of the intensity that is left
    double share = 0;  // 1 − error / the frame's own; below 0 where two errors cancelled each other
    bool operator==(const StageBlame&) const = default;
};

// One combination of values.
struct StudyPoint {
    std::size_t number = 0;           // in the sweep's order, the last axis fastest
    std::vector<std::string> values;  // one an axis
    std::string failure;              // why there is nothing more; empty
    std::vector<ErrorRow> errors;
    std::vector<StageBlame> blame;  // empty where there is no reference for it
    TimeSamples frame;
    std::array<TimeSamples, kStageCount> stages;  // empty where the plan leaves a stage out
    std::map<std::string, long long> counters;    // "fragments", "shadow look-ups": no noise
    double megabytes = 0;                         // of all buffers that the frame holds

    // Nothing where the point has no such row.
    std::optional<double> error(const ErrorChoice& choice) const;
    std::optional<std::pair<double, double>> drawn(const ErrorChoice& choice) const;  // ErrorRow::drawn
    bool operator==(const StudyPoint&) const = default;
};

struct StudyReport {
    std::string scene;     // its name
    std::string file;      // as given; empty for a built-in scene
    std::string geometry;  // a mark of its meshes and all else that no setting tells, the same for the same ones
    std::string version;   // of the program
    int width = 0, height = 0, threads = 1, warmups = 0, repeats = 0, processes = 0;
    std::string machine, compiler;                // "AMD EPYC 7763, 2 processors"; "GCC 12.2.0, optimized"
    std::vector<double> load;                     // average number of running programs before each process
    std::map<std::string, std::string> settings;  // of the scene, those that no axis changes
    std::vector<SweepAxis> axes;
    ErrorChoice choice;
    std::array<std::string, kErrorKinds> references;  // name of the reference of each kind; empty: none, and why below
    std::array<std::string, kErrorKinds> whyNone;     // also why some points have none, or not the best there is
    std::vector<ErrorRow> errorBars;  // errors that the references may themselves have, like the points'
    std::string errorWhy;             // how those of the model reference were found
    std::vector<StudyPoint> points;   // in order of their numbers
    // Of the reference of an error, measured as the error is; nothing where it is not known.
    std::optional<double> errorBar(const ErrorChoice& of) const;
    bool operator==(const StudyReport&) const = default;
};

}  // namespace pipeline
