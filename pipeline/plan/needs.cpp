#include "pipeline/plan/needs.h"

#include <algorithm>

#include <fmt/format.h>

namespace pipeline {
namespace {

constexpr const char* kNoShadowsInOpenGl = "OpenGL's model knows no shadows.";

// One sentence for all lights when they agree, else one for each.
std::string noShadowAtAll(const Scene& scene, bool darkLightsToo) {
    if (scene.settings.model == Model::OpenGl) return kNoShadowsInOpenGl;
    const auto casts = [&](const Light& light) { return light.castsShadow && (darkLightsToo || light.intensity > 0); };
    if (std::ranges::none_of(scene.lights, casts)) return "No light casts a shadow.";
    // A convex object shadows only the polygons that face away, which are dark without a look-up;
    // the closed-form bias never shadows a plane by itself. Any other bias may: that is a lesson.
    // Each sample of an area light is a point light in this, and facing is asked sample by sample.
    if (scene.objects.size() == 1 && scene.objects[0].mesh->facts.convex &&
        scene.settings.shadowBias == ShadowBias::Automatic)
        return "The only object is convex: it cannot shadow itself.";
    if (scene.objects.empty()) return "The scene has no object.";
    return {};
}

std::string noSpecular(const Scene& scene) {
    const auto shines = [](const Object& o) {
        return o.material.specular != Vec3d(0) || (o.backMaterial && o.backMaterial->specular != Vec3d(0));
    };
    const bool any = std::ranges::any_of(scene.objects, shines);
    return any ? "" : "k_s is 0 in every material.";
}

std::size_t polygonCount(const Scene& scene) {
    std::size_t count = 0;
    for (const Object& object : scene.objects) count += object.mesh->polygonCount();
    return count;
}

bool anyPerLight(BufferSet wanted) {
    return std::ranges::any_of(bufferTable(), [&](const BufferInfo& info) {
        return info.perLight && info.stage == StageId::Shading && wanted[index(info.id)];
    });
}

}  // namespace

Needs needsOf(const Scene& scene, BufferSet wanted) {
    const Settings& settings = scene.settings;
    const auto has = [&](BufferId id) { return wanted[index(id)]; };
    const bool everything = !settings.leaveOut;
    Needs needs;
    needs.evaluateAll = everything || has(BufferId::PolygonsIntensity);

    const bool facingNeeded = settings.model == Model::OpenGl && settings.twoSided;  // which side is lit
    if (settings.cull == CullMode::None && !facingNeeded && !has(BufferId::PolygonsVerdict) && !everything)
        needs.cull.notBecause =
            fmt::format("Off in this scene: cull = none. All {} polygons go on.", polygonCount(scene));
    if (settings.shading == Shading::Flat && !has(BufferId::VerticesNormal) && !has(BufferId::VerticesIntensity) &&
        !everything)
        needs.vertexNormals.notBecause = "Flat shading needs polygon normals only.";
    if (settings.shading != Shading::Flat && !has(BufferId::PolygonsIntensity))
        needs.polygonTerms.notBecause = "Only flat shading evaluates polygons.";
    if (settings.shading != Shading::Gouraud && !has(BufferId::VerticesIntensity))
        needs.vertexTerms.notBecause = "Only Gouraud shading evaluates vertices.";

    const bool shadowAsked = has(BufferId::ShadowBuffer);
    const bool shadowFactors = anyPerLight(wanted);  // somebody looks at S itself, also of a light that is dark
    const std::string noShadow = noShadowAtAll(scene, shadowFactors), dull = noSpecular(scene);
    bool anyBuffer = false;
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        const Light& light = scene.lights[k];
        Need shadow, counts, specular;
        if (light.intensity == 0 && !shadowFactors && !everything) counts.notBecause = "Its intensity is 0.";
        if (!counts)
            specular.notBecause = counts.notBecause;
        else if (!dull.empty() && !everything)
            specular.notBecause = dull;
        if (settings.model == Model::OpenGl)
            shadow.notBecause = kNoShadowsInOpenGl;  // nobody would look it up, not even with everything forced in
        else if (!light.castsShadow)
            shadow.notBecause = "It casts no shadow.";
        else if (everything)
            shadow.notBecause.clear();
        else if (!noShadow.empty())
            shadow.notBecause = noShadow;
        else if (light.intensity == 0 && !shadowFactors)
            shadow.notBecause = "Its intensity is 0.";
        if (shadowAsked) shadow.notBecause.clear();
        anyBuffer = anyBuffer || shadow;
        needs.shadowBuffer.push_back(shadow);
        needs.light.push_back(counts);
        needs.specular.push_back(specular);
    }
    if (!anyBuffer) needs.shadowBuffers.notBecause = noShadow.empty() ? "No light casts a shadow." : noShadow;
    return needs;
}

std::string whyUseless(const Scene& scene, BufferId id) {
    const Needs needs = needsOf(scene, {});
    const Model model = scene.settings.model;
    const bool lights = !scene.lights.empty();
    if (bufferInfo(id).perLight && !lights) return "The scene has no light.";
    switch (id) {
        case BufferId::PolygonsVerdict: return needs.cull.notBecause;
        case BufferId::VerticesNormal: return needs.vertexNormals.notBecause;
        case BufferId::ShadowBuffer: return needs.shadowBuffers.notBecause;
        case BufferId::PolygonsIntensity: return needs.polygonTerms.notBecause;
        case BufferId::VerticesIntensity: return needs.vertexTerms.notBecause;
        case BufferId::Depth:
            return scene.settings.visibility == Visibility::Painter ? "The painter's algorithm compares no depths."
                                                                    : "";
        case BufferId::HalfwayVector:
        case BufferId::NDotH: return model == Model::Phong ? "Phong's model uses R, not H." : "";
        case BufferId::ReflectionVector:
        case BufferId::RDotV: return model == Model::Phong ? "" : "The illumination model uses H, not R.";
        case BufferId::Emission: return model == Model::OpenGl ? "" : "Only OpenGL's model has emission.";
        case BufferId::Shadow:
            if (model == Model::OpenGl) return kNoShadowsInOpenGl;
            return std::ranges::any_of(scene.lights, &Light::castsShadow) ? "" : "No light casts a shadow.";
        default: return {};
    }
}

BufferSet usefulBuffers(const Scene& scene) {
    BufferSet set;
    for (const BufferInfo& info : bufferTable()) set[index(info.id)] = whyUseless(scene, info.id).empty();
    return set;
}

}  // namespace pipeline
