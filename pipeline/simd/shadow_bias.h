// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_SHADOW_BIAS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_SHADOW_BIAS_H
#undef SHADESCOPE_SHADOW_BIAS_H
#else
#define SHADESCOPE_SHADOW_BIAS_H
#endif

#include <limits>

#include "pipeline/simd/arithmetic.h"
#include "pipeline/stages/shadow_factor.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// A face of a light in float, with its shadow buffer.
struct LightFace {
    Vec3<float> eye, right, up, forward;
    Vec2<float> step, centre, width;  // columns and rows per unit; middle of the buffer, texels; units per texel
    bool perspective;
    float rounding;  // as in LightView
    const BlockBuffer2D<float>* depth;

    LightFace(const LightView<float>& light, std::size_t number)
        : LightFace(light.faces[number], light.rounding, *light.blocks[number]) {}
    LightFace(const View& view, float rounds, const BlockBuffer2D<float>& blocks)
        : eye(view.eye),
          right(view.right),
          up(view.up),
          forward(view.forward),
          step(view.scale.x, -view.scale.y),
          centre(view.centre),
          width(1.0 / view.scale),
          perspective(view.perspective),
          rounding(rounds),
          depth(&blocks) {
        // The faces of a cube look along the axes of the world, and points are seen along these. Right and up are the
        // other two axes in their order, forwards or backwards.
        if (!perspective) return;
        if (right.x + right.y + right.z < 0) step.x = -step.x;
        if (up.x + up.y + up.z < 0) step.y = -step.y;
    }
    float last() const { return float(depth->size.x - 1); }  // last column or row

    template <class A>
    HWY_INLINE Floats3 along(Floats3 v) const {
        return {A::dot(all(right), v), A::dot(all(up), v), A::dot(all(forward), v)};
    }
};

// How much z' can differ from a texel's depth: δ of shadowTest, for polygons with this normal in the face's axes.
template <class A>
HWY_INLINE Floats texelSlope(const LightFace& face, const ShadowSettings& settings, Floats3 normal) {
    const float texels = float(settings.filter) + 0.5F + 1.0F / 128;
    return hn::Mul(all(texels),
                   A::mulAdd(hn::Abs(normal.x), all(face.width.x), hn::Mul(hn::Abs(normal.y), all(face.width.y))));
}
// The bias for a slope, if it is not constant.
HWY_INLINE Floats biasOf(const LightFace& face, const ShadowSettings& settings, Floats slope) {
    if (settings.bias == ShadowBias::Slope) slope = hn::Mul(all(float(settings.biasValue)), slope);
    return hn::Add(slope, all(face.rounding));
}

// For a light at infinity with one sample: the bias of whole polygons, which depends only on their normals.
struct PolygonBias {
    static constexpr float kTurnedAway = -std::numeric_limits<float>::infinity();
    const ShadowSettings& settings;
    Vec3<float> source;     // direction towards the light
    const LightFace* face;  // null if nothing was drawn

    HWY_INLINE static Mask turnsAway(Floats bias) { return hn::Eq(bias, all(kTurnedAway)); }
    // kTurnedAway for polygons that do not face the light.
    template <class A>
    HWY_INLINE Floats of(Floats3 normal) const {
        Floats bias = all(float(settings.biasValue));
        if (face && settings.bias != ShadowBias::Constant) {
            const Floats3 n = face->along<A>(normal);
            bias = biasOf(*face, settings, hn::Div(texelSlope<A>(*face, settings, n), hn::Abs(n.z)));
        }
        return hn::IfThenElse(hn::Gt(A::dot(normal, all(source)), all(0)), bias, all(kTurnedAway));
    }
};

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
