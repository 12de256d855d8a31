#pragma once
#include <mutex>

namespace app {

// VTK is at work in one place at a time: a view that is painted and a picture that is rendered beside it take turns.
inline std::mutex& vtkTurn() {
    static std::mutex turn;
    return turn;
}

}  // namespace app
