#include "lessons/expression/changed_frames.h"

#include "pipeline/plan/memory_limit.h"
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
    pipeline::FramePtr& known = m_frames[key];
    if (known && (wanted & ~known->wanted()).none()) return known;
    auto scene = withChanges(base.scene(), changes);
    if (!scene) return scene.errors();
    pipeline::FrameRequest request;
    request.wanted = wanted | (known ? known->wanted() : pipeline::BufferSet());
    request.stop = stop;
    auto frame = runFrame(std::make_shared<const pipeline::Scene>(std::move(scene).value()), request, known);
    if (!frame) return pipeline::Error{{}, "stopped"};
    known = frame;
    return frame;
}

}  // namespace lessons
