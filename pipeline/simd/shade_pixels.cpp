#include "pipeline/simd/shade_pixels.h"

#include <algorithm>
#include <bit>
#include <vector>

#include "pipeline/simd/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/simd/shade_pixels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
//
#include "pipeline/simd/elements.h"
#include "pipeline/simd/power.h"
#include "pipeline/simd/put_pixels.h"
#include "pipeline/stages/shading_terms.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {
namespace {

// What a light makes of a material.
struct Reflected {
    Vec3<float> diffuse, specular;
};
// Of an object whose pixels are shaded.
struct Look {
    bool powers, halfway;  // whether there is a highlight, and of which form
    float exponent;
    BaseTerms<float> base;
    std::vector<Reflected> lights;

    Look(const ShadingInputs& inputs, const Material& material)
        : powers(material.specular != Vec3d(0) || inputs.illumination.detail.dull),
          halfway(usesHalfway(inputs.illumination.model, material)),
          exponent(float((halfway ? inputs.illumination.exponentFactor : 1.0) * material.exponent)),
          base(baseTerms<float>(inputs, material)) {
        for (const Light& light : inputs.lights) {
            const Vec3<float> shining(light.intensity * light.color);
            lights.push_back({shining * Vec3<float>(material.diffuse), shining * Vec3<float>(material.specular)});
        }
    }
};

HWY_INLINE long long countOf(Mask mask) { return static_cast<long long>(hn::CountTrue(F(), mask)); }

HWY_INLINE Mask isZero(Floats3 v) {
    return hn::And(hn::Eq(v.x, all(0)), hn::And(hn::Eq(v.y, all(0)), hn::Eq(v.z, all(0))));
}
HWY_INLINE Floats3 where(Mask mask, Floats3 v) {
    return {hn::IfThenElseZero(mask, v.x), hn::IfThenElseZero(mask, v.y), hn::IfThenElseZero(mask, v.z)};
}

// A row of blocks on its way to the picture.
struct ShadedRow {
    SurfaceRow surface;
    Row3 N, V;                                    // unit
    Row3 emission, ambient;                       // where they are kept
    Row3 L, R, H;                                 // of a light, where they are kept
    Row nDotL, rDotV, nDotH;                      // likewise
    Row3 diffuse, specular;                       // of a light, without its shadow and then in it
    Row shadow;                                   // S
    Row3 intensity;                               // the sum
    alignas(64) std::int32_t object[kRowPixels];  // that is seen
};

// The pixels of a tile.
template <class A>
class TileShader {
public:
    // Polygons or vertices of `out` have been shaded.
    TileShader(const ShadingInputs& inputs, const ShadingSources<float>& in, Tile tile, ShadingOutput<float>& out)
        : m_inputs(inputs), m_in(in), m_tile(tile), m_out(out), m_surfaces(inputs, in, tile), m_bytes(out.iMax) {
        for (std::size_t id = 0; id < kBufferCount; ++id)
            m_keeps = m_keeps || (id != index(BufferId::Intensity) && has(BufferId(id)));
        for (const Material& material : inputs.materials) m_looks.emplace_back(inputs, material);
        for (std::size_t k = 0; k < inputs.lights.size(); ++k) m_shadows.emplace_back(inputs, in, k);
    }

    ShadingCounts shade() {
        for (int y = 0; y * kBlock < m_tile.max.y - m_tile.min.y; ++y) {
            m_first = std::size_t(y) * kRowPixels;
            m_surfaces.find(y, m_row.surface);
            m_inputs.shading == Shading::Phong ? shadePhong() : shadeGathered();
            write();
        }
        return m_counts;
    }

private:
    bool has(BufferId id) const { return !m_out.vectors[index(id)].empty() || !m_out.scalars[index(id)].empty(); }
    HWY_INLINE Mask seen(std::size_t i) const { return seenIn(m_row.surface.triangle + i); }
    // Calls body(i, mask) for the vectors of the row in which something is seen.
    template <class Body>
    HWY_INLINE void forEachSeen(Body body) {
        for (std::size_t i = 0; i < kRowPixels; i += hn::Lanes(F()))
            if (const Mask mask = seen(i); !hn::AllFalse(F(), mask)) body(i, mask);
    }
    // The same for those of an object.
    template <class Body>
    HWY_INLINE void forEachOf(std::size_t object, Body body) {
        if (m_looks.size() == 1) return forEachSeen(body);
        const Ints wanted = hn::Set(I(), std::int32_t(object));
        forEachSeen([&](std::size_t i, Mask mask) HWY_ATTR {
            const auto mine = hn::Eq(hn::Load(I(), m_row.object + i), wanted);
            const Mask both = hn::And(mask, asFloats(mine));
            if (!hn::AllFalse(F(), both)) body(i, both);
        });
    }

    void keep(BufferId id, const Row3& row, std::size_t k = 0) {
        auto& buffers = m_out.vectors[index(id)];
        if (buffers.empty()) return;
        forEachSeen([&](std::size_t i, Mask mask) HWY_ATTR {
            const Floats3 v = load(row, i);
            putPixels(v, mask, m_first + i, m_tile.min, buffers[k]);
        });
    }
    void keep(BufferId id, const Row& row, std::size_t k = 0) {
        auto& buffers = m_out.scalars[index(id)];
        if (buffers.empty()) return;
        forEachSeen([&](std::size_t i, Mask mask)
                        HWY_ATTR { putPixels(load(row, i), mask, m_first + i, m_tile.min, buffers[k]); });
    }

    void shadePhong() {
        const std::vector<std::size_t> objects = findObjects();
        orient();
        for (const std::size_t object : objects) beginIntensity(object);
        if (m_keeps) {
            keep(BufferId::Position, m_row.surface.position), keep(BufferId::Normal, m_row.N);
            keep(BufferId::ViewVector, m_row.V);
            keep(BufferId::Emission, m_row.emission), keep(BufferId::Ambient, m_row.ambient);
        }
        for (std::size_t k = 0; k < m_inputs.lights.size(); ++k) {
            if (!m_inputs.parts.lights[k]) continue;
            if (m_keeps) clearVectors();
            for (const std::size_t object : objects) m_keeps ? reflect<true>(k, object) : reflect<false>(k, object);
            if (m_keeps) {
                keep(BufferId::LightVector, m_row.L, k), keep(BufferId::NDotL, m_row.nDotL, k);
                keep(BufferId::ReflectionVector, m_row.R, k), keep(BufferId::RDotV, m_row.rDotV, k);
                keep(BufferId::HalfwayVector, m_row.H, k), keep(BufferId::NDotH, m_row.nDotH, k);
            }
            addLight(k);
        }
    }

    // Those seen in the row, and which of them in each pixel.
    std::vector<std::size_t> findObjects() {
        std::vector<std::size_t> found;
        if (m_looks.size() == 1) return {0};
        const auto* objects = reinterpret_cast<const std::int32_t*>(m_in.transform.topology->polygonObject.data());
        forEachSeen([&](std::size_t i, Mask mask) HWY_ATTR {
            hn::Store(hn::GatherIndex(I(), objects, hn::Load(I(), m_row.surface.polygon + i)), I(), m_row.object + i);
            for (std::uint32_t bits = bitsOf(mask); bits != 0; bits &= bits - 1) {
                const auto object = std::size_t(m_row.object[i + std::size_t(std::countr_zero(bits))]);
                if (std::ranges::find(found, object) == found.end()) found.push_back(object);
            }
        });
        return found;
    }

    void orient() {
        const View& view = m_in.transform.view;
        forEachSeen([&](std::size_t i, Mask mask)
                        HWY_ATTR { store(A::unit(load(m_row.surface.normal, i), mask), m_row.N, i); });
        const Floats3 eye = all(Vec3<float>(view.eye)), forward = all(Vec3<float>(view.forward));
        const Floats3 none = all(Vec3<float>(0));
        forEachSeen([&](std::size_t i, Mask mask) HWY_ATTR {
            if (!m_inputs.parts.viewVector)
                store(none, m_row.V, i);
            else if (view.perspective)
                store(A::unit(eye - load(m_row.surface.position, i), mask), m_row.V, i);
            else
                store({hn::Neg(forward.x), hn::Neg(forward.y), hn::Neg(forward.z)}, m_row.V, i);
        });
    }

    void beginIntensity(std::size_t object) {
        const BaseTerms<float>& base = m_looks[object].base;
        fill(object, all(sumOf(base)), m_row.intensity);
        if (has(BufferId::Emission)) fill(object, all(base.emission), m_row.emission);
        if (has(BufferId::Ambient)) fill(object, all(base.ambient), m_row.ambient);
    }
    void fill(std::size_t object, Floats3 value, Row3& to) {
        forEachOf(object, [&](std::size_t i, Mask mask) HWY_ATTR { store(choose(mask, value, load(to, i)), to, i); });
    }
    void clearVectors() {
        for (Row3* row : {&m_row.L, &m_row.R, &m_row.H}) *row = {};
        for (Row* row : {&m_row.nDotL, &m_row.rDotV, &m_row.nDotH}) *row = {};
    }

    // The terms of light k over the pixels of an object, as without shadows. keeps: also the vectors of it.
    template <bool kKeeps>
    void reflect(std::size_t k, std::size_t object) {
        const Light& light = m_inputs.lights[k];
        const LightDetail detail = m_inputs.illumination.detail;
        const Look& look = m_looks[object];
        const bool atInfinity = light.kind == LightKind::AtInfinity;
        const Vec3<float> place(light.position);
        const Floats3 source = all(atInfinity ? normalized(place) : place);
        const Reflected reflected = look.lights[k];
        const bool mirrors = look.powers && !look.halfway, halves = look.powers && look.halfway;
        const Floats exponent = all(look.exponent);
        ShadingCounts counts;
        forEachOf(object, [&](std::size_t i, Mask mask) HWY_ATTR {
            const Floats3 N = load(m_row.N, i), V = load(m_row.V, i);
            const Floats3 L = atInfinity ? source : A::unit(source - load(m_row.surface.position, i), mask);
            const Floats nDotL = A::dot(N, L);
            const Mask lit = hn::And(mask, hn::Gt(nDotL, all(0)));
            counts.evaluations += countOf(mask);
            if constexpr (kKeeps) putInto(mask, L, m_row.L, i), putInto(mask, nDotL, m_row.nDotL, i);
            Floats power = all(0), q = power;
            Mask towards = lit;
            if (mirrors || (kKeeps && detail.reflection)) {
                const Floats3 R = scaled(N, hn::Add(nDotL, nDotL)) - L;
                const Floats rDotV = A::dot(R, V);
                if constexpr (kKeeps) putInto(mask, R, m_row.R, i), putInto(mask, rDotV, m_row.rDotV, i);
                if (mirrors) towards = hn::And(lit, hn::Gt(rDotV, all(0))), q = halfSquare<A>(R, V);
            }
            if (halves || (kKeeps && detail.halfway)) {
                const Floats3 H = A::unit(L + V, mask);
                const Floats nDotH = A::dot(N, H);
                if constexpr (kKeeps) putInto(mask, H, m_row.H, i), putInto(mask, nDotH, m_row.nDotH, i);
                if (halves) towards = hn::And(lit, hn::Gt(nDotH, all(0))), q = halfSquare<A>(N, H);
            }
            if (look.powers) {
                if (!hn::AllFalse(F(), towards)) power = powerOfCosines<A>(q, exponent, towards);
                const Mask vanished = hn::And(towards, hn::Gt(hn::Mul(exponent, q), all(kVanishing<float>)));
                const long long vanishing = detail.vanishing ? 0 : countOf(vanished);
                counts.vanished += vanishing, counts.powers += countOf(towards) - vanishing;
            }
            // Never -0: what is left out is +0.
            const Floats3 specular = scaled(all(reflected.specular), power) + all(Vec3<float>(0));
            putInto(mask, where(lit, scaled(all(reflected.diffuse), nDotL)), m_row.diffuse, i);
            putInto(mask, where(towards, specular), m_row.specular, i);
        });
        m_counts += counts;
    }
    // Of pixels of one object among others'.
    HWY_INLINE void putInto(Mask mask, Floats3 v, Row3& to, std::size_t i) const {
        store(m_looks.size() == 1 ? v : choose(mask, v, load(to, i)), to, i);
    }
    HWY_INLINE void putInto(Mask mask, Floats v, Row& to, std::size_t i) const {
        store(m_looks.size() == 1 ? v : hn::IfThenElse(mask, v, load(to, i)), to, i);
    }

    // The terms of light k in its shadow, added to the intensity.
    void addLight(std::size_t k) {
        const bool casts = m_shadows[k].casts || m_shadows[k].looksUp();
        if (casts) findShadows(m_shadows[k]);
        forEachSeen([&](std::size_t i, Mask) HWY_ATTR {
            Floats3 diffuse = load(m_row.diffuse, i), specular = load(m_row.specular, i);
            if (casts) {
                const Floats S = load(m_row.shadow, i);
                diffuse = scaled(diffuse, S), specular = scaled(specular, S);
                if (m_keeps) store(diffuse, m_row.diffuse, i), store(specular, m_row.specular, i);
            }
            store(load(m_row.intensity, i) + diffuse + specular, m_row.intensity, i);
        });
        if (!m_keeps) return;
        if (!casts) std::ranges::fill(m_row.shadow.of, 1.0F);
        keep(BufferId::Shadow, m_row.shadow, k);
        keep(BufferId::Diffuse, m_row.diffuse, k), keep(BufferId::Specular, m_row.specular, k);
    }
    void findShadows(const ShadowLight& light) {
        const bool everywhere = m_inputs.parts.idleLookups || has(BufferId::Shadow);
        forEachSeen([&](std::size_t i, Mask mask) HWY_ATTR {
            const Mask idle = hn::And(isZero(load(m_row.diffuse, i)), isZero(load(m_row.specular, i)));
            const Mask wanted = everywhere ? mask : hn::AndNot(idle, mask);
            const Floats3 position = load(m_row.surface.position, i), normal = load(m_row.surface.facing, i);
            store(light.template factors<A>(m_inputs.shadow, position, normal, wanted), m_row.shadow, i);
            if (!light.looksUp()) return;
            const long long lookups = countOf(wanted);
            m_counts.lookups += lookups, m_counts.idleLookups += countOf(mask) - lookups;
        });
    }

    // Flat or Gouraud shading: what polygons or vertices have, and the shadows of the pixels.
    void shadeGathered() {
        const auto& elements = m_inputs.shading == Shading::Flat ? m_out.polygons : m_out.vertices;
        forEachSeen([&](std::size_t i, Mask mask) HWY_ATTR {
            const Elements<A> at(m_inputs, m_in, m_row.surface, i, mask);
            const Floats3 emission = at.difference(elements.base, 0), ambient = at.difference(elements.base, 1);
            store(all(Vec3<float>(0)) + emission + ambient, m_row.intensity, i);
            if (m_keeps) store(emission, m_row.emission, i), store(ambient, m_row.ambient, i);
        });
        if (m_keeps) {
            keep(BufferId::Position, m_row.surface.position);
            keep(BufferId::Emission, m_row.emission), keep(BufferId::Ambient, m_row.ambient);
        }
        const auto lights = std::int32_t(m_inputs.lights.size());
        for (std::size_t k = 0; k < m_inputs.lights.size(); ++k) {
            if (!m_inputs.parts.lights[k]) continue;
            forEachSeen([&](std::size_t i, Mask mask) HWY_ATTR {
                const Elements<A> at(m_inputs, m_in, m_row.surface, i, mask);
                store(at.sum(elements.terms, lights, std::int32_t(k), 0), m_row.diffuse, i);
                store(at.sum(elements.terms, lights, std::int32_t(k), 1), m_row.specular, i);
            });
            addLight(k);
        }
    }
    // The row's intensity and color, 0 where nothing is seen.
    void write() {
        auto& intensities = m_out.vectors[index(BufferId::Intensity)];
        ColorRows colors;
        for (std::size_t i = 0; i < kRowPixels; i += hn::Lanes(F())) {
            const Mask mask = seen(i);
            if (intensities.empty() && hn::AllFalse(F(), mask)) {
                colors.put(hn::Zero(I()), hn::Zero(I()), hn::Zero(I()), i);
                continue;
            }
            const Floats3 v = where(mask, load(m_row.intensity, i));
            colors.put(m_bytes.template of<A>(v.x), m_bytes.template of<A>(v.y), m_bytes.template of<A>(v.z), i);
            if (const Mask inTile = within(m_tile, m_first + i); !intensities.empty() && !hn::AllFalse(F(), inTile))
                putPixels(v, inTile, m_first + i, m_tile.min, intensities[0]);
        }
        colors.copyTo(m_tile, int(m_first / kRowPixels) * kBlock, m_out.color);
    }

    const ShadingInputs& m_inputs;
    const ShadingSources<float>& m_in;
    Tile m_tile;
    ShadingOutput<float>& m_out;
    Surfaces<A> m_surfaces;
    ToBytes m_bytes;
    bool m_keeps = false;                // any buffer beside color and intensity
    std::vector<Look> m_looks;           // per object
    std::vector<ShadowLight> m_shadows;  // per light
    std::size_t m_first = 0;             // of the row, in the tile
    ShadedRow m_row;
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
    return inputs.parts.fast ? shadeTile<Fast>(inputs, in, tile, out) : shadeTile<Exact>(inputs, in, tile, out);
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
        std::fill_n(&out.color.pixels[at], tile.max.x - tile.min.x, Color8(0));
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
