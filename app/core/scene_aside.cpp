#include "app/core/scene_aside.h"

#include "app/core/scene_step.h"

namespace app {

void Document::showState(pipeline::Scene scene) {
    m_undo.clear();
    m_frames.setLive(false);
    if (scene != *m_scene) setSceneValue(std::make_shared<const pipeline::Scene>(std::move(scene)));
}

Document::Steps Document::steps() const {
    Steps kept{{}, m_undo.index(), m_undo.cleanIndex()};
    for (int i = 0; i < m_undo.count(); ++i)
        kept.steps.emplace_back(static_cast<const SceneStep*>(m_undo.command(i))->copy());
    return kept;
}

void Document::restore(const Steps& steps) {
    m_restores = true;
    m_undo.clear();
    if (steps.clean < 0) m_undo.resetClean();
    for (int i = 0; i <= int(steps.steps.size()); ++i) {
        if (i == steps.clean) m_undo.setClean();
        if (i < int(steps.steps.size())) m_undo.push(steps.steps[std::size_t(i)]->copy());
    }
    m_undo.setIndex(steps.index);
    m_restores = false;
}

SceneAside::SceneAside(const Document& document)
    : m_scene(document.sharedScene()), m_kept(document.kept()), m_steps(document.steps()) {}

void SceneAside::putBack(Document& document) const {
    document.setScene(*m_scene, m_kept);
    document.restore(m_steps);
}

}  // namespace app
