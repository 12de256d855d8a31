// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_ROW_SHADOWS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_ROW_SHADOWS_H
#undef SHADESCOPE_ROW_SHADOWS_H
#else
#define SHADESCOPE_ROW_SHADOWS_H
#endif

#include <optional>
#include <vector>

#include "pipeline/simd/incidence.h"
#include "pipeline/simd/shadows.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// The shadows that lights cast on a row of blocks.
class RowShadows {
public:
    RowShadows(const ShadingInputs& inputs, const ShadingSources<float>& in) : m_inputs(inputs) {
        for (std::size_t k = 0; k < inputs.lights.size(); ++k) {
            const ShadowLight& light = m_lights.emplace_back(inputs, in, k);
            const std::optional<PolygonBias> bias = light.polygonBias();
            m_biasOf.push_back(bias ? std::optional(m_biases.size()) : std::nullopt);
            if (bias) m_biases.push_back(*bias);
            m_facing = m_facing || (light.casts() && !bias);
        }
        m_lookUps.resize(m_biases.size());
    }
    // Of the lights whose bias is constant over triangles, in the order of SurfaceRow::bias.
    const std::vector<PolygonBias>& biases() const { return m_biases; }
    bool needsPlanes() const { return m_facing; }  // the normals of planes, for the other lights

    bool casts(std::size_t k) const { return m_lights[k].casts(); }
    bool dims(std::size_t k) const { return m_lights[k].casts() || m_lights[k].looksUp(); }

    // Begins the look-ups of a row, long before they are used.
    template <class A>
    void prepare(const SurfaceRow& row) {
        for (std::size_t k = 0; k < m_lights.size(); ++k)
            if (const auto bias = m_biasOf[k]; bias && m_inputs.parts.of(Part::Light, k))
                m_lights[k].template prepare<A>(row, row.bias[*bias], m_lookUps[*bias]);
    }
    // Writes S of light k for a group's lanes whose terms are not 0, or for all of them. areZero(n): the lanes of vector
    // n whose terms are 0. marksUnknown: the others get Incidence::kUnknownShadow.
    template <class A, class AreZero>
    void find(const SurfaceRow& row, const Group& group, std::size_t k, bool everywhere, bool marksUnknown,
              AreZero areZero, Row& S, ShadingCounts& counts) const {
        const ShadowLight& light = m_lights[k];
        const auto bias = m_biasOf[k];
        Group wanted;
        long long lookups = 0, pixels = 0;
        for (std::size_t n = 0; n < group.count; ++n) {
            const std::size_t i = group.at[n];
            const Mask mask = group.mask(n), asks = everywhere ? mask : hn::AndNot(areZero(n), mask);
            const std::uint32_t bits = bitsOf(asks);
            lookups += std::popcount(bits), pixels += std::popcount(group.bits[n]);
            if (bits != 0) wanted.add(i, bits);
            Floats factor = all(1);
            if (bits != 0 && bias)
                factor = hn::IfThenElse(asks, light.factorByPolygon(m_lookUps[*bias], row.bias[*bias], i), factor);
            store(factor, S, i);
        }
        if (light.looksUp()) counts.lookups += lookups, counts.idleLookups += pixels - lookups;
        if (light.casts() && !bias) light.template factors<A>(row, wanted, S);
        if (light.casts() && marksUnknown) markUnknown(group, wanted, S);
    }

private:
    static void markUnknown(const Group& group, const Group& wanted, Row& S) {
        const Floats unknown = all(Incidence::kUnknownShadow);
        for (std::size_t n = 0, w = 0; n < group.count; ++n) {
            const std::size_t i = group.at[n];
            const bool isWanted = w < wanted.count && wanted.at[w] == i;
            store(isWanted ? hn::IfThenElse(wanted.mask(w), load(S, i), unknown) : unknown, S, i);
            w += isWanted;
        }
    }

    const ShadingInputs& m_inputs;
    std::vector<ShadowLight> m_lights;  // one for each light
    std::vector<PolygonBias> m_biases;
    std::vector<std::optional<std::size_t>> m_biasOf;  // for each light: its index in m_biases
    std::vector<LookUps> m_lookUps;                    // one for each bias
    bool m_facing = false;
};

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
