#pragma once
#include <string>

#include "pipeline/study/analysis.h"

namespace pipeline {

// A study for a terminal: a table of its points, the fastest first, those without a place last;
// observed orders; the two answers at these limits. At most as wide as the values make it.
std::string studyText(const StudyReport& report, const StudyAnalysis& analysis, const StudyLimits& limits);

// How and on what the times were measured, in sentences: "Times: median of 63 frames (3 processes of
// 21, each after 2 that do not count), 1 thread. AMD EPYC 7763; GCC 12.2.0, optimized." Reports share it.
std::string protocolText(const StudyReport& report);
// "model: analytic, intensities within 2e-16 of I_max (against the same rays in long double)"; of a kind without a
// reference why: "storage: none. Nothing is stored with fewer digits."
std::string referenceText(const StudyReport& report, ErrorKind kind, const ErrorChoice& choice);
// What an observed order means on this axis: "Order p where the error falls with h^p, h = 1 /
// tessellation." As in stepWidth.
std::string orderMeaning(const SweepAxis& axis);
// "0.587 to 0.593"; empty without a time.
std::string intervalText(const PointAnalysis& point);

}  // namespace pipeline
