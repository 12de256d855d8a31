#include "app/frames/scene_step.h"

#include "app/frames/equation_symbols.h"
#include "app/look/text.h"

namespace app {

SceneStep::SceneStep(Show show, ScenePtr before, ScenePtr after, const QString& text, int drag)
    : m_show(std::move(show)), m_before(std::move(before)), m_after(std::move(after)), m_drag(drag) {
    setText(text);
}

SceneStep::SceneStep(Show show, ScenePtr before, ScenePtr after, const pipeline::SettingRef& setting, int drag)
    : m_show(std::move(show)),
      m_before(std::move(before)),
      m_after(std::move(after)),
      m_setting(setting),
      m_drag(drag) {
    nameAfterSetting();
}

SceneStep::SceneStep(Show show, ScenePtr before, ScenePtr after, const QString& text, StepLooks looks)
    : SceneStep(std::move(show), std::move(before), std::move(after), text) {
    m_looks = std::move(looks);
}

SceneStep* SceneStep::copy() const {
    auto* step = new SceneStep(m_show, m_before, m_after, text(), m_looks);
    step->m_setting = m_setting;
    return step;
}

bool SceneStep::mergeWith(const QUndoCommand* other) {
    const auto& newer = static_cast<const SceneStep&>(*other);  // same id: a step of the same drag
    m_after = newer.m_after;
    if (m_setting) nameAfterSetting();
    setObsolete(*m_before == *m_after);  // dragged back to where it began
    return true;
}

void SceneStep::undo() {
    m_undone = true;
    m_show(changesScene() ? m_before : nullptr, m_looks.before);
}

// The first time it is being made, and whoever makes it shows the rest.
void SceneStep::redo() { m_show(changesScene() ? m_after : nullptr, m_undone ? m_looks.after : nullptr); }

std::optional<SettingChange> SceneStep::change() const {
    if (!m_setting) return std::nullopt;
    return SettingChange{*m_setting, m_setting->get(*m_before), m_setting->get(*m_after)};
}

// "n exponent 4 → 8"
void SceneStep::nameAfterSetting() {
    const auto text = [this](const pipeline::Scene& scene) {
        return QString::fromStdString(formatSetting(*m_setting, m_setting->get(scene)));
    };
    setText(QStringLiteral("%1 %2 → %3").arg(labelOf(*m_setting), text(*m_before), text(*m_after)));
}

}  // namespace app
