#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/compare/handed_in/reading.h"

namespace pipeline::foreign {

inline constexpr double kFarthestElement = 20;  // tolerances: one element counts no more

// How far a reading is from the reference: the trimmed mean of the differences, in tolerances, and a penalty for what is
// drawn in one alone.
double readingCost(const HandedFile& file, const Values& mine, const Values& reference, const ReadingContext& context,
                   double tolerance);

// Which elements are drawn, by what a file itself says; empty where it does not say.
std::vector<std::uint8_t> drawnIn(const HandedName& name, const Values& mine);

}  // namespace pipeline::foreign
