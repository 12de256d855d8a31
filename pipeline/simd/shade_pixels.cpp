#include "pipeline/simd/shade_pixels.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <vector>

#include "pipeline/simd/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/simd/shade_pixels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
//
#include "pipeline/simd/casters.h"
#include "pipeline/simd/elements.h"
#include "pipeline/simd/groups.h"
#include "pipeline/simd/highlights.h"
#include "pipeline/simd/keep_incidence.h"
#include "pipeline/simd/look.h"
#include "pipeline/simd/put_pixels.h"
#include "pipeline/simd/surfaces.h"
#include "pipeline/simd/view_vectors.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {
namespace {

// The terms that one light adds, in each lane.
struct Terms {
    Floats3 diffuse, specular;
};

HWY_INLINE Mask isZero(Floats3 v) {
    return hn::And(hn::Eq(v.x, all(0)), hn::And(hn::Eq(v.y, all(0)), hn::Eq(v.z, all(0))));
}
HWY_INLINE Mask isZero(const Terms& of) { return hn::And(isZero(of.diffuse), isZero(of.specular)); }
// The largest absolute value of the three components.
HWY_INLINE float largest(Vec3<float> v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// A row of blocks while it is shaded. Each loop over the row leaves its results here for the next loop.
struct ShadedRow {
    SurfaceRow surface;
    Row3 V;                    // stored if several lights or buffers read it
    Row nDotL, q, log, power;  // of one light; q: 1 - R·V or 1 - N·H; log: log(1 - q), where it is kept
    ElementRow elements;       // in flat and Gouraud shading
    Row3 diffuse, specular;    // of one light, in flat and Gouraud shading
    Row S;
    Row3 intensity;  // the sum
};

// Shades the pixels of one tile.
template <class A>
class TileShader {
public:
    // The polygons or vertices in `out` must have been shaded before.
    TileShader(const ShadingInputs& inputs, const ShadingSources<float>& in, Tile tile, ShadingOutput<float>& out)
        : m_inputs(inputs),
          m_in(in),
          m_tile(tile),
          m_out(out),
          m_casters(inputs, in),
          m_surfaces(inputs, in, tile, m_casters.biases, m_casters.facing),
          m_views(in.transform.view, tile),
          m_bytes(out.iMax) {
        for (std::size_t id = 0; id < kBufferCount; ++id)
            m_keeps = m_keeps || (id != index(BufferId::Intensity) && has(BufferId(id)));
        for (const Material& material : inputs.materials) m_looks.emplace_back(inputs, material);
        for (const Light& light : inputs.lights) m_lights.emplace_back(light);
        m_vanishesFrom = vanishesFrom<float>(inputs.illumination.detail.logContrast);
        m_lookUps.resize(m_casters.biases.size());
        const bool isViewed = inputs.shading == Shading::Phong && inputs.parts[Part::ViewVector];
        m_sharesViews = isViewed && (m_keeps || inputs.parts.count(Part::Light) > 1);
        if (!m_keeps && !out.incidence.empty()) m_keeper.emplace(inputs.lights.size());
    }

    ShadingCounts shade() {
        for (int y = 0; y * kBlock < m_tile.max.y - m_tile.min.y; ++y) {
            m_first = std::size_t(y) * kRowPixels;
            m_surfaces.find(y, m_row.surface);
            m_views.beginRow(y);
            if (m_sharesViews) leaveViews();
            for (std::size_t k = 0; k < m_lights.size(); ++k)
                if (const auto bias = m_casters.biasOf[k]; bias && m_inputs.parts.of(Part::Light, k))
                    m_casters.lights[k].template prepare<A>(m_row.surface, m_row.surface.bias[*bias], m_lookUps[*bias]);
            m_groups.find(m_row.surface, m_surfaces.tellsObjects());
            m_isAlone = m_groups.areOne();
            for (std::size_t i = 0; !m_isAlone && i < kRowPixels; i += hn::Lanes(F()))
                store(all(Vec3<float>(0)), m_row.intensity, i);
            for (const Group& group : m_groups.all()) {
                if (m_inputs.shading == Shading::Phong)
                    m_keeps ? shadePhong<true>(group) : shadePhong<false>(group);
                else
                    m_keeps ? shadeGathered<true>(group) : shadeGathered<false>(group);
            }
            const auto pixelsAt = [&](std::size_t i) HWY_ATTR { return m_row.surface.seenAt(i); };
            putRow<A>(m_row.intensity, m_groups.blocks(), pixelsAt, m_bytes, m_tile, y, m_out);
            if (m_keeper) m_keeper->endRow(std::size_t(y));
        }
        if (m_keeper) m_out.incidence[tileAt(m_in.transform.view.size, m_tile)] = m_keeper->whole();
        return m_counts;
    }

private:
    bool has(BufferId id) const { return !m_out.vectors[index(id)].empty() || !m_out.scalars[index(id)].empty(); }
    HWY_INLINE void keep(BufferId id, Floats3 value, Mask mask, std::size_t i, std::size_t k = 0) {
        auto& buffers = m_out.vectors[index(id)];
        if (!buffers.empty()) putPixels(value, mask, m_first + i, m_tile.min, buffers[k]);
    }
    HWY_INLINE void keep(BufferId id, Floats value, Mask mask, std::size_t i, std::size_t k = 0) {
        auto& buffers = m_out.scalars[index(id)];
        if (!buffers.empty()) putPixels(value, mask, m_first + i, m_tile.min, buffers[k]);
    }

    // Writes the intensity of a group's pixels; lanes that belong to another group keep theirs.
    HWY_INLINE void putIntensity(Floats3 v, Mask mask, std::size_t i) {
        store(m_isAlone ? v : choose(mask, v, load(m_row.intensity, i)), m_row.intensity, i);
    }

    template <bool kKeeps>
    void shadePhong(const Group& group) {
        const Look& look = m_looks[group.object];
        const Floats3 base = all(sumOf(look.base));
        // With one group and no other buffers the first light starts from the base, without a pass that writes it.
        bool isLeft = kKeeps || !m_isAlone;
        if (isLeft) leaveBase<kKeeps>(group, look);
        if (m_keeper) m_keeper->add(group, look.highlight);
        for (std::size_t k = 0; k < m_lights.size(); ++k) {
            if (!m_inputs.parts.of(Part::Light, k)) continue;
            switch (look.highlight) {
                case SpecularForm::None: reflect<kKeeps, SpecularForm::None>(group, k); break;
                case SpecularForm::Reflection: reflect<kKeeps, SpecularForm::Reflection>(group, k); break;
                case SpecularForm::Halfway: reflect<kKeeps, SpecularForm::Halfway>(group, k); break;
            }
            const bool shines = look.highlight != SpecularForm::None;
            if (shines) raise(group, look.exponent);
            const Reflected& reflected = look.lights[k];
            const auto terms = [&](std::size_t n) HWY_ATTR {
                const std::size_t i = group.at[n];
                const Floats nDotL = load(m_row.nDotL, i), power = shines ? load(m_row.power, i) : all(0);
                const Floats3 specular = scaled(all(reflected.specular), power);
                // Kept terms are never -0, because a term left out is +0. A sum that begins with +0 is never -0.
                return Terms{where(hn::Gt(nDotL, all(0)), scaled(all(reflected.diffuse), nDotL)),
                             kKeeps ? specular + all(Vec3<float>(0)) : specular};
            };
            const Floats mostDiffuse = all(largest(reflected.diffuse)), mostSpecular = all(largest(reflected.specular));
            const auto areZero = [&](std::size_t n) HWY_ATTR {
                if (HWY_UNLIKELY(!look.isFinite)) return isZero(terms(n));
                // All products have the same factor, so the product with the largest one is the last to round to 0.
                const std::size_t i = group.at[n];
                const Floats nDotL = load(m_row.nDotL, i), power = shines ? load(m_row.power, i) : all(0);
                const Mask dark = hn::Or(hn::Not(hn::Gt(nDotL, all(0))), hn::Eq(hn::Mul(mostDiffuse, nDotL), all(0)));
                return hn::And(dark, hn::Eq(hn::Mul(mostSpecular, power), all(0)));
            };
            const bool isDimmed = dim<kKeeps>(group, k, areZero);
            addLight<kKeeps>(group, k, isLeft ? nullptr : &base, [&](std::size_t n) HWY_ATTR {
                const Terms of = terms(n);
                return isDimmed ? dimmed(of, group.at[n]) : of;
            });
            isLeft = true;
            if (m_keeper)
                m_keeper->addLight(group, k, m_row.nDotL, shines ? &m_row.log : nullptr,
                                   m_casters.lights[k].casts() ? &m_row.S : nullptr);
        }
        if (!isLeft) leaveBase<kKeeps>(group, look);
    }

    void leaveViews() {
        for (std::size_t i = 0; i < kRowPixels; i += hn::Lanes(F()))
            if (const Mask seen = m_row.surface.seenAt(i); !hn::AllFalse(F(), seen))
                store(m_views.template at<A>(i, seen), m_row.V, i);
    }
    // Writes the intensity without any light: emission and ambient.
    template <bool kKeeps>
    void leaveBase(const Group& group, const Look& look) {
        const Floats3 base = all(sumOf(look.base));
        for (std::size_t n = 0; n < group.count; ++n) {
            const std::size_t i = group.at[n];
            const Mask mask = group.mask(n);
            putIntensity(base, mask, i);
            if constexpr (kKeeps) {
                keep(BufferId::Position, load(m_row.surface.position, i), mask, i);
                keep(BufferId::Normal, load(m_row.surface.N, i), mask, i);
                keep(BufferId::ViewVector, load(m_row.V, i), mask, i);
                keep(BufferId::Emission, all(look.base.emission), mask, i);
                keep(BufferId::Ambient, all(look.base.ambient), mask, i);
            }
        }
    }

    // Writes N·L of light k, and q of its highlight: kNoHighlight where there is none.
    template <bool kKeeps, SpecularForm kForm>
    void reflect(const Group& group, std::size_t k) {
        const LightDetail& detail = m_inputs.illumination.detail;
        const bool atInfinity = m_lights[k].atInfinity;
        const Floats3 source = all(m_lights[k].source);
        for (std::size_t n = 0; n < group.count; ++n) m_counts.evaluations += std::popcount(group.bits[n]);
        for (std::size_t n = 0; n < group.count; ++n) {
            const std::size_t i = group.at[n];
            const Mask mask = group.mask(n);
            const Floats3 N = load(m_row.surface.N, i);
            const Floats3 V = m_sharesViews ? load(m_row.V, i) : m_views.template at<A>(i, mask);
            const Floats3 L = atInfinity ? source : A::unit(source - load(m_row.surface.position, i), mask);
            const Floats nDotL = A::dot(N, L);
            const Mask lit = hn::And(mask, hn::Gt(nDotL, all(0)));
            store(nDotL, m_row.nDotL, i);
            if constexpr (kKeeps) keep(BufferId::LightVector, L, mask, i, k), keep(BufferId::NDotL, nDotL, mask, i, k);
            if (kForm == SpecularForm::Reflection || (kKeeps && detail.reflection)) {
                const Floats3 R = scaled(N, hn::Add(nDotL, nDotL)) - L;
                const Floats rDotV = A::dot(R, V);
                if constexpr (kKeeps)
                    keep(BufferId::ReflectionVector, R, mask, i, k), keep(BufferId::RDotV, rDotV, mask, i, k);
                if constexpr (kForm == SpecularForm::Reflection)
                    storeHighlight(halfSquare<A>(R, V), hn::And(lit, hn::Gt(rDotV, all(0))), i);
            }
            if (kForm == SpecularForm::Halfway || (kKeeps && detail.halfway)) {
                const Floats3 H = A::unit(L + V, mask);
                const Floats nDotH = A::dot(N, H);
                if constexpr (kKeeps)
                    keep(BufferId::HalfwayVector, H, mask, i, k), keep(BufferId::NDotH, nDotH, mask, i, k);
                if constexpr (kForm == SpecularForm::Halfway)
                    storeHighlight(halfSquare<A>(N, H), hn::And(lit, hn::Gt(nDotH, all(0))), i);
            }
        }
    }
    HWY_INLINE void storeHighlight(Floats q, Mask there, std::size_t i) {
        store(hn::IfThenElse(there, q, all(kNoHighlight)), m_row.q, i);
    }

    void raise(const Group& group, float exponent) {
        HighlightCounts counts =
            raiseHighlights<A>(group, exponent, m_vanishesFrom, m_row.q, m_row.power, m_keeper ? &m_row.log : nullptr);
        if (m_inputs.illumination.detail.vanishing) counts.vanished = 0;
        m_counts.vanished += counts.vanished, m_counts.powers += counts.there - counts.vanished;
    }

    // Adds the terms of light k to the intensity, or to `base` if it is given. terms(n): of vector n, with the shadow.
    template <bool kKeeps, class TermsOf>
    void addLight(const Group& group, std::size_t k, const Floats3* base, TermsOf terms) {
        for (std::size_t n = 0; n < group.count; ++n) {
            const std::size_t i = group.at[n];
            const Mask mask = group.mask(n);
            const Terms of = terms(n);
            if constexpr (kKeeps) {
                keep(BufferId::Shadow, isDimmed(k) ? load(m_row.S, i) : all(1), mask, i, k);
                keep(BufferId::Diffuse, of.diffuse, mask, i, k), keep(BufferId::Specular, of.specular, mask, i, k);
            }
            const Floats3 before = base ? *base : load(m_row.intensity, i);
            putIntensity(before + of.diffuse + of.specular, mask, i);
        }
    }
    bool isDimmed(std::size_t k) const { return m_casters.lights[k].casts() || m_casters.lights[k].looksUp(); }
    // Where the terms are 0, S may be any finite number.
    HWY_INLINE Terms dimmed(const Terms& of, std::size_t i) const {
        const Floats S = load(m_row.S, i);
        return {scaled(of.diffuse, S), scaled(of.specular, S)};
    }
    // Writes S of light k for the lanes whose terms are not 0. Returns whether the light can be dimmed by a shadow.
    // areZero(n): the lanes of vector n whose terms are 0.
    template <bool kKeeps, class AreZero>
    bool dim(const Group& group, std::size_t k, AreZero areZero) {
        if (!isDimmed(k)) return false;
        const ShadowLight& light = m_casters.lights[k];
        const bool everywhere = m_inputs.parts[Part::ShadowLookup] || (kKeeps && has(BufferId::Shadow));
        const auto bias = m_casters.biasOf[k];
        Group wanted;
        long long lookups = 0, pixels = 0;
        for (std::size_t n = 0; n < group.count; ++n) {
            const std::size_t i = group.at[n];
            const Mask mask = group.mask(n), asks = everywhere ? mask : hn::AndNot(areZero(n), mask);
            const std::uint32_t bits = bitsOf(asks);
            lookups += std::popcount(bits), pixels += std::popcount(group.bits[n]);
            if (bits != 0) wanted.add(i, bits);
            Floats S = all(1);
            if (bits != 0 && bias)
                S = hn::IfThenElse(asks, light.factorByPolygon(m_lookUps[*bias], m_row.surface.bias[*bias], i), S);
            store(S, m_row.S, i);
        }
        if (light.looksUp()) m_counts.lookups += lookups, m_counts.idleLookups += pixels - lookups;
        if (light.casts() && !bias) light.template factors<A>(m_row.surface, wanted, m_row.S);
        if (light.casts() && m_keeper) markUnknown(group, wanted);
        return true;
    }

    // Marks S as unknown for the pixels of a group that needed no look-up.
    void markUnknown(const Group& group, const Group& wanted) {
        const Floats unknown = all(Incidence::kUnknownShadow);
        for (std::size_t n = 0, w = 0; n < group.count; ++n) {
            const std::size_t i = group.at[n];
            const bool isWanted = w < wanted.count && wanted.at[w] == i;
            store(isWanted ? hn::IfThenElse(wanted.mask(w), load(m_row.S, i), unknown) : unknown, m_row.S, i);
            w += isWanted;
        }
    }

    // Flat or Gouraud shading: gathers the terms of polygons or vertices, and adds the shadows of the pixels.
    template <bool kKeeps>
    void shadeGathered(const Group& group) {
        const bool isFlat = m_inputs.shading == Shading::Flat;
        const auto& elements = isFlat ? m_out.polygons : m_out.vertices;
        const auto elementsAt = [&](std::size_t n) HWY_ATTR {
            return Elements<A>(isFlat, m_row.elements, m_row.surface.weights, group.at[n]);
        };
        for (std::size_t n = 0; n < group.count; ++n) {
            const std::size_t i = group.at[n];
            const Mask mask = group.mask(n);
            findElements(m_inputs, m_in, elements.places, m_row.surface, i, m_row.elements);
            const Elements<A> at = elementsAt(n);
            const Floats3 emission = at.difference(elements.base, 0), ambient = at.difference(elements.base, 1);
            putIntensity(all(Vec3<float>(0)) + emission + ambient, mask, i);
            if constexpr (kKeeps) {
                keep(BufferId::Position, load(m_row.surface.position, i), mask, i);
                keep(BufferId::Emission, emission, mask, i), keep(BufferId::Ambient, ambient, mask, i);
            }
        }
        const auto lights = std::int32_t(m_lights.size());
        for (std::int32_t k = 0; k < lights; ++k) {
            if (!m_inputs.parts.of(Part::Light, std::size_t(k))) continue;
            for (std::size_t n = 0; n < group.count; ++n) {  // gathered once for all uses below
                const Elements<A> at = elementsAt(n);
                store(at.sum(elements.terms, lights, k, 0), m_row.diffuse, group.at[n]);
                store(at.sum(elements.terms, lights, k, 1), m_row.specular, group.at[n]);
            }
            const auto terms = [&](std::size_t n) HWY_ATTR {
                return Terms{load(m_row.diffuse, group.at[n]), load(m_row.specular, group.at[n])};
            };
            const bool isDimmed =
                dim<kKeeps>(group, std::size_t(k), [&](std::size_t n) HWY_ATTR { return isZero(terms(n)); });
            addLight<kKeeps>(group, std::size_t(k), nullptr, [&](std::size_t n) HWY_ATTR {
                const Terms of = terms(n);
                return isDimmed ? dimmed(of, group.at[n]) : of;
            });
        }
    }

    const ShadingInputs& m_inputs;
    const ShadingSources<float>& m_in;
    Tile m_tile;
    ShadingOutput<float>& m_out;
    Casters m_casters;
    Surfaces<A> m_surfaces;
    ViewVectors m_views;
    bool m_sharesViews;
    float m_vanishesFrom;  // vanishing threshold for n q of a highlight
    ToBytes m_bytes;
    bool m_keeps = false;           // any buffer except color and intensity
    std::vector<Look> m_looks;      // one for each object
    std::vector<Shining> m_lights;  // one for each light
    Groups m_groups;
    bool m_isAlone = false;  // there is only one group, so all lanes are its own
    std::optional<IncidenceKeeper> m_keeper;
    std::size_t m_first = 0;  // first pixel of the row in the tile
    ShadedRow m_row;
    std::vector<LookUps> m_lookUps;  // one for each light whose bias is constant over a polygon
    ShadingCounts m_counts;
};

template <class A>
ShadingCounts shadeTile(const ShadingInputs& inputs, const ShadingSources<float>& in, Tile tile,
                        ShadingOutput<float>& out) {
    return TileShader<A>(inputs, in, tile, out).shade();
}

}  // namespace

ShadingCounts shadeTileInVectors(const ShadingInputs& inputs, const ShadingSources<float>& in, Tile tile,
                                 ShadingOutput<float>& out) {
    return inputs.parts[Part::FastVectors] ? shadeTile<Fast>(inputs, in, tile, out)
                                           : shadeTile<Exact>(inputs, in, tile, out);
}

int lanesHere() { return int(hn::Lanes(F())); }

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pipeline {

HWY_EXPORT(shadeTileInVectors);
HWY_EXPORT(lanesHere);

void leaveTileDark(Tile tile, ShadingOutput<float>& out) {
    for (int y = tile.min.y; y < tile.max.y; ++y) {
        const std::size_t at = out.color.offset({tile.min.x, y});
        std::memset(&out.color.pixels[at], 0, std::size_t(tile.max.x - tile.min.x) * sizeof(Color8));
        for (auto& intensity : out.vectors[index(BufferId::Intensity)])
            std::fill_n(&intensity.pixels[at], tile.max.x - tile.min.x, Vec3<float>(0));
    }
}

ShadingCounts shadePixelsInVectors(const ShadingInputs& inputs, const ShadingSources<float>& in, Tile tile,
                                   ShadingOutput<float>& out) {
    return HWY_DYNAMIC_DISPATCH(shadeTileInVectors)(inputs, in, tile, out);
}

int vectorLanes() { return HWY_DYNAMIC_DISPATCH(lanesHere)(); }

}  // namespace pipeline
#endif
