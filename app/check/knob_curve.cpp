#include "app/check/knob_curve.h"

#include <cmath>

namespace app {

using pipeline::check::Knob;

namespace {

KnobErrors evaluated(const Knob& knob, double at) { return {at, knob.naive(at), knob.ours(at)}; }

}  // namespace

std::vector<double> knobValues(const Knob& knob, std::size_t count) {
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) {
        const double t = double(i) / double(count - 1);
        values.push_back(knob.logarithmic ? knob.low * std::pow(knob.high / knob.low, t)
                                          : knob.low + t * (knob.high - knob.low));
    }
    values.back() = knob.high;
    return values;
}

// One thread for the curve, one for the value: a slider that moves does not wait for the curve.
KnobCurve::KnobCurve(QObject* parent) : QObject(parent) { m_pool.setMaxThreadCount(2); }

KnobCurve::~KnobCurve() {
    forget();
    m_pool.waitForDone();
}

void KnobCurve::forget() {
    m_curve.request_stop();
    m_value.request_stop();
    m_pool.clear();
    m_knob = nullptr;
}

void KnobCurve::askCurve(const Knob& knob) {
    forget();
    m_knob = &knob;
    m_curve = std::stop_source();
    m_pool.start([this, &knob, stop = m_curve.get_token()] {
        std::vector<KnobErrors> curve;
        for (const double at : knobValues(knob, kPoints)) {
            if (stop.stop_requested()) return;
            curve.push_back(evaluated(knob, at));
        }
        // Runs later in this object's own thread, and not at all once it is gone.
        QMetaObject::invokeMethod(
            this,
            [this, curve, stop] {
                if (!stop.stop_requested()) emit curveReady(curve);
            },
            Qt::QueuedConnection);
    });
}

void KnobCurve::askAt(double at) {
    if (!m_knob) return;
    m_value.request_stop();
    m_value = std::stop_source();
    m_pool.start([this, &knob = *m_knob, at, stop = m_value.get_token()] {
        if (stop.stop_requested()) return;
        const KnobErrors errors = evaluated(knob, at);
        QMetaObject::invokeMethod(
            this,
            [this, errors, stop] {
                if (!stop.stop_requested()) emit valueReady(errors);
            },
            Qt::QueuedConnection);
    });
}

}  // namespace app
