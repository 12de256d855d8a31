#include "pipeline/plan/plan_parts.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/scene/area_light.h"

namespace pipeline {
namespace {

struct Parts {
    const Scene& scene;
    const Needs& needs;
    Action action;
    std::vector<PlanPart> parts{};

    void runs(std::string part, std::string why) { parts.push_back({std::move(part), action, std::move(why), "", {}}); }
    void add(std::string part, const Need& need, const std::string& why, std::string saves) {
        if (need)
            runs(std::move(part), need.despite.empty() ? why : need.despite);
        else
            parts.push_back(
                {std::move(part), Action::LeaveOut, need.notBecause, need.rule ? std::move(saves) : "", need.rule});
    }
    // What a rule decides element by element while the stage runs; the run counts it.
    void within(std::string part, Rule rule, std::string where, std::string why) {
        const bool inForce = needs.rules[index(rule)];
        parts.push_back({std::move(part), action, inForce ? std::move(where) : std::move(why), "",
                         inForce ? std::optional(rule) : std::nullopt});
    }
};

double bytesOf(const Scene& scene, double numbers) { return numbers * bytesOf(scene.settings.precision); }

void shadowParts(Parts& out) {
    const Scene& scene = out.scene;
    const double texels = double(scene.settings.shadowSize) * scene.settings.shadowSize;
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        const int faces = sampleGrid(scene.lights[k]).count() * shadowFacesPerSample(scene.lights[k].kind);
        out.add(fmt::format("light {}", k), out.needs.shadowBuffer[k], "It casts a shadow, or its buffer is asked for.",
                fmt::format("{} {}, {:.1f} MB", faces, faces == 1 ? "pass" : "passes",
                            bytesOf(scene, texels * faces) / 1e6));
    }
}

void zBufferParts(Parts& out) {
    const Settings& settings = out.scene.settings;
    const bool sorts = settings.visibility == Visibility::Painter;
    const bool outlines = settings.visibility == Visibility::None;
    const std::string noOrder = sorts      ? ""
                                : outlines ? "Outlines are drawn in the order of the scene."
                                           : "The z-buffer needs no order.";
    if (!outlines && out.needs.cull)
        out.within("clipping", Rule::Clipping, "Only of polygons that culling did not find whole in the picture.",
                   "Of every polygon.");
    else if (!outlines)
        out.runs("clipping",
                 "Of every polygon: culling, which finds those that are whole in the picture, is left out.");
    out.add("polygons seen", out.needs.seenPolygons, "Shading reads which polygon a pixel sees, or it is asked for.",
            "4 bytes a pixel");
    out.add("counts of fragments", out.needs.fragmentCounts, "They are asked for, or come by themselves.",
            "8 bytes a pixel");
    out.add("barycentric weights", out.needs.weights, "Shading reads them, or they are asked for.", "12 bytes a pixel");
    out.add("depth test", out.needs.depthTest, "Of all fragments at a pixel the nearest stays.", "");
    out.add("sort", {noOrder, {}}, "Polygons are painted from the farthest to the nearest.", "");
    out.add("split", {sorts && !settings.split ? "Off in this scene: split = off." : noOrder, {}},
            "Polygons may intersect, or overlap in a cycle.", "");
}

// evaluatesAll: where the rule is in force, for somebody who asks.
void hiddenPart(Parts& out, std::string part, Rule rule, bool evaluatesAll, std::string where, std::string why) {
    if (out.scene.settings.antialiasing > 1)
        out.runs(std::move(part), "All: snapped anew for each sample of a pixel, any may be seen in one.");
    else if (evaluatesAll && out.needs.rules[index(rule)])
        out.runs(std::move(part), "All: their intensities are asked for.");
    else
        out.within(std::move(part), rule, std::move(where), std::move(why));
}

void shadingParts(Parts& out) {
    const Needs& needs = out.needs;
    out.add("polygon terms", needs.polygonTerms, "Flat shading reads them, or they are asked for.",
            "a pass over the polygons");
    out.add("vertex terms", needs.vertexTerms, "Gouraud shading reads them, or they are asked for.",
            "a pass over the vertices");
    if (out.scene.settings.visibility == Visibility::None) {
        for (std::size_t k = 0; k < needs.light.size(); ++k)
            out.add(fmt::format("light {}", k), needs.light[k], "Somebody reads what it adds to polygons or vertices.",
                    "an evaluation a point");
        return out.within("tiles", Rule::EmptyTiles, "Not those that no outline touches.", "All of them.");
    }
    if (needs.polygonTerms)
        hiddenPart(out, "hidden polygons", Rule::HiddenPolygons, needs.hiddenPolygons,
                   "Not those that culling dropped or, where they are small, no pixel shows.",
                   "Also those that culling dropped or no pixel shows.");
    if (needs.vertexTerms)
        hiddenPart(out, "hidden vertices", Rule::HiddenVertices, needs.hiddenVertices,
                   "Not those all of whose polygons are hidden.", "Also those all of whose polygons are hidden.");
    out.add("ambient term", needs.ambient, "There is ambient light.", "a product a point");
    const char* why = modelFacts(out.scene.settings.model).dullWithoutKs
                          ? "A material has a k_s other than 0."
                          : "The illumination model has one for every material.";
    for (std::size_t k = 0; k < needs.light.size(); ++k) {
        out.add(fmt::format("light {}", k), needs.light[k], "It shines, or what it adds is asked for.",
                "an evaluation a point");
        out.add(fmt::format("specular of light {}", k), needs.specular[k], why, "a power a point");
        if (modelFacts(out.scene.settings.model).found.glLights)
            out.add(fmt::format("attenuation of light {}", k), needs.attenuation[k], "It is not 1 at every distance.",
                    "a distance and a division a point");
    }
    if (!needs.light.empty()) {
        out.add("R", needs.reflection, "The illumination model reads it, or it is asked for.",
                "a vector a point and light");
        out.add("H", needs.halfway, "The illumination model reads it, or it is asked for.",
                "a normalisation a point and light");
        if (out.scene.settings.forms.power == PowerForm::Log1p)
            out.within("powers", Rule::VanishingPower,
                       "Not where the result is certain to round to 0, or changes nothing that is asked for.",
                       "Also where the result rounds to 0 or changes nothing.");
        else
            out.runs("powers", "All: where the result rounds to 0 is known of numerics.power = log1p alone.");
    }
    out.add("V at a pixel", needs.viewVector, "A specular term reads it, or it is asked for.",
            "a normalisation a pixel");
    out.add("position at a pixel", needs.position, "A light, a shadow or V reads it, or it is asked for.",
            "an interpolation a pixel");
    if (needs.shadowBuffers)
        out.within("shadow look-up", Rule::ShadowLookup, "Not where the terms that it would multiply are 0.",
                   "At every pixel.");
    if (const int n = out.scene.settings.antialiasing; n > 1)
        out.runs("antialiasing", fmt::format("The picture is drawn once more for each of {} samples a pixel.", n * n));
    out.add("pixels in vectors", needs.vectorShading,
            needs.fast ? "Several at a time, in fast arithmetic." : "Several at a time, the same bits as one by one.",
            "");
    out.within("tiles", Rule::EmptyTiles, "Not those in which nothing was drawn.", "All of them.");
    out.add("translucent pass", needs.layers, "A material has alpha below 1.", "a pass over the tiles");
    out.add("sort of layers", needs.layerSort, "Layers are put in order by depth at every pixel.", "a sort a tile");
}

std::string sumsOf(const Needs& needs) {
    const auto own = std::ranges::count(needs.ownNormals, true);
    if (own == 0) return "Vertex normals are means of polygon normals.";
    return fmt::format("In all objects but {}, in which every vertex has a normal of its own.", own);
}

// The buffers of shading that nobody reads, and their size.
void bufferParts(Parts& out) {
    if (!out.needs.rules[index(Rule::UnreadBuffers)]) return out.runs("buffers", "All of them.");
    const Settings& settings = out.scene.settings;
    int unread = 0;
    double numbers = 0;
    for (const BufferInfo& info : bufferTable()) {
        if (info.stage != StageId::Shading || info.domain != Domain::Pixel || info.element != Element::Real ||
            info.id == BufferId::Antialiased || out.needs.buffers[index(info.id)])
            continue;
        const int count = info.perLight ? int(out.scene.lights.size()) : 1;
        unread += count;
        numbers += double(count) * info.channels * settings.width * settings.height;
    }
    if (unread == 0) return out.runs("buffers", "All of them are asked for.");
    out.parts.push_back({fmt::format("{} {}", unread, unread == 1 ? "buffer" : "buffers"), Action::LeaveOut,
                         "Nobody asks for them.", fmt::format("{:.1f} MB", bytesOf(out.scene, numbers) / 1e6),
                         Rule::UnreadBuffers});
}

}  // namespace

std::vector<PlanPart> partsOf(StageId stage, const Scene& scene, const Needs& needs, Action action) {
    Parts out{scene, needs, action};
    switch (stage) {
        case StageId::Transform:
            out.add("model transform", needs.modelTransform, "It takes objects to world space, vertex by vertex.",
                    "a product of a matrix and a vertex, and a copy");
            break;
        case StageId::Cull: break;
        case StageId::Normals:
            out.add("polygon normals", needs.polygonNormals,
                    "Shading, shadows or vertex normals read them, or they are asked for.", "a pass over the polygons");
            if (needs.vertexNormals)
                out.add("sums around vertices", needs.normalSums, sumsOf(needs), "a pass over the polygons");
            out.add("vertex normals", needs.vertexNormals, "Normals are interpolated, or asked for.",
                    "a pass over the vertices");
            if (needs.vertexNormals)
                out.add("normalisation", needs.unitNormals, "They are brought to length 1.",
                        "a pass over the vertices");
            break;
        case StageId::ShadowBuffer: shadowParts(out); break;
        case StageId::ZBuffer: zBufferParts(out); break;
        case StageId::Shading:
            shadingParts(out);
            bufferParts(out);
            break;
    }
    return std::move(out.parts);
}

}  // namespace pipeline
