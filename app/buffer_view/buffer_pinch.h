#pragma once
#include <QObject>
#include <QPointF>

namespace app {

class BufferView;

// Pinching with two fingers zooms a view's picture about the point between them, in the steps of the wheel.
class PinchZoom : public QObject {
public:
    explicit PinchZoom(BufferView& view);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void pinch(double by, QPointF at);  // by: a factor

    BufferView& m_view;
    double m_pinched = 1;  // the part of a pinch that is smaller than a step
};

}  // namespace app
