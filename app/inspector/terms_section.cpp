#include "app/inspector/terms_section.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "app/frames/mix_model.h"
#include "app/inspector/gain_bar.h"
#include "app/look/number_format.h"
#include "app/look/numbers.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "pipeline/stages/shading.h"

namespace app {

using pipeline::TermKind;
using pipeline::TermMix;
using pipeline::TermStrip;

namespace {

double valueOf(const TermStrip& strip, const pipeline::PixelReport& report, int channel) {
    const auto k = std::size_t(std::max(0, strip.light));
    switch (strip.kind) {
        case TermKind::Emission: return report.emission[channel];
        case TermKind::Ambient: return report.ambient[channel];
        case TermKind::Diffuse: return report.diffuse[k][channel];
        case TermKind::Specular: return report.specular[k][channel];
    }
    return 0;
}

QString termText(double value) { return chosenText(value).value_or(intensity(value)); }

}  // namespace

TermsSection::TermsSection(Document& document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_grid(new QGridLayout),
      m_sum(new QLabel(this)),
      m_words(styled(new QLabel(this), {.tone = 2, .wraps = true})),
      m_reset(new QPushButton(tr("Every term as it is"), this)) {
    setAccessibleName(tr("Terms of the intensity"));
    auto* column = spaced(new QVBoxLayout(this), {});
    column->addLayout(m_grid);
    column->addWidget(m_sum);
    auto* foot = new QHBoxLayout;
    foot->addWidget(m_words, 1);
    foot->addWidget(m_reset);
    column->addLayout(foot);
    m_grid->setColumnStretch(3, 1);
    m_sum->setTextFormat(Qt::RichText);
    m_reset->setProperty("kind", "link");
    connect(m_reset, &QPushButton::clicked, &document.mixer(), &MixModel::reset);
    connect(&document.mixer(), &MixModel::changed, this, &TermsSection::showMix);
    followTheme(this, [this] { styleRows(); });
}

void TermsSection::build(std::size_t count) {
    for (const Strip& strip : m_strips)
        for (QWidget* part :
             std::initializer_list<QWidget*>{strip.solo, strip.mute, strip.name, strip.gain, strip.value, strip.bar})
            delete part;
    m_strips.clear();
    const auto toggle = [this](const char* letter, std::size_t i, bool TermStrip::*field) {
        auto* button = new QToolButton(this);
        button->setText(letter);
        button->setCheckable(true);
        button->setProperty("kind", "strip");
        connect(button, &QToolButton::clicked, this, [this, i, field](bool on) {
            TermMix mix = m_document.mixer().mix();
            mix[i].*field = on;
            m_document.mixer().set(mix);
        });
        return button;
    };
    for (std::size_t i = 0; i < count; ++i) {
        const int row = int(i);
        const QString name = toQString(m_document.mixer().mix()[i].name());
        Strip strip{toggle("S", i, &TermStrip::solo),
                    toggle("M", i, &TermStrip::muted),
                    new QLabel(name, this),
                    new QLabel(this),
                    new QLabel(this),
                    new GainBar(this)};
        strip.solo->setToolTip(tr("Solo: this term alone, in every picture of the frame buffer."));
        strip.mute->setToolTip(tr("Mute: the picture without this term."));
        strip.solo->setAccessibleName(tr("Solo %1").arg(name));
        strip.mute->setAccessibleName(tr("Mute %1").arg(name));
        strip.bar->setAccessibleName(tr("Gain of %1").arg(name));
        strip.value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        m_grid->addWidget(strip.solo, row, 0);
        m_grid->addWidget(strip.mute, row, 1);
        m_grid->addWidget(strip.name, row, 2);
        m_grid->addWidget(strip.bar, row, 3);
        m_grid->addWidget(strip.gain, row, 4);
        m_grid->addWidget(strip.value, row, 5);
        connect(strip.bar, &GainBar::moved, this, [this, i](double gain) {
            TermMix mix = m_document.mixer().mix();
            mix[i].gain = gain;
            m_document.mixer().set(mix);
        });
        m_strips.push_back(strip);
    }
    styleRows();
}

void TermsSection::styleRows() {
    const Theme& theme = Theme::current();
    m_grid->setHorizontalSpacing(theme.px(4));
    m_grid->setVerticalSpacing(theme.px(2));
    m_grid->setColumnMinimumWidth(5, QFontMetrics(theme.mono(12)).horizontalAdvance("0 000.000"));
    m_grid->setColumnMinimumWidth(4, QFontMetrics(theme.mono(12)).horizontalAdvance("×0.00"));
    for (const Strip& strip : m_strips) {
        for (QToolButton* button : {strip.solo, strip.mute}) {
            button->setFont(theme.text(12, 600));
            button->setFixedSize(theme.px(22), theme.px(22));
        }
        strip.name->setFont(theme.text(12));
        for (QLabel* digits : {strip.gain, strip.value}) digits->setFont(theme.mono(12));
    }
    for (QLabel* label : {m_sum, m_words}) label->setFont(theme.text(12));
    m_reset->setFont(theme.text(12));
    showMix();
}

void TermsSection::show(const pipeline::PixelReport& report, int channel) {
    const TermMix& mix = m_document.mixer().mix();
    m_values.clear();
    for (const TermStrip& strip : mix) {
        // The frame lags behind a scene with another number of lights: its terms follow.
        if (strip.light >= int(report.diffuse.size())) return m_values.clear();
        m_values.push_back(valueOf(strip, report, channel));
    }
    m_intensity = report.intensity[channel];
    m_iMax = report.iMax;
    m_isShaded = report.isShaded;
    if (m_strips.size() != mix.size()) build(mix.size());
    setAccessibleDescription(sentence());
    showMix();
}

double TermsSection::sum() const {
    double sum = 0;
    for (const double value : m_values) sum += value;
    return sum;
}

double TermsSection::mixed() const {
    const TermMix& mix = m_document.mixer().mix();
    double sum = 0;
    for (std::size_t i = 0; i < std::min(mix.size(), m_values.size()); ++i)
        sum += pipeline::weight(mix, i) * m_values[i];
    return sum;
}

QString TermsSection::sentence() const {
    const TermMix& mix = m_document.mixer().mix();
    QStringList parts;
    for (std::size_t i = 0; i < std::min(mix.size(), m_values.size()); ++i)
        if (mix[i].kind != TermKind::Emission || m_values[i] != 0)
            parts << toQString(mix[i].name()) + ' ' + termText(m_values[i]);
    return parts.join(", ");
}

void TermsSection::showMix() {
    const MixModel& mixer = m_document.mixer();
    const TermMix& mix = mixer.mix();
    m_reset->setVisible(!mixer.isPlain());
    m_words->setText(mixer.isPlain() ? QString() : mixer.sentence());
    m_words->setVisible(!m_words->text().isEmpty());
    if (m_strips.size() != mix.size() || m_values.size() != mix.size()) return;
    const double whole = std::max({std::abs(m_intensity), std::abs(sum()), std::abs(mixed())});
    for (std::size_t i = 0; i < mix.size(); ++i) {
        const Strip& strip = m_strips[i];
        const double weight = pipeline::weight(mix, i), value = weight * m_values[i];
        // What nothing emits needs no strip.
        const bool isShown = mix[i].kind != TermKind::Emission || m_values[i] != 0 || mix[i].gain != 1;
        for (QWidget* part :
             std::initializer_list<QWidget*>{strip.solo, strip.mute, strip.name, strip.gain, strip.value, strip.bar})
            part->setVisible(isShown);
        strip.solo->setChecked(mix[i].solo);
        strip.mute->setChecked(mix[i].muted);
        strip.bar->show(whole > 0 ? value / whole : 0, mix[i].gain, weight == 0);
        strip.gain->setText(mix[i].gain == 1 ? QString() : QStringLiteral("×%1").arg(mix[i].gain));
        strip.value->setText(termText(value));
        strip.name->setEnabled(weight != 0);
        strip.value->setEnabled(weight != 0);
    }
    // Adding up in another order than the stage did costs a few last digits.
    const bool isZero = std::abs(residual()) <= 1e-6 * whole;
    const ThemeColors& c = Theme::current().colors();
    const auto mono = [](const QString& text) {
        return QStringLiteral("<span style=\"font-family:'JetBrains Mono','DejaVu Sans Mono'\">%1</span>").arg(text);
    };
    QString text = tr("Sum %1 &nbsp; ").arg(mono(termText(sum())));
    text += !m_isShaded ? tr("not shaded yet")
                        : tr("residual ") +
                              QStringLiteral("<span style=\"color:%1\">%2</span>")
                                  .arg((isZero ? c.run : c.failed).name(), mono(isZero ? "0" : errorText(residual())));
    if (!mixer.isPlain()) {
        const int shown = pipeline::frameBufferValue(pipeline::Vec3d(mixed()), m_iMax).r;
        text += tr("<br>Mixed %1, in the frame buffer %2").arg(mono(termText(mixed())), mono(QString::number(shown)));
        if (mixed() > m_iMax) text += tr(" (above I<sub>max</sub> = %1: clamped)").arg(mono(termText(m_iMax)));
    }
    m_sum->setText(text);
}

}  // namespace app
