#include "app/panels/canvas_flip.h"

namespace app {

namespace {

void turn(QPolygonF& polygon, int height) {
    for (QPointF& p : polygon) p = upsideDown(p, height);
}

void turn(ShapePicture& picture, int height) {
    for (Shape& shape : picture.shapes) {
        turn(shape.outline.corners, height);
        shape.outline.centre = upsideDown(shape.outline.centre, height);
    }
    for (ShapePoint& point : picture.points) point.at = upsideDown(point.at, height);
}

}  // namespace

CanvasContent upsideDown(const CanvasContent& content) {
    CanvasContent result = content;
    const int height = content.size.height();
    if (!content.focus.isEmpty()) result.focus.moveTop(height - content.focus.bottom());
    result.image = content.image.mirrored();
    if (result.shapes) turn(*result.shapes, height);
    if (result.verdicts) turn(*result.verdicts, height);
    result.edges = Outlines([edges = content.edges, height] {
        std::vector<QPolygonF> turned = edges.get();
        for (QPolygonF& edge : turned) turn(edge, height);
        return turned;
    });
    for (QPolygonF& outline : result.marked) turn(outline, height);
    for (QImage& overlay : result.overlays) overlay = overlay.mirrored();
    result.edgeView.reset();
    if (content.strange) result.strange = [=, s = content.strange](int x, int y) { return s(x, height - 1 - y); };
    if (content.text) result.text = [=, t = content.text](int x, int y) { return t(x, height - 1 - y); };
    for (std::optional<QPoint>* pixel : {&result.picked, &result.hovered})
        if (*pixel) *pixel = upsideDown(**pixel, height);
    for (auto& [number, pixel] : result.pinned) pixel = upsideDown(pixel, height);
    if (result.region) {
        const QRect& r = *content.region;
        result.region = QRect(QPoint(r.left(), height - 1 - r.bottom()), r.size());
    }
    return result;
}

}  // namespace app
