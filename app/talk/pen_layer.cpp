#include "app/talk/pen_layer.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include "app/look/theme.h"

namespace app {

PenLayer::PenLayer(QWidget* parent) : QWidget(parent) { setAttribute(Qt::WA_TransparentForMouseEvents); }

void PenLayer::setCover(Cover cover) {
    m_cover = cover;
    update();
}

void PenLayer::setPen(bool pen) {
    m_pen = pen;
    setAttribute(Qt::WA_TransparentForMouseEvents, !pen);
    setCursor(pen ? Qt::CrossCursor : Qt::ArrowCursor);
    update();
}

void PenLayer::setSpotlight(bool spotlight) {
    m_spotlight = spotlight;
    update();
}

void PenLayer::pointAt(QPointF position) {
    m_at = position;
    if (m_spotlight) update();
}

void PenLayer::clearLines() {
    m_lines.clear();
    update();
}

void PenLayer::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (m_cover != Cover::None) {
        painter.fillRect(rect(), m_cover == Cover::Black ? Qt::black : Qt::white);
        return;
    }
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_spotlight) {
        const double radius = 0.14 * height();
        QPainterPath dark;
        dark.addRect(rect());
        dark.addEllipse(m_at, radius, radius);
        painter.fillPath(dark, QColor(0, 0, 0, 190));
    }
    if (m_lines.empty()) return;
    // A halo, so that the line is seen on any picture.
    const ThemeColors& colors = Theme::current().colors();
    for (const auto& [color, width] : {std::pair{colors.view, 9.0}, {colors.failed, 5.0}}) {
        painter.setPen(QPen(color, width * height() / 1080, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        for (const QPolygonF& line : m_lines) painter.drawPolyline(line);
    }
}

void PenLayer::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) m_lines.push_back({event->position(), event->position()});
}

void PenLayer::mouseMoveEvent(QMouseEvent* event) {
    if (!(event->buttons() & Qt::LeftButton) || m_lines.empty()) return;
    m_lines.back() << event->position();
    update();
}

}  // namespace app
