// The words for a moment.
#include <fmt/format.h>

#include "pipeline/scene/scene.h"
#include "pipeline/steps/step_source.h"
#include "pipeline/steps/steps.h"

namespace pipeline {
namespace {

std::string_view unitOf(StageId stage, const StepPhase& phase) {
    switch (phase.kind) {
        case ElementKind::Vertex: return stage == StageId::Normals ? "vertex normals" : "vertices";
        case ElementKind::PolygonTerms: return "polygons evaluated";
        case ElementKind::VertexTerms: return "vertices evaluated";
        case ElementKind::Layers: return "passes of layers";
        case ElementKind::Samples: return "means of samples";
        case ElementKind::Polygon:
        case ElementKind::Piece: break;
    }
    if (stage == StageId::Normals) return "polygon normals";
    if (phase.rows.empty()) return "polygons";
    return stage == StageId::ZBuffer ? "fragments" : "pixels";
}

std::string elementWords(const Place& place, std::optional<std::uint32_t> polygon) {
    switch (place.kind) {
        case ElementKind::Vertex: return fmt::format("vertex {}", place.number);
        case ElementKind::Polygon: return fmt::format("polygon {}", place.number);
        case ElementKind::Piece: return fmt::format("piece {} of polygon {}", place.number, polygon.value_or(0));
        case ElementKind::PolygonTerms: return fmt::format("terms of polygon {}", place.number);
        case ElementKind::VertexTerms: return fmt::format("terms of vertex {}", place.number);
        case ElementKind::Layers: return "translucent layers";
        case ElementKind::Samples: return "mean of the samples";
    }
    return {};
}

}  // namespace

Steps::Progress Steps::progress(Moment moment) const {
    moment = fitting(moment);
    const StepPhase* now = nullptr;
    for (const StepPhase& phase : phases(moment.stage))
        if (!now || moment.done > phase.first) now = &phase;
    if (!now) return {};
    Progress progress{moment.done - now->first, now->total(), std::string(unitOf(moment.stage, *now))};
    if (now->light >= 0) progress.unit += fmt::format(" for light {}", now->light);
    return progress;
}

std::string Steps::words(Moment moment, StepLevel level) const {
    moment = fitting(moment);
    const std::string_view stage = stageInfo(moment.stage).label;
    const bool over = moment.done == total(moment.stage);
    if (moment.step() < 0) return over ? fmt::format("{}, done", stage) : fmt::format("{}, not begun", stage);
    if (over && level == StepLevel::Stage) return fmt::format("{}, done", stage);
    const Spot spot = at(moment.stage, moment.step());
    const StepPhase& phase = *spot.phase;
    Place place = placeOf(moment);
    const bool inside = place.row.has_value() || moment.line > 0;
    place.kind = phase.kind, place.number = phase.number(spot.element);
    // The line first: it is what changes, and what a place that is cut must still say.
    std::string words = place.line ? fmt::format("line {}, ", *place.line) : std::string();
    if (phase.light >= 0) words += fmt::format("light {}, ", phase.light);
    const bool endsObject = !inside && moment.done == end(moment.stage, moment.step(), StepLevel::Object);
    const bool hasObject = phase.kind != ElementKind::Layers && phase.kind != ElementKind::Samples;
    if (level == StepLevel::Object && endsObject && hasObject) {
        const std::uint32_t object = objectOf(spot);
        return words + fmt::format("object {}, {}", object, m_frame->scene().objects[object].name);
    }
    words += elementWords(place, polygonOf(spot));
    const auto pixel = level >= StepLevel::Scanline || inside ? pixelOf(moment) : std::nullopt;
    if (pixel) words += fmt::format(", row {}", pixel->y);
    if (pixel && (level >= StepLevel::Pixel || place.x)) words += fmt::format(", x {}", pixel->x);
    return words;
}

}  // namespace pipeline
