#pragma once
#include <vector>

#include "app/panels/shown_buffer.h"

namespace app {

// What the colours of a buffer of names stand for, and how often each comes among the drawn elements. drawn: which of
// them hold something; empty: all. Negative numbers stand for nothing.
std::vector<LegendEntry> legendOf(const pipeline::Frame& frame, const pipeline::AnyBuffer& buffer,
                                  const std::vector<bool>& drawn);

}  // namespace app
