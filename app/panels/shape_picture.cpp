#include "app/panels/shape_picture.h"

#include <QFontMetricsF>
#include <algorithm>
#include <numeric>

#include "app/core/theme.h"
#include "pipeline/stages/cull.h"

namespace app {

using pipeline::AnyBuffer;
using pipeline::Domain;
using pipeline::Palette;

namespace {

QColor toColor(pipeline::Color8 c) { return {c.r, c.g, c.b}; }

QColor colorOf(const AnyBuffer& buffer, std::size_t row, const BufferLook& look) {
    const Palette palette = shownPalette(*buffer.info, look.channel);
    if (buffer.channels() == 3 && look.channel == ShownChannel::All)
        return toColor(elementColor(buffer, 0, row, look.range));
    return toColor(
        paletteColor(palette, buffer.value(0, row, firstOf(look.channel)), look.range.first, look.range.last));
}

QString rowText(const AnyBuffer& buffer, std::size_t row, ShownChannel channel) {
    const QStringList values = elementText(buffer, 0, row, channel);
    return values.size() == 1 ? values[0] : '(' + values.join(", ") + ')';
}

// Also where one of them is a line or a point.
bool isNear(const QRectF& box, const QRectF& window) {
    return box.right() >= window.left() && box.left() <= window.right() && box.bottom() >= window.top() &&
           box.top() <= window.bottom();
}

QRectF boxAround(const ShapePicture& picture, const ProjectedPolygon& polygon) {
    const auto corners = picture.topology->corners(polygon.polygon);
    QPointF least = picture.places[corners[0]], most = least;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const QPointF& at = picture.places[corners[i]];
        least = {std::min(least.x(), at.x()), std::min(least.y(), at.y())};
        most = {std::max(most.x(), at.x()), std::max(most.y(), at.y())};
    }
    return {least, most};
}

// Once each, as the polygons come to them.
void addPoints(const AnyBuffer& buffer, const BufferLook& look, ShapePicture& picture) {
    const bool isColor = buffer.info->palette == Palette::Color || buffer.info->unit.empty();
    std::vector<bool> seen(buffer.rows(), false);
    for (const Shape& shape : picture.shapes) {
        const auto corners = picture.topology->corners(shape.outline.polygon);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const std::uint32_t v = corners[i];
            if (v >= seen.size() || seen[v]) continue;
            seen[v] = true;
            picture.points.push_back({picture.places[v], int(v), isColor ? colorOf(buffer, v, look) : QColor()});
        }
    }
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

}  // namespace

Qt::BrushStyle hatchOfVerdict(char letter) {
    switch (letter) {
        case 'B': return Qt::BDiagPattern;
        case 'D': return Qt::Dense6Pattern;
        case 'C': return Qt::FDiagPattern;
        case 'O': return Qt::CrossPattern;
        case 'T': return Qt::DiagCrossPattern;
        default: return Qt::NoBrush;
    }
}

QPolygonF ShapePicture::outline(const Shape& shape) const {
    const auto corners = topology->corners(shape.outline.polygon);
    QPolygonF polygon;
    for (std::size_t i = 0; i < corners.size(); ++i) polygon << places[corners[i]];
    return polygon;
}

ShapePicture shapePicture(const pipeline::Frame& frame, const AnyBuffer& buffer, const BufferLook& look, bool isSmall) {
    ProjectedPolygons projected = projectPolygons(frame);
    std::stable_sort(projected.polygons.begin(), projected.polygons.end(), [](const auto& a, const auto& b) {
        return std::pair(a.goesOn, -a.distance) < std::pair(b.goesOn, -b.distance);
    });
    ShapePicture picture;
    picture.topology = std::move(projected.topology);
    picture.places = std::move(projected.places);
    picture.isSmall = isSmall;
    picture.shapes.reserve(projected.polygons.size());
    picture.boxes.reserve(projected.polygons.size());
    const bool onPolygons = buffer.info->domain == Domain::Polygon;
    const bool areVerdicts = onPolygons && buffer.info->palette == Palette::Verdict;
    picture.value = [buffer, areVerdicts, channel = look.channel](std::size_t row) {
        return areVerdicts ? QString::number(row) : rowText(buffer, row, channel);
    };
    for (const ProjectedPolygon& polygon : projected.polygons) {
        Shape& shape = picture.shapes.emplace_back(Shape{.outline = polygon, .fill = {}});
        if (onPolygons) shape.fill = colorOf(buffer, polygon.polygon, look);
        if (areVerdicts) shape.letter = pipeline::letter(pipeline::Verdict(int(buffer.flat(polygon.polygon))));
        picture.boxes.push_back(boxAround(picture, polygon));
    }
    if (buffer.info->domain == Domain::Vertex) addPoints(buffer, look, picture);
    return picture;
}

int nearestPolygonAt(const ShapePicture& picture, QPointF at) {
    const Shape* nearest = nullptr;
    const auto isBefore = [](const ProjectedPolygon& a, const ProjectedPolygon& b) {
        return std::pair(!a.goesOn, a.distance) < std::pair(!b.goesOn, b.distance);
    };
    for (std::size_t i = 0; i < picture.shapes.size(); ++i) {
        if (!picture.boxes[i].contains(at)) continue;
        const Shape& shape = picture.shapes[i];
        if (nearest && !isBefore(shape.outline, nearest->outline)) continue;
        if (picture.outline(shape).containsPoint(at, Qt::OddEvenFill)) nearest = &shape;
    }
    return nearest ? int(nearest->outline.polygon) : -1;
}

void paintShapes(QPainter& painter, const ShapePicture& picture, QPointF origin, double zoom, QRectF window,
                 const std::stop_token& stop) {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const auto place = [&](QPointF p) { return origin + p * zoom; };
    std::vector<QPointF> placed;
    const auto drawOutline = [&](const Shape& shape) {
        const auto corners = picture.topology->corners(shape.outline.polygon);
        placed.clear();
        for (std::size_t k = 0; k < corners.size(); ++k) placed.push_back(place(picture.places[corners[k]]));
        painter.drawPolygon(placed.data(), int(placed.size()));
    };
    const auto boxOf = [&](std::size_t i) {
        const QRectF& box = picture.boxes[i];
        return QRectF(place(box.topLeft()), box.size() * zoom);
    };
    // Outlines of polygons that are hardly wider than they are would cover all that lies between them; and such
    // polygons, each smoothed by itself, would let the ground shine through between them.
    constexpr double kTiny = 3;
    const auto isTiny = [](const QRectF& box) { return std::max(box.width(), box.height()) < kTiny; };
    const QRectF near = window.adjusted(-kTiny, -kTiny, kTiny, kTiny);
    for (std::size_t i = 0; i < picture.shapes.size(); ++i) {
        if (stop.stop_requested()) break;
        const QRectF box = boxOf(i);
        if (!isNear(box, near)) continue;
        const Shape& shape = picture.shapes[i];
        painter.setRenderHint(QPainter::Antialiasing, !isTiny(box));
        // What culling drops stays visible through what covers it.
        QColor fill = shape.fill;
        if (fill.isValid() && shape.letter && shape.outline.goesOn) fill.setAlpha(170);
        painter.setPen(Qt::NoPen);
        painter.setBrush(fill.isValid() ? QBrush(fill) : Qt::NoBrush);
        drawOutline(shape);
        if (const Qt::BrushStyle hatch = hatchOfVerdict(shape.letter); hatch != Qt::NoBrush) {
            painter.setBrush(QBrush(QColor(0, 0, 0, 150), hatch));
            drawOutline(shape);
        }
    }
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t i = 0; i < picture.shapes.size(); ++i) {
        if (stop.stop_requested()) break;
        const QRectF box = boxOf(i);
        if (isTiny(box) || !isNear(box, near)) continue;
        const Shape& shape = picture.shapes[i];
        QPen pen(shape.outline.goesOn ? c.text : c.text3, shape.outline.goesOn ? 1.5 : 1.2);
        if (!shape.outline.goesOn) pen.setDashPattern({4, 3});
        painter.setPen(pen);
        painter.setBrush(Qt::NoBrush);
        drawOutline(shape);
    }

    for (const ShapePoint& point : picture.points) {
        painter.setPen(QPen(c.view, 1.5));
        painter.setBrush(point.fill.isValid() ? point.fill : c.accent);
        const double radius = picture.isSmall ? 2 : 5;
        painter.drawEllipse(place(point.at), radius, radius);
    }

    // Words for hundreds of polygons would hide them; of more than a few, those in front have words.
    const bool writes = !picture.isSmall && std::max(picture.shapes.size(), picture.points.size()) <= 200;
    const bool writesAll = picture.shapes.size() <= 6;
    window.adjust(2, 2, -2, -2);
    painter.setFont(theme.mono(12));
    const QFontMetricsF metrics(painter.font());
    std::vector<Chip> chips;
    const auto add = [&](QPointF of, QPointF offset, const QString& text, const QColor& ground, const QColor& ink) {
        Chip chip{of, QRectF(0, 0, metrics.horizontalAdvance(text) + 8, metrics.height() + 2), text, ground, ink};
        chip.rect.moveCenter(of);
        if (!offset.isNull()) chip.rect.moveTopLeft(of + offset);
        makeRoom(chip, chips, window);
        chips.push_back(chip);
    };
    if (!writes) return painter.restore();
    for (const Shape& shape : picture.shapes) {
        const ProjectedPolygon& polygon = shape.outline;
        const QPointF centre = place(meanOf(picture.outline(shape)));
        if (!shape.fill.isValid() || !window.contains(centre)) continue;
        const QString value = picture.value(polygon.polygon);
        if (shape.letter)
            add(centre, {}, QString("%1  %2").arg(shape.letter).arg(value), shape.fill, Qt::black);
        else if (writesAll || polygon.goesOn)
            add(centre, {}, QString("%1  %2").arg(polygon.polygon).arg(value), c.view,
                polygon.goesOn ? c.text : c.text3);
    }
    for (const ShapePoint& point : picture.points)
        if (window.contains(place(point.at)))
            add(place(point.at), {8, -metrics.height() - 6},
                QString("%1  %2").arg(point.vertex).arg(picture.value(std::size_t(point.vertex))), c.view, c.text);
    paintChips(painter, chips);
    painter.restore();
}

}  // namespace app
