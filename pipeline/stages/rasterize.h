#pragma once
#include <algorithm>
#include <array>
#include <cstdint>

#include "pipeline/buffers/block_buffer.h"
#include "pipeline/stages/clip.h"

namespace pipeline {

// From a triangle in view space to the pixels it covers: shared by the z-buffer and the shadow
// buffers ("same code as Z-Buffer, but using different origin", lecture 1).

// The unit of positions in the picture is 1/65536 pixel. How many of these bits corners are snapped to is a setting
// (View::subPixelBits, 8 unless asked for): fewer are the coarser grids of hardware.
inline constexpr int kSubPixelBits = 16;
inline constexpr std::int64_t kSubPixels = 1 << kSubPixelBits;  // units along a pixel's side

// Coverage is decided in integers, on corners snapped to the sub-pixel grid: exact, so that two
// triangles that share an edge never both cover a sample and never both miss it.
struct SnappedTriangle {
    std::array<glm::i64vec2, 3> corners;  // 1/65536 pixel, y down
    // Twice the signed area, 2^-32 px²; positive when the corners run clockwise as seen.
    std::int64_t area2() const;
    // Pixels whose centres the triangle's box holds, as a half-open range; may be empty.
    Tile pixels() const;
};

// Pixels, y down, to the grid of 2^-bits pixels, to nearest; in units. |p| must be within the guard band.
template <class W>
glm::i64vec2 snap(Vec2<W> p, int bits) {
    const W places = W(std::int64_t(1) << bits);
    const std::int64_t units = std::int64_t(1) << (kSubPixelBits - bits);
    return {static_cast<std::int64_t>(floor(p.x * places + W(0.5))) * units,
            static_cast<std::int64_t>(floor(p.y * places + W(0.5))) * units};
}

// The line from p to q as an integer function of position: > 0 on its right side as seen (y down),
// where a clockwise triangle lies; twice the area of (p, q, position).
// J. Pineda, "A parallel algorithm for polygon rasterization", SIGGRAPH 1988.
struct EdgeFunction {
    std::int64_t dx, dy;  // from p to q
    glm::i64vec2 p;
    EdgeFunction(glm::i64vec2 from, glm::i64vec2 to) : dx(to.x - from.x), dy(to.y - from.y), p(from) {}
    std::int64_t at(glm::i64vec2 x) const { return dx * (x.y - p.y) - dy * (x.x - p.x); }
    std::int64_t atPixel(glm::ivec2 pixel) const {
        return at({pixel.x * kSubPixels + kSubPixels / 2, pixel.y * kSubPixels + kSubPixels / 2});
    }
    // A sample exactly on the edge belongs to the triangle right of a left edge or below a top edge.
    bool ownsBoundary() const { return dy < 0 || (dy == 0 && dx > 0); }
    bool covers(std::int64_t value) const { return value > 0 || (value == 0 && ownsBoundary()); }
};

// Calls visit(pixel, e) for every pixel of the tile whose centre a clockwise triangle covers, row
// by row from the left; e[i] is the edge function opposite to corner i, their sum is area2().
template <class Visit>
void forEachCovered(const SnappedTriangle& t, Tile tile, Visit visit) {
    const EdgeFunction edges[3]{
        {t.corners[1], t.corners[2]}, {t.corners[2], t.corners[0]}, {t.corners[0], t.corners[1]}};
    const Tile box = t.pixels();
    const glm::ivec2 min = glm::max(tile.min, box.min), max = glm::min(tile.max, box.max);
    for (int y = min.y; y < max.y; ++y) {
        // An edge is affine along the row: e(x) = e(min.x) + (x - min.x) step. Solving e >= bias for
        // each edge gives the row's first and last pixel without looking at those between.
        std::int64_t first = 0, last = max.x - 1 - min.x;
        std::int64_t value[3], step[3];
        for (int i = 0; i < 3; ++i) {
            value[i] = edges[i].atPixel({min.x, y});
            step[i] = -edges[i].dy * kSubPixels;
            const std::int64_t slack = value[i] - (edges[i].ownsBoundary() ? 0 : 1);  // >= 0 where covered
            if (step[i] > 0 && slack < 0) first = std::max(first, (-slack + step[i] - 1) / step[i]);
            if (step[i] < 0) last = std::min(last, slack < 0 ? -1 : slack / -step[i]);
            if (step[i] == 0 && slack < 0) last = -1;
        }
        for (std::int64_t x = first; x <= last; ++x) {
            visit(glm::ivec2(min.x + int(x), y),
                  std::array<std::int64_t, 3>{value[0] + x * step[0], value[1] + x * step[1], value[2] + x * step[2]});
        }
    }
}

// w over a triangle as it is linear in the picture: at the first pixel of its first block of 4 × 4 pixels, and what a step
// to the right and one down add. Found at the first pixel of a pixel's block, and stepped from there, so that all of a block
// are one sum away from a number they share.
template <class Real>
struct PlaneEquation {
    Real first = 0, column = 0, row = 0;
    glm::ivec2 from{0};  // that first pixel; its block is the first in the picture
    bool holds = false;  // else w comes from the weights of the corners

    Real at(glm::ivec2 pixel) const {
        const glm::ivec2 inBlock = pixel & (kBlock - 1), block = pixel - inBlock - from;
        return (first + (column * Real(block.x) + row * Real(block.y))) +
               (column * Real(inBlock.x) + row * Real(inBlock.y));
    }
};

// How much w may grow over a triangle and the blocks around it, in relation to the least of it, for its plane to be used. It
// then errs by at most 3 + 8 kSteepest halves of a unit in the last place of that. Where w grows more, at a grazing view or
// in a splinter, sums of steps would lose digits that the weights of the corners keep.
inline constexpr double kSteepest = 1;
// Nor is it where it would not pay: for a box that is no larger than this on either side, pixels.
inline constexpr int kTinySide = kBlock;

// Of a triangle whose corners run clockwise, the farthest first. W is double or better.
template <class W, class Real>
PlaneEquation<Real> planeEquation(const SnappedTriangle& t, const std::array<Real, 3>& w, bool perspective) {
    const std::array<glm::i64vec2, 3>& p = t.corners;
    const W w0 = W(w[0]), one = W(w[1]) - w0, two = W(w[2]) - w0, inverse = 1 / W(t.area2());
    const auto slope = [&](std::int64_t p20, std::int64_t p01) { return (one * W(p20) + two * W(p01)) * inverse; };
    const W column = slope(p[2].y - p[0].y, p[0].y - p[1].y), row = slope(p[0].x - p[2].x, p[1].x - p[0].x);
    const Tile box = t.pixels();
    const glm::ivec2 from = glm::max(box.min, 0) & ~(kBlock - 1);
    const glm::i64vec2 centre = glm::i64vec2(from) * kSubPixels + kSubPixels / 2 - p[0];
    PlaneEquation<Real> out;
    out.first = Real(w0 + (column * W(centre.x) + row * W(centre.y)));
    out.column = Real(column * W(kSubPixels)), out.row = Real(row * W(kSubPixels));
    out.from = from;
    const glm::i64vec2 side = glm::max(p[0], glm::max(p[1], p[2])) - glm::min(p[0], glm::min(p[1], p[2]));
    const auto reach = [](std::int64_t of) { return Real(of) * (1 / Real(kSubPixels)) + Real(kBlock); };
    const Real grows = abs(out.column) * reach(side.x) + abs(out.row) * reach(side.y);
    const Real least = perspective ? w[0] : std::max(abs(w[0]), std::max(abs(w[1]), abs(w[2])));
    const glm::ivec2 pixels = box.max - box.min;
    out.holds = (pixels.x > kTinySide || pixels.y > kTinySide) && grows <= Real(kSteepest) * least;
    return out;
}

// A triangle ready to be rasterized, its corners clockwise as seen, the farthest first.
template <class Real>
struct RasterTriangle {
    SnappedTriangle snapped;
    std::array<Real, 3> w;                      // 1/z_view in perspective, z_view in orthographic projection
    std::array<Vec3<Real>, 3> weights;          // each corner's weights over the corners of triangle `id`
    Real inverseArea2;                          // 1 / area2()
    std::array<AtLeastDouble<Real>, 3> exactW;  // w before it was rounded to Real
    AtLeastDouble<Real> exactInverseArea2;
    PlaneEquation<Real> plane;
    std::uint32_t id;  // index into Topology::triangles
};

// Clips a triangle, projects and snaps it (in double or better, so that a corner falls on the same grid point
// whether or not its triangle was cut), and calls emit(RasterTriangle) for each piece with area.
// Returns the sum of the pieces' signed areas, 2^-32 px², positive for a front face
// (counter-clockwise as seen). inside: the triangle is known to need no clipping. drawn: else the pieces have no plane.
template <class Real, class Emit>
std::int64_t setUpTriangle(const View& view, const std::array<Vec3<Real>, 3>& corners, std::uint32_t id, Emit emit,
                           bool inside = false, bool drawn = true) {
    using W = AtLeastDouble<Real>;
    const std::array<Vec3<W>, 3> exact{Vec3<W>(corners[0]), Vec3<W>(corners[1]), Vec3<W>(corners[2])};
    const ClippedTriangle<W> clipped = inside ? wholeTriangle(exact) : clipTriangle(view, exact);
    const Vec2<W> centre(view.centre), scale(view.scale);
    std::array<glm::i64vec2, 9> snapped;
    std::array<W, 9> w;
    for (std::size_t i = 0; i < clipped.count; ++i) {
        const Vec3<W> v = clipped.corners[i].view;
        const W spread = view.perspective ? v.z : W(1);
        snapped[i] =
            snap(Vec2<W>(centre.x + scale.x * v.x / spread, centre.y - scale.y * v.y / spread), view.subPixelBits);
        w[i] = view.perspective ? 1 / v.z : v.z;
    }
    std::int64_t signedArea2 = 0;
    for (std::size_t k = 2; k < clipped.count; ++k) {
        std::array<std::size_t, 3> order{0, k - 1, k};
        const std::int64_t area2 = SnappedTriangle{{snapped[0], snapped[k - 1], snapped[k]}}.area2();
        signedArea2 -= area2;
        if (area2 == 0) continue;
        if (area2 < 0) std::swap(order[1], order[2]);  // counter-clockwise: turned round for the edge functions
        const auto smallest = std::min_element(order.begin(), order.end(),
                                               [&](std::size_t a, std::size_t b) { return Real(w[a]) < Real(w[b]); });
        std::rotate(order.begin(), smallest, order.end());

        RasterTriangle<Real> out;
        for (std::size_t i = 0; i < 3; ++i) {
            out.snapped.corners[i] = snapped[order[i]];
            out.w[i] = Real(w[order[i]]);
            out.exactW[i] = w[order[i]];
            out.weights[i] = Vec3<Real>(clipped.corners[order[i]].weights);
        }
        out.exactInverseArea2 = 1 / abs(W(area2));
        out.inverseArea2 = Real(out.exactInverseArea2);
        if (drawn) out.plane = planeEquation<W>(out.snapped, out.w, view.perspective);
        out.id = id;
        emit(out);
    }
    return signedArea2;
}

// What a fragment interpolates.
template <class Real>
struct Fragment {
    Real z;                  // z_view
    Real inverseZ;           // 1 / z in perspective, 0 in orthographic projection
    Vec3<Real> barycentric;  // perspective-correct weights over the corners of triangle `id`
};

// z from the triangle's plane, or from differences from corner 0: either way a polygon at one depth keeps that depth
// exactly. Corner 0 has the smallest w, so nothing is subtracted and lost, however much nearer the others are. The weights
// are those of the triangle's own corners, whichever of them comes first here: 1 and 2 as products, and what they leave is
// that of 0, so that they sum to 1. e: the edge functions at the pixel.
// P. Heckbert and H. Moreton, "Interpolation for polygon texture mapping and shading", 1991.
template <class Real>
Fragment<Real> interpolate(const RasterTriangle<Real>& t, glm::ivec2 pixel, const std::array<std::int64_t, 3>& e,
                           bool perspective) {
    const Vec3<Real> l = Vec3<Real>(Real(e[0]), Real(e[1]), Real(e[2])) * t.inverseArea2;
    const Real w = t.plane.holds ? t.plane.at(pixel) : t.w[0] + l.y * (t.w[1] - t.w[0]) + l.z * (t.w[2] - t.w[0]);
    const Real z = perspective ? 1 / w : w;
    Real b1 = 0, b2 = 0;
    for (int i = 0; i < 3; ++i) {
        const Real b = perspective ? l[i] * t.w[std::size_t(i)] * z : l[i];
        b1 += b * t.weights[std::size_t(i)].y, b2 += b * t.weights[std::size_t(i)].z;
    }
    return {z, perspective ? w : Real(0), {1 - b1 - b2, b1, b2}};
}

// w of a fragment, in double or better: what the depth formats encode.
template <class Real>
AtLeastDouble<Real> interpolateW(const RasterTriangle<Real>& t, const std::array<std::int64_t, 3>& e) {
    using W = AtLeastDouble<Real>;
    const W l1 = W(e[1]) * t.exactInverseArea2, l2 = W(e[2]) * t.exactInverseArea2;
    return t.exactW[0] + l1 * (t.exactW[1] - t.exactW[0]) + l2 * (t.exactW[2] - t.exactW[0]);
}

}  // namespace pipeline
