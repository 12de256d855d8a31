#include "app/canvas/canvas_input.h"

#include <QApplication>
#include <QMouseEvent>
#include <algorithm>
#include <utility>

#include "app/canvas/buffer_canvas.h"

namespace app {

CanvasInput::CanvasInput(BufferCanvas& canvas) : m_canvas(canvas) { canvas.installEventFilter(this); }

bool CanvasInput::eventFilter(QObject*, QEvent* event) {
    if (event->type() == QEvent::Leave) emit hovered(std::nullopt);
    if (!m_canvas.isEnabled()) return false;
    switch (event->type()) {
        case QEvent::Wheel: turn(*static_cast<QWheelEvent*>(event)); break;
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick: press(*static_cast<QMouseEvent*>(event)); break;
        case QEvent::MouseMove: move(*static_cast<QMouseEvent*>(event)); break;
        case QEvent::MouseButtonRelease: release(*static_cast<QMouseEvent*>(event)); break;
        case QEvent::KeyPress:
            if (!pressKey(*static_cast<QKeyEvent*>(event))) return false;
            break;
        default: return false;
    }
    event->accept();
    return true;
}

void CanvasInput::turn(const QWheelEvent& event) {
    constexpr int kStep = 120;  // eighths of a degree
    m_wheel += event.angleDelta().y();
    const int steps = m_wheel / kStep;
    m_wheel %= kStep;
    CanvasPlacing& placing = m_canvas.placing();
    if (steps != 0 && !m_canvas.content().size.isEmpty())
        placing.setZoom(CanvasPlacing::nextZoom(placing.zoom(), steps), event.position());
}

void CanvasInput::press(const QMouseEvent& event) {
    m_pressed = event.position();
    m_dragFrom = m_canvas.placing().placement().origin;
    m_drags = false;
    constexpr auto kBoth = Qt::ControlModifier | Qt::ShiftModifier;
    m_measures =
        event.button() == Qt::RightButton || (event.button() == Qt::LeftButton && (event.modifiers() & kBoth) == kBoth);
    m_wipes = isOnHandle(m_canvas.wipe(), m_canvas.rect(), m_pressed);
}

void CanvasInput::move(const QMouseEvent& event) {
    const QPointF at = event.position();
    if (m_wipes && event.buttons()) return emit wiped(std::clamp(at.x() / m_canvas.width(), 0.0, 1.0));
    m_canvas.setCursor(isOnHandle(m_canvas.wipe(), m_canvas.rect(), at) ? Qt::SplitHCursor : Qt::CrossCursor);
    if (m_measures && event.buttons()) return dragRegion(at);
    if (event.buttons() & (Qt::LeftButton | Qt::MiddleButton)) {
        const QPointF by = at - m_pressed;
        if (event.modifiers() & Qt::ControlModifier) {
            if (const auto pixel = m_canvas.placing().pixelAt(at)) emit picked(*pixel);
            m_drags = true;
        } else if (m_drags || by.manhattanLength() >= QApplication::startDragDistance()) {
            m_drags = true;
            return m_canvas.placing().drag(m_dragFrom + by);
        }
    }
    emit hovered(m_canvas.placing().pixelAt(at));
}

void CanvasInput::release(const QMouseEvent& event) {
    if (std::exchange(m_measures, false)) {
        const QPointF moved = event.position() - m_pressed;
        const bool isClick = moved.manhattanLength() < QApplication::startDragDistance();
        if (isClick && event.button() == Qt::RightButton) emit menuAsked(event.globalPosition().toPoint());
        return;
    }
    if (event.button() != Qt::LeftButton || m_drags || std::exchange(m_wipes, false)) return;
    if (const auto pixel = m_canvas.placing().pixelAt(event.position())) emit picked(*pixel);
}

// From where it was pressed, within the picture.
void CanvasInput::dragRegion(QPointF to) {
    const QSize size = m_canvas.content().size;
    if ((to - m_pressed).manhattanLength() < QApplication::startDragDistance() || size.isEmpty()) return;
    const auto pixel = [&](QPointF at) {
        const QPoint p = m_canvas.placing().pixelUnder(at);
        return QPoint(std::clamp(p.x(), 0, size.width() - 1), std::clamp(p.y(), 0, size.height() - 1));
    };
    const QPoint a = pixel(m_pressed), b = pixel(to);
    emit regionDragged(QRect(QPoint(std::min(a.x(), b.x()), std::min(a.y(), b.y())),
                             QPoint(std::max(a.x(), b.x()), std::max(a.y(), b.y()))));
}

bool CanvasInput::pressKey(const QKeyEvent& event) {
    if (event.modifiers() & Qt::ControlModifier) return false;
    const int step = event.modifiers() & Qt::ShiftModifier ? 10 : 1;
    CanvasPlacing& placing = m_canvas.placing();
    const int down = placing.isFlipped() ? -step : step;
    const auto zoom = [&](int steps) { placing.setZoom(CanvasPlacing::nextZoom(placing.zoom(), steps)); };
    switch (event.key()) {
        case Qt::Key_Left: emit nudged({-step, 0}); return true;
        case Qt::Key_Right: emit nudged({step, 0}); return true;
        case Qt::Key_Up: emit nudged({0, -down}); return true;
        case Qt::Key_Down: emit nudged({0, down}); return true;
        case Qt::Key_Plus: zoom(1); return true;
        case Qt::Key_Minus: zoom(-1); return true;
        default: return false;
    }
}

}  // namespace app
