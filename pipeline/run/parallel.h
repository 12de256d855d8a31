#pragma once
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
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

    // body(begin, end) over [0, count) in pieces of grain, of which the last may be shorter; one piece runs here and now.
    // Pieces not begun when the request is stopped are dropped.
    template <class Body>
    void forRange(std::size_t count, std::size_t grain, Body body) {
        if (count == 0 || stopped()) return;
        if (count <= grain) return body(std::size_t(0), count);
        // Ranges of pieces, for TBB halves what it is given: its own pieces of a range would be no multiple of a vector.
        const std::size_t pieces = (count + grain - 1) / grain;
        m_arena.execute([&] {
            oneapi::tbb::parallel_for(
                oneapi::tbb::blocked_range<std::size_t>(0, pieces),
                [&](const oneapi::tbb::blocked_range<std::size_t>& range) {
                    for (std::size_t piece = range.begin(); piece < range.end() && !stopped(); ++piece)
                        body(piece * grain, std::min(count, (piece + 1) * grain));
                },
                oneapi::tbb::simple_partitioner());
        });
    }
    bool stopped() const { return m_stop.stop_requested(); }
    const std::stop_token& stop() const { return m_stop; }  // for a piece that is long in itself

private:
    std::optional<oneapi::tbb::global_control> m_more;
    oneapi::tbb::task_arena m_arena;
    std::stop_token m_stop;
};

}  // namespace pipeline
