// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_POWER_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_POWER_H
#undef SHADESCOPE_POWER_H
#else
#define SHADESCOPE_POWER_H
#endif

#include "pipeline/fast/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// |a - b|²/2 = 1 - a·b, of unit vectors.
HWY_INLINE Floats halfSquare(Floats3 a, Floats3 b) {
    const Floats3 difference = a - b;
    return hn::Mul(all(0.5F), dot(difference, difference));
}

// log(1 - q), q in [0, 1): 1 - q is 2^e m with m in [0.75, 1.5), and m - 1 is -q itself where e is 0, so that the centre
// of a highlight keeps its digits. The polynomial interpolates log(1 + r)/r at the Chebyshev nodes of [-0.25, 0.5],
// within 3.1e-8 of it.
HWY_INLINE Floats logOfRest(Floats q) {
    const I whole;
    const Ints bits = hn::BitCast(whole, hn::Sub(all(1), q));
    const Ints e = hn::ShiftRight<23>(hn::Sub(bits, hn::Set(whole, 0x3f400000)));  // the bits of 0.75
    const Floats m = hn::BitCast(F(), hn::Sub(bits, hn::ShiftLeft<23>(e)));
    const Floats r = hn::IfThenElse(hn::Lt(q, all(0.25F)), hn::Neg(q), hn::Sub(m, all(1)));
    Floats p = all(0.0529510641F);
    for (const float c : {-0.11956825F, 0.149728972F, -0.16835696F, 0.199790331F, -0.249929166F, 0.333335028F,
                          -0.500000687F, 0.999999998F})
        p = hn::MulAdd(p, r, all(c));
    return hn::MulAdd(hn::ConvertTo(F(), e), all(0.693147181F), hn::Mul(r, p));
}

// exp(y), y <= 0; below 2^-126 that. The polynomial interpolates 2^f at the Chebyshev nodes of [-0.5, 0.5], within
// 1.1e-7 of it.
HWY_INLINE Floats expOfNegative(Floats y) {
    const Floats t = hn::Max(hn::Mul(y, all(1.44269504F)), all(-126));
    const Ints n = hn::NearestInt(t);
    const Floats f = hn::Sub(t, hn::ConvertTo(F(), n));
    Floats p = all(0.00133908634F);
    for (const float c : {0.00967603192F, 0.0555035711F, 0.240221075F, 0.693147188F, 1.0F})
        p = hn::MulAdd(p, f, all(c));
    return hn::BitCast(F(), hn::Add(hn::BitCast(I(), p), hn::ShiftLeft<23>(n)));
}

// (a·b)^exponent where `counts` says so and a·b > 0, else 0: powerOfCosine's form. q: halfSquare(a, b).
HWY_INLINE Floats powerOfCosines(Floats q, Floats exponent, Mask counts) {
    const Mask valid = hn::And(counts, hn::Lt(q, all(1)));
    const Floats small = hn::IfThenElseZero(valid, q);
    return hn::IfThenElseZero(valid, expOfNegative(hn::Mul(exponent, logOfRest(small))));
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
