#include "app/view3d/handle_painter.h"

#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "app/look/theme.h"

namespace app {

namespace {

constexpr double kRadius = 10;  // pixels of the design, as all sizes here

// White in black is seen on every picture.
void stroke(QPainter& painter, const QColor& ink, double width, double scale, const auto& draw) {
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(Theme::current().colors().view, (width + 3) * scale), QPen(ink, width * scale)}) {
        painter.setPen(pen);
        draw();
    }
}

QString nameOf(const HandleArm& arm) { return QString::fromStdString(arm.name); }

// A name beyond the end of an arm, away from the middle.
void paintName(QPainter& painter, const QString& name, QPointF end, QPointF middle, double scale) {
    const QPointF out = end - middle;
    const double length = std::max(1.0, std::hypot(out.x(), out.y()));
    const QPointF beside = end + 13 * scale / length * out;
    painter.drawText(QRectF(beside.x() - 12 * scale, beside.y() - 12 * scale, 24 * scale, 24 * scale), Qt::AlignCenter,
                     name);
}

void paintArms(QPainter& painter, const Handle& handle, const HandleView& view, QPointF middle,
               std::optional<std::size_t> held) {
    const ThemeColors& colors = Theme::current().colors();
    const double s = view.view.scale;
    const std::vector<glm::dvec2> tips = armTips(handle, view);
    for (std::size_t i = 0; i < tips.size(); ++i) {
        const bool taken = held == i;
        const QPointF tip = toPoint(tips[i]);
        stroke(painter, taken ? colors.accent : colors.text2, taken ? 2.5 : 1.5, s,
               [&] { painter.drawLine(middle, tip); });
        painter.setPen(QPen(colors.view, 1.5 * s));
        painter.setBrush(taken ? colors.accent : colors.text2);
        if (handle.tool == HandleTool::Scale)
            painter.drawPolygon(QPolygonF({tip + s * QPointF(0, -7), tip + s * QPointF(7, 0), tip + s * QPointF(0, 7),
                                           tip + s * QPointF(-7, 0)}));
        else
            painter.drawRect(QRectF(tip.x() - 4.5 * s, tip.y() - 4.5 * s, 9 * s, 9 * s));
        painter.setPen(taken ? colors.accent : colors.text);
        paintName(painter, nameOf(handle.arms[i]), tip, middle, s);
    }
}

// The half of a ring that is turned away is thin.
void paintRings(QPainter& painter, const Handle& handle, const HandleView& view, QPointF middle,
                std::optional<std::size_t> held) {
    const ThemeColors& colors = Theme::current().colors();
    const double depth = placeOf(view, handle.at).depth, s = view.view.scale;
    for (std::size_t i = 0; i < handle.arms.size(); ++i) {
        const bool taken = held == i;
        const QColor ink = taken ? colors.accent : colors.text2;
        QPainterPath front, back;
        QPointF nearest = middle;
        double least = 1e300;
        const std::vector<Vec3d> ring = armRing(handle, i, view);
        for (std::size_t k = 0; k + 1 < ring.size(); ++k) {
            const Projected a = placeOf(view, ring[k]), b = placeOf(view, ring[k + 1]);
            if (!a.inFront || !b.inFront) continue;
            QPainterPath& path = (a.depth + b.depth) / 2 <= depth ? front : back;
            path.moveTo(toPoint(a.at));
            path.lineTo(toPoint(b.at));
            // The name stands a little beside the nearest point, where three rings seldom cross.
            if (k % 8 == 3 && a.depth < least) least = a.depth, nearest = toPoint(a.at);
        }
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(ink, 0.8 * s));
        painter.drawPath(back);
        stroke(painter, ink, taken ? 3 : 1.8, s, [&] { painter.drawPath(front); });
        painter.setPen(taken ? colors.accent : colors.text);
        paintName(painter, nameOf(handle.arms[i]), nearest, middle, s);
    }
}

}  // namespace

void paintHandle(QPainter& painter, const Handle& handle, const HandleView& view, bool hot,
                 std::optional<std::size_t> arm) {
    const Projected p = placeOf(view, handle.at);
    if (!p.inFront) return;
    const Theme& theme = Theme::current();
    const ThemeColors& colors = theme.colors();
    const QPointF middle = toPoint(p.at);
    const double s = view.view.scale;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (hot) {
        QFont font = theme.formula(16);
        font.setItalic(true);
        painter.setFont(font);
        (handle.tool == HandleTool::Turn ? paintRings : paintArms)(painter, handle, view, middle, arm);
    }
    const Projected centre = placeOf(view, handle.centre);
    if (handle.kind == Handle::Kind::LightFacing && centre.inFront)
        stroke(painter, hot ? colors.accent : colors.outline, 1.5, s,
               [&] { painter.drawLine(toPoint(centre.at), middle); });
    stroke(painter,
           hot && !arm ? colors.accent
           : hot       ? colors.text2
                       : colors.outline,
           hot ? 2.5 : 1.5, s, [&] { painter.drawEllipse(middle, kRadius * s, kRadius * s); });
    // These have no mark of their own.
    if (handle.kind == Handle::Kind::Object || handle.kind == Handle::Kind::Target)
        stroke(painter, hot ? colors.accent : colors.outline, 1.5, s, [&] {
            painter.drawLine(middle - s * QPointF(5, 0), middle + s * QPointF(5, 0));
            painter.drawLine(middle - s * QPointF(0, 5), middle + s * QPointF(0, 5));
        });
    painter.restore();
}

void paintNumbers(QPainter& painter, const QString& text, QPointF cursor, const ViewFrame& view) {
    const Theme& theme = Theme::current();
    const ThemeColors& colors = theme.colors();
    const QFont font = theme.mono(13);
    const QFontMetricsF metrics(font);
    const double padding = theme.px(6);
    // In a narrow view the name has a line of its own.
    const auto sizeOf = [&](const QString& lines) { return metrics.size(0, lines); };
    QString lines = text;
    if (sizeOf(lines).width() + 2 * padding > view.size.x - 8) lines.replace(": ", ":\n");
    QRectF box(QPointF(), sizeOf(lines) + QSizeF(2 * padding, padding));
    box.moveTopLeft(cursor + view.scale * QPointF(16, 14));
    box.moveLeft(std::clamp(box.left(), 4.0, std::max(4.0, view.size.x - box.width() - 4)));
    if (box.bottom() > view.size.y - 4) box.moveBottom(std::min(cursor.y() - 12 * view.scale, view.size.y - 4));
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colors.line, 1));
    painter.setBrush(colors.surface);
    painter.drawRoundedRect(box, theme.px(4), theme.px(4));
    painter.setFont(font);
    painter.setPen(colors.text);
    painter.drawText(box, Qt::AlignCenter, lines);
    painter.restore();
}

}  // namespace app
