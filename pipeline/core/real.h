#pragma once
#include <glm/glm.hpp>

namespace pipeline {

// Real is the scalar that a stage computes in: float or double. It is the only template
// parameter of a stage; every other choice is a run-time setting, so that two precisions
// differ in nothing else.
template <class Real>
using Vec2 = glm::vec<2, Real>;
template <class Real>
using Vec3 = glm::vec<3, Real>;

// Scene data is double whatever a frame is computed in.
using Vec3d = glm::dvec3;
using Color8 = glm::u8vec3;  // sRGB frame buffer values, 0 to 255

}  // namespace pipeline
