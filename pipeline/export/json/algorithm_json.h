#pragma once
#include "pipeline/export/json/json_value.h"
#include "pipeline/steps/algorithm.h"

namespace pipeline {

// A moment of an algorithm: its name and title, the number of the line that it is at (null where it is at none), whether
// the step is over, the lines with their status and values (numbers exact, null where infinite), and what is left out.
Json toJson(const AlgorithmState& state);

}  // namespace pipeline
