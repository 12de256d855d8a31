#pragma once
#include <QWidget>

#include "app/frames/stepper.h"
#include "app/stages/step_track.h"

namespace app {

// The stages' names over parts of this width: whole where they fit in letters of the usual size, else their first words,
// in smaller letters only where those do not fit either. All of one size.
struct StageNames {
    explicit StageNames(int width);
    QStringList texts;
    QFont font;  // bold: the name of the stage on show fits, too
};

// The scrubber: a part for each stage, filled as far as the frame has got, with ticks, bookmarks as flags and a
// handle. Dragging, the wheel and the arrow keys send the stepper; nothing is computed here.
class StepBar : public QWidget {
    Q_OBJECT
public:
    explicit StepBar(Stepper& stepper, QWidget* parent = nullptr);

    // The stage on show, where the handle stands while the window shows the whole frame.
    void setStage(pipeline::StageId stage);
    void setCompact(bool compact);  // shorter names
    int widthForNames() const;      // that names need in letters of three quarters of the usual size
    // From the left edge of the widget, pixels; where the handle stands.
    std::optional<double> handleX() const;
    double xOf(pipeline::Moment moment) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    StepTrack track() const;  // only while there are steps
    const std::vector<double>& ticks(const StepTrack& track, pipeline::StageId stage) const;
    double margin() const;  // at both ends, for the handle
    QRectF bar() const;
    std::optional<std::size_t> bookmarkAt(QPointF place) const;
    void scrub(double x);
    void describe();
    void paintPart(QPainter& painter, const StepTrack& track, pipeline::StageId stage) const;
    void paintFlags(QPainter& painter, const StepTrack& track) const;
    void paintHandle(QPainter& painter) const;

    Stepper& m_stepper;
    pipeline::StageId m_stage = pipeline::StageId::Shading;
    bool m_compact = false;
    int m_wheel = 0;

    // Per stage, of these steps and this level and width.
    struct Ticks {
        StepsPtr steps;
        Stepper::Level level{};
        double width = 0;
        std::array<std::vector<double>, pipeline::kStageCount> at;
    };
    mutable Ticks m_ticks;
};

}  // namespace app
