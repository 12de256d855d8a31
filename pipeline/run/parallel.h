#pragma once
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

namespace pipeline {

// Arenas that nobody uses, by how many threads they have. A thread that joins a new arena wakes up first, which takes as
// long as a small frame: the next frame gets the arena that the last one has left, where the threads still look for work.
class ArenaPool {
public:
    using Arena = std::unique_ptr<oneapi::tbb::task_arena>;
    static ArenaPool& instance() {
        static auto* const pool = new ArenaPool;  // never destroyed: threads may outlive what is static
        return *pool;
    }
    Arena take(int count) {
        const std::scoped_lock lock(m_mutex);
        const auto found = m_free.find(count);
        if (found == m_free.end()) return std::make_unique<oneapi::tbb::task_arena>(count);
        Arena arena = std::move(found->second);
        m_free.erase(found);
        return arena;
    }
    void giveBack(int count, Arena arena) {
        const std::scoped_lock lock(m_mutex);
        m_free.emplace(count, std::move(arena));
    }

private:
    std::mutex m_mutex;
    std::multimap<int, Arena> m_free;
};

// The runner's threads. Stages see ranges and tiles, never this.
class Threads {
public:
    // count 0: as many as the machine has.
    Threads(int count, std::stop_token stop)
        : m_count(count > 0 ? count : oneapi::tbb::task_arena::automatic), m_stop(std::move(stop)) {
        // Asked for more than the machine has, it gets them all the same: tests compare 7 threads with 1.
        if (count > oneapi::tbb::info::default_concurrency())
            m_more.emplace(oneapi::tbb::global_control::max_allowed_parallelism, std::size_t(count));
        if (m_count != 1) m_arena = ArenaPool::instance().take(m_count);
    }
    ~Threads() {
        if (m_arena) ArenaPool::instance().giveBack(m_count, std::move(m_arena));
    }
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;

    // body(begin, end) over [0, count) in pieces of grain, of which the last may be shorter; one piece runs here and now.
    // Pieces not begun when the request is stopped are dropped.
    template <class Body>
    void forRange(std::size_t count, std::size_t grain, Body body) {
        if (count == 0 || stopped()) return;
        if (count <= grain) return body(std::size_t(0), count);
        // Ranges of pieces, for TBB halves what it is given: its own pieces of a range would be no multiple of a vector.
        const std::size_t pieces = (count + grain - 1) / grain;
        const auto run = [&](std::size_t begin, std::size_t end) {
            for (std::size_t piece = begin; piece < end && !stopped(); ++piece)
                body(piece * grain, std::min(count, (piece + 1) * grain));
        };
        if (!m_arena) return run(0, pieces);
        m_arena->execute([&] {
            using Range = oneapi::tbb::blocked_range<std::size_t>;
            oneapi::tbb::parallel_for(
                Range(0, pieces), [&](const Range& range) { run(range.begin(), range.end()); },
                oneapi::tbb::simple_partitioner());
        });
    }
    bool stopped() const { return m_stop.stop_requested(); }
    const std::stop_token& stop() const { return m_stop; }  // for a piece that is long in itself

private:
    std::optional<oneapi::tbb::global_control> m_more;
    int m_count;
    ArenaPool::Arena m_arena;  // none for one thread, which is the caller's
    std::stop_token m_stop;
};

}  // namespace pipeline
