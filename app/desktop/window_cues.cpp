#include "app/desktop/window_cues.h"

#include <QGuiApplication>
#include <QLayout>
#include <QMainWindow>
#include <algorithm>

#include "app/commands/actions.h"
#include "app/desktop/ask_to_save.h"
#include "app/desktop/scene_files.h"
#include "app/desktop/shown_state.h"
#include "app/docks/layout_store.h"
#include "app/docks/panel_docks.h"
#include "app/docks/window_layout.h"
#include "app/document/document.h"
#include "app/document/recent_files.h"
#include "app/lesson/lesson_panel.h"
#include "app/look/shown_name.h"
#include "app/look/text.h"
#include "app/talk/cue_panel.h"
#include "app/talk/presentation.h"
#include "app/views/view_area.h"
#include "app/widgets/error_list.h"
#include "app/widgets/save_dialog.h"

namespace app {

QString WindowCues::fileFilter() { return tr("Cue lists (*%1)").arg(lessons::kCueEnding); }

WindowCues::WindowCues(QMainWindow& window, Actions& actions, Document& document, const PanelDocks& docks,
                       ViewArea& views, WindowLayout& layout, ShownState& shown, SceneFiles& files,
                       Presentation& presentation, ErrorList& errors)
    : QObject(&window),
      m_window(window),
      m_actions(actions),
      m_document(document),
      m_dock(docks[PanelId::Cues]),
      m_panel(*docks.panels().cues),
      m_lessons(*docks.panels().lesson),
      m_views(views),
      m_layout(layout),
      m_shown(shown),
      m_files(files),
      m_presentation(presentation),
      m_errors(errors) {
    connect(&m_panel, &CuePanel::asked, this, [this](int cue) { goTo(cue); });
    connect(&m_panel, &CuePanel::keepAsked, this, &WindowCues::keep);
    connect(&m_panel, &CuePanel::replaceAsked, this, &WindowCues::replaceCurrent);
    connect(&m_panel, &CuePanel::saveAsAsked, this, &WindowCues::saveAs);
    connect(&presentation, &Presentation::cueAsked, this, [this](int cue) { goTo(cue); });
    connect(&presentation, &Presentation::ended, this, &WindowCues::endTalk);
    const auto forget = [this] { m_asked.reset(); };
    connect(&files, &SceneFiles::asked, this, forget);
    connect(&files, &SceneFiles::notShown, this, forget);
    connectModel();
    reportUnread();
    addActions(actions);
}

void WindowCues::addActions(Actions& actions) {
    using A = ActionId;
    actions.add({.id = A::Present,
                 .menu = "View",
                 .text = "Clean view",
                 .keys = "Ctrl+F11",
                 .tip = "Show the views alone on the whole screen, large; with cues, a talk.",
                 .run = [this] { present(); },
                 .whyNot =
                     [this] {
                         return m_layout.showsScene() || model().size() > 0 ? QString()
                                                                            : tr("Open a scene or a cue list first.");
                     },
                 .needsScene = false,
                 .inTalk = true});
    actions.add({.id = A::NotesScreen,
                 .menu = "View",
                 .text = "Notes on second screen",
                 .keys = "",
                 .tip = "While presenting: notes, the next cue and the time on the other screen.",
                 .run = [this] { m_withNotes = !m_withNotes; },
                 .whyNot =
                     [] {
                         return QGuiApplication::screens().size() > 1
                                    ? QString()
                                    : tr("There is one screen; the notes stand in the panel Cues.");
                     },
                 .isOn = [this] { return m_withNotes; },
                 .needsScene = false});
    actions.add({.id = A::KeepCue,
                 .menu = "Run",
                 .text = "Keep as a cue",
                 .keys = "Ctrl+B",
                 .tip = "Keep what you see as the next cue of a talk.",
                 .run = [this] { keep(); },
                 .startsGroup = true,
                 .inTalk = true});
    actions.add({.id = A::NextCue,
                 .menu = "Run",
                 .text = "Next cue",
                 .keys = "PgDown",
                 .tip = "Show the next cue, as a clicker does.",
                 .run = [this] { step(1); },
                 .whyNot = [this] { return whyNotStep(1); },
                 .needsScene = false,
                 .inTalk = true});
    actions.add({.id = A::PreviousCue,
                 .menu = "Run",
                 .text = "Previous cue",
                 .keys = "PgUp",
                 .tip = "Show the cue before, exactly as it was.",
                 .run = [this] { step(-1); },
                 .whyNot = [this] { return whyNotStep(-1); },
                 .needsScene = false,
                 .inTalk = true});
    connect(&m_panel, &CuePanel::presentAsked, this, &WindowCues::present);
    connect(&model(), &CueModel::changed, &actions, &Actions::refresh);
}

QString WindowCues::whyNotStep(int by) const {
    const int next = model().current() + by;
    if (turnsLesson() || (next >= 0 && next < model().size())) return {};
    if (model().size() == 0) return tr("There are no cues; Ctrl+B keeps what you see as one.");
    return by > 0 ? tr("This is the last cue.") : tr("This is the first cue.");
}

CueModel& WindowCues::model() const { return m_panel.model(); }

void WindowCues::connectModel() {
    connect(&model(), &CueModel::notRead, this, [this](const pipeline::Errors& errors) {
        m_errors.report(tr("The cue list before is still open."), errors);
    });
    connect(&model(), &CueModel::notWritten, this, [this](const QString& file, const pipeline::Errors& errors) {
        m_errors.report(tr("%1 could not be written. The cues are still here.").arg(shownName(file)), errors);
    });
    connect(&model(), &CueModel::putAside, this, [this](const QString& file) {
        emit m_document.said(tr("A new list. The cues before are kept in %1.").arg(shownName(file)));
    });
}

void WindowCues::reportUnread() {
    const auto& unread = model().unread();
    if (unread.empty()) return;
    const auto tell = [this, unread] {
        m_errors.report(tr("%1 could not be read. It stays as it is; new cues go into %2.")
                            .arg(shownName(toQString(unread.front().where.file)), shownName(model().file())),
                        unread);
    };
    tell();
    // A scene that opens hides what is reported: the session's does so at once.
    connect(&m_document, &Document::sceneOpened, this, tell,
            Qt::ConnectionType(Qt::QueuedConnection | Qt::SingleShotConnection));
}

// A cue is a place of a talk, not of someone's work: it has no bookmarks.
std::optional<lessons::WindowState> WindowCues::state() const {
    auto now = m_shown.now(model().folder());
    if (now) now->bookmarks.clear();
    return now;
}

void WindowCues::keep() {
    const auto now = state();
    if (!now) return;
    const int row = model().add({std::string(stageInfo(now->stage).label), {}, {}, *now});
    emit m_document.said(
        tr("Kept as cue %1, %2. F2 in the list of cues names it.").arg(row + 1).arg(onOneLine(model().cue(row).name)));
    raisePanel();
}

void WindowCues::replaceCurrent() {
    if (const auto now = state(); now && model().current() >= 0) model().setState(model().current(), *now);
}

void WindowCues::raisePanel() {
    if (m_layout.isWide()) m_dock.show(), m_dock.raise();
}

void WindowCues::goTo(int cue, const Then& then) {
    if (cue < 0 || cue >= model().size()) return;
    const lessons::WindowState state = model().cue(cue).state;
    // A talk is not stopped by a question. Within a file the changes stay, as steps of undo.
    if (!m_presentation.isOn() && !isOpen(m_document, state, model().folder()) && !m_files.mayLeave()) return;
    m_files.showState(state, model().folder(), SceneChanges::Given, [this, state, cue, then] {
        m_asked.reset();
        m_presentation.lookAt(state);
        model().setCurrent(cue);
        rememberPlace(model().file(), tr("talk, cue %1 of %2").arg(cue + 1).arg(model().size()),
                      toQString(model().cue(cue).name));
        if (then) then();
    });
    if (m_files.isReading()) m_asked = cue;
}

bool WindowCues::saveAs() {
    const QString file =
        askWhereToSave(&m_window, tr("Save the cue list"), model().file(), fileFilter(), lessons::kCueEnding + 1);
    return !file.isEmpty() && model().saveAs(file);
}

bool WindowCues::mayLeave() {
    if (!model().isUnsaved() || model().write()) return true;
    switch (askToSave(&m_window, shownName(model().file()))) {
        case SaveChanges::Cancel: return false;
        case SaveChanges::Save: return saveAs();
        case SaveChanges::Discard: break;
    }
    return true;
}

// From the cue on show, or from the one whose scene is still being read. Outside a talk a clicker turns a lesson's pages.
void WindowCues::step(int by) {
    if (!turnsLesson()) return goTo(m_asked.value_or(model().current()) + by);
    if (!m_lessons.run().turn(by)) emit m_document.said(tr("The page turns after your answer; Alt+S shows it."));
}

bool WindowCues::turnsLesson() const { return m_lessons.lesson() && !m_presentation.isOn(); }

bool WindowCues::open(const QString& file, const QString& name, const Then& then) {
    if (!model().open(file)) return false;
    addRecentFile(file, onOneLine(model().list().title));
    int first = 0;
    if (!name.isEmpty()) {
        const auto found = findCue(model().list(), name.toStdString());
        if (!found) {
            m_errors.report(tr("%1 has no such cue.").arg(shownName(file)), found.errors());
            return false;
        }
        first = int(*found);
    }
    // The panel first: after a talk the panels stand as they did when it began.
    goTo(first, [this, then] {
        raisePanel();
        if (then) then();
    });
    return true;
}

void WindowCues::present() {
    if (m_presentation.isOn()) return m_presentation.end();
    if (m_layout.showsScene()) return beginTalk();
    goTo(std::max(0, model().current()), [this] { beginTalk(); });
}

void WindowCues::beginTalk() {
    const auto now = m_shown.now();
    if (!now) return;
    m_beforeTalk = m_window.saveState(kLayoutVersion);
    m_presentation.begin(*now, m_actions.inTalk(), m_withNotes);
}

void WindowCues::endTalk() {
    // Letters as large as a talk's have pushed the panels. There is room for their places once all is small again,
    // also what is behind a tab, which has not heard of it.
    for (QLayout* layout : m_window.findChildren<QLayout*>()) layout->invalidate();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    m_window.restoreState(m_beforeTalk, kLayoutVersion);
    m_layout.fitText();
    m_views.active().goTo(m_views.active().leaf());  // the keys go on where they were during the talk
}

}  // namespace app
