// The parts of the stages before shading.
#include <algorithm>

#include <fmt/format.h>

#include "pipeline/plan/as_given.h"
#include "pipeline/plan/own_normals.h"
#include "pipeline/plan/part_rows.h"
#include "pipeline/plan/shadow_reach.h"
#include "pipeline/scene/area_light.h"
#include "pipeline/scene/mesh/topology.h"
#include "pipeline/simd/kernels.h"

namespace pipeline {
namespace {

Need needOfCulling(const Decision& d, std::size_t) {
    const bool facing = lightsBacks(d.scene.settings);  // which side is lit
    if (d.scene.settings.cull != CullMode::None || facing || d.isRead(Part::Culling)) return {};
    const std::size_t count = polygonCount(d.scene);
    const std::string all = count == 1 ? "The only polygon goes on." : fmt::format("All {} polygons go on.", count);
    return d.unless(Rule::Culling, "Off in this scene: cull = none. " + all);
}

// Why a run that ends before shading does not need normals: no pixel is shaded with them. A run that ends with this
// stage needs them, and so does a request for their buffers.
std::string unread(const Decision& d) {
    if (d.until == StageId::Shading || d.until == StageId::Normals) return {};
    return fmt::format("The run ends after {}, and nobody asks for them.", stageInfo(d.until).name);
}
// Of a fine mesh, of one polygon for four pixels and more, most are never seen.
bool findsNormalsWhereSeen(const Decision& d) {
    const Settings& settings = d.scene.settings;
    const bool isFine = 4.0 * double(polygonCount(d.scene)) > double(settings.width) * double(settings.height);
    return isFine && settings.shading != Shading::Flat && d.until == StageId::Shading && d[Part::ShadedInVectors] &&
           settings.forms.polygonNormal == PolygonNormalForm::Newell &&
           std::ranges::all_of(d.scene.objects, [](const Object& o) { return o.mesh->hasTrianglesAlone(); });
}
Need needOfPolygonNormals(const Decision& d, std::size_t) {
    if (d.isRead(Part::PolygonNormals) || (d[Part::VertexNormals] && d[Part::NormalSums])) return {};
    if (const std::string why = unread(d); !why.empty()) return d.unless(Rule::PolygonNormals, why);
    if (d[Part::PolygonTerms] && !allLitByFirstVertex(d.scene)) return {};
    if (outlines(d.scene)) return {kOutlines};
    // Which side of a polygon a light meets is asked of every light that casts a shadow, with or without a buffer.
    const bool facing = modelOf(d.scene).shadows && std::ranges::any_of(d.scene.lights, &Light::castsShadow);
    const bool read = (d.scene.settings.shading == Shading::Flat && !allLitByFirstVertex(d.scene)) || facing;
    std::string why;
    if (!read)
        why = "Every vertex has a normal of its own, and there are no shadows.";
    else if (findsNormalsWhereSeen(d))
        why = "Shadows alone read them, each where its polygon is seen: there it is found.";
    return d.unless(Rule::PolygonNormals, why);
}
Need needOfSums(const Decision& d, std::size_t) {
    if (!d[Part::VertexNormals]) return d[Part::VertexNormals];
    const std::vector<bool>& own = d.ownNormals();
    const bool all = !own.empty() && std::ranges::all_of(own, std::identity());
    return d.unless(Rule::PolygonNormals, all ? "Every vertex has a normal of its own." : "");
}
std::string sumsOf(const Scene&, const Needs& needs, std::size_t) {
    const auto own = std::ranges::count(needs.ownNormals, true);
    if (own == 0) return "Vertex normals are means of polygon normals.";
    return fmt::format("In all objects but {}, in which every vertex has a normal of its own.", own);
}
Need needOfVertexNormals(const Decision& d, std::size_t) {
    const bool asked = d.isRead(Part::VertexNormals);
    if (const std::string why = unread(d); !why.empty() && !asked) return d.unless(Rule::VertexNormals, why);
    if (outlines(d.scene) && !asked && !d[Part::VertexTerms]) return {kOutlines};
    const bool read = d.scene.settings.shading != Shading::Flat || asked || d[Part::VertexTerms] ||
                      (d[Part::PolygonTerms] && anyLitByFirstVertex(d.scene));
    return d.unless(Rule::VertexNormals, read ? "" : "Flat shading needs polygon normals only.");
}
bool hasVertexNormals(const Scene&, const Needs& needs) { return bool(needs[Part::VertexNormals]); }

Need needOfShadow(const Decision& d, std::size_t k) {
    const Light& light = d.scene.lights[k];
    if (!light.castsShadow) return {"It casts no shadow."};
    if (d.isRead(Part::ShadowBuffer)) return {};
    if (outlines(d.scene)) return {kOutlines};
    if (const Fact& shadows = modelOf(d.scene).shadows; !shadows) return {std::string(shadows.whyNot)};
    if (!d.of(Part::Light, k)) return d.of(Part::Light, k);
    if (Need adds = adding(d, light); !adds && !d.isRead(Part::ShadowLookup)) return adds;
    if (d.drawn.objects.empty()) return {d.ofAll("The scene has no object.", "Every object has alpha 0.")};
    const auto amongDrawn = [&](const std::string& why) {
        return why.empty() ? why : d.ofAll(why, "Objects of alpha 0 cast none. " + why);
    };
    Need convex = d.unless(Rule::ConvexShadow, amongDrawn(whyNoSelfShadow(d.drawn)));
    if (!convex) return convex;
    Need distant = d.unless(Rule::DistantShadow, amongDrawn(whyNoShadowBetween(d.drawn, light)));
    return distant && distant.despite.empty() ? convex : distant;
}
// One sentence for all lights when they agree.
Need needOfShadows(const Scene& scene, const std::vector<Need>& each) {
    if (std::ranges::any_of(each, [](const Need& need) { return bool(need); })) return {};
    const bool same = std::ranges::all_of(each, [&](const Need& n) { return n.notBecause == each[0].notBecause; });
    if (each.empty() || std::ranges::none_of(scene.lights, &Light::castsShadow)) return {"No light casts a shadow."};
    if (same && each[0].rule != Rule::DarkLight) return each[0];
    return {"No light needs one.", each[0].rule};
}
std::string passesOf(const Scene& scene, const Needs&, std::size_t k) {
    const double texels = double(scene.settings.shadowSize) * scene.settings.shadowSize;
    const int faces = sampleGrid(scene.lights[k]).count() * shadowFacesPerSample(scene.lights[k].kind);
    return fmt::format("{} {}, {:.1f} MB", faces, faces == 1 ? "pass" : "passes",
                       texels * faces * bytesOf(scene.settings.precision) / 1e6);
}
// What the kernels need not leave; the stage's own text always leaves it.
Need beside(const Decision& d, bool read, const char* notBecause) {
    return d.unless(Rule::UnreadBuffers, read || !d[Part::DrawnInVectors] ? "" : notBecause);
}
Need needOfWeights(const Decision& d, std::size_t) {
    const bool asked = d.isRead(Part::Weights);
    if (d.until < StageId::Shading) return beside(d, asked, "Nobody asks for them.");
    return beside(d, asked || !d[Part::ShadedInVectors],
                  "Nobody asks for them, and vectors of pixels keep them for no longer than a tile.");
}
Need needOfOrder(const Scene& scene) {
    if (scene.settings.visibility == Visibility::Painter) return {};
    return {outlines(scene) ? "Outlines are drawn in the order of the scene." : "The z-buffer needs no order."};
}

using S = StageId;
using R = Part;

constexpr auto kRowsBefore = std::to_array<PartInfo>({
    {.id = R::ModelTransform,
     .stage = S::Transform,
     .name = "model transform",
     .need = [](auto& d, auto) { return d.unless(Rule::ModelTransform, whyPlacesStay(d.scene)); },
     .runs = "It takes objects to world space, vertex by vertex.",
     .saves = "a product of a matrix and a vertex, and a copy"},

    {.id = R::Culling, .stage = S::Cull, .need = needOfCulling, .useless = whyNot<R::Culling>},

    {.id = R::PolygonNormals,
     .stage = S::Normals,
     .name = "polygon normals",
     .need = needOfPolygonNormals,
     .runs = "Shading, shadows or vertex normals read them, or they are asked for.",
     .saves = "a pass over the polygons"},
    {.id = R::NormalSums,
     .stage = S::Normals,
     .name = "sums around vertices",
     .need = needOfSums,
     .runs = sumsOf,
     .saves = "a pass over the polygons",
     .isListed = hasVertexNormals},
    {.id = R::VertexNormals,
     .stage = S::Normals,
     .name = "vertex normals",
     .need = needOfVertexNormals,
     .runs = "Normals are interpolated, or asked for.",
     .saves = "a pass over the vertices",
     .useless = whyNot<R::VertexNormals>},
    {.id = R::Normalisation,
     .stage = S::Normals,
     .name = "normalisation",
     .need =
         [](auto& d, auto) {
             return d[R::VertexNormals] ? d.unless(Rule::ModelTransform, whyNormalsStay(d.scene)) : d[R::VertexNormals];
         },
     .runs = "They are brought to length 1.",
     .saves = "a pass over the vertices",
     .isListed = hasVertexNormals},

    {.id = R::ShadowBuffer,
     .stage = S::ShadowBuffer,
     .name = "light {}",
     .need = needOfShadow,
     .forAll = needOfShadows,
     .runs = "It casts a shadow, or its buffer is asked for.",
     .saves = passesOf,
     .useless = whyNot<R::ShadowBuffer>},

    {.id = R::Clipping,
     .stage = S::ZBuffer,
     .name = "clipping",
     .need = [](auto& d, auto) { return d.within(Rule::Clipping); },
     .runs = [](auto&, auto& needs, auto) -> std::string {
         if (needs[R::Culling]) return "Of every polygon.";
         return "Of every polygon: culling, which finds those that are whole in the picture, is left out.";
     },
     .within = [](auto&, auto& needs, auto) -> std::string {
         return needs[R::Culling] ? "Only of polygons that culling did not find whole in the picture." : "";
     },
     .ofOutlines = false},
    {.id = R::SeenPolygons,
     .stage = S::ZBuffer,
     .name = "polygons seen",
     .need =
         [](auto& d, auto) {
             return beside(d, d.until >= S::Shading || d.isRead(R::SeenPolygons), "Nobody asks for them.");
         },
     .runs = "Shading reads which polygon a pixel sees, or it is asked for.",
     .saves = "4 bytes a pixel"},
    {.id = R::FragmentCounts,
     .stage = S::ZBuffer,
     .name = "counts of fragments",
     .need = [](auto& d, auto) { return beside(d, d.isRead(R::FragmentCounts), "Nobody asks for them."); },
     .runs = "They are asked for, or come by themselves.",
     .saves = "8 bytes a pixel"},
    {.id = R::Weights,
     .stage = S::ZBuffer,
     .name = "barycentric weights",
     .need = needOfWeights,
     .runs = "Shading reads them, or they are asked for.",
     .saves = "12 bytes a pixel"},
    {.id = R::DepthTest,
     .stage = S::ZBuffer,
     .name = "depth test",
     .need = [](auto& d, auto) -> Need {
         if (outlines(d.scene)) return {"Outlines are drawn one over the other: no depths are compared."};
         return only(d.scene.settings.visibility != Visibility::Painter, "The painter's algorithm compares no depths.");
     },
     .runs = "Of all fragments at a pixel the nearest stays.",
     .useless = whyNot<R::DepthTest>},
    {.id = R::Sort,
     .stage = S::ZBuffer,
     .name = "sort",
     .need = [](auto& d, auto) { return needOfOrder(d.scene); },
     .runs = "Polygons are painted from the farthest to the nearest."},
    {.id = R::Split,
     .stage = S::ZBuffer,
     .name = "split",
     .need =
         [](auto& d,
            auto) { return d[R::Sort] ? only(d.scene.settings.split, "Off in this scene: split = off.") : d[R::Sort]; },
     .runs = "Polygons may intersect, or overlap in a cycle."},
    {.id = R::DrawnInVectors,
     .stage = S::ZBuffer,
     .need = [](auto& d, auto) { return Need{whyNotDrawnInVectors(d.scene.settings)}; }},
});
static_assert(areInOrder(kRowsBefore, R::ModelTransform));

}  // namespace

std::span<const PartInfo> partsBeforeShading() { return kRowsBefore; }

}  // namespace pipeline
