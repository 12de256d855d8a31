#pragma once
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>

#include "app/frames/frame_check.h"
#include "app/jobs/latest_worker.h"

namespace app {

// Computes frames on the thread of a LatestWorker. It keeps the last frame, so that the next one can reuse its results.
// If no request comes for a while, it checks the frame once. No Qt, so that the thread sanitizer sees every lock.
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

    using Running = LatestWorker::Running;
    // The worker sets the stop token of `request` itself. Returns the request's ticket; tickets increase.
    long request(std::shared_ptr<const pipeline::Scene> scene, pipeline::FrameRequest request, Running running);
    void cancel();  // the running and the waiting request; the next frame reuses valid results

private:
    void work(const std::shared_ptr<const pipeline::Scene>& scene, const pipeline::FrameRequest& request, long ticket);
    pipeline::FramePtr run(const std::shared_ptr<const pipeline::Scene>& scene, const pipeline::FrameRequest& request,
                           long ticket);
    void check();
    FrameCheck checked(const std::stop_token& stop) const;

    Deliver m_deliver;
    DeliverCheck m_deliverCheck;
    Fail m_fail;

    std::mutex m_mutex;
    std::condition_variable_any m_quiet;
    // Guarded by m_mutex.
    std::stop_source m_stopCheck;
    bool m_ends = false;
    long m_tickets = 0;

    pipeline::FramePtr m_last;  // used by the worker's thread only
    LatestWorker m_worker;      // last: its thread uses the other members
};

}  // namespace app
