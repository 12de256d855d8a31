#pragma once
#include <QWidget>

#include "pipeline/study/scanline_plot.h"

namespace app {

// The plot of a section along a row. It knows no document: callers set its content; it reports input by signals.
class ScanlinePlotView : public QWidget {
    Q_OBJECT
public:
    explicit ScanlinePlotView(QWidget* parent = nullptr);

    // Null: nothing but the sentence.
    void setSection(std::shared_ptr<const pipeline::ScanlineSection> section, int channel);
    void setSentence(const QString& sentence);
    void setMarks(std::optional<int> picked, std::optional<int> hovered);  // x in this row
    const pipeline::PlotDrawing& drawing() const { return m_drawing; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void hovered(std::optional<int> x);
    void picked(int x);
    void rowAsked(int by);  // arrows up and down, the wheel

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void layOutAgain();
    pipeline::PlotSize plotSize() const;
    std::optional<int> pixelAt(double x) const;

    std::shared_ptr<const pipeline::ScanlineSection> m_section;
    QString m_sentence;
    int m_channel = 2;
    std::optional<int> m_picked, m_hovered;
    pipeline::PlotDrawing m_drawing;
    int m_wheel = 0;
};

}  // namespace app
