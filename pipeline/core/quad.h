#pragma once
#include <cfloat>
#include <cmath>
#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace pipeline {

#if LDBL_MANT_DIG == 113  // long double is the type itself, as on 64-bit ARM
using Binary128 = long double;
#else
__extension__ using Binary128 = __float128;
#endif

// IEEE 754 binary128: 113 bits of significand, exponents to +-16383. What the stages are computed in
// to know the rounding error of double. A class because the compiler's own type has no numeric_limits,
// which glm asks for, and no overloads of the mathematical functions.
struct Quad {
    Binary128 value;

    Quad() = default;
    template <class T>
    requires std::is_arithmetic_v<T>
    constexpr Quad(T x) : value(x) {}
    template <class T>
    requires std::is_arithmetic_v<T>
    constexpr explicit operator T() const { return static_cast<T>(value); }
    static constexpr Quad of(Binary128 x) {
        Quad q{};
        q.value = x;
        return q;
    }

    constexpr Quad operator-() const { return of(-value); }
    constexpr Quad& operator+=(Quad b) { return value += b.value, *this; }
    constexpr Quad& operator-=(Quad b) { return value -= b.value, *this; }
    constexpr Quad& operator*=(Quad b) { return value *= b.value, *this; }
    constexpr Quad& operator/=(Quad b) { return value /= b.value, *this; }
    friend constexpr Quad operator+(Quad a, Quad b) { return of(a.value + b.value); }
    friend constexpr Quad operator-(Quad a, Quad b) { return of(a.value - b.value); }
    friend constexpr Quad operator*(Quad a, Quad b) { return of(a.value * b.value); }
    friend constexpr Quad operator/(Quad a, Quad b) { return of(a.value / b.value); }
    friend constexpr bool operator==(Quad a, Quad b) { return a.value == b.value; }
    friend constexpr bool operator<(Quad a, Quad b) { return a.value < b.value; }
    friend constexpr bool operator>(Quad a, Quad b) { return a.value > b.value; }
    friend constexpr bool operator<=(Quad a, Quad b) { return a.value <= b.value; }
    friend constexpr bool operator>=(Quad a, Quad b) { return a.value >= b.value; }
};

Quad abs(Quad x);
Quad sqrt(Quad x);
Quad acos(Quad x);
Quad exp(Quad x);
Quad exp2(Quad x);
Quad log2(Quad x);
Quad log1p(Quad x);
Quad pow(Quad x, Quad y);
Quad atan2(Quad y, Quad x);
Quad floor(Quad x);
Quad round(Quad x);
Quad frexp(Quad x, int* exponent);
Quad ldexp(Quad x, int exponent);
bool isfinite(Quad x);

// For any of the four arithmetics, without std:: in front; elementary.h has the others.
using std::abs;
using std::floor;
using std::frexp;
using std::isfinite;
using std::ldexp;
using std::round;
using std::sqrt;

}  // namespace pipeline

template <>
struct std::numeric_limits<pipeline::Quad> {
    static constexpr bool is_specialized = true, is_signed = true, is_integer = false, is_exact = false;
    static constexpr bool is_iec559 = true, has_infinity = true, has_quiet_NaN = true, is_bounded = true;
    static constexpr int radix = 2, digits = 113, digits10 = 33, max_digits10 = 36;
    static constexpr int min_exponent = -16381, max_exponent = 16384;
    static constexpr pipeline::Quad infinity() { return std::numeric_limits<double>::infinity(); }
    static constexpr pipeline::Quad quiet_NaN() { return std::numeric_limits<double>::quiet_NaN(); }
    static constexpr pipeline::Quad epsilon() { return 0x1p-112; }
};
