#pragma once
#include <QObject>
#include <QRectF>
#include <optional>

#include "app/canvas/buffer_painter.h"
#include "lessons/state/window_state.h"

class QWidget;

namespace app {

// Where a picture is in its view: how large, which part, and which way up. Pictures count their rows from the top; a
// picture that is flipped is placed with row 0 at the bottom.
class CanvasPlacing : public QObject {
    Q_OBJECT
public:
    explicit CanvasPlacing(const QWidget& view) : m_view(view) {}

    // `focus`: what of the picture is worth looking at; may be empty. Zoom and place stay, unless the picture has another
    // size.
    void setPicture(QSize size, const QRectF& focus);
    void followSize();                            // of the view
    void setPicked(std::optional<QPoint> pixel);  // moves into view what is not
    void setFlipped(bool flipped);
    bool isFlipped() const { return m_flipped; }

    // Shows what is worth looking at, or the whole picture, until the user zooms or moves. The part
    // is chosen once: it does not follow a picture that changes.
    void fit(bool whole = false);
    void toggleFit();  // the one, and when that is shown the other
    // Screen pixels per picture pixel; the point `anchor` of the view stays where it is.
    void setZoom(double zoom, QPointF anchor);
    void setZoom(double zoom);  // anchored at the picked pixel, else in the middle
    double zoom() const { return m_placement.zoom; }
    // The steps of the wheel: whole from 2 up. The next one in the direction of `steps`.
    static double nextZoom(double zoom, int steps);
    void drag(QPointF origin);  // by the user
    // The part in view, of pictures in the size of the one on show or the next one; nothing: as much as fits. A part stays
    // in view when the view changes its size, until the user zooms or moves.
    std::optional<lessons::BufferShown::Zoom> part() const;
    void showPart(const std::optional<lessons::BufferShown::Zoom>& part);
    // Where it stands, of the picture as it is given, so that another view of the same size can stand there too: what fits
    // where it fits, else the same zoom around the same point.
    struct Look {
        bool fits = true;
        QRectF focus;
        double zoom = 1;
        QPointF center;
    };
    Look look() const;
    void follow(const Look& look);

    Placement placement() const { return m_placement; }
    QPointF toShown(QPointF picture) const;  // from the picture's own place to where the placement has it
    QPoint pixelUnder(QPointF view) const;   // also beside the picture
    std::optional<QPoint> pixelAt(QPointF view) const;
    QRect visiblePart() const;   // of the picture, pixels
    QRectF focusInView() const;  // where what is worth looking at is in the view; empty: nothing is

signals:
    void changed();
    void zoomChanged(double zoom);
    void moved();    // by the user: zoomed, dragged, or fit
    void resized();  // the picture has another size, and nobody has asked for a part of it

private:
    void place(Placement placement);
    void placeFocus();
    void placePart();

    const QWidget& m_view;
    QSize m_picture;
    QRectF m_worthIt;  // of the picture
    std::optional<QPoint> m_picked;
    Placement m_placement;
    QRectF m_focus;                                    // what fits
    std::optional<lessons::BufferShown::Zoom> m_part;  // as it was asked for
    bool m_fits = true, m_flipped = false;
};

}  // namespace app
