// Included once for each instruction set, by files that go through foreach_target.h: no include guard but this one.
#if defined(SHADESCOPE_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_LANES_H
#undef SHADESCOPE_LANES_H
#else
#define SHADESCOPE_LANES_H
#endif

#include <hwy/highway.h>

#include "pipeline/core/real.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// One number a pixel; at most 16 of them.
using F = hn::CappedTag<float, 16>;
using I = hn::RebindToSigned<F>;
using U = hn::RebindToUnsigned<F>;
using Floats = hn::Vec<F>;
using Ints = hn::Vec<I>;
using Mask = hn::Mask<F>;

struct Floats3 {
    Floats x, y, z;
};

HWY_INLINE Floats all(float value) { return hn::Set(F(), value); }
HWY_INLINE Floats3 all(Vec3<float> v) { return {all(v.x), all(v.y), all(v.z)}; }
HWY_INLINE Floats3 operator-(Floats3 a, Floats3 b) { return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)}; }
HWY_INLINE Floats3 operator+(Floats3 a, Floats3 b) { return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)}; }
HWY_INLINE Floats3 scaled(Floats3 a, Floats s) { return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)}; }
HWY_INLINE Mask asFloats(hn::Mask<I> mask) { return hn::RebindMask(F(), mask); }
// Bit i: of lane i.
HWY_INLINE std::uint32_t bitsOf(Mask mask) {
    std::uint64_t bits = 0;
    hn::StoreMaskBits(F(), mask, reinterpret_cast<std::uint8_t*>(&bits));
    return std::uint32_t(bits);
}
// And back.
HWY_INLINE Mask maskOf(std::uint64_t bits) {
    return hn::LoadMaskBits(F(), reinterpret_cast<const std::uint8_t*>(&bits));
}

// The 3-vectors at `index` of an array of them.
HWY_INLINE Floats3 gather(const std::vector<Vec3<float>>& values, Ints index) {
    const float* base = &values[0].x;
    const Ints at = hn::Add(index, hn::Add(index, index));
    const Ints one = hn::Set(I(), 1);
    return {hn::GatherIndex(F(), base, at), hn::GatherIndex(F(), base, hn::Add(at, one)),
            hn::GatherIndex(F(), base, hn::Add(at, hn::Add(one, one)))};
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
