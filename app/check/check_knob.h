#pragma once
#include <QWidget>

#include "app/check/knob_curve.h"

class QLabel;
class QLineEdit;

namespace app {

class CheckPlot;
class ValueSlider;

// The quantity that makes a case stiff, as a slider with its value, and the errors of both forms over its range.
class CheckKnob : public QWidget {
    Q_OBJECT
public:
    explicit CheckKnob(QWidget* parent = nullptr);

    // A case with a knob; the slider starts at the stiff end, where the naive form is worse. null: shows nothing.
    void setCase(const pipeline::check::Case* which);
    double value() const { return m_value; }
    bool moved() const { return m_moved; }  // by anyone, since the case was set
    void setValue(double value);            // of the knob's range; says nothing

signals:
    void changed(double value, bool done);  // by the user; done: the slider is let go

private:
    void take(double value, bool done);
    void takeText();
    void showValue();
    void showPlot();
    double atPlace(double place) const;

    const pipeline::check::Case* m_case = nullptr;
    double m_value = 0;
    KnobCurve m_curve;
    std::vector<KnobErrors> m_errors;
    std::optional<KnobErrors> m_now;
    bool m_moved = false;
    QLabel *m_title, *m_label, *m_low, *m_high;
    ValueSlider* m_slider;
    QLineEdit* m_field;
    CheckPlot* m_plot;
};

}  // namespace app
