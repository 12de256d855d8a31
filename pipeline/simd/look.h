#pragma once
#include <cmath>
#include <vector>

#include "pipeline/stages/shading_terms.h"

namespace pipeline {

// A light that shines on pixels.
struct Shining {
    bool atInfinity;
    Vec3<float> source;  // the direction towards it, or where it stands
    explicit Shining(const Light& light) : atInfinity(light.kind == LightKind::AtInfinity), source(light.position) {
        if (atInfinity) source = normalized(source);
    }
};
// What a material makes of a light.
struct Reflected {
    Vec3<float> diffuse, specular;
};
// What of it a highlight is a power of: of R·V or of N·H.
enum class SpecularForm : std::uint8_t { None, Reflection, Halfway };
// What of an object its pixels are shaded by.
struct Look {
    SpecularForm highlight = SpecularForm::None;
    float exponent;
    BaseTerms<float> base;
    std::vector<Reflected> lights;
    bool isFinite = true;  // they are: times 0 they are 0

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
