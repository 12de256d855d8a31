#pragma once
#include "pipeline/run/frame.h"

namespace lessons {

// Bytes, by frameBytes(): ChangedFrames drops its frames before they and a new one are more.
inline constexpr double kMostKeptBytes = 512.0 * 1024 * 1024;

// While one lives, its thread looks at a frame of with() and may make others for what stands within: together they take
// no more than a run may.
class HeldFrame {
public:
    explicit HeldFrame(const pipeline::Frame& frame);
    ~HeldFrame();
    HeldFrame(const HeldFrame&) = delete;
    HeldFrame& operator=(const HeldFrame&) = delete;

private:
    double m_before;
};

}  // namespace lessons
