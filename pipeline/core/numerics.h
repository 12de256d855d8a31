#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/core/real.h"

namespace pipeline {

template <class Real>
Real largestComponent(Vec3<Real> v) {
    return std::max({abs(v.x), abs(v.y), abs(v.z)});
}

// v at length 1 within 2 rounding units, over the whole range of Real. The zero vector, and
// one with a component that is not finite, gives the zero vector: a direction that is not
// defined adds nothing wherever it is used.
template <class Real>
Vec3<Real> normalized(Vec3<Real> v) {
    const Real largest = largestComponent(v);
    if (!(largest > 0) || !isfinite(largest)) return Vec3<Real>(0);
    // A power of two brings the squares into range without rounding: a scaled scene keeps its bits.
    int exponent;
    frexp(largest, &exponent);
    const Vec3<Real> scaled{ldexp(v.x, -exponent), ldexp(v.y, -exponent), ldexp(v.z, -exponent)};
    const Real length = sqrt(glm::dot(scaled, scaled));
    return isfinite(length) ? scaled / length : Vec3<Real>(0);
}

// (a·b)^exponent for unit vectors with a·b > 0, else 0.
// a·b is 1 - q with q = |a - b|²/2. Near the centre of a highlight q keeps its digits while the
// dot product has rounded them away: at exponent 10^6 pow(a·b) in float errs by 0.15, this by 10^-7.
template <class Real>
Real powerOfCosine(Vec3<Real> a, Vec3<Real> b, Real exponent) {
    const Vec3<Real> difference = a - b;
    const Real q = glm::dot(difference, difference) / 2;
    if (!(q < 1)) return 0;
    return exp(exponent * log1p(-q));
}

// Whether powerOfCosine is certain to round to 0, without its exponential: −log1p(−q) >= q, and
// exp(x) is 0 below −103.98 in float, −745.14 in double, −11399.5 in long double and −11433.5 in Quad
// (half the smallest number above 0).
template <class Real>
bool powerVanishes(Vec3<Real> a, Vec3<Real> b, Real exponent) {
    constexpr int kDigits = std::numeric_limits<Real>::digits;
    constexpr Real kZero = kDigits == 24 ? 105 : kDigits == 53 ? 750 : 11500;
    const Vec3<Real> difference = a - b;
    return exponent * (glm::dot(difference, difference) / 2) > kZero;
}

// The angle between two vectors of any length, radians. acos of a dot product reads 0 below
// 0.006 degrees in float; this form keeps its digits at every angle.
// W. Kahan, "How futile are mindless assessments of roundoff", 2006.
template <class Real>
Real angleBetween(Vec3<Real> a, Vec3<Real> b) {
    return atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace pipeline
