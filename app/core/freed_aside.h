#pragma once
#include <memory>
#include <utility>

namespace app {

void freeAside(std::shared_ptr<const void> held);

// A frame of a million polygons, or its drawing as shapes, takes long to free. Held as this gives it, it is freed beside
// the window also where the window is the last to let go of it.
template <class T>
std::shared_ptr<T> freedAside(std::shared_ptr<T> held) {
    T* at = held.get();
    if (!at) return {};
    return {at, [held = std::move(held)](T*) mutable { freeAside(std::move(held)); }};
}

}  // namespace app
