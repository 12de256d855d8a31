#include "app/desktop/main_window.h"

#include <QCloseEvent>
#include <QStackedWidget>
#include <QToolBar>

#include "app/commands/actions.h"
#include "app/commands/explain_actions.h"
#include "app/commands/look_actions.h"
#include "app/commands/step_actions.h"
#include "app/commands/view_actions.h"
#include "app/desktop/exports.h"
#include "app/desktop/failure_reports.h"
#include "app/desktop/file_opening.h"
#include "app/desktop/opening_menus.h"
#include "app/desktop/palette_commands.h"
#include "app/desktop/scene_files.h"
#include "app/desktop/session.h"
#include "app/desktop/shown_state.h"
#include "app/desktop/stage_actions.h"
#include "app/desktop/state_clipboard.h"
#include "app/desktop/tool_windows.h"
#include "app/desktop/window_cues.h"
#include "app/desktop/window_keys.h"
#include "app/desktop/window_lessons.h"
#include "app/desktop/window_renderer.h"
#include "app/desktop/window_title.h"
#include "app/docks/layout_store.h"
#include "app/docks/layouts.h"
#include "app/docks/look_keeper.h"
#include "app/docks/panel_docks.h"
#include "app/docks/status_line.h"
#include "app/docks/top_bar.h"
#include "app/docks/window_centre.h"
#include "app/docks/window_layout.h"
#include "app/document/freed_memory.h"
#include "app/document/scene_opener.h"
#include "app/document/session_file.h"
#include "app/frames/pixel_inspection.h"
#include "app/lesson/lesson_panel.h"
#include "app/stages/timeline.h"
#include "app/start/start_page.h"
#include "app/talk/cue_panel.h"
#include "app/talk/presentation.h"
#include "app/views/view_area.h"
#include "app/widgets/error_list.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/popover.h"
#include "app/widgets/tab_order.h"

namespace app {
namespace {

// Under everything, from edge to edge.
QToolBar* makeTimelineBar(QMainWindow& window) {
    auto* bar = new QToolBar(MainWindow::tr("Timeline"), &window);
    bar->setObjectName("timelineBar");
    bar->setMovable(false);
    bar->toggleViewAction()->setVisible(false);  // it is no panel
    window.addToolBar(Qt::BottomToolBarArea, bar);
    return bar;
}

}  // namespace

MainWindow::MainWindow()
    : m_opener(new SceneOpener(this)),
      m_actions(new Actions(this, [this] { return m_layout && m_layout->showsScene(); })),
      m_centre(new WindowCentre(m_document, this)) {
    setObjectName("mainWindow");
    setMinimumSize(1024, 640);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    setCentralWidget(m_centre);
    makeFeatures();
    new FreedMemory(m_document, this);
    connectDocument();
    followTheme(this, [this] {
        if (!m_presentation->changesWindow()) m_layout->fitText();
    });
    new LookKeeper(
        *this, *m_docks, [this] { m_layout->keep(); }, [this] { return m_presentation->changesWindow(); });
    if (!restoreWindowPlace(*this)) takeFirstWindowPlace(*this);
    m_layout->showStart();
}

MainWindow::~MainWindow() {
    m_presentation->end();  // it gives the theme its scale back, to widgets that are still there
    // The panels go while the document that they observe is still there.
    hide();
    qDeleteAll(findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
}

void MainWindow::makeFeatures() {
    Actions& actions = *m_actions;
    ViewArea& views = m_centre->views();
    ErrorList& errors = m_centre->errors();
    auto* top = new TopBar(m_document, this);
    setMenuWidget(top);
    m_docks = new PanelDocks(*this, m_document, views);
    const Panels& panels = m_docks->panels();
    addStepActions(actions, m_document);
    QToolBar* const timelineBar = makeTimelineBar(*this);
    auto* timeline = new Timeline(m_document, transportOf(actions), timelineBar);
    timelineBar->addWidget(timeline);
    auto* status = new StatusLine(m_document, *m_opener, this);
    setStatusBar(status);
    const AroundViews around{top->strip(), *timelineBar, *timeline, *status};
    m_presentation = new Presentation(m_document, panels.cues->model(), *m_opener, *this);
    m_layout = new WindowLayout(*this, m_document, *m_centre, around, *m_docks, *m_presentation);
    auto* layouts = new Layouts(*this, actions, views, *m_layout, *status);
    m_shown = new ShownState(m_document, views, *m_layout, errors, this);
    m_files = new SceneFiles(*this, actions, m_document, *m_opener, *m_shown, *m_layout, *panels.lesson,
                             *m_presentation, errors);
    new StateClipboard(m_centre->pages(), actions, m_document, *m_shown, *m_files, errors);
    new Exports(*this, actions, m_document, views, *m_shown);
    m_lessons = new WindowLessons(*this, actions, m_document, *m_opener, *m_centre, around, *m_docks, *m_layout,
                                  *m_shown, *m_presentation);
    auto* renderer = new WindowRenderer(*this, actions, m_document, *m_docks, views, *m_layout, *m_files, *m_lessons);
    m_cues = new WindowCues(*this, actions, m_document, *m_docks, views, *m_layout, *m_shown, *m_files, *m_presentation,
                            errors);
    m_opening = new FileOpening(*this, actions, m_document, m_centre->start(), *m_files, *m_lessons, *m_cues, *renderer,
                                *panels.cues);
    new PaletteCommands(*this, m_document, actions, *m_docks, views, *m_layout, *layouts, *m_shown, *m_lessons,
                        *m_opening);
    new OpeningMenus(*this, actions, m_document, m_centre->start(), *m_opening, *m_files, *m_lessons,
                     panels.lesson->shelf());
    new ToolWindows(*this, actions, m_document, *m_layout, *m_files, *m_lessons);
    new StageActions(*this, actions, m_document, views, top->strip());
    new LookActions(*this, actions);
    addViewActions(actions, views);
    addExplainActions(actions, m_document, *panels.inspector, views);
    addActions();
    new WindowTitle(*this, top->title(), m_document, *m_layout, *m_files, *m_lessons);
    new WindowKeys(*this, m_document, actions, *m_layout, *m_opener, *m_files);
    connect(m_opener, &SceneOpener::changed, status,
            [this, status] { status->setVisible(m_layout->showsViews() || m_opener->busy()); });
    connect(status, &StatusLine::cancelAsked, m_files, &SceneFiles::cancel);
    connect(renderer, &WindowRenderer::viewsChanged, this, &MainWindow::askAgain);
    connect(&m_centre->start(), &StartPage::viewChosen, this, [this](const lessons::WindowState& state) {
        const auto giveRoom = [this] { m_layout->giveViewsRoom(); };
        if (m_files->mayLeave()) m_files->showState(state, {}, SceneChanges::Given, giveRoom);
    });
    connect(top, &TopBar::commandAsked, actions[ActionId::RunCommand], &QAction::trigger);
    actions.fillMenus(top->menus());
    for (PanelDock* dock : m_docks->all())
        actions.menu("View")->insertAction(actions[ActionId::TwoBufferViews], dock->toggleViewAction());
    connect(actions.menu("File"), &QMenu::aboutToShow, this, &MainWindow::askAgain);
}

// What belongs to no feature: the window itself and its undo.
void MainWindow::addActions() {
    using A = ActionId;
    QUndoStack* const undo = m_document.history().stack();
    m_actions->add({.id = A::RestoreSession,
                    .menu = "File",
                    .text = "Restore the session at start",
                    .keys = "",
                    .tip = "Begin with what the window showed when it was closed.",
                    .run = [] { SessionFile::setWanted(!SessionFile::isWanted()); },
                    .isOn = [] { return SessionFile::isWanted(); },
                    .needsScene = false,
                    .startsGroup = true});
    m_actions->add({.id = A::Quit,
                    .menu = "File",
                    .text = "Quit",
                    .keys = "Ctrl+Q",
                    .tip = "Close the window.",
                    .run = [this] { close(); },
                    .needsScene = false});
    m_actions->add({.id = A::Undo,
                    .menu = "Edit",
                    .text = "Undo",
                    .keys = "Ctrl+Z",
                    .tip = "Take the last change back.",
                    .run = [undo] { undo->undo(); },
                    .whyNot = [undo] { return undo->canUndo() ? QString() : tr("Nothing to undo."); },
                    .name = [undo] { return undo->canUndo() ? tr("Undo %1").arg(undo->undoText()) : tr("Undo"); },
                    .inTalk = true});
    m_actions->add({.id = A::Redo,
                    .menu = "Edit",
                    .text = "Redo",
                    .keys = "Ctrl+Shift+Z; Ctrl+Y",
                    .tip = "Make the change again.",
                    .run = [undo] { undo->redo(); },
                    .whyNot = [undo] { return undo->canRedo() ? QString() : tr("Nothing to redo."); },
                    .name = [undo] { return undo->canRedo() ? tr("Redo %1").arg(undo->redoText()) : tr("Redo"); },
                    .inTalk = true});
    m_actions->add({.id = A::FullScreen,
                    .menu = "View",
                    .text = "Full screen",
                    .keys = "F11",
                    .tip = "Fill the screen, or give it back.",
                    .run = [this] { isFullScreen() ? showNormal() : showFullScreen(); },
                    .isOn = [this] { return isFullScreen(); },
                    .needsScene = false,
                    .startsGroup = true});
    m_docks->all().front()->addButton((*m_actions)[A::Undo], "undo");
    m_docks->all().front()->addButton((*m_actions)[A::Redo], "redo");
}

void MainWindow::askAgain() {
    m_actions->refresh();
    m_docks->enable(m_layout->showsScene());
}

ViewArea& MainWindow::views() { return m_centre->views(); }

bool MainWindow::openFile(const QString& file, const std::function<void()>& then) {
    return m_opening->open(file, then);
}

void MainWindow::connectDocument() {
    // A lesson's scene, or a checked case, goes before what is still being read.
    connect(&m_document, &Document::sceneOpened, m_opener, &SceneOpener::cancel);
    connect(&m_document, &Document::sceneOpened, this, [this] {
        m_centre->errors().hide();
        m_layout->showViews();
    });
    for (const auto signal : {&Document::sceneChanged, &Document::stageChanged})
        connect(&m_document, signal, this, &MainWindow::askAgain);
    for (const auto signal : {&Pointing::pixelChanged, &Pointing::channelChanged, &Pointing::selectionChanged})
        connect(&m_document.pointing(), signal, this, &MainWindow::askAgain);
    connect(&m_document.frames(), &FrameFeed::frameReady, this, &MainWindow::askAgain);
    connect(&m_document.inspection(), &PixelInspection::changed, this, &MainWindow::askAgain);
    connect(&m_document.stepper(), &Stepper::changed, m_actions, &Actions::refresh);
    connect(m_document.history().stack(), &QUndoStack::indexChanged, this, &MainWindow::askAgain);
    connect(m_layout, &WindowLayout::changed, this, &MainWindow::askAgain);
    connect(m_lessons, &WindowLessons::changed, this, &MainWindow::askAgain);
    reportFailures(m_document, m_centre->errors());
}

void MainWindow::startSession(const QString& folder, bool restore) {
    m_session = new Session(
        m_document, folder, [this] { return m_lessons->isOpen() ? m_lessons->stateBefore() : m_shown->now(); }, this);
    connect(&m_centre->views(), &ViewArea::changed, m_session, &Session::saveSoon);
    connect(m_files, &SceneFiles::notShown, m_session, &Session::begin);
    connect(m_files, &SceneFiles::closed, m_session, &Session::forget);
    SessionFile& file = m_session->file();
    const SessionFile::Left left = restore && SessionFile::isWanted() ? file.take() : file.leave();
    if (!left.errors.empty())
        m_centre->errors().report(tr("The last session could not be restored. It is kept as %1.").arg(left.aside),
                                  left.errors);
    if (left.state) m_files->showState(*left.state, {}, SceneChanges::Ours);
    if (!m_opener->busy()) m_session->begin();
}

// As the window is read, whatever was made first. In an overlay Tab goes round, for Esc leaves it.
bool MainWindow::focusNextPrevChild(bool next) {
    const QWidget* scope = this;
    for (QWidget* above = focusWidget(); above; above = above->parentWidget())
        if (qobject_cast<Popover*>(above)) scope = above;
    return focusNext(*scope, next) || QMainWindow::focusNextPrevChild(next);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    if (!m_presentation->changesWindow()) m_layout->fit(WindowLayout::Fit::AnotherClass);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    m_presentation->end();
    if (!m_cues->mayLeave() || !m_files->mayLeave()) return event->ignore();
    if (m_session) m_session->end(!m_files->wouldLoseChanges());
    m_layout->keep();
    saveWindowPlace(*this);
    saveTheme();
    QMainWindow::closeEvent(event);
}

}  // namespace app
