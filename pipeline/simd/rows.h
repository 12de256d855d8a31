// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_ROWS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_ROWS_H
#undef SHADESCOPE_ROWS_H
#else
#define SHADESCOPE_ROWS_H
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "pipeline/buffers/block_buffer.h"
#include "pipeline/simd/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// Numbers of the pixels of a row of blocks. What shading computes goes from row to row in short loops, which keep what
// they work on in registers and find what others left in the nearest cache.
constexpr std::size_t kRowPixels = std::size_t(kBlocksAcross) * kBlockPixels;
constexpr std::size_t kRowVectors = kRowPixels / std::min<std::size_t>(16, HWY_LANES(float));
struct Row {
    alignas(64) float of[kRowPixels];
};
struct Row3 {
    Row x, y, z;
};
HWY_INLINE Floats load(const Row& from, std::size_t i) { return hn::Load(F(), from.of + i); }
HWY_INLINE Floats3 load(const Row3& from, std::size_t i) { return {load(from.x, i), load(from.y, i), load(from.z, i)}; }
HWY_INLINE void store(Floats v, Row& to, std::size_t i) { hn::Store(v, F(), to.of + i); }
HWY_INLINE void store(Floats3 v, Row3& to, std::size_t i) {
    store(v.x, to.x, i), store(v.y, to.y, i), store(v.z, to.z, i);
}
HWY_INLINE Floats3 choose(Mask mask, Floats3 yes, Floats3 no) {
    return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y), hn::IfThenElse(mask, yes.z, no.z)};
}

// Vectors of a row, and which of their pixels: as bits, for GCC aligns no memory that a container asks for to vectors
// wider than those it compiles for by default.
struct Group {
    std::size_t object = 0, count = 0;  // object: that all of the pixels are of, where that makes a difference
    std::size_t at[kRowVectors];
    std::uint32_t bits[kRowVectors];
    void add(std::size_t i, std::uint32_t pixels) { at[count] = i, bits[count++] = pixels; }
    HWY_INLINE Mask mask(std::size_t n) const { return maskOf(bits[n]); }
};

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
