#include "app/start/start_line.h"

#include <QPainter>

#include "app/look/icons.h"
#include "app/look/theme.h"

namespace app {

StartLine::StartLine(const QString& title, const QString& tip, QWidget* parent)
    : StartButton(title, tip, Frame::Flat, parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize StartLine::sizeHint() const {
    const Theme& theme = Theme::current();
    const int line = QFontMetrics(theme.text()).height();
    return {theme.px(120),
            m_icon.isEmpty() ? line + (m_where.isEmpty() ? 0 : line) + theme.px(12) : line + theme.px(8)};
}

void StartLine::paintInside(QPainter& painter, const QRectF& box) const {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    if (!m_icon.isEmpty()) {
        const int side = theme.px(16);
        painter.drawPixmap(QPointF(box.left(), box.center().y() - side / 2.0),
                           iconPixmap(m_icon, c.text2, side, devicePixelRatioF()));
        painter.setFont(theme.text());
        painter.setPen(c.text);
        const QRectF words = box.adjusted(theme.px(25), 0, 0, 0);
        painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(text(), Qt::ElideRight, int(words.width())));
        return;
    }
    painter.setFont(theme.text(12));
    painter.setPen(c.text2);
    const int line = QFontMetrics(theme.text()).height();
    const double top = box.top() + theme.px(4);
    double right = box.right();
    if (m_isTimed) {
        painter.drawText(QRectF(box.left(), top, box.width(), line), Qt::AlignRight | Qt::AlignVCenter, m_when);
        right -= painter.fontMetrics().horizontalAdvance(m_when) + theme.px(8);
    }
    painter.drawText(QRectF(box.left(), top + line, box.width(), line + theme.px(2)), Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(m_where, Qt::ElideRight, int(box.width())));
    painter.setFont(theme.text(13, 500));
    painter.setPen(c.text);
    painter.drawText(QRectF(box.left(), top, right - box.left(), line), Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text(), Qt::ElideRight, int(right - box.left())));
    painter.setPen(c.line);
    painter.drawLine(box.bottomLeft() - QPointF(0, 0.5), box.bottomRight() - QPointF(0, 0.5));
}

}  // namespace app
