#pragma once
#include <hwy/targets.h>

namespace test {

// A build for one machine has the kernels of its instruction set alone: nothing to compare them with.
inline constexpr bool kHasOneInstructionSet = (HWY_TARGETS & (HWY_TARGETS - 1)) == 0;
inline constexpr const char* kWhyNotCompared = "built for one instruction set; the preset ci has all of them";

}  // namespace test
