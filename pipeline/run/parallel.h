#pragma once
#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>

#include "pipeline/core/stop.h"

namespace pipeline {

// The threads of the runner. Stages see ranges and tiles, never this class.
class Threads {
public:
    // count 0: as many as the machine has.
    Threads(int count, Stop stop);
    ~Threads();
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;

    // Calls body(begin, end) over [0, count) in pieces of `grain`; the last one may be shorter. A single piece runs in
    // this thread. If the request is stopped, pieces that have not begun are dropped.
    template <class Body>
    void forRange(std::size_t count, std::size_t grain, Body body) {
        if (count == 0 || stopped()) return;
        if (count <= grain) return body(std::size_t(0), count);
        const std::size_t pieces = (count + grain - 1) / grain;
        const auto run = [&](std::size_t begin, std::size_t end) {
            for (std::size_t piece = begin; piece < end && !stopped(); ++piece)
                body(piece * grain, std::min(count, (piece + 1) * grain));
        };
        m_team ? share(pieces, std::cref(run)) : run(0, pieces);
    }
    bool stopped() const { return m_stop.stop_requested(); }
    const Stop& stop() const { return m_stop; }  // for a long piece to check

private:
    // Calls run(begin, end) over [0, pieces), in parts of any length.
    void share(std::size_t pieces, const std::function<void(std::size_t, std::size_t)>& run);

    struct Team;
    std::unique_ptr<Team> m_team;  // null for one thread, which is the caller's
    Stop m_stop;
};

}  // namespace pipeline
