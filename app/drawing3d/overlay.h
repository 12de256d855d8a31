#pragma once
#include <QPainter>
#include <QRectF>
#include <vector>

#include "app/drawing3d/label_places.h"
#include "app/drawing3d/view_options.h"
#include "app/drawing3d/view_space.h"

namespace app {

// Letters, captions and the picked point's marker, over the rendered view.
void paintOverlay(QPainter& painter, const Drawing& drawing, const ViewFrame& view,
                  const std::vector<PlacedLabel>& labels);

// A light ring around a point of the world.
void paintProbe(QPainter& painter, Vec3d point, const ViewFrame& view);

// A vector's line with its dash and tip, and its letter: one entry of the legend, as long as it is wide.
void paintVectorSample(QPainter& painter, const QRectF& box, VectorCode code, bool shown);
// The legend of all five: what it takes, in one row or, where that is wider than `room`, in two; in that space, the place
// of an entry.
QSizeF legendSize(double room, int count = 5);
QRectF legendEntry(VectorCode code, const QRectF& legend);
// In the lower left corner of a picture.
QRectF legendAt(glm::dvec2 size);
// only: these vectors alone, in a legend of the size for so many.
void paintLegend(QPainter& painter, const QRectF& legend, const ViewOptions& options,
                 const std::optional<std::vector<VectorCode>>& only = {});

// The cube that turns with the camera. Its visible faces, and which of them a point is on.
enum class CubeFace { None, X, Y, Z, MinusX, MinusY, MinusZ, Middle };
// The letter of a face is the axis of the space that points out of it.
QString letterOf(CubeFace face, ViewSpace space);
void paintCube(QPainter& painter, const QRectF& box, const OrbitCamera& camera, ViewSpace space = ViewSpace::World);
CubeFace cubeFaceAt(const QRectF& box, const OrbitCamera& camera, QPointF point);

}  // namespace app
