#pragma once
#include <optional>

#include <QWidget>

#include "app/look/accessible.h"

namespace app {

// A slider over real numbers: a thin track, filled up to the value, with a mark where the value
// was before. Any press on the track takes the knob there. What lies outside [low, high] stands
// at the end. Keys: arrows a hundredth of the range, Page Up and Down a tenth, Home and End.
class ValueSlider : public QWidget, public AccessibleSlider {
    Q_OBJECT
public:
    // step: values are multiples of it from low on; 0 for none.
    ValueSlider(double low, double high, double step, QWidget* parent = nullptr);

    void setValue(double value);                 // says nothing
    void setMark(std::optional<double> before);  // the former value, or none
    void setRinged(bool ringed);                 // another view points at what it sets
    bool isDragged() const { return m_dragged; }
    Scale spoken() const override;
    void slideTo(double value) override;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }
    // Where the knob stands for a value, in this widget's pixels.
    QPointF position(double value) const;

signals:
    void moved(double value);     // while the knob moves
    void released(double value);  // at the end of a drag; after each key

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    double valueAt(double x) const;
    double snapped(double value) const;
    void stepBy(double steps);

    double m_low, m_high, m_step;
    double m_value = 0;
    std::optional<double> m_mark;
    bool m_dragged = false, m_ringed = false;
};

}  // namespace app
