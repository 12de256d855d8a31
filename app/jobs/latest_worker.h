#pragma once
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace app {

// Runs one piece of work at a time on a thread of its own: always the newest request. A newer request replaces a
// waiting one. No Qt, so that the thread sanitizer sees every lock.
class LatestWorker {
public:
    using Work = std::function<void(const std::stop_token& stop)>;

    LatestWorker();
    ~LatestWorker();  // stops and joins; nothing begins after

    // Whether running work may finish although newer work waits. It may while a slider moves: a late picture is better
    // than none.
    enum class Running { Finish, Stop };
    void ask(Work work, Running running);
    void forget();      // drops waiting work and asks running work to stop
    bool hasWaiting();  // newer work waits for the running one

private:
    void loop(const std::stop_token& quit);

    std::mutex m_mutex;
    std::condition_variable_any m_arrived;
    // Guarded by m_mutex.
    std::optional<Work> m_next;
    std::stop_source m_stop;

    std::jthread m_thread;  // last: starts when all other members exist
};

}  // namespace app
