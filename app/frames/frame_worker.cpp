#include "app/frames/frame_worker.h"

#include <chrono>
#include <new>

namespace app {

using pipeline::FramePtr;
using pipeline::FrameRequest;
using pipeline::Scene;

FrameWorker::FrameWorker(Deliver deliver, DeliverCheck deliverCheck, Fail fail)
    : m_deliver(std::move(deliver)), m_deliverCheck(std::move(deliverCheck)), m_fail(std::move(fail)) {}

FrameWorker::~FrameWorker() {
    const std::lock_guard lock(m_mutex);
    m_ends = true;
    m_stopCheck.request_stop();
}

long FrameWorker::request(std::shared_ptr<const Scene> scene, FrameRequest request, Running running) {
    long ticket = 0;
    {
        const std::lock_guard lock(m_mutex);
        ticket = ++m_tickets;
        m_stopCheck.request_stop();
    }
    m_worker.ask(
        [this, scene = std::move(scene), request = std::move(request), ticket](const std::stop_token& stop) mutable {
            request.stop = stop;
            work(scene, request, ticket);
        },
        running);
    return ticket;
}

void FrameWorker::cancel() { m_worker.forget(); }

namespace {

// Puts what will be shown into the form in which it is read, so that the window does not wait for that.
void readAhead(const pipeline::Frame& frame) {
    const pipeline::BufferSet wanted = frame.wanted().set(index(pipeline::BufferId::PolygonId));
    for (const pipeline::BufferName& name : pipeline::allBuffers(frame.scene().lights.size()))
        if (wanted[index(name.id)]) frame.buffer(name);
}

}  // namespace

void FrameWorker::work(const std::shared_ptr<const Scene>& scene, const FrameRequest& request, long ticket) {
    {
        const std::lock_guard lock(m_mutex);
        if (m_ends) return;
        m_stopCheck = std::stop_source();
    }
    FramePtr frame = run(scene, request, ticket);
    if (!frame) return;
    m_last = std::move(frame);
    m_deliver(m_last, ticket);
    if (m_deliverCheck) check();
}

// Null where it was stopped, for a newer request waits or none is wanted, and where the machine has too little memory:
// pipeline/plan/memory_limit.h says what a frame may take, and not what there is.
FramePtr FrameWorker::run(const std::shared_ptr<const Scene>& scene, const FrameRequest& request, long ticket) {
    try {
        FramePtr frame = pipeline::runFrame(scene, request, m_last);
        if (frame) readAhead(*frame);
        return frame;
    } catch (const std::bad_alloc&) {
        if (m_fail) m_fail(ticket);
        return nullptr;
    }
}

// A check takes longer than a frame. Next to a slider that moves it would take the cores from every next one, so it waits
// until no request has come for a while.
void FrameWorker::check() {
    constexpr auto kQuiet = std::chrono::milliseconds(250);
    std::stop_token stop;
    {
        std::unique_lock lock(m_mutex);
        stop = m_stopCheck.get_token();
        m_quiet.wait_for(lock, stop, kQuiet, [] { return false; });
    }
    // A request may have stopped the check of the frame before, just when this one began.
    if (stop.stop_requested() || m_worker.hasWaiting()) return;
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
