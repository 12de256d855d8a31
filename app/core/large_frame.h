#pragma once
#include "pipeline/run/frame.h"
#include "pipeline/scene/topology.h"

namespace app {

// More triangles than the window's thread goes through within a few milliseconds.
inline constexpr std::size_t kManyTriangles = 50000;

// More numbers than that: a picture of 640 × 480 in three channels has some fewer.
inline constexpr std::size_t kManyNumbers = std::size_t{1} << 20;

// What looks at every polygon of it is done beside the window.
inline bool isLarge(const pipeline::Frame& frame) { return frame.topology().triangles.size() > kManyTriangles; }

}  // namespace app
