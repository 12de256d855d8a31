#include "app/compare/compare_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "app/look/accessible.h"
#include "app/look/icons.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/segmented.h"

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
      m_finding(styled(new QLabel(this), {.size = 12, .wraps = true})),
      m_worst(new QPushButton(this)),
      m_stages(new QPushButton(this)),
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
    nameComboBox(*m_metric, tr("Metric of the difference"));
    m_worst->setAccessibleName(tr("Worst pixel"));
    m_stages->setAccessibleName(tr("By stage"));
    m_stages->setToolTip(tr("Lists how much every buffer of every stage differs"));
    m_close->setIcon(icon("close"));
    m_close->setAccessibleName(tr("Compare no longer"));
    m_close->setToolTip(tr("Compare no longer"));

    auto* column = spaced(new QVBoxLayout(this), {6, 4, 6, 2}, 2);
    m_first->addWidget(m_modes);
    m_first->addWidget(m_metric);
    m_first->addStretch();
    m_first->addWidget(m_worst);
    m_first->addWidget(m_stages);
    m_first->addWidget(m_close);
    m_second->addWidget(m_finding, 1);
    m_second->addWidget(m_offer);
    m_finding->setMinimumWidth(1);  // a long path is no reason for a wide view
    column->addLayout(m_first);
    column->addLayout(m_second);
    m_offer->hide();
    connect(m_offer, &QPushButton::clicked, this, &CompareBar::offerTaken);

    connect(m_modes, &Segmented::chosen, this, [this](int mode) { emit modeChosen(CompareMode(mode)); });
    connect(m_metric, &QComboBox::activated, this, [this](int i) { emit metricChosen(DifferenceMetric(i)); });
    connect(m_worst, &QPushButton::clicked, this, &CompareBar::worstChosen);
    connect(m_stages, &QPushButton::clicked, this, &CompareBar::stagesChosen);
    connect(m_close, &QToolButton::clicked, this, &CompareBar::closed);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        for (QHBoxLayout* row : {m_first, m_second}) row->setSpacing(theme.px(6));
        m_modes->setFixedSize(Segmented::widthFor(modeTexts()) + theme.px(10), theme.px(24));
        m_metric->setFont(theme.text(12));
        // Compared views stand at the same height, whatever they found.
        m_finding->setMinimumHeight(2 * m_finding->fontMetrics().lineSpacing());
        for (QPushButton* button : {m_worst, m_stages, m_offer}) button->setFont(theme.text(12, 500));
        for (QAbstractButton* button : std::initializer_list<QAbstractButton*>{m_worst, m_stages, m_close})
            button->setIconSize(QSize(1, 1) * theme.px(16));
    });
}

void CompareBar::setBare(bool bare) {
    m_bare = bare;
    show(m_compares);
}

void CompareBar::show(bool compares) {
    m_compares = compares;
    setVisible(compares && !m_bare);
}

void CompareBar::fit(int height) {
    m_isLow = height < Theme::current().px(260);
    m_finding->setVisible(!m_isLow);
    arrange();
}

void CompareBar::resizeEvent(QResizeEvent*) { arrange(); }

// Where there is no room for their words the buttons bear signs, and what has no room beside the choices at all stands
// beside the words below.
void CompareBar::arrange() {
    const Theme& theme = Theme::current();
    const QFontMetrics metrics(m_worst->font());
    int words = 0, others = theme.px(12 + 5 * 6) + m_modes->width();
    for (const QWidget* part : {static_cast<QWidget*>(m_metric), static_cast<QWidget*>(m_close)})
        others += part->sizeHint().width();
    for (const QPushButton* button : {m_worst, m_stages})
        words += metrics.horizontalAdvance(button->accessibleName()) + theme.px(26);
    const bool hasWords = width() >= others + words;
    const auto put = [this](QWidget* part, bool inFirst, int at, bool isWanted) {
        QHBoxLayout *place = inFirst ? m_first : m_second, *other = inFirst ? m_second : m_first;
        if (place->indexOf(part) < 0) {
            other->removeWidget(part);
            place->insertWidget(inFirst ? at : place->count(), part);
        }
        part->setVisible(isWanted && (inFirst || !m_isLow));
    };
    const bool hasSigns = width() >= others + 2 * theme.px(24);
    put(m_worst, hasSigns, m_first->indexOf(m_close), true);
    put(m_stages, hasSigns, m_first->indexOf(m_close), true);
    const bool isDifference = m_modes->current() == int(CompareMode::Difference);
    put(m_metric, width() >= others, 1, isDifference);
    for (auto [button, sign] : {std::pair(m_worst, "pin"), std::pair(m_stages, "histogram")}) {
        button->setText(hasWords ? button->accessibleName() : QString());
        button->setIcon(hasWords ? QIcon() : icon(sign));
        button->setStyleSheet(hasWords ? QString()
                                       : QStringLiteral("QPushButton { padding: 0 %1px; }").arg(theme.px(3)));
    }
}

void CompareBar::setMode(CompareMode mode) {
    m_modes->setCurrent(int(mode));
    arrange();
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
    m_finding->setToolTip(sentence);
    setAccessibleDescription(sentence);
    m_worst->setEnabled(whyNoWorst.isEmpty());
    m_worst->setToolTip(whyNoWorst.isEmpty() ? tr("Picks the pixel where the two differ most") : whyNoWorst);
}

}  // namespace app
