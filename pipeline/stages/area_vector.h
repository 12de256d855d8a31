#pragma once
#include <algorithm>
#include <limits>
#include <span>

#include "pipeline/core/forms.h"
#include "pipeline/core/numerics.h"
#include "pipeline/stages/transform.h"

namespace pipeline {

// Where the largest component of a polygon's area vector is less, products of its edges may be too small for normal
// numbers of Real: the edges are scaled first, by a power of two.
template <class Real>
Real smallestArea() {
    return ldexp(Real(1), std::numeric_limits<Real>::min_exponent / 2);
}

template <class Real>
Vec3<Real> scaled(Vec3<Real> v, int exponent) {
    return exponent == 0 ? v : Vec3<Real>(ldexp(v.x, exponent), ldexp(v.y, exponent), ldexp(v.z, exponent));
}

// Twice a polygon's area along its normal, by the right-hand rule, of edges times 2^-scale.
template <class Real, class Corners>
Vec3<Real> areaVector(PolygonNormalForm form, std::span<const Vec3<Real>> world, const Corners& corners,
                      int scale = 0) {
    Vec3<Real> sum(0);
    const std::size_t n = std::size(corners);
    if (form == PolygonNormalForm::FromOrigin) {
        for (std::size_t i = 0; i < n; ++i) sum += glm::cross(world[corners[i]], world[corners[(i + 1) % n]]);
        return sum;
    }
    const Vec3<Real> origin = world[corners[0]];
    const std::size_t end = form == PolygonNormalForm::ThreeCorners ? 3 : n;
    const auto edge = [&](std::size_t i) { return scaled(world[corners[i]] - origin, -scale); };
    for (std::size_t i = 2; i < end; ++i) sum += glm::cross(edge(i - 1), edge(i));
    return sum;
}

// Of a polygon of the scene, outward.
template <class Real>
Vec3<Real> areaVector(PolygonNormalForm form, const TransformOutput<Real>& in, std::size_t polygon, int scale = 0) {
    const Vec3<Real> sum = areaVector<Real>(form, in.world, in.topology->corners(polygon), scale);
    return in.mirrored[in.topology->objectOfPolygon(polygon)] ? -sum : sum;
}

// Along the normal of a polygon or triangle, by the right-hand rule, of any length.
template <class Real, class Corners>
Vec3<Real> alongNormal(PolygonNormalForm form, std::span<const Vec3<Real>> world, const Corners& corners) {
    const Vec3<Real> sum = areaVector<Real>(form, world, corners);
    if (form == PolygonNormalForm::FromOrigin || !(largestComponent(sum) < smallestArea<Real>())) return sum;
    Real longest = 0;
    for (std::size_t i = 1; i < std::size(corners); ++i)
        longest = std::max(longest, largestComponent(world[corners[i]] - world[corners[0]]));
    if (!(longest > 0)) return sum;
    int exponent;
    frexp(longest, &exponent);
    return areaVector<Real>(form, world, corners, exponent);
}

// Of a polygon of the scene, outward.
template <class Real>
Vec3<Real> alongNormal(PolygonNormalForm form, const TransformOutput<Real>& in, std::size_t polygon) {
    const Vec3<Real> sum = alongNormal<Real>(form, in.world, in.topology->corners(polygon));
    return in.mirrored[in.topology->objectOfPolygon(polygon)] ? -sum : sum;
}

}  // namespace pipeline
