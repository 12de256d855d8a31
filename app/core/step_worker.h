#pragma once
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "pipeline/steps/steps.h"

namespace app {

using StepsPtr = std::shared_ptr<const pipeline::Steps>;

// Finds a frame's steps, and its state at a moment, on one thread of its own. A newer request replaces one that
// waits; what is being computed is finished, so that pictures come while a handle is dragged. No Qt, so that the
// thread sanitizer sees every lock.
class StepWorker {
public:
    struct Result {
        StepsPtr steps;            // of the whole frame that was asked about
        pipeline::FramePtr shown;  // its state at the moment; null where none was asked for
        long ticket = 0;
    };
    // Called on the worker's thread.
    using Deliver = std::function<void(Result)>;

    explicit StepWorker(Deliver deliver);
    ~StepWorker();  // stops what runs and waits for it; no call comes after

    // at: nothing to find the steps alone. Returns the request's ticket; they grow.
    long request(pipeline::FramePtr whole, std::optional<pipeline::Place> at);
    void forget();  // what waits, and what is being computed

private:
    struct Job {
        pipeline::FramePtr whole;
        std::optional<pipeline::Place> at;
        long ticket = 0;
    };
    void work(const std::stop_token& quit);

    Deliver m_deliver;
    StepsPtr m_steps;  // the worker's thread alone
    std::mutex m_mutex;
    std::condition_variable_any m_arrived;
    std::optional<Job> m_next;
    std::stop_source m_stop;
    long m_tickets = 0;
    std::jthread m_thread;  // last: it uses all of the above
};

}  // namespace app
