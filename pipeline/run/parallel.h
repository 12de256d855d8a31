#pragma once
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <cstddef>
#include <optional>
#include <stop_token>

namespace pipeline {

// The runner's threads. Stages see ranges and tiles, never this.
class Threads {
public:
    // count 0: as many as the machine has.
    Threads(int count, std::stop_token stop)
        : m_arena(count > 0 ? count : oneapi::tbb::task_arena::automatic), m_stop(std::move(stop)) {
        // Asked for more than the machine has, it gets them all the same: tests compare 7 threads with 1.
        if (count > oneapi::tbb::info::default_concurrency())
            m_more.emplace(oneapi::tbb::global_control::max_allowed_parallelism, std::size_t(count));
    }

    // body(begin, end) over [0, count) in pieces of at most grain; one piece runs here and now.
    // Pieces not begun when the request is stopped are dropped.
    template <class Body>
    void forRange(std::size_t count, std::size_t grain, Body body) {
        if (count == 0 || stopped()) return;
        if (count <= grain) return body(std::size_t(0), count);
        m_arena.execute([&] {
            oneapi::tbb::parallel_for(
                oneapi::tbb::blocked_range<std::size_t>(0, count, grain),
                [&](const oneapi::tbb::blocked_range<std::size_t>& range) {
                    if (!stopped()) body(range.begin(), range.end());
                },
                oneapi::tbb::simple_partitioner());
        });
    }
    bool stopped() const { return m_stop.stop_requested(); }

private:
    std::optional<oneapi::tbb::global_control> m_more;
    oneapi::tbb::task_arena m_arena;
    std::stop_token m_stop;
};

}  // namespace pipeline
