#include "app/start/start_button.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "app/widgets/follow_theme.h"

namespace app {

StartButton::StartButton(const QString& title, const QString& description, Frame frame, QWidget* parent)
    : QAbstractButton(parent), m_frame(frame) {
    setText(title);
    setToolTip(description);
    setAccessibleName(title);
    setAccessibleDescription(description);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
    setCursor(Qt::PointingHandCursor);
    followTheme(this, [this] { updateGeometry(), update(); });
}

void StartButton::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const double radius = m_frame == Frame::Card ? theme.px(6) : 0;
    const QRectF box = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    QPainterPath shape;
    shape.addRoundedRect(m_frame == Frame::Card ? box : QRectF(rect()), radius, radius);
    painter.setClipPath(shape);
    if (m_frame == Frame::Card) painter.fillPath(shape, c.surface);
    if (underMouse()) painter.fillPath(shape, c.hover);
    paintInside(painter, rect());
    painter.setClipping(false);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(c.line, 1));
    if (m_frame == Frame::Card) painter.drawPath(shape);
    if (!hasFocus()) return;
    painter.setPen(QPen(c.surface, 4));  // a light line in it: the ring stands on black pictures
    painter.drawRoundedRect(QRectF(rect()).adjusted(2, 2, -2, -2), radius, radius);
    painter.setPen(QPen(c.focus, 2));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), radius, radius);
}

void StartButton::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return click();
    QAbstractButton::keyPressEvent(event);
}

namespace {

// Where `shown` of a line of `whole` begins, so that the kept part is in it. Beyond the picture's end what touches an
// edge of the picture still touches it.
double beginOf(double shown, double whole, double first, double last) {
    if (shown <= whole) return std::clamp((first + last - shown) / 2, 0.0, whole - shown);
    const bool touchesFirst = first<1, touchesLast = last> whole - 1;
    return touchesLast && !touchesFirst ? whole - shown : touchesFirst && !touchesLast ? 0 : (whole - shown) / 2;
}

}  // namespace

void paintScenePicture(QPainter& painter, const QRectF& place, const QImage& picture, const QRectF& kept) {
    painter.fillRect(place, picture.isNull() ? Theme::current().colors().view : QColor(Qt::black));
    if (picture.isNull() || place.isEmpty()) return;
    constexpr double kMargin = 1.06;  // around what is drawn
    const QSizeF whole = picture.size();
    QSizeF shown = place.size().scaled(whole, Qt::KeepAspectRatio);
    const double grow = std::max(kMargin * kept.width() / shown.width(), kMargin * kept.height() / shown.height());
    const double most = std::max(whole.width() / shown.width(), whole.height() / shown.height());
    shown *= std::clamp(grow, 1.0, most);
    const QPointF from(beginOf(shown.width(), whole.width(), kept.left(), kept.right()),
                       beginOf(shown.height(), whole.height(), kept.top(), kept.bottom()));
    const QRectF source = QRectF(from, shown) & QRectF(QPointF(), whole);
    const double scale = place.width() / shown.width();
    painter.drawImage(QRectF(place.topLeft() + (source.topLeft() - from) * scale, source.size() * scale), picture,
                      source);
}

}  // namespace app
