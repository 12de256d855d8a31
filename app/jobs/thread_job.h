#pragma once
#include <QObject>
#include <thread>
#include <utility>

#include "app/look/window_look.h"

namespace app {

// One piece of work on a thread of its own. It sees the window's look as it was at the start. Deleting this object
// stops the work and joins.
class ThreadJob : public QObject {
public:
    using QObject::QObject;
    void cancel() { m_thread.request_stop(); }

protected:
    // work(stop, later): later(call) runs the call in this object's own thread, or not at all if the object is gone.
    // Work must not use this object otherwise, because it may outlive it.
    template <class Work>
    void start(Work work) {
        QObject* const home = this;
        m_thread = std::jthread([home, work = std::move(work), look = WindowLook()](const std::stop_token& stop) {
            const WornLook worn(look);
            work(stop, [home](auto call) { QMetaObject::invokeMethod(home, std::move(call), Qt::QueuedConnection); });
        });
    }

private:
    std::jthread m_thread;
};

}  // namespace app
