#pragma once
#include <hwy/cache_control.h>

#include <cstddef>
#include <cstdint>

namespace pipeline {

// For a loop over an array that comes to `count` of its elements now: has on their way those that it comes to half a page
// later. By itself a processor fetches ahead to the end of a page and no farther.
template <class T>
HWY_INLINE void fetchAhead(const T* now, std::size_t count) {
    constexpr std::size_t kAhead = 2048, kLine = 64;
    const auto first = reinterpret_cast<std::uintptr_t>(now) + kAhead;  // may lie behind the end: nothing is read
    for (std::size_t i = 0; i < count * sizeof(T); i += kLine) hwy::Prefetch(reinterpret_cast<const void*>(first + i));
}

}  // namespace pipeline
