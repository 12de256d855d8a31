#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "pipeline/stages/rasterize.h"
#include "pipeline/stages/transform.h"

namespace pipeline {

// The weights that a pixel's intensity (Gouraud) or normal (Phong shading) is interpolated with. Depth, `position` and
// `barycentric` are perspective-correct whatever is chosen here.
//   Perspective  b, linear over the polygon in space
//   Affine       linear over the triangle in the picture: l_i = b_i z_i / Σ b_j z_j, since b_i = (l_i / z_i) / Σ l_j / z_j
//                (P. Heckbert and H. Moreton, "Interpolation for polygon texture mapping and shading", 1991)
//   Scanline     lecture 1's double interpolation, on the polygon itself: I_a and I_b linear along the two edges where the
//                pixel's row crosses them, then linear from one to the other. Depends on how the polygon is turned in the
//                picture, but for triangles, where it is affine.
// A triangle with a corner that is not in front of the near plane has no such place in the picture: the weights are affine
// over the piece that clipping left, for Scanline too.
template <class Real>
struct VertexWeights {
    std::size_t count = 0;                    // 3, of Scanline 2 to 4
    std::array<std::uint32_t, 4> vertices{};  // over all objects
    std::array<Real, 4> weights{};            // they sum to 1
    Interpolation used = Interpolation::Perspective;
};

// Where a row crosses the outlines of a polygon, from left to right: kept from pixel to pixel of that row.
struct RowCrossings {
    struct Crossing {
        double x;                // pixels
        std::uint32_t from, to;  // the edge's vertices
        double along;            // 0 at from, 1 at to
    };
    std::uint32_t polygon = ~0u;
    int row = -1;
    std::vector<Crossing> crossings;  // empty where the polygon has no outline in the picture
};

// At a pixel that the triangle covers, b its perspective-correct weights.
template <class Real>
VertexWeights<Real> vertexWeights(Interpolation mode, const TransformOutput<Real>& in, std::uint32_t triangle,
                                  Vec3<Real> b, glm::ivec2 pixel, RowCrossings& row);

// Σ w_i value(v_i); differences from the first, so that equal values stay what they are.
template <class Real, class Value>
Vec3<Real> interpolated(const VertexWeights<Real>& w, Value value) {
    const Vec3<Real> origin = value(w.vertices[0]);
    Vec3<Real> sum = origin;
    for (std::size_t i = 1; i < w.count; ++i) sum += w.weights[i] * (value(w.vertices[i]) - origin);
    return sum;
}

}  // namespace pipeline
