#pragma once
#include <QUndoCommand>

#include "app/core/document.h"

namespace app {

// One step of undo: the scene before and after it. The steps of one drag merge into one.
class SceneStep : public QUndoCommand {
public:
    using ScenePtr = std::shared_ptr<const pipeline::Scene>;
    using Looks = Document::Looks;

    // drag: steps with the same number >= 0 merge; steps with -1 never do.
    SceneStep(Document& document, ScenePtr before, ScenePtr after, const QString& text, int drag = -1);
    SceneStep(Document& document, ScenePtr before, ScenePtr after, const pipeline::SettingRef& setting, int drag);

    // The views' state belongs to the step; it may be all that the step changes.
    SceneStep(Document& document, ScenePtr before, ScenePtr after, const QString& text, Looks looks);

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

    Document& m_document;
    ScenePtr m_before, m_after;
    std::optional<pipeline::SettingRef> m_setting;
    int m_drag = -1;
    Looks m_looks;
    bool m_undone = false;
};

}  // namespace app
