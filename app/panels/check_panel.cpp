#include "app/panels/check_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QKeyEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>

#include "app/core/text.h"
#include "app/panels/check_details.h"
#include "app/panels/check_knob.h"
#include "app/panels/check_pictures.h"
#include "app/panels/follow_theme.h"
#include "app/panels/segmented.h"
#include "app/panels/surface.h"

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
    auto* splitter = new QSplitter(Qt::Horizontal, this);
    splitter->addWidget(makeLeft());
    splitter->addWidget(makeRight());
    splitter->setChildrenCollapsible(false);
    splitter->setSizes({Theme::current().px(860), Theme::current().px(820)});
    auto* column = new QVBoxLayout(this);
    column->addWidget(splitter);
    connect(&document, &Document::sceneOpened, this, [this] { m_open.reset(); });
    followTheme(this, [this, column, splitter] {
        const Theme& theme = Theme::current();
        column->setContentsMargins(theme.px(8), theme.px(8), theme.px(8), theme.px(8));
        splitter->setHandleWidth(theme.px(8));
        setStyleSheet(QStringLiteral("#checkPanel { background: %1; }").arg(theme.colors().bg.name()));
        setGroup(m_group);  // the table's colours and fonts
    });
    showState();
}

CheckPanel::~CheckPanel() = default;

QWidget* CheckPanel::makeLeft() {
    auto* content = new QWidget(this);
    m_head = new QLabel(content);
    m_head->setObjectName("checkHead");
    m_bar = new QProgressBar(content);
    m_bar->setTextVisible(false);
    m_bar->setAccessibleName(tr("Cases that have run"));
    m_groups = new Segmented(
        {tr("All"), tr("Geometry"), tr("Camera"), tr("Raster"), tr("Depth"), tr("Shading"), tr("Shadow"), tr("Limits")},
        content);
    m_groups->setAccessibleName(tr("Group of cases"));
    m_groups->setCurrent(0);
    m_cases = new CheckCases(content);
    m_runAll = new QPushButton(tr("Run all again"), content);
    m_runAll->setObjectName("checkRunAll");
    m_runAll->setProperty("kind", "primary");
    m_runOne = new QPushButton(tr("Run this case"), content);
    m_runOne->setObjectName("checkRunOne");
    m_copy = new QPushButton(tr("Copy"), content);
    m_copy->setObjectName("checkCopy");
    m_command = new QLabel(content);
    m_command->setObjectName("checkCommand");
    m_command->setProperty("tone", 2);
    m_command->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_command->setMinimumWidth(1);  // its words are no reason for a wide window
    auto* foot = new QHBoxLayout;
    for (QPushButton* button : {m_runAll, m_runOne, m_copy}) foot->addWidget(button);
    m_command->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    foot->addWidget(m_command, 1);
    auto* column = new QVBoxLayout(content);
    column->addWidget(m_head);
    column->addWidget(m_bar);
    column->addWidget(m_groups);
    column->addWidget(m_cases, 1);
    column->addLayout(foot);
    connect(m_groups, &Segmented::chosen, this,
            [this](int choice) { setGroup(choice == 0 ? std::nullopt : std::optional(Group(choice - 1))); });
    connect(m_cases, &CheckCases::chosen, this, &CheckPanel::select);
    connect(m_cases, &CheckCases::openAsked, this, &CheckPanel::openAsScene);
    connect(m_runAll, &QPushButton::clicked, this, [this] { run({}); });
    connect(m_runOne, &QPushButton::clicked, this, [this] { run({{std::string(chosenCase().id)}, {}}); });
    connect(m_copy, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(report()); });
    followTheme(content, [this, column, foot] {
        const Theme& theme = Theme::current();
        column->setContentsMargins(theme.px(12), theme.px(10), theme.px(12), theme.px(12));
        column->setSpacing(theme.px(8));
        foot->setSpacing(theme.px(8));
        m_head->setFont(theme.text(15, 600));
        m_bar->setFixedHeight(theme.px(4));
        m_command->setFont(theme.mono(12));
    });
    return surface(content, this);
}

QWidget* CheckPanel::makeRight() {
    auto* content = new QWidget(this);
    m_details = new CheckDetails(content);
    m_message = new QLabel(content);
    m_message->setObjectName("checkMessage");
    m_message->setWordWrap(true);
    m_message->hide();
    m_pictures = new CheckPictures(content);
    m_knob = new CheckKnob(content);
    m_noKnob = new QLabel(tr("Nothing in this case can be turned: it is as stiff as it is."), content);
    m_noKnob->setAlignment(Qt::AlignCenter);
    m_noKnob->setProperty("tone", 2);
    auto* column = new QVBoxLayout(content);
    column->addWidget(m_details);
    column->addWidget(m_message);
    column->addWidget(m_pictures, 2);
    column->addWidget(m_knob, 2);
    column->addWidget(m_noKnob);
    column->addStretch(0);
    connect(m_details, &CheckDetails::openAsked, this, &CheckPanel::openAsScene);
    connect(m_knob, &CheckKnob::changed, this, &CheckPanel::turnKnob);
    followTheme(content, [this, column] {
        const int margin = Theme::current().px(12);
        column->setContentsMargins(0, 0, 0, 0);
        m_message->setContentsMargins(margin, 0, margin, 0);
    });
    auto* area = scrolling(content, this);
    followTheme(area, [area, content] { area->setMinimumWidth(content->minimumSizeHint().width()); });
    return surface(area, this);
}

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
    m_groups->setCurrent(group ? int(*group) + 1 : 0);
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
    const QString time = m_seconds > 0 ? tr(", in %1 s").arg(m_seconds, 0, 'f', 1) : QString();
    m_head->setText(m_job        ? tr("%1 of %2 have run").arg(m_arrived).arg(m_asked)
                    : known == 0 ? tr("No case has run")
                                 : tr("%1 of %2 hold%3").arg(hold).arg(known).arg(time));
    m_bar->setRange(0, int(std::max<std::size_t>(m_asked, 1)));
    m_bar->setValue(m_job ? int(m_arrived) : 0);
    const QString busy = tr("The cases are running.");
    m_runAll->setEnabled(!m_job);
    m_runAll->setToolTip(m_job ? busy : tr("Runs all cases of the catalogue."));
    m_runOne->setEnabled(!m_job);
    m_runOne->setToolTip(m_job ? busy : tr("Runs %1 alone.").arg(toQString(chosenCase().id)));
    m_copy->setEnabled(!m_job && known > 0);
    m_copy->setToolTip(m_job       ? busy
                       : known > 0 ? tr("Copies what every case gave, as JSON: what check --json prints.")
                                   : tr("No case has run."));
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
