// The handles of a SceneView: what is near the cursor, and what a drag does.
#include <QCursor>
#include <algorithm>

#include "app/view3d/handle_painter.h"
#include "app/view3d/scene_view.h"
#include "app/view3d/view_corner.h"

namespace app {

namespace {

constexpr double kHotReach = 64;  // pixels of the design around a handle within which its arms stay
constexpr double kBelowArms = 48, kHandleRadius = 12;

glm::dvec2 toVector(QPointF p) { return {p.x(), p.y()}; }

}  // namespace

void SceneView::updateOverlay() { m_overlay->update(); }

// What belongs to a picture that is on its way is painted once, with it.
void SceneView::updateWithPicture() {
    if (!m_vtk || m_vtk->isNewest()) updateOverlay();
}

void SceneView::setHandles(std::vector<Handle> handles) {
    if (handles.size() != m_handles.size()) m_hot.reset();
    m_handles = std::move(handles);
    updateWithPicture();
}

void SceneView::setNumbers(const QString& text) {
    m_numbers = text;
    updateOverlay();
}

HandleView SceneView::handlesOnScreen() const { return handleView(viewFrame(), shown()->map); }

void SceneView::findHandle(QPointF position) {
    const std::optional<std::size_t> before = m_hot;
    std::optional<Grip> grip;
    if (showsHandles()) {
        const HandleView view = handlesOnScreen();
        grip = gripAt(m_handles, m_hot, view, toVector(position));
        const bool gone = !grip && m_hot &&
                          (*m_hot >= m_handles.size() || glm::length(placeOf(view, m_handles[*m_hot].at).at -
                                                                     toVector(position)) > kHotReach * view.view.scale);
        if (gone) m_hot.reset();
    } else {
        m_hot.reset();
    }
    m_arm = grip ? grip->arm : std::nullopt;
    if (grip) m_hot = grip->handle;
    m_last = position;
    if (!m_hot && !before) return;
    grip&& holds(m_handles[*m_hot], grip->arm) ? setCursor(Qt::SizeAllCursor) : unsetCursor();
    emit handleHovered(grip ? &m_handles[*m_hot] : nullptr);
    updateOverlay();
}

bool SceneView::beginDrag(QPointF position) {
    if (!showsHandles()) return false;
    m_heldView = handlesOnScreen();
    const auto grip = gripAt(m_handles, m_hot, m_heldView, toVector(position));
    if (!grip || !holds(m_handles[grip->handle], grip->arm)) return false;
    m_flight.stop();
    m_hot = grip->handle;
    m_arm = grip->arm;
    m_held = m_handles[*m_hot];
    m_heldAt = m_held.value;
    m_touched = true;  // a moved light would turn the view that frames it
    updateOverlay();
    return true;
}

void SceneView::dragTo(QPointF position, Qt::KeyboardModifiers modifiers) {
    m_last = position;
    // A click may tremble.
    constexpr double kSlop = 3;
    if (m_heldAt == m_held.value && (position - m_pressedAt).manhattanLength() < kSlop) return;
    const DragStep step = modifiers & Qt::ControlModifier ? DragStep::Coarse
                          : modifiers & Qt::ShiftModifier ? DragStep::Fine
                                                          : DragStep::Usual;
    m_heldAt = draggedTo(m_held, m_arm, m_heldView, toVector(m_pressedAt), toVector(position - m_pressedAt), step);
    emit dragged(m_held, m_heldAt, false);
    updateOverlay();
}

void SceneView::endDrag() {
    m_drag = Drag::None;
    emit dragged(m_held, m_heldAt, true);
    if (const auto hit = hitAt(m_last); hit && m_heldAt == m_held.value) emit clicked(*hit);
    findHandle(m_last);
}

void SceneView::cancelDrag() {
    const bool held = isDragging();
    m_drag = Drag::None;
    if (!held) return updateOverlay();
    emit dragCancelled(m_held);
    findHandle(m_last);
}

// x, y and z hold it to an arm, and let go of it again; Esc puts it back.
bool SceneView::dragKey(int key, Qt::KeyboardModifiers modifiers) {
    if (key == Qt::Key_Escape) {
        cancelDrag();
        return true;
    }
    if (key != Qt::Key_X && key != Qt::Key_Y && key != Qt::Key_Z) return false;
    const auto arm = std::size_t(key - Qt::Key_X);
    if (arm >= m_held.arms.size()) return true;
    const bool letGo = m_arm == arm && holds(m_held, std::nullopt);
    m_arm = letGo ? std::nullopt : std::optional(arm);
    dragTo(m_last, modifiers);
    return true;
}

// Where no word can be read.
std::vector<QRectF> SceneView::takenPlaces() const {
    std::vector<QRectF> places;
    for (const QWidget* corner : {static_cast<QWidget*>(m_legend), static_cast<QWidget*>(m_cube)})
        if (corner->isVisible()) places.emplace_back(corner->geometry());
    if (!showsHandles()) return places;
    const HandleView view = handlesOnScreen();
    const double r = kHandleRadius * view.view.scale;  // its border included
    for (const Handle& handle : m_handles) {
        const glm::dvec2 at = placeOf(view, handle.at).at;
        places.push_back({at.x - r, at.y - r, 2 * r, 2 * r});
    }
    return places;
}

void SceneView::paintHandles(QPainter& painter) const {
    if (!showsHandles()) return;
    const HandleView view = handlesOnScreen();
    const auto isHeld = [&](const Handle& handle) {
        return isDragging() && handle.kind == m_held.kind && handle.index == m_held.index;
    };
    for (std::size_t i = 0; i < m_handles.size(); ++i)
        if (!isHeld(m_handles[i])) paintHandle(painter, m_handles[i], view, !isDragging() && m_hot == i, m_arm);
    if (isDragging()) {  // never late, though the picture may be
        Handle held = m_held;
        if (held.tool == HandleTool::Move) held.at = m_heldAt;
        paintHandle(painter, held, view, true, m_arm);
    }
    if (m_numbers.isEmpty()) return;
    // Below the arms, which they would cover.
    QPointF beside = m_last;
    if (m_hot && *m_hot < m_handles.size() && !m_handles[*m_hot].arms.empty())
        beside.setY(std::max(beside.y(), placeOf(view, m_handles[*m_hot].at).at.y + kBelowArms * view.view.scale));
    paintNumbers(painter, m_numbers, beside, view.view);
}

}  // namespace app
