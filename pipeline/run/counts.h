#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pipeline/run/frame_data.h"

// What a stage did, in counts that no clock disturbs. The stage has run, or been reused.
namespace pipeline {

// In one line: "3 of 5 polygons kept".
template <class Real>
std::string countsOf(StageId stage, const FrameData<Real>& data);

// What was done and what a rule left out, element by element.
template <class Real>
std::vector<Tally> talliesOf(StageId stage, const FrameData<Real>& data);

// Where what the stage leaves is not what was asked for: why.
template <class Real>
std::optional<Remark> remarkOf(StageId stage, const FrameData<Real>& data);

}  // namespace pipeline
