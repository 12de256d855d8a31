#pragma once
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace app {

// Does one piece of work at a time on a thread of its own: the newest that was asked for. One that waits is replaced.
// No Qt, so that the thread sanitizer sees every lock.
class NewestWorker {
public:
    using Work = std::function<void(const std::stop_token& stop)>;

    NewestWorker();
    ~NewestWorker();  // stops what runs and waits for it; nothing begins after

    // Whether work that runs may finish although newer waits. While a slider moves it may: a picture a little late is
    // better than none until the hand rests.
    enum class Running { Finish, Stop };
    void ask(Work work, Running running);
    void forget();      // what waits; what runs is asked to stop
    bool hasWaiting();  // newer work waits for what runs

private:
    void loop(const std::stop_token& quit);

    std::mutex m_mutex;
    std::condition_variable_any m_arrived;
    // Guarded by m_mutex.
    std::optional<Work> m_next;
    std::stop_source m_stop;

    std::jthread m_thread;  // last: starts when all else is there
};

}  // namespace app
