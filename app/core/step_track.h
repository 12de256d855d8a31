#pragma once
#include <vector>

#include "pipeline/steps/steps.h"

namespace app {

// The scrubber's track as numbers: six equal parts from left to right, one a stage, with gaps between. Within a part
// the stage's smallest steps are evenly spread.
struct StepTrack {
    const pipeline::Steps& steps;
    double width;  // of all, pixels
    double gap;    // between two parts

    double partWidth() const;
    double partLeft(pipeline::StageId stage) const;
    double xOf(pipeline::Moment moment) const;
    // The moment of a place on the track; of a left-out stage the end of the one before.
    pipeline::Moment momentAt(double x) const;
    // Where the steps of a level end, at least four pixels apart; nothing where there is no room for all of them.
    std::vector<double> ticks(pipeline::StageId stage, pipeline::StepLevel level) const;
};

// The end of a step of this level that is nearest to a moment within its stage, or the stage's beginning.
pipeline::Moment snapped(const pipeline::Steps& steps, pipeline::Moment moment, pipeline::StepLevel level);

}  // namespace app
