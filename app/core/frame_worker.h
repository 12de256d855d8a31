#pragma once
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "pipeline/run/runner.h"

namespace app {

// Per stage, against double precision; nothing where it is not computed.
using StageErrors = std::array<std::optional<pipeline::StageError>, pipeline::kStageCount>;

// What is found out about a frame in idle time.
struct FrameCheck {
    StageErrors errors;
    std::size_t nan = 0;  // numbers in all its buffers that are none
};

// Computes frames on one thread of its own, one at a time. A newer request replaces one that
// waits. It keeps the last frame, so that the next one reuses what still holds, and spends its
// idle time on checking that frame: once, when no request has come for a while. No Qt, so that the thread sanitizer
// sees every lock.
class FrameWorker {
public:
    // Called on the worker's thread: with a finished frame and the ticket of its request, and
    // later, if nothing came in between, with the check of that frame.
    using Deliver = std::function<void(pipeline::FramePtr, long ticket)>;
    using DeliverCheck = std::function<void(pipeline::FramePtr, const FrameCheck&)>;
    // There was not enough memory for the frame of this request: it is given up, and the next one may fit.
    using Fail = std::function<void(long ticket)>;

    // Without deliverCheck no frame is checked.
    FrameWorker(Deliver deliver, DeliverCheck deliverCheck, Fail fail = {});
    ~FrameWorker();  // stops what runs and waits for it; no call comes after

    // Whether a frame that is being computed may finish although a newer one is wanted. While a
    // slider moves it may: a picture a little late is better than none until the hand rests.
    enum class Running { Finish, Stop };
    // The stop token in `request` is the worker's own affair. Returns the request's ticket; they grow.
    long request(std::shared_ptr<const pipeline::Scene> scene, pipeline::FrameRequest request, Running running);
    void cancel();  // what runs and what waits; the next one reuses what still holds

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

    pipeline::FramePtr m_last;  // the worker's thread alone
    std::jthread m_thread;      // last: starts when all else is there
};

}  // namespace app
