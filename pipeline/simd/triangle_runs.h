// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_TRIANGLE_RUNS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_TRIANGLE_RUNS_H
#undef SHADESCOPE_TRIANGLE_RUNS_H
#else
#define SHADESCOPE_TRIANGLE_RUNS_H
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "pipeline/buffers/block_buffer.h"
#include "pipeline/simd/set_up.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// The runs of a tile jump about in the small triangles: those that are drawn next are on their way before.
class FetchedAhead {
public:
    FetchedAhead(const TrianglePiece& piece, std::span<const TriangleRun> runs) : m_piece(piece), m_runs(runs) {
        for (int i = 0; i < kAhead; ++i) fetch();
    }
    HWY_INLINE void fetch() {
        while (m_run < m_runs.size() && m_runs[m_run].isNotSmall()) ++m_run;
        if (m_run == m_runs.size()) return;
        hwy::Prefetch(&m_piece.small[m_runs[m_run].first + m_at]);
        if (++m_at == m_runs[m_run].count) m_at = 0, ++m_run;
    }

private:
    static constexpr int kAhead = 12;
    const TrianglePiece& m_piece;
    std::span<const TriangleRun> m_runs;
    std::size_t m_run = 0;
    std::uint32_t m_at = 0;
};
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
// How many of the runs are of small triangles before one is not.
HWY_INLINE std::size_t smallOnes(std::span<const TriangleRun> runs) {
    return std::size_t(std::ranges::find_if(runs, &TriangleRun::isNotSmall) - runs.begin());
}
// Calls visit(triangle) for the small triangles of a run.
template <class Visit>
HWY_INLINE void forEachSmall(const TrianglePiece& piece, TriangleRun run, FetchedAhead& ahead, Visit visit) {
    for (std::uint32_t i = 0; i < run.count; ++i) ahead.fetch(), visit(piece.small[run.first + i]);
}
// Calls visit(at, z, id) for those of a run of fragments.
template <class Visit>
HWY_INLINE void forEachFragment(const Fragments& all, TriangleRun run, Visit visit) {
    const std::size_t first = run.first & ~TriangleRun::kTiny;
    for (std::size_t i = first; i < first + run.count; ++i) visit(std::size_t(all.at[i]), all.z[i], all.id[i]);
}
// Calls visit(triangle, index) for those of a run of others.
template <class Visit>
HWY_INLINE void forEachOther(const TrianglePiece& piece, TriangleRun run, Visit visit) {
    const std::uint32_t first = run.first & ~TriangleRun::kOther;
    for (std::uint32_t i = first; i < first + run.count; ++i) visit(piece.others[i], i);
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
