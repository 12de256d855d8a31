#pragma once
#include <vector>

#include "pipeline/scene/remark.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// Remarks beyond these are counted in a last one.
inline constexpr std::size_t kMaxRemarks = 64;

// What is strange about a scene that has passed checkScene, in the scene's order: the readers'
// remarks, camera, lights, then objects with their materials. Settings that this scene does not
// read are not looked at.
std::vector<Remark> sceneRemarks(const Scene& scene);

}  // namespace pipeline
