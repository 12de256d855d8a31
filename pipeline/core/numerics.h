#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

#include "pipeline/core/elementary.h"
#include "pipeline/core/forms.h"
#include "pipeline/core/power.h"
#include "pipeline/core/real.h"

namespace pipeline {

template <class Real>
Real largestComponent(Vec3<Real> v) {
    return std::max({abs(v.x), abs(v.y), abs(v.z)});
}

// Between this and its inverse squares need no scaling: what underflows is too small to count, and the bits are those of
// the scaled form, but for components that are no longer normal in a vector of length 1.
inline constexpr float kLargestUnscaled = 0x1p30F;

// v at length 1 within 2 rounding units, over the whole range of Real. The zero vector, and
// one with a component that is not finite, gives the zero vector: a direction that is not
// defined adds nothing wherever it is used.
template <class Real>
Vec3<Real> normalized(Vec3<Real> v) {
    const Real largest = largestComponent(v), square = glm::dot(v, v);
    // The largest may be a number although another component is none.
    if (largest < Real(kLargestUnscaled) && largest > Real(1 / kLargestUnscaled) && isfinite(square))
        return v / sqrt(square);
    if (!(largest > 0) || !isfinite(largest)) return Vec3<Real>(0);
    // A power of two brings the squares into range without rounding: a scaled scene keeps its bits.
    int exponent;
    frexp(largest, &exponent);
    const Vec3<Real> scaled{ldexp(v.x, -exponent), ldexp(v.y, -exponent), ldexp(v.z, -exponent)};
    const Real length = sqrt(glm::dot(scaled, scaled));
    return isfinite(length) ? scaled / length : Vec3<Real>(0);
}

// How far a vector's square is from 1.
inline double offUnit(Vec3d v) { return std::abs(glm::dot(v, v) - 1); }
// What it may be for a vector that has length 1 as far as Real can tell: rounding the components of one changes its square
// by at most sqrt(3) half units in the last place of 1, and in double to find the square by as much again.
template <class Real>
inline constexpr double kOffUnit = 2 * double(std::numeric_limits<Real>::epsilon());

// (a·b)^exponent for unit vectors with a·b > 0, else 0.
// a·b is 1 - q with q = |a - b|²/2. Near the centre of a highlight q keeps its digits while the
// dot product has rounded them away: at exponent 10^6 pow(a·b) in float errs by 0.15, this by 10^-7.
template <class Real>
Real powerOfCosine(Vec3<Real> a, Vec3<Real> b, Real exponent) {
    const Vec3<Real> difference = a - b;
    const Real q = glm::dot(difference, difference) / 2;
    if (!(q < 1)) return 0;
    return expOfNegative(exponent * logOneMinus(q));
}

// 1 / sqrt(x) for an x of about 1, from its bits as a double or float, and after as many of Newton's steps as are asked
// for: within 3.44 %, 0.176 % and 4.8e-6 with none, one and two. The same on every machine.
// C. Lomont, "Fast inverse square root", Purdue University 2003.
template <class Real>
Real inverseSquareRoot(Real x, int steps) {
    Real guess;
    if constexpr (std::is_same_v<Real, float>)
        guess = std::bit_cast<float>(0x5f375a86u - (std::bit_cast<std::uint32_t>(x) >> 1));
    else
        guess = Real(std::bit_cast<double>(0x5fe6eb50c7b537a9u - (std::bit_cast<std::uint64_t>(double(x)) >> 1)));
    for (int i = 0; i < steps; ++i) guess *= Real(1.5) - x / 2 * guess * guess;
    return guess;
}

// v at length 1 in one of its forms; the zero vector where a form fails.
template <class Real>
Vec3<Real> normalized(Vec3<Real> v, UnitForm form) {
    if (form == UnitForm::Scaled) return normalized(v);
    if (form == UnitForm::Direct) {
        const Vec3<Real> unit = v / sqrt(glm::dot(v, v));
        return isfinite(unit.x) && isfinite(unit.y) && isfinite(unit.z) ? unit : Vec3<Real>(0);
    }
    const Real largest = largestComponent(v);
    if (!(largest > 0) || !isfinite(largest)) return Vec3<Real>(0);
    int exponent;
    frexp(largest, &exponent);
    const Vec3<Real> scaled{ldexp(v.x, -exponent), ldexp(v.y, -exponent), ldexp(v.z, -exponent)};
    const int steps = form == UnitForm::Estimate ? 0 : form == UnitForm::Newton ? 1 : 2;
    const Real square = glm::dot(scaled, scaled);
    return isfinite(square) ? scaled * inverseSquareRoot(square, steps) : Vec3<Real>(0);
}

// base^exponent for a whole exponent >= 0.
template <class Real>
Real powerBySquaring(Real base, std::int64_t exponent) {
    Real power = 1;
    for (; exponent > 0; exponent >>= 1, base *= base)
        if (exponent & 1) power *= base;
    return power;
}

// What a power grows to at most where rounding left a·b above 1: products with intensities stay finite.
inline constexpr double kLargestPower = 1e18;

// (a·b)^exponent in one of its forms, 0 to kLargestPower; exponent >= 0.
template <class Real>
Real powerOfCosine(Vec3<Real> a, Vec3<Real> b, Real exponent, PowerForm form) {
    if (form == PowerForm::Log1p) return powerOfCosine(a, b, exponent);
    const Real t = glm::dot(a, b);
    if (!(t > 0)) return 0;
    Real power = 0;
    switch (form) {
        case PowerForm::Log1p: break;
        case PowerForm::Pow: power = pow(t, exponent); break;
        case PowerForm::Squaring: power = powerBySquaring(t, std::int64_t(double(exponent) + 0.5)); break;
        case PowerForm::Exp2: power = exp2(exponent * log2(t)); break;
        case PowerForm::Schlick: {
            const Real within = std::min(t, Real(1));
            power = within / (exponent - exponent * within + within);
            break;
        }
        case PowerForm::Gaussian: power = exp(exponent * (t - 1)); break;
    }
    return std::min(power, Real(kLargestPower));
}

// Whether powerOfCosine is certain to be 0, without its exponential, where exponent · |a - b|²/2 is above this:
// −log(1 − q) >= q, and exp(x) is 0 below −87 in float (expOfNegative), −745.14 in double, −11399.5 in long double and
// −11433.5 in Quad (half the smallest number above 0).
template <class Real>
inline constexpr Real kVanishing = std::numeric_limits<Real>::digits == 24   ? 88
                                   : std::numeric_limits<Real>::digits == 53 ? 750
                                                                             : 11500;
// And from which n q on it is less than half a unit in the last place of what it is added to, where its factor is at
// most exp(logContrast) times that. The hundredth is more than all roundings make of it.
template <class Real>
Real vanishesFrom(double logContrast) {
    return std::min(kVanishing<Real>,
                    Real(logContrast + (std::numeric_limits<Real>::digits + 2) * std::numbers::ln2 + 0.01));
}
// from: the n q from which on a power counts as nothing.
template <class Real>
bool powerVanishes(Vec3<Real> a, Vec3<Real> b, Real exponent, Real from = kVanishing<Real>) {
    const Vec3<Real> difference = a - b;
    return exponent * (glm::dot(difference, difference) / 2) > from;
}

// The angle between two vectors of any length, radians. acos of a dot product reads 0 below
// 0.006 degrees in float; this form keeps its digits at every angle.
// W. Kahan, "How futile are mindless assessments of roundoff", 2006.
template <class Real>
Real angleBetween(Vec3<Real> a, Vec3<Real> b) {
    return atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// The angle between two unit vectors in one of its forms, radians.
template <class Real>
Real angleBetween(Vec3<Real> a, Vec3<Real> b, CornerAngleForm form) {
    if (form == CornerAngleForm::Atan2) return angleBetween(a, b);
    return acos(std::clamp(glm::dot(a, b), Real(-1), Real(1)));
}

}  // namespace pipeline
