// The handles of a SceneView: what is near the cursor, and what a drag does.
#include <QCursor>

#include "app/view3d/handle_painter.h"
#include "app/view3d/scene_view.h"

namespace app {

namespace {

constexpr double kHotReach = 64;  // logical pixels around a handle within which its axes stay

glm::dvec2 toVector(QPointF p) { return {p.x(), p.y()}; }

}  // namespace

void SceneView::setHandles(std::vector<Handle> handles) {
    if (handles.size() != m_handles.size()) m_hot.reset();
    m_handles = std::move(handles);
    updateOverlay();
}

void SceneView::setNumbers(const QString& text) {
    m_numbers = text;
    updateOverlay();
}

void SceneView::findHandle(QPointF position) {
    const std::optional<std::size_t> before = m_hot;
    const ViewFrame view = viewFrame();
    const auto grip = showsHandles() ? gripAt(m_handles, m_hot, view, toVector(position)) : std::nullopt;
    m_axis = grip ? grip->axis : DragAxis::Screen;
    if (grip) {
        m_hot = grip->handle;
    } else if (m_hot && *m_hot < m_handles.size()) {
        const glm::dvec2 at = project(view.camera, view.size, m_handles[*m_hot].at).at;
        if (!showsHandles() || glm::length(at - toVector(position)) > kHotReach) m_hot.reset();
    }
    m_last = position;
    if (!m_hot && !before) return;
    grip ? setCursor(Qt::SizeAllCursor) : unsetCursor();
    emit handleHovered(grip ? &m_handles[*m_hot] : nullptr);
    updateOverlay();
}

bool SceneView::beginDrag(QPointF position) {
    if (!showsHandles()) return false;
    const auto grip = gripAt(m_handles, m_hot, viewFrame(), toVector(position));
    if (!grip) return false;
    m_flight.stop();
    m_hot = grip->handle;
    m_axis = grip->axis;
    m_held = m_handles[*m_hot];
    m_heldAt = m_held.at;
    m_touched = true;  // a moved light would turn the view that frames it
    updateOverlay();
    return true;
}

void SceneView::dragTo(QPointF position) {
    m_last = position;
    // A click may tremble.
    constexpr double kSlop = 3;
    if (m_heldAt == m_held.at && (position - m_pressedAt).manhattanLength() < kSlop) return;
    m_heldAt = draggedTo(m_held, m_axis, viewFrame(), toVector(position - m_pressedAt));
    emit dragged(m_held, m_heldAt, false);
    updateOverlay();
}

void SceneView::endDrag() {
    m_drag = Drag::None;
    emit dragged(m_held, m_heldAt, true);
    if (const auto hit = hitAt(m_last); hit && m_heldAt == m_held.at) emit clicked(*hit);
    findHandle(m_last);
}

// x, y and z hold it to an axis, and let go of it again; Esc puts it back.
bool SceneView::dragKey(int key) {
    if (key == Qt::Key_Escape) {
        m_drag = Drag::None;
        emit dragCancelled(m_held);
        findHandle(m_last);
        return true;
    }
    if (key != Qt::Key_X && key != Qt::Key_Y && key != Qt::Key_Z) return false;
    const auto axis = DragAxis(1 + key - Qt::Key_X);
    m_axis = m_axis == axis ? DragAxis::Screen : axis;
    dragTo(m_last);
    return true;
}

void SceneView::paintHandles(QPainter& painter) const {
    if (!showsHandles()) return;
    const ViewFrame view = viewFrame();
    const auto isHeld = [&](const Handle& handle) {
        return isDragging() && handle.kind == m_held.kind && handle.index == m_held.index;
    };
    for (std::size_t i = 0; i < m_handles.size(); ++i)
        if (!isHeld(m_handles[i])) paintHandle(painter, m_handles[i], view, !isDragging() && m_hot == i, m_axis);
    if (isDragging()) {  // never late, though the picture may be
        Handle held = m_held;
        held.at = m_heldAt;
        paintHandle(painter, held, view, true, m_axis);
    }
    if (!m_numbers.isEmpty()) paintNumbers(painter, m_numbers, m_last, view);
}

}  // namespace app
