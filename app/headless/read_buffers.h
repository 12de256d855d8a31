#pragma once
#include <vector>

#include "pipeline/core/stop.h"
#include "pipeline/run/frame.h"

namespace app {

// A frame makes some buffers when they are first read, which takes a while in a large picture: reads these, or all if there
// are none. False when it was stopped.
inline bool readBuffers(const pipeline::Frame& frame, const std::vector<pipeline::BufferName>& names,
                        const pipeline::Stop& stop) {
    for (const pipeline::BufferName& name : names.empty() ? pipeline::allBuffers(frame.scene().lights.size()) : names) {
        if (stop.stop_requested()) return false;
        [[maybe_unused]] const auto made = frame.buffer(name);
    }
    return !stop.stop_requested();
}

}  // namespace app
