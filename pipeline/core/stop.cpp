#include "pipeline/core/stop.h"

#include <atomic>

namespace pipeline {
namespace {

std::atomic<StopObserver> s_observer = nullptr;

}  // namespace

void observeStops(StopObserver observer) { s_observer = observer; }

bool StopCheck::look() {
    if (const StopObserver observer = s_observer) observer(m_items);
    m_items = 0, m_nextLook = kItemsPerLook;
    m_stopped = m_stop.stop_requested();
    return m_stopped;
}

}  // namespace pipeline
