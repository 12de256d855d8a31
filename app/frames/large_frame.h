#pragma once
#include "pipeline/run/frame.h"
#include "pipeline/scene/mesh/topology.h"

namespace app {

// More triangles than the window's thread can go through in a few milliseconds.
inline constexpr std::size_t kManyTriangles = 50000;

// More numbers than that; a picture of 640 × 480 in three channels has slightly fewer.
inline constexpr std::size_t kManyNumbers = std::size_t{1} << 20;

// Work on every polygon of such a frame runs in the background.
inline bool isLarge(const pipeline::Frame& frame) { return frame.topology().triangles.size() > kManyTriangles; }

}  // namespace app
