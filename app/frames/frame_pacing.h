#pragma once
#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <set>

namespace app {

// When the next frame may be requested while a slider or a handle is dragged: after the frame before it, and after the
// views have begun to draw that one, so that no core computes frames that nobody sees.
class FramePacing : public QObject {
    Q_OBJECT
public:
    explicit FramePacing(QObject* parent = nullptr);

    void setLive(bool live);  // true with each step of a drag, false at its end
    bool isLive() const { return m_live; }
    bool isMoving() const { return m_moving.isActive(); }  // from a step of a drag until some time after the last one
    void stopMoving() { m_moving.stop(); }
    // `who` has not begun to draw the newest frame. A request waits for it, but not longer than 1/60 s.
    void hold(const QObject* who, bool holds);
    // Whether a request has to wait, for the views or for the frame that is being computed. due() comes for the views.
    bool waits(bool computes);
    void dueNow();         // due() in the next turn of the event loop
    void takeTurn();       // the request that waited is being made
    void countFromHere();  // the newest request has been sent

signals:
    void due();
    void rested();

private:
    bool m_live = false;
    QTimer m_moving;
    std::set<const QObject*> m_holding;
    QTimer m_held;                 // a waiting request
    QElapsedTimer m_sinceRequest;  // since the newest request
};

}  // namespace app
