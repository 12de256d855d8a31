#include "app/frames/other_frame.h"

#include <QMetaObject>

#include "app/jobs/free_in_background.h"

namespace app {

OtherFrame::OtherFrame(QObject* parent) : QObject(parent) {}
OtherFrame::~OtherFrame() = default;

void OtherFrame::request(const std::shared_ptr<const pipeline::Scene>& scene, pipeline::BufferSet wanted) {
    if (m_scene && *m_scene == *scene && m_wanted == wanted) return;
    m_scene = scene;
    m_wanted = wanted;
    m_cancelled = false;
    const bool wasBusy = busy();
    if (!m_worker) {
        const auto deliver = [this](pipeline::FramePtr frame, long ticket) {
            QMetaObject::invokeMethod(
                this,
                [this, frame = freedInBackground(std::move(frame)), ticket] {
                    if (ticket < m_oldestValid) return;
                    m_frame = frame;
                    m_taken = ticket;
                    if (!busy()) emit busyChanged(false);
                    emit ready();
                },
                Qt::QueuedConnection);
        };
        // Too little memory: as if it had been stopped by hand.
        const auto fail = [this](long ticket) {
            QMetaObject::invokeMethod(
                this,
                [this, ticket] {
                    if (ticket == m_ticket) cancel();
                },
                Qt::QueuedConnection);
        };
        m_worker = std::make_unique<FrameWorker>(deliver, FrameWorker::DeliverCheck(), fail);
    }
    // A picture a little late is better than none until the hand rests.
    m_ticket =
        m_worker->request(scene, {.wanted = wanted, .until = pipeline::StageId::Shading, .threads = 0, .stop = {}},
                          FrameWorker::Running::Finish);
    if (!wasBusy) emit busyChanged(true);
}

void OtherFrame::forget() {
    m_scene.reset();
    m_frame.reset();
    m_cancelled = false;
    giveUp();
}

void OtherFrame::giveUp() {
    m_oldestValid = m_ticket + 1;
    if (!busy()) return;
    m_worker->cancel();
    m_taken = m_ticket;
    emit busyChanged(false);
}

void OtherFrame::cancel() {
    m_cancelled = m_cancelled || busy();
    giveUp();
}

void OtherFrame::retry() {
    if (m_cancelled) m_scene.reset();
}

}  // namespace app
