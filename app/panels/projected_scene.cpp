#include "app/panels/projected_scene.h"

#include <algorithm>

#include "pipeline/scene/topology.h"
#include "pipeline/stages/cull.h"

namespace app {

using pipeline::BufferId;

namespace {

// Of every vertex: its place in the picture, and z_view.
struct ProjectedVertices {
    std::vector<QPointF> places;
    std::vector<double> distances;
    bool perspective = true;
    std::optional<pipeline::AnyBuffer> verdicts;

    bool inFront(const pipeline::Topology::Corners& corners) const {
        for (std::size_t i = 0; perspective && i < corners.size(); ++i)
            if (!(distances[corners[i]] > 0)) return false;
        return true;
    }
    bool goesOn(std::size_t polygon) const {
        return !verdicts || polygon >= verdicts->count() ||
               pipeline::goesOn(pipeline::Verdict(int(verdicts->flat(polygon))));
    }
};

// Without vertices where the frame has not placed them yet.
ProjectedVertices projectVertices(const pipeline::Frame& frame) {
    const auto screen = frame.buffer({BufferId::VerticesScreen}), view = frame.buffer({BufferId::VerticesView});
    ProjectedVertices projected;
    if (!screen || !view) return projected;
    projected.verdicts = frame.buffer({BufferId::PolygonsVerdict});
    projected.perspective = frame.scene().camera.projection == pipeline::ProjectionKind::Perspective ||
                            frame.scene().camera.kind == pipeline::CameraKind::Spherical;
    const std::size_t count = screen->rows();
    projected.places.reserve(count);
    projected.distances.reserve(count);
    std::visit(
        [&](const auto& v) {
            for (std::size_t i = 0; i < count; ++i)
                projected.places.emplace_back(double(v[3 * i]), double(v[3 * i + 1]));
        },
        screen->data);
    std::visit(
        [&](const auto& v) {
            for (std::size_t i = 0; i < count; ++i) projected.distances.push_back(double(v[3 * i + 2]));
        },
        view->data);
    return projected;
}

// visit(number, its corners, the vertices) for each polygon all of whose corners stand in front of the eye.
template <class Visit>
void forEachInFront(const pipeline::Frame& frame, Visit visit) {
    const ProjectedVertices vertices = projectVertices(frame);
    if (vertices.places.empty()) return;
    const pipeline::Topology& topology = frame.topology();
    for (std::size_t p = 0; p < topology.polygonCount(); ++p)
        if (const auto corners = topology.corners(p); vertices.inFront(corners)) visit(p, corners, vertices);
}

}  // namespace

std::vector<ProjectedPolygon> projectPolygons(const pipeline::Frame& frame) {
    std::vector<ProjectedPolygon> polygons;
    forEachInFront(frame, [&](std::size_t p, const auto& corners, const ProjectedVertices& vertices) {
        ProjectedPolygon& polygon = polygons.emplace_back();
        polygon.polygon = int(p);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const std::uint32_t v = corners[i];
            polygon.vertices.push_back(int(v));
            polygon.corners << vertices.places[v];
            polygon.centre += vertices.places[v];
            polygon.distance += vertices.distances[v];
        }
        polygon.centre /= double(corners.size());
        polygon.distance /= double(corners.size());
        polygon.goesOn = vertices.goesOn(p);
    });
    return polygons;
}

std::vector<QPolygonF> outlinesOf(const pipeline::Frame& frame, bool all) {
    std::vector<QPolygonF> outlines;
    forEachInFront(frame, [&](std::size_t p, const auto& corners, const ProjectedVertices& vertices) {
        if (!all && !vertices.goesOn(p)) return;
        QPolygonF& outline = outlines.emplace_back();
        outline.reserve(int(corners.size()));
        for (std::size_t i = 0; i < corners.size(); ++i) outline << vertices.places[corners[i]];
    });
    return outlines;
}

QRectF focusOn(const std::vector<QPolygonF>& outlines, QSize picture) {
    QRectF focus;
    for (const QPolygonF& outline : outlines) focus |= outline.boundingRect();
    focus &= QRectF(QPointF(0, 0), QSizeF(picture));
    const double air = 0.06 * std::max(focus.width(), focus.height());
    return focus.isEmpty() ? QRectF() : focus.adjusted(-air, -air, air, air);
}

std::vector<QPolygonF> outlinesOf(const pipeline::Frame& frame, const Selection& selection) {
    if (selection.kind == Selection::Kind::Light || !isIn(frame.scene(), selection)) return {};
    QRectF around;
    for (const ProjectedPolygon& polygon : projectPolygons(frame)) {
        const auto number = std::size_t(polygon.polygon);
        if (selection.kind == Selection::Kind::Polygon && number == selection.index) return {polygon.corners};
        if (selection.kind == Selection::Kind::Object && polygon.goesOn &&
            frame.placeOf(polygon.polygon).object == selection.index)
            around |= polygon.corners.boundingRect();
        if (selection.kind == Selection::Kind::Vertex)
            if (const auto v = std::ranges::find(polygon.vertices, int(selection.index)); v != polygon.vertices.end())
                return {QPolygonF{polygon.corners[v - polygon.vertices.begin()]}};
    }
    if (around.isEmpty()) return {};
    return {QPolygonF{around.topLeft(), around.topRight(), around.bottomRight(), around.bottomLeft()}};
}

int nearestPolygonAt(const std::vector<ProjectedPolygon>& polygons, QPointF at) {
    const ProjectedPolygon* nearest = nullptr;
    for (const ProjectedPolygon& polygon : polygons)
        if (polygon.corners.containsPoint(at, Qt::OddEvenFill) &&
            (!nearest || std::pair(!polygon.goesOn, polygon.distance) < std::pair(!nearest->goesOn, nearest->distance)))
            nearest = &polygon;
    return nearest ? nearest->polygon : -1;
}

}  // namespace app
