#pragma once
#include <memory>
#include <utility>

namespace app {

void freeInBackground(std::shared_ptr<const void> held);

// A frame of a million polygons, or its drawing as shapes, takes long to free. Wrapped by this, it is freed in the
// background even if the window releases it last.
template <class T>
std::shared_ptr<T> freedInBackground(std::shared_ptr<T> held) {
    T* at = held.get();
    if (!at) return {};
    return {at, [held = std::move(held)](T*) mutable { freeInBackground(std::move(held)); }};
}

}  // namespace app
