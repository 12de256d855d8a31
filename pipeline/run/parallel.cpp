#include "pipeline/run/parallel.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <map>
#include <mutex>
#include <new>
#include <optional>
#include <utility>

#include "pipeline/run/happens_before.h"

namespace pipeline {
namespace {

// Unused arenas, by their number of threads. A thread that joins a new arena must wake up first, which takes as long as
// a small frame. So the next frame gets the arena of the last one, whose threads still look for work.
class ArenaPool {
public:
    using Arena = std::unique_ptr<oneapi::tbb::task_arena>;
    static Arena take(int count) {
        const std::scoped_lock lock(s_mutex);
        const auto found = free().find(count);
        if (found == free().end()) return std::make_unique<oneapi::tbb::task_arena>(count);
        Arena arena = std::move(found->second);
        free().erase(found);
        return arena;
    }
    static void giveBack(int count, Arena arena) noexcept {
        const std::scoped_lock lock(s_mutex);
        try {
            free().emplace(count, std::move(arena));
        } catch (const std::bad_alloc&) {  // the next frame makes another one
        }
    }

private:
    static std::multimap<int, Arena>& free() {  // the lock must be held
        static auto* const arenas =
            new std::multimap<int, Arena>;  // never destroyed: threads may outlive static objects
        return *arenas;
    }
    static inline constinit std::mutex s_mutex;
};

}  // namespace

struct Threads::Team {
    explicit Team(int threads) : count(threads) {
        // The caller may ask for more threads than the machine has: tests compare 7 threads with 1.
        if (count > oneapi::tbb::info::default_concurrency())
            more.emplace(oneapi::tbb::global_control::max_allowed_parallelism, std::size_t(count));
        arena = ArenaPool::take(count);
    }
    ~Team() { ArenaPool::giveBack(count, std::move(arena)); }
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    int count;
    std::optional<oneapi::tbb::global_control> more;
    ArenaPool::Arena arena;
};

Threads::Threads(int count, Stop stop) : m_stop(std::move(stop)) {
    constexpr int kAll = oneapi::tbb::task_arena::automatic;
    if (count != 1) m_team = std::make_unique<Team>(count > 0 ? count : kAll);
}

Threads::~Threads() = default;

void Threads::share(std::size_t pieces, const std::function<void(std::size_t, std::size_t)>& run) {
    HappensBefore work, done;
    work.give();
    m_team->arena->execute([&] {
        // Ranges of pieces, because TBB halves what it gets, and its own pieces would be no multiple of a SIMD width.
        using Range = oneapi::tbb::blocked_range<std::size_t>;
        const auto runHere = [&](const Range& range) {
            work.take();
            run(range.begin(), range.end());
            done.give();
        };
        oneapi::tbb::parallel_for(Range(0, pieces), runHere, oneapi::tbb::simple_partitioner());
    });
    done.take();
}

}  // namespace pipeline
