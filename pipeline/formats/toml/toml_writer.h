#pragma once
#include <string>
#include <string_view>

#include "pipeline/core/result.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// A scene as readTomlScene reads it: the same picture, bit for bit. Nothing beside it is needed: meshes that are no
// built-in shapes stand in it. What has its default value is left out. Refused above kMaxTomlBytes.
Result<std::string> toTomlScene(const Scene& scene);

// A string in double quotes, escaped.
std::string tomlString(std::string_view text);
// The same, over several lines as it is where it has several and nothing forbids it.
std::string tomlText(std::string_view text);
// The fewest digits that read as the same number; it is finite.
std::string tomlNumber(double value);

}  // namespace pipeline
