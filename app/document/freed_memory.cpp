#include "app/document/freed_memory.h"

#include <QThreadPool>

#include "app/document/document.h"
#include "pipeline/core/memory.h"

namespace app {

FreedMemory::FreedMemory(Document& document, QObject* parent) : QObject(parent) {
    constexpr int kIdleMilliseconds = 500;  // the views begin after the frame, and free what they showed before
    m_rest.setSingleShot(true);
    m_rest.setInterval(kIdleMilliseconds);
    connect(&document, &Document::sceneOpened, this, [this] { m_due = true; });
    connect(&document.frames(), &FrameFeed::busyChanged, this,
            [this](bool busy) { busy || !m_due ? m_rest.stop() : m_rest.start(); });
    connect(&m_rest, &QTimer::timeout, this, &FreedMemory::giveBack);
}

void FreedMemory::giveBack() {
    m_due = false;
    // After what has been put aside to be freed there.
    QThreadPool::globalInstance()->start([] { pipeline::giveBackFreedMemory(); }, -1);
    emit givenBack();
}

}  // namespace app
