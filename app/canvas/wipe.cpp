#include "app/canvas/wipe.h"

#include <QFontMetricsF>
#include <cmath>

#include "app/look/theme.h"

namespace app {

namespace {

// On a ground of its own, readable on every picture.
void paintName(QPainter& painter, const QString& name, QRectF part) {
    constexpr double kMargin = 8, kPadding = 6;
    if (name.isEmpty() || part.width() < 3 * kMargin) return;
    const ThemeColors& c = Theme::current().colors();
    painter.setFont(Theme::current().text(13, 600));
    const QFontMetricsF metrics(painter.font());
    const double room = part.width() - 2 * (kMargin + kPadding);
    const QString text = metrics.elidedText(name, Qt::ElideRight, room);
    const QRectF chip(part.left() + kMargin, part.top() + kMargin, metrics.horizontalAdvance(text) + 2 * kPadding,
                      metrics.height() + kPadding);
    painter.setPen(c.line);
    painter.setBrush(c.surface);
    painter.drawRoundedRect(chip, 4, 4);
    painter.setPen(c.text);
    painter.drawText(chip, Qt::AlignCenter, text);
}

void paintHandle(QPainter& painter, double x, QRect view) {
    const ThemeColors& c = Theme::current().colors();
    painter.setPen(QPen(Qt::black, 4));
    painter.drawLine(QPointF(x, view.top()), QPointF(x, view.bottom() + 1));
    painter.setPen(QPen(Qt::white, 2));
    painter.drawLine(QPointF(x, view.top()), QPointF(x, view.bottom() + 1));
    const QRectF grip(x - kWipeHandle / 2.0, view.center().y() - 18, kWipeHandle, 36);
    painter.setPen(QPen(Qt::black, 1));
    painter.setBrush(c.fill);
    painter.drawRoundedRect(grip, 4, 4);
    painter.setPen(QPen(c.onFill, 1.5, Qt::SolidLine, Qt::RoundCap));
    for (const double dx : {-2.0, 2.0})
        painter.drawLine(QPointF(x + dx, grip.top() + 10), QPointF(x + dx, grip.bottom() - 10));
}

}  // namespace

bool isOnHandle(const Wipe& wipe, QRect view, QPointF at) {
    return wipe.hasHandle && std::abs(at.x() - wipe.border(view.width())) <= kWipeHandle / 2.0;
}

void paintWipe(QPainter& painter, const Wipe& wipe, QRect view) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const int border = wipe.border(view.width());
    paintName(painter, wipe.nameA, QRectF(view.left(), view.top(), border, view.height()));
    paintName(painter, wipe.nameB, QRectF(view.left() + border, view.top(), view.width() - border, view.height()));
    if (wipe.hasHandle) paintHandle(painter, border, view);
    painter.restore();
}

}  // namespace app
