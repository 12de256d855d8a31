#pragma once
#include <vector>

#include "pipeline/buffers/buffer_table.h"
#include "pipeline/scene/scene.h"

namespace app {

// The buffer that a view shows when the window goes to a stage. It may be left out; then the view gives the reason.
pipeline::BufferName mainBuffer(pipeline::StageId stage, const pipeline::Scene& scene);
// The same inside the stage, where later stages have no output yet.
pipeline::BufferName mainBufferInside(pipeline::StageId stage, const pipeline::Scene& scene);
// The main buffer and then those that explain it, each once, for any number of views. All except the main one are
// useful in this scene; inside the stage none is from a later stage.
std::vector<pipeline::BufferName> usefulBuffers(pipeline::StageId stage, const pipeline::Scene& scene, bool inside);

}  // namespace app
