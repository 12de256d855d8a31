#include "app/canvas/shape_painter.h"

#include <QFontMetricsF>
#include <algorithm>
#include <numeric>

#include "app/look/luminance.h"
#include "app/look/theme.h"

namespace app {

namespace {

// Black or white, whichever has more contrast: WCAG 2.1, where both have the same from a luminance of 0.179 on.
QColor inkOn(const QColor& ground) {
    const auto light = [](double channel) { return std::pow(channel, 2.2); };
    const double seen = luminance(light(ground.redF()), light(ground.greenF()), light(ground.blueF()));
    return seen < 0.179 ? Qt::white : Qt::black;
}

// Also where one of them is a line or a point.
bool isNear(const QRectF& box, const QRectF& window) {
    return box.right() >= window.left() && box.left() <= window.right() && box.bottom() >= window.top() &&
           box.top() <= window.bottom();
}

QPointF meanOf(const QPolygonF& corners) {
    return std::accumulate(corners.begin(), corners.end(), QPointF()) / double(corners.size());
}

// A few words on a ground of their own, near the place that they speak of.
struct Chip {
    QPointF of;
    QRectF rect;
    QString text;
    QColor ground, ink;
};

// Moves a chip into the window and off those that are there already, down or up by whole lines.
void makeRoom(Chip& chip, const std::vector<Chip>& others, const QRectF& window) {
    QRectF& rect = chip.rect;
    rect.moveLeft(std::clamp(rect.left(), window.left(), std::max(window.left(), window.right() - rect.width())));
    const double start = rect.top();
    for (int step = 0; step < 60; ++step) {
        rect.moveTop(start + (step + 1) / 2 * (step % 2 ? 1.0 : -1.0) * (rect.height() + 1));
        const bool inside = rect.top() >= window.top() && rect.bottom() <= window.bottom();
        if (inside &&
            std::none_of(others.begin(), others.end(), [&](const Chip& c) { return c.rect.intersects(rect); }))
            return;
    }
    rect.moveTop(start);
}

// Lines from things to their chips, where those had to move away; then the chips.
void paintChips(QPainter& painter, const std::vector<Chip>& chips) {
    for (const Chip& chip : chips) {
        const QPointF to(std::clamp(chip.of.x(), chip.rect.left(), chip.rect.right()),
                         std::clamp(chip.of.y(), chip.rect.top(), chip.rect.bottom()));
        if (QLineF(chip.of, to).length() < 4) continue;
        const QColor color = Theme::current().colors().text;
        painter.setPen(QPen(color, 1));
        painter.drawLine(chip.of, to);
        painter.setBrush(color);
        painter.drawEllipse(chip.of, 2, 2);
    }
    for (const Chip& chip : chips) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(chip.ground);
        painter.drawRoundedRect(chip.rect, 3, 3);
        painter.setPen(chip.ink);
        painter.drawText(chip.rect, Qt::AlignCenter, chip.text);
    }
}

// Outlines of polygons that are hardly wider than they are would cover all that lies between them; and such polygons,
// each smoothed by itself, would let the ground shine through between them.
constexpr double kTiny = 3;
bool isTiny(const QRectF& box) { return std::max(box.width(), box.height()) < kTiny; }

struct ShapePainter {
    QPainter& painter;
    const ShapePicture& picture;
    QPointF origin;
    double zoom;
    QRectF window;
    const std::stop_token& stop;
    const ThemeColors& colors = Theme::current().colors();
    std::vector<QPointF> placed{};  // the corners of one polygon after the other

    QPointF place(QPointF p) const { return origin + p * zoom; }
    void drawOutline(const Shape& shape) {
        const auto corners = picture.topology->corners(shape.outline.polygon);
        placed.clear();
        for (std::size_t i = 0; i < corners.size(); ++i) placed.push_back(place(picture.places[corners[i]]));
        painter.drawPolygon(placed.data(), int(placed.size()));
    }
    // visit(shape, its box) for each that is seen, until it is stopped.
    template <class Visit>
    void forEachSeen(Visit visit) const {
        const QRectF near = window.adjusted(-kTiny, -kTiny, kTiny, kTiny);
        for (std::size_t i = 0; i < picture.shapes.size() && !stop.stop_requested(); ++i) {
            const QRectF box = picture.boxOf(i);
            const QRectF at(place(box.topLeft()), box.size() * zoom);
            if (isNear(at, near)) visit(picture.shapes[i], at);
        }
    }

    void fill() {
        forEachSeen([&](const Shape& shape, const QRectF& box) {
            painter.setRenderHint(QPainter::Antialiasing, !isTiny(box));
            // What culling drops stays visible through what covers it.
            QColor color = shape.fill;
            if (color.isValid() && shape.letter && shape.outline.goesOn) color.setAlpha(170);
            painter.setPen(Qt::NoPen);
            painter.setBrush(color.isValid() ? QBrush(color) : Qt::NoBrush);
            drawOutline(shape);
            const Qt::BrushStyle hatch = hatchOfVerdict(shape.letter);
            if (hatch == Qt::NoBrush) return;
            painter.setBrush(QBrush(QColor(0, 0, 0, 150), hatch));
            drawOutline(shape);
        });
    }

    void drawOutlines() {
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setBrush(Qt::NoBrush);
        forEachSeen([&](const Shape& shape, const QRectF& box) {
            if (isTiny(box)) return;
            const bool goesOn = shape.outline.goesOn;
            QPen pen(goesOn ? colors.text : colors.text3, goesOn ? 1.5 : 1.2);
            if (!goesOn) pen.setDashPattern({4, 3});
            painter.setPen(pen);
            drawOutline(shape);
        });
    }

    void drawPoints() const {
        painter.setPen(QPen(colors.view, 1.5));
        const double radius = picture.isSmall ? 2 : 5;
        for (const ShapePoint& point : picture.points) {
            if (stop.stop_requested()) return;
            painter.setBrush(point.fill.isValid() ? point.fill : colors.accent);
            painter.drawEllipse(place(point.at), radius, radius);
        }
    }

    void write() const {
        // Words for hundreds of polygons would hide them; of more than a few, those in front have words.
        if (picture.isSmall || std::max(picture.shapes.size(), picture.points.size()) > 200) return;
        const bool writesAll = picture.shapes.size() <= 6;
        const QRectF inside = window.adjusted(2, 2, -2, -2);
        painter.setFont(Theme::current().mono(13));
        const QFontMetricsF metrics(painter.font());
        std::vector<Chip> chips;
        const auto add = [&](QPointF of, QPointF offset, const QString& text, const QColor& ground, const QColor& ink) {
            Chip chip{of, QRectF(0, 0, metrics.horizontalAdvance(text) + 8, metrics.height() + 2), text, ground, ink};
            chip.rect.moveCenter(of);
            if (!offset.isNull()) chip.rect.moveTopLeft(of + offset);
            makeRoom(chip, chips, inside);
            chips.push_back(chip);
        };
        for (const Shape& shape : picture.shapes) {
            const auto& [polygon, goesOn, distance] = shape.outline;
            const QPointF centre = place(meanOf(picture.outline(shape)));
            if (!shape.fill.isValid() || !inside.contains(centre)) continue;
            if (shape.letter)
                add(centre, {}, QString("%1  %2").arg(shape.letter).arg(picture.value(polygon)), shape.fill,
                    inkOn(shape.fill));
            else if (writesAll || goesOn)
                add(centre, {}, QString("%1  %2").arg(polygon).arg(picture.value(polygon)), colors.view,
                    goesOn ? colors.text : colors.text3);
        }
        for (const ShapePoint& point : picture.points)
            if (const QPointF at = place(point.at); inside.contains(at))
                add(at, {8, -metrics.height() - 6},
                    QString("%1  %2").arg(point.vertex).arg(picture.value(std::size_t(point.vertex))), colors.view,
                    colors.text);
        paintChips(painter, chips);
    }
};

}  // namespace

void paintShapes(QPainter& painter, const ShapePicture& picture, QPointF origin, double zoom, QRectF window,
                 const std::stop_token& stop, double strength) {
    painter.save();
    ShapePainter shapes{painter, picture, origin, zoom, window, stop};
    painter.setOpacity(strength);
    shapes.fill();
    shapes.drawOutlines();
    shapes.drawPoints();
    painter.setOpacity(1);
    shapes.write();
    painter.restore();
}

}  // namespace app
