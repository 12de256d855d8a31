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

// Numbers of the pixels of a row of blocks. Shading works in short loops over a row. Each loop keeps its data in
// registers and finds the results of earlier loops in the nearest cache.
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

// Vectors of a row with a mask of lanes for each. The masks are bits, because GCC does not align containers for vectors
// wider than its default.
struct Group {
    std::size_t object = 0, count = 0;  // object: that of all its pixels, if objects are told apart
    std::size_t at[kRowVectors];
    std::uint32_t bits[kRowVectors];
    void add(std::size_t i, std::uint32_t pixels) { at[count] = i, bits[count++] = pixels; }
    HWY_INLINE Mask mask(std::size_t n) const { return maskOf(bits[n]); }
};

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
