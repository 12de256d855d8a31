#pragma once
#include <QPainter>
#include <QRectF>
#include <vector>

#include "app/view3d/drawing.h"
#include "app/view3d/view_options.h"
#include "app/view3d/view_space.h"

namespace app {

// A label's place on the screen, logical pixels.
struct PlacedLabel {
    Label label;
    glm::dvec2 at;    // middle of the text
    glm::dvec2 mark;  // of a caption: where its mark is, or stands in for it at the border
    bool atBorder = false;
    QSizeF size;  // of the text
};

// Letters stand beyond the tips, at least 21 pixels from each other and 17 from every tip where
// there is room; captions beside their marks, or at the border: above, below or at a side of them, where they cover
// no letter, no mark and none of each other. A vector that leads out of the view has its letter where it leaves it. All
// of them inside the view, and beside what is `taken`. `scale` is the font scale.
std::vector<PlacedLabel> placeLabels(const Drawing& drawing, const ViewFrame& view,
                                     const std::vector<QRectF>& taken = {});
// The space that a label takes.
QRectF boxOf(const PlacedLabel& placed);

// Letters, captions and the picked point's marker, over the rendered view.
// `taken`: what other things stand on.
void paintOverlay(QPainter& painter, const Drawing& drawing, const ViewFrame& view,
                  const std::vector<QRectF>& taken = {});

// A light ring around a point of the world.
void paintProbe(QPainter& painter, Vec3d point, const ViewFrame& view);

// A vector's line with its dash and tip, and its letter: one entry of the legend, as long as it is wide.
void paintVectorSample(QPainter& painter, const QRectF& box, VectorCode code, bool shown);
// The legend of all five: what it takes, in one row or, where that is wider than `room`, in two; in that space, the place
// of an entry.
QSizeF legendSize(double room);
QRectF legendEntry(VectorCode code, const QRectF& legend);
// In the lower left corner of a picture.
QRectF legendAt(glm::dvec2 size);
void paintLegend(QPainter& painter, const QRectF& legend, const ViewOptions& options);

// The cube that turns with the camera. Its visible faces, and which of them a point is on.
enum class CubeFace { None, X, Y, Z, MinusX, MinusY, MinusZ, Middle };
// The letter of a face is the axis of the space that points out of it.
QString letterOf(CubeFace face, ViewSpace space);
void paintCube(QPainter& painter, const QRectF& box, const OrbitCamera& camera, ViewSpace space = ViewSpace::World);
CubeFace cubeFaceAt(const QRectF& box, const OrbitCamera& camera, QPointF point);

}  // namespace app
