#include "app/buffer_view/buffer_pinch.h"

#include <QGestureEvent>

#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"

namespace app {

PinchZoom::PinchZoom(BufferView& view) : QObject(&view), m_view(view) {
    view.canvas()->installEventFilter(this);
    view.canvas()->grabGesture(Qt::PinchGesture);
}

bool PinchZoom::eventFilter(QObject*, QEvent* event) {
    if (event->type() == QEvent::NativeGesture) {  // of a touchpad
        const auto& gesture = *static_cast<QNativeGestureEvent*>(event);
        if (gesture.gestureType() != Qt::ZoomNativeGesture) return false;
        pinch(1 + gesture.value(), gesture.position());
        return true;
    }
    if (event->type() != QEvent::Gesture) return false;
    const auto* gesture = static_cast<QGestureEvent*>(event)->gesture(Qt::PinchGesture);
    if (!gesture) return false;
    const auto& pinched = *static_cast<const QPinchGesture*>(gesture);
    pinch(pinched.scaleFactor(), m_view.canvas()->mapFromGlobal(pinched.centerPoint()));
    return true;
}

void PinchZoom::pinch(double by, QPointF at) {
    if (!(by > 0) || m_view.canvas()->content().size.isEmpty()) return;
    m_pinched *= by;
    CanvasPlacing& placing = m_view.canvas()->placing();
    const double zoom = placing.zoom(), next = CanvasPlacing::nextZoom(zoom, m_pinched > 1 ? 1 : -1);
    const double step = next / zoom;
    if (step == 1) m_pinched = 1;  // at either end
    if (step == 1 || (m_pinched > 1 ? m_pinched < step : m_pinched > step)) return;
    m_pinched /= step;
    placing.setZoom(next, at);
}

}  // namespace app
