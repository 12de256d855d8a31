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
#include <type_traits>

#include "pipeline/simd/set_up.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// Prefetches the small triangles of a tile's next runs, which are scattered in memory.
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
// The number of runs of small triangles at the beginning of `runs`.
HWY_INLINE std::size_t smallOnes(std::span<const TriangleRun> runs) {
    return std::size_t(std::ranges::find_if(runs, &TriangleRun::isNotSmall) - runs.begin());
}
// Calls visit(triangle) for the small triangles of a run.
template <class Visit>
HWY_INLINE void forEachSmall(const TrianglePiece& piece, TriangleRun run, FetchedAhead& ahead, Visit visit) {
    for (std::uint32_t i = 0; i < run.count; ++i) ahead.fetch(), visit(piece.small[run.first + i]);
}
// Calls visit(at, z, id), or visit(at, z), for the fragments of a run.
template <class Visit>
HWY_INLINE void forEachFragment(const Fragments& all, TriangleRun run, Visit visit) {
    const std::size_t first = run.first & ~TriangleRun::kTiny;
    for (std::size_t i = first; i < first + run.count; ++i) {
        if constexpr (std::is_invocable_v<Visit, std::size_t, float>)
            visit(std::size_t(all.at[i]), all.z[i]);
        else
            visit(std::size_t(all.at[i]), all.z[i], all.id[i]);
    }
}
// Calls visit(triangle, index) for the triangles of a run of others.
template <class Visit>
HWY_INLINE void forEachOther(const TrianglePiece& piece, TriangleRun run, Visit visit) {
    const std::uint32_t first = run.first & ~TriangleRun::kOther;
    for (std::uint32_t i = first; i < first + run.count; ++i) visit(piece.others[i], i);
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
