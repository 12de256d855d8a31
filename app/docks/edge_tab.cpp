#include "app/docks/edge_tab.h"

#include <QPainter>

#include "app/widgets/follow_theme.h"

namespace app {

EdgeTab::EdgeTab(QWidget* parent) : QAbstractButton(parent) {
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
    followTheme(this, [this] { updateGeometry(); });
}

QSize EdgeTab::sizeHint() const { return {Theme::current().px(26), Theme::current().px(200)}; }

void EdgeTab::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(hasFocus() ? QPen(c.focus, 2) : isEnabled() ? QPen(c.line, 1) : QPen(c.outline, 1.5, Qt::DashLine));
    painter.setBrush(isEnabled() && underMouse() ? c.hover : c.surface);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
    painter.setFont(theme.text(12));
    painter.setPen(c.text2);
    painter.translate(width(), 0);
    painter.rotate(90);
    painter.drawText(QRect(0, 0, height(), width()), Qt::AlignCenter, text());
}

}  // namespace app
