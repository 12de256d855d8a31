#pragma once
#include <hwy/cache_control.h>

#include <cstddef>
#include <cstdint>

#include "pipeline/buffers/block_buffer.h"

namespace pipeline {

// For a loop that is at element `count` of an array: prefetches the elements half a page ahead. The CPU itself
// prefetches only to the end of a page.
template <class T>
HWY_INLINE void fetchAhead(const T* now, std::size_t count) {
    constexpr std::size_t kAhead = 2048, kLine = 64;
    const auto first = reinterpret_cast<std::uintptr_t>(now) + kAhead;
    for (std::size_t i = 0; i < count * sizeof(T); i += kLine) {
        // Nothing is read, and the address may be behind the array's end, where pointer arithmetic is not allowed.
        // NOLINTNEXTLINE(performance-no-int-to-ptr)
        hwy::Prefetch(reinterpret_cast<const void*>(first + i));
    }
}

// Prefetches the blocks of the next tile while the triangles of a tile are drawn, if a buffer is larger than the inner
// caches.
class BlocksAhead {
public:
    // names: null if not requested.
    static BlocksAhead from(std::size_t tile, const BlockBuffer2D<float>& z,
                            const BlockBuffer2D<std::uint32_t>* names) {
        constexpr std::size_t kFew = (std::size_t{2} << 20) / sizeof(Block<float>);  // 2 MB
        if (tile == z.tileCount() || z.blocks.size() <= kFew) return {};
        return {z.tile(tile), z.tile(tile) + kBlocks, names ? names->tile(tile) : nullptr};
    }
    HWY_INLINE void fetch() {
        static_assert(sizeof(*m_z) == 64 && sizeof(*m_names) == 64, "a line of the cache");
        constexpr int kAtOnce = 4;
        if (m_z == m_end) return;
        for (int i = 0; i < kAtOnce; ++i) {
            hwy::Prefetch(m_z++);
            if (m_names) hwy::Prefetch(m_names++);
        }
    }

private:
    BlocksAhead() = default;
    BlocksAhead(const Block<float>* z, const Block<float>* end, const Block<std::uint32_t>* names)
        : m_z(z), m_end(end), m_names(names) {}
    const Block<float>*m_z = nullptr, *m_end = nullptr;
    const Block<std::uint32_t>* m_names = nullptr;
};

}  // namespace pipeline
