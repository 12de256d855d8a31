#include "app/jobs/background_job.h"

#include <QCoreApplication>
#include <QScopeGuard>
#include <atomic>

#include "app/jobs/memory_notice.h"
#include "app/look/window_look.h"

namespace app {

BackgroundJob::BackgroundJob(QObject* parent) : QObject(parent) {}
BackgroundJob::~BackgroundJob() = default;

void BackgroundJob::start(std::function<std::function<void()>(const Control&)> job, Running running) {
    if (!m_worker) m_worker = std::make_unique<LatestWorker>();
    const bool wasBusy = busy();
    if (running == Running::Stop) m_oldestValid = m_ticket + 1;
    const long ticket = ++m_ticket;
    // What is invoked runs later, in the thread of this object, and is dropped by Qt when the object is gone by then.
    // Several threads of one job may tell of it.
    const auto progress = [this, ticket, most = std::make_shared<std::atomic<int>>(0)](double share) {
        const int percent = int(100 * share);
        int before = *most;
        while (before < percent && !most->compare_exchange_weak(before, percent)) continue;
        if (before >= percent) return;
        QMetaObject::invokeMethod(
            this,
            [this, ticket, share] {
                if (ticket >= m_oldestValid) emit progressed(share);
            },
            Qt::QueuedConnection);
    };
    m_worker->ask(
        [this, ticket, job = std::move(job), progress, look = WindowLook()](const std::stop_token& stop) {
            const WornLook worn(look);
            std::function<void()> done;
            try {
                done = job({stop, progress});
            } catch (const std::bad_alloc&) {
                done = [] { emit MemoryNotice::instance().gaveUp(); };
            }
            if (stop.stop_requested()) return;
            QMetaObject::invokeMethod(
                this, [this, ticket, done] { take(ticket, done); }, Qt::QueuedConnection);
            {
                const std::lock_guard lock(m_mutex);
                m_posted = ticket;
            }
            m_finished.notify_one();
        },
        running);
    if (!wasBusy) emit busyChanged(true);
}

void BackgroundJob::take(long ticket, const std::function<void()>& done) {
    if (ticket < m_oldestValid) return;
    m_taken = ticket;
    const auto ended = qScopeGuard([this] {  // also where the result needs more memory than there is
        if (!busy()) emit busyChanged(false);
    });
    done();
}

bool BackgroundJob::waitFor(std::chrono::milliseconds longest) {
    {
        std::unique_lock lock(m_mutex);
        if (!m_finished.wait_for(lock, longest, [this] { return m_posted >= m_ticket || !busy(); })) return false;
    }
    QCoreApplication::sendPostedEvents(this, QEvent::MetaCall);
    return true;
}

void BackgroundJob::forget() {
    m_oldestValid = m_ticket + 1;
    const bool wasBusy = busy();
    m_taken = m_ticket;
    if (m_worker) m_worker->forget();
    if (wasBusy) emit busyChanged(false);
}

}  // namespace app
