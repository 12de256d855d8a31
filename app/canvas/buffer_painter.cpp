#include "app/canvas/buffer_painter.h"

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

#include "app/canvas/edge_painter.h"
#include "app/canvas/shape_painter.h"
#include "app/look/luminance.h"
#include "app/look/theme.h"

namespace app {

namespace {

// The picture's pixels that can be seen.
QRect visiblePixels(const CanvasContent& content, const Placement& placement, QRect visible) {
    const QPointF first = placement.toPicture(visible.topLeft()),
                  last = placement.toPicture(visible.bottomRight() + QPoint(1, 1));
    const QRect pixels(QPoint(int(std::floor(first.x())), int(std::floor(first.y()))),
                       QPoint(int(std::ceil(last.x())) - 1, int(std::ceil(last.y())) - 1));
    return pixels.intersected(QRect(QPoint(0, 0), content.size));
}

void paintImage(QPainter& painter, const CanvasContent& content, const Placement& placement, const QRect& pixels) {
    // Only what is seen is scaled: at 72 times a whole picture would be larger than any screen.
    const QRectF target(placement.toWidget(pixels.topLeft()), QSizeF(pixels.size()) * placement.zoom);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, placement.zoom * painter.transform().m11() < 1);
    painter.drawImage(target, content.image, pixels);
    for (const QImage& overlay : content.overlays) painter.drawImage(target, overlay, pixels);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
}

void paintGrid(QPainter& painter, const Placement& placement, const QRect& pixels) {
    painter.setPen(QPen(QColor(0, 0, 0, 110), 1));
    const QPointF first = placement.toWidget(pixels.topLeft()),
                  last = placement.toWidget(pixels.bottomRight() + QPoint(1, 1));
    for (int x = pixels.left(); x <= pixels.right() + 1; ++x) {
        const double at = placement.toWidget(QPointF(x, 0)).x();
        painter.drawLine(QPointF(at, first.y()), QPointF(at, last.y()));
    }
    for (int y = pixels.top(); y <= pixels.bottom() + 1; ++y) {
        const double at = placement.toWidget(QPointF(0, y)).y();
        painter.drawLine(QPointF(first.x(), at), QPointF(last.x(), at));
    }
}

// Black or white, whatever is read on the ground: both where (L + 0.05)² = 1.05 · 0.05. W3C, WCAG 2.1, 2018.
Qt::GlobalColor inkOn(QRgb ground) {
    const double light = luminance(linearLight(qRed(ground)), linearLight(qGreen(ground)), linearLight(qBlue(ground)));
    return light > 0.179 ? Qt::black : Qt::white;
}

void paintTexts(QPainter& painter, const CanvasContent& content, const Placement& placement, const QRect& pixels) {
    const ThemeColors& c = Theme::current().colors();
    const int size = std::clamp(int(placement.zoom / 5), 11, 32);
    QFont font = Theme::current().mono(11);
    font.setPixelSize(size);
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    for (int y = pixels.top(); y <= pixels.bottom(); ++y)
        for (int x = pixels.left(); x <= pixels.right(); ++x) {
            const QStringList lines = content.edgeView ? edgeText(*content.edgeView, x, y) : content.text(x, y);
            QRgb ground = content.image.pixel(x, y);
            for (const QImage& overlay : content.overlays)
                if (qAlpha(overlay.pixel(x, y)) != 0) ground = overlay.pixel(x, y);
            painter.setPen(qAlpha(ground) == 0 ? c.text2 : QColor(inkOn(ground)));
            const QRectF cell(placement.toWidget(QPointF(x, y)), QSizeF(placement.zoom, placement.zoom));
            double top = cell.center().y() - double(lines.size()) * metrics.height() / 2;
            for (const QString& line : lines) {
                const double wide = metrics.horizontalAdvance(line);
                QFont fitting = font;  // a number in the digits of the user's choice may be longer
                if (wide > cell.width()) fitting.setPixelSize(std::max(5, int(size * cell.width() / wide)));
                painter.setFont(fitting);
                painter.drawText(QRectF(cell.left(), top, cell.width(), metrics.height()), Qt::AlignCenter, line);
                top += metrics.height();
            }
        }
}

void paintEdges(QPainter& painter, const CanvasContent& content, const Placement& placement, const QRect& pixels,
                const std::stop_token& stop) {
    if (!content.edges) return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (const QPolygonF& edge : content.edges(QRectF(pixels).adjusted(-2, -2, 2, 2))) {
        if (stop.stop_requested()) break;
        const QPolygonF polygon = placement.toWidget(edge);
        painter.setPen(QPen(QColor(0, 0, 0, 170), 2.6));
        painter.drawPolygon(polygon);
        painter.setPen(QPen(QColor(255, 255, 255, 220), 1.1));
        painter.drawPolygon(polygon);
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
}

void paintCentres(QPainter& painter, const Placement& placement, const QRect& pixels) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 120));
    for (int y = pixels.top(); y <= pixels.bottom(); ++y)
        for (int x = pixels.left(); x <= pixels.right(); ++x)
            painter.drawEllipse(placement.toWidget(QPointF(x + 0.5, y + 0.5)), 1.2, 1.2);
}

void paintStrange(QPainter& painter, const CanvasContent& content, const Placement& placement, const QRect& pixels) {
    QFont font = Theme::current().mono(12);
    font.setPixelSize(int(placement.zoom * 0.8));
    painter.setFont(font);
    for (int y = pixels.top(); y <= pixels.bottom(); ++y)
        for (int x = pixels.left(); x <= pixels.right(); ++x) {
            const QString mark = content.strange(x, y);
            if (mark.isEmpty()) continue;
            painter.setPen(inkOn(content.image.pixel(x, y)));
            painter.drawText(QRectF(placement.toWidget(QPointF(x, y)), QSizeF(placement.zoom, placement.zoom)),
                             Qt::AlignCenter, mark);
        }
}

// White in black: seen on every picture.
void paintDouble(QPainter& painter, double white, double black, const std::function<void()>& draw) {
    for (const auto& [color, width] : {std::pair(Qt::black, black), std::pair(Qt::white, white)}) {
        painter.setPen(QPen(QColor(color), width, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
        draw();
    }
}

void paintPicked(QPainter& painter, QPoint picked, const Placement& placement, QRect visible, bool hasCrossHair) {
    QRectF frame(placement.toWidget(picked), QSizeF(placement.zoom, placement.zoom));
    if (frame.width() < 8) {
        const QPointF centre = frame.center();
        frame = QRectF(centre.x() - 4, centre.y() - 4, 8, 8);
    }
    painter.setBrush(Qt::NoBrush);
    if (hasCrossHair) {
        const QPointF c = frame.center();
        const double gap = frame.width() / 2 + 6;
        paintDouble(painter, 1.5, 3.5, [&] {
            painter.drawLine(QPointF(visible.left(), c.y()), QPointF(c.x() - gap, c.y()));
            painter.drawLine(QPointF(c.x() + gap, c.y()), QPointF(visible.right() + 1, c.y()));
            painter.drawLine(QPointF(c.x(), visible.top()), QPointF(c.x(), c.y() - gap));
            painter.drawLine(QPointF(c.x(), c.y() + gap), QPointF(c.x(), visible.bottom() + 1));
        });
    }
    paintDouble(painter, 2.5, 5, [&] { painter.drawRect(frame); });
}

void paintPinned(QPainter& painter, int number, QPoint pixel, const Placement& placement) {
    QRectF frame(placement.toWidget(pixel), QSizeF(placement.zoom, placement.zoom));
    if (frame.width() < 6) frame = QRectF(frame.center() - QPointF(3, 3), QSizeF(6, 6));
    painter.setBrush(Qt::NoBrush);
    paintDouble(painter, 1.5, 3.5, [&] { painter.drawRect(frame); });
    QFont font = Theme::current().mono(13);
    font.setBold(true);
    const double side = QFontMetricsF(font).height();
    const QRectF square(frame.topRight() + QPointF(2, -side - 1), QSizeF(side, side));
    painter.setPen(QPen(Qt::white, 1));
    painter.setBrush(Qt::black);
    painter.drawRect(square);
    painter.setFont(font);
    painter.drawText(square, Qt::AlignCenter, QString::number(number));
    painter.setBrush(Qt::NoBrush);
}

}  // namespace

void paintChecker(QPainter& painter, QRect rect) {
    const ThemeColors& c = Theme::current().colors();
    QPixmap tile(16, 16);
    tile.fill(c.view);
    QPainter tilePainter(&tile);
    tilePainter.fillRect(0, 0, 8, 8, c.hover);
    tilePainter.fillRect(8, 8, 8, 8, c.hover);
    tilePainter.end();
    painter.drawTiledPixmap(rect, tile);
}

void paintCanvas(QPainter& painter, const CanvasContent& content, const Placement& placement, QRect visible,
                 bool showEdges, const std::stop_token& stop) {
    const ThemeColors& c = Theme::current().colors();
    if (content.hasGround) painter.fillRect(visible, content.ground.isValid() ? content.ground : c.bg);
    if (content.size.isEmpty()) return;
    const QRect pixels = visiblePixels(content, placement, visible);
    const QRectF picture(placement.origin, QSizeF(content.size) * placement.zoom);
    if (content.hasGround && !content.ground.isValid())
        paintChecker(painter, picture.toAlignedRect().intersected(visible));
    if (!content.image.isNull() && !pixels.isEmpty()) {
        paintImage(painter, content, placement, pixels);
        if (content.verdicts) {
            constexpr double kStrength = 0.6;  // of the shapes: the picture below still shows
            paintShapes(painter, *content.verdicts, placement.origin, placement.zoom, visible, stop, kStrength);
        }
        if (placement.zoom >= kGridZoom) paintGrid(painter, placement, pixels);
        if (placement.zoom >= kGridZoom && placement.zoom < kTextZoom && content.strange)
            paintStrange(painter, content, placement, pixels);
        if (showEdges || placement.zoom >= kEdgeZoom) paintEdges(painter, content, placement, pixels, stop);
        if (placement.zoom >= kEdgeZoom && placement.zoom < kTextZoom && !content.edgeView)
            paintCentres(painter, placement, pixels);
        const double textZoom = content.edgeView ? kWeightsZoom : kTextZoom;
        if (placement.zoom >= textZoom && content.text) paintTexts(painter, content, placement, pixels);
        if (content.edgeView) paintEdgeView(painter, *content.edgeView, placement, pixels);
    }
    if (content.shapes) paintShapes(painter, *content.shapes, placement.origin, placement.zoom, visible, stop);
}

void paintMarks(QPainter& painter, const CanvasContent& content, const Placement& placement, QRect visible) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (const QPolygonF& outline : content.marked) {
        const QPolygonF polygon = placement.toWidget(outline);
        paintDouble(painter, 2, 4, [&] {
            polygon.size() == 1 ? painter.drawEllipse(polygon[0], 6, 6) : painter.drawPolygon(polygon);
        });
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
    if (content.region)
        paintDouble(painter, 1.5, 3.5, [&] {
            painter.drawRect(
                QRectF(placement.toWidget(content.region->topLeft()), QSizeF(content.region->size()) * placement.zoom));
        });
    for (const auto& [number, pixel] : content.pinned) paintPinned(painter, number, pixel, placement);
    if (content.hovered && content.hovered != content.picked) {
        const QRectF frame(placement.toWidget(*content.hovered), QSizeF(placement.zoom, placement.zoom));
        paintDouble(painter, 1, 2.5, [&] { painter.drawRect(frame); });
    }
    if (content.picked) {
        // The cross-hair would run through what is written in a large pixel or on polygons.
        const bool hasCrossHair = placement.zoom < 24 && !content.shapes;
        paintPicked(painter, *content.picked, placement, visible, hasCrossHair);
    }
}

void paintOrigin(QPainter& painter, const Placement& placement, QSize size) {
    const ThemeColors& c = Theme::current().colors();
    const QFont font = Theme::current().mono(12);
    const QFontMetricsF metrics(font);
    const QString text = QStringLiteral("0, 0");
    const QPointF corner = placement.toWidget(QPointF(0, size.height()));
    const QRectF box(corner + QPointF(2, -metrics.height() - 4),
                     QSizeF(metrics.horizontalAdvance(text) + 8, metrics.height() + 2));
    painter.setPen(QPen(c.line, 1));
    painter.setBrush(c.surface);
    painter.drawRect(box);
    painter.setPen(c.text);
    painter.setFont(font);
    painter.drawText(box, Qt::AlignCenter, text);
}

}  // namespace app
