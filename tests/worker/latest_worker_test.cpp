// The loop under everything that the window finds out beside its frames.
#include "app/jobs/latest_worker.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <vector>

namespace app {
namespace {

using Running = LatestWorker::Running;

// Work that says that it runs, then waits until it is let go or stopped.
struct Held {
    std::promise<void> begun, letGo;
    std::atomic<bool> stopped = false;

    LatestWorker::Work work() {
        return [this, go = letGo.get_future().share()](const std::stop_token& stop) {
            begun.set_value();
            while (!stop.stop_requested() && go.wait_for(std::chrono::milliseconds(1)) != std::future_status::ready) {
            }
            stopped = stop.stop_requested();
        };
    }
};

// Of three that are asked for while a fourth runs, the newest alone is done.
TEST(LatestWorker, DoesTheNewestOfWhatWaits) {
    Held held;
    std::vector<int> done;
    std::promise<void> last;
    {
        LatestWorker worker;
        worker.ask(held.work(), Running::Finish);
        held.begun.get_future().wait();
        for (const int i : {1, 2, 3})
            worker.ask(
                [&done, &last, i](const std::stop_token&) {
                    done.push_back(i);
                    if (i == 3) last.set_value();
                },
                Running::Finish);
        EXPECT_TRUE(worker.hasWaiting());
        held.letGo.set_value();
        last.get_future().wait();
        EXPECT_FALSE(worker.hasWaiting());
    }
    EXPECT_FALSE(held.stopped);
    EXPECT_EQ(done, std::vector{3});
}

TEST(LatestWorker, StopsWhatRunsWhereItIsTold) {
    Held held;
    std::promise<void> next;
    LatestWorker worker;
    worker.ask(held.work(), Running::Stop);
    held.begun.get_future().wait();
    worker.ask(
        [&](const std::stop_token& stop) {
            EXPECT_FALSE(stop.stop_requested());
            next.set_value();
        },
        Running::Stop);
    next.get_future().wait();
    EXPECT_TRUE(held.stopped);
}

TEST(LatestWorker, ForgetsWhatRunsAndWhatWaits) {
    Held held;
    bool waiting = false;
    {
        LatestWorker worker;
        worker.ask(held.work(), Running::Finish);
        held.begun.get_future().wait();
        worker.ask([&](const std::stop_token&) { waiting = true; }, Running::Finish);
        worker.forget();
    }
    EXPECT_TRUE(held.stopped);
    EXPECT_FALSE(waiting);
}

// However it meets the loop: nothing runs after the destructor has returned.
TEST(LatestWorker, EndsWhileWorkArrives) {
    for (int i = 0; i < 200; ++i) {
        auto alive = std::make_shared<std::atomic<bool>>(true);
        {
            LatestWorker worker;
            for (int k = 0; k <= i % 3; ++k)
                worker.ask([alive](const std::stop_token&) { EXPECT_TRUE(*alive); },
                           k % 2 ? Running::Stop : Running::Finish);
        }
        *alive = false;
    }
}

}  // namespace
}  // namespace app
