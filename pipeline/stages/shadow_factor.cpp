#include "pipeline/stages/shadow_factor.h"

#include <algorithm>
#include <cmath>

#include "pipeline/stages/texel_test.h"

namespace pipeline {
namespace {

template <class Real>
Real closedFormBias(const View& face, Vec3<Real> p, Vec3<Real> n, Real texels) {
    const Vec2<Real> width(1.0 / face.scale);
    const Real delta = texels * (abs(n.x) * width.x + abs(n.y) * width.y);
    if (!face.perspective) return delta / abs(n.z);
    const Real relative = p.z * delta / abs(glm::dot(n, p));
    // relative / (1 + relative) tends to 1 as the plane runs through the light.
    return isfinite(relative) ? p.z * (relative / (1 + relative)) : p.z;
}

// Where a point in a face's view space falls on its buffer, columns and rows.
template <class Real>
Vec2<Real> placeOf(const View& face, Vec3<Real> p) {
    const Real spread = face.perspective ? p.z : Real(1);
    return {Real(face.centre.x) + Real(face.scale.x) * p.x / spread,
            Real(face.centre.y) - Real(face.scale.y) * p.y / spread};
}

// Texels beyond +-2^30 are outside every buffer, and so is what a filter looks at around them; the conversion to int must
// not overflow.
template <class Real>
int texelAt(Real x) {
    constexpr int kLimit = 1 << 30;
    return x > Real(-kLimit) && x < Real(kLimit) ? static_cast<int>(floor(x)) : -kLimit;
}

}  // namespace

template <class Real>
ShadowTest<Real> shadowTest(const LightView<Real>& light, const ShadowSettings& settings, Vec3<Real> position,
                            Vec3<Real> normal) {
    ShadowTest<Real> test;
    if (settings.planted) spoilShadowPoint(settings, position);
    test.face = faceOf(light, position);
    const View& face = light.faces[test.face];
    const Vec3<Real> p = toView(face, position);
    Vec2<Real> place = placeOf(face, p);
    test.z = p.z;
    if (settings.planted) spoilLightPlace(settings, face, position, place, test.z);
    test.texel = {texelAt(place.x), texelAt(place.y)};
    // A point on the seam of two faces of a point light lies in the last texel, not beyond it.
    if (face.perspective) test.texel = glm::clamp(test.texel, glm::ivec2(0), face.size - 1);
    test.offset = (place - Vec2<Real>(test.texel)) - Real(0.5);
    if (settings.planted) spoilTexel(settings, face.size, test.texel);
    if (settings.bias == ShadowBias::Constant) {
        test.bias = Real(settings.biasValue);
        return test;
    }
    const Vec3<Real> n{glm::dot(Vec3<Real>(face.right), normal), glm::dot(Vec3<Real>(face.up), normal),
                       glm::dot(Vec3<Real>(face.forward), normal)};
    const Real texels = Real(settings.filter) + Real(0.5) + Real(1) / 128;
    const Real slope = closedFormBias(face, p, n, texels);
    const bool scales = settings.bias == ShadowBias::Slope;
    test.bias = (scales ? Real(settings.biasValue) * slope : slope) + light.rounding;
    return test;
}

template <class Real>
Real heldSlope(const Buffer2D<Real>& depth, bool perspective, glm::ivec2 at, Vec2<Real> offset) {
    const Real stored = depth.at(at);
    const auto along = [&](int axis) {
        glm::ivec2 beside = at;
        beside[axis] += offset[axis] > 0 ? -1 : 1;
        // Beyond the buffer nothing is known of the surface.
        if (beside[axis] < 0 || beside[axis] >= depth.size[axis]) return Real(0);
        const Real nearer = depth.at(beside), recedes = stored - nearer;
        if (!(recedes > 0)) return Real(0);  // also of two infinities
        return (perspective ? recedes / nearer : recedes) * abs(offset[axis]);
    };
    const Real sum = along(0) + along(1);
    if (!perspective) return sum;
    return sum < 1 ? stored * (sum / (1 - sum)) : Real(0);
}

template <class Real>
TexelTest<Real> testTexel(const LightView<Real>& light, const ShadowSettings& settings, const ShadowTest<Real>& test,
                          glm::ivec2 at, Vec2<Real> offset) {
    const Buffer2D<Real>& depth = *light.depth[test.face];
    TexelTest<Real> found{depth.at(at), test.bias, false};
    found.shadowed = test.z > found.stored + found.bias;
    if (found.shadowed && settings.bias == ShadowBias::Automatic) {
        found.bias = std::max(found.bias, heldSlope(depth, light.faces[test.face].perspective, at, offset));
        found.shadowed = test.z > found.stored + found.bias;
    }
    if (settings.planted) spoilShadowed(settings, test, found);
    return found;
}

template <class Real>
int litTexels(const LightView<Real>& light, const ShadowSettings& settings, Vec3<Real> position, Vec3<Real> normal) {
    const ShadowTest<Real> test = shadowTest(light, settings, position, normal);
    const Buffer2D<Real>& depth = *light.depth[test.face];
    const int r = settings.filter;
    // The faces of a point light adjoin: for what lies beyond a seam stands the texel before it. Beyond the buffer of a
    // light at infinity there is nothing.
    const glm::ivec2 last = depth.size - 1;
    const bool adjoin = light.faces.size() > 1;
    int lit = 0;
    for (int y = test.texel.y - r; y <= test.texel.y + r; ++y) {
        for (int x = test.texel.x - r; x <= test.texel.x + r; ++x) {
            const glm::ivec2 at = adjoin ? glm::clamp(glm::ivec2(x, y), glm::ivec2(0), last) : glm::ivec2(x, y);
            const bool inside = at.x >= 0 && at.y >= 0 && at.x <= last.x && at.y <= last.y;
            const Vec2<Real> offset{test.offset.x - Real(x - test.texel.x), test.offset.y - Real(y - test.texel.y)};
            if (!inside || !testTexel(light, settings, test, at, offset).shadowed) ++lit;
        }
    }
    return lit;
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                             \
    template ShadowTest<Real> shadowTest(const LightView<Real>&, const ShadowSettings&, Vec3<Real>, Vec3<Real>); \
    template Real heldSlope(const Buffer2D<Real>&, bool, glm::ivec2, Vec2<Real>);                                \
    template TexelTest<Real> testTexel(const LightView<Real>&, const ShadowSettings&, const ShadowTest<Real>&,   \
                                       glm::ivec2, Vec2<Real>);                                                  \
    template int litTexels(const LightView<Real>&, const ShadowSettings&, Vec3<Real>, Vec3<Real>);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
