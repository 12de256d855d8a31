#pragma once
#include <string>
#include <utility>
#include <vector>

#include "pipeline/scene/scene.h"

namespace pipeline {

// A scene for renderers that read OBJ alone: NAME.obj in world space, NAME.mtl, and NAME.txt with camera, lights and what
// the picture's colours stand for, one thing a line. (file, text) each.
std::vector<std::pair<std::string, std::string>> objKit(const Scene& scene, const std::string& name);

}  // namespace pipeline
