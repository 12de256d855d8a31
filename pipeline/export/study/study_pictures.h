#pragma once
#include <optional>
#include <vector>

#include "pipeline/core/stop.h"
#include "pipeline/export/study/study_html.h"
#include "pipeline/study/run_study.h"

namespace pipeline {

// A point's image, what it should be, and the signed error of its intensity, in sRGB. `reference` and `error` are empty
// where there is no reference of the model.
struct ComparedPictures {
    Buffer2D<Color8> image, reference, error;
    double largest = 0;  // what the ends of the error's palette stand for, in shares of I_max
};
ComparedPictures comparedPictures(const PointPictures& shown);

// For a report: those of the points on the front, of at most `most` of them, the first and the last included.
std::vector<StudyPictures> frontPictures(const StudyRequest& request, const StudyReport& report, std::size_t most,
                                         Stop stop);

}  // namespace pipeline
