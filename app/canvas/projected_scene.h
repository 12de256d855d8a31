#pragma once
#include <QPolygonF>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "lessons/state/selection.h"
#include "pipeline/run/frame.h"
#include "pipeline/scene/mesh/topology.h"

namespace app {

// A polygon in the picture.
struct ProjectedPolygon {
    std::uint32_t polygon = 0;  // over all objects
    bool goesOn = true;         // to the z-buffer, by the verdict
    double distance = 0;        // z_view, mean of the corners
};

// Polygons and where their corners stand. A few large pieces of memory: small ones, one for each of a million
// polygons, take long to free, and whoever else asks for memory waits meanwhile.
struct ProjectedPolygons {
    std::shared_ptr<const pipeline::Topology> topology;
    std::vector<QPointF> places;    // of every vertex, pixels (y down)
    std::vector<double> distances;  // of every vertex, z_view
    std::vector<ProjectedPolygon> polygons;
    std::vector<std::uint32_t> vertices;  // that have a place on the screen
};

// The scene's polygons where all their corners have a place on the screen; in scene order. Incomplete when it is stopped.
ProjectedPolygons projectPolygons(const pipeline::Frame& frame, const std::stop_token& stop = {});

// The outlines that reach into a part of the picture, found when it is looked at: few of many polygons are ever seen
// closely. Any thread may ask.
using OutlinesIn = std::function<std::vector<QPolygonF>(const QRectF& part)>;

// Those of the polygons that go on.
OutlinesIn outlinesIn(const pipeline::Frame& frame);
// A rectangle around all of these polygons, or around those that go on.
QRectF boundsOf(const pipeline::Frame& frame, bool all);
// The part of the picture within a rectangle, with some air; empty where that is outside.
QRectF focusOn(QRectF around, QSize picture);

// Where the selected thing stands in the picture: a polygon's outline, a rectangle around an
// object's polygons that go on, a vertex as a single point; nothing for what has no place on the screen.
std::vector<QPolygonF> outlinesOf(const pipeline::Frame& frame, const lessons::Selection& selection);

}  // namespace app
