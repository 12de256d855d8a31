#include "app/check/check_panel.h"

#include <fmt/format.h>

#include <QApplication>
#include <QClipboard>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/check/check_bar.h"
#include "app/check/check_details.h"
#include "app/check/check_knob.h"
#include "app/check/check_pictures.h"
#include "app/look/text.h"
#include "app/widgets/fitting_choice.h"
#include "app/widgets/folding_panes.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/surface.h"
#include "pipeline/check/check_json.h"
#include "pipeline/plan/memory_limit.h"

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
    auto* column = spaced(new QVBoxLayout(this), {8, 8, 8, 8}, 6);
    column->addWidget(m_bar);
    column->addWidget(panes, 1);
    connect(m_bar, &CheckBar::groupChosen, this, &CheckPanel::setGroup);
    connect(m_bar, &CheckBar::runAsked, this, [this, panes] {
        run({});
        panes->bringToFront(0);
    });
    connect(m_bar, &CheckBar::copyAsked, this, [this] { QApplication::clipboard()->setText(report()); });
    connect(&document, &Document::sceneOpened, this, [this] { m_open.reset(); });
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
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

QWidget* CheckPanel::makeLeft() {
    auto* content = new QWidget(this);
    m_cases = new CheckCases(content);
    m_runOne = new QPushButton(tr("Run this case"), content);
    m_runOne->setObjectName("checkRunOne");
    m_command = styled(new QLabel(content), {.name = "checkCommand", .tone = 2, .isMono = true, .size = 12});
    m_command->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_command->setMinimumWidth(1);  // its words are no reason for a wide window
    auto* foot = spaced(new QHBoxLayout, {}, 8);
    foot->addWidget(m_runOne);
    m_command->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    foot->addWidget(m_command, 1);
    foot->addStretch();
    auto* column = spaced(new QVBoxLayout(content), {12, 10, 12, 12}, 8);
    column->addWidget(m_cases, 1);
    column->addLayout(foot);
    connect(m_cases, &CheckCases::chosen, this, &CheckPanel::select);
    connect(m_cases, &CheckCases::openAsked, this, &CheckPanel::openAsScene);
    connect(m_runOne, &QPushButton::clicked, this, [this] { run({{std::string(chosenCase().id)}, {}}); });
    followTheme(content, [this] { fitGroups(); });
    return surface(content, this);
}

QWidget* CheckPanel::makeRight() {
    auto* content = new QWidget(this);
    m_details = new CheckDetails(content);
    m_message = styled(new QLabel(content), {.name = "checkMessage", .wraps = true});
    m_message->hide();
    m_pictures = new CheckPictures(content);
    m_knob = new CheckKnob(content);
    m_noKnob = new QLabel(tr("Nothing in this case can be turned: it is as stiff as it is."), content);
    m_noKnob->setAlignment(Qt::AlignCenter);
    m_noKnob->setProperty("tone", 2);
    auto* column = spaced(new QVBoxLayout(content), {});
    column->addWidget(m_details);
    column->addWidget(m_message);
    column->addWidget(m_pictures, 2);
    column->addWidget(m_knob, 2);
    column->addWidget(m_noKnob);
    column->addStretch(0);
    connect(m_details, &CheckDetails::openAsked, this, &CheckPanel::openAsScene);
    connect(m_knob, &CheckKnob::changed, this, &CheckPanel::turnKnob);
    followTheme(content, [this] {
        const int margin = Theme::current().px(12);
        m_message->setContentsMargins(margin, 0, margin, 0);
    });
    auto* area = scrolling(content, this);
    followTheme(area, [area, content] { area->setMinimumWidth(content->minimumSizeHint().width()); });
    return surface(area, this);
}

// In a narrow window the groups are a list, and the command, which the manual has, goes.
void CheckPanel::fitGroups() {
    const bool isNarrow = width() < Theme::current().px(1180);
    m_bar->setNarrow(isNarrow);
    m_command->setVisible(!isNarrow);
}

void CheckPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitGroups();
}

std::optional<pipeline::Scene> CheckPanel::sceneAtKnob() const {
    const Case& which = chosenCase();
    if (!which.scene) return {};
    if (which.knob.scene) return which.knob.scene(m_knob->value());
    pipeline::Scene scene = which.scene();
    if (const auto setting = findSetting(scene, which.knob.setting); !which.knob.setting.empty() && setting)
        setting->set(scene, m_knob->value());
    return scene;
}

// As the case has it until the slider is moved.
void CheckPanel::showPictures() {
    std::optional<pipeline::Scene> scene;
    if (chosenCase().scene) scene = m_knob->moved() ? sceneAtKnob() : chosenCase().scene();
    const bool drawn = scene && checkSceneAndMemory(*scene).empty();
    m_pictures->setScene(chosenCase(), drawn ? std::make_shared<const pipeline::Scene>(*scene) : nullptr);
}

bool CheckPanel::openAsScene() {
    const auto tell = [this](const QString& words) {
        m_message->setText(words);
        m_message->show();
        return false;
    };
    const Case& which = chosenCase();
    auto scene = sceneAtKnob();
    if (!scene) return tell(tr("%1 is numbers or a file: it has no scene.").arg(toQString(which.id)));
    if (const auto errors = checkSceneAndMemory(*scene); !errors.empty())
        return tell(toQString(format(errors.front())));
    if (!m_mayLeave()) return false;
    if (scene->name.empty()) scene->name = fmt::format("{} {}", which.id, which.title);
    m_document.setScene(*std::move(scene));
    m_open = m_selected;
    tell(which.knob.setting.empty()
             ? tr("%1 is open in the main window.").arg(toQString(which.id))
             : tr("%1 is open in the main window and follows the slider.").arg(toQString(which.id)));
    return true;
}

// The scene of the case on show follows; a drag is one step of undo.
void CheckPanel::turnKnob(double value, bool done) {
    if (!chosenCase().knob.setting.empty() || chosenCase().knob.scene) showPictures();
    if (m_open != m_selected || chosenCase().knob.setting.empty()) return;
    if (const auto setting = findSetting(m_document.scene(), chosenCase().knob.setting))
        m_document.change(*setting, value, done ? Document::Change::Done : Document::Change::Live);
}

QString CheckPanel::report() const {
    std::vector<CaseResult> results;
    for (const auto& result : m_results)
        if (result) results.push_back(*result);
    const pipeline::Json json = toJson(results, m_seconds);
    return toQString(json.dump(2));
}

}  // namespace app
