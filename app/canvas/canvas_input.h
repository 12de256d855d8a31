#pragma once
#include <QObject>
#include <QPointF>
#include <QRect>
#include <optional>

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace app {

class BufferCanvas;

// The mouse and the keys of a canvas: zooms and moves the picture, and reports other input by signals. Pixels count
// rows from the top.
class CanvasInput : public QObject {
    Q_OBJECT
public:
    explicit CanvasInput(BufferCanvas& canvas);

signals:
    void picked(QPoint pixel);
    void regionDragged(QRect region);  // with the right button, or Ctrl and Shift
    void menuAsked(QPoint at);         // right button without a drag; a place on the screen
    void nudged(QPoint by);            // arrow keys: 1, with Shift 10
    void hovered(std::optional<QPoint> pixel);
    void wiped(double share);  // by the handle between two pictures

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void turn(const QWheelEvent& event);
    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    bool pressKey(const QKeyEvent& event);  // false for one that does nothing here
    void dragRegion(QPointF to);

    BufferCanvas& m_canvas;
    QPointF m_pressed, m_dragFrom;
    bool m_drags = false, m_wipes = false, m_measures = false;
    int m_wheel = 0;  // the part of a turn that is smaller than a step
};

}  // namespace app
