#pragma once
#include "pipeline/run/frame.h"
#include "pipeline/scene/topology.h"

namespace app {

// More triangles than the window's thread goes through within a few milliseconds.
inline constexpr std::size_t kManyTriangles = 50000;

// What looks at every polygon of it is done beside the window.
inline bool isLarge(const pipeline::Frame& frame) { return frame.topology().triangles.size() > kManyTriangles; }

}  // namespace app
