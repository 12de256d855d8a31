#include "app/panels/start_button.h"

#include <QPainter>
#include <QPainterPath>

#include "app/panels/follow_theme.h"

namespace app {

StartButton::StartButton(const QString& title, const QString& description, QSizePolicy::Policy across,
                         QSizePolicy::Policy down, QWidget* parent)
    : QAbstractButton(parent) {
    setText(title);
    setAccessibleName(title);
    setAccessibleDescription(description);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
    setCursor(Qt::PointingHandCursor);
    QSizePolicy policy(across, down);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    followTheme(this, [this] { updateGeometry(), update(); });
}

void StartButton::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const QRectF box = QRectF(rect()).adjusted(3.5, 3.5, -3.5, -3.5);
    QPainterPath shape;
    shape.addRoundedRect(box, theme.px(6), theme.px(6));
    painter.fillPath(shape, underMouse() ? c.hover : c.surface);
    paintInside(painter, box, shape);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(c.line, 1));
    painter.drawPath(shape);
    if (hasFocus()) {
        painter.setPen(QPen(c.focus, 2));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), theme.px(8), theme.px(8));
    }
}

}  // namespace app
