#include "app/canvas/canvas_flip.h"

namespace app {

namespace {

void turn(QPolygonF& polygon, int height) {
    for (QPointF& p : polygon) p = upsideDown(p, height);
}

std::shared_ptr<const ShapePicture> turned(const std::shared_ptr<const ShapePicture>& picture, int height) {
    if (!picture) return nullptr;
    auto result = std::make_shared<ShapePicture>(*picture);
    for (QPointF& place : result->places) place = upsideDown(place, height);
    for (QRectF& box : result->boxes) box.moveTop(height - box.bottom());
    for (ShapePoint& point : result->points) point.at = upsideDown(point.at, height);
    return result;
}

}  // namespace

CanvasContent upsideDown(const CanvasContent& content) {
    CanvasContent result = content;
    const int height = content.size.height();
    if (!content.focus.isEmpty()) result.focus.moveTop(height - content.focus.bottom());
    result.image = content.image.mirrored();
    result.shapes = turned(content.shapes, height);
    result.verdicts = turned(content.verdicts, height);
    if (content.edges)
        result.edges = [edges = content.edges, height](QRectF part) {
            part.moveTop(height - part.bottom());
            std::vector<QPolygonF> found = edges(part);
            for (QPolygonF& edge : found) turn(edge, height);
            return found;
        };
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
