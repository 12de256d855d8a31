#pragma once
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "pipeline/core/result.h"
#include "pipeline/scene/scene.h"

namespace app {

// "640x480" and "12,40": two whole numbers around a separator, nothing else.
std::optional<glm::ivec2> parsePair(std::string_view text, char separator);

// --pixel's X,Y. The error says which pixels the scene has.
pipeline::Result<glm::ivec2> pixelIn(const pipeline::Scene& scene, const std::string& text);

}  // namespace app
