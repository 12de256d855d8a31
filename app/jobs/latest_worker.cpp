#include "app/jobs/latest_worker.h"

namespace app {

LatestWorker::LatestWorker() : m_thread([this](const std::stop_token& quit) { loop(quit); }) {}

LatestWorker::~LatestWorker() {
    m_thread.request_stop();
    forget();
    m_thread.join();
}

void LatestWorker::ask(Work work, Running running) {
    {
        const std::lock_guard lock(m_mutex);
        m_next = std::move(work);
        if (running == Running::Stop) m_stop.request_stop();
    }
    m_arrived.notify_one();
}

void LatestWorker::forget() {
    const std::lock_guard lock(m_mutex);
    m_next.reset();
    m_stop.request_stop();
}

bool LatestWorker::hasWaiting() {
    const std::lock_guard lock(m_mutex);
    return m_next.has_value();
}

void LatestWorker::loop(const std::stop_token& quit) {
    while (!quit.stop_requested()) {
        Work work;
        std::stop_token stop;
        {
            std::unique_lock lock(m_mutex);
            if (!m_arrived.wait(lock, quit, [this] { return m_next.has_value(); })) return;
            work = std::move(*m_next);
            m_next.reset();
            // Fresh under the lock: a request from here on stops this work, one that came before is this work.
            // Quitting may have been asked for in between.
            m_stop = std::stop_source();
            if (quit.stop_requested()) return;
            stop = m_stop.get_token();
        }
        work(stop);
    }
}

}  // namespace app
