#include "app/panels/projected_scene.h"

#include <algorithm>

#include "pipeline/stages/cull.h"

namespace app {

using pipeline::BufferId;

std::vector<ProjectedPolygon> projectPolygons(const pipeline::Frame& frame) {
    const auto screen = frame.buffer({BufferId::VerticesScreen}), view = frame.buffer({BufferId::VerticesView});
    if (!screen || !view) return {};
    const auto verdicts = frame.buffer({BufferId::PolygonsVerdict});
    const bool perspective = frame.scene().camera.projection == pipeline::ProjectionKind::Perspective ||
                             frame.scene().camera.kind == pipeline::CameraKind::Spherical;
    std::vector<ProjectedPolygon> polygons;
    int firstVertex = 0, number = 0;
    for (const pipeline::Object& object : frame.scene().objects) {
        for (std::size_t p = 0; p < object.mesh->polygonCount(); ++p, ++number) {
            ProjectedPolygon polygon;
            polygon.polygon = number;
            bool inFront = true;
            for (const std::uint32_t corner : object.mesh->polygon(p)) {
                const auto v = std::size_t(firstVertex) + corner;
                polygon.vertices.push_back(int(v));
                const QPointF at(screen->value(0, v, 0), screen->value(0, v, 1));
                polygon.corners << at;
                polygon.centre += at;
                polygon.distance += view->value(0, v, 2);
                inFront = inFront && (!perspective || view->value(0, v, 2) > 0);
            }
            const double n = double(polygon.corners.size());
            polygon.centre /= n;
            polygon.distance /= n;
            if (verdicts && std::size_t(number) < verdicts->count())
                polygon.goesOn = goesOn(pipeline::Verdict(int(verdicts->flat(std::size_t(number)))));
            if (inFront) polygons.push_back(std::move(polygon));
        }
        firstVertex += int(object.mesh->positions.size());
    }
    return polygons;
}

QRectF focusOn(const std::vector<QPolygonF>& outlines, QSize picture) {
    QRectF focus;
    for (const QPolygonF& outline : outlines) focus |= outline.boundingRect();
    focus &= QRectF(QPointF(0, 0), QSizeF(picture));
    const double air = 0.06 * std::max(focus.width(), focus.height());
    return focus.isEmpty() ? QRectF() : focus.adjusted(-air, -air, air, air);
}

std::vector<QPolygonF> outlinesOf(const std::vector<ProjectedPolygon>& polygons, bool all) {
    std::vector<QPolygonF> outlines;
    for (const ProjectedPolygon& polygon : polygons)
        if (all || polygon.goesOn) outlines.push_back(polygon.corners);
    return outlines;
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
