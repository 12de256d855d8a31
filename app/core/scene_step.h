#pragma once
#include <QUndoCommand>

#include "app/core/document.h"

namespace app {

// One step of undo: the scene before and after it. The steps of one drag merge into one.
class SceneStep : public QUndoCommand {
public:
    using ScenePtr = std::shared_ptr<const pipeline::Scene>;

    // drag: steps with the same number >= 0 merge; -1 never does.
    SceneStep(Document& document, ScenePtr before, ScenePtr after, const QString& text, int drag = -1);
    SceneStep(Document& document, ScenePtr before, ScenePtr after, const pipeline::SettingRef& setting, int drag);

    int id() const override { return m_drag; }
    bool mergeWith(const QUndoCommand* other) override;
    void undo() override;
    void redo() override;

    std::optional<SettingChange> change() const;
    const ScenePtr& before() const { return m_before; }

private:
    void nameAfterSetting();

    Document& m_document;
    ScenePtr m_before, m_after;
    std::optional<pipeline::SettingRef> m_setting;
    int m_drag = -1;
};

}  // namespace app
