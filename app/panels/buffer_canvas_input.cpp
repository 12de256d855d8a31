// The mouse and the keys of a BufferCanvas.
#include <QApplication>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/panels/buffer_canvas.h"
#include "app/panels/canvas_flip.h"

namespace app {

void BufferCanvas::wheelEvent(QWheelEvent* event) {
    constexpr int kStep = 120;  // eighths of a degree
    m_wheel += event->angleDelta().y();
    const int steps = m_wheel / kStep;
    m_wheel %= kStep;
    if (steps != 0 && !m_content.size.isEmpty()) setZoom(nextZoom(zoom(), steps), event->position());
    event->accept();
}

void BufferCanvas::mousePressEvent(QMouseEvent* event) {
    m_pressed = event->position();
    m_dragFrom = m_placement.origin;
    m_drags = false;
    constexpr auto kBoth = Qt::ControlModifier | Qt::ShiftModifier;
    m_measures = event->button() == Qt::RightButton ||
                 (event->button() == Qt::LeftButton && (event->modifiers() & kBoth) == kBoth);
    m_wipes = isOnHandle(m_wipe, rect(), m_pressed);
}

void BufferCanvas::mouseMoveEvent(QMouseEvent* event) {
    if (m_wipes && event->buttons()) return emit wiped(std::clamp(event->position().x() / width(), 0.0, 1.0));
    setCursor(isOnHandle(m_wipe, rect(), event->position()) ? Qt::SplitHCursor : Qt::CrossCursor);
    if (m_measures && event->buttons()) return dragRegion(event->position());
    if (event->buttons() & (Qt::LeftButton | Qt::MiddleButton)) {
        const QPointF by = event->position() - m_pressed;
        if (event->modifiers() & Qt::ControlModifier) {
            if (const auto pixel = pixelAt(event->position())) emit picked(*pixel);
            m_drags = true;
        } else if (m_drags || by.manhattanLength() >= QApplication::startDragDistance()) {
            m_drags = true;
            m_fits = false;
            m_part.reset();
            place({m_dragFrom + by, m_placement.zoom});
            emit moved();
            return;
        }
    }
    emit hovered(pixelAt(event->position()));
}

void BufferCanvas::mouseReleaseEvent(QMouseEvent* event) {
    if (std::exchange(m_measures, false)) {
        const QPointF moved = event->position() - m_pressed;
        const bool isClick = moved.manhattanLength() < QApplication::startDragDistance();
        if (isClick && event->button() == Qt::RightButton) emit menuAsked(event->globalPosition().toPoint());
        return;
    }
    if (event->button() != Qt::LeftButton || m_drags || std::exchange(m_wipes, false)) return;
    if (const auto pixel = pixelAt(event->position())) emit picked(*pixel);
}

// As it is placed, and then turned: a pixel's upper border is its own, also of one that stands upside down.
QPoint BufferCanvas::pixelUnder(QPointF widget) const {
    const QPointF p = m_placement.toPicture(widget);
    const QPoint pixel(int(std::floor(p.x())), int(std::floor(p.y())));
    return m_flipped ? upsideDown(pixel, m_content.size.height()) : pixel;
}

std::optional<QPoint> BufferCanvas::pixelAt(QPointF widget) const {
    const QPoint pixel = pixelUnder(widget);
    if (!QRect(QPoint(0, 0), m_content.size).contains(pixel)) return {};
    return pixel;
}

// From where it was pressed, within the picture.
void BufferCanvas::dragRegion(QPointF to) {
    if ((to - m_pressed).manhattanLength() < QApplication::startDragDistance() || m_content.size.isEmpty()) return;
    const auto pixel = [this](QPointF at) {
        const QPoint p = pixelUnder(at);
        return QPoint(std::clamp(p.x(), 0, m_content.size.width() - 1),
                      std::clamp(p.y(), 0, m_content.size.height() - 1));
    };
    const QPoint a = pixel(m_pressed), b = pixel(to);
    emit regionDragged(QRect(QPoint(std::min(a.x(), b.x()), std::min(a.y(), b.y())),
                             QPoint(std::max(a.x(), b.x()), std::max(a.y(), b.y()))));
}

void BufferCanvas::leaveEvent(QEvent*) { emit hovered(std::nullopt); }

void BufferCanvas::keyPressEvent(QKeyEvent* event) {
    const int step = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
    switch (event->modifiers() & Qt::ControlModifier ? 0 : event->key()) {
        case Qt::Key_Left: emit nudged({-step, 0}); return;
        case Qt::Key_Right: emit nudged({step, 0}); return;
        case Qt::Key_Up: emit nudged({0, m_flipped ? step : -step}); return;
        case Qt::Key_Down: emit nudged({0, m_flipped ? -step : step}); return;
        case Qt::Key_Plus: stepZoom(1); return;
        case Qt::Key_Minus: stepZoom(-1); return;
        default: QWidget::keyPressEvent(event);
    }
}

}  // namespace app
