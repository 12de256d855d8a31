#pragma once
#include <QObject>
#include <QThreadPool>
#include <stop_token>
#include <vector>

#include "pipeline/check/case.h"

namespace app {

// The errors of both forms of a case at one value of the slider.
struct KnobErrors {
    double at = 0;
    double naive = 0, ours = 0;
};

// Values over the whole range of the slider, evenly spaced (in the logarithm if it is logarithmic). count >= 2
std::vector<double> knobValues(const pipeline::check::Knob& knob, std::size_t count);

// Evaluates the slider of one case at a time, in the background: a curve over the whole range, and single values. Only
// the newest single value matters.
class KnobCurve : public QObject {
    Q_OBJECT
public:
    static constexpr std::size_t kPoints = 49;

    explicit KnobCurve(QObject* parent = nullptr);
    ~KnobCurve() override;  // cancels waiting work and joins

    void askCurve(const pipeline::check::Knob& knob);  // answers for other sliders stop
    void askAt(double at);                             // for the same slider
    void forget();

signals:
    void curveReady(const std::vector<app::KnobErrors>& curve);
    void valueReady(app::KnobErrors errors);

private:
    const pipeline::check::Knob* m_knob = nullptr;
    std::stop_source m_curve, m_value;  // of the newest requests
    QThreadPool m_pool;
};

}  // namespace app
