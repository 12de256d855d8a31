#pragma once
#include <QObject>
#include <QUndoStack>
#include <variant>
#include <vector>

#include "app/frames/scene_step.h"

namespace app {

// The undo steps of a scene. A drag is one step.
class SceneHistory : public QObject {
    Q_OBJECT
public:
    explicit SceneHistory(QObject* parent = nullptr);
    ~SceneHistory() override;

    QUndoStack* stack() { return &m_stack; }
    // The setting that the last step changed, if it changed exactly one.
    std::optional<SettingChange> lastChange() const;
    // The scene before the last step; a whole drag is one step. Null if there is none.
    ScenePtr sceneBefore() const;
    // Whether the scene has changed since it was opened or saved.
    bool isEdited() const;

    void clear();
    // One step of its own. Null `looks`: it changes the scene alone.
    void push(ScenePtr before, ScenePtr after, const QString& text, StepLooks looks);
    // What changes by a drag: one setting, or several numbers under the name of their step.
    using Dragged = std::variant<pipeline::SettingRef, QString>;
    // The next change of `what`. true: it belongs to the drag before. `live`: more of the drag follows.
    bool drag(const Dragged& what, bool live);
    void pushDragged(ScenePtr before, ScenePtr after);  // a step of that drag
    void endDrag() { m_live = false; }

    // All steps: `index` of them are done. After `clean` of them the scene equals its file; −1: never.
    struct Steps {
        std::vector<std::shared_ptr<SceneStep>> steps = {};
        int index = 0, clean = 0;
    };
    Steps steps() const;
    void restore(const Steps& steps);  // their scene is on show again

signals:
    void stepped(const app::ScenePtr& scene);  // to be shown now

private:
    const SceneStep* newestChange() const;
    SceneStep::Show shows();

    QUndoStack m_stack;
    bool m_restores = false;  // the steps show nothing
    bool m_live = false;      // a drag goes on
    int m_drag = 0;           // its number
    Dragged m_dragged;
};

}  // namespace app
