// The part of stage 6 that asks what a light reaches.
#include "pipeline/scene/area_light.h"
#include "pipeline/stages/shading.h"

namespace pipeline {

template <class Real>
Real shadowAt(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::size_t k, std::uint32_t triangle,
              Vec3<Real> position) {
    const Light& light = inputs.lights[k];
    // Without shadows only the normal says what a light reaches.
    if (!modelFacts(inputs.illumination.model).shadows || !light.castsShadow) return 1;
    const Vec3<Real> front = in.planeNormal(triangle);
    const Vec3<Real> normal = showsBack(inputs, in, in.transform.topology->polygonOf(triangle)) ? -front : front;
    const bool looksUp = in.shadow && !in.shadow->lights[k].empty();
    const SampleGrid grid = sampleGrid(light);
    const AreaSides sides = sidesOf(light);
    // Counts, and one division: samples that all say the same leave what one of them says, to the last bit.
    const int texels = filteredTexels(inputs.shadow);
    int lit = 0;
    for (int i = 0; i < grid.count(); ++i) {
        const Vec3<Real> L = towardsLight(light.kind, samplePlace(light, grid, sides, i), position);
        if (!(glm::dot(normal, L) > 0)) continue;
        lit += looksUp ? litTexels(in.shadow->lights[k][std::size_t(i)], inputs.shadow, position, normal) : texels;
    }
    return Real(lit) / Real(grid.count() * texels);
}

#define SHADESCOPE_INSTANTIATE(Real) \
    template Real shadowAt(const ShadingInputs&, const ShadingSources<Real>&, std::size_t, std::uint32_t, Vec3<Real>);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
