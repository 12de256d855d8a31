#include "app/core/freed_aside.h"

#include <QCoreApplication>
#include <QThread>
#include <QThreadPool>

namespace app {

void freeAside(std::shared_ptr<const void> held) {
    const QCoreApplication* window = QCoreApplication::instance();
    if (!window || QThread::currentThread() != window->thread()) return;  // at the end of this call
    QThreadPool::globalInstance()->start([held = std::move(held)] {});
}

}  // namespace app
