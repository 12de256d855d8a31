#pragma once
#include <vector>

#include "pipeline/plan/needs.h"
#include "pipeline/plan/plan.h"

namespace pipeline {

// The parts of a stage that may be left out by themselves, for a stage that does `action`.
std::vector<PlanPart> planParts(StageId stage, const Scene& scene, const Needs& needs, Action action);

}  // namespace pipeline
