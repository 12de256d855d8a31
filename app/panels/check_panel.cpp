#include "app/panels/check_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/core/text.h"
#include "app/panels/check_bar.h"
#include "app/panels/check_details.h"
#include "app/panels/check_knob.h"
#include "app/panels/check_pictures.h"
#include "app/panels/fitting_choice.h"
#include "app/panels/folding_panes.h"
#include "app/panels/follow_theme.h"

namespace app {

using pipeline::check::Case;
using pipeline::check::CaseResult;
using pipeline::check::caseTable;
using pipeline::check::Group;

CheckPanel::CheckPanel(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_results(caseTable().size()) {
    setObjectName("checkPanel");
    setWindowTitle(tr("Stiff and extreme cases"));
    setAttribute(Qt::WA_StyledBackground);
    // The first that shows all that a case can.
    m_selected =
        std::size_t(std::ranges::find_if(caseTable(), [](const Case& one) { return !one.knob.label.empty(); }) -
                    caseTable().begin());
    m_bar = new CheckBar(this);
    const QList<QWidget*> parts{makeLeft(), makeRight()};
    auto* panes = new FoldingPanes(parts, {tr("Cases"), tr("Details")}, this);
    panes->setWishes({860, 820});
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_bar);
    column->addWidget(panes, 1);
    connect(m_bar, &CheckBar::groupChosen, this, &CheckPanel::setGroup);
    connect(m_bar, &CheckBar::runAsked, this, [this, panes] {
        run({});
        panes->bringToFront(0);
    });
    connect(m_bar, &CheckBar::copyAsked, this, [this] { QApplication::clipboard()->setText(report()); });
    connect(&document, &Document::sceneOpened, this, [this] { m_open.reset(); });
    followTheme(this, [this, column] {
        const Theme& theme = Theme::current();
        column->setContentsMargins(theme.px(8), theme.px(8), theme.px(8), theme.px(8));
        column->setSpacing(theme.px(6));
        setStyleSheet(QStringLiteral("#checkPanel { background: %1; }").arg(theme.colors().bg.name()));
        setGroup(m_group);  // the table's colours and fonts
    });
    showState();
}

CheckPanel::~CheckPanel() = default;

const Case& CheckPanel::chosenCase() const { return caseTable()[m_selected]; }

void CheckPanel::run(pipeline::check::Filter filter) {
    if (m_job) return;
    m_arrived = m_asked = 0;
    for (std::size_t i = 0; i < m_results.size(); ++i) m_asked += filter.admits(caseTable()[i]);
    if (m_asked == m_results.size()) {
        std::ranges::fill(m_results, std::nullopt);
        setGroup(m_group);
    }
    m_job = std::make_unique<CheckJob>(std::move(filter));
    connect(m_job.get(), &CheckJob::arrived, this, &CheckPanel::take);
    connect(m_job.get(), &CheckJob::finished, this, &CheckPanel::finish);
    showState();
}

void CheckPanel::take(const CaseResult& result) {
    const auto which = std::size_t(result.what - caseTable().data());
    m_results[which] = result;
    m_cases->setResult(which, result);
    ++m_arrived;
    if (which == m_selected) showSelected();
    showState();
}

void CheckPanel::finish(double seconds, bool cancelled) {
    if (m_asked == m_results.size() && !cancelled) m_seconds = seconds;
    // Its own signal is being handled.
    m_job.release()->deleteLater();
    setGroup(m_group);
    // Opened again while the last cases of a stopped run came to their ends.
    if (cancelled && isVisible()) return run({});
    showState();
}

void CheckPanel::setGroup(std::optional<Group> group) {
    m_group = group;
    m_bar->setGroup(group);
    m_cases->setCases(m_results, group);
    if (!m_cases->contains(m_selected)) {
        const auto table = caseTable();
        m_selected = std::size_t(std::ranges::find(table, *group, &Case::group) - table.begin());
    }
    select(m_selected);
}

void CheckPanel::select(std::size_t which) {
    if (which != m_selected) m_message->hide();
    m_selected = which;
    m_cases->select(which);
    showSelected();
    showState();
}

void CheckPanel::showSelected() {
    const bool hasKnob = !chosenCase().knob.label.empty();
    m_details->setCase(chosenCase(), m_results[m_selected]);
    m_knob->setCase(hasKnob ? &chosenCase() : nullptr);
    m_knob->setVisible(hasKnob);
    m_noKnob->setVisible(!hasKnob);
    showPictures();
}

void CheckPanel::showState() {
    const auto known = std::ranges::count_if(m_results, [](const auto& result) { return result.has_value(); });
    const auto hold = std::ranges::count_if(m_results, [](const auto& result) { return result && result->holds; });
    m_bar->showState({m_job != nullptr, m_arrived, m_asked, std::size_t(known), std::size_t(hold), m_seconds});
    m_runOne->setEnabled(!m_job);
    m_runOne->setToolTip(m_job ? tr("The cases are running.") : tr("Runs %1 alone.").arg(toQString(chosenCase().id)));
    m_command->setText(m_group ? tr("also: shadescope check --group %1").arg(toQString(name(*m_group)))
                               : tr("also: shadescope check"));
}

void CheckPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    m_cases->setFocus();
    if (std::ranges::any_of(m_results, [](const auto& result) { return !result; })) run({});
}

void CheckPanel::closeEvent(QCloseEvent* event) {
    if (m_job) m_job->cancel();
    QWidget::closeEvent(event);
}

void CheckPanel::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        close();
        return;
    }
    QWidget::keyPressEvent(event);
}

}  // namespace app
