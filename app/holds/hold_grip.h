#pragma once
#include <QPointF>
#include <QWidget>
#include <optional>

#include "app/look/accessible.h"

class QLabel;

namespace app {

// A button over a picture, or on the figure below it, that moves one thing which a page of a lesson lets the user hold, by
// mouse and by keys: arrows, Shift for large steps, Home for the page's own value, Esc to let a drag be. Its words stand
// beside it. For a screen reader it is a slider. It moves nothing itself: it says what was done to it.
class HoldGrip : public QWidget, public AccessibleSlider {
    Q_OBJECT
public:
    // A white disc with a sign, or a square one; a sun, or its hollow foot.
    struct Look {
        enum class Shape { Disc, Square, Sun, Foot };
        Shape shape = Shape::Disc;
        QString sign{};
    };
    HoldGrip(const QString& name, Look look, QWidget* room);

    static int side();  // pixels, at least 44
    struct Place {
        std::optional<QPointF> middle;  // in the room; nothing: it is hidden
        bool isBehind = false;          // a lamp behind what it goes around: a ring
        bool isBeside = false;          // the words are at its side, not above
        int top = 0;                    // above which no words may be
        QString words;
        Scale scale{};
    };
    void place(const Place& place);
    void setDragged(bool dragged);
    Scale spoken() const override { return m_scale; }
    void slideTo(double value) override;

signals:
    void grabbed(QPointF at);  // in the room, as the two below
    void dragged(QPointF at, Qt::KeyboardModifiers modifiers);
    void dropped();
    void cancelled();                       // the drag
    void nudged(QPoint by, bool isCoarse);  // to the right, downwards
    void restored();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    Look m_look;
    QLabel* m_words;
    Scale m_scale{};
    bool m_isBehind = false, m_isDragged = false;
};

}  // namespace app
