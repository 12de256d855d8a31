#pragma once
#include <optional>

#include "pipeline/scene/settings.h"
#include "pipeline/stages/shadow_buffer.h"

namespace pipeline {

struct ShadowSettings {
    ShadowBias bias;
    double biasValue;
    int filter;  // radius of percentage-closer filtering, texels
    Planted planted{};
    std::optional<View> eye{};  // of a planted shadow-space alone
    bool operator==(const ShadowSettings&) const = default;
};

// The comparison of lecture 1, z' > Z'[x'][y'] + bias, at one point and texel.
template <class Real>
struct ShadowTest {
    std::size_t face = 0;
    glm::ivec2 texel{0};  // may lie outside the buffer: then nothing is in the way
    Real z = 0, bias = 0;
    Vec2<Real> offset{0};  // of the point from the texel's centre, right and down, texels
};

// z', its texel and the bias for a point on a surface with unit normal `normal`, world space.
//
// A texel holds the depth at its centre, up to half a texel away. On the surface's own plane that
// changes z' by at most δ = h (|n_x| w_x + |n_y| w_y), n the normal in light space and w a texel's
// width, h = r + 1/2 for a filter of radius r, and 1/128 for snapping on both sides:
//   at infinity  b = δ / |n_z|                      (z' is affine in the texel)
//   point light  b = z' δ' / (1 + δ'), δ' = z' δ / |n·p|   (1/z' is)
// The plane then never shadows itself, whatever the angle, and no more is added than that needs.
template <class Real>
ShadowTest<Real> shadowTest(const LightView<Real>& light, const ShadowSettings& settings, Vec3<Real> position,
                            Vec3<Real> normal);

// Of the texels that filtering looks at, how many see the point lit.
// W. Reeves, D. Salesin, R. Cook, "Rendering antialiased shadows with depth maps", SIGGRAPH 1987.
constexpr int filteredTexels(const ShadowSettings& settings) {
    return (2 * settings.filter + 1) * (2 * settings.filter + 1);
}
template <class Real>
int litTexels(const LightView<Real>& light, const ShadowSettings& settings, Vec3<Real> position, Vec3<Real> normal);

}  // namespace pipeline
