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
#include "app/core/stepper.h"
#include "app/core/work_list.h"
#include "lessons/hidden.h"
#include "lessons/state/selection.h"
#include "pipeline/core/result.h"
#include "pipeline/run/frame.h"
#include "pipeline/scene/settings_table.h"

namespace app {

class DerivedBuffers;
class MixModel;
class PixelInspection;
class SceneStep;

// A setting's value before the newest step of undo.
struct SettingChange {
    pipeline::SettingRef setting;
    double before = 0, after = 0;
};

// What the window shows: a scene, the stage on show, the picked pixel, and the newest frame.
// Lives in the GUI thread and holds values; the FrameWorker computes. Panels observe it and
// send it intents; they never call a stage and never know another panel.
class Document : public QObject {
    Q_OBJECT
public:
    explicit Document(QObject* parent = nullptr);
    ~Document() override;

    bool hasScene() const { return m_scene != nullptr; }
    const pipeline::Scene& scene() const { return *m_scene; }  // only when hasScene()
    const std::shared_ptr<const pipeline::Scene>& sharedScene() const { return m_scene; }
    // The newest finished frame; null before the first. It may lag behind scene() while a slider moves.
    // frame()->scene() is the scene that it shows. While stepping inside it, the frame as far as it has got.
    const pipeline::FramePtr& frame() const { return m_frame; }
    // With all its stages, wherever the stepper stands.
    const pipeline::FramePtr& wholeFrame() const { return m_whole; }
    Stepper& stepper() { return m_stepper; }
    const Stepper& stepper() const { return m_stepper; }
    bool busy() const { return m_busy; }                   // a frame is being computed
    WorkList& work() { return m_work; }                    // that, and what its views wait for
    bool isMoving() const { return m_moving.isActive(); }  // under a slider or a handle
    pipeline::StageId stage() const { return m_stage; }
    std::optional<glm::ivec2> pixel() const { return m_pixel; }
    // What the frame on show has there.
    PixelInspection& inspection() { return *m_inspection; }
    // What is selected beside the pixel; picking a pixel forgets it.
    const std::optional<lessons::Selection>& selection() const { return m_selection; }
    std::optional<glm::ivec2> hovered() const { return m_hovered; }
    int channel() const { return m_channel; }  // 0 r, 1 g, 2 b: for the equation
    // The buffer or setting that a part of the equation under the cursor stands for; empty where there is none.
    const QString& pointed() const { return m_pointed; }
    // Per stage, once computed (in idle time, after each frame); nothing before.
    const StageErrors& errors() const { return m_check.errors; }
    // How many numbers in the frame's buffers are none; known when the errors are.
    std::optional<std::size_t> nanCount() const { return m_checked ? std::optional(m_check.nan) : std::nullopt; }
    QUndoStack* undoStack() { return &m_undo; }
    DerivedBuffers& derived() { return *m_derived; }
    const DerivedBuffers& derived() const { return *m_derived; }
    const MixModel& mixer() const { return *m_mixer; }
    MixModel& mixer() { return *m_mixer; }  // how the terms are mixed in the pictures on show
    // What the newest step of undo changed, where it changed one setting.
    std::optional<SettingChange> lastChange() const;
    // The scene before the newest step of undo, a whole drag being one; null where there is none.
    std::shared_ptr<const pipeline::Scene> sceneBefore() const;

    // What must neither be shown nor told now: on a page of a lesson, before its question is settled. The one place that
    // says so; whoever shows a buffer or is a part of the window asks here.
    const lessons::Hidden& hidden() const { return m_hidden; }
    void setHidden(lessons::Hidden hidden);

    const KeptScene& kept() const { return m_kept; }
    // Whether closing it would lose changes to a file.
    bool isChanged() const { return m_kept.scene && isEdited(); }
    // Whether the scene is another than when it was opened or saved.
    bool isEdited() const;

    // A picture that carries its scene begins at the stage of what it shows.
    void open(const OpenedScene& opened);
    // Its file, read again: one step of undo. False where the scene in it has other settings, and nothing has changed.
    bool reload(const OpenedScene& again);
    // Writes the scene with its settings as TOML, whole or not at all. When that fails notWritten() tells why.
    bool save(const QString& file);
    void setScene(pipeline::Scene scene, KeptScene kept = {});  // as if opened: clears the undo stack

    // Another state of the scene on show, which is no change of it: steps of undo are forgotten.
    void showState(pipeline::Scene scene);
    // The steps of undo of the scene on show: `index` of them are done; `clean` of them led to what its file has, −1
    // where none did.
    struct Steps {
        std::vector<std::shared_ptr<SceneStep>> steps = {};
        int index = 0, clean = 0;
    };
    Steps steps() const;
    void restore(const Steps& steps);  // those of a scene that setScene has shown again

    // Changes one setting. While a slider is dragged: Live for every step, then Done; the whole
    // drag is one step of undo. Out-of-range values and scenes that checkScene refuses change
    // nothing and are reported through failed().
    enum class Change { Live, Done };
    void change(const pipeline::SettingRef& setting, double value, Change kind = Change::Done);
    // Several numbers at once: the Live edits of one `text` up to Done are one step of undo, named by it.
    // Back at the scene that it began with it leaves no step.
    void edit(pipeline::Scene scene, const QString& text, Change kind);
    // Replaces the scene in one step of undo, named by `text`.
    void replace(pipeline::Scene scene, const QString& text);
    // What is on show belongs to the step: `before` brings back what it was, `after` shows the new again.
    struct Looks {
        std::function<void()> before, after;
    };
    void replace(pipeline::Scene scene, const QString& text, Looks looks);

    void setStage(pipeline::StageId stage);  // leaves the inside of a stage
    void nextStage();
    void previousStage();
    void pick(std::optional<glm::ivec2> pixel);                // clamped to the picture
    void select(std::optional<lessons::Selection> selection);  // nothing where the scene has no such thing
    void hover(std::optional<glm::ivec2> pixel);
    void setChannel(int channel);
    void point(const QString& refers);
    // The buffers that `who` shows. What nobody wants is not computed. Forgotten with `who`.
    // AtRest: not while a slider or a handle moves.
    enum class When { Always, AtRest };
    void want(const QObject* who, pipeline::BufferSet buffers, When when = When::Always);
    // `who`, which wants buffers, has not begun to draw the newest frame. While the scene moves the next one waits for it,
    // so that the processors have no frames to make that nobody sees; at 30 a second it waits no longer.
    void hold(const QObject* who, bool holds);

signals:
    void sceneOpened();   // another scene
    void sceneChanged();  // any change of it, undo included
    void keptChanged();   // kept(), which has just been read or written
    void frameReady();
    void errorsReady();  // errors() and nanCount() are those of frame()
    void stageChanged();
    void pixelChanged();
    void selectionChanged();
    void hoverChanged();
    void channelChanged();
    void pointedChanged();
    void hiddenChanged();
    void busyChanged(bool busy);                  // a frame is being computed
    void failed(const pipeline::Errors& errors);  // a change that cannot be, or a file that could not be read
    void notWritten(const QString& file, const pipeline::Errors& errors);
    void outOfMemory();                  // a frame is not computed: frame() is the one before, until something changes
    void said(const QString& sentence);  // for the status bar

private:
    friend class SceneStep;
    const SceneStep* newestChange() const;
    void showStage(pipeline::StageId stage);
    void showFrame(const pipeline::FramePtr& frame);
    void setSceneValue(std::shared_ptr<const pipeline::Scene> scene);
    void requestFrameSoon();
    void requestFrame();
    bool waits();  // for the views, or the frame before
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
    bool m_restores = false;  // steps of undo: they change nothing
    WorkList m_work;
    pipeline::FramePtr m_frame, m_whole;
    Stepper m_stepper;
    pipeline::StageId m_stage = pipeline::StageId::Shading;
    std::optional<glm::ivec2> m_pixel, m_hovered;
    std::optional<lessons::Selection> m_selection;
    int m_channel = 2;
    QString m_pointed;
    FrameCheck m_check;
    bool m_checked = false;
    struct Want {
        pipeline::BufferSet buffers;
        When when = When::Always;
    };
    std::map<const QObject*, Want> m_wanted;
    QTimer m_moving;  // runs from a live change until some time after the last one
    std::set<const QObject*> m_holding;
    bool m_paced = false;          // one of those was behind in this drag: frames are asked for one by one
    QTimer m_held;                 // a request that waits
    QElapsedTimer m_sinceRequest;  // the newest one
    QUndoStack m_undo;

    // Frames: what was asked for last, and what came.
    bool m_requestPending = false;  // requestFrame runs when control returns to the event loop
    bool m_busy = false;
    long m_ticket = 0, m_taken = 0;  // of the newest request; of m_whole
    long m_oldestValid = 0;          // older tickets are frames of a scene closed since, or given up
    pipeline::BufferSet m_requested;
    std::shared_ptr<const pipeline::Scene> m_requestedScene;

    // A drag: Live changes of one setting, one step of undo.
    void setLive(bool live);
    bool m_live = false;
    int m_drag = 0;
    std::optional<pipeline::SettingRef> m_dragged;  // nothing: what m_edited names
    QString m_edited;

    std::unique_ptr<FrameWorker> m_worker;
    std::unique_ptr<MixModel> m_mixer;
    std::unique_ptr<DerivedBuffers> m_derived;
    std::unique_ptr<PixelInspection> m_inspection;
};

}  // namespace app
