#pragma once
#include <QAbstractButton>

#include "app/start/scene_gallery.h"

class QPainterPath;

namespace app {

// A card, picture or row of the start page: its frame with hover and focus, and its words for a screen reader. Enter
// presses it.
class StartButton : public QAbstractButton {
    Q_OBJECT
public:
    enum class Frame : unsigned char { Card, Flat };  // round with a line, or neither
    StartButton(const QString& title, const QString& description, Frame frame, QWidget* parent);

protected:
    void paintEvent(QPaintEvent* event) final;
    void keyPressEvent(QKeyEvent* event) override;
    // Paints what stands in the frame. box: the frame, in pixels of the widget.
    virtual void paintInside(QPainter& painter, const QRectF& box) const = 0;

private:
    Frame m_frame;
};

// Fills the place with the picture, without cutting off what is drawn in it; black where the picture ends. kept: the
// drawn part, or that of several pictures which are to be aligned.
void paintScenePicture(QPainter& painter, const QRectF& place, const QImage& picture, const QRectF& kept);

}  // namespace app
