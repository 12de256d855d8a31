#pragma once
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "pipeline/core/elementary.h"
#include "pipeline/core/real.h"

namespace pipeline {

// The two halves of a power (1 − q)^n = exp(n log(1 − q)). In float and double they are written out in operations that
// IEEE 754 rounds alike everywhere, so that a picture has the same bits on every machine and in every width of vectors
// (pipeline/simd/power.h is the text in float, many numbers at a time); elementary.h has the other functions. Extended and
// quad precision take the library's.

// (log(1 + r) − r) / r², r in [−1/4, 1/2), and (exp(f) − 1 − f) / f², |f| <= log(2)/2, from the constant on: minimax of
// the relative error of log and exp, 4.8e-9 and 3.1e-9. E. Remez, "Sur la détermination des polynômes d'approximation
// de degré donnée", Communications of the Kharkov Mathematical Society 1934.
inline constexpr std::array kLogTail{-0.5F,        0.333334535F,  -0.250000536F, 0.199906066F,  -0.166477665F,
                                     0.144820601F, -0.131622344F, 0.104483463F,  -0.0449097498F};
inline constexpr std::array kExpTail{0.49999994F, 0.166665211F, 0.0416683890F, 0.00836871006F, 0.00138146104F};
// log(2) in two parts; a whole number up to 127 times the first is exact. W. Cody and W. Waite, "Software Manual for the
// Elementary Functions", 1980.
inline constexpr float kLog2Head = 0x1.62e3p-1F, kLog2Rest = 0x1.2fefa4p-17F;
// Added to a number below 2^22, it rounds it to a whole one, which is in the last bits of the sum.
inline constexpr float kToWhole = 0x1.8p23F;
// Powers below exp of this are 0: below exp(−87.34) they are no longer normal.
inline constexpr float kSmallestExponent = -87;

// In double: with s = r / (2 + r), r in [−1/4, 1/2), (log(1 + r) − 2 s) / s³ in s², and (exp(f) − 1 − f) / f², minimax
// of the relative error too, 2^-61 and 2^-60, found with 60 digits and rounded.
inline constexpr std::array kLogTailInDouble{0x1.555555555554fp-1, 0x1.999999999c0f8p-2, 0x1.24924921ec050p-2,
                                             0x1.c71c7488dd81dp-3, 0x1.745c4c7a4665ap-3, 0x1.3b358bb9a7b27p-3,
                                             0x1.0dcf1372e2521p-3, 0x1.1b69ec5080c20p-3};
inline constexpr std::array kExpTailInDouble{0.5,
                                             0x1.555555555555bp-3,
                                             0x1.5555555555503p-5,
                                             0x1.111111110ec66p-7,
                                             0x1.6c16c16c3043fp-10,
                                             0x1.a01a01b37aa1dp-13,
                                             0x1.a01a01369c919p-16,
                                             0x1.71ddf029e899bp-19,
                                             0x1.27e5b43c67741p-22,
                                             0x1.af6bd7d2bb40bp-26,
                                             0x1.1e3d25256c8ddp-29};
// A whole number up to 2^21 times the first is exact.
inline constexpr double kLog2HeadInDouble = 0x1.62e42feep-1, kLog2RestInDouble = 0x1.a39ef35793c76p-33;
inline constexpr double kToWholeInDouble = 0x1.8p52;
// exp(−708.4) is the last normal one.
inline constexpr double kSmallestExponentInDouble = -708;

// Its even and its odd powers apart: two short chains of operations, where Horner's rule has one long one.
template <class Real, std::size_t kCount>
Real polynomial(const std::array<Real, kCount>& c, Real x) {
    const Real square = x * x;
    Real even = c[(kCount - 1) / 2 * 2], odd = c[(kCount - 2) / 2 * 2 + 1];
    for (std::size_t i = (kCount - 1) / 2 * 2; i >= 2; i -= 2) even = even * square + c[i - 2];
    for (std::size_t i = (kCount - 2) / 2 * 2 + 1; i >= 3; i -= 2) odd = odd * square + c[i - 2];
    return odd * x + even;
}

// log(1 − q), 0 <= q < 1, within 1.2 units in the last place.
inline float logOneMinus(float q) {
    // 1 − q = 2^e (1 + r). From q itself r has no rounding, so that the centre of a highlight keeps its digits.
    const std::int32_t e = (std::bit_cast<std::int32_t>(1 - q) - 0x3f400000) >> 23;  // the bits of 3/4
    const float k = std::bit_cast<float>(0x3f800000 - e * 0x800000);                 // 2^-e
    const float r = (k - 1) - k * q;
    return float(e) * kLog2Head + (float(e) * kLog2Rest + (r + r * r * polynomial(kLogTail, r)));
}
// log((1 + r) 2^e), r in [−1/4, 1/2), within 0.9 units where r is exact. log(1 + r) = 2 atanh(s) = r − s (r − (log(1 + r) − 2 s) / s), and r − s r is r − r²/2 + s r²/2: what
// r²/2 takes off is small beside r.
inline double logOfScaled(double r, double e) {
    const double s = r / (2 + r), square = s * s, half = r * r / 2;
    const double tail = s * (half + square * polynomial(kLogTailInDouble, square));
    return e * kLog2HeadInDouble + (r - (half - (tail + e * kLog2RestInDouble)));
}
// Within 0.9 units.
inline double logOneMinus(double q) {
    const std::int64_t e = (std::bit_cast<std::int64_t>(1 - q) - 0x3fe8000000000000) >> 52;  // the bits of 3/4
    const double k = std::bit_cast<double>(0x3ff0000000000000 - e * 0x10000000000000);       // 2^-e
    return logOfScaled((k - 1) - k * q, double(e));
}
template <class Real>
Real logOneMinus(Real q) {
    return log1p(-q);
}

// exp(y), y <= 0, within 1.2 units in the last place; 0 below kSmallestExponent.
inline float expOfNegative(float y) {
    if (!(y >= kSmallestExponent)) return 0;
    const float above = y * 1.44269504F + kToWhole;  // y / log(2), to the nearest, in the last bits
    const float n = above - kToWhole;
    const float f = (y - n * kLog2Head) - n * kLog2Rest;
    const float power = 1 + (f + f * f * polynomial(kExpTail, f));
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(power) + (std::bit_cast<std::uint32_t>(above) << 23));
}
// Within 0.75 units.
inline double expOfNegative(double y) {
    if (!(y >= kSmallestExponentInDouble)) return 0;
    const double above = y * 0x1.71547652b82fep+0 + kToWholeInDouble, n = above - kToWholeInDouble;
    const double head = y - n * kLog2HeadInDouble, rest = n * kLog2RestInDouble, f = head - rest;
    const double lost = (head - f) - rest;  // of f
    const double one = 1 + f;
    const double power = one + ((f - (one - 1)) + (f * f * polynomial(kExpTailInDouble, f) + lost));
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(power) + (std::bit_cast<std::uint64_t>(above) << 52));
}
template <class Real>
Real expOfNegative(Real y) {
    return exp(y);
}

}  // namespace pipeline
