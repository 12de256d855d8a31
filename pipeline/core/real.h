#pragma once
#include <glm/glm.hpp>
#include <limits>
#include <type_traits>

#include "pipeline/core/quad.h"

namespace pipeline {

// Real is the scalar that a stage computes in: float, double, long double or Quad. It is the only
// template parameter of a stage; every other choice is a run-time setting, so that two precisions
// differ in nothing else.
template <class Real>
using Vec2 = glm::vec<2, Real>;
template <class Real>
using Vec3 = glm::vec<3, Real>;

// For what float is never precise enough for: projection, clipping, depths.
template <class Real>
using AtLeastDouble = std::conditional_t<(std::numeric_limits<Real>::digits > 53), Real, double>;

// Scene data is double whatever a frame is computed in.
using Vec3d = glm::dvec3;
using Color8 = glm::u8vec3;  // sRGB frame buffer values, 0 to 255

// What a stage's .cpp ends with: its functions for every Real, by a macro that takes one.
#define SHADESCOPE_FOR_EVERY_REAL(INSTANTIATE) \
    INSTANTIATE(float)                         \
    INSTANTIATE(double)                        \
    INSTANTIATE(long double)                   \
    INSTANTIATE(Quad)

}  // namespace pipeline
