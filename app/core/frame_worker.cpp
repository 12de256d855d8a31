#include "app/core/frame_worker.h"

#include <chrono>
#include <new>

namespace app {

using pipeline::FramePtr;
using pipeline::FrameRequest;
using pipeline::Scene;

FrameWorker::FrameWorker(Deliver deliver, DeliverCheck deliverCheck, Fail fail)
    : m_deliver(std::move(deliver)),
      m_deliverCheck(std::move(deliverCheck)),
      m_fail(std::move(fail)),
      m_thread([this](std::stop_token quit) { work(std::move(quit)); }) {}

FrameWorker::~FrameWorker() {
    m_thread.request_stop();
    {
        const std::lock_guard lock(m_mutex);
        m_stopFrame.request_stop();
        m_stopCheck.request_stop();
    }
    m_thread.join();
}

long FrameWorker::request(std::shared_ptr<const Scene> scene, FrameRequest request, Running running) {
    long ticket = 0;
    {
        const std::lock_guard lock(m_mutex);
        ticket = ++m_tickets;
        m_next = Job{std::move(scene), std::move(request), ticket};
        if (running == Running::Stop) m_stopFrame.request_stop();
        m_stopCheck.request_stop();
    }
    m_arrived.notify_one();
    return ticket;
}

void FrameWorker::cancel() {
    const std::lock_guard lock(m_mutex);
    m_next.reset();
    m_stopFrame.request_stop();
}

namespace {

// Puts what will be shown into the form in which it is read, so that the window does not wait for that.
void readAhead(const pipeline::Frame& frame) {
    const pipeline::BufferSet wanted = frame.wanted().set(index(pipeline::BufferId::PolygonId));
    for (const pipeline::BufferName& name : pipeline::allBuffers(frame.scene().lights.size()))
        if (wanted[index(name.id)]) frame.buffer(name);
}

}  // namespace

void FrameWorker::work(std::stop_token quit) {
    while (!quit.stop_requested()) {
        Job job;
        {
            std::unique_lock lock(m_mutex);
            if (!m_arrived.wait(lock, quit, [this] { return m_next.has_value(); })) return;
            job = std::move(*m_next);
            m_next.reset();
            // Fresh sources under the lock: a request that comes from here on stops this frame,
            // one that came before is the frame. Quitting may have been asked for in between.
            m_stopFrame = std::stop_source();
            m_stopCheck = std::stop_source();
            if (quit.stop_requested()) return;
            job.request.stop = m_stopFrame.get_token();
        }
        const long ticket = job.ticket;
        FramePtr frame = run(std::move(job));
        if (!frame) continue;
        m_last = std::move(frame);
        m_deliver(m_last, ticket);
        if (m_deliverCheck) check();
    }
}

// Null where it was stopped, for a newer request waits or none is wanted, and where the machine has too little memory:
// pipeline/plan/memory_limit.h says what a frame may take, and not what there is.
FramePtr FrameWorker::run(Job job) {
    try {
        FramePtr frame = pipeline::runFrame(std::move(job.scene), job.request, m_last);
        if (frame) readAhead(*frame);
        return frame;
    } catch (const std::bad_alloc&) {
        if (m_fail) m_fail(job.ticket);
        return nullptr;
    }
}

// A check takes longer than a frame: beside a slider that moves it would take the processors from every next one.
bool FrameWorker::staysIdle(const std::stop_token& stop) {
    constexpr auto kQuiet = std::chrono::milliseconds(250);
    std::unique_lock lock(m_mutex);
    return !m_arrived.wait_for(lock, stop, kQuiet, [this] { return m_next.has_value(); }) && !stop.stop_requested();
}

void FrameWorker::check() {
    std::stop_token stop;
    {
        const std::lock_guard lock(m_mutex);
        stop = m_stopCheck.get_token();
    }
    if (!staysIdle(stop)) return;
    try {
        const FrameCheck found = checked(stop);
        if (!stop.stop_requested()) m_deliverCheck(m_last, found);
    } catch (const std::bad_alloc&) {  // of a frame that is there, only its errors stay unknown
    }
}

FrameCheck FrameWorker::checked(const std::stop_token& stop) const {
    FrameCheck found{.errors = pipeline::errorAgainstDouble(m_last, stop)};
    for (const pipeline::AnyBuffer& buffer : m_last->buffers()) {
        if (stop.stop_requested()) break;
        found.nan += statistics(buffer).nan;
    }
    return found;
}

}  // namespace app
