#pragma once
#include "pipeline/buffers/buffer_table.h"
#include "pipeline/scene/scene.h"

namespace app {

// The buffer that a view shows when the window goes to a stage. It may be left out; the view then
// says why.
pipeline::BufferName mainBuffer(pipeline::StageId stage, const pipeline::Scene& scene);
// The one to show beside it: what the stage leaves that explains the main one.
pipeline::BufferName secondBuffer(pipeline::StageId stage, const pipeline::Scene& scene);
// Both while the window stands inside the stage: later stages have left nothing yet.
pipeline::BufferName mainBufferInside(pipeline::StageId stage, const pipeline::Scene& scene);
pipeline::BufferName secondBufferInside(pipeline::StageId stage, const pipeline::Scene& scene);

}  // namespace app
