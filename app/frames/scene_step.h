#pragma once
#include <QUndoCommand>
#include <functional>
#include <memory>
#include <optional>

#include "pipeline/scene/settings_table.h"

namespace app {

using ScenePtr = std::shared_ptr<const pipeline::Scene>;

// The value of a setting before the last change.
struct SettingChange {
    pipeline::SettingRef setting;
    double before = 0, after = 0;
};

// The views' state that belongs to a step: `before` restores the old state, `after` the new one.
struct StepLooks {
    std::function<void()> before, after;
};

// One step of undo: the scene before and after it. The steps of one drag merge into one.
class SceneStep : public QUndoCommand {
public:
    // Shows what undo or redo leads to. Null scene: the step does not change it. Empty look: nothing to restore.
    using Show = std::function<void(const ScenePtr& scene, const std::function<void()>& look)>;

    // drag: steps with the same number >= 0 merge; steps with -1 never do.
    SceneStep(Show show, ScenePtr before, ScenePtr after, const QString& text, int drag = -1);
    SceneStep(Show show, ScenePtr before, ScenePtr after, const pipeline::SettingRef& setting, int drag);

    // The views' state belongs to the step; it may be all that the step changes.
    SceneStep(Show show, ScenePtr before, ScenePtr after, const QString& text, StepLooks looks);

    // The same step, for a new undo stack.
    SceneStep* copy() const;

    int id() const override { return m_drag; }
    bool mergeWith(const QUndoCommand* other) override;
    void undo() override;
    void redo() override;

    std::optional<SettingChange> change() const;
    const ScenePtr& before() const { return m_before; }
    bool changesScene() const { return m_before != m_after; }

private:
    void nameAfterSetting();

    Show m_show;
    ScenePtr m_before, m_after;
    std::optional<pipeline::SettingRef> m_setting;
    int m_drag = -1;
    StepLooks m_looks;
    bool m_undone = false;
};

}  // namespace app
