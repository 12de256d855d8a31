#include "app/view3d/handle_painter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/core/theme.h"

namespace app {

namespace {

constexpr double kRadius = 10;

QPointF toPoint(glm::dvec2 p) { return {p.x, p.y}; }

// White in black is seen on every picture.
void stroke(QPainter& painter, const QColor& ink, double width, const auto& draw) {
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(Theme::current().colors().view, width + 3), QPen(ink, width)}) {
        painter.setPen(pen);
        draw();
    }
}

}  // namespace

void paintHandle(QPainter& painter, const Handle& handle, const ViewFrame& view, bool hot, DragAxis axis) {
    const Projected p = project(view.camera, view.size, handle.at);
    if (!p.inFront) return;
    const Theme& theme = Theme::current();
    const ThemeColors& colors = theme.colors();
    const QPointF middle = toPoint(p.at);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (hot && handle.kind != Handle::Kind::LightDirection) {
        const auto tips = axisTips(handle, view);
        static constexpr std::array kNames{"x", "y", "z"};
        QFont font = theme.formula(16);
        font.setItalic(true);
        painter.setFont(font);
        for (std::size_t i = 0; i < 3; ++i) {
            const bool taken = axis == DragAxis(i + 1);
            const QPointF tip = toPoint(tips[i]);
            stroke(painter, taken ? colors.accent : colors.text2, taken ? 2.5 : 1.5,
                   [&] { painter.drawLine(middle, tip); });
            painter.setPen(QPen(colors.view, 1.5));
            painter.setBrush(taken ? colors.accent : colors.text2);
            painter.drawRect(QRectF(tip.x() - 4.5, tip.y() - 4.5, 9, 9));
            painter.setPen(taken ? colors.accent : colors.text);
            const QPointF out = tip - middle;
            const double length = std::max(1.0, std::hypot(out.x(), out.y()));
            const QPointF beside = tip + 13 / length * out;
            painter.drawText(QRectF(beside.x() - 12, beside.y() - 12, 24, 24), Qt::AlignCenter, kNames[i]);
        }
    }
    stroke(painter, hot ? colors.accent : colors.outline, hot ? 2.5 : 1.5,
           [&] { painter.drawEllipse(middle, kRadius, kRadius); });
    // An object has no mark of its own.
    if (handle.kind == Handle::Kind::Object || handle.kind == Handle::Kind::Target)
        stroke(painter, hot ? colors.accent : colors.outline, 1.5, [&] {
            painter.drawLine(middle - QPointF(5, 0), middle + QPointF(5, 0));
            painter.drawLine(middle - QPointF(0, 5), middle + QPointF(0, 5));
        });
    painter.restore();
}

void paintNumbers(QPainter& painter, const QString& text, QPointF cursor, const ViewFrame& view) {
    const Theme& theme = Theme::current();
    const ThemeColors& colors = theme.colors();
    const QFont font = theme.mono(13);
    const QFontMetricsF metrics(font);
    const double padding = theme.px(6);
    QRectF box(0, 0, metrics.horizontalAdvance(text) + 2 * padding, metrics.height() + padding);
    box.moveTopLeft(cursor + QPointF(16, 14));
    box.moveLeft(std::clamp(box.left(), 4.0, std::max(4.0, view.size.x - box.width() - 4)));
    if (box.bottom() > view.size.y - 4) box.moveBottom(cursor.y() - 12);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colors.line, 1));
    painter.setBrush(colors.surface);
    painter.drawRoundedRect(box, 4, 4);
    painter.setFont(font);
    painter.setPen(colors.text);
    painter.drawText(box, Qt::AlignCenter, text);
    painter.restore();
}

}  // namespace app
