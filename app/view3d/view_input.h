#pragma once
#include <QObject>
#include <QPointF>
#include <optional>

#include "app/drawing3d/view_content.h"

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace app {

class SceneView;

// The mouse and the keys of a 3D view. Left drag orbits, middle or Shift+left drag pans, the wheel zooms to the cursor; a
// click gives the point under it. Keys: 1 front, 3 side, 7 top, 9 iso, 0 from the eye, Z out of it, 5 orthographic, R the
// first view again, A everything; arrows orbit, + and − zoom; S the next space, F the next face of a point light; M what
// an object's handle does: move, turn, scale.
class ViewInput : public QObject {
    Q_OBJECT
public:
    explicit ViewInput(SceneView& view);

    bool isHeld() const;  // a button is down
    void cancelDrag();    // whatever the mouse holds; a handle goes back

signals:
    void clicked(const app::Hit& hit);  // on a polygon; in world space, whatever space is on show
    void hovered(const std::optional<app::Hit>& hit);
    void left();
    void spaceAsked(int step);  // 1 the next one, −1 the one before
    void faceAsked(int step);   // likewise, of a point light

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    enum class Drag { None, Click, Orbit, Pan, Pick };

    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void leave();
    void wheel(QWheelEvent& event);
    bool key(const QKeyEvent& event);
    bool act(int key);
    std::optional<Hit> hitAt(QPointF position) const;
    void endHandle();

    SceneView& m_view;
    Drag m_drag = Drag::None;
    Qt::MouseButton m_button = Qt::NoButton;  // that began it
    QPointF m_pressedAt, m_last;
};

}  // namespace app
