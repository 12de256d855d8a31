#pragma once
#include <string_view>

namespace pipeline {

// The name of the instruction set that the SIMD kernels need and this CPU lacks; empty if they run. Only a build for
// one machine (SHADESCOPE_THIS_MACHINE) may lack one: else the kernels for any CPU are there.
std::string_view missingInstructions();

}  // namespace pipeline
