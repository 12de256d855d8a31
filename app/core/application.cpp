#include "app/core/application.h"

#include <new>

#include "app/core/memory_notice.h"

namespace app {

bool Application::notify(QObject* receiver, QEvent* event) {
    try {
        return QApplication::notify(receiver, event);
    } catch (const std::bad_alloc&) {
        event->ignore();  // above all of a window that was to be closed and could not be saved first
        try {
            emit MemoryNotice::instance().gaveUp();
        } catch (const std::bad_alloc&) {  // not even for that: it is left unsaid
        }
        return true;
    }
}

}  // namespace app
