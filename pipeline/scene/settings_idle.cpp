#include "pipeline/scene/settings_idle.h"

#include <algorithm>
#include <string>

#include "pipeline/scene/opacity.h"

namespace pipeline::settings_idle {

namespace {

bool spherical(const Scene& scene) { return scene.camera.kind == CameraKind::Spherical; }
bool orthographic(const Scene& scene) { return scene.camera.projection == ProjectionKind::Orthographic; }
const ModelFacts& model(const Scene& scene) { return modelFacts(scene.settings.model); }
// "Only OpenGL's model reads it.", where this one does not.
template <class Reads>
std::string_view onlyWhere(const Scene& scene, Reads reads) {
    static const std::string kOnly = "Only " + namesOfModels(reads) + " reads it.";
    return reads(model(scene)) ? std::string_view() : kOnly;
}
bool noShadow(const Scene& scene) { return std::ranges::none_of(scene.lights, &Light::castsShadow); }

}  // namespace

std::string_view onlySpherical(const Scene& scene) {
    return spherical(scene) ? "" : "The camera is look-at; choose spherical to change it.";
}
std::string_view onlyLookAt(const Scene& scene) {
    return spherical(scene) ? "The camera is spherical; choose look-at to change it." : "";
}
std::string_view onlyLookAtPerspective(const Scene& scene) {
    if (spherical(scene)) return onlyLookAt(scene);
    return orthographic(scene) ? "The projection is orthographic; choose perspective to change it." : "";
}
std::string_view onlyLookAtOrthographic(const Scene& scene) {
    if (spherical(scene)) return onlyLookAt(scene);
    return orthographic(scene) ? "" : "The projection is perspective; choose orthographic to change it.";
}
std::string_view notOutlines(const Scene& scene) {
    return scene.settings.visibility == Visibility::None ? "Outlines are not shaded." : "";
}
std::string_view onlyVertexNormals(const Scene& scene) {
    if (!notOutlines(scene).empty()) return notOutlines(scene);
    return scene.settings.shading == Shading::Flat ? "Flat shading needs polygon normals only." : "";
}
std::string_view notFlat(const Scene& scene) {
    if (!notOutlines(scene).empty()) return notOutlines(scene);
    return scene.settings.shading == Shading::Flat ? "Flat shading interpolates nothing." : "";
}
std::string_view onlyZBuffer(const Scene& scene) {
    return scene.settings.visibility == Visibility::ZBuffer ? "" : "Without a z-buffer no depth is stored.";
}
std::string_view onlyPainter(const Scene& scene) {
    return scene.settings.visibility == Visibility::Painter ? "" : "Only the painter's algorithm splits polygons.";
}
std::string_view onlyTranslucent(const Scene& scene) {
    return translucentSides(scene).empty() ? "No surface is translucent: set a material's alpha between 0 and 1." : "";
}
std::string_view onlyShadow(const Scene& scene) {
    if (!notOutlines(scene).empty()) return notOutlines(scene);
    if (const Fact& shadows = model(scene).shadows; !shadows) return shadows.whyNot;
    return noShadow(scene) ? "No light casts a shadow." : "";
}
std::string_view onlyArea(const Scene& scene) {
    if (!onlyShadow(scene).empty()) return onlyShadow(scene);
    const bool any = std::ranges::any_of(scene.lights, [](const Light& l) { return l.kind == LightKind::Area; });
    return any ? "" : "No light is an area light.";
}
std::string_view onlyBias(const Scene& scene) {
    if (!onlyShadow(scene).empty()) return onlyShadow(scene);
    return scene.settings.shadowBias == ShadowBias::Automatic ? "Bias is automatic; choose constant to change it." : "";
}
std::string_view onlySpecular(const Scene& scene) {
    const auto isDull = [&](const Material& material) { return !shines(scene.settings.model, material); };
    const bool dull = std::ranges::all_of(scene.objects, [&](const Object& object) {
        return isDull(object.material) && (!object.backMaterial || isDull(*object.backMaterial));
    });
    return dull ? "k_s is 0 in every material." : "";
}

std::string_view onlyPower(const Scene& scene) {
    if (model(scene).lobe == Lobe::None) return "The specular term of this model is no power.";
    return onlySpecular(scene);
}
std::string_view onlyShapes(const Scene& scene) {
    const bool none =
        std::ranges::none_of(scene.objects, [](const Object& object) { return object.shape.has_value(); });
    return none ? "No object is a built-in shape." : "";
}
std::string_view onlyFactored(const Scene& scene) {
    if (const Fact& factor = model(scene).exponentFactor; !factor) return factor.whyNot;
    const bool any = std::ranges::any_of(
        scene.objects, [&](const Object& object) { return usesHalfway(scene.settings.model, object.material); });
    return any || model(scene).lobe == Lobe::Halfway ? "" : "Only Blinn–Phong's highlight reads it.";
}
std::string_view onlyChosenLobe(const Scene& scene) { return model(scene).choosesLobe.whyNot; }
std::string_view onlyViewer(const Scene& scene) {
    return onlyWhere(scene, [](const ModelFacts& facts) { return facts.viewer == Viewer::Setting; });
}
std::string_view onlyTwoSided(const Scene& scene) {
    return scene.settings.cull == CullMode::Back ? "Back faces are left out: cull = back." : "";
}
std::string_view onlyEmission(const Scene& scene) {
    return onlyWhere(scene, [](const ModelFacts& facts) { return facts.found.emission; });
}
std::string_view onlyGlLights(const Scene& scene) {
    return onlyWhere(scene, [](const ModelFacts& facts) { return facts.found.glLights; });
}
std::string_view onlyFading(const Scene& scene) {
    if (!onlyGlLights(scene).empty()) return onlyGlLights(scene);
    const bool point =
        std::ranges::any_of(scene.lights, [](const Light& l) { return l.kind != LightKind::AtInfinity; });
    return point ? "" : "No light stands at a point: nothing fades with distance.";
}
std::string_view onlyOwnAmbient(const Scene& scene) {
    return model(scene).found.ownAmbient ? "" : "This model reflects ambient light by k_r, k_g and k_b.";
}
std::string_view onlyFloat(const Scene& scene) {
    return scene.settings.precision == Precision::Float ? "" : "Fast arithmetic computes in float alone.";
}
std::string_view onlyAntialiased(const Scene& scene) {
    return scene.settings.antialiasing > 1 ? "" : "One sample a pixel stands in its centre: antialiasing = 1.";
}
std::string_view onlyGivenNormals(const Scene& scene) {
    if (!onlyVertexNormals(scene).empty()) return onlyVertexNormals(scene);
    const bool given = std::ranges::any_of(scene.objects, [](const Object& o) { return !o.mesh->normals.empty(); });
    return given && scene.settings.normalWeight == NormalWeight::Given ? "" : "Only a mesh's own normals are given.";
}
std::string_view onlyAngleWeights(const Scene& scene) {
    if (!onlyVertexNormals(scene).empty()) return onlyVertexNormals(scene);
    return scene.settings.normalWeight == NormalWeight::Angle ? "" : "Vertex normals are not weighted by angle.";
}

std::string_view onlyWithDefect(const Scene& scene) {
    return scene.settings.defect != Defect::None ? "" : "No defect is planted.";
}
std::string_view onlyLeavingOut(const Scene& scene) {
    if (scene.settings.defect != Defect::None) return kDefectIsPlanted;
    return scene.settings.leaveOut ? "" : "Nothing is left out: leave_out = off.";
}

}  // namespace pipeline::settings_idle
