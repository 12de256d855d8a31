#pragma once
#include <array>
#include <cstdint>

#include "pipeline/core/real.h"
#include "pipeline/stages/view.h"

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
