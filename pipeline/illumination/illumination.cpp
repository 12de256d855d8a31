#include "pipeline/illumination/illumination.h"

#include <algorithm>
#include <cmath>

#include "pipeline/core/numerics.h"
#include "pipeline/scene/opacity.h"

namespace pipeline {

Illumination illuminationOf(const Settings& settings) {
    const ModelFacts& model = modelFacts(settings.model);
    return {settings.model,
            model.exponentFactor ? settings.exponentFactor : 1.0,
            model.viewer == Viewer::Setting && settings.localViewer,
            lightsBacks(settings),
            {}};
}

namespace {

// A direction whose length float can hold: times a power of two, which changes no bit of its unit vector.
Vec3d inRange(Vec3d direction) {
    const double largest = largestComponent(direction);
    if (largest == 0 || (largest < double(kLargestUnscaled) && largest > 1 / double(kLargestUnscaled)))
        return direction;
    int exponent;
    std::frexp(largest, &exponent);
    for (int c = 0; c < 3; ++c) direction[c] = std::ldexp(direction[c], -exponent);
    return direction;
}

}  // namespace

std::vector<Light> lightsInWorldSpace(const Scene& scene, const View& view) {
    std::vector<Light> lights = scene.lights;
    for (Light& light : lights) {
        if (light.kind == LightKind::AtInfinity) light.position = inRange(light.position);
        light.gl.spotDirection = inRange(light.gl.spotDirection);
    }
    if (!modelFacts(scene.settings.model).found.glLights) return lights;
    const auto turned = [&](Vec3d v) { return v.x * view.right + v.y * view.up - v.z * view.forward; };
    for (Light& light : lights) {
        if (light.gl.space == LightSpace::World) continue;
        light.position = turned(light.position) + (light.kind == LightKind::AtInfinity ? Vec3d(0) : view.eye);
        light.gl.spotDirection = turned(light.gl.spotDirection);
        light.gl.space = LightSpace::World;
    }
    return lights;
}

namespace {

MaximumIntensity inParts(Model model, const std::vector<Material>& materials, const std::vector<Light>& lights,
                         const AmbientLight& ambient, const std::vector<std::uint8_t>& transparent) {
    if (modelFacts(model).white == White::One) return {};
    const auto most = [](Vec3d v) { return std::max({0.0, v.x, v.y, v.z}); };
    double diffuse = 0, specular = 0;
    for (std::size_t i = 0; i < materials.size(); ++i) {
        if (!transparent.empty() && transparent[i]) continue;
        diffuse = std::max(diffuse, most(materials[i].diffuse));
        specular = std::max(specular, most(materials[i].specular));
    }
    // Colour by colour: a red and a green light never add up in one of them.
    const Vec3d ambientLight = ambient.lightIn(model);
    MaximumIntensity maximum{0, diffuse, specular, 0, {}};
    for (int c = 0; c < 3; ++c) {
        double sum = diffuse * std::max(0.0, ambientLight[c]);
        for (const Light& light : lights) sum += std::max(0.0, light.intensity * light.color[c]) * (diffuse + specular);
        if (c > 0 && !(sum > maximum.value)) continue;
        maximum.value = std::max(maximum.value, sum), maximum.ambient = std::max(0.0, ambientLight[c]);
        maximum.lights.clear();
        for (const Light& light : lights) maximum.lights.push_back(std::max(0.0, light.intensity * light.color[c]));
    }
    return maximum;
}

std::vector<Material> materialsOf(const Scene& scene) {
    std::vector<Material> materials;
    for (const Object& object : scene.objects) materials.push_back(object.material);
    return materials;
}

}  // namespace

double maximumIntensity(Model model, const std::vector<Material>& materials, const std::vector<Light>& lights,
                        const AmbientLight& ambient, const std::vector<std::uint8_t>& transparent) {
    return inParts(model, materials, lights, ambient, transparent).value;
}
MaximumIntensity maximumIntensityInParts(const Scene& scene) {
    return inParts(scene.settings.model, materialsOf(scene), scene.lights, scene.ambient, transparentObjects(scene));
}
double maximumIntensity(const Scene& scene) { return maximumIntensityInParts(scene).value; }

}  // namespace pipeline
