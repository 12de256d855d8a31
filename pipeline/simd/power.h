// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_POWER_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_POWER_H
#undef SHADESCOPE_POWER_H
#else
#define SHADESCOPE_POWER_H
#endif

#include "pipeline/core/power.h"
#include "pipeline/simd/arithmetic.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// The functions of pipeline/core/power.h with SIMD.

template <class A, std::size_t kCount>
HWY_INLINE Floats polynomial(const std::array<float, kCount>& c, Floats x) {
    const Floats square = hn::Mul(x, x);
    Floats even = all(c[(kCount - 1) / 2 * 2]), odd = all(c[(kCount - 2) / 2 * 2 + 1]);
    for (std::size_t i = (kCount - 1) / 2 * 2; i >= 2; i -= 2) even = A::mulAdd(even, square, all(c[i - 2]));
    for (std::size_t i = (kCount - 2) / 2 * 2 + 1; i >= 3; i -= 2) odd = A::mulAdd(odd, square, all(c[i - 2]));
    return A::mulAdd(odd, x, even);
}

template <class A>
HWY_INLINE Floats logOneMinus(Floats q) {
    const I whole;
    const Ints bits = hn::BitCast(whole, hn::Sub(all(1), q));
    const Ints exponent = hn::ShiftRight<23>(hn::Sub(bits, hn::Set(whole, 0x3f400000)));
    const Floats k = hn::BitCast(F(), hn::Sub(hn::Set(whole, 0x3f800000), hn::ShiftLeft<23>(exponent)));
    const Floats r = A::negMulAdd(k, q, hn::Sub(k, all(1))), e = hn::ConvertTo(F(), exponent);
    const Floats log = A::mulAdd(hn::Mul(r, r), polynomial<A>(kLogTail, r), r);
    return A::mulAdd(e, all(kLog2Head), A::mulAdd(e, all(kLog2Rest), log));
}

template <class A>
HWY_INLINE Floats expOfNegative(Floats y) {
    const Mask normal = hn::Ge(y, all(kSmallestExponent));
    y = hn::IfThenElseZero(normal, y);
    const Floats above = A::mulAdd(y, all(1.44269504F), all(kToWhole)), times = hn::Sub(above, all(kToWhole));
    const Floats f = A::negMulAdd(times, all(kLog2Rest), A::negMulAdd(times, all(kLog2Head), y));
    const Floats power = hn::Add(A::mulAdd(hn::Mul(f, f), polynomial<A>(kExpTail, f), f), all(1));
    return hn::IfThenElseZero(
        normal, hn::BitCast(F(), hn::Add(hn::BitCast(I(), power), hn::ShiftLeft<23>(hn::BitCast(I(), above)))));
}

// |a - b|²/2 = 1 - a·b, for unit vectors.
template <class A>
HWY_INLINE Floats halfSquare(Floats3 a, Floats3 b) {
    const Floats3 difference = a - b;
    return hn::Mul(all(0.5F), A::dot(difference, difference));
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
