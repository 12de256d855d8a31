// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_TILE_SHADER_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_TILE_SHADER_H
#undef SHADESCOPE_TILE_SHADER_H
#else
#define SHADESCOPE_TILE_SHADER_H
#endif

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "pipeline/simd/elements.h"
#include "pipeline/simd/groups.h"
#include "pipeline/simd/highlights.h"
#include "pipeline/simd/keep_incidence.h"
#include "pipeline/simd/look.h"
#include "pipeline/simd/microfacets.h"
#include "pipeline/simd/put_pixels.h"
#include "pipeline/simd/row_shadows.h"
#include "pipeline/simd/surfaces.h"
#include "pipeline/simd/view_vectors.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

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
    Row3 diffuse, specular;    // of one light, where N·L and a power are not enough
    Row S;
    Row3 intensity;  // the sum
};

// Shades the pixels of one tile.
template <class A>
class TileShader {
public:
    // The polygons or vertices in `out` must have been shaded before. drawn: shades these triangles instead of the
    // visible ones, and keeps nothing but the intensity.
    HWY_NOINLINE TileShader(const ShadingInputs& inputs, const ShadingSources<float>& in, Tile tile,
                            ShadingOutput<float>& out, const DrawnTile* drawn = nullptr)
        : m_inputs(inputs),
          m_in(in),
          m_tile(tile),
          m_out(out),
          m_constants(inputs),
          m_shadows(inputs, in),
          m_surfaces(inputs, in, tile, m_shadows.biases(), m_shadows.needsPlanes(), drawn),
          m_views(in.transform.view, tile) {
        for (std::size_t id = 0; !drawn && id < kBufferCount; ++id)
            m_keeps = m_keeps || (id != index(BufferId::Intensity) && has(BufferId(id)));
        if (!drawn && !m_keeps && !out.incidence.empty()) m_keeper.emplace(inputs.lights.size());
    }

    // put(y, row, blocks): takes row y with its intensities, and the bit mask of the blocks that show something.
    // Neither a template nor inline: all of the shading would be there once for each.
    HWY_NOINLINE void shade(const std::function<void(int y, const ShadedRow& row, std::uint32_t blocks)>& put) {
        for (int y = 0; y * kBlock < m_tile.max.y - m_tile.min.y; ++y) {
            m_first = std::size_t(y) * kRowPixels;
            m_surfaces.find(y, m_row.surface);
            m_views.beginRow(y);
            if (sharesViews()) leaveViews();
            m_shadows.template prepare<A>(m_row.surface);
            m_groups.find(m_row.surface, m_surfaces.tellsObjects());
            for (std::size_t i = 0; !m_groups.areOne() && i < kRowPixels; i += hn::Lanes(F()))
                store(all(Vec3<float>(0)), m_row.intensity, i);
            for (const Group& group : m_groups.all()) {
                if (m_inputs.shading == Shading::Phong)
                    m_keeps ? shadePhong<true>(group) : shadePhong<false>(group);
                else
                    m_keeps ? shadeGathered<true>(group) : shadeGathered<false>(group);
            }
            put(y, m_row, m_groups.blocks());
            if (m_keeper) m_keeper->endRow(std::size_t(y));
        }
        if (m_keeper) m_out.incidence[tileAt(m_in.transform.view.size, m_tile)] = m_keeper->whole();
    }
    const ShadingCounts& counts() const { return m_counts; }

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

    // Writes the intensity of a group's pixels. Lanes of another group keep theirs. All lanes of an only group are its own.
    HWY_INLINE void putIntensity(Floats3 v, Mask mask, std::size_t i) {
        store(m_groups.areOne() ? v : choose(mask, v, load(m_row.intensity, i)), m_row.intensity, i);
    }

    template <bool kKeeps>
    void shadePhong(const Group& group) {
        const Look& look = m_constants.looks[group.object];
        if (look.highlight == SpecularForm::Microfacets) return shadeMicrofacets<kKeeps>(group, look);
        const Floats3 base = all(sumOf(look.base));
        // With one group and no other buffers the first light starts from the base, without a pass that writes it.
        bool isLeft = kKeeps || !m_groups.areOne();
        if (isLeft) leaveBase<kKeeps>(group, look);
        if (m_keeper) m_keeper->add(group, look.highlight);
        for (std::size_t k = 0; k < m_constants.lights.size(); ++k) {
            if (!m_inputs.parts.of(Part::Light, k)) continue;
            switch (look.highlight) {
                case SpecularForm::None: reflect<kKeeps, SpecularForm::None>(group, k); break;
                case SpecularForm::Reflection: reflect<kKeeps, SpecularForm::Reflection>(group, k); break;
                case SpecularForm::Halfway: reflect<kKeeps, SpecularForm::Halfway>(group, k); break;
                case SpecularForm::Microfacets: break;  // shadeMicrofacets
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
                                   m_shadows.casts(k) ? &m_row.S : nullptr);
        }
        if (!isLeft) leaveBase<kKeeps>(group, look);
    }

    template <bool kKeeps>
    void shadeMicrofacets(const Group& group, const Look& look) {
        leaveBase<kKeeps>(group, look);
        for (std::size_t k = 0; k < m_constants.lights.size(); ++k) {
            if (!m_inputs.parts.of(Part::Light, k)) continue;
            reflect<kKeeps, SpecularForm::Microfacets>(group, k);
            addStored<kKeeps>(group, k);
        }
    }

    // V is read more than once.
    bool sharesViews() const {
        const bool isViewed = m_inputs.shading == Shading::Phong && m_inputs.parts[Part::ViewVector];
        return isViewed && (m_keeps || m_inputs.parts.count(Part::Light) > 1);
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
                keep(BufferId::DiffuseCoefficient, all(look.diffuseCoefficient), mask, i);
                keep(BufferId::Emission, all(look.base.emission), mask, i);
                keep(BufferId::Ambient, all(look.base.ambient), mask, i);
            }
        }
    }

    // Writes N·L of light k, and q of its highlight: kNoHighlight where there is none. Of microfacets: the terms.
    template <bool kKeeps, SpecularForm kForm>
    void reflect(const Group& group, std::size_t k) {
        const LightDetail& detail = m_inputs.illumination.detail;
        const bool atInfinity = m_constants.lights[k].atInfinity, isStored = sharesViews();
        const Floats3 source = all(m_constants.lights[k].source);
        for (std::size_t n = 0; n < group.count; ++n) m_counts.evaluations += std::popcount(group.bits[n]);
        for (std::size_t n = 0; n < group.count; ++n) {
            const std::size_t i = group.at[n];
            const Mask mask = group.mask(n);
            const Floats3 N = load(m_row.surface.N, i);
            const Floats3 V = isStored ? load(m_row.V, i) : m_views.template at<A>(i, mask);
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
            constexpr bool kIsMirrored = kForm == SpecularForm::Microfacets;
            if (kForm == SpecularForm::Halfway || kIsMirrored || (kKeeps && detail.halfway)) {
                const Floats3 H = A::unit(L + V, mask);
                const Floats nDotH = A::dot(N, H);
                if constexpr (kKeeps)
                    keep(BufferId::HalfwayVector, H, mask, i, k), keep(BufferId::NDotH, nDotH, mask, i, k);
                if constexpr (kForm == SpecularForm::Halfway)
                    storeHighlight(halfSquare<A>(N, H), hn::And(lit, hn::Gt(nDotH, all(0))), i);
                if constexpr (kIsMirrored) {
                    const Look& look = m_constants.looks[group.object];
                    const Terms of = microfacetTerms<A>(look.mirrors, look.lights[k], N, H, V, nDotL, nDotH, lit);
                    store(of.diffuse, m_row.diffuse, i), store(of.specular, m_row.specular, i);
                }
            }
        }
    }
    HWY_INLINE void storeHighlight(Floats q, Mask there, std::size_t i) {
        store(hn::IfThenElse(there, q, all(kNoHighlight)), m_row.q, i);
    }

    void raise(const Group& group, float exponent) {
        HighlightCounts counts = raiseHighlights<A>(group, exponent, m_constants.vanishesFrom, m_row.q, m_row.power,
                                                    m_keeper ? &m_row.log : nullptr);
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
                keep(BufferId::Shadow, m_shadows.dims(k) ? load(m_row.S, i) : all(1), mask, i, k);
                keep(BufferId::Diffuse, of.diffuse, mask, i, k), keep(BufferId::Specular, of.specular, mask, i, k);
            }
            const Floats3 before = base ? *base : load(m_row.intensity, i);
            putIntensity(before + of.diffuse + of.specular, mask, i);
        }
    }
    // Where the terms are 0, S may be any finite number.
    HWY_INLINE Terms dimmed(const Terms& of, std::size_t i) const {
        const Floats S = load(m_row.S, i);
        return {scaled(of.diffuse, S), scaled(of.specular, S)};
    }
    // Writes S of light k for the lanes whose terms are not 0. Returns whether the light can be dimmed by a shadow.
    // areZero(n): the lanes of vector n whose terms are 0.
    template <bool kKeeps, class AreZero>
    bool dim(const Group& group, std::size_t k, AreZero areZero) {
        if (!m_shadows.dims(k)) return false;
        const bool everywhere = m_inputs.parts[Part::ShadowLookup] || (kKeeps && has(BufferId::Shadow));
        m_shadows.template find<A>(m_row.surface, group, k, everywhere, m_keeper.has_value(), areZero, m_row.S,
                                   m_counts);
        return true;
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
        const auto lights = std::int32_t(m_constants.lights.size());
        for (std::int32_t k = 0; k < lights; ++k) {
            if (!m_inputs.parts.of(Part::Light, std::size_t(k))) continue;
            for (std::size_t n = 0; n < group.count; ++n) {  // gathered once for all uses below
                const Elements<A> at = elementsAt(n);
                store(at.sum(elements.terms, lights, k, 0), m_row.diffuse, group.at[n]);
                store(at.sum(elements.terms, lights, k, 1), m_row.specular, group.at[n]);
            }
            addStored<kKeeps>(group, std::size_t(k));
        }
    }

    // Adds light k, whose terms stand in m_row.
    template <bool kKeeps>
    void addStored(const Group& group, std::size_t k) {
        const auto terms = [&](std::size_t n) HWY_ATTR {
            return Terms{load(m_row.diffuse, group.at[n]), load(m_row.specular, group.at[n])};
        };
        const bool isDimmed = dim<kKeeps>(group, k, [&](std::size_t n) HWY_ATTR { return isZero(terms(n)); });
        addLight<kKeeps>(group, k, nullptr, [&](std::size_t n) HWY_ATTR {
            const Terms of = terms(n);
            return isDimmed ? dimmed(of, group.at[n]) : of;
        });
    }

    const ShadingInputs& m_inputs;
    const ShadingSources<float>& m_in;
    Tile m_tile;
    ShadingOutput<float>& m_out;
    ShadingConstants m_constants;
    RowShadows m_shadows;
    Surfaces<A> m_surfaces;
    ViewVectors m_views;
    bool m_keeps = false;  // any buffer except color and intensity
    Groups m_groups;
    std::optional<IncidenceKeeper> m_keeper;
    std::size_t m_first = 0;  // first pixel of the row in the tile
    ShadedRow m_row;
    ShadingCounts m_counts;
};

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
