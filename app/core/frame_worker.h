#pragma once
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "app/core/frame_check.h"

namespace app {

// Computes frames on one thread of its own, one at a time. A newer request replaces a waiting one. It keeps the last
// frame, so that the next one can reuse its results. If no request comes for a while, it checks the frame once. No Qt,
// so that the thread sanitizer sees every lock.
class FrameWorker {
public:
    // Called on the worker's thread with a finished frame and the ticket of its request; later with the check of that
    // frame, if no request came in between.
    using Deliver = std::function<void(pipeline::FramePtr, long ticket)>;
    using DeliverCheck = std::function<void(pipeline::FramePtr, const FrameCheck&)>;
    // There was not enough memory for the frame of this request. It is dropped; the next one may fit.
    using Fail = std::function<void(long ticket)>;

    // Without deliverCheck frames are not checked.
    FrameWorker(Deliver deliver, DeliverCheck deliverCheck, Fail fail = {});
    ~FrameWorker();  // stops and joins; no call comes after

    // Whether a running frame may finish although a newer one is wanted. It may while a slider moves: a late picture is
    // better than none.
    enum class Running { Finish, Stop };
    // The worker sets the stop token of `request` itself. Returns the request's ticket; tickets increase.
    long request(std::shared_ptr<const pipeline::Scene> scene, pipeline::FrameRequest request, Running running);
    void cancel();  // the running and the waiting request; the next frame reuses valid results

private:
    struct Job {
        std::shared_ptr<const pipeline::Scene> scene;
        pipeline::FrameRequest request;
        long ticket = 0;
    };
    void work(std::stop_token quit);
    pipeline::FramePtr run(Job job);
    void check();
    FrameCheck checked(const std::stop_token& stop) const;
    bool staysIdle(const std::stop_token& stop);

    Deliver m_deliver;
    DeliverCheck m_deliverCheck;
    Fail m_fail;

    std::mutex m_mutex;
    std::condition_variable_any m_arrived;
    // Guarded by m_mutex.
    std::optional<Job> m_next;
    std::stop_source m_stopFrame, m_stopCheck;
    long m_tickets = 0;

    pipeline::FramePtr m_last;  // used by the worker's thread only
    std::jthread m_thread;      // last: starts when all other members exist
};

}  // namespace app
