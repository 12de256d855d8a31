// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_SHADOWS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_SHADOWS_H
#undef SHADESCOPE_SHADOWS_H
#else
#define SHADESCOPE_SHADOWS_H
#endif

#include <hwy/cache_control.h>

#include "pipeline/simd/arithmetic.h"
#include "pipeline/stages/shading.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// Where points fall on a buffer: texels, and the distance that is compared there.
struct LightPoints {
    Floats x, y, z;
};
template <class A>
HWY_INLINE LightPoints lightPoints(const View& face, Floats3 position) {
    const Floats3 p = position - all(Vec3<float>(face.eye));
    const Floats right = A::dot(all(Vec3<float>(face.right)), p), up = A::dot(all(Vec3<float>(face.up)), p);
    return {hn::Floor(A::mulAdd(all(float(face.scale.x)), right, all(float(face.centre.x)))),
            hn::Floor(A::negMulAdd(all(float(face.scale.y)), up, all(float(face.centre.y)))),
            A::dot(all(Vec3<float>(face.forward)), p)};
}

// A buffer is larger than the caches next to the processor, and neighbours in the picture may be far apart in it: what
// the next pixels will look up is on its way while these are shaded.
template <class A>
HWY_INLINE void fetchTexels(const ShadingInputs& inputs, const ShadingSources<float>& in, Floats3 position, Mask mask) {
    if (!in.shadow || inputs.illumination.model == Model::OpenGl) return;
    for (std::size_t k = 0; k < inputs.lights.size(); ++k) {
        if (inputs.lights[k].kind != LightKind::AtInfinity || in.shadow->lights[k].empty()) continue;
        const Buffer2D<float>& depth = in.shadow->lights[k][0].depth[0];
        const LightPoints points = lightPoints<A>(in.shadow->lights[k][0].faces[0], position);
        const Floats zero = all(0), last = all(float(depth.size.x - 1));
        const Ints column = hn::ConvertTo(I(), hn::Min(hn::Max(points.x, zero), last));
        const Ints row = hn::ConvertTo(I(), hn::Min(hn::Max(points.y, zero), last));
        HWY_ALIGN std::int32_t texels[16];
        hn::Store(hn::Add(hn::Mul(row, hn::Set(I(), depth.size.x)), column), I(), texels);
        for (std::uint32_t bits = bitsOf(mask); bits != 0; bits &= bits - 1)
            hwy::Prefetch(&depth.pixels[std::size_t(texels[std::countr_zero(bits)])]);
    }
}

// How many of the texels that filtering looks at see the points lit: litTexels, of a light at infinity.
template <class A>
HWY_INLINE Floats litCount(const LightView<float>& light, const ShadowSettings& settings, Floats3 position,
                           Floats3 normal, Mask wanted) {
    const View& face = light.faces[0];
    const Buffer2D<float>& depth = light.depth[0];
    const Floats3 right = all(Vec3<float>(face.right)), up = all(Vec3<float>(face.up)),
                  forward = all(Vec3<float>(face.forward));
    const auto [x, y, z] = lightPoints<A>(face, position);
    Floats bias = all(float(settings.biasValue));
    if (settings.bias != ShadowBias::Constant) {
        const float texels = float(settings.filter) + 0.5F + 1.0F / 128;
        const Vec2<float> width(1.0 / face.scale);
        const Floats across =
            A::mulAdd(hn::Abs(A::dot(right, normal)), all(width.x), hn::Mul(hn::Abs(A::dot(up, normal)), all(width.y)));
        const Floats slope = hn::Div(hn::Mul(all(texels), across), hn::Abs(A::dot(forward, normal)));
        bias = settings.bias == ShadowBias::Slope ? hn::Mul(bias, slope) : hn::Add(slope, all(light.rounding));
    }
    const int r = settings.filter;
    const Floats zero = all(0), last = all(float(depth.size.x - 1));
    Floats lit = zero;
    for (int dy = -r; dy <= r; ++dy) {
        for (int dx = -r; dx <= r; ++dx) {
            const Floats u = hn::Add(x, all(float(dx))), v = hn::Add(y, all(float(dy)));
            const Mask inside = hn::And(hn::And(hn::Ge(u, zero), hn::Le(u, last)),
                                        hn::And(hn::And(hn::Ge(v, zero), hn::Le(v, last)), wanted));
            const Ints column = hn::ConvertTo(I(), hn::IfThenElseZero(inside, u));
            const Ints row = hn::ConvertTo(I(), hn::IfThenElseZero(inside, v));
            const Ints at = hn::Add(hn::Mul(row, hn::Set(I(), depth.size.x)), column);
            const Floats stored = hn::GatherIndex(F(), depth.pixels.data(), at);
            const Mask shadowed = hn::And(inside, hn::Gt(z, hn::Add(stored, bias)));
            lit = hn::Add(lit, hn::IfThenZeroElse(shadowed, all(1)));
        }
    }
    return lit;
}

// S of light k where it is wanted, else 1: shadowAt, of points of these polygons.
template <class A>
HWY_INLINE Floats shadowFactors(const ShadingInputs& inputs, const ShadingSources<float>& in, std::size_t k,
                                Floats3 position, Ints polygon, Mask wanted) {
    const Light& light = inputs.lights[k];
    const bool none = !light.castsShadow || inputs.illumination.model == Model::OpenGl;
    if (none || hn::AllFalse(F(), wanted)) return all(1);
    if (light.kind == LightKind::AtInfinity) {
        const Floats3 normal = gather(in.normals.polygon, polygon), L = all(normalized(Vec3<float>(light.position)));
        const Mask faces = hn::Gt(A::dot(normal, L), all(0));
        const bool looksUp = in.shadow && !in.shadow->lights[k].empty();
        Floats share = all(1);
        if (looksUp)
            share =
                hn::Div(litCount<A>(in.shadow->lights[k][0], inputs.shadow, position, normal, hn::And(wanted, faces)),
                        all(float(filteredTexels(inputs.shadow))));
        return hn::IfThenElse(wanted, hn::IfThenElseZero(faces, share), all(1));
    }
    // Six buffers, of an area light for each sample: one pixel after the other.
    HWY_ALIGN float factor[16], x[16], y[16], z[16];
    HWY_ALIGN std::int32_t polygons[16];
    hn::Store(all(1), F(), factor);
    hn::Store(position.x, F(), x), hn::Store(position.y, F(), y), hn::Store(position.z, F(), z);
    hn::Store(polygon, I(), polygons);
    for (std::uint32_t bits = bitsOf(wanted); bits != 0; bits &= bits - 1) {
        const int l = std::countr_zero(bits);
        factor[l] = shadowAt(inputs, in, k, std::uint32_t(polygons[l]), Vec3<float>(x[l], y[l], z[l]));
    }
    return hn::Load(F(), factor);
}

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
