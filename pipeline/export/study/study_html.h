#pragma once
#include <string>
#include <vector>

#include "pipeline/study/analysis.h"

namespace pipeline {

// Pictures of one point, each the bytes of a PNG file; empty for none.
struct StudyPictures {
    std::size_t point = 0;  // into StudyReport::points
    std::string image, reference, error;
    std::string errorRange;  // what the ends of the error's palette stand for: "−0.05 to 0.05"
};

// A study as one page that needs nothing else: title, the two answers at these limits, the plot in
// light and dark, the points sorted by time, observed orders, pictures, for each point every error
// with its reference and the stages to blame, protocol and settings. HTML 5 without scripts.
std::string studyHtml(const StudyReport& report, const StudyAnalysis& analysis, const StudyLimits& limits,
                      const std::vector<StudyPictures>& pictures = {});

}  // namespace pipeline
