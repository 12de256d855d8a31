#pragma once
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "pipeline/core/real.h"

namespace pipeline {

// The two halves of a power (1 − q)^n = exp(n log(1 − q)). In float they are written out in operations that IEEE 754
// rounds alike everywhere, so that a picture has the same bits on every machine and in every width of vectors
// (pipeline/simd/power.h is the same text, many numbers at a time). The other precisions take the library's.

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

// Its even and its odd powers apart: two short chains of operations, where Horner's rule has one long one.
template <std::size_t kCount>
float polynomial(const std::array<float, kCount>& c, float x) {
    const float square = x * x;
    float even = c[(kCount - 1) / 2 * 2], odd = c[(kCount - 2) / 2 * 2 + 1];
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
template <class Real>
Real expOfNegative(Real y) {
    return exp(y);
}

}  // namespace pipeline
