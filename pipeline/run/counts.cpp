#include "pipeline/run/counts.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/core/text.h"

namespace pipeline {
namespace {

std::uint32_t keptOf(const CullOutput& cull) {
    std::uint32_t kept = 0;  // count_if counts in 64 bits and takes several times as long
    for (const Verdict verdict : cull.verdicts) kept += goesOn(verdict);
    return kept;
}

}  // namespace

template <class Real>
std::string countsOf(StageId stage, const FrameData<Real>& data) {
    const Topology& topology = *data.transform->topology;
    switch (stage) {
        case StageId::Transform:
            return fmt::format("{} {}", topology.vertexCount(), topology.vertexCount() == 1 ? "vertex" : "vertices");
        case StageId::Cull: return fmt::format("{} of {} polygons kept", keptOf(*data.cull), topology.polygonCount());
        case StageId::Normals: {
            std::string text = data.keys.normals.polygonNormals
                                   ? plural(std::int64_t(data.normals->polygon.size()), "polygon normal")
                                   : "polygon normals left out";
            text += data.normals->vertex.empty()
                        ? "; vertex normals left out"
                        : "; " + plural(std::int64_t(data.normals->vertex.size()), "vertex normal");
            if (const std::size_t n = data.normals->vanishing; n > 0)
                text += fmt::format("; {} without a mean, the first polygon's instead", n);
            return text;
        }
        case StageId::ShadowBuffer: {
            std::size_t faces = 0;
            for (const auto& samples : data.shadowBuffer->lights)
                for (const LightView<Real>& sample : samples) faces += sample.faces.size();
            return plural(std::int64_t(faces), "shadow buffer") + fmt::format(" of {}²", data.keys.shadowBuffer.size);
        }
        case StageId::ZBuffer: {
            return fmt::format("{}, {} {}{}", plural(data.zBuffer->arrived, "fragment"), data.zBuffer->won,
                               data.keys.zBuffer.visibility == Visibility::ZBuffer ? "passed" : "written",
                               data.zBuffer->note);
        }
        case StageId::Shading: {
            const long long seen = data.zBuffer->seenPixels;
            if (data.keys.shading.outlines) return plural(seen, "pixel") + " of outlines";
            std::string text = plural(seen, "pixel") + " shaded";
            if (const ShadingCounts& n = data.shading->counts; n.relitTiles > 0)
                text += fmt::format("; N·L, highlights and S reused in {} of {} tiles", n.relitTiles, n.tiles);
            if (data.keys.shading.layers.drawn) text += "; " + plural(data.shading->counts.layers, "layer");
            if (const long long instead = data.shading->counts.affineInstead; instead > 0)
                text += fmt::format("; {} affine, for their polygon is clipped or crosses itself", instead);
            return text;
        }
    }
    return {};
}

template <class Real>
std::vector<Tally> talliesOf(StageId stage, const FrameData<Real>& data) {
    if (stage == StageId::ZBuffer)
        return {{"triangles clipped", data.zBuffer->clipped, data.zBuffer->unclipped, Rule::Clipping}};
    if (stage != StageId::Shading) return {};
    const ShadingCounts& n = data.shading->counts;
    std::vector<Tally> tallies{{"polygons evaluated", n.polygons, n.hiddenPolygons, Rule::HiddenPolygons},
                               {"vertices evaluated", n.vertices, n.hiddenVertices, Rule::HiddenVertices},
                               {"light evaluations", n.evaluations, 0, {}},
                               {"powers", n.powers, n.vanished, Rule::VanishingPower},
                               {"shadow look-ups", n.lookups, n.idleLookups, Rule::ShadowLookup},
                               {"tiles", n.tiles, n.emptyTiles, Rule::EmptyTiles}};
    if (n.relit > 0) tallies.push_back({"light evaluations reused", n.relit, 0, {}});
    return tallies;
}

template <class Real>
std::optional<Remark> remarkOf(StageId stage, const FrameData<Real>& data) {
    if (stage != StageId::ZBuffer || data.zBuffer->unordered == 0) return {};
    return Remark{"split", fmt::format("The painter has given up on {} of {} pieces of triangles after too many "
                                       "comparisons: they are painted unordered, and may hide what is nearer.",
                                       data.zBuffer->unordered, data.zBuffer->pieces)};
}

#define SHADESCOPE_INSTANTIATE(Real)                                        \
    template std::string countsOf(StageId, const FrameData<Real>&);         \
    template std::vector<Tally> talliesOf(StageId, const FrameData<Real>&); \
    template std::optional<Remark> remarkOf(StageId, const FrameData<Real>&);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
