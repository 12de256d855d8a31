#pragma once
#include <QWidget>

#include "app/look/accessible.h"

namespace app {

// The share of a term in its sum, as a bar, and its gain, as a mark on a scale from 0 to 4. Any press or drag sets the
// gain, a double click makes it 1; keys: arrows a tenth, Home 0, End 4, 1.
class GainBar : public QWidget, public AccessibleSlider {
    Q_OBJECT
public:
    explicit GainBar(QWidget* parent = nullptr);

    // share: of the sum, with the gain; 0 to 1. isOff: muted, or another strip is solo.
    void show(double share, double gain, bool isOff);
    double gain() const { return m_gain; }
    Scale spoken() const override;
    void slideTo(double gain) override { emit moved(gain); }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {40, sizeHint().height()}; }

signals:
    void moved(double gain);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void drag(double x);

    double m_share = 0, m_gain = 1;
    bool m_off = false;
};

}  // namespace app
