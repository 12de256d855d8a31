#pragma once
#include <QAbstractButton>

class QPainterPath;

namespace app {

// A card of the start page: its frame with hover and focus, and its words for a screen reader. As high as its width asks.
class StartButton : public QAbstractButton {
    Q_OBJECT
public:
    StartButton(const QString& title, const QString& description, QSizePolicy::Policy across, QSizePolicy::Policy down,
                QWidget* parent);

    bool hasHeightForWidth() const override { return true; }

protected:
    void paintEvent(QPaintEvent* event) final;
    // Paints what stands in the frame. box: the frame, in pixels of the widget; shape: the same with round corners.
    virtual void paintInside(QPainter& painter, const QRectF& box, const QPainterPath& shape) const = 0;
};

}  // namespace app
