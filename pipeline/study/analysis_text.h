#pragma once
#include <string>

#include "pipeline/study/analysis.h"

namespace pipeline {

// The numbers and sentences of a study, the same in tables, plots, reports and the window.

// Whole numbers below a million as they are, else two digits: "84", "0", "4.2e-2", "1.3", "1.0e7".
std::string errorText(double error);
// With the interval of several draws: "1.3 (0.9 to 1.8)"; empty for a point without an error.
std::string errorText(const PointAnalysis& point);
// Three digits without a unit: "0.590", "10.6", "1340".
std::string timeText(double milliseconds);
// "1.98"; "−0.50" with the sign U+2212.
std::string orderText(double order);
// "1.98 ± 0.10"; empty without an interval, for then it is not printed.
std::string orderText(const ObservedOrder& order);

// "1 thread", "4 threads"; 0 stands for as many as the machine has: "all threads".
std::string threadsText(int threads);
// Of the picture: "640 × 480"; where the study changes it "several sizes".
std::string pictureSizeText(const StudyReport& report);
// A setting's label within a sentence: "shadow buffer" of "Shadow buffer"; "L x" and "θ around z" stay.
std::string withinSentence(std::string label);
// "RMSE of intensity", "largest angle of normal".
std::string measureText(const ErrorChoice& choice);
// The column that says how many pixels an error leaves out.
inline constexpr const char* kLeftOut = "pixels that differ";
// "RMSE of intensity (degrees)", and without a unit as measureText.
std::string measureWithUnit(const StudyAnalysis& analysis);

// The cheapest setting with an error of at most `error`: "RMSE of intensity up to 5e-4 takes at least
// 2.94 ms: phong, tessellation 16." Or that there is none, and the best there is.
std::string cheapestSentence(const StudyAnalysis& analysis, double error);
// The best setting within a time: "Within 5 ms RMSE of intensity is at best 3.5e-5: phong,
// tessellation 64." Or that there is none, and the fastest there is.
std::string bestSentence(const StudyAnalysis& analysis, double milliseconds);

// "on the front", the label of the point that dominates it, or why it is not in the plot.
std::string standing(const StudyAnalysis& analysis, std::size_t point);

}  // namespace pipeline
