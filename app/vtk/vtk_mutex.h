#pragma once
#include <mutex>

namespace app {

// Held by whoever calls VTK, which runs on one thread at a time: a painted view, or a picture rendered in the
// background.
inline std::mutex& vtkMutex() {
    static std::mutex turn;
    return turn;
}

}  // namespace app
