#pragma once
#include <array>
#include <cstdint>

#include "pipeline/core/real.h"
#include "pipeline/scene/view.h"

namespace pipeline {

// The planes a polygon is cut by before it is projected. Left, right, top and bottom stand far
// outside the picture (the guard band): the rasterizer drops what lies between it and the border.
enum class Plane : std::uint8_t { Near, Far, Left, Right, Top, Bottom };
inline constexpr std::size_t kPlaneCount = 6;

// Pixels from the picture's centre to the guard band: half the side of the largest picture. In units of 1/65536 pixel
// an edge function then stays below 2^62 and is exact in 64 bits.
inline constexpr double kGuardBand = double(1 << 13);

// Distance of a view-space point from the plane, in view units times the plane's slope; >= 0 inside.
// `band` is the half size of the picture or of the guard band, pixels.
template <class W>
W signedDistance(const View& view, Plane plane, Vec3<W> p, glm::dvec2 band);

// For each plane, in their order, a bit: whether the point is outside; whether it is not inside, which a distance that
// is no number makes it too. The same distances as signedDistance gives.
struct PlaneBits {
    unsigned outside = 0, notInside = 0;
};
template <class W>
PlaneBits planesAgainst(const View& view, Vec3<W> p, glm::dvec2 band) {
    const W spread = view.perspective ? p.z : W(1), x = W(view.scale.x) * p.x, y = W(view.scale.y) * p.y;
    const W side = W(band.x) * spread, top = W(band.y) * spread;
    PlaneBits bits;
    const auto add = [&bits](Plane plane, W distance) {
        bits.outside |= unsigned(distance < 0) << unsigned(plane);
        bits.notInside |= unsigned(!(distance >= 0)) << unsigned(plane);
    };
    add(Plane::Near, p.z - W(view.near)), add(Plane::Far, W(view.far) - p.z);
    add(Plane::Left, side + x), add(Plane::Right, side - x);
    add(Plane::Top, top - y), add(Plane::Bottom, top + y);
    return bits;
}

// A corner of a clipped triangle: where it is, and its weights over the triangle's own corners,
// so that a cut triangle interpolates exactly as the whole one would.
template <class W>
struct ClipCorner {
    Vec3<W> view;
    Vec3<W> weights;
};

// The part of a triangle inside near, far and guard band: 0, or 3 to 9 corners in order.
template <class W>
struct ClippedTriangle {
    std::array<ClipCorner<W>, 3 + kPlaneCount> corners;
    std::size_t count = 0;
};

// I. Sutherland and G. Hodgman, "Reentrant polygon clipping", CACM 1974. Every cut is computed
// from the corner inside to the corner outside: two polygons that share an edge get the same
// point, bit for bit, whichever way round they run along it. W is at least double: at a near plane a
// millionth of the scene away, a cut in float would keep four bits.
template <class W>
ClippedTriangle<W> clipTriangle(const View& view, const std::array<Vec3<W>, 3>& corners);
// The same for a triangle that is known to lie inside all planes.
template <class W>
ClippedTriangle<W> wholeTriangle(const std::array<Vec3<W>, 3>& corners);

}  // namespace pipeline
