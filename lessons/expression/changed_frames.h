#pragma once
#include <map>
#include <span>
#include <string>

#include "pipeline/core/result.h"
#include "pipeline/core/stop.h"
#include "pipeline/run/frame.h"

namespace lessons {

// Frames of a scene with some settings changed, as with(shading=gouraud; …) asks for them. Each is computed once.
class ChangedFrames {
public:
    // The frame of the base's scene after `changes`, "KEY=VALUE" each, with the wanted buffers. Errors say what is wrong
    // with a change, or "stopped".
    pipeline::Result<pipeline::FramePtr> frame(const pipeline::Frame& base, std::span<const std::string> changes,
                                               const pipeline::BufferSet& wanted, const pipeline::Stop& stop);

private:
    std::shared_ptr<const pipeline::Scene> m_scene;  // of the base
    std::map<std::string, pipeline::FramePtr> m_frames;
};

// `scene` after `changes`, checked.
pipeline::Result<pipeline::Scene> withChanges(pipeline::Scene scene, std::span<const std::string> changes);

}  // namespace lessons
