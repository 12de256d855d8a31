#pragma once
#include <optional>

#include "pipeline/run/frame.h"

namespace app {

// On which texel of light k's shadow buffer the point falls that a pixel shows: column and row in the buffer's picture,
// whose faces, and samples of an area light, stand one after the other; of the samples the middle one. Nothing where
// nothing was drawn, where the light has no shadow buffer, and outside of it.
std::optional<glm::ivec2> shadowTexel(const pipeline::Frame& frame, std::size_t light, glm::ivec2 pixel);

}  // namespace app
