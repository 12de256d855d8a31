#pragma once
#include <optional>
#include <vector>

#include "pipeline/run/frame.h"

namespace pipeline {

// Why nothing of a frame's objects is seen, as far as its stages tell, and which setting shows them: polygons that face
// away, are outside the picture, before the near or behind the far plane, without area, wholly transparent or smaller than
// a pixel; or drawn and black, with what the illumination model in force does not read. Nothing where something is seen.
std::optional<Remark> whyNothingIsSeen(const Frame& frame);

// What is strange about the frame's scene, what its stages did not do as they were asked, and why nothing is seen.
std::vector<Remark> frameRemarks(const Frame& frame);

}  // namespace pipeline
