#pragma once
#include <hwy/cache_control.h>

#include <cstddef>
#include <cstdint>

#include "pipeline/buffers/block_buffer.h"

namespace pipeline {

// For a loop over an array that comes to `count` of its elements now: has on their way those that it comes to half a page
// later. By itself a processor fetches ahead to the end of a page and no farther.
template <class T>
HWY_INLINE void fetchAhead(const T* now, std::size_t count) {
    constexpr std::size_t kAhead = 2048, kLine = 64;
    const auto first = reinterpret_cast<std::uintptr_t>(now) + kAhead;
    for (std::size_t i = 0; i < count * sizeof(T); i += kLine) {
        // Nothing is read, and it may lie behind the array's end, where no sum of pointers may point.
        // NOLINTNEXTLINE(performance-no-int-to-ptr)
        hwy::Prefetch(reinterpret_cast<const void*>(first + i));
    }
}

// While the triangles of a tile are drawn, the blocks of the next tile are on their way, where a buffer is larger than the
// caches next to the processor.
class BlocksAhead {
public:
    // names: null where nobody asks.
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
