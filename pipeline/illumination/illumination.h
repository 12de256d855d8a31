#pragma once
#include "pipeline/illumination/blinn_phong.h"
#include "pipeline/illumination/opengl.h"
#include "pipeline/illumination/phong.h"
#include "pipeline/stages/view.h"

namespace pipeline {

// The illumination model that a scene asks for, with the settings that it reads; what it does not
// read keeps its neutral value here, so that no stage has to ask again.
struct Illumination {
    Model model = Model::Phong;
    double exponentFactor = 1;  // of (N·H)^n but in OpenGL's model
    bool localViewer = false;   // OpenGL
    bool twoSided = false;      // OpenGL
    LightDetail detail{};
    bool operator==(const Illumination&) const = default;
};
Illumination illuminationOf(const Settings& settings);

// Whether a polygon whose mesh gives normals is lit with that of its first vertex, as glShadeModel(GL_FLAT) lights
// GL_POLYGON: the OpenGL graphics system 1.5, section 2.14.7.
constexpr bool lightsFirstVertex(const Settings& settings) {
    return settings.model == Model::OpenGl && settings.normalWeight == NormalWeight::Given;
}

// A scene's lights, those of OpenGL's model that stand in eye space (x right, y up, z towards the
// viewer) brought to world space.
std::vector<Light> lightsInWorldSpace(const Scene& scene, const View& view);

// What one light adds at a surface point. attenuated: see addOpenGl.
template <class Real>
LightSample<Real> sampleLight(const Illumination& illumination, const Light& light, const Material& material,
                              const Surface<Real>& at, bool attenuated = true) {
    const LightDetail& detail = illumination.detail;
    const bool halfway = usesHalfway(illumination.model, material);
    const bool dull = !detail.dull && material.specular == Vec3d(0);
    LightSample<Real> s = directionsOf(light, at, detail.reflection || (!halfway && !dull),
                                       detail.halfway || (halfway && !dull), detail.unit);
    if (illumination.model == Model::OpenGl)
        addOpenGl(light, material, at, detail, attenuated, s);
    else if (halfway)
        addBlinnPhong(light, material, illumination.exponentFactor, at, detail, s);
    else
        addPhong(light, material, at, detail, s);
    return s;
}

// Lecture 1 reflects ambient light by k_d, the other models by a coefficient of its own.
template <class Real>
Vec3<Real> ambientTerm(Model model, const AmbientLight& ambient, const Material& material) {
    return Vec3<Real>(ambient.lightIn(model)) * Vec3<Real>(model == Model::Phong ? material.diffuse : material.ambient);
}

template <class Real>
Vec3<Real> emissionTerm(Model model, const Material& material) {
    return model == Model::OpenGl ? Vec3<Real>(material.emission) : Vec3<Real>(0);
}

// What a frame buffer value of 255 stands for: in lecture 1's model the formula with every dot
// product 1 and every reflection coefficient at its maximum over the materials and the three
// colours, for the colour of light for which that is most; 1 in the others, whose colours are meant to lie in [0, 1].
// transparent: per material 1 where its object draws nothing, which does not count; empty where none is.
double maximumIntensity(Model model, const std::vector<Material>& materials, const std::vector<Light>& lights,
                        const AmbientLight& ambient, const std::vector<std::uint8_t>& transparent = {});
double maximumIntensity(const Scene& scene);

}  // namespace pipeline
