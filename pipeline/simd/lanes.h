// Included once for each instruction set, by files that go through foreach_target.h: no include guard but this one.
#if defined(SHADESCOPE_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_LANES_H
#undef SHADESCOPE_LANES_H
#else
#define SHADESCOPE_LANES_H
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <span>

#include "pipeline/core/real.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// One number for each pixel; at most 16 lanes.
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
HWY_INLINE Floats3 where(Mask mask, Floats3 v) {
    return {hn::IfThenElseZero(mask, v.x), hn::IfThenElseZero(mask, v.y), hn::IfThenElseZero(mask, v.z)};
}
// Bit i is set for lane i.
HWY_INLINE std::uint32_t bitsOf(Mask mask) {
    std::uint64_t bits = 0;
    hn::StoreMaskBits(F(), mask, reinterpret_cast<std::uint8_t*>(&bits));
    return std::uint32_t(bits);
}
// The inverse of bitsOf.
HWY_INLINE Mask maskOf(std::uint64_t bits) {
    return hn::LoadMaskBits(F(), reinterpret_cast<const std::uint8_t*>(&bits));
}

// 4 words at an address for each lane, transposed: `of[i]` has word i of every lane. Loading whole addresses takes a
// fraction of the time of gathers, which load single words.
template <class D>
struct Fours {
    hn::Vec<D> of[4];
};
// place(l): the address of the words of lane l.
template <class D, class Place>
HWY_INLINE Fours<D> loadFours(D d, Place place) {
#if HWY_TARGET == HWY_SCALAR
    return {{hn::Load(d, place(0)), hn::Load(d, place(0) + 1), hn::Load(d, place(0) + 2), hn::Load(d, place(0) + 3)}};
#else
    constexpr std::size_t kLanes = hn::MaxLanes(d);
    static_assert(kLanes == 4 || kLanes == 8 || kLanes == 16);
    // Row i has lanes i, 4 + i, 8 + i and 12 + i side by side. After the transposition within each four, lane l is at
    // l.
    const auto row = [&](std::size_t i) HWY_ATTR {
        const hn::CappedTag<hn::TFromD<D>, 4> four;
        const hn::CappedTag<hn::TFromD<D>, 8> eight;
        if constexpr (kLanes == 4) {
            return hn::LoadU(four, place(i));
        } else {
            const auto pair = [&](std::size_t l) HWY_ATTR {
                return hn::Combine(eight, hn::LoadU(four, place(l + 4)), hn::LoadU(four, place(l)));
            };
            if constexpr (kLanes == 8)
                return pair(i);
            else
                return hn::Combine(d, pair(i + 8), pair(i));
        }
    };
    const hn::RepartitionToWide<D> wide;
    const auto lower = [&](auto one, auto two) HWY_ATTR { return hn::BitCast(wide, hn::InterleaveLower(d, one, two)); };
    const auto upper = [&](auto one, auto two) HWY_ATTR { return hn::BitCast(wide, hn::InterleaveUpper(d, one, two)); };
    const auto r0 = row(0), r1 = row(1), r2 = row(2), r3 = row(3);
    const auto low = lower(r0, r1), lowNext = lower(r2, r3), high = upper(r0, r1), highNext = upper(r2, r3);
    return {{hn::BitCast(d, hn::InterleaveLower(wide, low, lowNext)),
             hn::BitCast(d, hn::InterleaveUpper(wide, low, lowNext)),
             hn::BitCast(d, hn::InterleaveLower(wide, high, highNext)),
             hn::BitCast(d, hn::InterleaveUpper(wide, high, highNext))}};
#endif
}

// Loads a 3-vector for each lane. indexOf(l): its index for lane l.
template <class IndexOf>
HWY_INLINE Floats3 loadThrees(std::span<const Vec3<float>> values, IndexOf indexOf) {
    // A load of four reads the next vector's first number too; the last vector has no next one.
    const std::size_t last = values.size() - 1;
    const float end[4]{values[last].x, values[last].y, values[last].z, 0};
    const Fours<F> fours = loadFours(F(), [&](std::size_t l) {
        const std::size_t i = indexOf(l);
        return i == last ? end : &values[i].x;
    });
    return {fours.of[0], fours.of[1], fours.of[2]};
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
