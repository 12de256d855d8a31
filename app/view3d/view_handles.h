#pragma once
#include <QObject>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <optional>
#include <vector>

#include "app/view3d/handle_drag.h"

class QPainter;

namespace app {

class SceneView;

// The handles of a 3D view: which one the cursor is near, and what a drag does. During a drag x, y and z hold the handle
// to an arm, Shift drags finely, Ctrl in coarse steps, and Esc puts it back.
class ViewHandles : public QObject {
    Q_OBJECT
public:
    explicit ViewHandles(SceneView& view);

    // What can be dragged, of what is shown. A dragged handle stays as it was at the press.
    void set(std::vector<Handle> handles);
    const std::vector<Handle>& all() const { return m_handles; }
    // Painted beside the cursor while a handle is dragged or the cursor is on one.
    void setNumbers(const QString& text);
    const QString& numbers() const { return m_numbers; }

    void find(QPointF position);  // the one near the cursor
    bool begin(QPointF position);
    bool isDragging() const { return m_isDragging; }
    void dragTo(QPointF position, Qt::KeyboardModifiers modifiers);
    bool press(int key, Qt::KeyboardModifiers modifiers);  // during a drag; true: the key is a handle's
    bool end();                                            // whether the drag changed the value
    void cancel();                                         // the handle goes back

    std::vector<QRectF> places() const;  // on the view, each with its border
    void paint(QPainter& painter) const;

signals:
    // The handle, as it was at the press, is to have this value; `done` with the button's release.
    void dragged(const app::Handle& handle, app::Vec3d value, bool done);
    void cancelled(const app::Handle& handle);
    void hovered(const app::Handle* handle);  // null: none any more

private:
    bool areShown() const;
    HandleView onScreen() const;  // only if something is shown

    SceneView& m_view;
    std::vector<Handle> m_handles;
    QString m_numbers;
    QPointF m_cursor, m_pressedAt;
    std::optional<std::size_t> m_hot;  // the handle that the cursor is near
    std::optional<std::size_t> m_arm;  // that the cursor is on or holds
    bool m_isDragging = false;
    Handle m_held;          // as it was at the press
    Vec3d m_heldAt{0.0};    // its value now
    HandleView m_heldView;  // at the press: a space may change with what is dragged in it
};

}  // namespace app
