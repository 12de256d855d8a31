// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_SHADOWS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_SHADOWS_H
#undef SHADESCOPE_SHADOWS_H
#else
#define SHADESCOPE_SHADOWS_H
#endif

#include <hwy/cache_control.h>

#include "pipeline/scene/area_light.h"
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

// Where a texel stands in the blocks of a buffer.
HWY_INLINE Ints texelPlace(const BlockBuffer2D<float>& depth, Ints column, Ints row) {
    static_assert(kTileSize == 64 && kBlock == 4);
    const I whole;
    const Ints tile =
        hn::Add(hn::Mul(hn::ShiftRight<6>(row), hn::Set(whole, depth.tiles.x)), hn::ShiftRight<6>(column));
    const auto bits = [&](Ints v, int mask) HWY_ATTR { return hn::And(v, hn::Set(whole, mask)); };
    const Ints block = hn::Add(hn::ShiftLeft<6>(bits(row, 60)), hn::ShiftLeft<2>(bits(column, 60)));
    return hn::Add(hn::Add(hn::ShiftLeft<12>(tile), block), hn::Add(hn::ShiftLeft<2>(bits(row, 3)), bits(column, 3)));
}

// A buffer is larger than the caches next to the processor, and neighbours in the picture may be far apart in it: what
// the next pixels will look up is on its way while these are shaded.
template <class A>
HWY_INLINE void fetchTexels(const ShadingInputs& inputs, const ShadingSources<float>& in, Floats3 position, Mask mask) {
    if (!in.shadow || inputs.illumination.model == Model::OpenGl) return;
    for (std::size_t k = 0; k < inputs.lights.size(); ++k) {
        if (inputs.lights[k].kind != LightKind::AtInfinity || in.shadow->lights[k].empty()) continue;
        const BlockBuffer2D<float>& depth = *in.shadow->lights[k][0].blocks[0];
        const LightPoints points = lightPoints<A>(in.shadow->lights[k][0].faces[0], position);
        const Floats zero = all(0), last = all(float(depth.size.x - 1));
        const Ints column = hn::ConvertTo(I(), hn::Min(hn::Max(points.x, zero), last));
        const Ints row = hn::ConvertTo(I(), hn::Min(hn::Max(points.y, zero), last));
        HWY_ALIGN std::int32_t texels[16];
        hn::Store(texelPlace(depth, column, row), I(), texels);
        for (std::uint32_t bits = bitsOf(mask); bits != 0; bits &= bits - 1)
            hwy::Prefetch(&depth.blocks[0].of[std::size_t(texels[std::countr_zero(bits)])]);
    }
}

// The texel that a coordinate lies in: texelAt, as a number.
HWY_INLINE Floats texelAt(Floats x) {
    const Floats limit = all(0x1p30F);
    const Mask inRange = hn::And(hn::Gt(x, hn::Neg(limit)), hn::Lt(x, limit));
    return hn::IfThenElse(inRange, hn::Floor(x), hn::Neg(limit));
}

// How many of the texels that filtering looks at see the points lit, on this face of the light: litTexels.
template <class A>
HWY_INLINE Floats litOnFace(const LightView<float>& light, std::size_t number, const ShadowSettings& settings,
                            Floats3 position, Floats3 normal, Mask wanted) {
    const View& face = light.faces[number];
    const BlockBuffer2D<float>& depth = *light.blocks[number];
    const Floats zero = all(0), one = all(1), last = all(float(depth.size.x - 1));
    const Floats3 right = all(Vec3<float>(face.right)), up = all(Vec3<float>(face.up)),
                  forward = all(Vec3<float>(face.forward));
    const Floats3 world = position - all(Vec3<float>(face.eye));
    const Floats3 p{A::dot(right, world), A::dot(up, world), A::dot(forward, world)};
    const Floats scaleX = all(float(face.scale.x)), centreX = all(float(face.centre.x)),
                 scaleY = all(float(face.scale.y)), centreY = all(float(face.centre.y));
    Floats x, y;
    if (face.perspective) {
        x = texelAt(hn::Add(centreX, hn::Div(hn::Mul(scaleX, p.x), p.z)));
        y = texelAt(hn::Sub(centreY, hn::Div(hn::Mul(scaleY, p.y), p.z)));
        x = hn::Min(hn::Max(x, zero), last), y = hn::Min(hn::Max(y, zero), last);
    } else {
        x = hn::Floor(A::mulAdd(scaleX, p.x, centreX));
        y = hn::Floor(A::negMulAdd(scaleY, p.y, centreY));
    }

    Floats bias = all(float(settings.biasValue));
    if (settings.bias != ShadowBias::Constant) {
        const Floats3 n{A::dot(right, normal), A::dot(up, normal), A::dot(forward, normal)};
        const float texels = float(settings.filter) + 0.5F + 1.0F / 128;
        const Vec2<float> width(1.0 / face.scale);
        const Floats delta =
            hn::Mul(all(texels), A::mulAdd(hn::Abs(n.x), all(width.x), hn::Mul(hn::Abs(n.y), all(width.y))));
        Floats slope;
        if (face.perspective) {
            const Floats relative = hn::Div(hn::Mul(p.z, delta), hn::Abs(A::dot(n, p)));
            slope =
                hn::IfThenElse(hn::IsFinite(relative), hn::Mul(p.z, hn::Div(relative, hn::Add(one, relative))), p.z);
        } else {
            slope = hn::Div(delta, hn::Abs(n.z));
        }
        bias = settings.bias == ShadowBias::Slope ? hn::Mul(bias, slope) : hn::Add(slope, all(light.rounding));
    }

    const int r = settings.filter;
    const bool adjoin = light.faces.size() > 1;
    Floats lit = zero;
    for (int dy = -r; dy <= r; ++dy) {
        for (int dx = -r; dx <= r; ++dx) {
            Floats u = hn::Add(x, all(float(dx))), v = hn::Add(y, all(float(dy)));
            if (adjoin) u = hn::Min(hn::Max(u, zero), last), v = hn::Min(hn::Max(v, zero), last);
            const Mask inside = hn::And(hn::And(hn::Ge(u, zero), hn::Le(u, last)),
                                        hn::And(hn::And(hn::Ge(v, zero), hn::Le(v, last)), wanted));
            const Ints column = hn::ConvertTo(I(), hn::IfThenElseZero(inside, u));
            const Ints row = hn::ConvertTo(I(), hn::IfThenElseZero(inside, v));
            const Floats stored = hn::GatherIndex(F(), depth.blocks[0].of, texelPlace(depth, column, row));
            const Mask shadowed = hn::And(inside, hn::Gt(p.z, hn::Add(stored, bias)));
            lit = hn::Add(lit, hn::IfThenZeroElse(shadowed, one));
        }
    }
    return lit;
}

// The same on the face that each point falls on: neighbours mostly fall on one.
template <class A>
HWY_INLINE Floats litCount(const LightView<float>& light, const ShadowSettings& settings, Floats3 position,
                           Floats3 normal, Mask wanted) {
    if (light.faces.size() == 1) return litOnFace<A>(light, 0, settings, position, normal, wanted);
    const Floats3 p = position - all(Vec3<float>(light.faces[0].eye));
    const Floats x = hn::Abs(p.x), y = hn::Abs(p.y), z = hn::Abs(p.z);
    const Mask alongX = hn::And(hn::Ge(x, y), hn::Ge(x, z)), alongY = hn::AndNot(alongX, hn::Ge(y, z));
    const Mask along[]{alongX, alongY, hn::Not(hn::Or(alongX, alongY))};
    const Floats component[]{p.x, p.y, p.z};
    Floats lit = all(0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Mask backwards = hn::Lt(component[axis], all(0));
        for (std::size_t sign = 0; sign < 2; ++sign) {
            const Mask side = sign == 0 ? hn::Not(backwards) : backwards;
            const Mask here = hn::And(wanted, hn::And(along[axis], side));
            if (hn::AllFalse(F(), here)) continue;
            lit = hn::IfThenElse(here, litOnFace<A>(light, 2 * axis + sign, settings, position, normal, here), lit);
        }
    }
    return lit;
}

// A light as pixels see it, whose shadow they may be in.
struct ShadowLight {
    const std::vector<LightView<float>>* views = nullptr;  // per place; null without a shadow buffer
    bool casts, atInfinity;
    std::vector<Vec3<float>> places;  // of its samples; at infinity the direction towards it

    ShadowLight(const ShadingInputs& inputs, const ShadingSources<float>& in, std::size_t k)
        : casts(inputs.lights[k].castsShadow && inputs.illumination.model != Model::OpenGl),
          atInfinity(inputs.lights[k].kind == LightKind::AtInfinity) {
        if (in.shadow && !in.shadow->lights[k].empty()) views = &in.shadow->lights[k];
        if (!casts) return;
        const Light& light = inputs.lights[k];
        const SampleGrid grid = sampleGrid(light);
        const AreaSides sides = sidesOf(light);
        for (int i = 0; i < grid.count(); ++i) {
            const Vec3<float> place(samplePlace(light, grid, sides, i));
            places.push_back(atInfinity ? normalized(place) : place);
        }
    }
    bool looksUp() const { return views != nullptr; }

    // S where it is wanted, else 1: shadowAt, of points of polygons with these normals.
    template <class A>
    HWY_INLINE Floats factors(const ShadowSettings& settings, Floats3 position, Floats3 normal, Mask wanted) const {
        if (!casts || hn::AllFalse(F(), wanted)) return all(1);
        const int texels = filteredTexels(settings);
        Floats lit = all(0);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Floats3 place = all(places[i]);
            const Floats3 L = atInfinity ? place : A::unit(place - position, wanted);
            const Mask faces = hn::And(wanted, hn::Gt(A::dot(normal, L), all(0)));
            if (hn::AllFalse(F(), faces)) continue;
            const Floats seen =
                views ? litCount<A>((*views)[i], settings, position, normal, faces) : all(float(texels));
            lit = hn::Add(lit, hn::IfThenElseZero(faces, seen));
        }
        return hn::IfThenElse(wanted, hn::Div(lit, all(float(int(places.size()) * texels))), all(1));
    }
};

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
