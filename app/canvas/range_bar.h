#pragma once
#include <QStackedWidget>

#include "app/canvas/shown_buffer.h"

class QLabel;
class QPushButton;

namespace app {

class LegendBar;

// Below a buffer: its range with the palette, or the names of its colours; nothing for a picture.
class RangeBar : public QStackedWidget {
    Q_OBJECT
public:
    explicit RangeBar(QWidget* parent = nullptr);

    // keepsFitting: the range follows every frame. logarithmic: the axis of the histogram's counts.
    void show(const ShownBuffer& shown, bool keepsFitting, bool logarithmic);
    void setBare(bool bare);  // without its buttons, which have keys
    // Keeps its height while hidden, so that the picture is as high as one with a range beside it.
    void keepRoom(bool keep);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

signals:
    void shown();  // or hidden, with another picture
    void rangeChosen(pipeline::PaletteRange range);
    void autofit(bool keep);  // keep: from now on
    void logarithmicChosen(bool logarithmic);

private:
    void setFonts();
    void fitWidth();
    QLabel *m_low, *m_high, *m_unit;
    PaletteBar* m_bar;
    QPushButton *m_log, *m_fit;
    LegendBar* m_legend;
    bool m_bare = false;
};

}  // namespace app
