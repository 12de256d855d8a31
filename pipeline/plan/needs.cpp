#include "pipeline/plan/needs.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "pipeline/plan/as_given.h"
#include "pipeline/plan/lit_scene.h"
#include "pipeline/plan/own_normals.h"
#include "pipeline/plan/shadow_reach.h"
#include "pipeline/scene/topology.h"
#include "pipeline/simd/model_kernels.h"

namespace pipeline {
namespace {

constexpr const char* kOutlines = "Outlines are not shaded.";
constexpr const char* kOnlyR = "The specular terms are Phong's, of R and not of H.";
constexpr const char* kOnlyH = "The specular terms are of H and not of R.";

bool anyWanted(BufferSet wanted, std::initializer_list<BufferId> ids) {
    return std::ranges::any_of(ids, [&](BufferId id) { return wanted[index(id)]; });
}
bool anyPerLight(BufferSet wanted) {
    return std::ranges::any_of(bufferTable(), [&](const BufferInfo& info) {
        return info.perLight && info.stage == StageId::Shading && wanted[index(info.id)];
    });
}

// What decides all needs of one scene.
struct Decision {
    const Scene& scene;
    const Scene& drawn;  // without what light cannot show
    BufferSet wanted;
    RuleSet rules;
    StageId until;  // after this stage the run ends

    // Left out for the reason where the rule is in force, else needed. An empty reason: needed.
    Need unless(Rule rule, std::string reason) const {
        if (reason.empty()) return {};
        if (rules[index(rule)]) return {std::move(reason), rule};
        reason.pop_back();  // the full stop
        const std::string_view off = scene.settings.leaveOut ? kRules[index(rule)].key : "leave_out";
        return {{}, {}, fmt::format("{}, but {} is off.", reason, off)};
    }
    // A reason that holds for all objects, or for those that are drawn alone.
    std::string ofAll(const std::string& all, const std::string& ofDrawn) const {
        return &drawn == &scene ? all : ofDrawn;
    }
    bool has(BufferId id) const { return wanted[index(id)]; }
    const ModelFacts& model() const { return modelFacts(scene.settings.model); }
    bool outlines() const { return scene.settings.visibility == Visibility::None; }

    Need modelTransform() const { return unless(Rule::ModelTransform, whyPlacesStay(scene)); }
    Need unitNormals(const Needs& needs) const {
        if (!needs.vertexNormals) return needs.vertexNormals;
        return unless(Rule::ModelTransform, whyNormalsStay(scene));
    }
    Need cull() const {
        const bool facing = lightsBacks(scene.settings);  // which side is lit
        if (scene.settings.cull != CullMode::None || facing || has(BufferId::PolygonsVerdict)) return {};
        const std::size_t count = polygonCount(scene);
        const std::string all = count == 1 ? "The only polygon goes on." : fmt::format("All {} polygons go on.", count);
        return unless(Rule::Culling, "Off in this scene: cull = none. " + all);
    }
    // Why a run that ends before shading has no use for normals: nobody shades with them, and who looks at the stage
    // itself ends the run there or asks for them.
    std::string unread() const {
        if (until == StageId::Shading || until == StageId::Normals) return {};
        return fmt::format("The run ends after {}, and nobody asks for them.", stageInfo(until).name);
    }
    Need polygonNormals(const Needs& needs) const {
        if (has(BufferId::PolygonsNormal) || (needs.vertexNormals && needs.normalSums)) return {};
        if (const std::string why = unread(); !why.empty()) return unless(Rule::PolygonNormals, why);
        if (needs.polygonTerms && !allLitByFirstVertex(scene)) return {};
        if (outlines()) return {kOutlines, {}};
        // Which side of a polygon a light meets is asked of every light that casts a shadow, with or without a buffer.
        const bool facing = model().shadows && std::ranges::any_of(scene.lights, &Light::castsShadow);
        const bool read = (scene.settings.shading == Shading::Flat && !allLitByFirstVertex(scene)) || facing;
        std::string why;
        if (!read)
            why = "Every vertex has a normal of its own, and there are no shadows.";
        else if (findsNormalsWhereSeen())
            why = "Shadows alone read them, each where its polygon is seen: there it is found.";
        return unless(Rule::PolygonNormals, why);
    }
    // Of a fine mesh, of one polygon for four pixels and more, most are never seen.
    bool findsNormalsWhereSeen() const {
        const Settings& settings = scene.settings;
        const bool isFine = 4.0 * double(polygonCount(scene)) > double(settings.width) * double(settings.height);
        return isFine && settings.shading != Shading::Flat && until == StageId::Shading && vectorShading() &&
               settings.forms.polygonNormal == PolygonNormalForm::Newell &&
               std::ranges::all_of(scene.objects, [](const Object& o) { return o.mesh->hasTrianglesAlone(); });
    }
    std::vector<bool> ownNormals(const Need& vertexNormals) const {
        if (!vertexNormals || !rules[index(Rule::PolygonNormals)]) return {};
        return objectsOfOwnNormals(scene);
    }
    Need normalSums(const Needs& needs) const {
        if (!needs.vertexNormals) return needs.vertexNormals;
        const bool all = !needs.ownNormals.empty() && std::ranges::all_of(needs.ownNormals, std::identity());
        return unless(Rule::PolygonNormals, all ? "Every vertex has a normal of its own." : "");
    }
    // The stage runs where either is needed, else it is left out for the reason of the polygon normals.
    Need normals(const Needs& needs) const {
        return needs.polygonNormals || needs.vertexNormals ? Need{} : needs.polygonNormals;
    }
    Need vertexNormals() const {
        if (const std::string why = unread(); !why.empty() && !has(BufferId::VerticesNormal))
            return unless(Rule::VertexNormals, why);
        if (outlines() && !has(BufferId::VerticesNormal) && !vertexTerms()) return {kOutlines, {}};
        const bool read = scene.settings.shading != Shading::Flat || has(BufferId::VerticesNormal) ||
                          bool(vertexTerms()) || (polygonTerms() && anyLitByFirstVertex(scene));
        return unless(Rule::VertexNormals, read ? "" : "Flat shading needs polygon normals only.");
    }
    Need polygonTerms() const {
        if (outlines() && !has(BufferId::PolygonsIntensity)) return {kOutlines, {}};
        const bool read = scene.settings.shading == Shading::Flat || has(BufferId::PolygonsIntensity);
        return unless(Rule::PolygonTerms, read ? "" : "Only flat shading evaluates polygons.");
    }
    Need vertexTerms() const {
        if (outlines() && !has(BufferId::VerticesIntensity)) return {kOutlines, {}};
        const bool read = scene.settings.shading == Shading::Gouraud || has(BufferId::VerticesIntensity);
        return unless(Rule::VertexTerms, read ? "" : "Only Gouraud shading evaluates vertices.");
    }
    Need light(const Light& light) const {
        if (outlines() && !anyWanted(wanted, {BufferId::PolygonsIntensity, BufferId::VerticesIntensity}))
            return {kOutlines, {}};
        if (anyPerLight(wanted)) return {};
        return adding(light);
    }
    // Whether it adds anything.
    Need adding(const Light& light) const {
        if (const std::string why = whyDark(light, scene.settings.model); !why.empty())
            return unless(Rule::DarkLight, why);
        if (isReflected(drawn, light)) return {};
        return unless(Rule::Unreflected,
                      ofAll("No material reflects any of it.", "No material that is drawn reflects any of it."));
    }
    Need specular(const Need& light) const {
        if (!light) return light;
        if (model().light.specular.empty()) return {"The illumination model has no specular term.", {}};
        if (anyMaterial(drawn, [&](const Material& m) { return shines(scene.settings.model, m); })) return {};
        return unless(Rule::Specular,
                      ofAll("k_s is 0 in every material.", "k_s is 0 in every material that is drawn."));
    }
    Need attenuation(const Light& light, const Need& counts) const {
        if (!counts) return counts;
        if (!model().found.glLights) return {onlyIn(&ModelFacts::Found::glLights, "attenuation"), {}};
        if (light.kind == LightKind::AtInfinity) return {"A light at infinity is as bright everywhere.", {}};
        const bool one = light.gl.constant == 1 && light.gl.linear == 0 && light.gl.quadratic == 0;
        return unless(Rule::Attenuation, one ? "It is 1 at every distance." : "");
    }
    Need shadow(const Light& light, const Need& counts) const {
        if (!light.castsShadow) return {"It casts no shadow.", {}};
        if (has(BufferId::ShadowBuffer)) return {};
        if (outlines()) return {kOutlines, {}};
        if (const Fact& shadows = model().shadows; !shadows) return {std::string(shadows.whyNot), {}};
        if (!counts) return counts;
        if (Need adds = adding(light); !adds && !has(BufferId::Shadow)) return adds;
        if (drawn.objects.empty()) return {ofAll("The scene has no object.", "Every object has alpha 0."), {}};
        const auto amongDrawn = [&](const std::string& why) {
            return why.empty() ? why : ofAll(why, "Objects of alpha 0 cast none. " + why);
        };
        Need convex = unless(Rule::ConvexShadow, amongDrawn(whyNoSelfShadow(drawn)));
        if (!convex) return convex;
        Need distant = unless(Rule::DistantShadow, amongDrawn(whyNoShadowBetween(drawn, light)));
        return distant && distant.despite.empty() ? convex : distant;
    }
    // One sentence for all lights when they agree.
    Need shadowBuffers(const std::vector<Need>& each) const {
        if (std::ranges::any_of(each, [](const Need& need) { return bool(need); })) return {};
        const bool same = std::ranges::all_of(each, [&](const Need& n) { return n.notBecause == each[0].notBecause; });
        const bool casts = std::ranges::any_of(scene.lights, &Light::castsShadow);
        if (each.empty() || !casts) return {"No light casts a shadow.", {}};
        if (same && each[0].rule != Rule::DarkLight) return each[0];
        return {"No light needs one.", each[0].rule};
    }
    Need ambient() const {
        // A factor below 0, or −0, would make a term of −0, whose sign a buffer shows.
        const auto anySign = [](Vec3d v) { return std::signbit(v.x) || std::signbit(v.y) || std::signbit(v.z); };
        const Vec3d product = scene.ambient.lightIn(scene.settings.model);
        const bool negative = anySign(product) || anyMaterial(scene, [&](const Material& m) {
                                  return anySign(m.diffuse) || anySign(m.ambient);
                              });
        const bool dark = product == Vec3d(0);
        return unless(Rule::Ambient, dark && !negative ? "The ambient light is 0." : "");
    }
    Need viewVector(bool specular) const {
        if (has(BufferId::ViewVector) || anyWanted(wanted, {BufferId::RDotV, BufferId::NDotH, BufferId::HalfwayVector}))
            return {};
        const bool read = specular || model().found.diffuse.V;
        return unless(Rule::ViewVector, read ? "" : "No specular term reads it.");
    }
    Need position(const Needs& needs) const {
        const bool perPixel = scene.settings.shading == Shading::Phong;
        const auto near = [](const Light& l) { return l.kind != LightKind::AtInfinity; };
        const bool read =
            anyWanted(wanted, {BufferId::Position}) || bool(needs.shadowBuffers) ||
            (model().viewer == Viewer::Setting && bool(needs.viewVector)) ||
            std::ranges::any_of(scene.lights, [&](const Light& l) { return near(l) && (perPixel || l.castsShadow); });
        return unless(Rule::Position, read ? "" : "No light and nobody reads it.");
    }
    // R and H: also what the model reads is left out of a scene without specular terms.
    Need direction(bool VectorsRead::*vector, bool specular, std::initializer_list<BufferId> readers,
                   const char* other) const {
        const bool ofModel = anySpecularReads(drawn, vector);
        if (anyWanted(wanted, readers) || (ofModel && specular) || model().found.diffuse.*vector) return {};
        const bool none = ofModel || drawn.objects.empty() || model().light.specular.empty();
        return unless(Rule::Directions, none ? "No specular term reads it." : other);
    }
    Need reflection(bool specular) const {
        return direction(&VectorsRead::R, specular, {BufferId::ReflectionVector, BufferId::RDotV}, kOnlyH);
    }
    Need halfway(bool specular) const {
        return direction(&VectorsRead::H, specular, {BufferId::HalfwayVector, BufferId::NDotH}, kOnlyR);
    }
    Need depthTest() const {
        if (outlines()) return {"Outlines are drawn one over the other: no depths are compared.", {}};
        if (scene.settings.visibility == Visibility::Painter)
            return {"The painter's algorithm compares no depths.", {}};
        return {};
    }
    // The stage's own text always leaves them: the vectors of pipeline/simd need not.
    Need beside(bool read, const char* notBecause) const {
        const Settings& s = scene.settings;
        const bool inVectors = s.precision == Precision::Float && s.visibility == Visibility::ZBuffer &&
                               s.depthFormat == DepthFormat::Linear;
        return unless(Rule::UnreadBuffers, read || !inVectors ? "" : notBecause);
    }
    Need seenPolygons() const {
        return beside(until >= StageId::Shading ||
                          anyWanted(wanted, {BufferId::ObjectId, BufferId::PolygonId, BufferId::Barycentric}),
                      "Nobody asks for them.");
    }
    Need fragmentCounts() const {
        return beside(anyWanted(wanted, {BufferId::Overdraw, BufferId::DepthWrites}), "Nobody asks for them.");
    }
    Need weights(const Need& vectorShading) const {
        if (until < StageId::Shading) return beside(has(BufferId::Barycentric), "Nobody asks for them.");
        return beside(has(BufferId::Barycentric) || !vectorShading,
                      "Nobody asks for them, and vectors of pixels keep them for no longer than a tile.");
    }
    // Only what the kernels of pipeline/simd have.
    Need vectorShading() const {
        const Settings& settings = scene.settings;
        if (settings.precision != Precision::Float) return {"It computes in float alone.", {}};
        if (outlines()) return {kOutlines, {}};
        if (settings.shading == Shading::Phong && settings.interpolation != Interpolation::Perspective)
            return {"It interpolates normals in perspective alone.", {}};
        if (settings.shading == Shading::Gouraud && settings.interpolation == Interpolation::Scanline)
            return {"It does not interpolate along rows.", {}};
        if (std::string why = whyNoKernel(settings.model); !why.empty() && settings.shading == Shading::Phong)
            return {std::move(why), {}};
        if (lightsBacks(settings)) return {"It lights one side alone.", {}};
        if (settings.forms.power != PowerForm::Log1p || settings.forms.unit != UnitForm::Scaled)
            return {"It has the stable forms of formulas alone.", {}};
        if (settings.shading == Shading::Phong) return {};
        using enum BufferId;
        for (const BufferId id :
             {Normal, ViewVector, LightVector, ReflectionVector, HalfwayVector, NDotL, RDotV, NDotH})
            if (has(id))
                return {fmt::format("The buffer {} is asked for, which it leaves in Phong shading alone.",
                                    bufferInfo(id).name),
                        {}};
        return {};
    }
    // Whether the intensity is left beside the frame buffer: the stage's own text always leaves it, and what is laid over
    // it or averaged reads it.
    bool intensity(const Needs& needs) const {
        return !needs.vectorShading || needs.layers || scene.settings.antialiasing > 1 ||
               anyWanted(wanted, {BufferId::Intensity, BufferId::Antialiased});
    }
    Need layers() const {
        if (outlines()) return {kOutlines, {}};
        return unless(Rule::TranslucentPass, whyNoLayers(scene));
    }
    Need layerSort(const Need& layers) const {
        if (scene.settings.translucency == Translucency::Polygons)
            return {"Off in this scene: translucency = polygons.", {}};
        if (!layers || !layers.despite.empty()) return layers;
        const bool single = translucentTriangles(scene) == 1;
        return unless(Rule::LayerSort, single ? "There is one translucent triangle: no pixel has two layers." : "");
    }
};

}  // namespace

Needs needsOf(const Scene& scene, BufferSet wanted, StageId until) {
    Needs needs;
    needs.rules = rulesOf(scene.settings);
    needs.buffers = wanted;
    // A shadow buffer is not made for its own sake: its light decides.
    if (!needs.rules[index(Rule::UnreadBuffers)])
        needs.buffers.set().set(index(BufferId::ShadowBuffer), wanted[index(BufferId::ShadowBuffer)]);
    const std::optional<Scene> drawn = withoutTransparent(scene, needs.buffers);
    const Decision decide{scene, drawn ? *drawn : scene, needs.buffers, needs.rules, until};
    needs.modelTransform = decide.modelTransform();
    needs.cull = decide.cull();
    needs.polygonTerms = decide.polygonTerms();
    needs.vertexNormals = decide.vertexNormals();
    needs.unitNormals = decide.unitNormals(needs);
    needs.ownNormals = decide.ownNormals(needs.vertexNormals);
    needs.normalSums = decide.normalSums(needs);
    needs.polygonNormals = decide.polygonNormals(needs);
    needs.normals = decide.normals(needs);
    needs.vertexTerms = decide.vertexTerms();
    // For each sample of a pixel corners are snapped anew: what culling dropped or no pixel showed may be seen in one.
    const bool snapsAnew = scene.settings.antialiasing > 1;
    const auto evaluatesHidden = [&](Rule rule, BufferId intensity) {
        return !needs.rules[index(rule)] || decide.has(intensity) || snapsAnew;
    };
    needs.hiddenPolygons = evaluatesHidden(Rule::HiddenPolygons, BufferId::PolygonsIntensity);
    needs.hiddenVertices = evaluatesHidden(Rule::HiddenVertices, BufferId::VerticesIntensity);
    bool specular = false;
    for (const Light& light : scene.lights) {
        needs.light.push_back(decide.light(light));
        needs.specular.push_back(decide.specular(needs.light.back()));
        needs.attenuation.push_back(decide.attenuation(light, needs.light.back()));
        needs.shadowBuffer.push_back(decide.shadow(light, needs.light.back()));
        specular = specular || needs.specular.back();
    }
    needs.shadowBuffers = decide.shadowBuffers(needs.shadowBuffer);
    needs.ambient = decide.ambient();
    needs.viewVector = decide.viewVector(specular);
    needs.position = decide.position(needs);
    needs.reflection = decide.reflection(specular);
    needs.halfway = decide.halfway(specular);
    needs.depthTest = decide.depthTest();
    needs.vectorShading = decide.vectorShading();
    needs.fast = needs.vectorShading && scene.settings.arithmetic == Arithmetic::Fast;
    needs.seenPolygons = decide.seenPolygons();
    needs.fragmentCounts = decide.fragmentCounts();
    needs.weights = decide.weights(needs.vectorShading);
    needs.layers = decide.layers();
    needs.layerSort = decide.layerSort(needs.layers);
    needs.buffers.set(index(BufferId::Intensity), decide.intensity(needs));
    return needs;
}

namespace {

std::string whyUseless(const Scene& scene, const Needs& needs, BufferId id) {
    const ModelFacts& model = modelFacts(scene.settings.model);
    const bool lights = !scene.lights.empty();
    const BufferInfo& info = bufferInfo(id);
    if (info.perLight && !lights) return "The scene has no light.";
    const bool atPixels = info.stage == StageId::Shading && info.domain == Domain::Pixel;
    if (scene.settings.visibility == Visibility::None) {
        if (atPixels && id != BufferId::Intensity && id != BufferId::Antialiased && id != BufferId::Color)
            return kOutlines;
    } else if (atPixels && !needs.rules[index(Rule::UnreadBuffers)]) {
        return {};  // all of them are made
    }
    switch (id) {
        case BufferId::PolygonsVerdict: return needs.cull.notBecause;
        case BufferId::VerticesNormal: return needs.vertexNormals.notBecause;
        case BufferId::ShadowBuffer: return needs.shadowBuffers.notBecause;
        case BufferId::PolygonsIntensity: return needs.polygonTerms.notBecause;
        case BufferId::VerticesIntensity: return needs.vertexTerms.notBecause;
        case BufferId::Depth: return needs.depthTest.notBecause;
        case BufferId::HalfwayVector:
        case BufferId::NDotH: return anySpecularReads(scene, &VectorsRead::H) ? "" : kOnlyR;
        case BufferId::ReflectionVector:
        case BufferId::RDotV: return anySpecularReads(scene, &VectorsRead::R) ? "" : kOnlyH;
        case BufferId::Translucent:
        case BufferId::Transmittance:
        case BufferId::Layers: return whyNoLayers(scene);
        case BufferId::Antialiased:
            return scene.settings.antialiasing > 1 ? "" : "Off in this scene: antialiasing = 1. It is the intensity.";
        case BufferId::Emission: return model.found.emission ? "" : onlyIn(&ModelFacts::Found::emission, "emission");
        case BufferId::Shadow:
            if (!model.shadows) return std::string(model.shadows.whyNot);
            if (std::ranges::none_of(scene.lights, &Light::castsShadow)) return "No light casts a shadow.";
            for (std::size_t k = 0; k < scene.lights.size(); ++k)
                if (scene.lights[k].castsShadow && needs.light[k]) return {};
            return "No light that casts a shadow adds anything.";
        default: return {};
    }
}

}  // namespace

BufferSet normalsOfShading(const Scene& scene) {
    if (scene.settings.visibility == Visibility::None) return {};
    return setOf({scene.settings.shading == Shading::Flat ? BufferId::PolygonsNormal : BufferId::VerticesNormal});
}

std::string whyUseless(const Scene& scene, BufferId id) { return whyUseless(scene, needsOf(scene, {}), id); }

BufferSet usefulBuffers(const Scene& scene) {
    const Needs needs = needsOf(scene, {});
    BufferSet set;
    for (const BufferInfo& info : bufferTable()) set[index(info.id)] = whyUseless(scene, needs, info.id).empty();
    return set;
}

}  // namespace pipeline
