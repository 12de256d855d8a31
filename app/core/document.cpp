#include "app/core/document.h"

#include <algorithm>
#include <cmath>

#include <QFileInfo>

#include "app/core/derived_buffers.h"
#include "app/core/mix_model.h"
#include "app/core/pixel_inspection.h"
#include "app/core/renderer_check.h"
#include "app/core/scene_step.h"
#include "app/core/shown_name.h"
#include "app/core/stage_status.h"
#include "app/core/write_file.h"
#include "pipeline/core/text.h"
#include "pipeline/formats/toml_writer.h"
#include "pipeline/plan/memory_limit.h"

namespace app {

using pipeline::Scene;
using pipeline::SettingRef;
using pipeline::StageId;

Document::Document(QObject* parent) : QObject(parent) {
    m_mixer = std::make_unique<MixModel>(*this);
    m_derived = std::make_unique<DerivedBuffers>(*this);
    m_inspection = std::make_unique<PixelInspection>(*this);
    m_renderer = std::make_unique<RendererCheck>(*this);
    connect(&m_stepper, &Stepper::stageReached, this, &Document::showStage);
    connect(&m_frames, &FrameFeed::stateReady, this, [this] {
        if (m_hidden.count() == 0) emit said(frameSentence(*m_frames.whole()));
    });
}

Document::~Document() {
    m_renderer.reset();
    m_inspection.reset();
    m_derived.reset();
    m_mixer.reset();
    m_undo.disconnect();  // clearing itself, it would tell observers that may be gone
}

// Steps of undo that change what is on show alone are none of the scene's.
const SceneStep* Document::newestChange() const {
    for (int i = m_undo.index() - 1; i >= 0; --i)
        if (const auto* step = static_cast<const SceneStep*>(m_undo.command(i)); step->changesScene()) return step;
    return nullptr;
}

std::optional<SettingChange> Document::lastChange() const {
    const SceneStep* step = newestChange();
    return step ? step->change() : std::nullopt;
}

std::shared_ptr<const Scene> Document::sceneBefore() const {
    const SceneStep* step = newestChange();
    return step ? step->before() : nullptr;
}

bool Document::isEdited() const {
    const int clean = m_undo.cleanIndex(), now = m_undo.index();
    if (clean < 0) return true;  // no undo leads there
    for (int i = std::min(clean, now); i < std::max(clean, now); ++i)
        if (static_cast<const SceneStep*>(m_undo.command(i))->changesScene()) return true;
    return false;
}

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
    m_undo.setClean();
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
    m_undo.setClean();
    emit keptChanged();
    emit said(tr("The scene is saved as %1.").arg(shownName(file)));
    return true;
}

void Document::setScene(Scene scene, KeptScene kept) {
    // First: without memory for it the scene before stays as it is.
    auto opened = std::make_shared<const Scene>(std::move(scene));
    m_undo.clear();
    m_kept = std::move(kept);
    m_frames.setLive(false);
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
    const bool sameDrag = m_frames.isLive() && m_dragged == ref;
    if (!sameDrag) ++m_drag;
    const bool closesDrag = sameDrag && kind == Change::Done;
    m_frames.setLive(kind == Change::Live);
    m_dragged = ref;
    if (*after != *m_scene) {
        m_undo.push(new SceneStep(*this, m_scene, std::move(after), ref, m_drag));
    } else if (closesDrag) {
        m_frames.requestSoon();
    }
}

void Document::edit(Scene scene, const QString& text, Change kind) {
    if (const auto errors = checkSceneAndMemory(scene); !errors.empty()) {
        emit failed(errors);
        return;
    }
    const bool sameDrag = m_frames.isLive() && !m_dragged && m_edited == text;
    if (!sameDrag) ++m_drag;
    m_frames.setLive(kind == Change::Live);
    m_dragged.reset();
    m_edited = text;
    if (scene != *m_scene)
        m_undo.push(new SceneStep(*this, m_scene, std::make_shared<const Scene>(std::move(scene)), text, m_drag));
    else if (sameDrag && kind == Change::Done)
        m_frames.requestSoon();
}

void Document::replace(Scene scene, const QString& text) { replace(std::move(scene), text, {}); }

void Document::replace(Scene scene, const QString& text, Looks looks) {
    if (const auto errors = checkSceneAndMemory(scene); !errors.empty()) {
        emit failed(errors);
        return;
    }
    m_frames.setLive(false);
    const bool isOther = scene != *m_scene;
    if (!isOther && !looks.before) return;
    const auto after = isOther ? std::make_shared<const Scene>(std::move(scene)) : m_scene;
    m_undo.push(new SceneStep(*this, m_scene, after, text, std::move(looks)));
}

void Document::setSceneValue(std::shared_ptr<const Scene> scene) {
    m_scene = std::move(scene);
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
    emit said(
        QString::fromStdString(std::string(stageInfo(stage).label) + ": " + std::string(stageInfo(stage).summary)));
}

void Document::nextStage() {
    if (index(m_stage) + 1 < pipeline::kStageCount) setStage(pipeline::kStages[index(m_stage) + 1]);
}

void Document::previousStage() {
    if (index(m_stage) > 0) setStage(pipeline::kStages[index(m_stage) - 1]);
}

}  // namespace app
