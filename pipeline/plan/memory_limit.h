#pragma once
#include "pipeline/buffers/buffer_table.h"
#include "pipeline/core/result.h"
#include "pipeline/core/stage.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// Why a frame takes more memory than a run may, if so. Counted is what the plan makes for a request: the buffers of its
// pixels and of its lights' shadows. The errors have keys, and no place. The scene has passed checkScene.
Errors checkMemory(const Scene& scene, BufferSet wanted, StageId until = StageId::Shading);

// As checkScene and, for those who may ask for any buffer later on, checkMemory of all of them.
Errors checkSceneAndMemory(const Scene& scene);

}  // namespace pipeline
