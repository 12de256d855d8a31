#pragma once
#include <QObject>
#include <QString>
#include <QUndoStack>
#include <functional>
#include <memory>
#include <optional>

#include "app/core/frame_feed.h"
#include "app/core/opened_scene.h"
#include "app/core/pointing.h"
#include "app/core/stepper.h"
#include "app/core/work_list.h"
#include "lessons/hidden.h"
#include "pipeline/core/result.h"
#include "pipeline/scene/settings_table.h"

namespace app {

class DerivedBuffers;
class MixModel;
class PixelInspection;
class RendererCheck;
class SceneStep;

// The value of a setting before the last change.
struct SettingChange {
    pipeline::SettingRef setting;
    double before = 0, after = 0;
};

// The scene and its undo, the current stage, and what follows the scene: its frames and where the user points in it.
// Lives in the GUI thread. Panels observe it and send it intents. They never call a stage and never know another panel.
class Document : public QObject {
    Q_OBJECT
public:
    explicit Document(QObject* parent = nullptr);
    ~Document() override;

    bool hasScene() const { return m_scene != nullptr; }
    const pipeline::Scene& scene() const { return *m_scene; }  // only if hasScene()
    const std::shared_ptr<const pipeline::Scene>& sharedScene() const { return m_scene; }
    FrameFeed& frames() { return m_frames; }
    const FrameFeed& frames() const { return m_frames; }
    Pointing& pointing() { return m_pointing; }
    const Pointing& pointing() const { return m_pointing; }
    Stepper& stepper() { return m_stepper; }
    const Stepper& stepper() const { return m_stepper; }
    WorkList& work() { return m_work; }  // the frame, and the work that views wait for
    pipeline::StageId stage() const { return m_stage; }
    // The report on the picked pixel in the current frame.
    PixelInspection& inspection() { return *m_inspection; }
    QUndoStack* undoStack() { return &m_undo; }
    DerivedBuffers& derived() { return *m_derived; }
    const DerivedBuffers& derived() const { return *m_derived; }
    const MixModel& mixer() const { return *m_mixer; }
    MixModel& mixer() { return *m_mixer; }             // the mix of the terms in the pictures
    RendererCheck& renderer() { return *m_renderer; }  // another renderer, compared with this scene
    const RendererCheck& renderer() const { return *m_renderer; }
    // The setting that the last step of undo changed, if it changed exactly one.
    std::optional<SettingChange> lastChange() const;
    // The scene before the last step of undo; a whole drag is one step. Null if there is none.
    std::shared_ptr<const pipeline::Scene> sceneBefore() const;

    // What must stay hidden on a page of a lesson until its question is settled. Everything that shows a buffer or is a
    // part of the window asks here.
    const lessons::Hidden& hidden() const { return m_hidden; }
    void setHidden(lessons::Hidden hidden);

    const KeptScene& kept() const { return m_kept; }
    // Whether closing would lose changes to a file.
    bool isChanged() const { return m_kept.scene && isEdited(); }
    // Whether the scene has changed since it was opened or saved.
    bool isEdited() const;

    // A picture with a scene opens at the stage of the picture's buffer.
    void open(const OpenedScene& opened);
    // Reloads the file as one step of undo. Returns false and changes nothing if the scene in it has other settings.
    bool reload(const OpenedScene& again);
    // Writes the scene with its settings as TOML, whole or not at all. If that fails, notWritten() gives the reason.
    bool save(const QString& file);
    void setScene(pipeline::Scene scene, KeptScene kept = {});  // as if opened: clears the undo stack

    // Shows another state of the scene that is not a change of it; clears the undo stack.
    void showState(pipeline::Scene scene);
    // The undo steps of the current scene: `index` of them are done. After `clean` of them the scene equals its file;
    // −1: never.
    struct Steps {
        std::vector<std::shared_ptr<SceneStep>> steps = {};
        int index = 0, clean = 0;
    };
    Steps steps() const;
    void restore(const Steps& steps);  // after setScene has shown their scene again

    // Changes one setting. While a slider is dragged, use Live for every step, then Done; the whole drag is one step of
    // undo. Values out of range and scenes that checkScene refuses change nothing; failed() reports them.
    enum class Change { Live, Done };
    void change(const pipeline::SettingRef& setting, double value, Change kind = Change::Done);
    // Changes several numbers at once: the Live edits with the same `text` up to Done are one step of undo with that
    // name. If the last edit restores the first scene, there is no step.
    void edit(pipeline::Scene scene, const QString& text, Change kind);
    // Replaces the scene in one step of undo, named by `text`.
    void replace(pipeline::Scene scene, const QString& text);
    // The views' state that belongs to the step: `before` restores the old state, `after` the new one.
    struct Looks {
        std::function<void()> before, after;
    };
    void replace(pipeline::Scene scene, const QString& text, Looks looks);

    void setStage(pipeline::StageId stage);  // also leaves the inside of a stage
    void nextStage();
    void previousStage();

signals:
    void sceneOpened();   // another scene
    void sceneChanged();  // any change, undo included
    void keptChanged();   // kept(), after reading or writing
    void stageChanged();
    void hiddenChanged();
    void failed(const pipeline::Errors& errors);  // a refused change, or a file that cannot be read
    void notWritten(const QString& file, const pipeline::Errors& errors);
    void said(const QString& sentence);  // for the status bar

private:
    friend class SceneStep;
    const SceneStep* newestChange() const;
    void showStage(pipeline::StageId stage);
    void setSceneValue(std::shared_ptr<const pipeline::Scene> scene);

    std::shared_ptr<const pipeline::Scene> m_scene;
    KeptScene m_kept;
    lessons::Hidden m_hidden;
    bool m_restores = false;  // during undo and redo, which make no new steps
    WorkList m_work;
    Stepper m_stepper;
    FrameFeed m_frames{m_stepper, m_work};
    pipeline::StageId m_stage = pipeline::StageId::Shading;
    Pointing m_pointing;
    QUndoStack m_undo;

    // A drag: Live changes of one setting, which are one step of undo.
    int m_drag = 0;
    std::optional<pipeline::SettingRef> m_dragged;  // empty: m_edited names the drag
    QString m_edited;

    std::unique_ptr<MixModel> m_mixer;
    std::unique_ptr<DerivedBuffers> m_derived;
    std::unique_ptr<PixelInspection> m_inspection;
    std::unique_ptr<RendererCheck> m_renderer;
};

}  // namespace app
