#pragma once
#include <QPolygonF>
#include <QWidget>
#include <vector>

namespace app {

// Over a presentation: lines drawn by hand, a spotlight, or the whole screen black or white. Lets the mouse through
// unless the pen is up.
class PenLayer : public QWidget {
    Q_OBJECT
public:
    explicit PenLayer(QWidget* parent);

    enum class Cover : unsigned char { None, Black, White };
    Cover cover() const { return m_cover; }
    void setCover(Cover cover);
    bool hasPen() const { return m_pen; }
    void setPen(bool pen);
    bool hasSpotlight() const { return m_spotlight; }
    void setSpotlight(bool spotlight);
    void pointAt(QPointF position);  // where the cursor is
    void clearLines();
    bool hasLines() const { return !m_lines.empty(); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    Cover m_cover = Cover::None;
    bool m_pen = false, m_spotlight = false;
    QPointF m_at;
    std::vector<QPolygonF> m_lines;
};

}  // namespace app
