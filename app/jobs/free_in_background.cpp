#include "app/jobs/free_in_background.h"

#include <QCoreApplication>
#include <QThread>
#include <QThreadPool>

namespace app {

void freeInBackground(std::shared_ptr<const void> held) {
    const QCoreApplication* window = QCoreApplication::instance();
    if (!window || QThread::currentThread() != window->thread()) return;  // at the end of this call
    QThreadPool::globalInstance()->start([held = std::move(held)] {});
}

}  // namespace app
