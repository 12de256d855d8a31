#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stop_token>

#include "pipeline/core/stop.h"

namespace test {

// Counts the looks at a stop and the items between them, and asks to stop at one of the looks.
class Looks {
public:
    explicit Looks(std::size_t stopAt = SIZE_MAX) {
        s_stop = std::stop_source();
        s_looks = s_items = s_most = 0, s_stopAt = stopAt;
        pipeline::observeStops([](std::size_t items) {
            ++s_looks, s_items += items, s_most = std::max(s_most, items);
            if (s_looks >= s_stopAt) s_stop.request_stop();
        });
    }
    ~Looks() { pipeline::observeStops(nullptr); }
    Looks(const Looks&) = delete;
    Looks& operator=(const Looks&) = delete;

    static pipeline::Stop stop() { return s_stop.get_token(); }
    static std::size_t count() { return s_looks; }
    static std::size_t items() { return s_items; }
    static std::size_t most() { return s_most; }

private:
    static inline std::stop_source s_stop;
    static inline std::size_t s_looks = 0, s_items = 0, s_most = 0, s_stopAt = 0;
};

}  // namespace test
