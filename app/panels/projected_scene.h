#pragma once
#include <QPolygonF>
#include <functional>
#include <memory>
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

// Outlines that are made when they are first looked at: few pictures of many polygons are ever seen so closely.
class Outlines {
public:
    using Make = std::function<std::vector<QPolygonF>()>;
    Outlines() = default;  // none
    explicit Outlines(Make make);
    const std::vector<QPolygonF>& get() const;
    bool areMade() const;

private:
    struct Made;
    std::shared_ptr<Made> m_made;
};

// Those of the polygons that go on.
Outlines outlinesOf(const pipeline::Frame& frame);
// A rectangle around all of these polygons, or around those that go on.
QRectF boundsOf(const pipeline::Frame& frame, bool all);
// The part of the picture within a rectangle, with some air; empty where that is outside.
QRectF focusOn(QRectF around, QSize picture);

// Where the selected thing stands in the picture: a polygon's outline, a rectangle around an
// object's polygons that go on, a vertex as a single point; nothing for what is behind the eye.
std::vector<QPolygonF> outlinesOf(const pipeline::Frame& frame, const Selection& selection);

// The one whose outline is drawn over the others at a point (pixels), or -1.
int nearestPolygonAt(const std::vector<ProjectedPolygon>& polygons, QPointF at);

}  // namespace app
