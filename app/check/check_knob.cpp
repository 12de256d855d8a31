#include "app/check/check_knob.h"

#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/check/check_plot.h"
#include "app/look/text.h"
#include "app/widgets/elided_label.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/value_slider.h"
#include "pipeline/core/text.h"

namespace app {

using pipeline::check::Knob;

namespace {

// Places of the slider, whatever the range.
constexpr double kPlaces = 400;

// Three digits are as fine as the slider is.
double rounded(double value) { return QString::number(value, 'g', 3).toDouble(); }
QString shortest(double value) { return toQString(pipeline::shortestText(value)); }

double placeOf(const Knob& knob, double at) {
    return knob.logarithmic ? kPlaces * std::log(at / knob.low) / std::log(knob.high / knob.low)
                            : kPlaces * (at - knob.low) / (knob.high - knob.low);
}

}  // namespace

CheckKnob::CheckKnob(QWidget* parent) : QWidget(parent) {
    m_title = new ElidedLabel(this);
    m_label = new QLabel(this);
    m_low = new QLabel(this);
    m_high = new QLabel(this);
    m_slider = new ValueSlider(0, kPlaces, 1, this);
    m_slider->setObjectName("checkSlider");
    m_field = new QLineEdit(this);
    m_field->setObjectName("checkValue");
    m_field->setAlignment(Qt::AlignRight);
    m_plot = new CheckPlot(this);
    for (QLabel* label : {m_low, m_high}) label->setProperty("tone", 2);
    auto* row = spaced(new QHBoxLayout, {}, 8);
    for (QWidget* part : {static_cast<QWidget*>(m_label), static_cast<QWidget*>(m_low)}) row->addWidget(part);
    row->addWidget(m_slider, 1);
    row->addWidget(m_high);
    row->addWidget(m_field);
    auto* column = spaced(new QVBoxLayout(this), {12, 10, 12, 12}, 8);
    column->addWidget(m_title);
    column->addLayout(row);
    column->addWidget(m_plot, 1);
    connect(m_slider, &ValueSlider::moved, this, [this](double place) { take(atPlace(place), false); });
    connect(m_slider, &ValueSlider::released, this, [this](double place) { take(atPlace(place), true); });
    connect(m_field, &QLineEdit::editingFinished, this, &CheckKnob::takeText);
    connect(&m_curve, &KnobCurve::curveReady, this, [this](const std::vector<KnobErrors>& curve) {
        m_errors = curve;
        const bool stiffAtLow = curve.front().naive > curve.back().naive || std::isnan(curve.front().naive);
        if (!m_moved && stiffAtLow) setValue(m_case->knob.low);
        showPlot();
    });
    connect(&m_curve, &KnobCurve::valueReady, this, [this](KnobErrors errors) {
        m_now = errors;
        showPlot();
    });
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_title->setFont(theme.text(14, 600));
        for (QLabel* label : {m_low, m_high}) label->setFont(theme.mono(12));
        m_field->setFont(theme.mono());
        m_field->setFixedWidth(theme.px(96));
    });
}

double CheckKnob::atPlace(double place) const {
    const Knob& knob = m_case->knob;
    const double t = place / kPlaces;
    const double at =
        knob.logarithmic ? knob.low * std::pow(knob.high / knob.low, t) : knob.low + t * (knob.high - knob.low);
    return std::clamp(rounded(at), knob.low, knob.high);
}

void CheckKnob::setCase(const pipeline::check::Case* which) {
    if (which == m_case) return;
    m_curve.forget();
    m_case = which;
    m_errors.clear();
    m_now.reset();
    m_moved = false;
    if (!which) return m_plot->setPlot({});
    const Knob& knob = which->knob;
    m_title->setText(tr("%1 over %2").arg(toQString(which->measure), toQString(knob.label)));
    m_label->setText(toQString(knob.label));
    m_low->setText(shortest(knob.low));
    m_high->setText(shortest(knob.high));
    m_slider->setAccessibleName(toQString(knob.label));
    m_field->setAccessibleName(tr("Value of %1").arg(toQString(knob.label)));
    m_curve.askCurve(knob);
    setValue(knob.high);
    m_moved = false;
}

void CheckKnob::setValue(double value) {
    m_value = value;
    m_now.reset();
    m_moved = true;
    m_curve.askAt(value);
    showValue();
    showPlot();
}

void CheckKnob::take(double value, bool done) {
    if (value != m_value) setValue(value);
    m_moved = true;
    emit changed(value, done);
}

void CheckKnob::takeText() {
    if (!m_case || m_field->text() == shortest(m_value)) return showValue();
    bool isNumber = false;
    const double value = m_field->text().remove(' ').toDouble(&isNumber);
    const Knob& knob = m_case->knob;
    if (!isNumber || !(value >= knob.low && value <= knob.high)) {
        m_field->setToolTip(
            tr("%1 is no number from %2 to %3").arg(m_field->text(), shortest(knob.low), shortest(knob.high)));
        m_field->setStyleSheet(
            QStringLiteral("QLineEdit { border: 2px solid %1; }").arg(Theme::current().colors().failed.name()));
        return;
    }
    take(value, true);
}

void CheckKnob::showValue() {
    m_field->setText(shortest(m_value));
    m_field->setToolTip({});
    m_field->setStyleSheet({});
    if (m_case) m_slider->setValue(placeOf(m_case->knob, m_value));
}

void CheckKnob::showPlot() { m_plot->setPlot({m_case, m_errors, m_now, m_value}); }

}  // namespace app
