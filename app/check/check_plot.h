#pragma once
#include <QWidget>

#include "app/check/check_plot_layout.h"

namespace app {

// The errors of both forms over the slider's range, with their values at the slider.
class CheckPlot : public QWidget {
    Q_OBJECT
public:
    explicit CheckPlot(QWidget* parent = nullptr);

    void setPlot(KnobPlot plot);
    const KnobPlot& plot() const { return m_plot; }
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void layOutAgain();

    KnobPlot m_plot;
    pipeline::PlotDrawing m_drawing;
};

}  // namespace app
