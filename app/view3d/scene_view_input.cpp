// The mouse and the keys of a SceneView.
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "app/view3d/scene_view.h"

namespace app {

namespace {

constexpr double kDegreesPerPixel = 0.4, kKeyStep = 5, kWheelStep = 1.15, kClickSlop = 4;

}  // namespace

std::optional<Hit> SceneView::hitAt(QPointF position) const {
    if (!shown() || isPoint() || isMoving()) return {};
    auto hit = firstHit(*shown(), rayThrough(m_camera, viewFrame().size, {position.x(), position.y()}));
    if (hit) hit->at = shown()->map.toWorld(hit->at);
    return hit;
}

// One drag at a time: other buttons do nothing meanwhile. A press of its own button again says that the release went elsewhere.
void SceneView::mousePressEvent(QMouseEvent* event) {
    if (m_drag != Drag::None && event->button() != m_button) return;
    if (isDragging()) endDrag();
    endMove();
    m_drag = Drag::None;
    m_button = event->button();
    m_pressedAt = m_last = event->position();
    const bool shift = event->modifiers() & Qt::ShiftModifier, control = event->modifiers() & Qt::ControlModifier;
    if (event->button() == Qt::LeftButton && beginDrag(event->position())) {
        m_drag = Drag::Handle;
    } else if (event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && shift)) {
        m_drag = Drag::Pan;
    } else if (event->button() == Qt::RightButton) {
        m_drag = Drag::Click;
    } else if (event->button() == Qt::LeftButton) {
        m_drag = control && !isPoint() ? Drag::Pick : Drag::Click;
        if (const auto hit = hitAt(event->position()); hit && m_drag == Drag::Pick) emit clicked(*hit);
    }
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
    // Released where this view was not told of it, as in a dialog that a key has opened.
    if (m_drag != Drag::None && !(event->buttons() & m_button)) cancelDrag();
    const QPointF position = event->position(), d = position - m_last;
    if (m_drag == Drag::Handle) return dragTo(position, event->modifiers());
    if (m_drag == Drag::None) {
        findHandle(position);
        if (m_content && !isPoint()) emit hovered(hitAt(position));
        return;
    }
    if (m_drag == Drag::Pick) {
        if (const auto hit = hitAt(position)) emit clicked(*hit);
        return;
    }
    // A click may tremble by a few pixels before it is a drag.
    if (m_drag == Drag::Click && (position - m_pressedAt).manhattanLength() < kClickSlop) return;
    if (m_button == Qt::RightButton) return void(m_drag = Drag::None);  // it picks, and drags nothing
    if (m_drag == Drag::Click) m_drag = Drag::Orbit;
    m_last = position;
    m_flight.stop();
    m_touched = true;
    if (m_drag == Drag::Orbit)
        orbit(m_camera, -d.x() * kDegreesPerPixel, d.y() * kDegreesPerPixel);
    else
        pan(m_camera, {d.x(), d.y()}, viewFrame().size);
    refresh();
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
    if (m_drag == Drag::None || event->button() != m_button) return;
    if (isDragging()) return endDrag();
    const bool picks = m_drag == Drag::Click;
    m_drag = Drag::None;
    updateOverlay();  // labels take the places that they have at rest
    if (!picks) return;
    if (const auto hit = hitAt(event->position())) emit clicked(*hit);
}

void SceneView::leaveEvent(QEvent* event) {
    QWidget::leaveEvent(event);
    if (m_drag == Drag::None) findHandle({-1e6, -1e6});
    emit left();
}

void SceneView::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / 120.0;
    if (!shown() || notches == 0) return;
    m_flight.stop();
    endMove();
    m_touched = true;
    zoomAt(m_camera, std::pow(kWheelStep, -notches), {event->position().x(), event->position().y()}, viewFrame().size);
    refresh();
    event->accept();
}

void SceneView::keyPressEvent(QKeyEvent* event) {
    const bool plain = !(event->modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier));
    if (m_drag == Drag::Handle && dragKey(event->key(), event->modifiers())) return;
    if (plain && event->key() == Qt::Key_S) return emit spaceAsked(event->modifiers() & Qt::ShiftModifier ? -1 : 1);
    if (plain && event->key() == Qt::Key_F) return emit faceAsked(event->modifiers() & Qt::ShiftModifier ? -1 : 1);
    if (!plain || !shown()) return QWidget::keyPressEvent(event);
    endMove();
    if (!keyAction(event->key())) QWidget::keyPressEvent(event);
}

bool SceneView::keyAction(int key) {
    const auto turn = [this](double aroundZ, double overTop) {
        OrbitCamera camera = m_camera;
        orbit(camera, aroundZ, overTop);
        setCamera(camera);
    };
    const auto zoom = [this](double factor) {
        OrbitCamera camera = m_camera;
        zoomAt(camera, factor, viewFrame().size / 2.0, viewFrame().size);
        setCamera(camera);
    };
    switch (key) {
        case Qt::Key_1: go(ViewPreset::Front); return true;
        case Qt::Key_3: go(ViewPreset::Side); return true;
        case Qt::Key_7: go(ViewPreset::Top); return true;
        case Qt::Key_9:
        case Qt::Key_Return:
        case Qt::Key_Enter:
        case Qt::Key_R: go(ViewPreset::Iso); return true;
        case Qt::Key_0: go(ViewPreset::Eye); return true;
        case Qt::Key_A: go(ViewPreset::Everything); return true;
        case Qt::Key_Z: zoomOut(); return true;
        case Qt::Key_5: setOrthographic(!m_camera.orthographic); return true;
        case Qt::Key_M: {
            ViewOptions options = m_options;
            options.objectTool = HandleTool((int(options.objectTool) + 1) % 3);
            setOptions(options);
            emit optionsChanged();
            return true;
        }
        case Qt::Key_Left: turn(-kKeyStep, 0); return true;
        case Qt::Key_Right: turn(kKeyStep, 0); return true;
        case Qt::Key_Up: turn(0, kKeyStep); return true;
        case Qt::Key_Down: turn(0, -kKeyStep); return true;
        case Qt::Key_Plus:
        case Qt::Key_Equal: zoom(1 / kWheelStep); return true;
        case Qt::Key_Minus: zoom(kWheelStep); return true;
        default: return false;
    }
}

}  // namespace app
