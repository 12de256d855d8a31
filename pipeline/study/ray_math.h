#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "pipeline/core/real.h"

// The ray caster's own arithmetic. It shares none with the stages that it is a reference for, so that an error in one
// of the two shows. Real is double, or long double to find out how far double may be wrong.
namespace pipeline::rays {

template <class Real>
using Mat3 = glm::mat<3, 3, Real>;

template <class Real>
inline constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

template <class Real>
Real largest(Vec3<Real> v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

// v at length 1; (0, 0, 0) where it has no direction.
template <class Real>
Vec3<Real> unit(Vec3<Real> v) {
    const Real scale = largest(v);
    if (!(scale > 0) || !std::isfinite(scale)) return Vec3<Real>(0);
    v /= scale;
    return v / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

// Sine and cosine of degrees. The angle is brought to −180..180 in degrees, and multiples of 90 are exact.
template <class Real>
struct SinCos {
    Real sin, cos;
};
template <class Real>
SinCos<Real> sinCos(double degrees) {
    const double turn = std::remainder(degrees, 360.0);
    if (std::remainder(turn, 90.0) == 0) {
        const Real s = turn == 90 ? Real(1) : turn == -90 ? Real(-1) : Real(0);
        const Real c = turn == 0 ? Real(1) : std::abs(turn) == 180 ? Real(-1) : Real(0);
        return {s, c};
    }
    const Real radians = Real(turn) * std::numbers::pi_v<Real> / 180;
    return {std::sin(radians), std::cos(radians)};
}

}  // namespace pipeline::rays
