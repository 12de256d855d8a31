#pragma once
#include <QObject>
#include <thread>
#include <utility>

#include "app/core/window_look.h"

namespace app {

// One piece of work on a thread of its own, which sees the window's look as it was at the start. The end of this object cancels what still runs, and waits.
class ThreadJob : public QObject {
public:
    using QObject::QObject;
    void cancel() { m_thread.request_stop(); }

protected:
    template <class Work>
    void start(Work work) {
        m_thread = std::jthread([work = std::move(work), look = WindowLook()](const std::stop_token& stop) {
            const WornLook worn(look);
            work(stop);
        });
    }
    // From the work: a call in this object's own thread, and none once it is gone.
    template <class Call>
    void later(Call call) {
        QMetaObject::invokeMethod(this, std::move(call), Qt::QueuedConnection);
    }

private:
    std::jthread m_thread;
};

}  // namespace app
