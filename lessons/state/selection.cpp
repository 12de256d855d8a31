#include "lessons/state/selection.h"

#include <algorithm>

#include "pipeline/scene/mesh/topology.h"

namespace lessons {

using pipeline::TableId;

namespace {

std::size_t countOf(const pipeline::Scene& scene, Selection::Kind kind) {
    using Kind = Selection::Kind;
    std::size_t count = 0;
    switch (kind) {
        case Kind::Object: return scene.objects.size();
        case Kind::Light: return scene.lights.size();
        case Kind::Polygon:
            for (const pipeline::Object& object : scene.objects) count += object.mesh->polygonCount();
            return count;
        case Kind::Vertex:
            for (const pipeline::Object& object : scene.objects) count += object.mesh->positions.size();
            return count;
    }
    return count;
}

std::vector<std::uint32_t> cornersOf(const pipeline::Topology& topology, std::size_t polygon) {
    const auto corners = topology.corners(polygon);
    std::vector<std::uint32_t> rows;
    for (std::size_t i = 0; i < corners.size(); ++i) rows.push_back(corners[i]);
    std::ranges::sort(rows);
    return rows;
}

}  // namespace

bool isIn(const pipeline::Scene& scene, const Selection& selection) {
    return selection.index < countOf(scene, selection.kind);
}

Selection selectionOf(TableId table, std::size_t row) {
    using Kind = Selection::Kind;
    switch (table) {
        case TableId::Objects: return {Kind::Object, row};
        case TableId::Polygons: return {Kind::Polygon, row};
        case TableId::Vertices: return {Kind::Vertex, row};
        case TableId::Lights: return {Kind::Light, row};
    }
    return {};
}

std::optional<std::size_t> polygonAt(const pipeline::Frame& frame, glm::ivec2 pixel) {
    const pipeline::Settings& settings = frame.scene().settings;
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= settings.width || pixel.y >= settings.height) return {};
    const auto ids = frame.buffer({pipeline::BufferId::PolygonId});
    if (!ids) return {};
    const double id = ids->value(std::size_t(pixel.x), std::size_t(pixel.y));
    if (id < 0) return {};
    return std::size_t(id);
}

std::vector<std::uint32_t> rowsOf(const pipeline::Frame& frame, TableId table,
                                  const std::optional<Selection>& selection, std::optional<glm::ivec2> pixel) {
    using Kind = Selection::Kind;
    std::optional<Selection> shown = selection;
    if (!shown && pixel)
        if (const auto polygon = polygonAt(frame, *pixel)) shown = Selection{Kind::Polygon, *polygon};
    if (!shown || !isIn(frame.scene(), *shown)) return {};
    const pipeline::Topology& topology = frame.topology();
    const auto index = std::uint32_t(shown->index);
    if (selectionOf(table, shown->index).kind == shown->kind) return {index};
    if (shown->kind == Kind::Polygon && table == TableId::Objects) return {topology.objectOfPolygon(index)};
    if (shown->kind == Kind::Polygon && table == TableId::Vertices) return cornersOf(topology, index);
    if (shown->kind == Kind::Vertex && table == TableId::Objects)
        return {std::uint32_t(topology.objectOfVertex(index))};
    return {};
}

}  // namespace lessons
