#include "pipeline/plan/black.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "pipeline/core/text.h"
#include "pipeline/illumination/illumination.h"
#include "pipeline/plan/lit_scene.h"
#include "pipeline/scene/opacity.h"

namespace pipeline {
namespace {

bool isThere(const Vec3d& k) { return k != Vec3d(0); }

bool isLit(const Scene& scene, const Light& light) {
    return whyDark(light, scene.settings.model).empty() && isReflected(scene, light);
}

bool isWhollyTransparent(const Scene& scene) {
    return !scene.objects.empty() && std::ranges::all_of(scene.objects, [&](const Object& object) {
        return isTransparent(object, scene.settings);
    });
}

}  // namespace

bool isBlack(const Scene& scene) {
    const Model model = scene.settings.model;
    const auto glows = [&](const Material& m) {
        return isThere(ambientTerm<double>(model, scene.ambient, m)) || isThere(emissionTerm<double>(model, m));
    };
    const auto lit = [&](const Light& light) { return isLit(scene, light); };
    return isWhollyTransparent(scene) || (!anyMaterial(scene, glows) && std::ranges::none_of(scene.lights, lit));
}

Remark whyBlack(const Scene& scene) {
    const Model model = scene.settings.model;
    const auto any = [&](auto holds) { return anyMaterial(scene, holds); };
    if (isWhollyTransparent(scene))
        return {"material.0.alpha",
                "Every object is wholly transparent (α = 0): set material.0.alpha=1, and so for each "
                "object."};
    const ModelFacts& facts = modelFacts(model);
    if (any([&](const Material& m) { return isThere(m.emission); }) && !facts.found.emission)
        return {"model",
                "The materials give off light, which this illumination model does not read: set model=opengl."};
    const bool hasDiffuse = any([](const Material& m) { return isThere(m.diffuse); });
    const bool hasAmbient = any([](const Material& m) { return isThere(m.ambient); });
    if (hasAmbient && !hasDiffuse && !facts.found.ownAmbient)
        return {
            "model",
            fmt::format("The materials reflect ambient light by k_a, which {} does not read: it takes k_d, which is 0. "
                        "Set model=blinn-phong.",
                        facts.name)};
    if (!hasDiffuse && !hasAmbient && !any([&](const Material& m) { return shines(model, m); }))
        return {"material.0.kr", "All coefficients of the materials are 0: set k_d, as material.0.kr."};
    if (isThere(scene.ambient.lightIn(model)) && (hasAmbient || !facts.found.ownAmbient))
        return {
            "ambient.intensity",
            fmt::format("The intensities are below 1/510 of I_max, {}: set larger coefficients, or ambient.intensity.",
                        shortestText(maximumIntensity(scene)))};
    const bool lit = std::ranges::any_of(scene.lights, [&](const Light& light) { return isLit(scene, light); });
    if (lit)
        return {
            "ambient.intensity",
            "No light reaches a surface that is seen, and there is no ambient light: set ambient.intensity, or move "
            "the light."};
    return {"ambient.intensity",
            scene.lights.empty() ? "The scene has no light: set ambient.intensity."
                                 : "No light has an intensity that the materials reflect: set light.0.intensity, or "
                                   "ambient.intensity."};
}

}  // namespace pipeline
