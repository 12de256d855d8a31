#pragma once
#include <vector>

#include "app/canvas/shown_buffer.h"

namespace app {

// The meaning of each colour of a buffer of names, and its number of drawn elements. drawn: which elements hold
// something; empty: all. Negative values have no name and are not counted.
std::vector<LegendEntry> legendOf(const pipeline::Frame& frame, const pipeline::AnyBuffer& buffer,
                                  const std::vector<bool>& drawn);

}  // namespace app
