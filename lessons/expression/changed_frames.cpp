#include "lessons/expression/changed_frames.h"

#include "lessons/expression/held_frame.h"

#include <fmt/format.h>

#include "pipeline/plan/frame_bytes.h"
#include "pipeline/run/runner.h"
#include "pipeline/scene/settings_table.h"

namespace lessons {

pipeline::Result<pipeline::Scene> withChanges(pipeline::Scene scene, std::span<const std::string> changes) {
    for (const std::string& change : changes) {
        auto next = pipeline::withSetting(std::move(scene), change);
        if (!next) return next;
        scene = std::move(next).value();
    }
    if (const pipeline::Errors errors = pipeline::checkSceneAndMemory(scene); !errors.empty()) return errors;
    return scene;
}

namespace {

thread_local double held = 0;  // bytes of the frames of with() that this thread evaluates in

}  // namespace

HeldFrame::HeldFrame(const pipeline::Frame& frame) : m_before(held) {
    held += frameBytes(frame.scene(), frame.wanted());
}
HeldFrame::~HeldFrame() { held = m_before; }

pipeline::Result<pipeline::FramePtr> ChangedFrames::frame(const pipeline::Frame& base,
                                                          std::span<const std::string> changes,
                                                          const pipeline::BufferSet& wanted,
                                                          const pipeline::Stop& stop) {
    if (m_scene != base.sharedScene()) {
        m_scene = base.sharedScene();
        m_frames.clear();
    }
    std::string key;
    for (const std::string& change : changes) key += change + '\n';
    pipeline::FramePtr known;
    if (const auto found = m_frames.find(key); found != m_frames.end()) {
        known = found->second;
        if ((wanted & ~known->wanted()).none()) return known;
    }
    auto scene = withChanges(base.scene(), changes);
    if (!scene) return scene.errors();
    pipeline::FrameRequest request;
    request.wanted = wanted | (known ? known->wanted() : pipeline::BufferSet());
    request.stop = stop;
    const double bytes = frameBytes(*scene, request.wanted);
    if (held + bytes > pipeline::kMemoryLimit)
        return pipeline::Error{
            {},
            fmt::format("frames of with() within one another take {:.1f} GiB", (held + bytes) / (1024.0 * 1024 * 1024)),
            "at most 4 GiB"};
    // Before the new one is made: a page may ask for any number of frames of any size.
    double all = held + bytes;
    for (const auto& [of, frame] : m_frames) all += frameBytes(frame->scene(), frame->wanted());
    if (all > kMostKeptBytes) m_frames.clear();
    auto frame = runFrame(std::make_shared<const pipeline::Scene>(std::move(scene).value()), request, known);
    if (!frame) return pipeline::Error{{}, "stopped"};
    m_frames[key] = frame;
    return frame;
}

}  // namespace lessons
