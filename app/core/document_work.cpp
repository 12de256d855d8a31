// What a Document lets run that may be given up and gone on with.
#include "app/core/document.h"

namespace app {

void Document::observeWork() {
    m_work.add(
        this, tr("the frame"), [this] { cancelFrame(); },
        [this] {
            m_requestedScene.reset();
            requestFrameSoon();
        });
    m_work.add(
        &m_stepper, tr("the steps"), [this] { m_stepper.cancel(); }, [this] { m_stepper.resume(); });
    connect(&m_stepper, &Stepper::busyChanged, this, [this](bool busy) { m_work.setBusy(&m_stepper, busy); });
}

void Document::cancelFrame() {
    m_worker->cancel();
    // What is wanted at rest has had its request too, and so has what waits for the frame.
    m_moving.stop();
    m_requested = wanted();
    m_requestedScene = m_scene;
    m_oldestValid = m_ticket + 1;
    m_taken = m_ticket;
    if (m_requestPending) m_held.start(0);
    setBusy(false);
}

// The same request would fail again: it counts as answered, so that none is made until something changes.
void Document::takeFailure(long ticket) {
    if (ticket < m_oldestValid || ticket != m_ticket) return;  // of a newer one is told
    m_taken = ticket;
    if (m_requestPending)
        m_held.start(0);
    else
        setBusy(false);
    emit outOfMemory();
}

}  // namespace app
