#include "app/canvas/range_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "app/canvas/legend_bar.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"

namespace app {

namespace {

// The room of a number only grows: numbers that change with every value of a drag must not lay the window out anew.
void letGrow(QLabel* number) {
    const QSize needed = number->sizeHint();
    if (needed.width() > number->minimumWidth() || needed.height() != number->minimumHeight())
        number->setFixedSize(needed);
}

}  // namespace

RangeBar::RangeBar(QWidget* parent)
    : QStackedWidget(parent),
      m_low(new QLabel(this)),
      m_high(new QLabel(this)),
      m_unit(new QLabel(this)),
      m_bar(new PaletteBar(this)),
      m_log(new QPushButton(tr("log"), this)),
      m_fit(new QPushButton(tr("Autofit"), this)),
      m_legend(new LegendBar(this)) {
    auto* range = new QWidget(this);
    auto* row = new QHBoxLayout(range);
    for (QWidget* part : {static_cast<QWidget*>(m_low), static_cast<QWidget*>(m_bar), static_cast<QWidget*>(m_high),
                          static_cast<QWidget*>(m_unit), static_cast<QWidget*>(m_log), static_cast<QWidget*>(m_fit)})
        row->addWidget(part, part == m_bar ? 1 : 0);
    auto* legend = new QWidget(this);
    auto* legendRow = new QHBoxLayout(legend);
    legendRow->addWidget(m_legend, 1);
    addWidget(range);
    addWidget(legend);

    m_low->setObjectName("rangeLow");
    m_high->setObjectName("rangeHigh");
    m_unit->setProperty("tone", "2");
    m_fit->setCheckable(true);
    m_fit->setToolTip(tr("While this is on, the range shows all values after every change (Shift+N); N fits once"));
    connect(m_fit, &QPushButton::clicked, this, &RangeBar::autofit);
    m_log->setObjectName("logCounts");
    m_log->setCheckable(true);
    m_log->setAccessibleName(tr("Logarithmic counts"));
    m_log->setToolTip(
        tr("The histogram's counts on a logarithmic axis, so that few pixels are seen beside many (Shift+L); else a "
           "linear one"));
    connect(m_log, &QPushButton::clicked, this, &RangeBar::logarithmicChosen);
    connect(m_bar, &PaletteBar::rangeChosen, this, &RangeBar::rangeChosen);
    followTheme(this, [this, row, legendRow] {
        const Theme& theme = Theme::current();
        setFonts();
        for (QHBoxLayout* layout : {row, legendRow}) {
            layout->setContentsMargins(theme.px(10), theme.px(2), theme.px(6), theme.px(2));
            layout->setSpacing(theme.px(6));
        }
        setFixedHeight(theme.px(48));
        fitWidth();
    });
}

void RangeBar::setFonts() {
    const Theme& theme = Theme::current();
    for (QLabel* label : {m_low, m_high}) label->setFont(theme.mono(12));
    m_unit->setFont(theme.text(12));
    for (QPushButton* button : {m_log, m_fit}) button->setFont(theme.text(12, 500));
    for (QLabel* number : {m_low, m_high}) number->setFixedSize(number->sizeHint());
}

// Set while they are hidden, fonts do not outlive a view that moves in the window.
void RangeBar::showEvent(QShowEvent* event) {
    QStackedWidget::showEvent(event);
    setFonts();
}

// Where there is little room it is the palette's: the axis has its key too, and the button a short name.
void RangeBar::fitWidth() {
    const bool narrow = width() < Theme::current().px(400);
    m_log->setVisible(!narrow && !m_bare);
    m_fit->setVisible(!m_bare);
    m_fit->setText(narrow ? tr("Fit") : tr("Autofit"));
    m_fit->setAccessibleName(tr("Autofit"));
    m_unit->setVisible(!m_unit->text().isEmpty() && width() > Theme::current().px(560));
}

void RangeBar::setBare(bool bare) {
    m_bare = bare;
    fitWidth();
}

void RangeBar::keepRoom(bool keep) {
    QSizePolicy policy = sizePolicy();
    policy.setRetainSizeWhenHidden(keep);
    setSizePolicy(policy);
}

void RangeBar::resizeEvent(QResizeEvent* event) {
    QStackedWidget::resizeEvent(event);
    fitWidth();
}

void RangeBar::show(const ShownBuffer& shown, bool keepsFitting, bool logarithmic) {
    const bool hasScale = !shown.scale.histogram.empty();
    setVisible(hasScale || !shown.legend.empty());
    emit this->shown();
    setCurrentIndex(hasScale ? 0 : 1);
    m_legend->setEntries(shown.legend);
    if (!hasScale) return;
    // For an audience the numbers name the ends of the bar, else those of the palette, which can be moved.
    const double first = m_bare ? shown.scale.low : shown.look.range.first;
    const double last = m_bare ? shown.scale.high : shown.look.range.last;
    const auto [low, high] = std::minmax(first, last);
    m_low->setText(valueText(shown.buffer, low, 8));
    m_high->setText(valueText(shown.buffer, high, 8));
    letGrow(m_low), letGrow(m_high);
    m_unit->setText(toQString(shown.buffer.info->unit));
    fitWidth();
    PaletteBar::Scale scale = shown.scale;
    scale.logarithmic = logarithmic;
    m_bar->setScale(std::move(scale));
    m_log->setChecked(logarithmic);
    m_fit->setChecked(keepsFitting);
}

}  // namespace app
