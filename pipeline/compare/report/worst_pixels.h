#pragma once
#include <glm/vec2.hpp>
#include <vector>

#include "pipeline/compare/verdict.h"

namespace pipeline::foreign {

// The buffer of pixels in which the error shows first: of the first wrong stage if it has one that differs, else the first
// that differs. Null where none does.
const Finding* firstWrongPicture(const Report& report);

// Its pixels to look at: the largest difference first, each at least `apart` pixels from those before.
inline constexpr int kApart = 16;
std::vector<glm::ivec2> worstPixels(const Report& report, int apart = kApart);

}  // namespace pipeline::foreign
