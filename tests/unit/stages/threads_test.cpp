// The runner's threads, whose arenas are kept for the next frame.
#include "pipeline/run/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace pipeline {
namespace {

// Each piece once, of the grain but for the last; several frames at the same time, and one after the other.
TEST(Threads, HandOutEveryPieceOnce) {
    constexpr std::size_t kCount = 1003, kGrain = 16;
    const auto frames = [&](int threads) {
        for (int frame = 0; frame < 20; ++frame) {
            Threads runners(threads, {});
            std::vector<std::atomic<int>> times(kCount);
            std::atomic<int> uneven = 0;
            runners.forRange(kCount, kGrain, [&](std::size_t begin, std::size_t end) {
                uneven += begin % kGrain != 0 || (end - begin != kGrain && end != kCount);
                for (std::size_t i = begin; i < end; ++i) ++times[i];
            });
            for (const std::atomic<int>& n : times) ASSERT_EQ(n, 1);
            ASSERT_EQ(uneven, 0);
        }
    };
    std::vector<std::jthread> atOnce;
    for (const int threads : {1, 2, 2, 0, 7}) atOnce.emplace_back([&, threads] { frames(threads); });
}

// Of a stopped request no piece begins, on one thread and on several.
TEST(Threads, BeginNothingOnceStopped) {
    for (const int threads : {1, 3}) {
        std::stop_source source;
        Threads runners(threads, source.get_token());
        std::atomic<int> begun = 0;
        runners.forRange(1000, 1, [&](std::size_t, std::size_t) {
            source.request_stop();
            ++begun;
        });
        EXPECT_GE(begun, 1);
        EXPECT_LE(begun, threads);
        runners.forRange(1000, 1, [&](std::size_t, std::size_t) { ADD_FAILURE(); });
    }
}

}  // namespace
}  // namespace pipeline
