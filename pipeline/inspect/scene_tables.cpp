#include "pipeline/inspect/scene_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "pipeline/inspect/table_columns.h"
#include "pipeline/plan/needs.h"
#include "pipeline/scene/mesh/topology.h"
#include "pipeline/stages/cull.h"

namespace pipeline {
namespace {

using namespace table_columns;

constexpr std::array<std::string_view, kTableCount> kTableNames{"objects", "polygons", "vertices", "lights"};

// "3 to 7": the rows of another table that belong to a row.
std::string rangeText(std::size_t first, std::size_t end) {
    if (first == end) return "none";
    return end - first == 1 ? fmt::format("{}", first) : fmt::format("{} to {}", first, end - 1);
}

bool whiteHighlights(const Scene& scene) {
    return std::ranges::all_of(scene.objects, [](const Object& object) {
        const Vec3d& s = object.material.specular;
        return s.x == s.y && s.y == s.z;
    });
}

void addObjects(const FramePtr& frame, SceneTable& table) {
    const Scene& scene = frame->scene();
    table.rows = scene.objects.size();
    table.meaning = "Array of objects: Object[i].";
    table.facts.push_back({"num_objs", "objects", "", std::int64_t(table.rows)});
    auto& columns = table.columns;
    columns.push_back(rowNumber("i", "object", "The object, counted from 0."));
    columns.push_back({"", "name", "", "As the scene names it.", -1, {}, [frame](std::size_t i) -> Cell {
                           return frame->scene().objects[i].name;
                       }});
    columns.push_back(count("num_pts", "vertex count", "Number of vertices in the object.",
                            [frame](std::size_t i) { return frame->scene().objects[i].mesh->positions.size(); }));
    columns.push_back({"w_pts",
                       "vertex rows",
                       "",
                       "Its vertices, as rows of the table of vertices.",
                       -1,
                       {},
                       [frame](std::size_t i) -> Cell {
                           const auto& first = frame->topology().firstVertex;
                           return rangeText(first[i], first[i + 1]);
                       }});
    columns.push_back(count("num_polys", "polygon count", "Number of polygons.",
                            [frame](std::size_t i) { return frame->scene().objects[i].mesh->polygonCount(); }));
    columns.push_back({"polys",
                       "polygon rows",
                       "",
                       "Its polygons, as rows of the table of polygons.",
                       -1,
                       {},
                       [frame](std::size_t i) -> Cell {
                           const auto& first = frame->topology().firstPolygon;
                           return rangeText(first[i], first[i + 1]);
                       }});
    const bool white = whiteHighlights(scene);
    addSettings(frame, SettingGroup::Material, columns, [white](std::string_view key) {
        const bool colored = key == "material.#.ksr" || key == "material.#.ksg" || key == "material.#.ksb";
        return white ? !colored : key != "material.#.ks";
    });
    const bool anyTurned = std::ranges::any_of(frame->scene().objects,
                                               [](const Object& object) { return object.transform.up != UpAxis::Z; });
    addSettings(frame, SettingGroup::Object, columns,
                [anyTurned](std::string_view key) { return key != "object.#.up" || anyTurned; });
    columns.push_back({"", "file", "", "The object description file, or built in.", -1, {}, [frame](std::size_t i) {
                           const std::string& file = frame->scene().objects[i].mesh->file;
                           return Cell(file.empty() ? std::string("built in") : file);
                       }});
}

void addPolygons(const FramePtr& frame, SceneTable& table) {
    table.rows = frame->topology().polygonCount();
    table.meaning = "Array of polygons: polys[j] of Object[i].";
    table.facts.push_back({"", "polygons", "", std::int64_t(table.rows)});
    auto& columns = table.columns;
    columns.push_back(rowNumber("", "polygon", "The polygon, counted over all objects as in the buffers."));
    columns.push_back(count("i", "object", "The object that it belongs to.",
                            [frame](std::size_t p) { return frame->topology().objectOfPolygon(p); }));
    columns.push_back(count("j", "polygon of the object", "The polygon, counted within its object.",
                            [frame](std::size_t p) { return frame->placeOf(int(p)).polygon; }));
    columns.push_back(count("num_verts", "corner count", "Number of vertices in the polygon.",
                            [frame](std::size_t p) { return frame->topology().corners(p).size(); }));
    columns.push_back({"inds",
                       "corners",
                       "",
                       "Its vertices, counted within its object, counter-clockwise from outside.",
                       -1,
                       {},
                       [frame](std::size_t p) -> Cell {
                           return fmt::format("{}", fmt::join(frame->topology().corners(p).local, ", "));
                       }});
    columns.push_back({"visibility", "polygons.verdict", "", "What back-face culling and clipping say of it.", -1,
                       frame->whyAbsent({BufferId::PolygonsVerdict}), [frame](std::size_t p) -> Cell {
                           return readStages(*frame, [&](const auto& data) {
                               return data.cull ? Cell(std::string(pipeline::name(data.cull->verdicts[p]))) : Cell();
                           });
                       }});
    columns.push_back({"", "signed area", "pixels²", "On the screen; positive where its front is seen.", 2,
                       frame->whyAbsent({BufferId::PolygonsVerdict}), [frame](std::size_t p) -> Cell {
                           return readStages(*frame, [&](const auto& data) {
                               const auto area = data.cull ? signedArea(*data.transform, *data.cull, p) : std::nullopt;
                               return area ? Cell(*area) : Cell();
                           });
                       }});
    addBuffer(frame, BufferId::PolygonsNormal, {"n[0]", "n[1]", "n[2]"}, {" x", " y", " z"}, kUnitDecimals, table);
    addBuffer(frame, BufferId::PolygonsIntensity, {"lred", "lgreen", "lblue"}, {" red", " green", " blue"},
              intensityDecimals(*frame), table);
}

void addVertices(const FramePtr& frame, SceneTable& table) {
    table.rows = frame->topology().vertexCount();
    table.meaning = "Arrays of vertices: w_pts, v_pts and s_pts of Object[i].";
    table.facts = viewingFacts(frame->scene());
    auto& columns = table.columns;
    columns.push_back(rowNumber("", "vertex", "The vertex, counted over all objects as in the buffers."));
    columns.push_back(count("i", "object", "The object that it belongs to.",
                            [frame](std::size_t v) { return frame->topology().objectOfVertex(v); }));
    columns.push_back(
        count("", "in object", "The vertex, counted within its object: what inds counts.", [frame](std::size_t v) {
            const Topology& topology = frame->topology();
            return v - topology.firstVertex[topology.objectOfVertex(v)];
        }));
    const int decimals = lengthDecimals(*frame);
    addBuffer(frame, BufferId::VerticesWorld, {"xw", "yw", "zw"}, {" x", " y", " z"}, decimals, table);
    addBuffer(frame, BufferId::VerticesView, {"xv", "yv", "zv"}, {" x", " y", " z"}, decimals, table);
    addBuffer(frame, BufferId::VerticesScreen, {"xs", "ys", ""}, {" x", " y", " depth"}, 3, table);
    columns.back().decimals = depthDecimals(*frame);
    columns.back().unit = frame->scene().settings.depthFormat == DepthFormat::Linear ? "world units" : "";
    columns.back().meaning = "The depth that the z-buffer compares.";
    addBuffer(frame, BufferId::VerticesNormal, {"N x", "N y", "N z"}, {" x", " y", " z"}, kUnitDecimals, table);
    addBuffer(frame, BufferId::VerticesIntensity, {"I(r)", "I(g)", "I(b)"}, {" red", " green", " blue"},
              intensityDecimals(*frame), table);
}

void addLights(const FramePtr& frame, SceneTable& table) {
    const Scene& scene = frame->scene();
    table.rows = scene.lights.size();
    table.meaning = "Lighting parameters: light k.";
    table.facts = {{"num_lights", "lights", "", std::int64_t(table.rows)},
                   {"la", "ambient.intensity", "", scene.ambient.intensityIn(scene.settings.model)}};
    if (scene.ambient.color != Vec3d(1.0))
        for (const auto& [key, axis] : {std::pair("ambient.red", 0), {"ambient.green", 1}, {"ambient.blue", 2}})
            table.facts.push_back({"", key, "", scene.ambient.color[axis]});
    if (const auto iMax = largestIntensity(*frame)) table.facts.push_back({"Imax", "I_max", "", *iMax});
    auto& columns = table.columns;
    columns.push_back(rowNumber("k", "light", "The light, counted from 0."));
    addSettings(frame, SettingGroup::Light, columns, [](std::string_view) { return true; });
    // The unit vector of "Computing N and L"; a light at a point has another one for every surface point.
    for (int axis = 0; axis < 3; ++axis)
        columns.push_back({fmt::format("L {}", "xyz"[axis]),
                           fmt::format("direction {}", "xyz"[axis]),
                           "",
                           "Unit vector towards a light at infinity; a light at a point has none for the whole scene.",
                           kUnitDecimals,
                           {},
                           [frame, axis](std::size_t k) -> Cell {
                               const Light& light = frame->scene().lights[k];
                               const double length = glm::length(light.position);
                               if (light.kind != LightKind::AtInfinity || !(length > 0)) return {};
                               return light.position[axis] / length;
                           }});
}

}  // namespace

std::string TableColumn::heading() const {
    if (!lecture.empty()) return lecture;
    if (name.find('.') == name.npos) return name;
    return name.substr(name.find_last_of(". ") + 1);
}

std::string_view name(TableId id) { return kTableNames[std::size_t(id)]; }

std::optional<TableId> findTable(std::string_view name) {
    const auto found = std::ranges::find(kTableNames, name);
    if (found == kTableNames.end()) return {};
    return TableId(found - kTableNames.begin());
}

BufferSet tableBuffers(const Scene& scene, TableId id) {
    using enum BufferId;
    BufferSet all;
    if (id == TableId::Polygons) all = setOf({PolygonsVerdict, PolygonsNormal, PolygonsIntensity});
    if (id == TableId::Vertices)
        all = setOf({VerticesWorld, VerticesView, VerticesScreen, VerticesNormal, VerticesIntensity});
    return all & usefulBuffers(scene);
}

SceneTable sceneTable(const FramePtr& frame, TableId id) {
    SceneTable table;
    table.id = id;
    switch (id) {
        case TableId::Objects: addObjects(frame, table); break;
        case TableId::Polygons: addPolygons(frame, table); break;
        case TableId::Vertices: addVertices(frame, table); break;
        case TableId::Lights: addLights(frame, table); break;
    }
    return table;
}

std::vector<std::uint32_t> sortedRows(const SceneTable& table, std::size_t column, bool descending) {
    std::vector<std::uint32_t> rows(table.rows);
    std::iota(rows.begin(), rows.end(), 0u);
    const auto& cell = table.columns[column].cell;
    std::vector<Cell> keys;  // read once each: a comparison is asked for many times
    keys.reserve(table.rows);
    for (std::size_t i = 0; i < table.rows; ++i) keys.push_back(cell(i));
    const auto empty = std::stable_partition(
        rows.begin(), rows.end(), [&](std::uint32_t i) { return !std::holds_alternative<std::monostate>(keys[i]); });
    std::stable_sort(rows.begin(), empty, [&](std::uint32_t a, std::uint32_t b) {
        return descending ? keys[b] < keys[a] : keys[a] < keys[b];
    });
    return rows;
}

}  // namespace pipeline
