#include "app/desktop/window_renderer.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "app/buffer_view/buffer_overlays.h"
#include "app/buffer_view/buffer_view.h"
#include "app/commands/actions.h"
#include "app/compare/buffer_compare.h"
#include "app/desktop/scene_files.h"
#include "app/desktop/window_lessons.h"
#include "app/docks/panel_docks.h"
#include "app/docks/window_layout.h"
#include "app/document/document.h"
#include "app/document/recent_files.h"
#include "app/document/renderer_check.h"
#include "app/lesson/lesson_panel.h"
#include "app/look/shown_name.h"
#include "app/look/text.h"
#include "app/my_renderer/renderer_panel.h"
#include "app/views/view_area.h"
#include "lessons/library.h"
#include "pipeline/compare/verdict.h"
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

// The scene that a folder was compared with last, else the one in it.
QString sceneFor(const QString& folder) {
    const auto files = recentFiles();
    const auto before = std::ranges::find(files, QFileInfo(folder).absoluteFilePath(), &RecentFile::file);
    return before != files.end() && QFileInfo(before->state).isFile() ? before->state : onlySceneIn(folder);
}

bool isMine(const QString& path, std::size_t lights) {
    const QFileInfo file(path);
    return file.isFile() && pipeline::foreign::findHanded(file.completeBaseName().toStdString(), lights).has_value();
}

}  // namespace

WindowRenderer::WindowRenderer(QWidget& window, Actions& actions, Document& document, const PanelDocks& docks,
                               ViewArea& views, WindowLayout& layout, SceneFiles& files, WindowLessons& lessons)
    : QObject(&window),
      m_window(window),
      m_document(document),
      m_docks(docks),
      m_views(views),
      m_layout(layout),
      m_files(files),
      m_lessons(lessons),
      m_panel(*docks.panels().renderer) {
    m_docks[PanelId::Renderer].hide();
    connect(&m_panel, &RendererPanel::folderAsked, this, &WindowRenderer::chooseFolder);
    connect(&m_panel, &RendererPanel::filesAsked, this, &WindowRenderer::chooseFiles);
    connect(&m_panel.finding(), &RendererFinding::begun, this, &WindowRenderer::setViews);
    connect(&m_panel.finding(), &RendererFinding::showAsked, this, &WindowRenderer::showInViews);
    connect(&m_panel, &RendererPanel::lessonAsked, &lessons, &WindowLessons::openPage);
    connect(&document.renderer(), &RendererCheck::compared, this, [this] {
        emit viewsChanged();
        if (!m_document.renderer().isOpen()) leave();
        remember();
    });
    connect(&lessons, &WindowLessons::begins, this, &WindowRenderer::leave);  // the lesson's scene is another
    addActions(actions);
}

void WindowRenderer::addActions(Actions& actions) {
    actions.add(
        {.id = ActionId::CheckRenderer,
         .menu = "File",
         .text = "Check my renderer…",
         .keys = "Ctrl+Shift+R",
         .tip = "Choose the folder that your own renderer has written: which of its stages is the first that "
                "is wrong?",
         .run = [this] { chooseFolder(); },
         .whyNot =
             [this] { return m_lessons.isOpen() ? tr("Close the lesson first: this scene is its own.") : QString(); },
         .needsScene = false,
         .startsGroup = true});
    actions.add({.id = ActionId::WorstPixel,
                 .menu = "Inspect",
                 .text = "Next worst pixel",
                 .keys = "Alt+W",
                 .tip = "Pick the pixel at which your renderer differs most; again: the next one.",
                 .run = [this] { m_panel.finding().goToWorst(); },
                 .whyNot =
                     [this] {
                         return m_document.renderer().report()
                                    ? QString()
                                    : tr("Check your renderer first: File, Check my renderer.");
                     }});
}

QString WindowRenderer::startFolder() const {
    const QStringList& before = m_document.renderer().paths();
    return before.isEmpty() ? QString() : before.front();
}

void WindowRenderer::chooseFolder() {
    checkChosen(
        {QFileDialog::getExistingDirectory(&m_window, tr("The folder that your renderer writes"), startFolder())});
}

void WindowRenderer::chooseFiles() {
    checkChosen(QFileDialog::getOpenFileNames(
        &m_window, tr("What your renderer has written"), startFolder(),
        tr("Buffers (*.npy *.png *.ppm *.pgm *.pfm *.exr *.csv *.tga *.bmp);;All files (*)")));
}

void WindowRenderer::checkChosen(QStringList paths) {
    paths.removeAll(QString());
    if (!paths.isEmpty()) check(paths);
}

bool WindowRenderer::accepts(const QStringList& paths) const {
    if (paths.size() == 1)
        return QFileInfo(paths.front()).isDir() && lessons::lessonAt(paths.front().toStdString()).empty();
    const std::size_t lights = m_document.hasScene() ? m_document.scene().lights.size() : 1;
    return !paths.isEmpty() && std::ranges::all_of(paths, [&](const QString& path) { return isMine(path, lights); });
}

void WindowRenderer::check(const QStringList& paths) {
    m_docks.panels().lesson->close();  // its scene is not the one that somebody has drawn
    if (!m_layout.showsScene()) {
        const QString scene = paths.size() == 1 ? sceneFor(paths.front()) : QString();
        if (scene.isEmpty()) {
            const std::string found = shownName(paths.front()).toStdString();
            emit m_document.failed({{{},
                                     "there is no scene to compare " + found + " with",
                                     "open the scene that your renderer draws, then choose the folder again; a folder "
                                     "may hold its scene"}});
            return;
        }
        m_files.open(scene, [this, paths] { check(paths); });
        return;
    }
    leave();
    showPanel();
    if (paths.size() == 1) addRecentFile(paths.front());
    m_document.renderer().open(paths);
}

// What was found stands in the list of recent files, with the scene, as far as hints do not keep it back.
void WindowRenderer::remember() {
    const RendererCheck& check = m_document.renderer();
    if (const auto report = check.shownStages(); report && check.paths().size() == 1)
        rememberPlace(QFileInfo(check.paths().front()).absoluteFilePath(),
                      toQString(pipeline::foreign::headline(*report)), toQString(m_document.scene().file));
}

void WindowRenderer::showPanel() {
    PanelDock& dock = m_docks[PanelId::Renderer];
    for (PanelDock* other : m_docks.left())
        if (other != &dock) other->hide();
    dock.show();
    dock.raise();
    m_layout.fit(WindowLayout::Fit::Always);
    m_panel.setFocus();
}

void WindowRenderer::setViews() {
    if (m_viewsBefore.isEmpty()) m_viewsBefore = QString::fromStdString(m_views.arrangement());
    m_views.setArrangement(kRendererViews);
    m_views.links().set(true);
    const std::vector<BufferView*> views = m_views.shownBuffers();
    for (std::size_t i = 0; i < views.size(); ++i) {
        views[i]->setBuffer(views.front()->buffer());
        views[i]->compare().compareWith(OtherSource{.kind = OtherSource::Kind::Mine});
        // The first shows mine; the others the reference, of which Shift shows mine.
        views[i]->compare().setMode(i == 0 && views.size() > 1 ? CompareMode::B : CompareMode::A);
        views[i]->features().overlays->set(OverlayId::Classes, i + 1 == views.size());
    }
    emit viewsChanged();
}

void WindowRenderer::showInViews(const pipeline::BufferName& buffer) {
    if (m_viewsBefore.isEmpty()) return m_views.showBuffer(buffer);
    for (BufferView* view : m_views.shownBuffers()) view->setBuffer(buffer);
}

// The views are again as they were.
void WindowRenderer::leave() {
    for (BufferView* view : m_views.shownBuffers()) {
        if (view->compare().isMine()) view->compare().compareWith(std::nullopt);
        view->features().overlays->set(OverlayId::Classes, false);
    }
    if (m_viewsBefore.isEmpty()) return;
    m_views.setArrangement(std::exchange(m_viewsBefore, QString()).toStdString());
    emit viewsChanged();
}

}  // namespace app
