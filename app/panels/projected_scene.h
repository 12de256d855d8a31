#pragma once
#include <QPolygonF>
#include <vector>

#include "app/core/selection.h"
#include "pipeline/run/frame.h"

namespace app {

// A polygon in the picture, its corners in pixels (y down).
struct ProjectedPolygon {
    int polygon = 0;            // over all objects
    std::vector<int> vertices;  // over all objects
    QPolygonF corners;
    QPointF centre;       // mean of the corners
    double distance = 0;  // z_view, mean of the corners
    bool goesOn = true;   // to the z-buffer, by the verdict
};

// The scene's polygons where all their corners stand in front of the eye; in scene order.
std::vector<ProjectedPolygon> projectPolygons(const pipeline::Frame& frame);

// The outlines of all, or of those that go on.
std::vector<QPolygonF> outlinesOf(const pipeline::Frame& frame, bool all);
// The smallest rectangle of the picture around outlines, with some air; empty where they are outside.
QRectF focusOn(const std::vector<QPolygonF>& outlines, QSize picture);

// Where the selected thing stands in the picture: a polygon's outline, a rectangle around an
// object's polygons that go on, a vertex as a single point; nothing for what is behind the eye.
std::vector<QPolygonF> outlinesOf(const pipeline::Frame& frame, const Selection& selection);

// The one whose outline is drawn over the others at a point (pixels), or -1.
int nearestPolygonAt(const std::vector<ProjectedPolygon>& polygons, QPointF at);

}  // namespace app
