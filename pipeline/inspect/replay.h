#pragma once
#include <vector>

#include "pipeline/run/frame_data.h"

namespace pipeline {

// Every fragment that reached one pixel, in the order it was drawn: the z-buffer stage run again on
// that pixel alone, with recording on. Nothing is stored for it in a normal run.
template <class Real>
std::vector<FragmentRecord> replayPixel(const FrameData<Real>& data, glm::ivec2 pixel);

// The polygons that would have reached the pixel had culling kept them.
template <class Real>
std::vector<std::uint32_t> culledAt(const FrameData<Real>& data, glm::ivec2 pixel);

}  // namespace pipeline
