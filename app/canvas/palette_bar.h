#pragma once
#include <QWidget>
#include <vector>

#include "pipeline/buffers/palette.h"

namespace app {

// The height of a bin's bar, 0 to 1; the tallest bin has `most` pixels. Logarithmic: log(1 + count), so that an empty
// bin has height 0 and a single pixel is visible beside many thousands.
double barHeight(int count, int most, bool logarithmic);

// A palette between two handles, a histogram above it, the axis of its counts at the left where there is room. The
// scale runs from the smallest value of the buffer to the largest, a little beyond a range that reaches further; the
// handles choose what the palette's ends stand for. Dragging between them moves both; a double click types.
class PaletteBar : public QWidget {
    Q_OBJECT
public:
    explicit PaletteBar(QWidget* parent = nullptr);

    struct Scale {
        double low = 0, high = 1;      // values at the ends of the bar
        pipeline::PaletteRange range;  // values at the ends of the palette
        pipeline::Palette palette = pipeline::Palette::Sequential;
        std::vector<int> histogram;  // from low to high
        bool logarithmic = true;     // the axis of the counts
    };
    void setScale(Scale scale);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    QString axisText() const;              // what stands at the top of the counts' axis; empty where there is no room
    QString binText(QPointF point) const;  // "621.45 to 629.10: 1 204", of the bin there

signals:
    void rangeChosen(pipeline::PaletteRange range);

protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    enum class Handle : unsigned char { First, Last, Both };
    QRectF bar() const;
    int most() const;
    void paintAxis(QPainter& painter, double x, double foot, double room) const;
    double xOf(double value) const;
    double valueAt(double x) const;
    Handle handleAt(double x) const;
    void moveHandle(Handle handle, double by, pipeline::PaletteRange from);

    Scale m_scale;
    Handle m_handle = Handle::First;
    double m_pressedAt = 0;
    pipeline::PaletteRange m_pressedRange;
};

}  // namespace app
