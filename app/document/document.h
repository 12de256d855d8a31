#pragma once
#include <QObject>
#include <QString>
#include <memory>

#include "app/document/opened_scene.h"
#include "app/document/scene_history.h"
#include "app/frames/frame_feed.h"
#include "app/frames/pointing.h"
#include "app/frames/stepper.h"
#include "app/jobs/work_list.h"
#include "lessons/questions/hidden.h"
#include "pipeline/core/result.h"

namespace app {

class DerivedBuffers;
class Hand;
class MixModel;
class PixelInspection;
class RendererCheck;

// The scene and its undo, the current stage, and what follows the scene: its frames and where the user points in it.
// Lives in the GUI thread. Panels observe it and send it intents. They never call a stage and never know another panel.
class Document : public QObject {
    Q_OBJECT
public:
    explicit Document(QObject* parent = nullptr);
    ~Document() override;

    bool hasScene() const { return m_scene != nullptr; }
    const pipeline::Scene& scene() const { return *m_scene; }  // only if hasScene()
    const ScenePtr& sharedScene() const { return m_scene; }
    SceneHistory& history() { return m_history; }
    const SceneHistory& history() const { return m_history; }
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
    DerivedBuffers& derived() { return *m_derived; }
    const DerivedBuffers& derived() const { return *m_derived; }
    const MixModel& mixer() const { return *m_mixer; }
    MixModel& mixer() { return *m_mixer; }             // the mix of the terms in the pictures
    RendererCheck& renderer() { return *m_renderer; }  // another renderer, compared with this scene
    const RendererCheck& renderer() const { return *m_renderer; }

    Hand& hand() { return *m_hand; }  // what a page of a lesson lets the user move in the pictures

    // What must stay hidden on a page of a lesson until its question is settled. Everything that shows a buffer or is a
    // part of the window asks here.
    const lessons::Hidden& hidden() const { return m_hidden; }
    void setHidden(lessons::Hidden hidden);

    const KeptScene& kept() const { return m_kept; }
    // Whether closing would lose changes to a file.
    bool isChanged() const { return m_kept.scene && m_history.isEdited(); }

    // A picture with a scene opens at the stage of the picture's buffer.
    void open(const OpenedScene& opened);
    // Reloads the file as one step of undo. Returns false and changes nothing if the scene in it has other settings.
    bool reload(const OpenedScene& again);
    // Writes the scene with its settings as TOML, whole or not at all. If that fails, notWritten() gives the reason.
    bool save(const QString& file);
    void setScene(pipeline::Scene scene, KeptScene kept = {});  // as if opened: clears the undo stack

    // Shows another state of the scene that is not a change of it; clears the undo stack.
    void showState(pipeline::Scene scene);

    // Changes one setting. While a slider is dragged, use Live for every step, then Done; the whole drag is one step of
    // undo. Values out of range and scenes that checkScene refuses change nothing; failed() reports them.
    enum class Change { Live, Done };
    void change(const pipeline::SettingRef& setting, double value, Change kind = Change::Done);
    // Changes several numbers at once: the Live edits with the same `text` up to Done are one step of undo with that
    // name. If the last edit restores the first scene, there is no step.
    void edit(pipeline::Scene scene, const QString& text, Change kind);
    // Replaces the scene in one step of undo, named by `text`. With `looks` an unchanged scene is a step too.
    void replace(pipeline::Scene scene, const QString& text, StepLooks looks = {});

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
    void showStage(pipeline::StageId stage);
    void showScene(const ScenePtr& scene);
    void endDrag();

    ScenePtr m_scene;
    SceneHistory m_history;
    KeptScene m_kept;
    lessons::Hidden m_hidden;
    WorkList m_work;
    Stepper m_stepper;
    FrameFeed m_frames{m_stepper, m_work};
    pipeline::StageId m_stage = pipeline::StageId::Shading;
    Pointing m_pointing;
    std::unique_ptr<MixModel> m_mixer;
    std::unique_ptr<DerivedBuffers> m_derived;
    std::unique_ptr<PixelInspection> m_inspection;
    std::unique_ptr<RendererCheck> m_renderer;
    std::unique_ptr<Hand> m_hand;
};

}  // namespace app
