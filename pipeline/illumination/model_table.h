#pragma once
#include <tuple>

#include "pipeline/illumination/light_sample.h"

namespace pipeline {

// What computes the terms of each model.

// A light at a surface point, as the models read it.
template <class Real>
struct LitSurface {
    const Light& light;  // in world space
    const Material& material;
    const Surface<Real>& at;
    const LightDetail& detail;
    double exponent;         // effectiveExponent
    bool halfway;            // usesHalfway
    bool attenuated = true;  // false where the light's attenuation is known to be 1 everywhere
};

// Adds the terms of a light to a sample that has its directions and dot products, R and H where the model's row reads them.
template <class Real>
using AddLight = void (*)(const LitSurface<Real>& in, LightSample<Real>& s);
using LightTermsOf = std::tuple<AddLight<float>, AddLight<double>, AddLight<long double>, AddLight<Quad>>;

const LightTermsOf& lightTermsOf(Model model);
// Of kTriedModel.
extern const LightTermsOf* triedTerms;

}  // namespace pipeline
