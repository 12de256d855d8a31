#pragma once
#include <cstdint>

#include "pipeline/core/numerics.h"
#include "pipeline/stages/view.h"

namespace pipeline {

// Σ b_i values[v_i] over a triangle's corners; differences from corner 0, so that equal values
// stay what they are. Values: any array of Vec3<Real>.
template <class Values, class Real>
Vec3<Real> interpolated(const Values& values, const std::uint32_t (&v)[3], Vec3<Real> b) {
    const Vec3<Real> origin = values[v[0]];
    return origin + b.y * (values[v[1]] - origin) + b.z * (values[v[2]] - origin);
}

// V at a world-space point: towards the eye, or against the viewing direction in an orthographic view.
template <class Real>
Vec3<Real> towardsEye(const View& view, Vec3<Real> position, UnitForm unit = UnitForm::Scaled) {
    return view.perspective ? normalized(Vec3<Real>(view.eye) - position, unit) : -Vec3<Real>(view.forward);
}

}  // namespace pipeline
