#include "app/document/document.h"

#include <algorithm>
#include <cmath>

#include <QFileInfo>

#include "app/document/hand.h"
#include "app/document/renderer_check.h"
#include "app/frames/derived_buffers.h"
#include "app/frames/mix_model.h"
#include "app/frames/pixel_inspection.h"
#include "app/frames/stage_status.h"
#include "app/jobs/write_file.h"
#include "app/look/shown_name.h"
#include "app/look/text.h"
#include "pipeline/core/text.h"
#include "pipeline/formats/toml/toml_writer.h"
#include "pipeline/plan/memory_limit.h"

namespace app {

using pipeline::Scene;
using pipeline::SettingRef;
using pipeline::StageId;

Document::Document(QObject* parent) : QObject(parent) {
    m_mixer = std::make_unique<MixModel>();
    m_derived = std::make_unique<DerivedBuffers>(m_frames, *m_mixer);
    m_inspection = std::make_unique<PixelInspection>(m_frames, m_pointing, m_work);
    m_renderer = std::make_unique<RendererCheck>(m_work);
    m_hand = std::make_unique<Hand>(*this);
    connect(this, &Document::sceneOpened, this, [this] {
        m_mixer->begin(m_scene);
        m_derived->begin(m_scene);
        m_renderer->begin(m_scene);
    });
    connect(this, &Document::sceneChanged, this, [this] {
        m_mixer->setScene(m_scene);
        m_derived->setScene(m_scene);
        m_renderer->setScene(m_scene);
    });
    connect(&m_history, &SceneHistory::stepped, this, &Document::showScene);
    connect(&m_stepper, &Stepper::stageReached, this, &Document::showStage);
    connect(&m_frames, &FrameFeed::stateReady, this, [this] {
        if (m_hidden.count() == 0) emit said(frameSentence(*m_frames.whole()));
    });
}

Document::~Document() = default;

void Document::setHidden(lessons::Hidden hidden) {
    m_hidden = std::move(hidden);
    emit hiddenChanged();
}

void Document::open(const OpenedScene& opened) {
    setScene(opened.scene, opened.kept);
    if (opened.stage) setStage(*opened.stage);
}

bool Document::reload(const OpenedScene& again) {
    const auto keys = [](const Scene& scene) {
        std::vector<std::string> all;
        for (const SettingRef& setting : settingsOf(scene)) all.push_back(setting.key());
        return all;
    };
    if (keys(again.scene) != keys(*m_scene)) return false;
    m_kept = again.kept;
    replace(again.scene, tr("reading %1 again").arg(shownName(m_kept.file)));
    m_history.stack()->setClean();
    emit keptChanged();
    return true;
}

bool Document::save(const QString& file) {
    const auto text = toTomlScene(*m_scene);
    if (const auto errors = text ? writeFile(file, *text) : text.errors(); !errors.empty()) {
        emit notWritten(file, errors);
        return false;
    }
    m_kept = {QFileInfo(file).absoluteFilePath(), m_scene};
    m_history.stack()->setClean();
    emit keptChanged();
    emit said(tr("The scene is saved as %1.").arg(shownName(file)));
    return true;
}

void Document::setScene(Scene scene, KeptScene kept) {
    // First: without memory for it the scene before stays as it is.
    auto opened = std::make_shared<const Scene>(std::move(scene));
    m_history.clear();
    m_kept = std::move(kept);
    endDrag();
    m_scene = std::move(opened);
    // A picked pixel, polygon numbers and errors of the other scene mean nothing here.
    m_frames.reset(m_scene);
    m_pointing.reset(m_scene);
    m_work.forgetStopped();
    emit sceneOpened();
    emit keptChanged();
    m_pointing.tellReset();
    emit sceneChanged();
    emit said(tr("%1 is open.").arg(QString::fromStdString(m_scene->name)));
    m_frames.requestSoon();
}

void Document::change(const SettingRef& ref, double value, Change kind) {
    const pipeline::Setting& setting = *ref.setting;
    if (setting.kind != pipeline::SettingKind::Number) value = std::round(value);
    if (!(value >= setting.min && value <= setting.max)) {  // NaN is refused too
        emit failed({{{},
                      std::string(setting.label) + " is " + pipeline::shortestText(value),
                      "a number from " + formatSetting(ref, setting.min) + " to " + formatSetting(ref, setting.max)}});
        return;
    }
    if (!isIn(*m_scene, ref)) return;  // of what has gone since
    auto after = std::make_shared<Scene>(*m_scene);
    ref.set(*after, value);
    if (const auto errors = checkSceneAndMemory(*after); !errors.empty()) {
        emit failed(errors);
        return;
    }
    const bool goesOn = m_history.drag(ref, kind == Change::Live);
    m_frames.setLive(kind == Change::Live);
    if (*after != *m_scene)
        m_history.pushDragged(m_scene, std::move(after));
    else if (goesOn && kind == Change::Done)
        m_frames.requestSoon();
}

void Document::edit(Scene scene, const QString& text, Change kind) {
    if (const auto errors = checkSceneAndMemory(scene); !errors.empty()) {
        emit failed(errors);
        return;
    }
    const bool goesOn = m_history.drag(text, kind == Change::Live);
    m_frames.setLive(kind == Change::Live);
    if (scene != *m_scene)
        m_history.pushDragged(m_scene, std::make_shared<const Scene>(std::move(scene)));
    else if (goesOn && kind == Change::Done)
        m_frames.requestSoon();
}

void Document::replace(Scene scene, const QString& text, StepLooks looks) {
    if (const auto errors = checkSceneAndMemory(scene); !errors.empty()) {
        emit failed(errors);
        return;
    }
    endDrag();
    const bool isOther = scene != *m_scene;
    if (!isOther && !looks.before) return;
    const auto after = isOther ? std::make_shared<const Scene>(std::move(scene)) : m_scene;
    m_history.push(m_scene, after, text, std::move(looks));
}

void Document::endDrag() {
    m_history.endDrag();
    m_frames.setLive(false);
}

void Document::showState(Scene scene) {
    m_history.clear();
    endDrag();
    if (scene != *m_scene) showScene(std::make_shared<const Scene>(std::move(scene)));
}

void Document::showScene(const ScenePtr& scene) {
    m_scene = scene;
    m_pointing.setScene(m_scene);
    emit sceneChanged();
    m_frames.setScene(m_scene);
}

void Document::setStage(StageId stage) {
    m_stepper.leave();
    showStage(stage);
}

void Document::showStage(StageId stage) {
    if (stage == m_stage) return;
    m_stage = stage;
    m_stepper.setStage(stage);
    emit stageChanged();
    const pipeline::FramePtr& frame = m_frames.whole();
    const pipeline::PlanStep* plan = frame ? &frame->plan()[index(stage)] : nullptr;
    // A question may ask for the reason.
    const bool tellsWhy = plan && plan->action == pipeline::Action::LeaveOut && m_hidden.count() == 0;
    const QString label = toQString(stageInfo(stage).label);
    emit said(tellsWhy ? tr("%1, left out: %2").arg(label, toQString(plan->why))
                       : tr("%1: %2").arg(label, toQString(stageInfo(stage).summary)));
}

// Every view shows the moment. After the last stage that is the whole frame.
static void goToEndOf(StageId stage, Stepper& stepper) {
    stage == StageId::Shading ? stepper.toLast() : stepper.goTo(pipeline::Place{stage});
}

void Document::nextStage() {
    goToEndOf(pipeline::kStages[std::min(index(m_stage) + 1, pipeline::kStageCount - 1)], m_stepper);
}

void Document::previousStage() {
    if (index(m_stage) > 0) goToEndOf(pipeline::kStages[index(m_stage) - 1], m_stepper);
}

}  // namespace app
