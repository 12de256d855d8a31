#pragma once
#include <vector>

#include "pipeline/buffers/buffer_table.h"
#include "pipeline/scene/scene.h"

namespace app {

// The buffer that a view shows when the window goes to a stage. It may be left out; the view then
// says why.
pipeline::BufferName mainBuffer(pipeline::StageId stage, const pipeline::Scene& scene);
// The same while the window stands inside the stage: later stages have left nothing yet.
pipeline::BufferName mainBufferInside(pipeline::StageId stage, const pipeline::Scene& scene);
// The main one, then what explains it, each once: for as many views as there are. All but the main one are buffers that
// the scene has a use for; inside the stage none is of a later one.
std::vector<pipeline::BufferName> usefulBuffers(pipeline::StageId stage, const pipeline::Scene& scene, bool inside);

}  // namespace app
