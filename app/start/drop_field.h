#pragma once
#include <QLabel>
#include <QPainter>

#include "app/look/theme.h"

namespace app {

// A dashed box that invites to drop files; tinted while a file is dragged over the window.
class DropField : public QLabel {
public:
    using QLabel::QLabel;

    void setOver(bool over) {
        m_over = over;
        update();
    }

protected:
    void paintEvent(QPaintEvent* event) override {
        const ThemeColors& c = Theme::current().colors();
        const double radius = Theme::current().px(6);
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setBrush(m_over ? c.tint : QColor(Qt::transparent));
        painter.setPen(QPen(m_over ? c.accent : c.outline, 1, Qt::DashLine));
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), radius, radius);
        QLabel::paintEvent(event);
    }

private:
    bool m_over = false;
};

}  // namespace app
