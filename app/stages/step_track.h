#pragma once
#include <vector>

#include "pipeline/steps/steps.h"

namespace app {

// The timeline's track as numbers: six equal parts from left to right, one for each stage, with gaps between. In a part
// the stage's smallest steps are evenly spaced.
struct StepTrack {
    const pipeline::Steps& steps;
    double width;  // of the whole track, pixels
    double gap;    // between two parts

    double partWidth() const;
    double partLeft(pipeline::StageId stage) const;
    double xOf(pipeline::Moment moment) const;
    // The moment of a position on the track; in a left-out stage the end of the previous stage.
    pipeline::Moment momentAt(double x) const;
    // The ends of the steps of a level, at least four pixels apart; empty if there is no room for all of them.
    std::vector<double> ticks(pipeline::StageId stage, pipeline::StepLevel level) const;
};

// The end of a step of this level that is nearest to a moment of its stage, or the stage's beginning.
pipeline::Moment snapped(const pipeline::Steps& steps, pipeline::Moment moment, pipeline::StepLevel level);

}  // namespace app
