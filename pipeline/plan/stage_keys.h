#pragma once
#include <memory>

#include "pipeline/plan/needs.h"
#include "pipeline/stages/shading.h"

namespace pipeline {

// What each stage's output depends on beside the outputs of the stages before it. Compared by
// value: that, and nothing else, tells whether a stage has to run again.
struct StageKeys {
    TransformInputs transform;
    CullInputs cull;
    NormalsInputs normals;
    ShadowBufferInputs shadowBuffer;
    ZBufferInputs zBuffer;
    ShadingInputs shading;
};
StageKeys stageKeys(const Scene& scene, const Needs& needs, std::shared_ptr<const Topology> topology);

}  // namespace pipeline
