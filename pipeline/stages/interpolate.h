#pragma once
#include <cstdint>

#include "pipeline/core/numerics.h"
#include "pipeline/scene/view.h"

namespace pipeline {

// Σ b_i values[v_i] over a triangle's corners; differences from corner 0, so that equal values
// stay what they are. Values: any array of Vec3<Real>.
template <class Values, class Real>
Vec3<Real> interpolated(const Values& values, const std::uint32_t (&v)[3], Vec3<Real> b) {
    const Vec3<Real> origin = values[v[0]];
    return origin + b.y * (values[v[1]] - origin) + b.z * (values[v[2]] - origin);
}

// The rays from an eye through the centres of pixels, which run along forward + x right − y up, where x and y are the
// pixel's column and row, and what first adds, times step: at z_view = 1.
template <class Real>
struct PixelRays {
    Vec3<Real> right, up, forward;
    Vec2<Real> first, step;
    explicit PixelRays(const View& view)
        : right(view.right), up(view.up), forward(view.forward), first(0.5 - view.centre), step(1.0 / view.scale) {}
};

// V at a world-space point: towards the eye, or against the viewing direction in an orthographic view.
template <class Real>
Vec3<Real> towardsEye(const View& view, Vec3<Real> position, UnitForm unit = UnitForm::Scaled) {
    return view.perspective ? normalized(Vec3<Real>(view.eye) - position, unit) : -Vec3<Real>(view.forward);
}

// V of what a pixel shows: back along the ray through its centre. The difference of eye and surface would say the same
// with the digits that are left of it.
template <class Real>
Vec3<Real> towardsEye(const View& view, glm::ivec2 pixel, UnitForm unit = UnitForm::Scaled) {
    if (!view.perspective) return -Vec3<Real>(view.forward);
    const PixelRays<Real> rays(view);
    const Vec2<Real> at = (Vec2<Real>(pixel) + rays.first) * rays.step;
    return normalized((at.y * rays.up - rays.forward) - at.x * rays.right, unit);
}

}  // namespace pipeline
