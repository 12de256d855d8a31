#include "pipeline/illumination/shadow_factor.h"

#include <cmath>

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
    test.face = faceOf(light, position);
    const View& face = light.faces[test.face];
    const Vec3<Real> p = toView(face, position);
    const Real spread = face.perspective ? p.z : Real(1);
    test.texel = {texelAt(Real(face.centre.x) + Real(face.scale.x) * p.x / spread),
                  texelAt(Real(face.centre.y) - Real(face.scale.y) * p.y / spread)};
    // A point on the seam of two faces of a point light lies in the last texel, not beyond it.
    if (face.perspective) test.texel = glm::clamp(test.texel, glm::ivec2(0), face.size - 1);
    test.z = p.z;
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
            if (!inside || !(test.z > depth.at(at) + test.bias)) ++lit;
        }
    }
    return lit;
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                             \
    template ShadowTest<Real> shadowTest(const LightView<Real>&, const ShadowSettings&, Vec3<Real>, Vec3<Real>); \
    template int litTexels(const LightView<Real>&, const ShadowSettings&, Vec3<Real>, Vec3<Real>);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
