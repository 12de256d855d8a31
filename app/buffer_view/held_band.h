#pragma once
#include <QLineF>
#include <QWidget>

#include "lessons/held_figure.h"

namespace app {

class BufferView;
class Hand;

// Below a held picture: the figure of the page, which follows the hand. Its place is kept on both halves of a page, so that
// nothing moves at the answer.
class HeldBand : public QWidget {
    Q_OBJECT
public:
    explicit HeldBand(BufferView& view);

    // Whether the view above it is the one that has the grips.
    void setOn(bool on);
    // Draws it anew; where the columns of the picture are, in pixels of the band.
    void show(double left, double perColumn);
    // Where the grip on its axis moves, pixels of the band; nothing: the figure has none.
    std::optional<QLineF> track() const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double scale() const;  // band pixels for one of the figure
    void fitHeight();
    void paintShape(QPainter& painter, const lessons::FigureShape& shape) const;
    void paintEquation(QPainter& painter) const;

    BufferView& m_view;
    Hand& m_hand;
    bool m_isOn = false;
    lessons::HeldFigure m_figure;
};

}  // namespace app
