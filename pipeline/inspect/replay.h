#pragma once
#include <vector>

#include "pipeline/core/stop.h"
#include "pipeline/run/frame_data.h"
#include "pipeline/stages/translucent.h"

namespace pipeline {

// Every fragment that reached one pixel, in the order it was drawn: the z-buffer stage run again on
// that pixel alone, with recording on. Nothing is stored for it in a normal run. What is stopped gives less.
template <class Real>
std::vector<FragmentRecord> replayPixel(const FrameData<Real>& data, glm::ivec2 pixel, const Stop& stop = {});

// The same for all pixels of a tile, in the order they were drawn.
template <class Real>
std::vector<FragmentRecord> replayTile(const FrameData<Real>& data, Tile tile, const Stop& stop = {});

// The layers of translucent surfaces over one pixel, in the order in which they are laid over it.
template <class Real>
std::vector<Layer<Real>> replayLayers(const FrameData<Real>& data, glm::ivec2 pixel);

// The polygons that would have reached the pixel had culling kept them.
template <class Real>
std::vector<std::uint32_t> culledAt(const FrameData<Real>& data, glm::ivec2 pixel, const Stop& stop = {});

}  // namespace pipeline
