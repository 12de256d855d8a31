#include "app/canvas/projected_scene.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "pipeline/run/frame_data.h"
#include "pipeline/stages/cull.h"

namespace app {

using pipeline::BufferId;

namespace {

// Of every vertex: its place in the picture, and z_view.
struct ProjectedVertices {
    std::vector<QPointF> places;
    std::vector<double> distances;
    std::vector<bool> isPlaced;  // false: nearer than the near plane, without a position, or not transformed yet
    std::optional<pipeline::AnyBuffer> verdicts;

    bool arePlaced(const pipeline::Topology::Corners& corners) const {
        for (std::size_t i = 0; i < corners.size(); ++i)
            if (!isPlaced[corners[i]]) return false;
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
    double nearest;  // z_view
};

Source sourceOf(const pipeline::Frame& frame) {
    const auto nearest = [](const auto& data) {
        const bool cuts = data.transform && data.transform->view.perspective;
        return cuts ? data.transform->view.near : -INFINITY;
    };
    return {frame.sharedTopology(), frame.buffer({BufferId::VerticesScreen}), frame.buffer({BufferId::VerticesView}),
            frame.buffer({BufferId::PolygonsVerdict}), pipeline::readStages(frame, nearest)};
}

// Without vertices where the frame has not placed them yet.
ProjectedVertices projectVertices(const Source& source) {
    ProjectedVertices projected;
    if (!source.screen || !source.view) return projected;
    projected.verdicts = source.verdicts;
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
    // What lies between the eye and the near plane is cut off, and may be as far off the picture as numbers reach.
    projected.isPlaced = pipeline::rowsWithValue(*source.screen);
    for (std::size_t i = 0; i < count; ++i)
        if (projected.distances[i] < source.nearest) projected.isPlaced[i] = false;
    return projected;
}

// visit(number, its corners) for each polygon all of whose corners have a place.
template <class Visit>
void forEachPlaced(const pipeline::Topology& topology, const ProjectedVertices& vertices, Visit visit) {
    if (vertices.places.empty()) return;
    for (std::size_t p = 0; p < topology.polygonCount(); ++p)
        if (const auto corners = topology.corners(p); vertices.arePlaced(corners)) visit(p, corners);
}

// A polygon and the box around it, which may be a line or a point.
struct Boxed {
    std::size_t polygon;
    double left = INFINITY, top = INFINITY, right = -INFINITY, bottom = -INFINITY;
    void add(const pipeline::Topology::Corners& corners, const ProjectedVertices& vertices) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const QPointF& at = vertices.places[corners[i]];
            left = std::min(left, at.x()), right = std::max(right, at.x());
            top = std::min(top, at.y()), bottom = std::max(bottom, at.y());
        }
    }
    bool reaches(const QRectF& part) const {
        return right >= part.left() && left <= part.right() && bottom >= part.top() && top <= part.bottom();
    }
};
QPolygonF outlineOf(const pipeline::Topology::Corners& corners, const ProjectedVertices& vertices) {
    QPolygonF outline;
    outline.reserve(int(corners.size()));
    for (std::size_t i = 0; i < corners.size(); ++i) outline << vertices.places[corners[i]];
    return outline;
}

}  // namespace

ProjectedPolygons projectPolygons(const pipeline::Frame& frame, const std::stop_token& stop) {
    ProjectedVertices vertices = projectVertices(sourceOf(frame));
    ProjectedPolygons projected;
    projected.topology = frame.sharedTopology();
    projected.polygons.reserve(frame.topology().polygonCount());
    forEachPlaced(frame.topology(), vertices, [&](std::size_t p, const auto& corners) {
        if (stop.stop_requested()) return;
        double distance = 0;
        for (std::size_t i = 0; i < corners.size(); ++i) distance += vertices.distances[corners[i]];
        projected.polygons.push_back({std::uint32_t(p), vertices.goesOn(p), distance / double(corners.size())});
    });
    for (std::size_t v = 0; v < vertices.places.size(); ++v)
        if (vertices.isPlaced[v]) projected.vertices.push_back(std::uint32_t(v));
    projected.places = std::move(vertices.places);
    projected.distances = std::move(vertices.distances);
    return projected;
}

OutlinesIn outlinesIn(const pipeline::Frame& frame) {
    struct Places {
        Source source;
        std::once_flag once;
        ProjectedVertices vertices;
        std::vector<Boxed> polygons;
    };
    const auto places = std::make_shared<Places>();
    places->source = sourceOf(frame);
    return [places](const QRectF& part) {
        const pipeline::Topology& topology = *places->source.topology;
        const ProjectedVertices& vertices = places->vertices;
        std::call_once(places->once, [&] {
            places->vertices = projectVertices(places->source);
            forEachPlaced(topology, vertices, [&](std::size_t p, const auto& corners) {
                if (vertices.goesOn(p)) places->polygons.emplace_back(p).add(corners, vertices);
            });
        });
        std::vector<QPolygonF> outlines;
        for (const Boxed& polygon : places->polygons)
            if (polygon.reaches(part)) outlines.push_back(outlineOf(topology.corners(polygon.polygon), vertices));
        return outlines;
    };
}

QRectF boundsOf(const pipeline::Frame& frame, bool all) {
    Boxed around{0};
    const ProjectedVertices vertices = projectVertices(sourceOf(frame));
    forEachPlaced(frame.topology(), vertices, [&](std::size_t p, const auto& corners) {
        if (all || vertices.goesOn(p)) around.add(corners, vertices);
    });
    return around.left <= around.right ? QRectF(QPointF(around.left, around.top), QPointF(around.right, around.bottom))
                                       : QRectF();
}

QRectF focusOn(QRectF around, QSize picture) {
    const QRectF focus = around & QRectF(QPointF(0, 0), QSizeF(picture));
    const double air = 0.06 * std::max(focus.width(), focus.height());
    return focus.isEmpty() ? QRectF() : focus.adjusted(-air, -air, air, air);
}

std::vector<QPolygonF> outlinesOf(const pipeline::Frame& frame, const lessons::Selection& selection) {
    using Kind = lessons::Selection::Kind;
    if (selection.kind == Kind::Light || !isIn(frame.scene(), selection)) return {};
    const ProjectedVertices vertices = projectVertices(sourceOf(frame));
    const pipeline::Topology& topology = frame.topology();
    if (vertices.places.empty()) return {};
    if (selection.kind == Kind::Polygon) {
        const auto corners = topology.corners(selection.index);
        return vertices.arePlaced(corners) ? std::vector{outlineOf(corners, vertices)} : std::vector<QPolygonF>();
    }
    if (selection.kind == Kind::Vertex)
        return vertices.isPlaced[selection.index] ? std::vector{QPolygonF{vertices.places[selection.index]}}
                                                  : std::vector<QPolygonF>();
    Boxed around{0};
    forEachPlaced(topology, vertices, [&](std::size_t p, const auto& corners) {
        if (topology.objectOfPolygon(p) == selection.index && vertices.goesOn(p)) around.add(corners, vertices);
    });
    if (!(around.left < around.right && around.top < around.bottom)) return {};
    return {QPolygonF{{around.left, around.top},
                      {around.right, around.top},
                      {around.right, around.bottom},
                      {around.left, around.bottom}}};
}

}  // namespace app
