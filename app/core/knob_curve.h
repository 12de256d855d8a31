#pragma once
#include <QObject>
#include <QThreadPool>
#include <stop_token>
#include <vector>

#include "pipeline/check/case.h"

namespace app {

// The errors of both forms of a case at one value of its knob.
struct KnobErrors {
    double at = 0;
    double naive = 0, ours = 0;
};

// Values from the knob's lowest to its highest, evenly over its range (over its logarithm where it is logarithmic).
// count >= 2
std::vector<double> knobValues(const pipeline::check::Knob& knob, std::size_t count);

// Evaluates the knob of one case at a time, beside the window: a curve over the whole range, and single values of
// which only the newest is of interest.
class KnobCurve : public QObject {
    Q_OBJECT
public:
    static constexpr std::size_t kPoints = 49;

    explicit KnobCurve(QObject* parent = nullptr);
    ~KnobCurve() override;  // cancels what has not begun, and waits for the rest

    void askCurve(const pipeline::check::Knob& knob);  // answers for another knob do not come any more
    void askAt(double at);                             // of that knob
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
