#pragma once
#include <optional>
#include <vector>

#include "pipeline/run/frame.h"

namespace pipeline {

// Why nothing of a frame's objects is visible, and which setting shows them. Polygons may face away, be outside the
// picture, before the near or behind the far plane, without area, transparent or smaller than a pixel. Or they are
// black, because the illumination model does not read a coefficient. Empty if something is visible.
std::optional<Remark> whyNothingIsSeen(const Frame& frame);

// Strange values of the scene, requests that its stages could not meet, and why nothing is visible.
std::vector<Remark> frameRemarks(const Frame& frame);

}  // namespace pipeline
