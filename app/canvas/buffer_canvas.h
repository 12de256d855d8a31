#pragma once
#include <QWidget>

#include "app/canvas/canvas_base.h"
#include "app/canvas/canvas_input.h"
#include "app/canvas/canvas_placing.h"
#include "app/canvas/wipe.h"

namespace app {

// A picture that can be zoomed to its pixels, moved and picked from. It knows no document: callers set its content; it
// reports input by signals.
class BufferCanvas : public QWidget {
    Q_OBJECT
public:
    explicit BufferCanvas(QWidget* parent = nullptr);

    CanvasPlacing& placing() { return m_placing; }
    const CanvasPlacing& placing() const { return m_placing; }
    const CanvasInput& input() const { return m_input; }

    // Zoom and place stay, unless the picture has another size.
    void setContent(CanvasContent content);
    const CanvasContent& content() const { return m_content; }
    // A second picture of the same size, if any, and its part of the view. The marks are those of the first content.
    void setOther(std::optional<CanvasContent> other, const Wipe& wipe);
    void setWipe(const Wipe& wipe);
    const Wipe& wipe() const { return m_wipe; }
    // Everything on show: one picture, or two with a border between them.
    CanvasPictures pictures() const { return {m_content, m_other, m_wipe}; }
    // The picture that fills the view; of two, A.
    const CanvasContent& seen() const { return m_other && m_wipe.share == 0 ? *m_other : m_content; }
    CanvasContent painted(const CanvasContent& content) const;  // turned over where it is flipped

    void setPicked(std::optional<QPoint> pixel);  // moves into view what is not
    void setHovered(std::optional<QPoint> pixel);
    void setMarked(std::vector<QPolygonF> outlines);
    void setPinned(std::vector<std::pair<int, QPoint>> pinned);
    void setRegion(std::optional<QRect> region);
    void setEdgeView(std::optional<pipeline::EdgeView> view);
    void setShowEdges(bool show);
    void setGround(QColor ground);  // around the picture; invalid: the theme's

    bool isPainting() const { return m_base.busy() || m_otherBase.busy(); }  // still shows the previous picture
    void cancelPainting() { m_base.cancel(), m_otherBase.cancel(); }
    void retryPainting();
    QSize sizeHint() const override;

signals:
    void sizeChanged();  // the widget's
    void seenChanged();  // seen() is another picture
    void paintingChanged();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void updateAll();  // the marks and what is below them

    CanvasContent m_content;
    std::optional<CanvasContent> m_other;
    Wipe m_wipe;
    CanvasBase m_base, m_otherBase;
    CanvasPlacing m_placing{*this};
    CanvasInput m_input{*this};
    bool m_showEdges = false;
};

}  // namespace app
