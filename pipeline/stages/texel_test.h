#pragma once
#include "pipeline/stages/shadow_factor.h"

namespace pipeline {

// The comparison of shadowTest at one texel, its own or one that a filter looks at; with the automatic bias by the larger
// of two bounds. One is that of shadowTest, by the point's own plane. The other is by what the texel holds.

// Where a crease runs through a texel, its centre may lie on another plane than the point, one that rises above the point's
// own towards the light. So the surface that the texel holds is continued to the point as the plane through the texel and
// those beside it, on the sides away from the point; as far as it recedes from the light on the way, b is at least that:
//   at infinity  b >= e = sum of max(0, Z' - Z'_beside) |offset| over both axes
//   point light  b >= Z' e' / (1 - e'), e' likewise of (Z' - Z'_beside) / Z'_beside; from e' = 1 on, no such plane is seen
// What a texel cannot hold is the outline of another surface that runs through it.
// offset: of the point from the centre of texel `at`, which lies in the buffer, texels.
template <class Real>
Real heldSlope(const Buffer2D<Real>& depth, bool perspective, glm::ivec2 at, Vec2<Real> offset);

template <class Real>
struct TexelTest {
    Real stored = 0, bias = 0;
    bool shadowed = false;
};
// offset: as for heldSlope.
template <class Real>
TexelTest<Real> testTexel(const LightView<Real>& light, const ShadowSettings& settings, const ShadowTest<Real>& test,
                          glm::ivec2 at, Vec2<Real> offset);

}  // namespace pipeline
