#pragma once
#include <QWidget>

#include "app/core/spoken.h"

class QLabel;

namespace app {

class Hand;

// A button over a picture that moves one thing which a page of a lesson lets the user hold, by mouse and by keys: arrows,
// Shift for large steps, Home for the page's own value. Its words stand beside it. For a screen reader it is a slider.
class HoldGrip : public QWidget, public SpokenSlider {
    Q_OBJECT
public:
    // On a canvas. `hold`: its number in the hand.
    HoldGrip(Hand& hand, std::size_t hold, QWidget* canvas);

    std::size_t hold() const { return m_hold; }
    static int side();  // pixels, at least 44
    // Puts its middle there, or hides it. The words stay below `top`; all in pixels of the canvas.
    void place(std::optional<QPointF> middle, bool isBehind, int top);
    void setDragged(bool dragged);
    Scale spoken() const override;
    void slideTo(double value) override;

signals:
    void grabbed(QPointF at);  // on the canvas, as the two below
    void dragged(QPointF at, Qt::KeyboardModifiers modifiers);
    void dropped();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    Hand& m_hand;
    std::size_t m_hold;
    QLabel* m_words;
    bool m_isBehind = false;
};

}  // namespace app
