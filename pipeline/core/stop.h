#pragma once
#include <cstddef>
#include <utility>
#include <version>

#ifdef __cpp_lib_jthread
#include <stop_token>
#endif

namespace pipeline {

#ifdef __cpp_lib_jthread
// Asks a long computation to end early; its result is then of no use.
using Stop = std::stop_token;
#else
// A library without threads: nobody is there to ask.
struct Stop {
    bool stop_requested() const { return false; }
};
#endif

// Told of every look that a StopCheck takes, and how many items were done since the one before. For tests; null: nobody.
using StopObserver = void (*)(std::size_t items);
void observeStops(StopObserver observer);

// Looks at a stop once in so many items of a loop, as looking at every one would cost time. An item is a corner, a
// vertex, a word: work of about a microsecond.
class StopCheck {
public:
    static constexpr std::size_t kItemsPerLook = 4096;

    explicit StopCheck(Stop stop) : m_stop(std::move(stop)) {}

    // Whether to give up, after so many more items. The first call looks.
    bool stopped(std::size_t items = 1) {
        m_items += items;
        return m_items < m_nextLook ? m_stopped : look();
    }

private:
    bool look();

    Stop m_stop;
    std::size_t m_items = 0, m_nextLook = 0;  // since the last look
    bool m_stopped = false;
};

}  // namespace pipeline
