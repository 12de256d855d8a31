#pragma once
#include <cmath>
#include <vector>

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
// The products of a material and a light's colour.
struct Reflected {
    Vec3<float> diffuse, specular;
};
// The base of a highlight's power: R·V or N·H.
enum class SpecularForm : std::uint8_t { None, Reflection, Halfway };
// The shading constants of an object.
struct Look {
    SpecularForm highlight = SpecularForm::None;
    float exponent;
    BaseTerms<float> base;
    std::vector<Reflected> lights;
    bool isFinite = true;  // all of them are finite, so times 0 they are 0

    Look(const ShadingInputs& inputs, const Material& material) : base(baseTerms<float>(inputs, material)) {
        const bool halfway = usesHalfway(inputs.illumination.model, material);
        if (shines(inputs.illumination.model, material) || inputs.illumination.detail.dull)
            highlight = halfway ? SpecularForm::Halfway : SpecularForm::Reflection;
        exponent = float(effectiveExponent(inputs.illumination.model, inputs.illumination.exponentFactor, material));
        for (const Light& light : inputs.lights) {
            const Vec3<float> shining(light.intensity * light.color);
            lights.push_back({shining * Vec3<float>(material.diffuse), shining * Vec3<float>(material.specular)});
            const Vec3<float> sum = lights.back().diffuse + lights.back().specular;
            isFinite = isFinite && std::isfinite(sum.x + sum.y + sum.z);
        }
    }
};

}  // namespace pipeline
