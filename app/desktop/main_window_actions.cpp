#include <QApplication>
#include <QGuiApplication>
#include <QMenu>
#include <QStackedWidget>

#include "app/core/pointed.h"
#include "app/core/renderer_check.h"
#include "app/core/session_file.h"
#include "app/core/text.h"
#include "app/desktop/actions.h"
#include "app/desktop/command_palette.h"
#include "app/desktop/explain_actions.h"
#include "app/desktop/file_opening.h"
#include "app/desktop/key_sheet.h"
#include "app/desktop/main_window.h"
#include "app/desktop/manual_window.h"
#include "app/desktop/palette_commands.h"
#include "app/desktop/panel_docks.h"
#include "app/desktop/pixel_field.h"
#include "app/desktop/preferences_dialog.h"
#include "app/desktop/scene_files.h"
#include "app/desktop/show_apart.h"
#include "app/desktop/shown_state.h"
#include "app/desktop/slide_dialog.h"
#include "app/desktop/state_clipboard.h"
#include "app/desktop/step_actions.h"
#include "app/desktop/top_bar.h"
#include "app/desktop/view_area.h"
#include "app/desktop/window_centre.h"
#include "app/desktop/window_cues.h"
#include "app/desktop/window_layout.h"
#include "app/desktop/window_lessons.h"
#include "app/desktop/window_renderer.h"
#include "app/panels/buffer_canvas.h"
#include "app/panels/buffer_header.h"
#include "app/panels/buffer_overlays.h"
#include "app/panels/buffer_view.h"
#include "app/panels/bug_panel.h"
#include "app/panels/check_panel.h"
#include "app/panels/contract_list.h"
#include "app/panels/cue_panel.h"
#include "app/panels/export_dialog.h"
#include "app/panels/film_dialog.h"
#include "app/panels/follow_theme.h"
#include "app/panels/inspector_panel.h"
#include "app/panels/lesson_panel.h"
#include "app/panels/renderer_panel.h"
#include "app/panels/stage_card.h"
#include "app/panels/stage_strip.h"
#include "app/panels/study_panel.h"
#include "app/view3d/offscreen.h"
#include "lessons/state/cue_list.h"
#include "pipeline/formats/built_in_scenes.h"

namespace app {
namespace {

constexpr std::array kStageActions{ActionId::Transform,    ActionId::Cull,    ActionId::Normals,
                                   ActionId::ShadowBuffer, ActionId::ZBuffer, ActionId::Shading};
constexpr std::array kThemeActions{ActionId::DarkTheme, ActionId::LightTheme, ActionId::ProjectorTheme};
constexpr std::array kChannelActions{ActionId::RedChannel, ActionId::GreenChannel, ActionId::BlueChannel};

// Whose keys work while presenting too.
constexpr std::array kKeys{
    ActionId::NextCue,      ActionId::PreviousCue,   ActionId::KeepCue,        ActionId::Present,
    ActionId::NextStage,    ActionId::PreviousStage, ActionId::Play,           ActionId::StepOn,
    ActionId::StepBack,     ActionId::FirstStep,     ActionId::LastStep,       ActionId::RunToSelection,
    ActionId::Undo,         ActionId::Redo,          ActionId::Transform,      ActionId::Cull,
    ActionId::Normals,      ActionId::ShadowBuffer,  ActionId::ZBuffer,        ActionId::Shading,
    ActionId::DarkTheme,    ActionId::LightTheme,    ActionId::ProjectorTheme, ActionId::RedChannel,
    ActionId::GreenChannel, ActionId::BlueChannel,   ActionId::Bookmark1,      ActionId::Bookmark2,
    ActionId::Bookmark3,    ActionId::Bookmark4,     ActionId::Bookmark5,      ActionId::Bookmark6,
    ActionId::Bookmark7,    ActionId::Bookmark8,     ActionId::Bookmark9,      ActionId::OriginalSize};

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
    on(A::Open, [this] { m_opening->choose(); });
    on(A::ReadAgain, [this] { m_files->reload(); });
    on(A::Save, [this] { m_files->save(); });
    on(A::SaveAs, [this] { m_files->saveAs(); });
    on(A::Export, [this] { exportBuffers(false); });
    on(A::SaveBuffer, [this] { exportBuffers(true); });
    connect(&views(), &ViewArea::saveAsked, this, [this] { exportBuffers(true); });
    on(A::Slide, [this] { exportSlide(); });
    on(A::Film, [this] { exportFilm(); });
    on(A::Handout, [this] { m_docks->panels().lesson->writeHandout(); });
    on(A::CheckRenderer, [this] { m_renderer->chooseFolder(); });
    on(A::Close, [this] { m_files->close(); });
    on(A::RestoreSession, [](bool wanted) { SessionFile::setWanted(wanted); });
    on(A::Quit, [this] { close(); });
    on(A::Undo, [this] { m_document.history().stack()->undo(); });
    on(A::Redo, [this] { m_document.history().stack()->redo(); });
    on(A::CopyState, [this] { m_clipboard->copy(); });
    on(A::PasteState, [this] { m_clipboard->paste(); });
    // In views and on the start page: tables and formulas copy themselves.
    for (const A id : {A::CopyState, A::PasteState}) {
        removeAction(actions[id]);
        actions[id]->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        m_centre->pages().addAction(actions[id]);
    }
    on(A::TwoBufferViews, [this](bool shown) { views().setSecond(shown); });
    on(A::SplitRight, [this] { views().splitView(views().active(), lessons::ViewTree::Kind::Row); });
    on(A::SplitBelow, [this] { views().splitView(views().active(), lessons::ViewTree::Kind::Column); });
    on(A::TurnView, [this] { views().turnView(views().active()); });
    on(A::CloseView, [this] { views().closeView(views().active()); });
    on(A::EvenViews, [this] { views().makeEven(); });
    on(A::LinkViews, [this](bool linked) { views().setLinked(linked); });
    on(A::OriginalSize, [this] { views().activeBuffer().canvas()->setZoom(1); });
    on(A::NextView, [this] { views().goToNext(1); });
    on(A::PreviousView, [this] { views().goToNext(-1); });
    on(A::Thumbnails, [this](bool shown) { views().setThumbnails(shown); });
    on(A::LargerText, [this] { growText(0.05); });
    on(A::SmallerText, [this] { growText(-0.05); });
    on(A::FullScreen, [this](bool full) { full ? showFullScreen() : showNormal(); });
    on(A::NextStage, [this] { m_document.nextStage(); });
    on(A::PreviousStage, [this] { m_document.previousStage(); });
    on(A::GoToPixel, [this] {
        const auto& settings = m_document.scene().settings;
        m_pixelField->open({settings.width, settings.height}, m_document.pointing().pixel());
    });
    on(A::Unpick, [this] { m_document.pointing().pick(std::nullopt); });
    on(A::Study, [this] { showStudy(); });
    on(A::Check, [this] { showChecks(); });
    on(A::WrongPicture, [this] { showWrongPicture(); });
    on(A::Contracts, [this] { showContracts(); });
    connect(actions[A::WorstPixel], &QAction::triggered, &m_docks->panels().renderer->finding(),
            &RendererFinding::goToWorst);
    on(A::KeepCue, [this] { m_cues->keep(); });
    on(A::NextCue, [this] { m_cues->step(1); });
    on(A::PreviousCue, [this] { m_cues->step(-1); });
    on(A::Present, [this] { present(); });
    actions[A::NotesScreen]->setChecked(true);
    connect(m_docks->panels().cues, &CuePanel::presentAsked, this, &MainWindow::present);
    on(A::RunCommand, [this] {
        enableActions();
        m_palette->open(m_commands->all());
    });
    on(A::Preferences, [this] { showPreferences(); });
    on(A::Keys, [this] { m_keys->open(); });
    on(A::Manual, [this] { showManual(); });
    connectStepActions(*m_actions, m_document);
    connectExplainActions(*m_actions, m_document, *m_docks->panels().inspector, views());
    for (std::size_t i = 0; i < kStageActions.size(); ++i)
        on(kStageActions[i], [this, i] { m_document.setStage(pipeline::kStages[i]); });
    for (std::size_t i = 0; i < kThemeActions.size(); ++i)
        on(kThemeActions[i], [i] { Theme::current().set(ThemeId(i)); });
    for (std::size_t i = 0; i < kChannelActions.size(); ++i)
        on(kChannelActions[i], [this, i] { m_document.pointing().setChannel(int(i)); });
    connect(m_pixelField, &PixelField::entered, this, [this](glm::ivec2 pixel) {
        m_document.pointing().pick(pixel);
        views().focusBuffer();  // whose arrows move it on
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
        m_files->fillRecent(*m_recent);
    });
    // What the active buffer view has above its picture.
    QMenu* inspect = actions.menu("Inspect");
    const auto addOwn = [&](const QString& name, void (BufferHeader::*opens)(QMenu*)) {
        auto* menu = new QMenu(name, inspect);
        const QList<QAction*> all = inspect->actions();
        inspect->insertMenu(all[all.indexOf(actions[A::RedChannel]) - 1], menu);
        connect(menu, &QMenu::aboutToShow, this,
                [this, menu, opens] { (views().activeBuffer().header().*opens)(menu); });
        connect(inspect, &QMenu::aboutToShow, menu, [this, menu] { menu->setEnabled(m_layout->showsScene()); });
    };
    addOwn(tr("Overlays"), &BufferHeader::overlayMenuOpens);
    addOwn(tr("Compare with"), &BufferHeader::compareMenuOpens);
    QMenu* view = actions.menu("View");
    for (PanelDock* dock : m_docks->all()) view->insertAction(actions[A::TwoBufferViews], dock->toggleViewAction());
    followTheme(this, [this] { (*m_actions)[kThemeActions[std::size_t(Theme::current().id())]]->setChecked(true); });
}

void MainWindow::enableActions() {
    using A = ActionId;
    const bool scene = m_layout->showsScene();
    const QString noScene = tr("Open a scene first.");
    for (const A id :
         {A::Close, A::CopyState, A::GoToPixel, A::OriginalSize, A::TwoBufferViews, A::Thumbnails, A::LookLayout,
          A::ExplainLayout, A::CompareLayout, A::FourLayout, A::SpaceLayout, A::PictureLayout, A::KeepLayout,
          A::ResetLayout, A::RedChannel, A::GreenChannel, A::BlueChannel, A::Study})
        m_actions->setEnabled(id, scene, noScene);
    for (const A id : kStageActions) m_actions->setEnabled(id, scene, noScene);
    for (const A id : {A::Save, A::SaveAs})
        m_actions->setEnabled(id, scene && !m_lessons->isOpen(),
                              scene ? tr("Close the lesson first: this scene is its own.") : noScene);
    m_actions->setEnabled(A::ReadAgain, scene && m_document.kept().scene,
                          scene ? tr("This scene comes from no file.") : noScene);
    m_actions->setEnabled(A::Handout, m_docks->panels().lesson->lesson() != nullptr, tr("Open a lesson first."));
    enableViewActions();
    for (const A id : {A::Export, A::SaveBuffer, A::Slide, A::Film})
        m_actions->setEnabled(id, scene && m_document.frames().shown() && m_document.hidden().count() == 0,
                              !scene                             ? noScene
                              : m_document.hidden().count() != 0 ? tr("After your answer.")
                                                                 : tr("The first frame is not ready yet."));
    m_actions->setEnabled(A::CheckRenderer, !m_lessons->isOpen(), tr("Close the lesson first: this scene is its own."));
    const bool mayTell = m_document.hidden().count() == 0;
    m_actions->setEnabled(
        A::Contracts, scene && m_document.frames().shown() && mayTell,
        scene ? mayTell ? tr("The first frame is not ready yet.") : tr("After your answer.") : noScene);
    m_actions->setEnabled(A::WorstPixel, scene && m_document.renderer().report(),
                          scene ? tr("Check your renderer first: File, Check my renderer.") : noScene);
    m_actions->setEnabled(A::Unpick, scene && m_document.pointing().pixel(), tr("Pick a pixel first."));
    m_actions->setEnabled(A::NextStage, scene && m_document.stage() != pipeline::StageId::Shading,
                          scene ? tr("Already at the last stage; Ctrl+← goes back.") : noScene);
    m_actions->setEnabled(A::PreviousStage, scene && m_document.stage() != pipeline::StageId::Transform,
                          scene ? tr("Already at the first stage; Ctrl+→ goes on.") : noScene);
    enableStepActions(*m_actions, m_document, scene);
    enableCueActions();
    enableExplainActions(*m_actions, m_document, *m_docks->panels().inspector, scene);
    const QUndoStack& undo = *m_document.history().stack();
    m_actions->setEnabled(A::Undo, scene && undo.canUndo(), tr("Nothing to undo."));
    m_actions->setEnabled(A::Redo, scene && undo.canRedo(), tr("Nothing to redo."));
    const Actions& actions = *m_actions;
    actions[A::Undo]->setText(undo.canUndo() ? tr("Undo %1").arg(undo.undoText()) : tr("Undo"));
    actions[A::Redo]->setText(undo.canRedo() ? tr("Redo %1").arg(undo.redoText()) : tr("Redo"));
    actions[kStageActions[index(m_document.stage())]]->setChecked(true);
    actions[kChannelActions[std::size_t(m_document.pointing().channel())]]->setChecked(true);
    actions[A::RestoreSession]->setChecked(SessionFile::isWanted());
    actions[A::Thumbnails]->setChecked(views().hasThumbnails());
    m_docks->enable(scene);
}

void MainWindow::exportBuffers(bool onlyActive) {
    auto* dialog = new ExportDialog(m_document, this);
    if (auto now = m_shown->now()) {
        std::vector<pipeline::BufferName> shown;
        for (const auto& view : now->views)
            if (const auto name = pipeline::findAnyBuffer(view.buffer)) shown.push_back(*name);
        dialog->setShown(std::move(shown));
        now->scene.clear(), now->set.clear(), now->sceneText.clear();  // it stands beside it
        dialog->setState(toToml(*now));
    }
    QStringList files;
    for (const std::string& file : viewFiles()) files += toQString(file);
    dialog->setViews(writeViews, files);
    if (onlyActive) dialog->choose(views().activeBuffer().buffer());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void MainWindow::showStudy() {
    if (!m_study) m_study = new StudyPanel(m_document, this);
    showApart(*m_study);
}

void MainWindow::showManual() {
    const QString page =
        m_layout->showsViews() ? manualPageOf(QApplication::focusWidget()) : QStringLiteral("README.md");
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
        m_checks->setMayLeave([this] { return m_files->mayLeave(); });
    }
    showApart(*m_checks);
}

void MainWindow::showWrongPicture() {
    if (!m_bugs) {
        m_bugs = new BugPanel(this);
        connect(m_bugs, &BugPanel::lessonAsked, this, [this](const QString& lesson, const QString& heading) {
            m_lessons->openPage(lesson, heading);
            activateWindow();
        });
    }
    showApart(*m_bugs);
}

// Below the card of the stage on show.
void MainWindow::showContracts() {
    if (!m_contracts) {
        m_contracts = new ContractList(m_document, this);
        connect(m_contracts, &ContractList::violatorsAsked, this,
                [this](const pipeline::BufferName& buffer, std::optional<glm::ivec2> worst) {
                    BufferView& view = views().activeBuffer();
                    view.setBuffer(buffer);
                    view.features().overlays->set(OverlayId::Violators, true);
                    if (worst) m_document.pointing().pick(worst);
                });
    }
    const QWidget& card = m_top->strip().card(m_document.stage());
    m_contracts->open(card.mapToGlobal(QPoint(0, card.height() + 2)), m_document.stage());
}

void MainWindow::exportSlide() {
    const auto now = m_shown->now();
    if (!now) return;
    auto* dialog = new SlideDialog(m_document, views(), *now, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void MainWindow::exportFilm() {
    auto* dialog = new FilmDialog(m_document, views().first().buffer(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void MainWindow::enableCueActions() {
    using A = ActionId;
    const CueModel& model = m_cues->model();
    const QString none = tr("There are no cues; Ctrl+B keeps what you see as one.");
    m_actions->setEnabled(A::KeepCue, m_layout->showsScene(), tr("Open a scene first."));
    m_actions->setEnabled(A::NextCue, m_cues->turnsLesson() || model.current() + 1 < model.size(),
                          model.size() == 0 ? none : tr("This is the last cue."));
    m_actions->setEnabled(A::PreviousCue, m_cues->turnsLesson() || model.current() > 0,
                          model.size() == 0 ? none : tr("This is the first cue."));
    m_actions->setEnabled(A::Present, m_layout->showsScene() || model.size() > 0,
                          tr("Open a scene or a cue list first."));
    m_actions->setEnabled(A::NotesScreen, QGuiApplication::screens().size() > 1,
                          tr("There is one screen; the notes stand in the panel Cues."));
}

void MainWindow::enableViewActions() {
    using A = ActionId;
    const bool scene = m_layout->showsScene();
    const auto enable = [&](A id, const QString& whyNot) {
        m_actions->setEnabled(id, scene && whyNot.isEmpty(), scene ? whyNot : tr("Open a scene first."));
    };
    const lessons::ViewLeaf active = views().active();
    enable(A::SplitRight, views().whyNotSplit(active, lessons::ViewTree::Kind::Row));
    enable(A::SplitBelow, views().whyNotSplit(active, lessons::ViewTree::Kind::Column));
    enable(A::CloseView, views().whyNotClose(active));
    const bool alone = views().tree().kind == lessons::ViewTree::Kind::Leaf;
    enable(A::EvenViews, isEven(views().tree()) ? tr("They are equal.") : QString());
    for (const A id : {A::NextView, A::PreviousView}) enable(id, alone ? tr("It is the only view.") : QString());
    enable(A::TurnView, {});
    enable(A::LinkViews, views().hasSecond() ? QString() : tr("It needs two buffer views."));
    (*m_actions)[A::LinkViews]->setChecked(views().isLinked());
    (*m_actions)[A::TwoBufferViews]->setChecked(views().hasSecond());
}

void MainWindow::present() {
    QList<QAction*> keys;
    for (const ActionId id : kKeys) keys << (*m_actions)[id];
    m_cues->present(keys, (*m_actions)[ActionId::NotesScreen]->isChecked());
}

}  // namespace app
