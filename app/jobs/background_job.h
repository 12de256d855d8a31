#pragma once
#include <QObject>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>

#include "app/jobs/latest_worker.h"

namespace app {

// Runs the newest of the requested jobs on a thread of its own, which starts with the first job. The result arrives in
// the thread of this object.
class BackgroundJob : public QObject {
    Q_OBJECT
public:
    using Running = LatestWorker::Running;
    // For the work: whether to stop, and a place for its progress, 0 to 1.
    struct Control {
        std::stop_token stop;
        std::function<void(double share)> progress;
    };

    explicit BackgroundJob(QObject* parent = nullptr);
    ~BackgroundJob() override;  // stops and joins; no result comes after

    // work(control) returns a result that can be copied; it sees the window's look as it is now. done(result) follows,
    // unless the job was stopped or forgotten, or ran out of memory (MemoryNotice reports that).
    template <class Work, class Done>
    void ask(Work work, Done done, Running running = Running::Stop) {
        start(
            [work = std::move(work), done = std::move(done)](const Control& control) -> std::function<void()> {
                auto result = work(control);
                return [done, result = std::move(result)] { done(result); };
            },
            running);
    }
    void forget();  // drops running and waiting work
    // Waits at most that long for the newest job; its result then arrives within this call. Returns whether it did.
    bool waitFor(std::chrono::milliseconds longest);
    bool busy() const { return m_taken < m_ticket; }

signals:
    void busyChanged(bool busy);
    void progressed(double share);  // of the running job

private:
    void start(std::function<std::function<void()>(const Control&)> job, Running running);
    void take(long ticket, const std::function<void()>& done);

    long m_ticket = 0, m_taken = 0, m_oldestValid = 0;
    std::mutex m_mutex;
    std::condition_variable m_finished;
    long m_posted = 0;                       // number of the newest result on its way; guarded by m_mutex
    std::unique_ptr<LatestWorker> m_worker;  // last: its thread uses the other members
};

}  // namespace app
