#pragma once
#include <QObject>
#include <QPointF>

namespace app {

class BufferView;

// Two fingers on a touchpad or on the screen zoom a view's picture, in the zooms of the wheel, about what is between them.
class PinchZoom : public QObject {
public:
    explicit PinchZoom(BufferView& view);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void pinch(double by, QPointF at);  // by: a factor

    BufferView& m_view;
    double m_pinched = 1;  // what is left of a pinch by less than a zoom
};

}  // namespace app
