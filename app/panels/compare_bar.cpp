#include "app/panels/compare_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <QToolButton>

#include "app/core/icons.h"
#include "app/core/spoken.h"
#include "app/core/text.h"
#include "app/panels/elided_label.h"
#include "app/panels/follow_theme.h"
#include "app/panels/segmented.h"

namespace app {

using pipeline::DifferenceMetric;

namespace {

QStringList modeTexts() {
    return {CompareBar::tr("A"), CompareBar::tr("B"), CompareBar::tr("Blink"), CompareBar::tr("Wipe"),
            CompareBar::tr("A − B")};
}

}  // namespace

CompareBar::CompareBar(QWidget* parent)
    : QWidget(parent),
      m_modes(new Segmented(modeTexts(), this)),
      m_metric(new QComboBox(this)),
      m_finding(new ElidedLabel(this)),
      m_worst(new QPushButton(tr("Worst pixel"), this)),
      m_stages(new QPushButton(tr("By stage"), this)),
      m_offer(new QPushButton(this)),
      m_close(new QToolButton(this)),
      m_first(new QHBoxLayout),
      m_second(new QHBoxLayout) {
    m_modes->setAccessibleName(tr("What is seen of the two"));
    m_modes->setToolTip(tr("Shift held shows B; T blinks, W wipes, D shows the difference"));
    for (const pipeline::MetricInfo& metric : pipeline::metricTable()) {
        m_metric->addItem(toQString(metric.name));
        m_metric->setItemData(m_metric->count() - 1, toQString(metric.words) + ", " + toQString(metric.formula),
                              Qt::ToolTipRole);
    }
    nameChoice(*m_metric, tr("Metric of the difference"));
    m_stages->setToolTip(tr("Lists how much every buffer of every stage differs"));
    m_close->setIcon(icon("close"));
    m_close->setAccessibleName(tr("Compare no longer"));
    m_close->setToolTip(tr("Compare no longer"));

    auto* column = new QVBoxLayout(this);
    m_first->addWidget(m_modes);
    m_first->addWidget(m_metric);
    m_first->addStretch();
    m_first->addWidget(m_close);
    m_second->addWidget(m_finding, 1);
    m_second->addWidget(m_offer);
    m_second->addWidget(m_worst);
    m_second->addWidget(m_stages);
    column->addLayout(m_first);
    column->addLayout(m_second);
    m_offer->hide();
    connect(m_offer, &QPushButton::clicked, this, &CompareBar::offerTaken);

    connect(m_modes, &Segmented::chosen, this, [this](int mode) { emit modeChosen(CompareMode(mode)); });
    connect(m_metric, &QComboBox::activated, this, [this](int i) { emit metricChosen(DifferenceMetric(i)); });
    connect(m_worst, &QPushButton::clicked, this, &CompareBar::worstChosen);
    connect(m_stages, &QPushButton::clicked, this, &CompareBar::stagesChosen);
    connect(m_close, &QToolButton::clicked, this, &CompareBar::closed);
    followTheme(this, [this, column] {
        const Theme& theme = Theme::current();
        column->setContentsMargins(theme.px(6), theme.px(4), theme.px(6), theme.px(2));
        column->setSpacing(theme.px(2));
        for (QHBoxLayout* row : {m_first, m_second}) row->setSpacing(theme.px(6));
        m_modes->setFixedSize(Segmented::widthFor(modeTexts()) + theme.px(10), theme.px(24));
        m_metric->setFont(theme.text(12));
        m_finding->setFont(theme.text(12));
        for (QPushButton* button : {m_worst, m_stages, m_offer}) button->setFont(theme.text(12, 500));
        m_close->setIconSize(QSize(1, 1) * theme.px(16));
    });
}

void CompareBar::fit(int height) {
    const bool isLow = height < Theme::current().px(260);
    m_finding->setVisible(!isLow);
    for (QPushButton* button : {m_worst, m_stages}) button->setVisible(!isLow || m_first->indexOf(button) >= 0);
}

// Where there is no room beside the choices the buttons stand beside the words.
void CompareBar::resizeEvent(QResizeEvent*) {
    int needed = Theme::current().px(12 + 5 * 6);
    for (QWidget* part : {static_cast<QWidget*>(m_metric), static_cast<QWidget*>(m_worst),
                          static_cast<QWidget*>(m_stages), static_cast<QWidget*>(m_close)})
        needed += part->sizeHint().width();
    const bool isWide = width() >= needed + m_modes->width();
    QHBoxLayout* place = isWide ? m_first : m_second;
    if (place->indexOf(m_worst) >= 0) return;
    int at = isWide ? place->indexOf(m_close) : place->count();
    for (QPushButton* button : {m_worst, m_stages}) {
        (isWide ? m_second : m_first)->removeWidget(button);
        place->insertWidget(at++, button);
    }
}

void CompareBar::setMode(CompareMode mode) {
    m_modes->setCurrent(int(mode));
    m_metric->setVisible(mode == CompareMode::Difference);
}

void CompareBar::setMetric(DifferenceMetric metric) {
    m_metric->setCurrentIndex(int(metric));
    const pipeline::MetricInfo& info = pipeline::metricTable()[std::size_t(metric)];
    m_metric->setToolTip(toQString(info.words) + ", " + toQString(info.formula));
}

void CompareBar::setOffer(Offer offer) {
    m_offer->setVisible(offer != Offer::Nothing);
    m_offer->setText(offer == Offer::Cancel ? tr("Cancel") : tr("Compute"));
}

void CompareBar::setFinding(const QString& sentence, const QString& whyNoWorst) {
    m_finding->setText(sentence);
    setAccessibleDescription(sentence);
    m_worst->setEnabled(whyNoWorst.isEmpty());
    m_worst->setToolTip(whyNoWorst.isEmpty() ? tr("Picks the pixel where the two differ most") : whyNoWorst);
}

}  // namespace app
