#include "app/core/document.h"

#include <algorithm>
#include <cmath>

#include <QFileInfo>

#include "app/core/derived_buffers.h"
#include "app/core/freed_aside.h"
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

using pipeline::BufferSet;
using pipeline::FramePtr;
using pipeline::Scene;
using pipeline::SettingRef;
using pipeline::StageId;

Document::Document(QObject* parent) : QObject(parent) {
    // The worker calls on its own thread; the calls below run later, in the thread of this object,
    // and are dropped by Qt when the document is gone by then.
    m_worker = std::make_unique<FrameWorker>(
        [this](FramePtr frame, long ticket) {
            QMetaObject::invokeMethod(
                this, [this, frame = freedAside(std::move(frame)), ticket] { takeFrame(frame, ticket); },
                Qt::QueuedConnection);
        },
        [this](FramePtr frame, const FrameCheck& check) {
            QMetaObject::invokeMethod(
                this, [this, frame = std::move(frame), check] { takeCheck(frame, check); }, Qt::QueuedConnection);
        },
        [this](long ticket) {
            QMetaObject::invokeMethod(
                this, [this, ticket] { takeFailure(ticket); }, Qt::QueuedConnection);
        });
    observeWork();
    m_mixer = std::make_unique<MixModel>(*this);
    m_derived = std::make_unique<DerivedBuffers>(*this);
    m_inspection = std::make_unique<PixelInspection>(*this);
    m_renderer = std::make_unique<RendererCheck>(*this);
    constexpr int kRestMilliseconds = 200;
    m_moving.setSingleShot(true);
    m_moving.setInterval(kRestMilliseconds);
    connect(&m_moving, &QTimer::timeout, this, &Document::requestFrameSoon);
    m_held.setSingleShot(true);
    connect(&m_held, &QTimer::timeout, this, &Document::requestFrame);
    connect(&m_stepper, &Stepper::stageReached, this, &Document::showStage);
    connect(&m_stepper, &Stepper::shown, this, &Document::showFrame);
    connect(&m_stepper, &Stepper::left, this, [this] { showFrame(m_whole); });
}

Document::~Document() {
    m_worker.reset();
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
    setLive(false);
    m_scene = std::move(opened);
    // A picked pixel, polygon numbers and errors of the other scene mean nothing here.
    m_frame.reset();
    m_whole.reset();
    m_stepper.setWhole(nullptr);
    forgetCheck();
    m_pointing.reset(m_scene);
    m_oldestValid = m_ticket + 1;
    m_work.forgetStopped();
    emit sceneOpened();
    emit keptChanged();
    m_pointing.tellReset();
    emit sceneChanged();
    emit said(tr("%1 is open.").arg(QString::fromStdString(m_scene->name)));
    requestFrameSoon();
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
    const bool sameDrag = m_live && m_dragged == ref;
    if (!sameDrag) ++m_drag;
    const bool closesDrag = sameDrag && kind == Change::Done;
    setLive(kind == Change::Live);
    m_dragged = ref;
    if (*after != *m_scene) {
        m_undo.push(new SceneStep(*this, m_scene, std::move(after), ref, m_drag));
    } else if (closesDrag) {
        requestFrameSoon();
    }
}

void Document::edit(Scene scene, const QString& text, Change kind) {
    if (const auto errors = checkSceneAndMemory(scene); !errors.empty()) {
        emit failed(errors);
        return;
    }
    const bool sameDrag = m_live && !m_dragged && m_edited == text;
    if (!sameDrag) ++m_drag;
    setLive(kind == Change::Live);
    m_dragged.reset();
    m_edited = text;
    if (scene != *m_scene)
        m_undo.push(new SceneStep(*this, m_scene, std::make_shared<const Scene>(std::move(scene)), text, m_drag));
    else if (sameDrag && kind == Change::Done)
        requestFrameSoon();
}

void Document::setLive(bool live) {
    m_live = live;
    if (live)
        m_moving.start();
    else
        m_moving.stop();
    if (live) return;
    if (m_requestPending) m_held.start(0);
}

void Document::replace(Scene scene, const QString& text) { replace(std::move(scene), text, {}); }

void Document::replace(Scene scene, const QString& text, Looks looks) {
    if (const auto errors = checkSceneAndMemory(scene); !errors.empty()) {
        emit failed(errors);
        return;
    }
    setLive(false);
    const bool isOther = scene != *m_scene;
    if (!isOther && !looks.before) return;
    const auto after = isOther ? std::make_shared<const Scene>(std::move(scene)) : m_scene;
    m_undo.push(new SceneStep(*this, m_scene, after, text, std::move(looks)));
}

void Document::setSceneValue(std::shared_ptr<const Scene> scene) {
    m_scene = std::move(scene);
    m_pointing.setScene(m_scene);
    emit sceneChanged();
    requestFrameSoon();
}

void Document::setStage(StageId stage) {
    m_stepper.leave();
    showStage(stage);
}

void Document::showFrame(const FramePtr& frame) {
    m_frame = frame;
    if (m_frame) emit frameReady();
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

void Document::want(const QObject* who, BufferSet buffers, When when) {
    const auto [entry, isNew] = m_wanted.try_emplace(who);
    if (isNew) {
        connect(who, &QObject::destroyed, this, [this, who] {
            m_wanted.erase(who);
            hold(who, false);
        });
    }
    entry->second = {buffers, when};
    requestFrameSoon();
}

void Document::hold(const QObject* who, bool holds) {
    if (holds && m_wanted.contains(who))
        m_holding.insert(who);
    else
        m_holding.erase(who);
    if (m_holding.empty() && m_held.isActive()) m_held.start(0);
}

bool Document::waits() {
    constexpr qint64 kLongest = 1000 / 60;  // milliseconds
    if (!m_live) return false;
    if (m_ticket > m_taken) return true;
    if (m_holding.empty() || m_sinceRequest.hasExpired(kLongest)) return false;
    m_held.start(int(kLongest - m_sinceRequest.elapsed()));
    return true;
}

BufferSet Document::wanted() const {
    // The picture itself, whatever is on show, and what the check of a frame compares.
    BufferSet all = pipeline::setOf({pipeline::BufferId::Color, pipeline::BufferId::Intensity});
    for (const auto& [who, want] : m_wanted)
        if (want.when == When::Always || !m_moving.isActive()) all |= want.buffers;
    return all;
}

// Several intents in one turn of the event loop ask for one frame.
void Document::requestFrameSoon() {
    if (m_requestPending || !hasScene()) return;
    m_requestPending = true;
    setBusy(true);
    QMetaObject::invokeMethod(
        this, [this] { requestFrame(); }, Qt::QueuedConnection);
}

void Document::requestFrame() {
    if (waits()) return;
    m_held.stop();
    m_requestPending = false;
    const BufferSet all = wanted();
    // What the newest request covers needs no other frame; buffers that nobody shows any more stay.
    const bool covered = m_requestedScene == m_scene && (all & ~m_requested).none();
    if (covered) {
        setBusy(m_ticket > m_taken);
        return;
    }
    setBusy(true);
    m_work.setBusy(this, true);
    m_requested = all;
    m_requestedScene = m_scene;
    m_sinceRequest.start();
    m_ticket = m_worker->request(m_scene, {.wanted = all, .stop = {}},
                                 m_live ? FrameWorker::Running::Finish : FrameWorker::Running::Stop);
}

void Document::takeFrame(FramePtr frame, long ticket) {
    if (ticket < m_oldestValid) return;
    // Buffers that a panel has asked for are no news.
    const bool isNews = !m_whole || m_whole->sharedScene() != frame->sharedScene();
    m_whole = std::move(frame);
    m_taken = ticket;
    forgetCheck();
    if (m_live && m_requestPending) requestFrame();  // computed while the views take this one up
    if (ticket == m_ticket && !m_requestPending) setBusy(false);
    m_stepper.setWhole(m_whole);
    if (!m_stepper.isInside()) showFrame(m_whole);  // else its state comes from the stepper
    if (isNews && m_hidden.count() == 0) emit said(frameSentence(*m_whole));
}

void Document::takeCheck(const FramePtr& frame, const FrameCheck& check) {
    if (frame != m_whole) return;
    m_check = check;
    m_checked = true;
    emit errorsReady();
}

void Document::forgetCheck() {
    m_check = {};
    m_checked = false;
}

void Document::setBusy(bool busy) {
    if (busy == m_busy) return;
    m_busy = busy;
    if (!busy) m_work.setBusy(this, false);
    emit busyChanged(busy);
}

}  // namespace app
