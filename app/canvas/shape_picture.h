#pragma once
#include <QColor>
#include <QString>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "app/canvas/buffer_image.h"
#include "app/canvas/projected_scene.h"

namespace app {

// Buffers that stand on polygons or vertices have no pixels of their own: they are shown on the
// polygons' outlines in the picture.
struct Shape {
    ProjectedPolygon outline;
    QColor fill;      // invalid: outline only
    char letter = 0;  // of the verdict; 0: none
};
struct ShapePoint {
    QPointF at;  // pixels
    int vertex = 0;
    QColor fill;
};
struct ShapePicture {
    std::shared_ptr<const pipeline::Topology> topology;
    std::vector<QPointF> places;  // of every vertex, pixels
    std::vector<Shape> shapes;    // in the order of drawing: farthest first, culled ones before kept ones
    // Around each of them, close together: all are gone through at every move of the pointer. None in a thumbnail, which
    // is painted once.
    std::vector<QRectF> boxes;
    std::vector<ShapePoint> points;
    std::function<QString(std::size_t)> value;  // of a filled polygon or a point; written where there are few
    bool isSmall = false;                       // a thumbnail: no words, small points

    QPolygonF outline(const Shape& shape) const;
    QRectF boxOf(std::size_t shape) const;  // pixels
};

// The hatches that tell verdicts apart without colour.
Qt::BrushStyle hatchOfVerdict(char letter);

// Incomplete when it is stopped.
ShapePicture shapePicture(const pipeline::Frame& frame, const pipeline::AnyBuffer& buffer, const BufferLook& look,
                          bool isSmall = false, const std::stop_token& stop = {});

// The one whose outline is drawn over the others at a point (pixels), or -1.
int nearestPolygonAt(const ShapePicture& picture, QPointF at);

}  // namespace app
