#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/study/study.h"

namespace pipeline {

// What a study says about one error: which settings belong together, which are worth their time,
// how fast the error falls, and the answer in words. Pure functions of a report.

// Times count as the same within a group: the fastest of all and what is slower by at most this share begin the first,
// the fastest of the rest the next. A group is no wider, and of three points the order of two is never that of others.
inline constexpr double kSameTime = 0.02;

// A point of the study in milliseconds and in the chosen error.
struct PointAnalysis {
    std::size_t curve = 0;                 // into StudyAnalysis::curves
    std::string label;                     // "phong, tessellation 16": all of its values that the sweep changes
    std::string step;                      // "16": its place on the curve; empty where no axis is refined
    std::optional<double> time;            // median of the frame
    std::size_t timeGroup = 0;             // 0 for the fastest; the same for times that count as the same
    std::pair<double, double> interval{};  // of the median; of all samples where they are too few for one
    std::optional<double> error;           // finite and at least 0
    std::optional<std::pair<double, double>> drawn;  // ErrorRow::drawn
    std::optional<double> leftOut;           // pixels that do not show what the reference shows, not in the error
    std::string missing;                     // why it has no place in the plot; empty where it has one
    std::optional<std::size_t> dominatedBy;  // into StudyReport::points
    bool placed() const { return missing.empty(); }
    bool onFront() const { return placed() && !dominatedBy; }
};

// How fast an error falls: p where the error is proportional to h^p.
struct ObservedOrder {
    std::vector<std::optional<double>> steps;  // one for each two neighbours; nothing where one has no error but 0
    std::optional<double> fit;                 // least squares through the logarithms of all errors above 0
    std::optional<double>
        within;  // half of fit's 95 % interval, Student's, from three such errors on; else not printed
};

// The points of one method, from coarse to fine.
struct MethodCurve {
    std::string name;                 // "phong", "flat, area"; empty where the sweep has one method only
    std::vector<std::size_t> points;  // into StudyReport::points, placed ones only, by the refined axis
    ObservedOrder order;
};

struct StudyAnalysis {
    ErrorChoice choice;
    std::string unit;                    // of the error; empty for a pure number
    std::optional<std::size_t> refined;  // the axis that is refined along a curve
    std::vector<MethodCurve> curves;     // in the order of the sweep
    std::vector<PointAnalysis> points;   // as StudyReport::points
    std::vector<std::size_t> byTime;     // placed points, the fastest first; of equals the better one
    std::vector<std::size_t> front;      // those of them that no other dominates
};

// Whether the points' errors leave out pixels, whose number then stands beside them.
bool leavesOutPixels(const StudyAnalysis& analysis);

// False for a measure of which more is better, "PSNR" and "mean SSIM": it is no error, and has no place in a plot of one.
bool isError(std::string_view measure);

// The errors that at least one point has: what a plot can show, in the order of the points' rows.
std::vector<ErrorChoice> choicesOf(const StudyReport& report);

// The axis of numbers that is refined along a curve: the last one with at least two values, all of
// them numbers. Every other axis makes methods.
std::optional<std::size_t> refinedAxis(const std::vector<SweepAxis>& axes);

// The width h that a value of an axis stands for, up to a factor: 1 / value where the setting is a resolution (pieces,
// texels, samples along a side, pixels); 2^-value where the key ends in "bits". Nothing of any other setting.
std::optional<double> stepWidth(const SweepAxis& axis, const std::string& value);

// A point is dominated when another one is at most as slow, by groups of kSameTime, and at most as wrong, better in one of
// both, and that is no accident. At most as wrong: in its error, and in the pixels that the error leaves out. No accident:
// of points that are equally wrong the median intervals do not overlap. An error of exactly 0 is better than every other.
// Dominance is transitive; named is the dominating point on the front with the smallest error.
StudyAnalysis analyse(const StudyReport& report, const ErrorChoice& choice);

// Observed order p = ln(e / e') / ln(h / h') of errors over widths, coarse to fine.
ObservedOrder observedOrder(const std::vector<std::optional<double>>& widths, const std::vector<double>& errors);

// The two answers; nothing where no point is good enough.
std::optional<std::size_t> cheapestWithin(const StudyAnalysis& analysis, double error);
std::optional<std::size_t> bestWithin(const StudyAnalysis& analysis, double milliseconds);

// Limits at which both answers say something: round numbers (1, 2 or 5 times a power of ten) not
// below the error and the time of the middle of the front. Nothing without a front.
struct StudyLimits {
    double error = 0, milliseconds = 0;
};
std::optional<StudyLimits> middleOfFront(const StudyAnalysis& analysis);

}  // namespace pipeline
