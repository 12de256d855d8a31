#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pipeline/run/frame_data.h"

// What a stage did, as counts that do not depend on a clock. The stage has run or been reused.
namespace pipeline {

// One line: "3 of 5 polygons kept".
template <class Real>
std::string countsOf(StageId stage, const FrameData<Real>& data);

// What was done, and what a rule left out, element by element.
template <class Real>
std::vector<Tally> talliesOf(StageId stage, const FrameData<Real>& data);

// If the stage's output is not what was requested: the reason.
template <class Real>
std::optional<Remark> remarkOf(StageId stage, const FrameData<Real>& data);

}  // namespace pipeline
