#include "pipeline/simd/missing_instructions.h"

#include "pipeline/simd/targets.h"
//
#include <hwy/highway.h>

namespace pipeline {

std::string_view missingInstructions() {
    return (hwy::SupportedTargets() & HWY_TARGETS) != 0 ? "" : hwy::TargetName(HWY_STATIC_TARGET);
}

}  // namespace pipeline
