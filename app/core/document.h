#pragma once
#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>
#include <QUndoStack>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "app/core/frame_worker.h"
#include "app/core/opened_scene.h"
#include "app/core/pointing.h"
#include "app/core/stepper.h"
#include "app/core/work_list.h"
#include "lessons/hidden.h"
#include "pipeline/core/result.h"
#include "pipeline/run/frame.h"
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

// The state of the window: scene, current stage and newest frame. Lives in the GUI thread and holds values; the
// FrameWorker computes. Panels observe it and send it intents. They never call a stage and never know another panel.
class Document : public QObject {
    Q_OBJECT
public:
    explicit Document(QObject* parent = nullptr);
    ~Document() override;

    bool hasScene() const { return m_scene != nullptr; }
    const pipeline::Scene& scene() const { return *m_scene; }  // only if hasScene()
    const std::shared_ptr<const pipeline::Scene>& sharedScene() const { return m_scene; }
    // The newest finished frame; null before the first. It may lag behind scene() while a slider moves;
    // frame()->scene() is the scene that it shows. While the user steps inside a frame, it is the frame so far.
    const pipeline::FramePtr& frame() const { return m_frame; }
    // The frame with all its stages, wherever the stepper is.
    const pipeline::FramePtr& wholeFrame() const { return m_whole; }
    Stepper& stepper() { return m_stepper; }
    const Stepper& stepper() const { return m_stepper; }
    bool busy() const { return m_busy; }                   // a frame is being computed
    WorkList& work() { return m_work; }                    // this, and the work that views wait for
    bool isMoving() const { return m_moving.isActive(); }  // a slider or a handle is being dragged
    pipeline::StageId stage() const { return m_stage; }
    Pointing& pointing() { return m_pointing; }
    const Pointing& pointing() const { return m_pointing; }
    // The report on the picked pixel in the current frame.
    PixelInspection& inspection() { return *m_inspection; }
    // One for each stage, computed in idle time after each frame; empty before.
    const StageErrors& errors() const { return m_check.errors; }
    // The number of NaN values in the frame's buffers; known together with the errors.
    std::optional<std::size_t> nanCount() const { return m_checked ? std::optional(m_check.nan) : std::nullopt; }
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
    // The buffers that `who` shows; buffers that nobody wants are not computed. Forgotten when `who` is deleted.
    // AtRest: not while a slider or a handle moves.
    enum class When { Always, AtRest };
    void want(const QObject* who, pipeline::BufferSet buffers, When when = When::Always);
    // `who`, which wants buffers, has not begun to draw the newest frame. While the scene moves, the next frame waits
    // for it, but not longer than 1/60 s: the other views go on, and `who` skips frames.
    void hold(const QObject* who, bool holds);

signals:
    void sceneOpened();   // another scene
    void sceneChanged();  // any change, undo included
    void keptChanged();   // kept(), after reading or writing
    void frameReady();
    void errorsReady();  // errors() and nanCount() belong to frame()
    void stageChanged();
    void hiddenChanged();
    void busyChanged(bool busy);                  // a frame is being computed
    void failed(const pipeline::Errors& errors);  // a refused change, or a file that cannot be read
    void notWritten(const QString& file, const pipeline::Errors& errors);
    void outOfMemory();                  // no new frame; frame() stays until something changes
    void said(const QString& sentence);  // for the status bar

private:
    friend class SceneStep;
    const SceneStep* newestChange() const;
    void showStage(pipeline::StageId stage);
    void showFrame(const pipeline::FramePtr& frame);
    void setSceneValue(std::shared_ptr<const pipeline::Scene> scene);
    void requestFrameSoon();
    void requestFrame();
    bool waits();  // for the views, or for the running frame
    void observeWork();
    void cancelFrame();
    void takeFrame(pipeline::FramePtr frame, long ticket);
    void takeFailure(long ticket);
    void takeCheck(const pipeline::FramePtr& frame, const FrameCheck& check);
    void forgetCheck();
    void setBusy(bool busy);
    pipeline::BufferSet wanted() const;

    std::shared_ptr<const pipeline::Scene> m_scene;
    KeptScene m_kept;
    lessons::Hidden m_hidden;
    bool m_restores = false;  // during undo and redo, which make no new steps
    WorkList m_work;
    pipeline::FramePtr m_frame, m_whole;
    Stepper m_stepper;
    pipeline::StageId m_stage = pipeline::StageId::Shading;
    Pointing m_pointing;
    FrameCheck m_check;
    bool m_checked = false;
    struct Want {
        pipeline::BufferSet buffers;
        When when = When::Always;
    };
    std::map<const QObject*, Want> m_wanted;
    QTimer m_moving;  // runs from a live change until some time after the last one
    std::set<const QObject*> m_holding;
    QTimer m_held;                 // a waiting request
    QElapsedTimer m_sinceRequest;  // since the newest request
    QUndoStack m_undo;

    // Frames: the last request and the last result.
    bool m_requestPending = false;  // requestFrame runs when control returns to the event loop
    bool m_busy = false;
    long m_ticket = 0, m_taken = 0;  // of the newest request; of m_whole
    long m_oldestValid = 0;          // older tickets belong to a closed scene or were cancelled
    pipeline::BufferSet m_requested;
    std::shared_ptr<const pipeline::Scene> m_requestedScene;

    // A drag: Live changes of one setting, which are one step of undo.
    void setLive(bool live);
    bool m_live = false;
    int m_drag = 0;
    std::optional<pipeline::SettingRef> m_dragged;  // empty: m_edited names the drag
    QString m_edited;

    std::unique_ptr<FrameWorker> m_worker;
    std::unique_ptr<MixModel> m_mixer;
    std::unique_ptr<DerivedBuffers> m_derived;
    std::unique_ptr<PixelInspection> m_inspection;
    std::unique_ptr<RendererCheck> m_renderer;
};

}  // namespace app
