// Somebody else's renderer in the MainWindow: its folder, and the views that show mine, reference and classes.
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>

#include "app/core/renderer_check.h"
#include "app/core/shown_name.h"
#include "app/core/text.h"
#include "app/desktop/actions.h"
#include "app/desktop/main_window.h"
#include "app/desktop/panel_dock.h"
#include "app/desktop/show_apart.h"
#include "app/desktop/view_area.h"
#include "app/panels/buffer_compare.h"
#include "app/panels/buffer_overlays.h"
#include "app/panels/buffer_view.h"
#include "app/panels/bug_panel.h"
#include "app/panels/contract_list.h"
#include "app/panels/lesson_panel.h"
#include "app/panels/renderer_panel.h"
#include "app/panels/stage_card.h"
#include "app/panels/stage_strip.h"
#include "lessons/library.h"
#include "pipeline/formats/format_table.h"

namespace app {
namespace {

// Mine, reference, and below them the classes.
constexpr const char* kRendererViews = "(buffer | buffer) / buffer";

// The scene in a folder, where there is one and no other.
QString onlySceneIn(const QString& folder) {
    QStringList found;
    for (const QFileInfo& file : QDir(folder).entryInfoList(QDir::Files)) {
        if (file.fileName() == QLatin1String("mine.toml")) continue;
        const QString name = file.fileName().toLower();
        if (name.endsWith(".toml") || name.endsWith(".scene")) found += file.absoluteFilePath();
    }
    return found.size() == 1 ? found.front() : QString();
}

bool isMine(const QString& path, std::size_t lights) {
    const QFileInfo file(path);
    return file.isFile() && pipeline::foreign::findHanded(file.completeBaseName().toStdString(), lights).has_value();
}

}  // namespace

void MainWindow::connectRenderer() {
    m_renderer = findChild<RendererPanel*>();
    findChild<PanelDock*>("renderer")->hide();
    connect(m_renderer, &RendererPanel::folderAsked, this, [this] { chooseRenderer(true); });
    connect(m_renderer, &RendererPanel::filesAsked, this, [this] { chooseRenderer(false); });
    connect(&m_renderer->finding(), &RendererFinding::begun, this, &MainWindow::setViewsToRenderer);
    connect(&m_renderer->finding(), &RendererFinding::showAsked, this, &MainWindow::showInViews);
    connect(m_renderer, &RendererPanel::lessonAsked, this, &MainWindow::goToLessonPage);
    connect(&m_document.renderer(), &RendererCheck::compared, this, [this] {
        enableActions();
        if (!m_document.renderer().isOpen()) leaveRenderer();
    });
    connect((*m_actions)[ActionId::WrongPicture], &QAction::triggered, this, &MainWindow::showWrongPicture);
    connect((*m_actions)[ActionId::Contracts], &QAction::triggered, this, &MainWindow::showContracts);
    connect((*m_actions)[ActionId::WorstPixel], &QAction::triggered, &m_renderer->finding(),
            &RendererFinding::goToWorst);
}

void MainWindow::chooseRenderer(bool folder) {
    const QStringList& before = m_document.renderer().paths();
    const QString start = before.isEmpty() ? QString() : before.front();
    QStringList paths;
    if (folder)
        paths += QFileDialog::getExistingDirectory(this, tr("The folder that your renderer writes"), start);
    else
        paths = QFileDialog::getOpenFileNames(this, tr("What your renderer has written"), start,
                                              tr("Buffers (*.npy *.png *.ppm *.pgm *.pfm *.exr *.csv);;All files (*)"));
    paths.removeAll(QString());
    if (!paths.isEmpty()) checkRenderer(paths);
}

// A folder that is no lesson, or several files that are all named as buffers are.
bool MainWindow::isRendererDrop(const QStringList& paths) const {
    if (paths.size() == 1)
        return QFileInfo(paths.front()).isDir() && lessons::lessonAt(paths.front().toStdString()).empty();
    const std::size_t lights = m_document.hasScene() ? m_document.scene().lights.size() : 1;
    return !paths.isEmpty() && std::ranges::all_of(paths, [&](const QString& path) { return isMine(path, lights); });
}

void MainWindow::checkRenderer(const QStringList& paths) {
    m_lessons->close();  // its scene is not the one that somebody has drawn
    if (!showsScene()) {
        const QString scene = paths.size() == 1 ? onlySceneIn(paths.front()) : QString();
        if (scene.isEmpty()) {
            const std::string found = shownName(paths.front()).toStdString();
            emit m_document.failed({{{},
                                     "there is no scene to compare " + found + " with",
                                     "open the scene that your renderer draws, then choose the folder again; a folder "
                                     "may hold its scene"}});
            return;
        }
        openFile(scene, [this, paths] { checkRenderer(paths); });
        return;
    }
    leaveRenderer();
    showRenderer();
    m_document.renderer().open(paths);
}

void MainWindow::showRenderer() {
    auto* dock = findChild<PanelDock*>("renderer");
    for (PanelDock* other : m_leftDocks)
        if (other != dock) other->hide();
    dock->show();
    dock->raise();
    fitWidth(true);
    m_renderer->setFocus();
}

void MainWindow::setViewsToRenderer() {
    if (m_viewsBeforeRenderer.isEmpty()) m_viewsBeforeRenderer = QString::fromStdString(m_views->arrangement());
    m_views->setArrangement(kRendererViews);
    m_views->setLinked(true);
    const std::vector<BufferView*> views = m_views->shownBuffers();
    for (std::size_t i = 0; i < views.size(); ++i) {
        views[i]->setBuffer(views.front()->buffer());
        views[i]->compare().compareWith(OtherSource{.kind = OtherSource::Kind::Mine});
        // The first shows mine; the others the reference, of which Shift shows mine.
        views[i]->compare().setMode(i == 0 && views.size() > 1 ? CompareMode::B : CompareMode::A);
        views[i]->features().overlays->set(OverlayId::Classes, i + 1 == views.size());
    }
    enableActions();
}

void MainWindow::showInViews(const pipeline::BufferName& buffer) {
    if (m_viewsBeforeRenderer.isEmpty()) return m_views->showBuffer(buffer);
    for (BufferView* view : m_views->shownBuffers()) view->setBuffer(buffer);
}

// The views are again as they were.
void MainWindow::leaveRenderer() {
    for (BufferView* view : m_views->shownBuffers()) {
        if (view->compare().isMine()) view->compare().compareWith(std::nullopt);
        view->features().overlays->set(OverlayId::Classes, false);
    }
    if (m_viewsBeforeRenderer.isEmpty()) return;
    m_views->setArrangement(std::exchange(m_viewsBeforeRenderer, QString()).toStdString());
    enableActions();
}

void MainWindow::showWrongPicture() {
    auto* bugs = findChild<BugPanel*>();
    if (!bugs) {
        bugs = new BugPanel(this);
        connect(bugs, &BugPanel::lessonAsked, this, [this](const QString& lesson, const QString& heading) {
            goToLessonPage(lesson, heading);
            activateWindow();
        });
    }
    showApart(*bugs);
}

// Below the card of the stage on show.
void MainWindow::showContracts() {
    auto* contracts = findChild<ContractList*>();
    if (!contracts) {
        contracts = new ContractList(m_document, this);
        connect(contracts, &ContractList::violatorsAsked, this,
                [this](const pipeline::BufferName& buffer, std::optional<glm::ivec2> worst) {
                    BufferView& view = m_views->activeBuffer();
                    view.setBuffer(buffer);
                    view.features().overlays->set(OverlayId::Violators, true);
                    if (worst) m_document.pick(worst);
                });
    }
    const QWidget& card = m_strip->card(m_document.stage());
    contracts->open(card.mapToGlobal(QPoint(0, card.height() + 2)), m_document.stage());
}

void MainWindow::goToLessonPage(const QString& lesson, const QString& heading) {
    openLesson(lesson);
    const lessons::Lesson* open = m_lessons->lesson();
    if (!open) return;
    for (std::size_t i = 0; i < open->pages.size(); ++i)
        if (toQString(open->pages[i].heading) == heading) m_lessons->goTo(int(i));
}

}  // namespace app
