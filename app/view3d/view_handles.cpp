#include "app/view3d/view_handles.h"

#include <QCursor>
#include <algorithm>

#include "app/view3d/handle_painter.h"
#include "app/view3d/scene_view.h"

namespace app {

namespace {

constexpr double kHotReach = 64;  // pixels of the design around a handle within which its arms stay
constexpr double kBelowArms = 48, kHandleRadius = 12;

glm::dvec2 toVector(QPointF p) { return {p.x(), p.y()}; }

}  // namespace

ViewHandles::ViewHandles(SceneView& view) : m_view(view) {}

bool ViewHandles::areShown() const {
    const ShownSpace& space = m_view.space();
    return m_view.options().handles && !space.isPoint() && space.shown() && !space.isMoving();
}

HandleView ViewHandles::onScreen() const { return handleView(m_view.viewFrame(), m_view.space().shown()->map); }

void ViewHandles::set(std::vector<Handle> handles) {
    if (handles.size() != m_handles.size()) m_hot.reset();
    m_handles = std::move(handles);
    m_view.updateWithPicture();
}

void ViewHandles::setNumbers(const QString& text) {
    m_numbers = text;
    m_view.updateOverlay();
}

void ViewHandles::find(QPointF position) {
    const std::optional<std::size_t> before = m_hot;
    std::optional<Grip> grip;
    if (areShown()) {
        const HandleView view = onScreen();
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
    m_cursor = position;
    if (!m_hot && !before) return;
    grip&& holds(m_handles[*m_hot], grip->arm) ? m_view.setCursor(Qt::SizeAllCursor) : m_view.unsetCursor();
    emit hovered(grip ? &m_handles[*m_hot] : nullptr);
    m_view.updateOverlay();
}

bool ViewHandles::begin(QPointF position) {
    m_cursor = m_pressedAt = position;
    if (!areShown()) return false;
    m_heldView = onScreen();
    const auto grip = gripAt(m_handles, m_hot, m_heldView, toVector(position));
    if (!grip || !holds(m_handles[grip->handle], grip->arm)) return false;
    m_hot = grip->handle;
    m_arm = grip->arm;
    m_held = m_handles[*m_hot];
    m_heldAt = m_held.value;
    m_isDragging = true;
    m_view.camera().touch();  // a moved light would turn the view that frames it
    m_view.updateOverlay();
    return true;
}

void ViewHandles::dragTo(QPointF position, Qt::KeyboardModifiers modifiers) {
    m_cursor = position;
    // A click may tremble.
    constexpr double kSlop = 3;
    if (m_heldAt == m_held.value && (position - m_pressedAt).manhattanLength() < kSlop) return;
    const DragStep step = modifiers & Qt::ControlModifier ? DragStep::Coarse
                          : modifiers & Qt::ShiftModifier ? DragStep::Fine
                                                          : DragStep::Usual;
    m_heldAt = draggedTo(m_held, m_arm, m_heldView, toVector(m_pressedAt), toVector(position - m_pressedAt), step);
    emit dragged(m_held, m_heldAt, false);
    m_view.updateOverlay();
}

bool ViewHandles::end() {
    m_isDragging = false;
    emit dragged(m_held, m_heldAt, true);
    return m_heldAt != m_held.value;
}

void ViewHandles::cancel() {
    m_isDragging = false;
    emit cancelled(m_held);
    find(m_cursor);
}

// x, y and z hold it to an arm, and let go of it again; Esc puts it back.
bool ViewHandles::press(int key, Qt::KeyboardModifiers modifiers) {
    if (key == Qt::Key_Escape) {
        cancel();
        return true;
    }
    if (key != Qt::Key_X && key != Qt::Key_Y && key != Qt::Key_Z) return false;
    const auto arm = std::size_t(key - Qt::Key_X);
    if (arm >= m_held.arms.size()) return true;
    const bool letGo = m_arm == arm && holds(m_held, std::nullopt);
    m_arm = letGo ? std::nullopt : std::optional(arm);
    dragTo(m_cursor, modifiers);
    return true;
}

std::vector<QRectF> ViewHandles::places() const {
    std::vector<QRectF> places;
    if (!areShown()) return places;
    const HandleView view = onScreen();
    const double r = kHandleRadius * view.view.scale;  // its border included
    for (const Handle& handle : m_handles) {
        const glm::dvec2 at = placeOf(view, handle.at).at;
        places.push_back({at.x - r, at.y - r, 2 * r, 2 * r});
    }
    return places;
}

void ViewHandles::paint(QPainter& painter) const {
    if (!areShown()) return;
    const HandleView view = onScreen();
    const auto isHeld = [&](const Handle& handle) {
        return m_isDragging && handle.kind == m_held.kind && handle.index == m_held.index;
    };
    for (std::size_t i = 0; i < m_handles.size(); ++i)
        if (!isHeld(m_handles[i])) paintHandle(painter, m_handles[i], view, !m_isDragging && m_hot == i, m_arm);
    if (m_isDragging) {  // never late, though the picture may be
        Handle held = m_held;
        if (held.tool == HandleTool::Move) held.at = m_heldAt;
        paintHandle(painter, held, view, true, m_arm);
    }
    if (m_numbers.isEmpty()) return;
    // Below the arms, which they would cover.
    QPointF beside = m_cursor;
    if (m_hot && *m_hot < m_handles.size() && !m_handles[*m_hot].arms.empty())
        beside.setY(std::max(beside.y(), placeOf(view, m_handles[*m_hot].at).at.y + kBelowArms * view.view.scale));
    paintNumbers(painter, m_numbers, beside, view.view);
}

}  // namespace app
