#pragma once
#include "pipeline/core/stop.h"
#include "pipeline/run/frame.h"

namespace pipeline {

// The plan for the frame of this scene after `before`, without running it. `before` may be null.
Plan makePlan(const Scene& scene, const FrameRequest& request, const FramePtr& before);

// Computes the frame of a scene and reuses results of `before` (may be null) that are still valid. The picture has the
// same bits as one computed from nothing, on any number of threads. Returns `before` itself if scene and request are
// the same, and null if the request was stopped. The scene must have passed checkScene.
FramePtr runFrame(std::shared_ptr<const Scene> scene, const FrameRequest& request, const FramePtr& before);

// A frame in the middle of its stages: `stages` has their outputs so far, and nothing after `until` has run. What the
// plan left out stays left out. For stepping inside a frame (pipeline/steps/).
FramePtr unfinishedFrame(const Frame& whole, std::shared_ptr<const FrameStages> stages, StageId until);

// Runs one stage of a frame again with its right code, on the outputs of the stages before it. If the result equals the
// frame's, the stage did its work, whatever its inputs were. Without a planted defect it returns the frame.
FramePtr runAlone(const FramePtr& whole, StageId stage);

// The largest error of each stage's buffers against a run of the same scene in double. In pixels for transform, as a
// fraction of the polygons for cull, in radians for normals. For the others it is the largest difference over the
// largest magnitude in double, at pixels that show the same polygon in both.
struct StageError {
    double value = 0;
    std::string text;  // "1.1e-5 px"
};
std::array<std::optional<StageError>, kStageCount> errorAgainstDouble(const FramePtr& frame, Stop stop = {});

}  // namespace pipeline
