// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_SHADOWS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_SHADOWS_H
#undef SHADESCOPE_SHADOWS_H
#else
#define SHADESCOPE_SHADOWS_H
#endif

#include <hwy/cache_control.h>

#include <bit>
#include <limits>
#include <optional>
#include <vector>

#include "pipeline/scene/area_light.h"
#include "pipeline/simd/shadow_bias.h"
#include "pipeline/simd/surfaces.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// Columns or rows, whole numbers up to 2^22, as bits: adding kToWhole moves the number into the last bits.
HWY_INLINE Ints wholeBits(Floats v) { return hn::BitCast(I(), hn::Add(v, all(kToWhole))); }
HWY_INLINE Ints wholeOf(Ints bits) { return hn::Sub(bits, hn::BitCast(I(), all(kToWhole))); }

// The index of a texel in the blocks of a buffer; column and row: wholeBits of an existing texel.
HWY_INLINE Ints texelPlace(const BlockBuffer2D<float>& depth, Ints column, Ints row) {
    static_assert(kTileSize == 64 && kBlock == 4);
    const auto bits = [](std::int32_t mask) HWY_ATTR { return hn::Set(I(), mask); };
    constexpr std::int32_t kTile = (1 << 22) - 64;  // mask: first column or row of the tile
    Ints inTiles = hn::And(column, bits(3));
    inTiles = hn::OrAnd(inTiles, hn::ShiftLeft<2>(row), bits(3 << 2));
    inTiles = hn::OrAnd(inTiles, hn::ShiftLeft<2>(column), bits(60 << 2));
    inTiles = hn::OrAnd(inTiles, hn::ShiftLeft<6>(row), bits(60 << 6));
    inTiles = hn::OrAnd(inTiles, hn::ShiftLeft<6>(column), bits(kTile << 6));
    return hn::Add(inTiles, hn::Mul(hn::And(row, bits(kTile)), bits(depth.tiles.x << 6)));
}

// Points in the coordinates of a light's face: across its buffer and along its view, in world units. n is the normal of
// their polygons in the same axes; nDotP is n·p.
struct SeenByLight {
    Floats x, y, z;
    Floats3 n;
    Floats nDotP;
};

// The look-ups of a row of pixels on one face of a light: the index of the nearest existing texel in the blocks, the
// points' distances and the bias of their triangles. In orthographic views a texel may be beyond the buffer. Filtering
// needs its column and row; without filtering the point counts as nearer than everything.
struct LookUps {
    Row x, y, z, bias;
    Row right, down;  // distance of the points from the texel's centre, texels
    alignas(64) std::int32_t place[kRowPixels];
};

// The faces of a cube adjoin, so a point beyond the last texel uses that texel.
HWY_INLINE Floats nearestTexel(const LightFace& face, Floats x) {
    return hn::Min(hn::IfThenElseZero(hn::Gt(x, all(0)), x), all(face.last()));
}

constexpr std::size_t kManyBlocks = (8 << 20) / (kBlockPixels * sizeof(float));  // 8 MB

// A shadow buffer is larger than the inner caches, and pixels beside each other may be far apart in it. So the texels
// of vector i are prefetched while the rest of the row is computed.
HWY_INLINE void preparePlaces(const LightFace& face, Ints places, std::size_t i, LookUps& out) {
    const std::int32_t* const at = out.place + i;
    hn::Store(places, I(), out.place + i);
    // In a small buffer a few prefetches are enough, because the other lanes' texels are mostly beside them.
    const std::size_t step = face.depth->blocks.size() > kManyBlocks ? 1 : 5;
    for (std::size_t l = 0; l < hn::Lanes(F()); l += step) hwy::Prefetch(numbersOf(face.depth->blocks.data()) + at[l]);
}
HWY_INLINE Ints nearestPlace(const LightFace& face, Floats x, Floats y) {
    return texelPlace(*face.depth, wholeBits(nearestTexel(face, x)), wholeBits(nearestTexel(face, y)));
}
// The texels x, y of points at right, down; all in texels.
HWY_INLINE void storeTexel(Floats x, Floats y, Floats right, Floats down, std::size_t i, LookUps& out) {
    store(x, out.x, i), store(y, out.y, i);
    store(hn::Sub(hn::Sub(right, x), all(0.5F)), out.right, i);
    store(hn::Sub(hn::Sub(down, y), all(0.5F)), out.down, i);
}
template <class A>
HWY_INLINE void prepareTexelAtInfinity(const LightFace& face, int filter, Floats3 p, std::size_t i, LookUps& out) {
    const Floats right = A::mulAdd(all(face.step.x), p.x, all(face.centre.x));
    const Floats down = A::mulAdd(all(face.step.y), p.y, all(face.centre.y));
    const Floats x = hn::Floor(right), y = hn::Floor(down);
    storeTexel(x, y, right, down, i, out);
    if (filter != 0) {
        preparePlaces(face, nearestPlace(face, x, y), i, out);
        store(p.z, out.z, i);
        return;
    }
    // As unsigned numbers, all texels beyond any side of the buffer are beyond the last one; NaN is too.
    const Ints column = wholeBits(x), row = wholeBits(y);
    const auto unsignedOf = [](Ints bits) HWY_ATTR { return hn::BitCast(U(), wholeOf(bits)); };
    const auto farther = hn::Max(unsignedOf(column), unsignedOf(row));
    const auto isBeyond = hn::Gt(farther, hn::Set(U(), std::uint32_t(face.depth->size.x - 1)));
    const Ints place = texelPlace(*face.depth, column, row);
    preparePlaces(face, hn::IfThenZeroElse(hn::RebindMask(I(), isBeyond), place), i, out);
    const Floats nearest = all(-std::numeric_limits<float>::infinity());
    store(hn::IfThenElse(hn::RebindMask(F(), isBeyond), nearest, p.z), out.z, i);
}

template <class A>
HWY_INLINE void prepareLookUps(const LightFace& face, const ShadowSettings& settings, const SeenByLight& p,
                               std::size_t i, LookUps& out) {
    if (face.perspective) {
        const auto place = [&](float centre, float step, Floats across)
                               HWY_ATTR { return hn::Add(all(centre), hn::Div(hn::Mul(all(step), across), p.z)); };
        const Floats right = place(face.centre.x, face.step.x, p.x), down = place(face.centre.y, face.step.y, p.y);
        const Floats x = nearestTexel(face, hn::Floor(right)), y = nearestTexel(face, hn::Floor(down));
        preparePlaces(face, nearestPlace(face, x, y), i, out);
        storeTexel(x, y, right, down, i, out), store(p.z, out.z, i);
    } else {
        prepareTexelAtInfinity<A>(face, settings.filter, {p.x, p.y, p.z}, i, out);
    }
    if (settings.bias == ShadowBias::Constant) return store(all(float(settings.biasValue)), out.bias, i);
    const Floats delta = texelSlope<A>(face, settings, p.n);
    Floats slope;
    if (face.perspective) {
        const Floats relative = hn::Div(hn::Mul(p.z, delta), hn::Abs(p.nDotP));
        slope = hn::IfThenElse(hn::IsFinite(relative), hn::Mul(p.z, hn::Div(relative, hn::Add(all(1), relative))), p.z);
    } else {
        slope = hn::Div(delta, hn::Abs(p.n.z));
    }
    store(biasOf(face, settings, slope), out.bias, i);
}

HWY_INLINE Floats storedAt(const LightFace& face, Ints place) {
    return hn::GatherIndex(F(), numbersOf(face.depth->blocks.data()), place);
}
// heldSlope for texels x, y that hold `stored`.
HWY_NOINLINE Floats heldSlopes(const LightFace& face, Floats stored, Floats x, Floats y, Floats right, Floats down) {
    const auto away = [](Floats texel, Floats offset)
                          HWY_ATTR { return hn::Add(texel, hn::IfThenElse(hn::Gt(offset, all(0)), all(-1), all(1))); };
    // Beyond the buffer the neighbour is the texel itself, so there is no difference.
    const auto along = [&](Ints beside, Floats offset) HWY_ATTR {
        const Floats nearer = storedAt(face, beside), recedes = hn::Sub(stored, nearer);
        const Floats rate = face.perspective ? hn::Div(recedes, nearer) : recedes;
        return hn::IfThenElseZero(hn::Gt(recedes, all(0)), hn::Mul(rate, hn::Abs(offset)));
    };
    const Floats sum =
        hn::Add(along(nearestPlace(face, away(x, right), y), right), along(nearestPlace(face, x, away(y, down)), down));
    if (!face.perspective) return sum;
    return hn::IfThenElseZero(hn::Lt(sum, all(1)), hn::Mul(stored, hn::Div(sum, hn::Sub(all(1), sum))));
}
// The lanes whose points, at distance z, are farther than the depth in their texels: testTexel.
HWY_INLINE Mask shadowedAt(const LightFace& face, const ShadowSettings& settings, Ints place, Floats z, Floats bias,
                           Floats x, Floats y, Floats right, Floats down) {
    const Floats stored = storedAt(face, place);
    const Mask shadowed = hn::Gt(z, hn::Add(stored, bias));
    if (settings.bias != ShadowBias::Automatic || hn::AllFalse(F(), hn::AndNot(PolygonBias::turnsAway(bias), shadowed)))
        return shadowed;
    const Floats held = heldSlopes(face, stored, x, y, right, down);
    return hn::And(shadowed, hn::Gt(z, hn::Add(stored, held)));
}
// The number of tested texels from which the points of vector i of a row are lit: litTexels.
HWY_INLINE Floats litInTexel(const LightFace& face, const ShadowSettings& settings, const LookUps& lookUps, Floats bias,
                             std::size_t i) {
    const Mask shadowed =
        shadowedAt(face, settings, hn::Load(I(), lookUps.place + i), load(lookUps.z, i), bias, load(lookUps.x, i),
                   load(lookUps.y, i), load(lookUps.right, i), load(lookUps.down, i));
    return hn::IfThenZeroElse(shadowed, all(1));
}
HWY_NOINLINE Floats litInTexels(const LightFace& face, const ShadowSettings& settings, const LookUps& lookUps,
                                Floats bias, std::size_t i) {
    const Floats x = load(lookUps.x, i), y = load(lookUps.y, i), first = all(0), last = all(face.last());
    Floats sum = all(0);
    const int r = settings.filter;
    for (int dy = -r; dy <= r; ++dy) {
        for (int dx = -r; dx <= r; ++dx) {
            const Floats u = hn::Add(x, all(float(dx))), v = hn::Add(y, all(float(dy)));
            const Floats right = hn::Sub(load(lookUps.right, i), all(float(dx)));
            const Floats down = hn::Sub(load(lookUps.down, i), all(float(dy)));
            const Mask shadowed = shadowedAt(face, settings, nearestPlace(face, u, v), load(lookUps.z, i), bias,
                                             nearestTexel(face, u), nearestTexel(face, v), right, down);
            Floats lit = hn::IfThenZeroElse(shadowed, all(1));
            const Mask inside =
                hn::And(hn::And(hn::Ge(u, first), hn::Le(u, last)), hn::And(hn::Ge(v, first), hn::Le(v, last)));
            if (!face.perspective) lit = hn::IfThenElse(inside, lit, all(1));
            sum = hn::Add(sum, lit);
        }
    }
    return sum;
}

// One light with the data for the shadow tests of pixels.
class ShadowLight {
public:
    ShadowLight(const ShadingInputs& inputs, const ShadingSources<float>& in, std::size_t k)
        : m_settings(inputs.shadow),
          m_casts(inputs.lights[k].castsShadow && modelFacts(inputs.illumination.model).shadows),
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
        const auto columns = std::size_t(grid.columns), count = m_places.size();
        if (count > 4) m_corners = {m_places[0], m_places[columns - 1], m_places[count - columns], m_places[count - 1]};
    }
    bool casts() const { return m_casts; }
    bool looksUp() const { return !m_faces.empty(); }
    // Its bias, if it is constant over a triangle.
    std::optional<PolygonBias> polygonBias() const {
        if (!m_casts || !m_atInfinity || m_places.size() != 1) return {};
        return PolygonBias{m_settings, m_places[0], looksUp() ? &m_faces[0] : nullptr};
    }

    // Prepares and prefetches the look-ups of a row, long before they are used. Pixels on triangles that face away need
    // none.
    template <class A>
    HWY_NOINLINE void prepare(const SurfaceRow& row, const Row& bias, LookUps& out) const {
        if (!looksUp()) return;
        const LightFace& face = m_faces[0];
        for (std::size_t i = 0; i < kRowPixels; i += hn::Lanes(F())) {
            const Mask seen = row.seenAt(i);
            if (hn::AllFalse(F(), hn::AndNot(PolygonBias::turnsAway(load(bias, i)), seen))) continue;
            prepareTexelAtInfinity<A>(face, m_settings.filter, face.along<A>(load(row.position, i) - all(face.eye)), i,
                                      out);
        }
    }
    // S for vector i of a row, with the bias of its triangles: shadowAt.
    HWY_INLINE Floats factorByPolygon(const LookUps& lookUps, const Row& bias, std::size_t i) const {
        const Floats of = load(bias, i);
        Floats share = all(1);
        if (looksUp()) {
            const int most = filteredTexels(m_settings);
            share = most == 1 ? litInTexel(m_faces[0], m_settings, lookUps, of, i)
                              : hn::Div(litInTexels(m_faces[0], m_settings, lookUps, of, i), all(float(most)));
        }
        return hn::IfThenZeroElse(PolygonBias::turnsAway(of), share);
    }
    // S for the pixels in `wanted`: shadowAt. The other lanes of their vectors get 1.
    template <class A>
    HWY_NOINLINE void factors(const SurfaceRow& row, const Group& wanted, Row& S) const {
        const int texels = filteredTexels(m_settings);
        Group faced = wanted;
        bool facesAll[kRowVectors];
        for (std::size_t n = 0; n < wanted.count; ++n) {
            store(all(0), S, wanted.at[n]);
            facesAll[n] =
                isFacedByAll<A>(load(row.position, wanted.at[n]), load(row.facing, wanted.at[n]), wanted.mask(n));
        }
        std::size_t face = 0;  // index of the cube face that the last points were on; all samples have the same axes
        for (std::size_t i = 0; i < m_places.size(); ++i) {
            for (std::size_t n = 0; n < wanted.count; ++n) {
                if (facesAll[n]) {
                    faced.bits[n] = wanted.bits[n];
                    continue;
                }
                const Mask mask = wanted.mask(n);
                faced.bits[n] = bitsOf(hn::And(mask, isFaced<A>(m_places[i], load(row.position, wanted.at[n]),
                                                                load(row.facing, wanted.at[n]), mask)));
            }
            if (m_faces.size() > m_places.size())
                addCube<A>(&m_faces[6 * i], face, row, faced, S);
            else if (looksUp())
                addFace<A>(m_faces[i], row, faced, S);
            else
                for (std::size_t n = 0; n < faced.count; ++n) addLit(all(float(texels)), faced.mask(n), faced.at[n], S);
        }
        const int most = int(m_places.size()) * texels;
        for (std::size_t n = 0; n < wanted.count; ++n) {
            const std::size_t i = wanted.at[n];
            const Floats lit = load(S, i), share = most == 1 ? lit : hn::Div(lit, all(float(most)));
            store(hn::IfThenElse(wanted.mask(n), share, all(1)), S, i);
        }
    }

private:
    // The lanes whose plane faces a place: n·L > 0, with L normalised as in the scalar stage.
    template <class A>
    HWY_INLINE Mask isFaced(Vec3<float> from, Floats3 position, Floats3 normal, Mask wanted) const {
        const Floats3 place = all(from);
        if (m_atInfinity) return hn::Gt(A::dot(normal, place), all(0));
        const Floats3 L = place - position;
        const Floats along = A::dot(normal, L);
        if constexpr (!A::kExact) return hn::Gt(along, all(0));
        // Rounding errs by less than 2^-21 |L|, and by less than 2^-20 once L is normalised. So the sign can only
        // change for numbers nearer to 0.
        const Floats size = hn::Add(hn::Add(hn::Abs(L.x), hn::Abs(L.y)), hn::Abs(L.z));
        const Mask sure =
            hn::And(hn::Gt(hn::Abs(along), hn::Mul(size, all(0x1p-18F))),
                    hn::And(hn::Lt(size, all(kLargestUnscaled)), hn::Gt(size, all(1 / kLargestUnscaled))));
        if (HWY_LIKELY(hn::AllTrue(F(), hn::Or(sure, hn::Not(wanted))))) return hn::Gt(along, all(0));
        return hn::Gt(A::dot(normal, A::unit(L, wanted)), all(0));
    }

    // True if all of these polygons face every place of the light. It tests the corners of the rectangle of places,
    // with a margin so that rounding does not matter.
    template <class A>
    HWY_INLINE bool isFacedByAll(Floats3 position, Floats3 normal, Mask wanted) const {
        if (m_corners.empty()) return false;
        Floats least = all(std::numeric_limits<float>::infinity()), most = all(0);
        for (const Vec3<float> place : m_corners) {
            const Floats3 L = all(place) - position;
            least = hn::Min(least, A::dot(normal, L));
            most = hn::Max(most, hn::Add(hn::Add(hn::Abs(L.x), hn::Abs(L.y)), hn::Abs(L.z)));
        }
        const Mask sure =
            hn::And(hn::Gt(least, hn::Mul(most, all(0x1p-16F))),
                    hn::And(hn::Lt(most, all(kLargestUnscaled)), hn::Gt(least, all(1 / kLargestUnscaled))));
        return hn::AllTrue(F(), hn::Or(sure, hn::Not(wanted)));
    }

    HWY_INLINE static void addLit(Floats lit, Mask mask, std::size_t i, Row& to) {
        store(hn::Add(load(to, i), hn::IfThenElseZero(mask, lit)), to, i);
    }
    // Adds the number of lit texels for prepared look-ups, for the pixels in `wanted`.
    HWY_INLINE void addLookUps(const LightFace& face, const LookUps& lookUps, const Group& wanted, Row& lit) const {
        for (std::size_t n = 0; n < wanted.count; ++n) {
            const std::size_t i = wanted.at[n];
            const Floats bias = load(lookUps.bias, i);
            const Floats of = m_settings.filter == 0 ? litInTexel(face, m_settings, lookUps, bias, i)
                                                     : litInTexels(face, m_settings, lookUps, bias, i);
            addLit(of, wanted.mask(n), i, lit);
        }
    }
    template <class A>
    HWY_INLINE void addFace(const LightFace& face, const SurfaceRow& row, const Group& faced, Row& lit) const {
        LookUps lookUps;
        Group asking;
        for (std::size_t n = 0; n < faced.count; ++n) {
            const std::size_t i = faced.at[n];
            const Mask mask = faced.mask(n);
            if (hn::AllFalse(F(), mask)) continue;
            const Floats3 p = face.along<A>(load(row.position, i) - all(face.eye));
            const Floats3 normal = face.along<A>(load(row.facing, i));
            prepareLookUps<A>(face, m_settings, {p.x, p.y, p.z, normal, all(0)}, i, lookUps);
            asking.add(i, faced.bits[n]);
        }
        addLookUps(face, lookUps, asking, lit);
    }
    // Looks up each point on the cube face that it is on. first: the index of the face to try first.
    template <class A>
    HWY_INLINE void addCube(const LightFace* faces, std::size_t& first, const SurfaceRow& row, Group& faced,
                            Row& lit) const {
        for (std::size_t tries = 0, begin = first; tries < 6; ++tries) {
            first = (begin + tries) % 6;
            const LightFace& face = faces[first];
            const bool backwards = first % 2 != 0;
            const bool done = first < 2   ? addCubeFace<A, 0>(face, backwards, row, faced, lit)
                              : first < 4 ? addCubeFace<A, 1>(face, backwards, row, faced, lit)
                                          : addCubeFace<A, 2>(face, backwards, row, faced, lit);
            if (done) return;
        }
    }
    // Looks up the points on the face along axis kAxis and removes them from `left`; returns whether none are left.
    template <class A, int kAxis>
    HWY_NOINLINE bool addCubeFace(const LightFace& face, bool backwards, const SurfaceRow& row, Group& left,
                                  Row& lit) const {
        std::uint32_t rest = 0;
        LookUps lookUps;
        Group asking;
        const Floats flipped = all(backwards ? -1.0F : 1.0F);
        for (std::size_t n = 0; n < left.count; ++n) {
            const std::size_t i = left.at[n];
            const Floats3 world = load(row.position, i) - all(face.eye);
            const Floats x = hn::Abs(world.x), y = hn::Abs(world.y), z = hn::Abs(world.z);
            const Mask most = kAxis == 0   ? hn::Ge(x, hn::Max(y, z))
                              : kAxis == 1 ? hn::And(hn::Gt(y, x), hn::Ge(y, z))
                                           : hn::Gt(z, hn::Max(x, y));
            const Floats along = kAxis == 0 ? world.x : kAxis == 1 ? world.y : world.z;
            const Mask ahead = backwards ? hn::Lt(along, all(0)) : hn::Ge(along, all(0));
            const Mask here = hn::And(left.mask(n), hn::And(most, ahead));
            const std::uint32_t bits = bitsOf(here);
            rest |= left.bits[n] &= ~bits;
            if (bits == 0) continue;
            const Floats3 N = load(row.facing, i);
            const auto turned = [](Floats3 v) HWY_ATTR {
                return kAxis == 0 ? Floats3{v.y, v.z, v.x} : kAxis == 1 ? Floats3{v.x, v.z, v.y} : v;
            };
            const Floats3 p = turned(world), normal = turned(N);
            const SeenByLight seen{p.x, p.y, hn::Mul(p.z, flipped), normal, A::dot(normal, p)};
            prepareLookUps<A>(face, m_settings, seen, i, lookUps);
            asking.add(i, bits);
        }
        addLookUps(face, lookUps, asking, lit);
        return rest == 0;
    }

    const ShadowSettings& m_settings;
    bool m_casts, m_atInfinity;
    std::vector<LightFace> m_faces;      // sample after sample, six of a point light; none without a shadow buffer
    std::vector<Vec3<float>> m_places;   // of its samples; for a light at infinity the direction towards it
    std::vector<Vec3<float>> m_corners;  // corners of the rectangle of places, if there are more than four
};

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
