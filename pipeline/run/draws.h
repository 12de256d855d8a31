#pragma once
#include "pipeline/run/frame.h"

namespace pipeline {

// The frame with another draw of its pixels' samples, on all threads: of jittered or random positions (samplePlaces), else
// the same. Draw 0 is the frame's own. Null when it was stopped.
FramePtr withDraw(const FramePtr& frame, unsigned draw, Stop stop);

}  // namespace pipeline
