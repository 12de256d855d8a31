#include "app/study/study_words.h"

#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>
#include <cmath>

#include "app/look/shown_name.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/padded_cells.h"
#include "pipeline/core/text.h"
#include "pipeline/export/study/study_text.h"
#include "pipeline/study/analysis_text.h"

namespace app {

StudyWords::StudyWords(QWidget* parent) : QWidget(parent) {
    const auto label = [this](const QString& text, int tone) {
        auto* made = new QLabel(text, this);
        made->setWordWrap(true);
        made->setTextInteractionFlags(Qt::TextSelectableByMouse);
        made->setTextFormat(Qt::PlainText);
        if (tone > 1) made->setProperty("tone", tone);
        return made;
    };
    m_title = label(tr("In words"), 1);
    m_cheapest = label({}, 1);
    m_cheapest->setObjectName("cheapestSentence");
    m_best = label({}, 1);
    m_best->setObjectName("bestSentence");
    m_error = new QLineEdit(this);
    m_error->setObjectName("errorLimit");
    m_time = new QLineEdit(this);
    m_time->setObjectName("timeLimit");
    m_orderTitle = label(tr("Observed order"), 1);
    m_meaning = label({}, 2);
    m_orders = new QTableWidget(0, 2, this);
    m_orders->setTabKeyNavigation(false);
    m_orders->setObjectName("studyOrders");
    m_orders->setAccessibleName(m_orderTitle->text());
    m_orders->setHorizontalHeaderLabels({tr("Method"), tr("order, 95 % interval")});
    m_orders->setEditTriggers(QTableWidget::NoEditTriggers);
    m_orders->setSelectionMode(QTableWidget::NoSelection);
    m_orders->setShowGrid(false);
    m_orders->setItemDelegate(new PaddedCells(m_orders));
    m_orders->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_orders->verticalHeader()->hide();
    m_orders->horizontalHeader()->setHighlightSections(false);
    auto* limits = new QFormLayout;
    limits->addRow(tr("Error up to"), m_error);
    limits->addRow(tr("Within ms"), m_time);
    auto* column = spaced(new QVBoxLayout(this), {12, 8, 12, 8}, 6);
    column->addWidget(m_title);
    column->addLayout(limits);
    for (QWidget* part : {static_cast<QWidget*>(m_cheapest), static_cast<QWidget*>(m_best),
                          static_cast<QWidget*>(m_orderTitle), static_cast<QWidget*>(m_meaning)})
        column->addWidget(part);
    column->addWidget(m_orders, 1);
    connect(m_error, &QLineEdit::editingFinished, this, [this] { take(m_error, m_limits.error, m_errorTyped); });
    connect(m_time, &QLineEdit::editingFinished, this, [this] { take(m_time, m_limits.milliseconds, m_timeTyped); });
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_title->setFont(theme.text(13, 600));
        m_orderTitle->setFont(theme.text(13, 600));
        m_meaning->setFont(theme.text(12));
        m_error->setFont(theme.mono(12));
        m_time->setFont(theme.mono(12));
        m_orders->verticalHeader()->setDefaultSectionSize(theme.px(28));
        m_orders->setMinimumHeight(theme.px(28 * 4));
    });
}

// A number from 0; anything else puts the old one back.
void StudyWords::take(QLineEdit* field, double& limit, bool& typed) {
    bool isNumber = false;
    const double value = field->text().trimmed().toDouble(&isNumber);
    if (isNumber && std::isfinite(value) && value >= 0) {
        typed = typed || value != limit;
        limit = value;
    }
    showAnswers();
}

void StudyWords::setStudy(const pipeline::StudyReport& report, pipeline::StudyAnalysis analysis) {
    // Another error is another scale.
    if (analysis.choice != m_analysis.choice) m_errorTyped = false;
    m_analysis = std::move(analysis);
    const auto middle = middleOfFront(m_analysis).value_or(pipeline::StudyLimits{});
    if (!m_errorTyped) m_limits.error = middle.error;
    if (!m_timeTyped) m_limits.milliseconds = middle.milliseconds;
    m_meaning->setText(m_analysis.refined ? toQString(pipeline::orderMeaning(report.axes[*m_analysis.refined]))
                                          : tr("No setting of numbers is refined."));
    m_orders->setRowCount(0);
    const QFont mono = Theme::current().mono(12);
    for (const pipeline::MethodCurve& curve : m_analysis.curves) {
        if (!curve.order.within) continue;
        const int row = m_orders->rowCount();
        m_orders->insertRow(row);
        m_orders->setItem(row, 0,
                          new QTableWidgetItem(curve.name.empty() ? tr("the only method") : onOneLine(curve.name)));
        auto* item = new QTableWidgetItem(toQString(pipeline::orderText(curve.order)));
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        item->setFont(mono);
        m_orders->setItem(row, 1, item);
    }
    m_orders->resizeColumnsToContents();
    showAnswers();
}

void StudyWords::showAnswers() {
    m_error->setText(toQString(pipeline::shortestText(m_limits.error)));
    m_time->setText(toQString(pipeline::shortestText(m_limits.milliseconds)));
    m_cheapest->setText(toQString(pipeline::cheapestSentence(m_analysis, m_limits.error)));
    m_best->setText(toQString(pipeline::bestSentence(m_analysis, m_limits.milliseconds)));
    emit answered();
}

QStringList StudyWords::sentences() const { return {m_cheapest->text(), m_best->text()}; }

}  // namespace app
