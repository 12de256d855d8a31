#pragma once
#include <cstdint>

#include "lessons/grading/sheet.h"
#include "lessons/pages/handout.h"

namespace lessons {

// A handout with numbers of its tables and equations left blank, up to `count` on each page, and its answers with these
// numbers. At most one number a row of a table, so that the row and the tables before it give it; of an equation the
// last one, its result. seed: which ones.
Sheets::Pages blanked(const Handout& handout, std::size_t count, std::uint64_t seed);

}  // namespace lessons
