#include "app/view3d/view_input.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "app/view3d/scene_view.h"

namespace app {

namespace {

constexpr double kDegreesPerPixel = 0.4, kKeyStep = 5, kWheelStep = 1.15, kClickSlop = 4;

}  // namespace

ViewInput::ViewInput(SceneView& view) : m_view(view) { view.installEventFilter(this); }

bool ViewInput::eventFilter(QObject*, QEvent* event) {
    switch (event->type()) {
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick: return press(*static_cast<QMouseEvent*>(event)), true;
        case QEvent::MouseMove: return move(*static_cast<QMouseEvent*>(event)), true;
        case QEvent::MouseButtonRelease: return release(*static_cast<QMouseEvent*>(event)), true;
        case QEvent::Wheel: return wheel(*static_cast<QWheelEvent*>(event)), true;
        case QEvent::KeyPress: return key(*static_cast<QKeyEvent*>(event));
        case QEvent::Leave: leave(); break;
        default: break;
    }
    return false;
}

bool ViewInput::isHeld() const { return m_drag != Drag::None || m_view.handles().isDragging(); }

std::optional<Hit> ViewInput::hitAt(QPointF position) const {
    const ShownSpace& space = m_view.space();
    if (!space.shown() || space.isPoint() || space.isMoving()) return {};
    const ViewFrame frame = m_view.viewFrame();
    auto hit = firstHit(*space.shown(), rayThrough(frame.camera, frame.size, {position.x(), position.y()}));
    if (hit) hit->at = space.shown()->map.toWorld(hit->at);
    return hit;
}

// One drag at a time: other buttons do nothing meanwhile. A press of its own button again says that the release went
// elsewhere.
void ViewInput::press(const QMouseEvent& event) {
    if (isHeld() && event.button() != m_button) return;
    if (m_view.handles().isDragging()) endHandle();
    m_view.space().endMove();
    m_drag = Drag::None;
    m_button = event.button();
    m_pressedAt = m_last = event.position();
    const bool shift = event.modifiers() & Qt::ShiftModifier, control = event.modifiers() & Qt::ControlModifier;
    if (event.button() == Qt::LeftButton && m_view.handles().begin(event.position())) return;
    if (event.button() == Qt::MiddleButton || (event.button() == Qt::LeftButton && shift)) {
        m_drag = Drag::Pan;
    } else if (event.button() == Qt::RightButton) {
        m_drag = Drag::Click;
    } else if (event.button() == Qt::LeftButton) {
        m_drag = control && !m_view.space().isPoint() ? Drag::Pick : Drag::Click;
        if (const auto hit = hitAt(event.position()); hit && m_drag == Drag::Pick) emit clicked(*hit);
    }
}

void ViewInput::move(const QMouseEvent& event) {
    // Released where this view was not told of it, as in a dialog that a key has opened.
    if (isHeld() && !(event.buttons() & m_button)) cancelDrag();
    const QPointF position = event.position(), d = position - m_last;
    if (m_view.handles().isDragging()) {
        m_last = position;
        return m_view.handles().dragTo(position, event.modifiers());
    }
    if (m_drag == Drag::None) {
        m_last = position;
        m_view.handles().find(position);
        if (m_view.space().content() && !m_view.space().isPoint()) emit hovered(hitAt(position));
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
    m_view.camera().change([&](OrbitCamera& camera) {
        if (m_drag == Drag::Orbit)
            orbit(camera, -d.x() * kDegreesPerPixel, d.y() * kDegreesPerPixel);
        else
            pan(camera, {d.x(), d.y()}, m_view.viewFrame().size);
    });
}

void ViewInput::release(const QMouseEvent& event) {
    if (!isHeld() || event.button() != m_button) return;
    if (m_view.handles().isDragging()) return endHandle();
    const bool picks = m_drag == Drag::Click;
    m_drag = Drag::None;
    m_view.updateOverlay();  // labels take the places that they have at rest
    if (!picks) return;
    if (const auto hit = hitAt(event.position())) emit clicked(*hit);
}

void ViewInput::endHandle() {
    const bool hasMoved = m_view.handles().end();
    if (const auto hit = hitAt(m_last); hit && !hasMoved) emit clicked(*hit);
    m_view.handles().find(m_last);
}

void ViewInput::cancelDrag() {
    m_drag = Drag::None;
    m_view.handles().isDragging() ? m_view.handles().cancel() : m_view.updateOverlay();
}

void ViewInput::leave() {
    if (!isHeld()) m_view.handles().find({-1e6, -1e6});
    emit left();
}

void ViewInput::wheel(QWheelEvent& event) {
    const double notches = event.angleDelta().y() / 120.0;
    if (!m_view.space().shown() || notches == 0) return;
    m_view.space().endMove();
    m_view.camera().change([&](OrbitCamera& camera) {
        zoomAt(camera, std::pow(kWheelStep, -notches), {event.position().x(), event.position().y()},
               m_view.viewFrame().size);
    });
    event.accept();
}

bool ViewInput::key(const QKeyEvent& event) {
    const bool plain = !(event.modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier));
    const int step = event.modifiers() & Qt::ShiftModifier ? -1 : 1;
    if (m_view.handles().isDragging() && m_view.handles().press(event.key(), event.modifiers())) return true;
    if (plain && event.key() == Qt::Key_S) return emit spaceAsked(step), true;
    if (plain && event.key() == Qt::Key_F) return emit faceAsked(step), true;
    if (!plain || !m_view.space().shown()) return false;
    m_view.space().endMove();
    return act(event.key());
}

bool ViewInput::act(int key) {
    ViewCamera& camera = m_view.camera();
    const auto turn = [&](double aroundZ, double overTop) {
        camera.change([&](OrbitCamera& now) { orbit(now, aroundZ, overTop); });
        return true;
    };
    const auto zoom = [&](double factor) {
        const glm::dvec2 size = m_view.viewFrame().size;
        camera.change([&](OrbitCamera& now) { zoomAt(now, factor, size / 2.0, size); });
        return true;
    };
    switch (key) {
        case Qt::Key_1: return camera.go(ViewPreset::Front), true;
        case Qt::Key_3: return camera.go(ViewPreset::Side), true;
        case Qt::Key_7: return camera.go(ViewPreset::Top), true;
        case Qt::Key_9:
        case Qt::Key_Return:
        case Qt::Key_Enter:
        case Qt::Key_R: return camera.go(ViewPreset::Iso), true;
        case Qt::Key_0: return camera.go(ViewPreset::Eye), true;
        case Qt::Key_A: return camera.go(ViewPreset::Everything), true;
        case Qt::Key_Z: return camera.zoomOut(), true;
        case Qt::Key_5: return camera.setOrthographic(!camera.now().orthographic), true;
        case Qt::Key_M: {
            ViewOptions options = m_view.options();
            options.objectTool = HandleTool((int(options.objectTool) + 1) % 3);
            return m_view.changeOptions(options), true;
        }
        case Qt::Key_Left: return turn(-kKeyStep, 0);
        case Qt::Key_Right: return turn(kKeyStep, 0);
        case Qt::Key_Up: return turn(0, kKeyStep);
        case Qt::Key_Down: return turn(0, -kKeyStep);
        case Qt::Key_Plus:
        case Qt::Key_Equal: return zoom(1 / kWheelStep);
        case Qt::Key_Minus: return zoom(kWheelStep);
        default: return false;
    }
}

}  // namespace app
