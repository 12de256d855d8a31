#include "app/panels/projected_scene.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

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

// What the places are read from; it lives on without the frame.
struct Source {
    std::shared_ptr<const pipeline::Topology> topology;
    std::optional<pipeline::AnyBuffer> screen, view, verdicts;
    bool perspective = true;
};

Source sourceOf(const pipeline::Frame& frame) {
    const pipeline::Camera& camera = frame.scene().camera;
    return {
        frame.sharedTopology(), frame.buffer({BufferId::VerticesScreen}), frame.buffer({BufferId::VerticesView}),
        frame.buffer({BufferId::PolygonsVerdict}),
        camera.projection == pipeline::ProjectionKind::Perspective || camera.kind == pipeline::CameraKind::Spherical};
}

// Without vertices where the frame has not placed them yet.
ProjectedVertices projectVertices(const Source& source) {
    ProjectedVertices projected;
    if (!source.screen || !source.view) return projected;
    projected.verdicts = source.verdicts;
    projected.perspective = source.perspective;
    const std::size_t count = source.screen->rows();
    projected.places.reserve(count);
    projected.distances.reserve(count);
    std::visit(
        [&](const auto& v) {
            for (std::size_t i = 0; i < count; ++i)
                projected.places.emplace_back(double(v[3 * i]), double(v[3 * i + 1]));
        },
        source.screen->data);
    std::visit(
        [&](const auto& v) {
            for (std::size_t i = 0; i < count; ++i) projected.distances.push_back(double(v[3 * i + 2]));
        },
        source.view->data);
    return projected;
}

// visit(number, its corners, the vertices) for each polygon all of whose corners stand in front of the eye.
template <class Visit>
void forEachInFront(const Source& source, Visit visit) {
    const ProjectedVertices vertices = projectVertices(source);
    if (vertices.places.empty()) return;
    for (std::size_t p = 0; p < source.topology->polygonCount(); ++p)
        if (const auto corners = source.topology->corners(p); vertices.inFront(corners)) visit(p, corners, vertices);
}

}  // namespace

std::vector<ProjectedPolygon> projectPolygons(const pipeline::Frame& frame) {
    std::vector<ProjectedPolygon> polygons;
    forEachInFront(sourceOf(frame), [&](std::size_t p, const auto& corners, const ProjectedVertices& vertices) {
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

struct Outlines::Made {
    Make make;
    std::once_flag once;
    std::vector<QPolygonF> outlines;
    std::atomic<bool> isThere = false;
};

Outlines::Outlines(Make make) : m_made(std::make_shared<Made>()) { m_made->make = std::move(make); }

bool Outlines::areMade() const { return m_made && m_made->isThere; }

const std::vector<QPolygonF>& Outlines::get() const {
    static const std::vector<QPolygonF> kNone;
    if (!m_made) return kNone;
    std::call_once(m_made->once, [this] {
        m_made->outlines = m_made->make();
        m_made->make = {};  // and what it holds
        m_made->isThere = true;
    });
    return m_made->outlines;
}

Outlines outlinesOf(const pipeline::Frame& frame) {
    return Outlines([source = sourceOf(frame)] {
        std::vector<QPolygonF> outlines;
        forEachInFront(source, [&](std::size_t p, const auto& corners, const ProjectedVertices& vertices) {
            if (!vertices.goesOn(p)) return;
            QPolygonF& outline = outlines.emplace_back();
            outline.reserve(int(corners.size()));
            for (std::size_t i = 0; i < corners.size(); ++i) outline << vertices.places[corners[i]];
        });
        return outlines;
    });
}

QRectF boundsOf(const pipeline::Frame& frame, bool all) {
    double left = INFINITY, top = INFINITY, right = -INFINITY, bottom = -INFINITY;
    forEachInFront(sourceOf(frame), [&](std::size_t p, const auto& corners, const ProjectedVertices& vertices) {
        if (!all && !vertices.goesOn(p)) return;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const QPointF at = vertices.places[corners[i]];
            left = std::min(left, at.x()), right = std::max(right, at.x());
            top = std::min(top, at.y()), bottom = std::max(bottom, at.y());
        }
    });
    return left <= right ? QRectF(QPointF(left, top), QPointF(right, bottom)) : QRectF();
}

QRectF focusOn(QRectF around, QSize picture) {
    const QRectF focus = around & QRectF(QPointF(0, 0), QSizeF(picture));
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
