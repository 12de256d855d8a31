#pragma once
#include <QImage>
#include <QPainter>
#include <QPolygonF>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "app/canvas/shape_picture.h"
#include "pipeline/inspect/edge_view.h"

namespace app {

// What a canvas shows, ready to paint. Positions are in picture pixels.
struct CanvasContent {
    QSize size;                     // of the picture; empty: nothing to show
    QRectF focus;                   // what is worth looking at, for fitting; empty: all of it
    bool isOfManyPolygons = false;  // they take their time
    QColor ground;                  // around the picture; invalid: the theme's
    bool hasGround = true;          // behind and around the picture; else nothing is painted there
    QImage image;                   // null where shapes are shown
    std::shared_ptr<const ShapePicture> shapes;
    OutlinesIn edges;                              // over the image; may be empty
    std::vector<QImage> overlays;                  // of the same size, over the image
    std::shared_ptr<const ShapePicture> verdicts;  // the same of polygons, half transparent
    std::optional<pipeline::EdgeView> edgeView;
    std::function<QString(int, int)> strange;   // a mark on a number that should not be there; may be empty
    std::function<QStringList(int, int)> text;  // lines written into a pixel that is large enough
    std::optional<QPoint> picked, hovered;
    std::vector<std::pair<int, QPoint>> pinned;  // number and pixel
    std::optional<QRect> region;                 // whose statistics are on show
    std::vector<QPolygonF> marked;               // outlines of what is selected; a single corner is a vertex
};

// Where the picture stands: its corner in the widget, and device-independent pixels per picture pixel.
struct Placement {
    QPointF origin;
    double zoom = 1;
    QPointF toPicture(QPointF widget) const { return (widget - origin) / zoom; }
    QPointF toWidget(QPointF picture) const { return origin + picture * zoom; }
    QPolygonF toWidget(QPolygonF picture) const {
        for (QPointF& p : picture) p = toWidget(p);
        return picture;
    }
    bool operator==(const Placement&) const = default;
};

inline constexpr double kGridZoom = 10, kEdgeZoom = 12, kTextZoom = 56;

// `visible` is the part of the widget to fill. Without the marks of the pointer, which move by
// themselves. What is not there when it is stopped is left out.
void paintCanvas(QPainter& painter, const CanvasContent& content, const Placement& placement, QRect visible,
                 bool showEdges, const std::stop_token& stop = {});
// The picked, the hovered and the pinned pixels, the region.
void paintMarks(QPainter& painter, const CanvasContent& content, const Placement& placement, QRect visible);
// "0, 0" at the lower left corner, for a picture that is turned over.
void paintOrigin(QPainter& painter, const Placement& placement, QSize size);
// The checker that stands for "nothing drawn".
void paintChecker(QPainter& painter, QRect rect);

}  // namespace app
