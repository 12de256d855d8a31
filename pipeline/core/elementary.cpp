#include "pipeline/core/elementary.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "pipeline/core/power.h"

namespace pipeline {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

// A number as a sum of two that is not rounded; |rest| is at most half a unit in the last place of head.
struct Pair {
    double head, rest;
};

// Exact. D. E. Knuth, "The Art of Computer Programming 2", section 4.2.2, theorem B.
Pair sumOf(double a, double b) {
    const double sum = a + b, part = sum - a;
    return {sum, (a - (sum - part)) + (b - part)};
}
// Exact where |a| >= |b| or a = 0. T. J. Dekker, "A floating-point technique for extending the available precision",
// Numerische Mathematik 18, 1971.
Pair ordered(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}
// Exact where the product and its rest are normal numbers and |a|, |b| < 2^970. Dekker, as above.
Pair productOf(double a, double b) {
    constexpr double kSplit = 0x1p27 + 1;
    const double wideA = a * kSplit, headA = wideA - (wideA - a), restA = a - headA;
    const double wideB = b * kSplit, headB = wideB - (wideB - b), restB = b - headB;
    const double product = a * b;
    return {product, ((headA * headB - product) + headA * restB + restA * headB) + restA * restB};
}
// Within 2^-101 of the result, as the quotient.
Pair productOf(Pair a, Pair b) {
    const Pair product = productOf(a.head, b.head);
    return ordered(product.head, product.rest + (a.head * b.rest + a.rest * b.head));
}
Pair quotientOf(Pair a, Pair b) {
    const double quotient = a.head / b.head;
    const Pair product = productOf(quotient, b.head);
    return ordered(quotient, (((a.head - product.head) - product.rest) + a.rest - quotient * b.rest) / b.head);
}

// Polynomials of least relative error of the function that they are part of, by E. Remez' exchange ("Sur la détermination
// des polynômes d'approximation de degré donnée", Communications of the Kharkov Mathematical Society 1934), found with 60
// digits and rounded: (sin x − x) / x³, error 2^-57, and (cos x − 1 + x²/2) / x⁴, 2^-59, in x² <= (π/4)²;
// (atanh x − x − x³/3 − x⁵/5) / x⁷, 2^-71, in x² <= 0.1717²; (atan x − x) / x³, 2^-61, in x² <= 1/256.
constexpr std::array kSin{-0x1.5555555555555p-3,  0x1.111111111110bp-7,  -0x1.a01a01a018ae9p-13, 0x1.71de3a5339e7dp-19,
                          -0x1.ae645298e3181p-26, 0x1.6120931ac90ecp-33, -0x1.aaa5798d48bf2p-41};
constexpr std::array kCos{0x1.555555555554bp-5,   -0x1.6c16c16c14f91p-10, 0x1.a01a019c844bep-16,
                          -0x1.27e4f7eac2bb0p-22, 0x1.1ee9d7b3c3af9p-29,  -0x1.8fa4998919eebp-37};
constexpr std::array kAtanh{0x1.24924924927d5p-3, 0x1.c71c71c658814p-4, 0x1.745d17d859f8bp-4, 0x1.3b1377e665535p-4,
                            0x1.111ddb8adabedp-4, 0x1.de9c4033fbc59p-5, 0x1.e7f404d42e446p-5};
constexpr std::array kAtan{-0x1.5555555555555p-2, 0x1.999999999983cp-3,  -0x1.2492492405138p-3,
                           0x1.c71c6e7eb91e6p-4,  -0x1.74582667e6b4bp-4, 0x1.376a1898bf49cp-4};

// log(2); its head has 42 bits, so that the product with an exponent is exact.
constexpr Pair kLn2{0x1.62e42fefa38p-1, 0x1.ef35793c7673p-45};
constexpr Pair kLog2OfE{0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56};
constexpr Pair kHalfPi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54}, kPi{2 * kHalfPi.head, 2 * kHalfPi.rest};

// exp(r.head + r.rest) · 2^n, |r| <= log(2)/2.
double scaledExp(Pair r, int n) {
    const double beyond = r.head * r.head * polynomial(kExpTailInDouble, r.head);
    const Pair first = ordered(1, r.head);
    const double power = first.head + (first.rest + (beyond + (r.rest + r.rest * r.head)));
    if (std::abs(n) > 1000) return std::ldexp(power, n);
    return std::bit_cast<double>(std::bit_cast<std::int64_t>(power) + n * 0x10000000000000);
}

// exp(y.head + y.rest). W. Cody and W. Waite, "Software Manual for the Elementary Functions", 1980, chapter 6.
double expOf(Pair y) {
    if (y.head > 710) return kInfinity;
    if (y.head < -746) return 0;
    constexpr double kToWhole = 0x1.8p52;  // added to a small number, it rounds it to a whole one
    const double n = (y.head * kLog2OfE.head + kToWhole) - kToWhole;
    const Pair r = sumOf(y.head - n * kLn2.head, -n * kLn2.rest);
    return scaledExp(ordered(r.head, r.rest + y.rest), int(n));
}

// log of a number above 0 as n log(2) + rest.
struct Logarithm {
    double n;
    Pair rest;
};
Logarithm logarithmOf(double x) {
    int exponent;
    double m = std::frexp(x, &exponent);               // exact, also of what is below normal
    if (m < 0x1.6a09e667f3bcdp-1) m *= 2, --exponent;  // from sqrt(1/2) to sqrt(2)
    // log m = 2 atanh((m − 1) / (m + 1)). Terms that count above 2^-64 of it are pairs.
    const Pair s = quotientOf({m - 1, 0}, sumOf(m, 1)), z = productOf(s, s);
    constexpr Pair kThird{0x1.5555555555555p-2, 0x1.5555555555555p-56},
        kFifth{0x1.999999999999ap-3, -0x1.999999999999ap-57};
    const Pair fifth = ordered(kFifth.head, kFifth.rest + z.head * polynomial(kAtanh, z.head));
    const Pair fourth = productOf(z, fifth);
    const Pair third = sumOf(kThird.head, fourth.head);
    const Pair second = productOf(z, {third.head, third.rest + (kThird.rest + fourth.rest)});
    const Pair first = ordered(1, second.head);
    const Pair half = productOf(s, {first.head, first.rest + second.rest});
    return {double(exponent), {2 * half.head, 2 * half.rest}};
}

Pair logOf(double x) {
    const Logarithm l = logarithmOf(x);
    const Pair sum = sumOf(l.n * kLn2.head, l.rest.head);
    return ordered(sum.head, sum.rest + (l.n * kLn2.rest + l.rest.rest));
}

// atan(i / 8).
constexpr std::array<Pair, 9> kAtanOfEighths{{{0, 0},
                                              {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                              {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                              {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                              {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                              {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                              {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                              {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                              {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}}};

Pair difference(Pair a, Pair b) {
    const Pair sum = sumOf(a.head, -b.head);
    return ordered(sum.head, sum.rest + (a.rest - b.rest));
}

// The angle of (x, y), radians; x, y >= 0, not both 0, the larger within 2^±400.
Pair angleOf(Pair y, Pair x) {
    const bool steep = y.head > x.head;
    const Pair a = steep ? x : y, b = steep ? y : x;
    Pair angle{0, 0};
    if (a.head < b.head * 0x1p-60) {
        angle.head = a.head / b.head;  // atan t = t − t³/3 …
    } else {
        // With c the nearest eighth of a / b: atan(a / b) = atan c + atan((a − c b) / (b + c a)), the last within 1/16.
        const int eighths = int(a.head / b.head * 8 + 0.5);
        const double c = eighths / 8.0;
        const Pair cb = productOf(c, b.head), ca = productOf(c, a.head);
        const Pair numerator = sumOf(a.head, -cb.head), denominator = sumOf(b.head, ca.head);
        const Pair t = quotientOf(ordered(numerator.head, numerator.rest + (a.rest - cb.rest - c * b.rest)),
                                  ordered(denominator.head, denominator.rest + (b.rest + ca.rest + c * a.rest)));
        const Pair& atC = kAtanOfEighths[std::size_t(eighths)];
        const double square = t.head * t.head;
        const Pair sum = sumOf(atC.head, t.head);
        angle = ordered(sum.head, sum.rest + (atC.rest + (t.rest + t.head * square * polynomial(kAtan, square))));
    }
    return steep ? difference(kHalfPi, angle) : angle;
}

// log of a normal number above 0, within 2^-51.
double plainLog(double x) {
    const std::int64_t e = (std::bit_cast<std::int64_t>(x) - 0x3fe8000000000000) >> 52;  // the bits of 3/4
    const double m = std::bit_cast<double>(std::bit_cast<std::int64_t>(x) - e * 0x10000000000000);
    return logOfScaled(m - 1, double(e));
}

// The angle of (x, y), radians, within 2^-48; x, y >= 0, not both 0, their products normal.
double plainAngle(double y, double x) {
    const double a = std::fmin(x, y), b = std::fmax(x, y);
    const int eighths = int(a / b * 8 + 0.5);
    const double c = eighths / 8.0, t = (a - c * b) / (b + c * a), square = t * t;
    const double angle = kAtanOfEighths[std::size_t(eighths)].head + (t + t * square * polynomial(kAtan, square));
    return y > x ? kHalfPi.head - angle : angle;
}

double roundedAngle(Pair angle, bool backwards) {
    if (backwards) angle = difference(kPi, angle);
    return angle.head + angle.rest;
}

}  // namespace

double sinNearZero(double x, double rest) {
    const double square = x * x;
    return x + (x * square * polynomial(kSin, square) + rest * (1 - square / 2));
}

double cosNearZero(double x, double rest) {
    const Pair square = productOf(x, x);
    const Pair first = ordered(1, -square.head / 2);
    return first.head +
           (first.rest + (square.head * square.head * polynomial(kCos, square.head) - square.rest / 2 - x * rest));
}

double exp(double x) { return std::isnan(x) ? x : expOf({x, 0}); }

double exp2(double x) {
    if (std::isnan(x)) return x;
    if (x > 1025) return kInfinity;
    if (x < -1076) return 0;
    const double n = std::round(x);
    return scaledExp(productOf({x - n, 0}, {kLn2.head, kLn2.rest}), int(n));
}

double log(double x) {
    if (std::isnan(x) || x < 0) return kNaN;
    if (x == 0) return -kInfinity;
    if (x == kInfinity) return x;
    const Pair l = logOf(x);
    return l.head + l.rest;
}

double log2(double x) {
    if (std::isnan(x) || x < 0) return kNaN;
    if (x == 0) return -kInfinity;
    if (x == kInfinity) return x;
    const Logarithm l = logarithmOf(x);
    const Pair rest = productOf(l.rest, kLog2OfE), sum = sumOf(l.n, rest.head);
    return sum.head + (sum.rest + rest.rest);
}

double pow(double base, double exponent) {
    if (exponent == 0 || base == 1) return 1;
    if (std::isnan(base) || std::isnan(exponent)) return kNaN;
    const double size = std::abs(base);
    const bool whole = std::floor(exponent) == exponent;  // infinity too
    const bool odd = whole && std::abs(exponent) < 0x1p53 && std::fmod(exponent, 2) != 0;
    const double sign = odd && std::signbit(base) ? -1 : 1;
    if (size == 0) return exponent < 0 ? sign * kInfinity : sign * 0;
    if (size == 1) return whole ? sign : kNaN;  // of -1
    if (std::isinf(exponent)) return (exponent > 0) == (size > 1) ? kInfinity : 0;
    if (std::isinf(size)) return exponent > 0 ? sign * kInfinity : sign * 0;
    if (base < 0 && !whole) return kNaN;
    // |log size| >= 2^-53: beyond 2^64 the power is 0 or infinite, whatever the exponent.
    const Pair l = logOf(size);
    const double n = std::fmax(-0x1p64, std::fmin(exponent, 0x1p64));
    return sign * expOf(productOf({n, 0}, l));
}

double atan2(double y, double x) {
    if (std::isnan(x) || std::isnan(y)) return kNaN;
    double up = std::abs(y), across = std::abs(x);
    if (std::isinf(up) || std::isinf(across)) up = std::isinf(up), across = std::isinf(across);
    Pair angle{0, 0};
    if (up != 0) {
        const double larger = std::fmax(up, across);
        if (larger > 0x1p400 || larger < 0x1p-400) {
            // By a power of two, exactly; what underflows is too small beside the other.
            int exponent;
            std::frexp(larger, &exponent);
            up = std::ldexp(up, 300 - exponent), across = std::ldexp(across, 300 - exponent);
        }
        angle = angleOf({up, 0}, {across, 0});
    }
    return std::copysign(roundedAngle(angle, std::signbit(x)), y);
}

float log2(float x) {
    if (!(x > 0 && std::isfinite(x))) return float(log2(double(x)));
    return float(plainLog(double(x)) * kLog2OfE.head);
}

float pow(float base, float exponent) {
    if (!(base > 0 && std::isfinite(base) && std::isfinite(exponent)))
        return float(pow(double(base), double(exponent)));
    return float(expOf({double(exponent) * plainLog(double(base)), 0}));
}

float atan2(float y, float x) {
    if (!(std::isfinite(x) && std::isfinite(y)) || (x == 0 && y == 0)) return float(atan2(double(y), double(x)));
    const double angle = plainAngle(std::abs(double(y)), std::abs(double(x)));
    return std::copysign(float(std::signbit(x) ? kPi.head - angle : angle), y);
}

float acos(float x) {
    if (!(std::abs(x) < 1)) return float(acos(double(x)));
    const double angle = plainAngle(std::sqrt((1 - double(x)) * (1 + double(x))), std::abs(double(x)));
    return float(x < 0 ? kPi.head - angle : angle);
}

double acos(double x) {
    if (!(std::abs(x) <= 1)) return kNaN;
    // atan2(sqrt((1 − x)(1 + x)), x), with both factors and the root as pairs.
    const Pair square = productOf(sumOf(1, -x), sumOf(1, x));
    const double root = std::sqrt(square.head);
    if (root == 0) return x < 0 ? kPi.head : 0;
    const Pair of = productOf(root, root);
    const double rest = (((square.head - of.head) - of.rest) + square.rest) / (2 * root);
    return roundedAngle(angleOf(ordered(root, rest), {std::abs(x), 0}), std::signbit(x) && x != 0);
}

}  // namespace pipeline
