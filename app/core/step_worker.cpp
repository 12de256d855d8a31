#include "app/core/step_worker.h"

namespace app {

StepWorker::StepWorker(Deliver deliver)
    : m_deliver(std::move(deliver)), m_thread([this](const std::stop_token& quit) { work(quit); }) {}

StepWorker::~StepWorker() {
    m_thread.request_stop();
    forget();
    m_thread.join();
}

long StepWorker::request(pipeline::FramePtr whole, std::optional<pipeline::Place> at) {
    long ticket = 0;
    {
        const std::lock_guard lock(m_mutex);
        ticket = ++m_tickets;
        m_next = Job{std::move(whole), at, ticket};
    }
    m_arrived.notify_one();
    return ticket;
}

void StepWorker::forget() {
    const std::lock_guard lock(m_mutex);
    m_next.reset();
    m_stop.request_stop();
}

void StepWorker::work(const std::stop_token& quit) {
    while (!quit.stop_requested()) {
        Job job;
        std::stop_token stop;
        {
            std::unique_lock lock(m_mutex);
            if (!m_arrived.wait(lock, quit, [this] { return m_next.has_value(); })) return;
            job = std::move(*m_next);
            m_next.reset();
            m_stop = std::stop_source();
            if (quit.stop_requested()) return;
            stop = m_stop.get_token();
        }
        if (!m_steps || m_steps->frame() != job.whole) m_steps = std::make_shared<const pipeline::Steps>(job.whole);
        Result result{m_steps, nullptr, job.ticket};
        if (job.at) result.shown = m_steps->frameAt(m_steps->momentOf(*job.at), 0, stop);
        if (!stop.stop_requested()) m_deliver(std::move(result));
    }
}

}  // namespace app
