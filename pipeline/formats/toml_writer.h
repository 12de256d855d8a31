#pragma once
#include <string>

#include "pipeline/core/result.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// A scene as readTomlScene reads it: the same picture, bit for bit. Nothing beside it is needed: meshes that are no
// built-in shapes stand in it. What has its default value is left out. Refused above kMaxTomlBytes.
Result<std::string> toTomlScene(const Scene& scene);

}  // namespace pipeline
