#include "app/document/scene_history.h"

#include <algorithm>

namespace app {

SceneHistory::SceneHistory(QObject* parent) : QObject(parent) {}

SceneHistory::~SceneHistory() {
    m_stack.disconnect();  // clearing itself, it would tell observers that may be gone
}

SceneStep::Show SceneHistory::shows() {
    return [this](const ScenePtr& scene, const std::function<void()>& look) {
        if (m_restores) return;
        if (scene) emit stepped(scene);
        if (look) look();
    };
}

// Steps of undo that change what is on show alone are none of the scene's.
const SceneStep* SceneHistory::newestChange() const {
    for (int i = m_stack.index() - 1; i >= 0; --i)
        if (const auto* step = static_cast<const SceneStep*>(m_stack.command(i)); step->changesScene()) return step;
    return nullptr;
}

std::optional<SettingChange> SceneHistory::lastChange() const {
    const SceneStep* step = newestChange();
    return step ? step->change() : std::nullopt;
}

ScenePtr SceneHistory::sceneBefore() const {
    const SceneStep* step = newestChange();
    return step ? step->before() : nullptr;
}

bool SceneHistory::isEdited() const {
    const int clean = m_stack.cleanIndex(), now = m_stack.index();
    if (clean < 0) return true;  // no undo leads there
    for (int i = std::min(clean, now); i < std::max(clean, now); ++i)
        if (static_cast<const SceneStep*>(m_stack.command(i))->changesScene()) return true;
    return false;
}

void SceneHistory::clear() { m_stack.clear(); }

void SceneHistory::push(ScenePtr before, ScenePtr after, const QString& text, StepLooks looks) {
    m_stack.push(new SceneStep(shows(), std::move(before), std::move(after), text, std::move(looks)));
}

bool SceneHistory::drag(const Dragged& what, bool live) {
    const bool goesOn = m_live && m_dragged == what;
    if (!goesOn) ++m_drag;
    m_live = live;
    m_dragged = what;
    return goesOn;
}

void SceneHistory::pushDragged(ScenePtr before, ScenePtr after) {
    m_stack.push(std::visit(
        [&](const auto& what) { return new SceneStep(shows(), std::move(before), std::move(after), what, m_drag); },
        m_dragged));
}

SceneHistory::Steps SceneHistory::steps() const {
    Steps kept{{}, m_stack.index(), m_stack.cleanIndex()};
    for (int i = 0; i < m_stack.count(); ++i)
        kept.steps.emplace_back(static_cast<const SceneStep*>(m_stack.command(i))->copy());
    return kept;
}

void SceneHistory::restore(const Steps& steps) {
    m_restores = true;
    m_stack.clear();
    if (steps.clean < 0) m_stack.resetClean();
    for (int i = 0; i <= int(steps.steps.size()); ++i) {
        if (i == steps.clean) m_stack.setClean();
        if (i < int(steps.steps.size())) m_stack.push(steps.steps[std::size_t(i)]->copy());
    }
    m_stack.setIndex(steps.index);
    m_restores = false;
}

}  // namespace app
