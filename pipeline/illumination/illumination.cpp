#include "pipeline/illumination/illumination.h"

#include <algorithm>
#include <cmath>

#include "pipeline/core/numerics.h"
#include "pipeline/scene/opacity.h"

namespace pipeline {

Illumination illuminationOf(const Settings& settings) {
    const bool openGl = settings.model == Model::OpenGl;
    return {settings.model,
            openGl ? 1.0 : settings.exponentFactor,
            openGl && settings.localViewer,
            openGl && settings.twoSided,
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
    if (scene.settings.model != Model::OpenGl) return lights;
    const auto turned = [&](Vec3d v) { return v.x * view.right + v.y * view.up - v.z * view.forward; };
    for (Light& light : lights) {
        if (light.gl.space == LightSpace::World) continue;
        light.position = turned(light.position) + (light.kind == LightKind::AtInfinity ? Vec3d(0) : view.eye);
        light.gl.spotDirection = turned(light.gl.spotDirection);
        light.gl.space = LightSpace::World;
    }
    return lights;
}

double maximumIntensity(Model model, const std::vector<Material>& materials, const std::vector<Light>& lights,
                        const AmbientLight& ambient, const std::vector<std::uint8_t>& transparent) {
    if (model != Model::Phong) return 1;
    // What is below 0 makes nothing brighter, and counts as 0.
    const auto most = [](Vec3d v) { return std::max({0.0, v.x, v.y, v.z}); };
    double diffuse = 0, specular = 0;
    for (std::size_t i = 0; i < materials.size(); ++i) {
        if (!transparent.empty() && transparent[i]) continue;
        diffuse = std::max(diffuse, most(materials[i].diffuse));
        specular = std::max(specular, most(materials[i].specular));
    }
    // Colour by colour: a red and a green light never add up in one of them.
    const Vec3d ambientLight = ambient.lightIn(model);
    double maximum = 0;
    for (int c = 0; c < 3; ++c) {
        double sum = diffuse * std::max(0.0, ambientLight[c]);
        for (const Light& light : lights) sum += std::max(0.0, light.intensity * light.color[c]) * (diffuse + specular);
        maximum = std::max(maximum, sum);
    }
    return maximum;
}

double maximumIntensity(const Scene& scene) {
    std::vector<Material> materials;
    for (const Object& object : scene.objects) materials.push_back(object.material);
    return maximumIntensity(scene.settings.model, materials, scene.lights, scene.ambient, transparentObjects(scene));
}

}  // namespace pipeline
