// The search for the next step at a pixel, polygon, vertex or object.
#include <algorithm>

#include "pipeline/scene/mesh/topology.h"
#include "pipeline/steps/step_source.h"
#include "pipeline/steps/steps.h"

namespace pipeline {

template <class EndIn>
std::optional<Moment> Steps::search(Moment moment, EndIn endIn) const {
    moment = fitting(moment);
    for (std::size_t stage = index(moment.stage); stage < kStageCount; ++stage) {
        const StageId id = kStages[stage];
        const std::int64_t done = id == moment.stage ? moment.done : 0;
        for (const StepPhase& phase : phases(id)) {
            if (done >= phase.first + phase.total()) continue;
            const std::int64_t within = std::max<std::int64_t>(0, done - phase.first);
            for (std::size_t i = at(id, phase.first + within).element; i < phase.count; ++i) {
                const std::int64_t over = std::max<std::int64_t>(0, within - phase.begin(i));
                if (const std::int64_t end = endIn(Spot{id, &phase, i}, over); end > over)
                    return Moment{id, phase.first + phase.begin(i) + end};
            }
        }
    }
    return std::nullopt;
}

std::optional<Moment> Steps::nextAt(Moment moment, glm::ivec2 pixel) const {
    return search(moment, [&](const Spot& spot, std::int64_t) {
        std::int64_t before = 0;
        if (spot.phase->rows.empty()) return before;
        for (const PixelSpan& span : m_source->spans(spot.stage, spot.element)) {
            if (span.y == pixel.y && span.first <= pixel.x && pixel.x <= span.last)
                return before + pixel.x - span.first + 1;
            before += span.length();
        }
        return std::int64_t(0);
    });
}

std::optional<Moment> Steps::nextAt(Moment moment, Thing thing, std::uint32_t number) const {
    return search(moment, [&](const Spot& spot, std::int64_t) -> std::int64_t {
        const ElementKind kind = spot.phase->kind;
        if (kind == ElementKind::Layers || kind == ElementKind::Samples) return 0;
        const bool vertex = kind == ElementKind::Vertex || kind == ElementKind::VertexTerms;
        const bool here = thing == Thing::Object    ? objectOf(spot) == number
                          : thing == Thing::Polygon ? polygonOf(spot) == number
                                                    : vertex && spot.phase->number(spot.element) == number;
        return here ? spot.phase->end(spot.element) - spot.phase->begin(spot.element) : 0;
    });
}

std::vector<std::uint8_t> Steps::polygonsDone(Moment moment) const {
    moment = fitting(moment);
    const Topology& topology = m_frame->topology();
    std::vector<std::uint8_t> polygons(topology.polygonCount(), 0), vertices;
    const StepPhase* now = nullptr;
    for (const StepPhase& phase : phases(moment.stage))
        if (!now || moment.done > phase.first) now = &phase;
    if (!now) return polygons;
    if (now->kind == ElementKind::Vertex || now->kind == ElementKind::VertexTerms)
        vertices.resize(topology.vertexCount(), 0);
    else if (now->kind == ElementKind::Layers || now->kind == ElementKind::Samples)
        return std::vector<std::uint8_t>(topology.polygonCount(), 1);
    for (std::size_t i = 0; i < now->count && now->first + now->end(i) <= moment.done; ++i) {
        if (vertices.empty())
            polygons[*polygonOf({moment.stage, now, i})] = 1;
        else
            vertices[now->number(i)] = 1;
    }
    if (vertices.empty()) return polygons;
    for (std::size_t polygon = 0; polygon < polygons.size(); ++polygon) {
        const Topology::Corners corners = topology.corners(polygon);
        polygons[polygon] = 1;
        for (std::size_t i = 0; i < corners.size(); ++i) polygons[polygon] &= vertices[corners[i]];
    }
    return polygons;
}

}  // namespace pipeline
