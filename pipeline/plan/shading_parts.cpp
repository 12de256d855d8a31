// The parts of shading.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/illumination/illumination.h"
#include "pipeline/plan/lit_scene.h"
#include "pipeline/plan/part_rows.h"
#include "pipeline/scene/mesh/topology.h"
#include "pipeline/simd/kernels.h"

namespace pipeline {

Need adding(const Decision& d, const Light& light) {
    if (const std::string why = whyDark(light, d.scene.settings.model); !why.empty())
        return d.unless(Rule::DarkLight, why);
    if (isReflected(d.drawn, light)) return {};
    return d.unless(Rule::Unreflected,
                    d.ofAll("No material reflects any of it.", "No material that is drawn reflects any of it."));
}
namespace {

constexpr const char* kNoSpecular = "The illumination model has no specular term.";
constexpr const char* kOnlyR = "The specular terms are Phong's, of R and not of H.";
constexpr const char* kOnlyH = "The specular terms are of H and not of R.";

std::string whyNoShadows(const Scene& scene, const Needs& needs, std::size_t) {
    if (const Fact& shadows = modelOf(scene).shadows; !shadows) return std::string(shadows.whyNot);
    if (std::ranges::none_of(scene.lights, &Light::castsShadow)) return "No light casts a shadow.";
    for (std::size_t k = 0; k < scene.lights.size(); ++k)
        if (scene.lights[k].castsShadow && needs.of(Part::Light, k)) return {};
    return "No light that casts a shadow adds anything.";
}

// Of what nobody can see. For each sample of a pixel corners are snapped anew: what culling dropped or no pixel showed may
// be seen in one.
Need needOfHidden(const Decision& d, Rule rule, Part terms) {
    return d.scene.settings.antialiasing > 1 || d.isRead(terms) ? Need{} : d.within(rule);
}
std::string allHidden(const Scene& scene, const Needs& needs, Rule rule, const char* without) {
    if (scene.settings.antialiasing > 1) return "All: snapped anew for each sample of a pixel, any may be seen in one.";
    return needs.rules[index(rule)] ? "All: their intensities are asked for." : without;
}
Need needOfLight(const Decision& d, std::size_t k) {
    if (outlines(d.scene) && !d.isRead(Part::PolygonTerms) && !d.isRead(Part::VertexTerms)) return {kOutlines};
    return d.isRead(Part::Light) ? Need{} : adding(d, d.scene.lights[k]);
}
Need needOfSpecular(const Decision& d, std::size_t k) {
    if (!d.of(Part::Light, k)) return d.of(Part::Light, k);
    if (modelOf(d.scene).light.specular.empty()) return {kNoSpecular};
    if (anyMaterial(d.drawn, [&](const Material& m) { return shines(d.scene.settings.model, m); })) return {};
    return d.unless(Rule::Specular,
                    d.ofAll("k_s is 0 in every material.", "k_s is 0 in every material that is drawn."));
}
Need needOfAttenuation(const Decision& d, std::size_t k) {
    const Light& light = d.scene.lights[k];
    if (!d.of(Part::Light, k)) return d.of(Part::Light, k);
    if (!modelOf(d.scene).found.glLights) return {onlyIn(&ModelFacts::Found::glLights, "attenuation")};
    if (light.kind == LightKind::AtInfinity) return {"A light at infinity is as bright everywhere."};
    const bool one = light.gl.constant == 1 && light.gl.linear == 0 && light.gl.quadratic == 0;
    return d.unless(Rule::Attenuation, one ? "It is 1 at every distance." : "");
}
Need needOfAmbient(const Decision& d, std::size_t) {
    // A factor below 0, or −0, would make a term of −0, whose sign a buffer shows.
    const auto anySign = [](Vec3d v) { return std::signbit(v.x) || std::signbit(v.y) || std::signbit(v.z); };
    const Vec3d product = d.scene.ambient.lightIn(d.scene.settings.model);
    const bool negative = anySign(product) || anyMaterial(d.scene, [&](const Material& m) {
                              return anySign(m.diffuse) || anySign(m.ambient);
                          });
    return d.unless(Rule::Ambient, product == Vec3d(0) && !negative ? "The ambient light is 0." : "");
}
// Why no specular term reads R, or H; empty if one does. other: the reason of a model whose terms read the other one.
std::string whyUnread(const Scene& scene, bool VectorsRead::*vector, const char* other) {
    if (anySpecularReads(scene, vector)) return {};
    return modelOf(scene).light.specular.empty() ? kNoSpecular : other;
}
// R and H: also what the model reads is left out of a scene without specular terms.
Need needOfDirection(const Decision& d, Part part, bool VectorsRead::*vector, const char* other) {
    const ModelFacts& model = modelOf(d.scene);
    const bool ofModel = anySpecularReads(d.drawn, vector);
    if (d.isRead(part) || (ofModel && d[Part::Specular]) || model.found.diffuse.*vector) return {};
    const bool none = ofModel || d.drawn.objects.empty() || model.light.specular.empty();
    return d.unless(Rule::Directions, none ? "No specular term reads it." : other);
}
Need needOfPosition(const Decision& d, std::size_t) {
    const bool perPixel = d.scene.settings.shading == Shading::Phong;
    const auto reads = [&](const Light& l) { return l.kind != LightKind::AtInfinity && (perPixel || l.castsShadow); };
    const bool read = d.isRead(Part::Position) || d[Part::ShadowBuffer] ||
                      (modelOf(d.scene).viewer == Viewer::Setting && d[Part::ViewVector]) ||
                      std::ranges::any_of(d.scene.lights, reads);
    return d.unless(Rule::Position, read ? "" : "No light and nobody reads it.");
}
// What the contrast is found of: terms of light by its colour, summed up in pixels; elsewhere a vertex's terms are
// interpolated one by one. Without it the power is left out only where it is rounded to 0.
Need needOfNegligible(const Decision& d, std::size_t) {
    const bool sums = d.scene.settings.shading == Shading::Phong && !modelOf(d.scene).found.glLights;
    return sums && !d.isRead(Part::NegligiblePowers) ? d.within(Rule::VanishingPower) : Need{};
}
Need needOfIntensity(const Decision& d, std::size_t) {
    const bool read =
        !d[Part::ShadedInVectors] || d[Part::Layers] || d[Part::Antialiasing] || d.isRead(Part::Intensity);
    return d.unless(Rule::UnreadBuffers, read ? "" : "Nobody asks for it.");
}
Need needOfLayers(const Decision& d, std::size_t) {
    return outlines(d.scene) ? Need{kOutlines} : d.unless(Rule::TranslucentPass, whyNoLayers(d.scene));
}
Need needOfSort(const Decision& d, std::size_t) {
    if (d.scene.settings.translucency == Translucency::Polygons) return {"Off in this scene: translucency = polygons."};
    if (!d[Part::Layers] || !d[Part::Layers].despite.empty()) return d[Part::Layers];
    const bool single = translucentTriangles(d.scene) == 1;
    return d.unless(Rule::LayerSort, single ? "There is one translucent triangle: no pixel has two layers." : "");
}
bool hasLights(const Scene& scene, const Needs&) { return !scene.lights.empty(); }

Need anyNeeded(const Scene&, const std::vector<Need>& each) {
    const auto needed = std::ranges::find_if(each, [](const Need& need) { return bool(need); });
    return needed == each.end() ? Need{"No light needs it."} : *needed;
}

using S = StageId;
using R = Part;

constexpr auto kRowsOfShading = std::to_array<PartInfo>({
    {.id = R::PolygonTerms,
     .stage = S::Shading,
     .name = "polygon terms",
     .need = [](auto& d, auto) -> Need {
         if (d.isRead(R::PolygonTerms)) return {};
         if (outlines(d.scene)) return {kOutlines};
         const bool read = d.scene.settings.shading == Shading::Flat;
         return d.unless(Rule::PolygonTerms, read ? "" : "Only flat shading evaluates polygons.");
     },
     .runs = "Flat shading reads them, or they are asked for.",
     .saves = "a pass over the polygons",
     .useless = whyNot<R::PolygonTerms>},
    {.id = R::VertexTerms,
     .stage = S::Shading,
     .name = "vertex terms",
     .need = [](auto& d, auto) -> Need {
         if (d.isRead(R::VertexTerms)) return {};
         if (outlines(d.scene)) return {kOutlines};
         const bool read = d.scene.settings.shading == Shading::Gouraud;
         return d.unless(Rule::VertexTerms, read ? "" : "Only Gouraud shading evaluates vertices.");
     },
     .runs = "Gouraud shading reads them, or they are asked for.",
     .saves = "a pass over the vertices",
     .useless = whyNot<R::VertexTerms>},
    {.id = R::HiddenPolygons,
     .stage = S::Shading,
     .name = "hidden polygons",
     .need = [](auto& d, auto) { return needOfHidden(d, Rule::HiddenPolygons, R::PolygonTerms); },
     .runs =
         [](auto& scene, auto& needs, auto) {
             return allHidden(scene, needs, Rule::HiddenPolygons, "Also those that culling dropped or no pixel shows.");
         },
     .within = "Not those that culling dropped or, where they are small, no pixel shows.",
     .isListed = [](auto&, auto& needs) { return bool(needs[R::PolygonTerms]); },
     .ofOutlines = false},
    {.id = R::HiddenVertices,
     .stage = S::Shading,
     .name = "hidden vertices",
     .need = [](auto& d, auto) { return needOfHidden(d, Rule::HiddenVertices, R::VertexTerms); },
     .runs =
         [](auto& scene, auto& needs, auto) {
             return allHidden(scene, needs, Rule::HiddenVertices, "Also those all of whose polygons are hidden.");
         },
     .within = "Not those all of whose polygons are hidden.",
     .isListed = [](auto&, auto& needs) { return bool(needs[R::VertexTerms]); },
     .ofOutlines = false},
    {.id = R::Ambient,
     .stage = S::Shading,
     .name = "ambient term",
     .need = needOfAmbient,
     .runs = "There is ambient light.",
     .saves = "a product a point",
     .ofOutlines = false},
    {.id = R::Light,
     .stage = S::Shading,
     .name = "light {}",
     .need = needOfLight,
     .forAll = anyNeeded,
     .runs = [](auto& scene, auto&, auto) -> std::string {
         return outlines(scene) ? "Somebody reads what it adds to polygons or vertices."
                                : "It shines, or what it adds is asked for.";
     },
     .saves = "an evaluation a point"},
    {.id = R::Specular,
     .stage = S::Shading,
     .name = "specular of light {}",
     .isHanded = false,
     .need = needOfSpecular,
     .forAll = anyNeeded,
     .runs = [](auto& scene, auto&, auto) -> std::string {
         return modelOf(scene).dullWithoutKs ? "A material has a k_s other than 0."
                                             : "The illumination model has one for every material.";
     },
     .saves = "a power a point",
     .ofOutlines = false},
    {.id = R::Attenuation,
     .stage = S::Shading,
     .name = "attenuation of light {}",
     .need = needOfAttenuation,
     .forAll = anyNeeded,
     .runs = "It is not 1 at every distance.",
     .saves = "a distance and a division a point",
     .isListed = [](auto& scene, auto&) { return modelOf(scene).found.glLights; },
     .ofOutlines = false},
    {.id = R::Reflection,
     .stage = S::Shading,
     .name = "R",
     .isHanded = false,
     .need = [](auto& d, auto) { return needOfDirection(d, R::Reflection, &VectorsRead::R, kOnlyH); },
     .runs = "The illumination model reads it, or it is asked for.",
     .saves = "a vector a point and light",
     .isListed = hasLights,
     .ofOutlines = false,
     .useless = [](auto& scene, auto&, auto) { return whyUnread(scene, &VectorsRead::R, kOnlyH); }},
    {.id = R::Halfway,
     .stage = S::Shading,
     .name = "H",
     .isHanded = false,
     .need = [](auto& d, auto) { return needOfDirection(d, R::Halfway, &VectorsRead::H, kOnlyR); },
     .runs = "The illumination model reads it, or it is asked for.",
     .saves = "a normalisation a point and light",
     .isListed = hasLights,
     .ofOutlines = false,
     .useless = [](auto& scene, auto&, auto) { return whyUnread(scene, &VectorsRead::H, kOnlyR); }},
    {.id = R::Powers,
     .stage = S::Shading,
     .name = "powers",
     .isHanded = false,
     .need =
         [](auto& d, auto) {
             return d.scene.settings.forms.power == PowerForm::Log1p ? d.within(Rule::VanishingPower) : Need{};
         },
     .runs = [](auto& scene, auto&, auto) -> std::string {
         if (scene.settings.forms.power == PowerForm::Log1p)
             return "Also where the result rounds to 0 or changes nothing.";
         return "All: where the result rounds to 0 is known of numerics.power = log1p alone.";
     },
     .within = "Not where the result is certain to round to 0, or changes nothing that is asked for.",
     .isListed = hasLights,
     .ofOutlines = false},
    {.id = R::NegligiblePowers, .stage = S::Shading, .isHanded = false, .need = needOfNegligible},
    {.id = R::ViewVector,
     .stage = S::Shading,
     .name = "V at a pixel",
     .need =
         [](auto& d, auto) {
             const bool read = d.isRead(R::ViewVector) || d[R::Specular] || modelOf(d.scene).found.diffuse.V;
             return d.unless(Rule::ViewVector, read ? "" : "No specular term reads it.");
         },
     .runs = "A specular term reads it, or it is asked for.",
     .saves = "a normalisation a pixel",
     .ofOutlines = false},
    {.id = R::Position,
     .stage = S::Shading,
     .name = "position at a pixel",
     .need = needOfPosition,
     .runs = "A light, a shadow or V reads it, or it is asked for.",
     .saves = "an interpolation a pixel",
     .ofOutlines = false},
    {.id = R::ShadowLookup,
     .stage = S::Shading,
     .name = "shadow look-up",
     .need = [](auto& d, auto) { return d.within(Rule::ShadowLookup); },
     .runs = "At every pixel.",
     .within = "Not where the terms that it would multiply are 0.",
     .isListed = [](auto&, auto& needs) { return bool(needs[R::ShadowBuffer]); },
     .ofOutlines = false,
     .useless = whyNoShadows},
    {.id = R::Antialiasing,
     .stage = S::Shading,
     .name = "antialiasing",
     .isHanded = false,
     .need =
         [](auto& d, auto) {
             return only(d.scene.settings.antialiasing > 1,
                         "Off in this scene: antialiasing = 1. It is the intensity.");
         },
     .runs =
         [](auto& scene, auto&, auto) {
             const int n = scene.settings.antialiasing;
             return fmt::format("The picture is drawn once more for each of {} samples a pixel.", n * n);
         },
     .isListed = [](auto&, auto& needs) { return bool(needs[R::Antialiasing]); },
     .ofOutlines = false,
     .useless = whyNot<R::Antialiasing>},
    {.id = R::ShadedInVectors,
     .stage = S::Shading,
     .name = "pixels in vectors",
     .need =
         [](auto& d, auto) {
             if (hasVertexColors(d.scene)) return Need{"It takes no colours of vertices."};
             return Need{whyNotShadedInVectors(d.scene.settings, d.wanted())};
         },
     .runs = [](auto&, auto& needs, auto) -> std::string {
         return needs[R::FastVectors] ? "Several at a time, in fast arithmetic."
                                      : "Several at a time, the same bits as one by one.";
     },
     .ofOutlines = false},
    {.id = R::FastVectors,
     .stage = S::Shading,
     .need =
         [](auto& d, auto) {
             const bool fast = d.scene.settings.arithmetic == Arithmetic::Fast;
             return fast ? d[R::ShadedInVectors] : Need{"Off in this scene: arithmetic = exact."};
         }},
    {.id = R::Tiles,
     .stage = S::Shading,
     .name = "tiles",
     .need = [](auto& d, auto) { return d.within(Rule::EmptyTiles); },
     .runs = "All of them.",
     .within = [](auto& scene, auto&, auto) -> std::string {
         return outlines(scene) ? "Not those that no outline touches." : "Not those in which nothing was drawn.";
     }},
    {.id = R::Layers,
     .stage = S::Shading,
     .name = "translucent pass",
     .isHanded = false,
     .need = needOfLayers,
     .runs = "A material has alpha below 1.",
     .saves = "a pass over the tiles",
     .ofOutlines = false,
     .useless = [](auto& scene, auto&, auto) { return whyNoLayers(scene); }},
    {.id = R::LayerSort,
     .stage = S::Shading,
     .name = "sort of layers",
     .isHanded = false,
     .need = needOfSort,
     .runs = "Layers are put in order by depth at every pixel.",
     .saves = "a sort a tile",
     .ofOutlines = false},
    {.id = R::Emission,
     .stage = S::Shading,
     .isHanded = false,
     .need =
         [](auto& d, auto) {
             return only(modelOf(d.scene).found.emission, onlyIn(&ModelFacts::Found::emission, "emission"));
         },
     .useless = whyNot<R::Emission>},
    {.id = R::Intensity, .stage = S::Shading, .isHanded = false, .need = needOfIntensity},
    {.id = R::SurfaceVectors, .stage = S::Shading, .isHanded = false, .need = [](auto&, auto) { return Need{}; }},
    {.id = R::LightVectors, .stage = S::Shading, .isHanded = false, .need = [](auto&, auto) { return Need{}; }},
});
static_assert(areInOrder(kRowsOfShading, R::PolygonTerms) &&
              index(R::PolygonTerms) + kRowsOfShading.size() == kPartCount);

}  // namespace

std::span<const PartInfo> partsOfShading() { return kRowsOfShading; }

}  // namespace pipeline
