// Cues and presenting, in the MainWindow.
#include <QFileDialog>
#include <QGuiApplication>
#include <QLayout>

#include "app/core/scene_opener.h"
#include "app/core/shown_name.h"
#include "app/core/text.h"
#include "app/desktop/actions.h"
#include "app/desktop/keep_changes.h"
#include "app/desktop/layout_store.h"
#include "app/desktop/main_window.h"
#include "app/desktop/panel_dock.h"
#include "app/desktop/presentation.h"
#include "app/desktop/view_area.h"
#include "app/panels/cue_panel.h"
#include "app/panels/error_list.h"
#include "app/panels/lesson_panel.h"
#include "app/panels/save_dialog.h"

namespace app {
namespace {

using A = ActionId;

// Whose keys work while presenting too.
constexpr std::array kKeys{
    A::NextCue,      A::PreviousCue, A::KeepCue,   A::Present,    A::NextStage,      A::PreviousStage,
    A::Play,         A::StepOn,      A::StepBack,  A::FirstStep,  A::LastStep,       A::RunToSelection,
    A::Undo,         A::Redo,        A::Transform, A::Cull,       A::Normals,        A::ShadowBuffer,
    A::ZBuffer,      A::Shading,     A::DarkTheme, A::LightTheme, A::ProjectorTheme, A::RedChannel,
    A::GreenChannel, A::BlueChannel, A::Bookmark1, A::Bookmark2,  A::Bookmark3,      A::Bookmark4,
    A::Bookmark5,    A::Bookmark6,   A::Bookmark7, A::Bookmark8,  A::Bookmark9,      A::OriginalSize};

QString cueFilter() { return MainWindow::tr("Cue lists (*%1)").arg(lessons::kCueEnding); }

}  // namespace

void MainWindow::connectCues() {
    m_cues = findChild<CuePanel*>();
    m_presentation = new Presentation(m_document, m_cues->model(), *m_opener, *this);
    connect(m_presentation, &Presentation::cancelAsked, this, &MainWindow::cancelOpening);
    connect(m_cues, &CuePanel::asked, this, [this](int cue) { goToCue(cue); });
    connect(m_cues, &CuePanel::keepAsked, this, &MainWindow::keepCue);
    connect(m_cues, &CuePanel::replaceAsked, this, [this] {
        CueModel& model = m_cues->model();
        if (const auto now = cueState(); now && model.current() >= 0) model.setState(model.current(), *now);
    });
    connect(m_cues, &CuePanel::openAsked, this, [this] {
        const QString file = QFileDialog::getOpenFileName(this, tr("Open a cue list"), QString(), cueFilter());
        if (!file.isEmpty()) openFile(file);
    });
    connect(m_cues, &CuePanel::saveAsAsked, this, &MainWindow::saveCuesAs);
    connect(m_cues, &CuePanel::presentAsked, this, &MainWindow::present);
    connect(&m_cues->model(), &CueModel::changed, this, &MainWindow::enableCueActions);
    connect(&m_cues->model(), &CueModel::notRead, this, [this](const pipeline::Errors& errors) {
        m_errors->report(tr("The cue list before is still open."), errors);
    });
    connect(&m_cues->model(), &CueModel::notWritten, this, [this](const QString& file, const pipeline::Errors& errors) {
        m_errors->report(tr("%1 could not be written. The cues are still here.").arg(shownName(file)), errors);
    });
    connect(&m_cues->model(), &CueModel::putAside, this, [this](const QString& file) {
        emit m_document.said(tr("A new list. The cues before are kept in %1.").arg(shownName(file)));
    });
    if (const auto& unread = m_cues->model().unread(); !unread.empty()) {
        const auto tell = [this, unread] {
            m_errors->report(
                tr("%1 could not be read. It stays as it is; new cues go into %2.")
                    .arg(shownName(toQString(unread.front().where.file)), shownName(m_cues->model().file())),
                unread);
        };
        tell();
        // A scene that opens hides what is reported: the session's does so at once.
        connect(&m_document, &Document::sceneOpened, this, tell,
                Qt::ConnectionType(Qt::QueuedConnection | Qt::SingleShotConnection));
    }
    connect(m_presentation, &Presentation::cueAsked, this, [this](int cue) { goToCue(cue); });
    connect(m_presentation, &Presentation::ended, this, [this] {
        m_presents = false;
        // Letters as large as a talk's have pushed the panels. There is room for their places once all is small again,
        // also what is behind a tab, which has not heard of it.
        for (QLayout* layout : findChildren<QLayout*>()) layout->invalidate();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        restoreState(m_beforeTalk, kLayoutVersion);
        fitLetters();
        m_views->goTo(m_views->active());  // the keys go on where they were during the talk
    });
    const auto on = [&](A id, auto run) { connect((*m_actions)[id], &QAction::triggered, this, run); };
    on(A::KeepCue, [this] { keepCue(); });
    on(A::NextCue, [this] { stepCue(1); });
    on(A::PreviousCue, [this] { stepCue(-1); });
    on(A::Present, [this] { present(); });
    (*m_actions)[A::NotesScreen]->setChecked(true);
}

void MainWindow::enableCueActions() {
    const CueModel& model = m_cues->model();
    const QString none = tr("There are no cues; Ctrl+B keeps what you see as one.");
    m_actions->setEnabled(A::KeepCue, showsScene(), tr("Open a scene first."));
    m_actions->setEnabled(A::NextCue, turnsLesson() || model.current() + 1 < model.size(),
                          model.size() == 0 ? none : tr("This is the last cue."));
    m_actions->setEnabled(A::PreviousCue, turnsLesson() || model.current() > 0,
                          model.size() == 0 ? none : tr("This is the first cue."));
    m_actions->setEnabled(A::Present, showsScene() || model.size() > 0, tr("Open a scene or a cue list first."));
    m_actions->setEnabled(A::NotesScreen, QGuiApplication::screens().size() > 1,
                          tr("There is one screen; the notes stand in the panel Cues."));
}

// A cue is a place of a talk, not of someone's work: it has no bookmarks.
std::optional<lessons::WindowState> MainWindow::cueState() const {
    auto now = state(m_cues->model().folder());
    if (now) now->bookmarks.clear();
    return now;
}

void MainWindow::keepCue() {
    const auto now = cueState();
    if (!now) return;
    CueModel& model = m_cues->model();
    const int row = model.add({std::string(stageInfo(now->stage).label), {}, {}, *now});
    emit m_document.said(
        tr("Kept as cue %1, %2. F2 in the list of cues names it.").arg(row + 1).arg(onOneLine(model.cue(row).name)));
    raiseCues();
}

void MainWindow::raiseCues() {
    for (PanelDock* dock : m_docks)
        if (dock->objectName() == "cues" && m_width == Width::Wide) dock->show(), dock->raise();
}

void MainWindow::goToCue(int cue, const Then& then) {
    CueModel& model = m_cues->model();
    if (cue < 0 || cue >= model.size()) return;
    const lessons::WindowState state = model.cue(cue).state;
    // A talk is not stopped by a question. Within a file the changes stay, as steps of undo.
    if (!m_presentation->isOn() && !isOpen(m_document, state, model.folder()) && !mayLeaveScene()) return;
    showState(state, model.folder(), SceneChanges::Given, [this, state, cue, then] {
        m_cueAsked.reset();
        m_presentation->lookAt(state);
        m_cues->model().setCurrent(cue);
        if (then) then();
    });
    if (m_opener->busy()) m_cueAsked = cue;
}

bool MainWindow::saveCuesAs() {
    CueModel& model = m_cues->model();
    const QString file =
        askWhereToSave(this, tr("Save the cue list"), model.file(), cueFilter(), lessons::kCueEnding + 1);
    return !file.isEmpty() && model.saveAs(file);
}

// Asked about where the list's own file cannot take them.
bool MainWindow::mayLeaveCues() {
    CueModel& model = m_cues->model();
    if (!model.isUnsaved() || model.write()) return true;
    switch (askToKeep(this, shownName(model.file()))) {
        case KeepChanges::Cancel: return false;
        case KeepChanges::Save: return saveCuesAs();
        case KeepChanges::Discard: break;
    }
    return true;
}

// From the cue on show, or from the one whose scene is still being read. Outside a talk a clicker turns a lesson's pages.
void MainWindow::stepCue(int by) {
    if (!turnsLesson()) return goToCue(m_cueAsked.value_or(m_cues->model().current()) + by);
    if (!m_lessons->run().turn(by)) emit m_document.said(tr("The page turns after your answer; Alt+S shows it."));
}

bool MainWindow::turnsLesson() const { return m_lessons && m_lessons->lesson() && !m_presentation->isOn(); }

bool MainWindow::openCues(const QString& file, const QString& name, const Then& then) {
    CueModel& model = m_cues->model();
    if (!model.open(file)) return false;
    int first = 0;
    if (!name.isEmpty()) {
        const auto found = findCue(model.list(), name.toStdString());
        if (!found) {
            m_errors->report(tr("%1 has no such cue.").arg(shownName(file)), found.errors());
            return false;
        }
        first = int(*found);
    }
    // The panel first: after a talk the panels stand as they did when it began.
    goToCue(first, [this, then] {
        raiseCues();
        if (then) then();
    });
    return true;
}

void MainWindow::present() {
    if (m_presentation->isOn()) return m_presentation->end();
    if (!showsScene()) return goToCue(std::max(0, m_cues->model().current()), [this] { beginPresenting(); });
    beginPresenting();
}

void MainWindow::beginPresenting() {
    const auto now = state({});
    if (!now) return;
    QList<QAction*> keys;
    for (const A id : kKeys) keys << (*m_actions)[id];
    m_presents = true;
    m_beforeTalk = saveState(kLayoutVersion);
    m_presentation->begin(*now, keys, (*m_actions)[A::NotesScreen]->isChecked());
}

}  // namespace app
