#pragma once
#include <array>

#include "pipeline/core/triangle_tree.h"
#include "pipeline/scene/mesh/shape.h"
#include "pipeline/study/ray_math.h"

namespace pipeline::rays {

// The true surfaces of the built-in shapes, in their own space: scene/shape.h says which.

// Where a ray goes through a surface, and the outward normal there, of any length.
template <class Real>
struct Crossing {
    Real t = 0;
    Vec3<Real> normal{0};
};

// In the order of t, also behind the ray's origin.
template <class Real>
struct Crossings {
    std::array<Crossing<Real>, 4> at{};
    int count = 0;
    void add(Real t, Vec3<Real> normal) { at[std::size_t(count++)] = {t, normal}; }
};

// All but the teapot, whose bicubic patches have no closed form.
constexpr bool hasClosedForm(ShapeKind kind) { return kind != ShapeKind::Teapot; }
// A ray that starts on its surface and leaves it outwards meets it no more.
constexpr bool isConvex(ShapeKind kind) { return kind != ShapeKind::Torus && kind != ShapeKind::Teapot; }
// Half the sides of the box around a shape; its middle is the origin.
constexpr Vec3d halfExtent(ShapeKind kind) {
    switch (kind) {
        case ShapeKind::Plane: return {0.5, 0.5, 0};
        case ShapeKind::Box: return Vec3d(0.5);
        case ShapeKind::Torus: return {1.4, 1.4, 0.4};
        default: return Vec3d(1);
    }
}

// Plane by one division, box and cylinder as what slabs have in common (T. Kay and J. Kajiya, "Ray tracing complex
// scenes", SIGGRAPH 1986), sphere and cylinder from the point of the ray that is closest to the axis, the torus as the
// roots of a polynomial of degree 4. The direction is not (0, 0, 0).
template <class Real>
Crossings<Real> crossings(ShapeKind kind, const Ray<Real>& ray);

// Whether a ray that starts in a point of the torus meets it again, 0 < t < end. The polynomial has the root 0 there
// whatever the point was rounded to: dividing it off takes the place of an offset that would have to be guessed.
template <class Real>
bool torusMeetsItself(const Ray<Real>& ray, Real end);

}  // namespace pipeline::rays
