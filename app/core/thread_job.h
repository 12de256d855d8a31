#pragma once
#include <QObject>
#include <thread>
#include <utility>

#include "app/core/window_look.h"

namespace app {

// One piece of work on a thread of its own, which sees the window's look as it was at the start. The end of this object
// cancels what still runs, and waits.
class ThreadJob : public QObject {
public:
    using QObject::QObject;
    void cancel() { m_thread.request_stop(); }

protected:
    // work(stop, later); later(call) has the call made in this object's own thread, and not at all once it is gone. Work
    // does nothing else with this object, of which it may see the end.
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
