// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_SHADOWS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_SHADOWS_H
#undef SHADESCOPE_SHADOWS_H
#else
#define SHADESCOPE_SHADOWS_H
#endif

#include <hwy/cache_control.h>

#include <bit>

#include "pipeline/scene/area_light.h"
#include "pipeline/simd/arithmetic.h"
#include "pipeline/stages/shading.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// A face of a light, in float, and what was drawn there.
struct LightFace {
    Vec3<float> eye, right, up, forward;
    Vec2<float> scale, centre, width;  // texels a unit; the buffer's middle, texels; units a texel
    bool perspective;
    float rounding;  // of LightView
    const BlockBuffer2D<float>* depth;

    LightFace(const LightView<float>& light, std::size_t number)
        : LightFace(light.faces[number], light.rounding, *light.blocks[number]) {}
    LightFace(const View& view, float rounds, const BlockBuffer2D<float>& blocks)
        : eye(view.eye),
          right(view.right),
          up(view.up),
          forward(view.forward),
          scale(view.scale),
          centre(view.centre),
          width(1.0 / view.scale),
          perspective(view.perspective),
          rounding(rounds),
          depth(&blocks) {}
    float last() const { return float(depth->size.x - 1); }  // column or row
};

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

// The texel that a coordinate lies in: texelAt, as a number.
HWY_INLINE Floats texelAt(Floats x) {
    const Floats limit = all(0x1p30F);
    const Mask inRange = hn::And(hn::Gt(x, hn::Neg(limit)), hn::Lt(x, limit));
    return hn::IfThenElse(inRange, hn::Floor(x), hn::Neg(limit));
}

// What of a face's bias is the same for all lights of these axes: the normal along them, and delta of shadowTest.
struct FaceNormal {
    Floats3 n;
    Floats delta;
};
template <class A>
HWY_INLINE FaceNormal faceNormal(const LightFace& face, const ShadowSettings& settings, Floats3 normal) {
    const Floats3 n{A::dot(all(face.right), normal), A::dot(all(face.up), normal), A::dot(all(face.forward), normal)};
    const float texels = float(settings.filter) + 0.5F + 1.0F / 128;
    return {n,
            hn::Mul(all(texels), A::mulAdd(hn::Abs(n.x), all(face.width.x), hn::Mul(hn::Abs(n.y), all(face.width.y))))};
}

// How many of the texels that filtering looks at see the points lit, on this face of the light: litTexels. adjoin: it is
// one of several.
template <class A>
HWY_INLINE Floats litOnFace(const LightFace& face, bool adjoin, const ShadowSettings& settings, Floats3 position,
                            const FaceNormal& facing, Mask wanted) {
    const BlockBuffer2D<float>& depth = *face.depth;
    const Floats zero = all(0), one = all(1), last = all(face.last());
    const Floats3 world = position - all(face.eye);
    const Floats3 p{A::dot(all(face.right), world), A::dot(all(face.up), world), A::dot(all(face.forward), world)};
    const Floats scaleX = all(face.scale.x), centreX = all(face.centre.x), scaleY = all(face.scale.y),
                 centreY = all(face.centre.y);
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
        Floats slope;
        if (face.perspective) {
            const Floats relative = hn::Div(hn::Mul(p.z, facing.delta), hn::Abs(A::dot(facing.n, p)));
            slope =
                hn::IfThenElse(hn::IsFinite(relative), hn::Mul(p.z, hn::Div(relative, hn::Add(one, relative))), p.z);
        } else {
            slope = hn::Div(facing.delta, hn::Abs(facing.n.z));
        }
        bias = settings.bias == ShadowBias::Slope ? hn::Mul(bias, slope) : hn::Add(slope, all(face.rounding));
    }

    const int r = settings.filter;
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

// A light as pixels see it, whose shadow they may be in.
class ShadowLight {
public:
    ShadowLight(const ShadingInputs& inputs, const ShadingSources<float>& in, std::size_t k)
        : m_settings(inputs.shadow),
          m_casts(inputs.lights[k].castsShadow && inputs.illumination.model != Model::OpenGl),
          m_atInfinity(inputs.lights[k].kind == LightKind::AtInfinity) {
        if (in.shadow)
            for (const LightView<float>& place : in.shadow->lights[k])
                for (std::size_t face = 0; face < place.faces.size(); ++face) m_faces.emplace_back(place, face);
        if (!m_casts) return;
        const Light& light = inputs.lights[k];
        const SampleGrid grid = sampleGrid(light);
        const AreaSides sides = sidesOf(light);
        for (int i = 0; i < grid.count(); ++i) {
            const Vec3<float> place(samplePlace(light, grid, sides, i));
            m_places.push_back(m_atInfinity ? normalized(place) : place);
        }
    }
    bool casts() const { return m_casts; }
    bool looksUp() const { return !m_faces.empty(); }

    // S where it is wanted, else 1: shadowAt, of points of polygons with these normals.
    template <class A>
    HWY_INLINE Floats factors(Floats3 position, Floats3 normal, Mask wanted) const {
        if (!m_casts || hn::AllFalse(F(), wanted)) return all(1);
        const int texels = filteredTexels(m_settings);
        const bool isCube = m_faces.size() > m_places.size();
        FaceNormals normals;
        Floats lit = all(0);
        for (std::size_t i = 0; i < m_places.size(); ++i) {
            const Mask faces = hn::And(wanted, isFaced<A>(m_places[i], position, normal, wanted));
            if (hn::AllFalse(F(), faces)) continue;
            Floats seen = all(float(texels));
            if (isCube)
                seen = litOnCube<A>(i, position, normal, normals, faces);
            else if (looksUp())
                seen = litOnFace<A>(m_faces[i], false, m_settings, position,
                                    faceNormal<A>(m_faces[i], m_settings, normal), faces);
            lit = hn::Add(lit, hn::IfThenElseZero(faces, seen));
        }
        return hn::IfThenElse(wanted, hn::Div(lit, all(float(int(m_places.size()) * texels))), all(1));
    }

    // A buffer is larger than the caches next to the processor, and neighbours in the picture may be far apart in it:
    // what the next pixels will look up is on its way while these are shaded.
    template <class A>
    HWY_INLINE void fetchTexels(Floats3 position, Mask mask) const {
        const LightFace& face = m_faces[0];
        const Floats3 p = position - all(face.eye);
        const Floats zero = all(0), last = all(face.last());
        const Floats x = A::mulAdd(all(face.scale.x), A::dot(all(face.right), p), all(face.centre.x));
        const Floats y = A::negMulAdd(all(face.scale.y), A::dot(all(face.up), p), all(face.centre.y));
        const Ints column = hn::ConvertTo(I(), hn::Min(hn::Max(x, zero), last));
        const Ints row = hn::ConvertTo(I(), hn::Min(hn::Max(y, zero), last));
        HWY_ALIGN std::int32_t texels[16];
        hn::Store(texelPlace(*face.depth, column, row), I(), texels);
        for (std::uint32_t bits = bitsOf(mask); bits != 0; bits &= bits - 1)
            hwy::Prefetch(&face.depth->blocks[0].of[std::size_t(texels[std::countr_zero(bits)])]);
    }
    bool isFetched() const { return m_atInfinity && m_casts && looksUp(); }

private:
    // Those of a cube's faces that points have fallen on; the cubes of all places have the same axes.
    struct FaceNormals {
        bool known[6]{};
        FaceNormal of[6];
    };

    // Where polygons with these normals face a place: n·L > 0, L normalised as the stage's own text does it.
    template <class A>
    HWY_INLINE Mask isFaced(Vec3<float> from, Floats3 position, Floats3 normal, Mask wanted) const {
        const Floats3 place = all(from);
        if (m_atInfinity) return hn::Gt(A::dot(normal, place), all(0));
        const Floats3 L = place - position;
        const Floats along = A::dot(normal, L);
        if constexpr (!A::kExact) return hn::Gt(along, all(0));
        // Rounding errs by less than 2^-21 |L|, and by less than 2^-20 once L is normalised: only nearer to 0 than that
        // may it change the sign.
        const Floats size = hn::Add(hn::Add(hn::Abs(L.x), hn::Abs(L.y)), hn::Abs(L.z));
        const Mask sure =
            hn::And(hn::Gt(hn::Abs(along), hn::Mul(size, all(0x1p-18F))),
                    hn::And(hn::Lt(size, all(kLargestUnscaled)), hn::Gt(size, all(1 / kLargestUnscaled))));
        if (HWY_LIKELY(hn::AllTrue(F(), hn::Or(sure, hn::Not(wanted))))) return hn::Gt(along, all(0));
        return hn::Gt(A::dot(normal, A::unit(L, wanted)), all(0));
    }

    // litOnFace, on the face around place i that each point falls on: neighbours mostly fall on one.
    template <class A>
    HWY_INLINE Floats litOnCube(std::size_t i, Floats3 position, Floats3 normal, FaceNormals& normals,
                                Mask wanted) const {
        const Floats3 p = position - all(m_faces[6 * i].eye);
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
                const std::size_t number = 2 * axis + sign;
                const LightFace& face = m_faces[6 * i + number];
                if (!normals.known[number])
                    normals.known[number] = true, normals.of[number] = faceNormal<A>(face, m_settings, normal);
                lit =
                    hn::IfThenElse(here, litOnFace<A>(face, true, m_settings, position, normals.of[number], here), lit);
            }
        }
        return lit;
    }

    const ShadowSettings& m_settings;
    bool m_casts, m_atInfinity;
    std::vector<LightFace> m_faces;     // place after place, six of a point light; none without a shadow buffer
    std::vector<Vec3<float>> m_places;  // of its samples; at infinity the direction towards it
};

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
