#pragma once
#include <QObject>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>

#include "app/core/newest_worker.h"

namespace app {

// The newest of the jobs asked for, computed on a thread of its own, which starts with the first; its result comes in
// the thread of this object.
class BackgroundJob : public QObject {
    Q_OBJECT
public:
    using Running = NewestWorker::Running;
    // What work may look at: whether to give up, and where it says how far it is, 0 to 1.
    struct Control {
        std::stop_token stop;
        std::function<void(double share)> progress;
    };

    explicit BackgroundJob(QObject* parent = nullptr);
    ~BackgroundJob() override;  // stops what runs, and waits; nothing comes after

    // work(control) gives a result that can be copied, and sees the window's look as it is now; done(result) follows,
    // unless it was stopped or forgotten, or there was not enough memory for it, which MemoryNotice says.
    template <class Work, class Done>
    void ask(Work work, Done done, Running running = Running::Stop) {
        start(
            [work = std::move(work), done = std::move(done)](const Control& control) -> std::function<void()> {
                auto result = work(control);
                return [done, result = std::move(result)] { done(result); };
            },
            running);
    }
    void forget();  // what runs and what waits
    // Waits for what was asked for last, at most so long; its result then comes within this call. Whether it did.
    bool waitFor(std::chrono::milliseconds longest);
    bool busy() const { return m_taken < m_ticket; }

signals:
    void busyChanged(bool busy);
    void progressed(double share);  // of what runs

private:
    void start(std::function<std::function<void()>(const Control&)> job, Running running);
    void take(long ticket, const std::function<void()>& done);

    long m_ticket = 0, m_taken = 0, m_oldestValid = 0;
    std::mutex m_mutex;
    std::condition_variable m_finished;
    long m_posted = 0;                       // of the newest result that is on its way; guarded by m_mutex
    std::unique_ptr<NewestWorker> m_worker;  // last: its thread uses the others
};

}  // namespace app
