#pragma once
#include <optional>

#include "pipeline/run/frame.h"

namespace app {

// The texel in light k's shadow buffer of the point that a pixel shows: its column and row in the buffer's picture,
// where the faces (and samples of an area light) follow each other. For an area light the middle sample. Empty where
// nothing was drawn, if the light has no shadow buffer, and outside the buffer.
std::optional<glm::ivec2> shadowTexel(const pipeline::Frame& frame, std::size_t light, glm::ivec2 pixel);

}  // namespace app
