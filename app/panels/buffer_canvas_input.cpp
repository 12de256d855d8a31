// What the mouse and the keys do in a BufferCanvas.
#include <QApplication>
#include <QMouseEvent>
#include <algorithm>
#include <utility>

#include "app/panels/buffer_canvas.h"

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
    m_wipes = isOnHandle(m_wipe, rect(), m_pressed);
}

void BufferCanvas::mouseMoveEvent(QMouseEvent* event) {
    if (m_wipes && event->buttons()) return emit wiped(std::clamp(event->position().x() / width(), 0.0, 1.0));
    setCursor(isOnHandle(m_wipe, rect(), event->position()) ? Qt::SplitHCursor : Qt::CrossCursor);
    if (event->buttons() & (Qt::LeftButton | Qt::MiddleButton)) {
        const QPointF moved = event->position() - m_pressed;
        if (event->modifiers() & Qt::ControlModifier) {
            if (const auto pixel = pixelAt(event->position())) emit picked(*pixel);
            m_drags = true;
        } else if (m_drags || moved.manhattanLength() >= QApplication::startDragDistance()) {
            m_drags = true;
            m_fits = false;
            m_part.reset();
            place({m_dragFrom + moved, m_placement.zoom});
            return;
        }
    }
    emit hovered(pixelAt(event->position()));
}

void BufferCanvas::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || m_drags || std::exchange(m_wipes, false)) return;
    if (const auto pixel = pixelAt(event->position())) emit picked(*pixel);
}

void BufferCanvas::leaveEvent(QEvent*) { emit hovered(std::nullopt); }

void BufferCanvas::keyPressEvent(QKeyEvent* event) {
    const int step = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
    switch (event->modifiers() & Qt::ControlModifier ? 0 : event->key()) {
        case Qt::Key_Left: emit nudged({-step, 0}); return;
        case Qt::Key_Right: emit nudged({step, 0}); return;
        case Qt::Key_Up: emit nudged({0, -step}); return;
        case Qt::Key_Down: emit nudged({0, step}); return;
        case Qt::Key_Plus: stepZoom(1); return;
        case Qt::Key_Minus: stepZoom(-1); return;
        default: QWidget::keyPressEvent(event);
    }
}

}  // namespace app
