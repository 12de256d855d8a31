#include "app/core/application.h"

#include <new>

#include "app/core/memory_notice.h"

namespace app {

bool Application::notify(QObject* receiver, QEvent* event) {
    try {
        return QApplication::notify(receiver, event);
    } catch (const std::bad_alloc&) {
        emit MemoryNotice::instance().gaveUp();
        return true;
    }
}

}  // namespace app
