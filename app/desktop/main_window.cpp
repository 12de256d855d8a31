#include "app/desktop/main_window.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QApplication>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QStackedWidget>
#include <QToolBar>
#include <QVBoxLayout>

#include "app/core/file_watch.h"
#include "app/core/freed_memory.h"
#include "app/core/icons.h"
#include "app/core/memory_notice.h"
#include "app/core/pixel_inspection.h"
#include "app/core/scene_opener.h"
#include "app/core/shown_name.h"
#include "app/core/text.h"
#include "app/desktop/actions.h"
#include "app/desktop/command_palette.h"
#include "app/desktop/key_sheet.h"
#include "app/desktop/layout_store.h"
#include "app/desktop/look_keeper.h"
#include "app/desktop/panel_dock.h"
#include "app/desktop/panel_table.h"
#include "app/desktop/pixel_field.h"
#include "app/desktop/popover.h"
#include "app/desktop/presentation.h"
#include "app/desktop/session.h"
#include "app/desktop/status_line.h"
#include "app/desktop/step_actions.h"
#include "app/desktop/view_area.h"
#include "app/desktop/views_room.h"
#include "app/panels/error_list.h"
#include "app/panels/follow_theme.h"
#include "app/panels/inspector_panel.h"
#include "app/panels/lesson_panel.h"
#include "app/panels/scene_tree.h"
#include "app/panels/settings_panel.h"
#include "app/panels/stage_strip.h"
#include "app/panels/start_page.h"
#include "app/panels/tab_order.h"
#include "app/panels/timeline.h"
#include "lessons/library.h"

namespace app {

MainWindow::MainWindow() : m_opener(new SceneOpener(this)), m_actions(new Actions(this)) {
    setObjectName("mainWindow");
    setMinimumSize(1024, 640);
    setAcceptDrops(true);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    makeTop();
    makeCentre();
    makeDocks();
    makeTimeline();
    m_status = new StatusLine(m_document, *m_opener, this);
    setStatusBar(m_status);
    m_palette = new CommandPalette(this);
    m_keys = new KeySheet(*m_actions, this);
    m_pixelField = new PixelField(this);
    new FreedMemory(m_document, this);
    connectCues();
    connectActions();
    connectDocument();
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_title->setFont(theme.text());
        m_rail->setIconSize(QSize(theme.px(18), theme.px(18)));
        if (!m_presents) fitLetters();
    });
    qApp->installEventFilter(this);
    new LookKeeper(
        *this, [this] { keepPanels(); }, [this] { return m_presents; });
    if (!restoreWindowPlace(*this)) takeFirstWindowPlace(*this);
    showStartPage();
}

MainWindow::~MainWindow() {
    qApp->removeEventFilter(this);
    m_presentation->end();  // it gives the theme its scale back, to widgets that are still there
    // The panels go while the document that they observe is still there.
    hide();
    qDeleteAll(findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
}

// Menus, the scene's name in the middle, the command field; below them the stages.
void MainWindow::makeTop() {
    auto* top = new QWidget(this);
    auto* column = new QVBoxLayout(top);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* row = new QHBoxLayout;
    auto* bar = new QMenuBar(top);
    m_actions->addMenus(*bar);
    bar->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Preferred);
    m_title = new QLabel(top);
    m_title->setObjectName("title");
    m_title->setProperty("tone", 2);
    m_title->setAlignment(Qt::AlignCenter);
    auto* command = new QPushButton(tr("Run a command   Ctrl+Shift+P"), top);
    command->setObjectName("runCommand");
    connect(command, &QPushButton::clicked, (*m_actions)[ActionId::RunCommand], &QAction::trigger);
    row->addWidget(bar);
    row->addWidget(m_title, 1);
    row->addWidget(command);
    column->addLayout(row);
    m_strip = new StageStrip(m_document, top);
    column->addWidget(m_strip);
    setMenuWidget(top);
    followTheme(top, [row, command] {
        const Theme& theme = Theme::current();
        row->setContentsMargins(0, theme.px(3), theme.px(8), theme.px(3));
        command->setFont(theme.text(12));
    });
}

void MainWindow::makeCentre() {
    auto* centre = new QWidget(this);
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(Theme::current().px(8));
    m_errors = new ErrorList(centre);
    m_banner = new QLabel(centre);
    m_pages = new QStackedWidget(centre);
    m_start = new StartPage(m_pages);
    m_views = new ViewArea(m_document, m_pages);
    m_pages->addWidget(m_start);
    m_pages->addWidget(m_views);
    column->addWidget(m_errors);
    column->addWidget(m_banner);
    column->addWidget(m_pages, 1);
    setCentralWidget(centre);
    connect(m_start, &StartPage::openRequested, this, &MainWindow::chooseFile);
    connect(m_start, &StartPage::fileChosen, this, [this](const QString& file) { openFile(file); });
    connect(m_start, &StartPage::recentChosen, this, &MainWindow::openRecent);
    connect(m_start, &StartPage::viewChosen, this, [this](const lessons::WindowState& state) {
        if (mayLeaveScene()) showState(state, {}, SceneChanges::Given, [this] { giveViewsRoom(*this, *m_views); });
    });
    connect(m_start, &StartPage::lessonChosen, this, &MainWindow::openLesson);
    connect(m_start, &StartPage::keysRequested, (*m_actions)[ActionId::Keys], &QAction::trigger);
}

void MainWindow::makeDocks() {
    m_rail = addToolBar(tr("Panels"));
    m_rail->setObjectName("rail");
    m_rail->setMovable(false);
    m_rail->setOrientation(Qt::Vertical);
    addToolBar(Qt::LeftToolBarArea, m_rail);
    for (const PanelRow& row : panelTable()) {
        auto* dock = new PanelDock(tr(row.title), row.icon, row.make(m_document, this), this);
        dock->setObjectName(row.name);
        addDockWidget(row.area, dock);
        m_docks += dock;
        if (row.area == Qt::LeftDockWidgetArea) m_leftDocks += dock;
        if (row.area != Qt::BottomDockWidgetArea) m_sideDocks += dock;
        QAction* toggle = dock->toggleViewAction();
        toggle->setShortcut(QKeySequence(row.keys));
        toggle->setIcon(app::icon(row.icon));
        addAction(toggle);
        m_rail->addAction(toggle);
    }
    tabDocks();
    followAlgorithm();
    m_docks.front()->addButton((*m_actions)[ActionId::Undo], "undo");
    m_docks.front()->addButton((*m_actions)[ActionId::Redo], "redo");
    auto* tree = findChild<SceneTree*>();
    auto* settings = findChild<SettingsPanel*>();
    connect(tree, &SceneTree::selected, settings, &SettingsPanel::select);
    connectLessons();
    connectRenderer();
    auto* inspector = findChild<InspectorPanel*>();
    connect(inspector, &InspectorPanel::bufferAsked, m_views, &ViewArea::showBuffer);
    connect(inspector, &InspectorPanel::settingAsked, this, &MainWindow::showSetting);
}

void MainWindow::showSetting(const QString& key) {
    for (PanelDock* dock : m_docks)
        if (dock->objectName() == "settings" && !dock->isInFront()) dock->toggleViewAction()->trigger();
    findChild<SettingsPanel*>()->showSetting(key);
}

// Under everything, from edge to edge.
void MainWindow::makeTimeline() {
    m_timelineBar = new QToolBar(tr("Timeline"), this);
    m_timelineBar->setObjectName("timelineBar");
    m_timelineBar->setMovable(false);
    m_timelineBar->toggleViewAction()->setVisible(false);  // it is no panel
    m_timeline = new Timeline(m_document, transportOf(*m_actions), m_timelineBar);
    m_timelineBar->addWidget(m_timeline);
    addToolBar(Qt::BottomToolBarArea, m_timelineBar);
}

void MainWindow::connectDocument() {
    // A lesson's scene, or a checked case, goes before what is still being read.
    connect(&m_document, &Document::sceneOpened, m_opener, &SceneOpener::cancel);
    connect(m_opener, &SceneOpener::changed, this,
            [this] { m_status->setVisible(m_width.has_value() || m_opener->busy()); });
    connect(m_status, &StatusLine::cancelAsked, this, &MainWindow::cancelOpening);
    connect(&m_document, &Document::sceneOpened, this, [this] {
        m_errors->hide();
        showScene();
        showTitle();
    });
    connect(&m_document, &Document::sceneChanged, this, &MainWindow::enableActions);
    connect(&m_document, &Document::frameReady, this, &MainWindow::enableActions);
    connect(&m_document, &Document::pixelChanged, this, &MainWindow::enableActions);
    connect(&m_document.inspection(), &PixelInspection::changed, this, &MainWindow::enableActions);
    connect(&m_document, &Document::stageChanged, this, &MainWindow::enableActions);
    connect(&m_document, &Document::channelChanged, this, &MainWindow::enableActions);
    connect(&m_document, &Document::selectionChanged, this, &MainWindow::enableActions);
    connect(&m_document.stepper(), &Stepper::changed, this,
            [this] { enableStepActions(*m_actions, m_document, m_width.has_value()); });
    connect(m_document.undoStack(), &QUndoStack::indexChanged, this, [this] {
        enableActions();
        showTitle();
    });
    connect(m_document.undoStack(), &QUndoStack::cleanChanged, this, &MainWindow::showTitle);
    m_file = new FileWatch(m_document);
    m_file->setParent(this);
    connect(m_file, &FileWatch::changed, this, &MainWindow::takeFileChange);
    connect(&m_document, &Document::failed, this, [this](const pipeline::Errors& errors) {
        const QString file = errors.empty() ? QString() : shownName(toQString(errors.front().where.file));
        if (file.isEmpty()) return m_errors->report(tr("That cannot be done. Nothing has changed."), errors);
        const QString still = m_document.hasScene() ? tr(" The scene before is still open.") : QString();
        m_errors->report(tr("%1 could not be read.").arg(file) + still, errors);
    });
    connect(&m_document, &Document::outOfMemory, this, [this] {
        m_errors->report(tr("There is not enough memory for this frame. What you see is the one before."),
                         {{{}, "not enough memory; a smaller picture and fewer buffers need less", {}}});
    });
    connect(&MemoryNotice::instance(), &MemoryNotice::gaveUp, this, [this] {
        m_errors->report(
            tr("There is not enough memory for all that is asked for. Something that you see is as it was."),
            {{{}, "not enough memory; a smaller picture and fewer buffers need less", {}}});
    });
    connect(&m_document, &Document::notWritten, this, [this](const QString& file, const pipeline::Errors& errors) {
        m_errors->report(tr("%1 could not be written. Nothing has changed.").arg(shownName(file)), errors);
    });
}

void MainWindow::showTitle() {
    const bool shown = m_document.hasScene() && m_pages->currentWidget() == m_views;
    const QString name = shown ? onOneLine(m_document.scene().name) : QString();
    const QString edited = shown && m_document.isEdited() ? tr(" · edited") : QString();
    const QString written = shown && m_file && m_file->hasChanged() ? tr(" · its file has changed (F5)") : QString();
    const bool isLesson = m_aside && m_lessons->lesson();
    m_title->setText(isLesson ? lessonTitle() : name + edited + written);
    QString title = m_aside          ? toQString(m_lessons->lesson()->title) + QStringLiteral(" – Shadescope")
                    : name.isEmpty() ? QStringLiteral("Shadescope")
                                     : name + QStringLiteral(" – Shadescope");
    setWindowTitle(title.replace("[*]", "[*][*]"));  // Qt's own mark for what is not saved
}

// A file may be dropped anywhere: a text field, which would take its name as words, leaves it to the window.
bool MainWindow::dropsHere(QObject* watched, QEvent& event) {
    const auto* widget = qobject_cast<QWidget*>(watched);
    if (!widget || widget == this || widget->window() != this) return false;
    switch (event.type()) {
        case QEvent::DragEnter:
        case QEvent::DragMove:
        case QEvent::Drop: break;
        default: return false;
    }
    auto& drop = static_cast<QDropEvent&>(event);
    if (!widget->acceptDrops() || !drop.mimeData()->hasUrls()) return false;
    if (event.type() == QEvent::DragEnter) dragEnterEvent(static_cast<QDragEnterEvent*>(&event));
    if (event.type() == QEvent::DragMove) drop.acceptProposedAction();
    if (event.type() == QEvent::Drop) dropEvent(&drop);
    return true;
}

// What has the focus and a use of its own for the space bar, Home or End gets them; the timeline has them elsewhere.
static bool keepsKey(QObject* watched, const QKeyEvent& key) {
    if (key.modifiers() != Qt::NoModifier) return false;
    const bool edge = key.key() == Qt::Key_Home || key.key() == Qt::Key_End || key.key() == Qt::Key_PageUp ||
                      key.key() == Qt::Key_PageDown;
    const bool list = qobject_cast<QAbstractItemView*>(watched) || qobject_cast<QComboBox*>(watched);
    if (edge) return list || qobject_cast<QAbstractSlider*>(watched);
    return key.key() == Qt::Key_Space && (list || qobject_cast<QAbstractButton*>(watched));
}

// "Ctrl+←" and "Ctrl+→" go to a stage from anywhere, also from a text field that would take them.
// At the first and the last stage they say so, and do nothing else instead.
bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
    if (dropsHere(watched, *event)) return true;
    const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    if (isKey && isActiveWindow() && (m_width || m_opener->busy())) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() == Qt::Key_Escape && m_opener->busy()) {
            event->accept();
            if (event->type() == QEvent::KeyPress) cancelOpening();
            return true;
        }
        const bool isArrow = key->key() == Qt::Key_Left || key->key() == Qt::Key_Right;
        if (isArrow && key->modifiers() == Qt::ControlModifier) {
            event->setAccepted(event->type() == QEvent::KeyPress);
            const ActionId stage = key->key() == Qt::Key_Left ? ActionId::PreviousStage : ActionId::NextStage;
            if (event->isAccepted()) emit m_document.said((*m_actions)[stage]->property("whyNot").toString());
            return true;
        }
        if (event->type() == QEvent::ShortcutOverride && keepsKey(watched, *key)) {
            event->accept();
            return true;
        }
    }
    if (event->type() == QEvent::KeyPress && watched == this) takeLeftKey(*static_cast<QKeyEvent*>(event));
    return QMainWindow::eventFilter(watched, event);
}

// As the window is read, whatever was made first. In an overlay Tab goes round, for Esc leaves it.
bool MainWindow::focusNextPrevChild(bool next) {
    const QWidget* scope = this;
    for (QWidget* above = focusWidget(); above; above = above->parentWidget())
        if (qobject_cast<Popover*>(above)) scope = above;
    return focusNext(*scope, next) || QMainWindow::focusNextPrevChild(next);
}

// A key that nothing has taken: Esc cancels what takes long, another may be that of an action which cannot be done now.
void MainWindow::takeLeftKey(const QKeyEvent& key) {
    if (key.key() == Qt::Key_Escape && !m_document.work().running().isEmpty()) return m_document.work().cancel();
    for (const ActionRow& row : actionTable()) {
        const QAction* action = (*m_actions)[row.id];
        if (!action->isEnabled() && action->shortcuts().contains(QKeySequence(key.keyCombination())))
            emit m_document.said(action->property("whyNot").toString());
    }
}

void MainWindow::closeEvent(QCloseEvent* event) {
    m_presentation->end();
    if (!mayLeaveCues() || !mayLeaveScene()) return event->ignore();
    if (m_session) m_session->end(!wouldLoseChanges());
    keepPanels();
    saveWindowPlace(*this);
    saveTheme();
    QMainWindow::closeEvent(event);
}

// Whatever is dropped is answered: what cannot be opened, with the reason.
void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!event->mimeData()->hasUrls()) return;
    event->acceptProposedAction();
    m_start->setDropHint(true);
}

void MainWindow::dragLeaveEvent(QDragLeaveEvent*) { m_start->setDropHint(false); }

void MainWindow::dropEvent(QDropEvent* event) {
    m_start->setDropHint(false);
    event->acceptProposedAction();
    const QList<QUrl> urls = event->mimeData()->urls();
    const auto refuse = [this](const QString& found, const QString& expected) {
        emit m_document.failed({{{}, found.toStdString(), expected.toStdString()}});
    };
    QStringList paths;
    for (const QUrl& url : urls)
        if (url.isLocalFile()) paths += url.toLocalFile();
    if (paths.size() == urls.size() && isRendererDrop(paths)) return checkRenderer(paths);
    if (urls.size() != 1) return refuse(tr("%1 files were dropped").arg(urls.size()), tr("one scene or model"));
    if (!urls.front().isLocalFile())
        return refuse(tr("%1 is no file of this machine").arg(urls.front().toDisplayString()),
                      tr("a file; save it first"));
    openFile(urls.front().toLocalFile());
}

}  // namespace app
