#pragma once
#include <cmath>
#include <vector>

#include "pipeline/simd/model_kernels.h"
#include "pipeline/stages/shading_terms.h"

namespace pipeline {

// A light, ready for shading pixels.
struct Shining {
    bool atInfinity;
    Vec3<float> source;  // direction towards it, or its position
    explicit Shining(const Light& light) : atInfinity(light.kind == LightKind::AtInfinity), source(light.position) {
        if (atInfinity) source = normalized(source);
    }
};
// The products of a material and a light's colour. Of microfacets: with k_d (1 − k_s)², and the light's colour alone.
struct Reflected {
    Vec3<float> diffuse, specular;
};
// The base of a highlight's power: R·V or N·H. Microfacets: no power.
enum class SpecularForm : std::uint8_t { None, Reflection, Halfway, Microfacets };
// What microfacets are of: α², and k_s.
struct Mirrors {
    float square = 0;
    Vec3<float> specular{0};
};
// The shading constants of an object.
struct Look {
    SpecularForm highlight = SpecularForm::None;
    float exponent;
    Mirrors mirrors;
    BaseTerms<float> base;
    Vec3<float> diffuseCoefficient;
    std::vector<Reflected> lights;
    bool isFinite = true;  // all of them are finite, so times 0 they are 0

    Look(const ShadingInputs& inputs, const Material& material)
        : base(baseTerms<float>(inputs, material)), diffuseCoefficient(material.diffuse) {
        const bool halfway = usesHalfway(inputs.illumination.model, material);
        if (shines(inputs.illumination.model, material) || inputs.illumination.detail.dull)
            highlight = halfway ? SpecularForm::Halfway : SpecularForm::Reflection;
        exponent = float(effectiveExponent(inputs.illumination.model, inputs.illumination.exponentFactor, material));
        const bool mirrored = kernelOf(inputs.illumination.model) == Kernel::Microfacets;
        if (mirrored) {
            highlight = SpecularForm::Microfacets;
            mirrors = {2 / (exponent + 2), Vec3<float>(material.specular)};
        }
        for (const Light& light : inputs.lights) {
            const Vec3<float> shining(light.intensity * light.color);
            const Vec3<float> diffuse = shining * Vec3<float>(material.diffuse), ks(material.specular),
                              rest = 1.0F - ks;
            lights.push_back(mirrored ? Reflected{diffuse * rest * rest, shining} : Reflected{diffuse, shining * ks});
            const Vec3<float> sum = lights.back().diffuse + lights.back().specular;
            isFinite = isFinite && std::isfinite(sum.x + sum.y + sum.z);
        }
    }
};

// What is the same for all pixels.
struct ShadingConstants {
    std::vector<Look> looks;      // one for each object
    std::vector<Shining> lights;  // one for each light
    float vanishesFrom;           // vanishing threshold for n q of a highlight

    explicit ShadingConstants(const ShadingInputs& inputs)
        : vanishesFrom(pipeline::vanishesFrom<float>(inputs.illumination.detail.logContrast)) {
        for (const Material& material : inputs.materials) looks.emplace_back(inputs, material);
        for (const Light& light : inputs.lights) lights.emplace_back(light);
    }
};

}  // namespace pipeline
