#include "app/frames/frame_feed.h"

#include "app/frames/frame_worker.h"
#include "app/frames/stepper.h"
#include "app/jobs/free_in_background.h"
#include "app/jobs/work_list.h"

namespace app {

using pipeline::BufferSet;
using pipeline::FramePtr;

FrameFeed::FrameFeed(Stepper& stepper, WorkList& work, QObject* parent)
    : QObject(parent), m_stepper(stepper), m_work(work) {
    // The worker calls on its own thread; the calls below run later, in the thread of this object,
    // and are dropped by Qt when the feed is gone by then.
    m_worker = std::make_unique<FrameWorker>(
        [this](FramePtr frame, long ticket) {
            QMetaObject::invokeMethod(
                this, [this, frame = freedInBackground(std::move(frame)), ticket] { take(frame, ticket); },
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
    connect(&m_pacing, &FramePacing::rested, this, &FrameFeed::requestSoon);
    connect(&m_pacing, &FramePacing::due, this, &FrameFeed::request);
    connect(&stepper, &Stepper::shown, this, &FrameFeed::show);
    connect(&stepper, &Stepper::left, this, [this] { show(m_whole); });
}

FrameFeed::~FrameFeed() = default;

void FrameFeed::observeWork() {
    m_work.add(
        this, tr("the frame"), [this] { cancel(); },
        [this] {
            m_requested.scene.reset();
            requestSoon();
        });
    m_work.add(
        &m_stepper, tr("the steps"), [this] { m_stepper.cancel(); }, [this] { m_stepper.resume(); });
    connect(&m_stepper, &Stepper::busyChanged, this, [this](bool busy) { m_work.setBusy(&m_stepper, busy); });
}

void FrameFeed::want(const QObject* who, BufferSet buffers, When when) {
    const auto [entry, isNew] = m_wants.try_emplace(who);
    if (isNew) {
        connect(who, &QObject::destroyed, this, [this, who] {
            m_wants.erase(who);
            hold(who, false);
        });
    }
    entry->second = {buffers, when};
    requestSoon();
}

void FrameFeed::hold(const QObject* who, bool holds) { m_pacing.hold(who, holds && m_wants.contains(who)); }

BufferSet FrameFeed::wanted() const {
    // The picture itself, whatever is on show, and what the check of a frame compares.
    BufferSet all = pipeline::setOf({pipeline::BufferId::Color, pipeline::BufferId::Intensity});
    for (const auto& [who, want] : m_wants)
        if (want.when == When::Always || !isMoving()) all |= want.buffers;
    return all;
}

void FrameFeed::reset(ScenePtr scene) {
    m_scene = std::move(scene);
    m_shown.reset();
    m_whole.reset();
    m_stepper.setWhole(nullptr);
    forgetCheck();
    m_tickets.oldestValid = m_tickets.newest + 1;
}

void FrameFeed::setScene(ScenePtr scene) {
    m_scene = std::move(scene);
    requestSoon();
}

void FrameFeed::setLive(bool live) {
    m_pacing.setLive(live);
    if (!live && m_pending) m_pacing.dueNow();
}

// Several intents in one turn of the event loop ask for one frame.
void FrameFeed::requestSoon() {
    if (m_pending || !m_scene) return;
    m_pending = true;
    setBusy(true);
    QMetaObject::invokeMethod(
        this, [this] { request(); }, Qt::QueuedConnection);
}

void FrameFeed::request() {
    if (m_pacing.waits(m_tickets.computes())) return;
    m_pacing.takeTurn();
    m_pending = false;
    const BufferSet all = wanted();
    // What the newest request covers needs no other frame; buffers that nobody shows any more stay.
    if (m_requested.scene == m_scene && (all & ~m_requested.buffers).none()) return setBusy(m_tickets.computes());
    setBusy(true);
    m_work.setBusy(this, true);
    m_requested = {m_scene, all};
    m_pacing.countFromHere();
    m_tickets.newest = m_worker->request(m_scene, {.wanted = all, .stop = {}},
                                         m_pacing.isLive() ? FrameWorker::Running::Finish : FrameWorker::Running::Stop);
}

void FrameFeed::cancel() {
    m_worker->cancel();
    // What is wanted at rest has had its request too, and so has what waits for the frame.
    m_pacing.stopMoving();
    m_requested = {m_scene, wanted()};
    m_tickets.oldestValid = m_tickets.newest + 1;
    m_tickets.taken = m_tickets.newest;
    if (m_pending) m_pacing.dueNow();
    setBusy(false);
}

void FrameFeed::show(const FramePtr& frame) {
    m_shown = frame;
    if (m_shown) emit frameReady();
}

void FrameFeed::take(FramePtr frame, long ticket) {
    if (ticket < m_tickets.oldestValid) return;
    // Buffers that a panel has asked for are no news.
    const bool isNews = !m_whole || m_whole->sharedScene() != frame->sharedScene();
    m_whole = std::move(frame);
    m_tickets.taken = ticket;
    forgetCheck();
    if (m_pacing.isLive() && m_pending) request();  // computed while the views take this one up
    if (ticket == m_tickets.newest && !m_pending) setBusy(false);
    m_stepper.setWhole(m_whole);
    if (!m_stepper.isInside()) show(m_whole);  // else its state comes from the stepper
    if (isNews) emit stateReady();
}

// The same request would fail again: it counts as answered, so that none is made until something changes.
void FrameFeed::takeFailure(long ticket) {
    if (ticket < m_tickets.oldestValid || ticket != m_tickets.newest) return;  // of a newer one is told
    m_tickets.taken = ticket;
    if (m_pending)
        m_pacing.dueNow();
    else
        setBusy(false);
    emit outOfMemory();
}

void FrameFeed::takeCheck(const FramePtr& frame, const FrameCheck& check) {
    if (frame != m_whole) return;
    m_check = check;
    m_checked = true;
    emit errorsReady();
}

void FrameFeed::forgetCheck() {
    m_check = {};
    m_checked = false;
}

void FrameFeed::setBusy(bool busy) {
    if (busy == m_busy) return;
    m_busy = busy;
    if (!busy) m_work.setBusy(this, false);
    emit busyChanged(busy);
}

}  // namespace app
