#pragma once
#include "pipeline/core/stop.h"
#include "pipeline/run/frame.h"

namespace pipeline {

// What the frame of this scene would do after `before`, without doing it. `before` may be null.
Plan makePlan(const Scene& scene, const FrameRequest& request, const FramePtr& before);

// Computes the frame of a scene, reusing of `before` (which may be null) whatever still holds.
// The picture is the same, bit for bit, as one computed from nothing, on any number of threads.
// `before` itself where it is the frame of this very scene and request. Null when the request was stopped. The scene must have passed checkScene.
FramePtr runFrame(std::shared_ptr<const Scene> scene, const FrameRequest& request, const FramePtr& before);

// A whole frame as far as `stages` have got: they stand in for its stages' outputs, and nothing after `until` has
// run. What the plan left out stays left out. For stepping inside a frame (pipeline/steps/).
FramePtr unfinishedFrame(const Frame& whole, std::shared_ptr<const FrameStages> stages, StageId until);

// A stage of a whole frame once more, as its right text has it, on what the stages before it have left in the frame: where
// that is what the frame has too, the stage did what it should, whatever it got. Without a planted defect it is the frame.
FramePtr runAlone(const FramePtr& whole, StageId stage);

// The largest error of each stage's buffers against a double-precision run of the same scene:
// pixels for transform, a share of the polygons for cull, radians for normals; for the others the largest difference
// over the largest magnitude in double, in pixels that show the same polygon in both.
struct StageError {
    double value = 0;
    std::string text;  // "1.1e-5 px"
};
std::array<std::optional<StageError>, kStageCount> errorAgainstDouble(const FramePtr& frame, Stop stop = {});

}  // namespace pipeline
