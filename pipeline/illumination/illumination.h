#pragma once
#include "pipeline/illumination/model_table.h"
#include "pipeline/scene/view.h"

namespace pipeline {

// The illumination model that a scene asks for, with the settings that it reads; what it does not
// read keeps its neutral value here, so that no stage has to ask again.
struct Illumination {
    Model model = Model::Phong;
    double exponentFactor = 1;  // of (N·H)^n
    bool localViewer = false;
    bool twoSided = false;
    LightDetail detail{};
    bool operator==(const Illumination&) const = default;
};
Illumination illuminationOf(const Settings& settings);

// Whether a polygon whose mesh gives normals is lit with that of its first vertex, as glShadeModel(GL_FLAT) lights
// GL_POLYGON: the OpenGL graphics system 1.5, section 2.14.7.
inline bool lightsFirstVertex(const Settings& settings) {
    return modelFacts(settings.model).firstVertex && settings.normalWeight == NormalWeight::Given;
}

// A scene's lights, those that the model has in eye space (x right, y up, z towards the viewer) brought to world space.
std::vector<Light> lightsInWorldSpace(const Scene& scene, const View& view);

// What one light adds at a surface point. attenuated: see LitSurface.
template <class Real>
LightSample<Real> sampleLight(const Illumination& illumination, const Light& light, const Material& material,
                              const Surface<Real>& at, bool attenuated = true) {
    const LightDetail& detail = illumination.detail;
    const bool halfway = usesHalfway(illumination.model, material);
    const ModelFacts& model = modelFacts(illumination.model);
    const bool shining = detail.dull || shines(illumination.model, material);
    const VectorsRead& diffuse = model.found.diffuse;
    const VectorsRead specular = shining ? model.specularReads(halfway) : VectorsRead();
    LightSample<Real> s = directionsOf(light, at, detail.reflection || diffuse.R || specular.R,
                                       detail.halfway || diffuse.H || specular.H, detail.unit);
    if (detail.planted) spoilDirections(illumination, light, at, s);
    std::get<AddLight<Real>>(lightTermsOf(illumination.model))(
        {light, material, at, detail, effectiveExponent(illumination.model, illumination.exponentFactor, material),
         halfway, attenuated},
        s);
    if (detail.planted) spoilTerms(illumination, light, material, at, attenuated, s);
    // Both terms are linear in their coefficients.
    s.diffuse *= at.color, s.ambient *= at.color;
    return s;
}

// What is there without any light: lecture 1 reflects ambient light by k_d, other models by a coefficient of its own.
template <class Real>
Vec3<Real> ambientTerm(Model model, const AmbientLight& ambient, const Material& material) {
    return Vec3<Real>(ambient.lightIn(model)) * Vec3<Real>(ambientCoefficient(model, material));
}

template <class Real>
Vec3<Real> emissionTerm(Model model, const Material& material) {
    return modelFacts(model).found.emission ? Vec3<Real>(material.emission) : Vec3<Real>(0);
}

// What brings the terms of a colour to [0, 1] where the model clamps it: their common factor, so that they still sum to it.
template <class Real>
Real clampingFactor(Real total) {
    if (total >= 0 && total <= 1) return 1;
    return total > 1 ? 1 / total : Real(0);
}

// What a frame buffer value of 255 stands for: in lecture 1's model the formula with every dot
// product 1 and every reflection coefficient at its maximum over the materials and the three
// colours, for the colour of light for which that is most; 1 in the others, whose colours are meant to lie in [0, 1].
struct MaximumIntensity {
    double value = 1;
    // What it is the sum of, in the colour for which it is most: diffuse * ambient and, of each light, light (diffuse +
    // specular). What is below 0 makes nothing brighter, and counts as 0.
    double diffuse = 0, specular = 0, ambient = 0;
    std::vector<double> lights{};
};
// transparent: per material 1 where its object draws nothing, which does not count; empty where none is.
double maximumIntensity(Model model, const std::vector<Material>& materials, const std::vector<Light>& lights,
                        const AmbientLight& ambient, const std::vector<std::uint8_t>& transparent = {});
double maximumIntensity(const Scene& scene);
MaximumIntensity maximumIntensityInParts(const Scene& scene);

}  // namespace pipeline
