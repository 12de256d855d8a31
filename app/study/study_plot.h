#pragma once
#include <QWidget>
#include <optional>

#include "pipeline/study/plot.h"

namespace app {

// Error against run time, live: a click on a setting chooses it, the arrow keys go from one to the
// next by time, hovering tells its values.
class StudyPlot : public QWidget {
    Q_OBJECT
public:
    explicit StudyPlot(QWidget* parent = nullptr);

    // `tips`: what is told of each point of the report.
    void setPlot(pipeline::Plot plot, QStringList tips);
    void select(std::optional<std::size_t> point);  // says nothing
    std::optional<std::size_t> selected() const { return m_selected; }
    // Where a point of the report stands, and what stands within reach of a place.
    std::optional<QPointF> placeOf(std::size_t point) const;
    std::optional<std::size_t> pointAt(QPointF place) const;

    QSize minimumSizeHint() const override;

signals:
    void chosen(std::size_t point);  // by the user

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void layOut();

    pipeline::Plot m_plot;
    QStringList m_tips;
    pipeline::PlotDrawing m_drawing;
    std::optional<std::size_t> m_selected, m_hovered;
};

}  // namespace app
