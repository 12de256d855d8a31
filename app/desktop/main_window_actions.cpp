#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QStackedWidget>

#include "app/core/own_file.h"
#include "app/core/pointed.h"
#include "app/core/recent_files.h"
#include "app/core/renderer_check.h"
#include "app/core/session_file.h"
#include "app/core/text.h"
#include "app/desktop/actions.h"
#include "app/desktop/command_palette.h"
#include "app/desktop/explain_actions.h"
#include "app/desktop/key_sheet.h"
#include "app/desktop/layout_store.h"
#include "app/desktop/main_window.h"
#include "app/desktop/manual_window.h"
#include "app/desktop/panel_dock.h"
#include "app/desktop/pixel_field.h"
#include "app/desktop/preferences_dialog.h"
#include "app/desktop/show_apart.h"
#include "app/desktop/step_actions.h"
#include "app/desktop/view_area.h"
#include "app/panels/buffer_canvas.h"
#include "app/panels/buffer_header.h"
#include "app/panels/buffer_view.h"
#include "app/panels/check_panel.h"
#include "app/panels/export_dialog.h"
#include "app/panels/follow_theme.h"
#include "app/panels/handout_button.h"
#include "app/panels/inspector_panel.h"
#include "app/panels/lesson_panel.h"
#include "app/panels/lesson_shelf.h"
#include "app/panels/save_dialog.h"
#include "app/panels/study_panel.h"
#include "app/view3d/offscreen.h"
#include "pipeline/formats/format_table.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/scene/settings_table.h"

namespace app {
namespace {

constexpr std::array kStageActions{ActionId::Transform,    ActionId::Cull,    ActionId::Normals,
                                   ActionId::ShadowBuffer, ActionId::ZBuffer, ActionId::Shading};
constexpr std::array kThemeActions{ActionId::DarkTheme, ActionId::LightTheme, ActionId::ProjectorTheme};
constexpr std::array kChannelActions{ActionId::RedChannel, ActionId::GreenChannel, ActionId::BlueChannel};

// Everything that can be read, then any file.
QString fileFilters() {
    QStringList patterns;
    for (const pipeline::Format& format : pipeline::formatTable()) patterns << u'*' + toQString(format.extension);
    return MainWindow::tr("Scenes and models (%1);;Lessons (lesson.md);;All files (*)").arg(patterns.join(u' '));
}

}  // namespace

// The first step at once, what comes while the window is laid out anew in one: a held key would else queue up for seconds.
void MainWindow::growText(double by) {
    m_growth += by;
    if (m_grows.isActive()) return;
    Theme::current().setScale(Theme::current().scale() + std::exchange(m_growth, 0));
    m_grows.start();
}

void MainWindow::connectActions() {
    m_grows.setSingleShot(true);
    m_grows.setInterval(0);
    connect(&m_grows, &QTimer::timeout, this, [this] {
        if (m_growth != 0) growText(0);
    });
    using A = ActionId;
    const Actions& actions = *m_actions;
    const auto on = [&](A id, auto run) { connect(actions[id], &QAction::triggered, this, run); };
    on(A::Open, [this] { chooseFile(); });
    on(A::ReadAgain, [this] { readAgain(); });
    on(A::Save, [this] { saveScene(); });
    on(A::SaveAs, [this] { saveSceneAs(); });
    on(A::Export, [this] { exportBuffers(false); });
    on(A::SaveBuffer, [this] { exportBuffers(true); });
    connect(m_views, &ViewArea::saveAsked, this, [this] { exportBuffers(true); });
    on(A::Slide, [this] { exportSlide(); });
    on(A::Film, [this] { exportFilm(); });
    on(A::Handout, [this] { m_lessons->findChild<HandoutButton*>()->click(); });
    on(A::CheckRenderer, [this] { chooseRenderer(true); });
    on(A::Close, [this] { closeScene(); });
    on(A::RestoreSession, [](bool wanted) { SessionFile::setWanted(wanted); });
    on(A::Quit, [this] { close(); });
    on(A::Undo, [this] { m_document.undoStack()->undo(); });
    on(A::Redo, [this] { m_document.undoStack()->redo(); });
    on(A::CopyState, [this] { copyState(); });
    on(A::PasteState, [this] { pasteState(); });
    // In views and on the start page: tables and formulas copy themselves.
    for (const A id : {A::CopyState, A::PasteState}) {
        removeAction(actions[id]);
        actions[id]->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        m_pages->addAction(actions[id]);
    }
    on(A::TwoBufferViews, [this](bool shown) { m_views->setSecond(shown); });
    on(A::SplitRight, [this] { m_views->splitView(m_views->active(), lessons::ViewTree::Kind::Row); });
    on(A::SplitBelow, [this] { m_views->splitView(m_views->active(), lessons::ViewTree::Kind::Column); });
    on(A::TurnView, [this] { m_views->turnView(m_views->active()); });
    on(A::CloseView, [this] { m_views->closeView(m_views->active()); });
    on(A::EvenViews, [this] { m_views->makeEven(); });
    on(A::LinkViews, [this](bool linked) { m_views->setLinked(linked); });
    on(A::OriginalSize, [this] { m_views->activeBuffer().canvas()->setZoom(1); });
    on(A::NextView, [this] { m_views->goToNext(1); });
    on(A::PreviousView, [this] { m_views->goToNext(-1); });
    on(A::Thumbnails, [this](bool shown) { m_views->setThumbnails(shown); });
    on(A::LargerText, [this] { growText(0.05); });
    on(A::SmallerText, [this] { growText(-0.05); });
    on(A::FullScreen, [this](bool full) { full ? showFullScreen() : showNormal(); });
    connectLayouts();
    on(A::NextStage, [this] { m_document.nextStage(); });
    on(A::PreviousStage, [this] { m_document.previousStage(); });
    on(A::GoToPixel, [this] {
        const auto& settings = m_document.scene().settings;
        m_pixelField->open({settings.width, settings.height}, m_document.pixel());
    });
    on(A::Unpick, [this] { m_document.pick(std::nullopt); });
    on(A::Study, [this] { showStudy(); });
    on(A::Check, [this] { showChecks(); });
    on(A::RunCommand, [this] { m_palette->open(commands()); });
    on(A::Preferences, [this] { showPreferences(); });
    on(A::Keys, [this] { m_keys->open(); });
    on(A::Manual, [this] { showManual(); });
    connectStepActions(*m_actions, m_document);
    connectExplainActions(*m_actions, m_document, *findChild<InspectorPanel*>(), *m_views);
    for (std::size_t i = 0; i < kStageActions.size(); ++i)
        on(kStageActions[i], [this, i] { m_document.setStage(pipeline::kStages[i]); });
    for (std::size_t i = 0; i < kThemeActions.size(); ++i)
        on(kThemeActions[i], [i] { Theme::current().set(ThemeId(i)); });
    for (std::size_t i = 0; i < kChannelActions.size(); ++i)
        on(kChannelActions[i], [this, i] { m_document.setChannel(int(i)); });
    connect(m_pixelField, &PixelField::entered, this, [this](glm::ivec2 pixel) {
        m_document.pick(pixel);
        m_views->focusBuffer();  // whose arrows move it on
    });

    QMenu* file = actions.menu("File");
    m_recent = new QMenu(tr("Open recent"), file);
    auto* builtIn = new QMenu(tr("Scenes"), file);
    file->insertMenu(actions[A::Save], m_recent);
    file->insertMenu(actions[A::Save], builtIn);
    for (const pipeline::BuiltInScene& scene : pipeline::builtInScenes()) {
        builtIn->addAction(toQString(scene.title), [this, path = toQString(scene.file.string())] { openFile(path); });
    }
    connect(file, &QMenu::aboutToShow, this, [this] {
        enableActions();
        m_recent->clear();
        const std::vector<RecentFile> files = recentFiles();
        QStringList names = recentNames(files);
        names.replaceInStrings("&", "&&");  // else the letter after it would be a key
        for (std::size_t i = 0; i < files.size(); ++i)
            m_recent->addAction(names[qsizetype(i)], [this, path = files[i].file] { openRecent(path); });
        m_recent->setEnabled(!m_recent->isEmpty());
    });
    // What the active buffer view has above its picture.
    QMenu* inspect = actions.menu("Inspect");
    const auto addOwn = [&](const QString& name, void (BufferHeader::*opens)(QMenu*)) {
        auto* menu = new QMenu(name, inspect);
        const QList<QAction*> all = inspect->actions();
        inspect->insertMenu(all[all.indexOf(actions[A::RedChannel]) - 1], menu);
        connect(menu, &QMenu::aboutToShow, this,
                [this, menu, opens] { (m_views->activeBuffer().header().*opens)(menu); });
        connect(inspect, &QMenu::aboutToShow, menu, [this, menu] { menu->setEnabled(showsScene()); });
    };
    addOwn(tr("Overlays"), &BufferHeader::overlayMenuOpens);
    addOwn(tr("Compare with"), &BufferHeader::compareMenuOpens);
    QMenu* view = actions.menu("View");
    for (PanelDock* dock : m_docks) {
        view->insertAction(actions[A::TwoBufferViews], dock->toggleViewAction());
        if (!m_leftDocks.contains(dock)) continue;
        connect(dock->toggleViewAction(), &QAction::triggered, this, [this, dock](bool shown) {
            if (shown) showOneLeftDock(dock);
        });
    }
    followTheme(this, [this] { (*m_actions)[kThemeActions[std::size_t(Theme::current().id())]]->setChecked(true); });
}

void MainWindow::enableActions() {
    using A = ActionId;
    const bool scene = m_document.hasScene() && m_pages->currentWidget() == m_views;
    const QString noScene = tr("Open a scene first.");
    for (const A id :
         {A::Close, A::CopyState, A::GoToPixel, A::OriginalSize, A::TwoBufferViews, A::Thumbnails, A::LookLayout,
          A::ExplainLayout, A::CompareLayout, A::FourLayout, A::SpaceLayout, A::PictureLayout, A::KeepLayout,
          A::ResetLayout, A::RedChannel, A::GreenChannel, A::BlueChannel, A::Study})
        m_actions->setEnabled(id, scene, noScene);
    for (const A id : kStageActions) m_actions->setEnabled(id, scene, noScene);
    for (const A id : {A::Save, A::SaveAs})
        m_actions->setEnabled(id, scene && !m_aside,
                              scene ? tr("Close the lesson first: this scene is its own.") : noScene);
    m_actions->setEnabled(A::ReadAgain, scene && m_document.kept().scene,
                          scene ? tr("This scene comes from no file.") : noScene);
    m_actions->setEnabled(A::Handout, m_lessons->lesson() != nullptr, tr("Open a lesson first."));
    enableViewActions();
    for (const A id : {A::Export, A::SaveBuffer, A::Slide, A::Film})
        m_actions->setEnabled(id, scene && m_document.frame() && m_document.hidden().count() == 0,
                              !scene                             ? noScene
                              : m_document.hidden().count() != 0 ? tr("After your answer.")
                                                                 : tr("The first frame is not ready yet."));
    m_actions->setEnabled(A::CheckRenderer, !m_aside, tr("Close the lesson first: this scene is its own."));
    const bool mayTell = m_document.hidden().count() == 0;
    m_actions->setEnabled(
        A::Contracts, scene && m_document.frame() && mayTell,
        scene ? mayTell ? tr("The first frame is not ready yet.") : tr("After your answer.") : noScene);
    m_actions->setEnabled(A::WorstPixel, scene && m_document.renderer().report(),
                          scene ? tr("Check your renderer first: File, Check my renderer.") : noScene);
    m_actions->setEnabled(A::Unpick, scene && m_document.pixel(), tr("Pick a pixel first."));
    m_actions->setEnabled(A::NextStage, scene && m_document.stage() != pipeline::StageId::Shading,
                          scene ? tr("Already at the last stage; Ctrl+← goes back.") : noScene);
    m_actions->setEnabled(A::PreviousStage, scene && m_document.stage() != pipeline::StageId::Transform,
                          scene ? tr("Already at the first stage; Ctrl+→ goes on.") : noScene);
    enableStepActions(*m_actions, m_document, scene);
    enableCueActions();
    enableExplainActions(*m_actions, m_document, *findChild<InspectorPanel*>(), scene);
    const QUndoStack& undo = *m_document.undoStack();
    m_actions->setEnabled(A::Undo, scene && undo.canUndo(), tr("Nothing to undo."));
    m_actions->setEnabled(A::Redo, scene && undo.canRedo(), tr("Nothing to redo."));
    const Actions& actions = *m_actions;
    actions[A::Undo]->setText(undo.canUndo() ? tr("Undo %1").arg(undo.undoText()) : tr("Undo"));
    actions[A::Redo]->setText(undo.canRedo() ? tr("Redo %1").arg(undo.redoText()) : tr("Redo"));
    actions[kStageActions[index(m_document.stage())]]->setChecked(true);
    actions[kChannelActions[std::size_t(m_document.channel())]]->setChecked(true);
    actions[A::RestoreSession]->setChecked(SessionFile::isWanted());
    actions[A::Thumbnails]->setChecked(m_views->hasThumbnails());
    for (PanelDock* dock : m_docks)
        dock->toggleViewAction()->setEnabled(scene && whyHidden(dock->objectName()).isEmpty());
}

void MainWindow::chooseFile() {
    const QString file = QFileDialog::getOpenFileName(this, tr("Open a file"), QString(), fileFilters());
    if (!file.isEmpty()) openFile(file);
}

// To its own file without a question, where nothing is lost with what stands there.
bool MainWindow::saveScene() {
    const QString own = ownFile(m_document);
    return own.isEmpty() ? saveSceneAs() : m_document.save(own);
}

bool MainWindow::saveSceneAs() {
    const QFileInfo opened(toQString(m_document.scene().file)), named(toQString(m_document.scene().name));
    const bool hasFile = !opened.fileName().isEmpty();
    const QString proposed = (hasFile ? opened.dir() : QDir::home())
                                 .filePath((hasFile ? opened : named).completeBaseName() + QStringLiteral(".toml"));
    const QString file = askWhereToSave(this, tr("Save the scene"), proposed, tr("Scenes (*.toml)"), "toml");
    if (file.isEmpty() || !m_document.save(file)) return false;
    addRecentFile(file);
    return true;
}

void MainWindow::exportBuffers(bool onlyActive) {
    auto* dialog = new ExportDialog(m_document, this);
    if (auto now = state({})) {
        std::vector<pipeline::BufferName> shown;
        for (const auto& view : now->views)
            if (const auto name = pipeline::findAnyBuffer(view.buffer)) shown.push_back(*name);
        dialog->setShown(std::move(shown));
        now->scene.clear(), now->set.clear(), now->sceneText.clear();  // it stands beside it
        dialog->setState(toToml(*now));
    }
    QStringList views;
    for (const std::string& file : viewFiles()) views += toQString(file);
    dialog->setViews(writeViews, views);
    if (onlyActive) dialog->choose(m_views->activeBuffer().buffer());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void MainWindow::showStudy() {
    if (!m_study) m_study = new StudyPanel(m_document, this);
    showApart(*m_study);
}

void MainWindow::showManual() {
    const QString page = m_width ? manualPageOf(QApplication::focusWidget()) : QStringLiteral("README.md");
    if (!m_manual) m_manual = new ManualWindow(this);
    m_manual->open(page);
}

void MainWindow::showPreferences() {
    auto* dialog = new PreferencesDialog(this);
    connect(dialog, &PreferencesDialog::keysAsked, this, [this] { m_keys->open(); });
    connect(dialog, &QDialog::finished, this, &MainWindow::enableActions);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void MainWindow::showChecks() {
    if (!m_checks) {
        m_checks = new CheckPanel(m_document, this);
        m_checks->setMayLeave([this] { return mayLeaveScene(); });
    }
    showApart(*m_checks);
}

}  // namespace app
