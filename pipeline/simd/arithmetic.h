// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_ARITHMETIC_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_ARITHMETIC_H
#undef SHADESCOPE_ARITHMETIC_H
#else
#define SHADESCOPE_ARITHMETIC_H
#endif

#include <bit>

#include "pipeline/core/numerics.h"
#include "pipeline/simd/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// The squared lengths for which `normalized` divides by the root without scaling. They are the squares of its bounds,
// with room for three components and for rounding, so the largest component is between the bounds.
template <class D>
HWY_INLINE hn::Mask<D> needsNoScaling(D d, hn::Vec<D> square) {
    constexpr float kMost = kLargestUnscaled * kLargestUnscaled, kLeast = 4 / kMost;
    return hn::And(hn::Lt(square, hn::Set(d, kMost)), hn::Gt(square, hn::Set(d, kLeast)));
}

// The two settings of `arithmetic`; kernels take them as A.

// Rounds every sum and product as the scalar stage does, in the same order, so the bits are the same.
struct Exact {
    static constexpr bool kExact = true;
    HWY_INLINE static Floats mulAdd(Floats a, Floats b, Floats c) { return hn::Add(hn::Mul(a, b), c); }
    HWY_INLINE static Floats negMulAdd(Floats a, Floats b, Floats c) { return hn::Sub(c, hn::Mul(a, b)); }
    HWY_INLINE static Floats dot(Floats3 a, Floats3 b) {
        return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
    }
    // normalized, for the lanes in mask; arbitrary numbers in the others.
    HWY_INLINE static Floats3 unit(Floats3 a, Mask mask) {
        const Floats square = dot(a, a);
        const Floats length = hn::Sqrt(square);
        const Floats3 out{hn::Div(a.x, length), hn::Div(a.y, length), hn::Div(a.z, length)};
        const Mask rest = hn::AndNot(needsNoScaling(F(), square), mask);
        return HWY_LIKELY(hn::AllFalse(F(), rest)) ? out : scaledUnit(a, out, rest);
    }

private:
    // Replaces the lanes of `out` that need scaling first.
    HWY_NOINLINE static Floats3 scaledUnit(Floats3 a, Floats3 out, Mask rest) {
        HWY_ALIGN float x[16], y[16], z[16];
        hn::Store(hn::IfThenElse(rest, a.x, out.x), F(), x);
        hn::Store(hn::IfThenElse(rest, a.y, out.y), F(), y);
        hn::Store(hn::IfThenElse(rest, a.z, out.z), F(), z);
        for (std::uint32_t bits = bitsOf(rest); bits != 0; bits &= bits - 1) {
            const int l = std::countr_zero(bits);
            const Vec3<float> v = normalized(Vec3<float>(x[l], y[l], z[l]));
            x[l] = v.x, y[l] = v.y, z[l] = v.z;
        }
        return {hn::Load(F(), x), hn::Load(F(), y), hn::Load(F(), z)};
    }
};

// Uses fused multiply-add where the CPU has it, and estimates with one Newton step.
struct Fast {
    static constexpr bool kExact = false;
    HWY_INLINE static Floats mulAdd(Floats a, Floats b, Floats c) { return hn::MulAdd(a, b, c); }
    HWY_INLINE static Floats negMulAdd(Floats a, Floats b, Floats c) { return hn::NegMulAdd(a, b, c); }
    HWY_INLINE static Floats dot(Floats3 a, Floats3 b) {
        return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
    }
    // Within 2^-22; (0, 0, 0) stays (0, 0, 0).
    HWY_INLINE static Floats3 unit(Floats3 a, Mask) {
        const Floats square = dot(a, a);
        const Floats estimate = hn::ApproximateReciprocalSqrt(square);
        const Floats inverse =
            hn::Mul(estimate, hn::NegMulAdd(hn::Mul(hn::Mul(all(0.5F), square), estimate), estimate, all(1.5F)));
        return scaled(a, hn::IfThenElseZero(hn::Gt(square, all(0)), inverse));
    }
};

// a s + b
template <class A>
HWY_INLINE Floats3 scaledPlus(Floats3 a, Floats s, Floats3 b) {
    return {A::mulAdd(a.x, s, b.x), A::mulAdd(a.y, s, b.y), A::mulAdd(a.z, s, b.z)};
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
