// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_CASTERS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_CASTERS_H
#undef SHADESCOPE_CASTERS_H
#else
#define SHADESCOPE_CASTERS_H
#endif

#include <optional>
#include <vector>

#include "pipeline/simd/shadows.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// The lights that may cast shadows, with their biases.
struct Casters {
    std::vector<ShadowLight> lights;                 // one for each light
    std::vector<PolygonBias> biases;                 // of the lights whose bias is constant over triangles
    std::vector<std::optional<std::size_t>> biasOf;  // for each light: its index in `biases`
    bool facing = false;                             // whether the other lights need the normals of planes

    Casters(const ShadingInputs& inputs, const ShadingSources<float>& in) {
        for (std::size_t k = 0; k < inputs.lights.size(); ++k) {
            const ShadowLight& light = lights.emplace_back(inputs, in, k);
            const std::optional<PolygonBias> bias = light.polygonBias();
            biasOf.push_back(bias ? std::optional(biases.size()) : std::nullopt);
            if (bias) biases.push_back(*bias);
            facing = facing || (light.casts() && !bias);
        }
    }
};

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
