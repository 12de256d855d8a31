#pragma once
#include "pipeline/stages/shading.h"

// What the halves of stage 6 share: elements (polygons, vertices) and pixels.
namespace pipeline {

// Emission and ambient light; 0 for what the plan leaves out. Never -0, like a light's terms. color: Surface::color.
template <class Real>
BaseTerms<Real> baseTerms(const ShadingInputs& inputs, const Material& material, Vec3<Real> color = Vec3<Real>(1)) {
    const Model model = inputs.illumination.model;
    return {Vec3<Real>(0) + emissionTerm<Real>(model, material),
            Vec3<Real>(0) + (inputs.parts[Part::Ambient] ? color * ambientTerm<Real>(model, inputs.ambient, material)
                                                         : Vec3<Real>(0))};
}

// Vertices as seen from the front or from behind.
template <class Real>
const typename ShadingOutput<Real>::Elements& vertexElements(const ShadingOutput<Real>& out, bool back) {
    return back ? out.verticesBack : out.vertices;
}

// Where a sum of intensities begins. From +0, a term that is 0 changes no bit, whatever its sign:
// that is why a light which adds nothing may be left out.
template <class Real>
Vec3<Real> sumOf(const BaseTerms<Real>& base) {
    return Vec3<Real>(0) + base.emission + base.ambient;
}

// LightDetail::logContrast of Phong shading, of all materials and lights, channel by channel.
double logContrast(const ShadingInputs& inputs);

template <class Real>
void count(const LightSample<Real>& sample, ShadingCounts& counts) {
    ++counts.evaluations;
    counts.powers += sample.power == Power::Computed;
    counts.vanished += sample.power == Power::Vanished;
}

}  // namespace pipeline
