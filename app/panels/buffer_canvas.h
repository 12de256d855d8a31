#pragma once
#include <QWidget>

#include "app/panels/canvas_base.h"
#include "app/panels/wipe.h"
#include "lessons/state/window_state.h"

namespace app {

// A picture that can be zoomed to its pixels, moved and picked from. It knows no document: what it
// shows is given, what the user does is said.
class BufferCanvas : public QWidget {
    Q_OBJECT
public:
    explicit BufferCanvas(QWidget* parent = nullptr);

    // Zoom and place stay, unless the picture has another size.
    void setContent(CanvasContent content);
    const CanvasContent& content() const { return m_content; }
    // A second picture of the same size, if any, and which part of the view it has. Marks are those of
    // the content.
    void setOther(std::optional<CanvasContent> other, const Wipe& wipe);
    void setWipe(const Wipe& wipe);
    const Wipe& wipe() const { return m_wipe; }
    // All of what is seen: a picture, or two with a border between them.
    CanvasPictures pictures() const { return {m_content, m_other, m_wipe}; }
    // The picture that fills the view, or the part of A.
    const CanvasContent& seen() const { return m_other && m_wipe.share == 0 ? *m_other : m_content; }
    // As it is painted: turned over where it is flipped.
    CanvasContent painted(const CanvasContent& content) const;
    QPointF toShown(QPointF picture) const;       // from the picture's own place to where the placement has it
    void setPicked(std::optional<QPoint> pixel);  // moves into view what is not
    void setHovered(std::optional<QPoint> pixel);
    void setMarked(std::vector<QPolygonF> outlines);
    void setEdgeView(std::optional<pipeline::EdgeView> view);
    void setPinned(std::vector<std::pair<int, QPoint>> pinned);
    void setRegion(std::optional<QRect> region);
    // Row 0 at the foot. Everything that is given and said still counts rows from the top.
    void setFlipped(bool flipped);
    bool isFlipped() const { return m_flipped; }
    QRect visiblePart() const;  // of the picture, pixels
    void setShowEdges(bool show);
    bool showsEdges() const { return m_showEdges; }

    // Shows what is worth looking at, or the whole picture, until the user zooms or moves. The part
    // is chosen once: it does not follow a picture that changes.
    void fit(bool whole = false);
    void toggleFit();  // the one, and when that is shown the other
    // Screen pixels per picture pixel; the point `anchor` of the widget stays where it is.
    void setZoom(double zoom, QPointF anchor);
    void setZoom(double zoom);  // anchored at the picked pixel, else in the middle
    void stepZoom(int steps);
    double zoom() const;
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
    // The steps of the wheel: whole from 2 up. The next one in the direction of `steps`.
    static double nextZoom(double zoom, int steps);

    std::optional<QPoint> pixelAt(QPointF widget) const;
    QPoint pixelUnder(QPointF widget) const;  // also beside the picture
    Placement placement() const { return m_placement; }
    bool isPainting() const { return m_base.busy() || m_otherBase.busy(); }  // what is seen is of before
    void cancelPainting() { m_base.cancel(), m_otherBase.cancel(); }
    void retryPainting();
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {120, 90}; }

signals:
    void picked(QPoint pixel);
    void regionDragged(QRect region);  // with the right button, or Ctrl and Shift
    void menuAsked(QPoint at);         // right button without a drag; a place on the screen
    void nudged(QPoint by);            // arrow keys: 1, with Shift 10
    void hovered(std::optional<QPoint> pixel);
    void zoomChanged(double zoom);
    void sizeChanged();        // the widget's
    void moved();              // by the user: zoomed, dragged, or fit
    void resized();            // the picture has another size, and nobody has asked for a part of it
    void wiped(double share);  // by its handle
    void seenChanged();        // seen() is another picture
    void paintingChanged();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void updateAll();  // the marks and what is below them
    void drawBase(QPainter& painter, CanvasBase& base, const CanvasContent& content, QRect part);
    void place(Placement placement);
    void placeFocus();
    void placePart();
    QRectF toShown(QRectF picture) const;
    void dragRegion(QPointF to);
    double fittingZoom() const;
    QPointF anchor() const;

    CanvasContent m_content;
    std::optional<CanvasContent> m_other;
    Wipe m_wipe;
    CanvasBase m_base, m_otherBase;
    Placement m_placement;
    QRectF m_focus;                                    // what fits
    std::optional<lessons::BufferShown::Zoom> m_part;  // as it was asked for
    bool m_fits = true, m_showEdges = false, m_flipped = false, m_measures = false;
    QPointF m_pressed, m_dragFrom;
    bool m_drags = false, m_wipes = false;
    int m_wheel = 0;  // what is left of turning by less than a step
};

}  // namespace app
