#include "pipeline/plan/lit_scene.h"

#include <fmt/format.h>

#include "pipeline/scene/opacity.h"

namespace pipeline {
namespace {

// Asked of the factors: their product may be too small for a double and none for quad.
bool anyProduct(Vec3d a, Vec3d b) { return (a.x != 0 && b.x != 0) || (a.y != 0 && b.y != 0) || (a.z != 0 && b.z != 0); }

}  // namespace

std::optional<Scene> withoutTransparent(const Scene& scene, BufferSet wanted) {
    if (wanted[index(BufferId::PolygonsIntensity)] || wanted[index(BufferId::VerticesIntensity)]) return {};
    const auto transparent = [&](const Object& object) { return isTransparent(object, scene.settings); };
    if (std::ranges::none_of(scene.objects, transparent)) return {};
    Scene rest = scene;
    std::erase_if(rest.objects, transparent);
    return rest;
}

bool anySpecularReads(const Scene& scene, bool VectorsRead::*vector) {
    return anyMaterial(scene, [&](const Material& m) {
        return modelFacts(scene.settings.model).specularReads(usesHalfway(scene.settings.model, m)).*vector;
    });
}

std::string onlyIn(bool ModelFacts::Found::*fact, std::string_view what) {
    return fmt::format("Only {} has {}.", namesOfModels([&](const ModelFacts& model) { return model.found.*fact; }),
                       what);
}

std::string whyDark(const Light& light, Model model) {
    if (light.intensity == 0) return "Its intensity is 0.";
    if (light.color != Vec3d(0)) return {};
    if (!modelFacts(model).found.glLights) return "Its colour is black.";
    const bool black = light.gl.ambient == Vec3d(0) && light.gl.specular == Vec3d(0);
    return black ? "All its colours are black." : "";
}

bool isReflected(const Scene& scene, const Light& light) {
    const ModelFacts& model = modelFacts(scene.settings.model);
    const bool isGl = model.found.glLights;
    return anyMaterial(scene, [&](const Material& m) {
        const Vec3d specular = model.dullWithoutKs ? m.specular : Vec3d(1);
        return anyProduct(light.color, m.diffuse) || anyProduct(isGl ? light.gl.specular : light.color, specular) ||
               (isGl && anyProduct(light.gl.ambient, m.ambient));
    });
}

std::size_t translucentTriangles(const Scene& scene) {
    const std::vector<TranslucentSides> sides = translucentSides(scene);
    std::size_t count = 0;
    for (std::size_t i = 0; i < sides.size(); ++i)
        if ((sides[i].front || sides[i].back) && !isTransparent(scene.objects[i], scene.settings))
            count += scene.objects[i].mesh->triangles.size();
    return count;
}

std::string whyNoLayers(const Scene& scene) {
    if (translucentTriangles(scene) > 0) return "";
    return transparentObjects(scene).empty() ? "Every surface is opaque." : "Every surface that is drawn is opaque.";
}

}  // namespace pipeline
