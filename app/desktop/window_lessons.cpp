#include "app/desktop/window_lessons.h"

#include <QFileInfo>
#include <QLabel>
#include <QMainWindow>
#include <QToolBar>
#include <algorithm>

#include "app/commands/actions.h"
#include "app/desktop/shown_state.h"
#include "app/docks/edge_tab.h"
#include "app/docks/panel_docks.h"
#include "app/docks/status_line.h"
#include "app/docks/window_centre.h"
#include "app/document/hand.h"
#include "app/document/recent_files.h"
#include "app/document/scene_opener.h"
#include "app/lesson/lesson_keys.h"
#include "app/lesson/lesson_panel.h"
#include "app/look/shown_name.h"
#include "app/look/text.h"
#include "app/look/theme.h"
#include "app/stages/stage_strip.h"
#include "app/start/start_order.h"
#include "app/start/start_page.h"
#include "app/talk/presentation.h"
#include "app/views/view_area.h"
#include "app/widgets/error_list.h"
#include "app/widgets/follow_theme.h"
#include "lessons/library.h"

namespace app {
namespace {

bool has(const std::vector<lessons::Part>& parts, std::optional<lessons::Part> part) {
    return part && std::ranges::find(parts, *part) != parts.end();
}

// The heading by which a dock is moved.
void showHeading(PanelDock& dock, bool shown) {
    QWidget* bar = dock.titleBarWidget();
    bar->setFixedHeight(shown ? Theme::current().px(32) : 0);
    for (QWidget* part : bar->findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) part->setVisible(shown);
}

}  // namespace

WindowLessons::WindowLessons(QMainWindow& window, Actions& actions, Document& document, SceneOpener& opener,
                             const WindowCentre& centre, const AroundViews& around, const PanelDocks& docks,
                             WindowLayout& layout, ShownState& shown, const Presentation& presentation)
    : QObject(&window),
      m_window(window),
      m_document(document),
      m_opener(opener),
      m_centre(centre),
      m_around(around),
      m_docks(docks),
      m_lessons(*docks.panels().lesson),
      m_layout(layout),
      m_shown(shown),
      m_presentation(presentation),
      m_edge(new QToolBar(tr("Closed panels"), &window)),
      m_inspectorTab(new EdgeTab(m_edge)) {
    m_lessons.keys().takeKeysOf(m_centre.views());
    connect(&m_lessons, &LessonPanel::opens, this, &WindowLessons::begin);
    connect(&m_lessons, &LessonPanel::closed, this, &WindowLessons::end);
    connect(&m_lessons, &LessonPanel::showViews, &shown, &ShownState::lookAt);
    for (const auto signal : {&LessonPanel::pageChanged, &LessonPanel::onlyThisChanged})
        connect(&m_lessons, signal, this, &WindowLessons::showParts);
    connect(&m_lessons, &LessonPanel::pageChanged, this, &WindowLessons::remember);
    connect(&document, &Document::hiddenChanged, this, &WindowLessons::showParts);
    connect(&document.hand(), &Hand::taken, this, &WindowLessons::showParts);
    connect(&document.hand(), &Hand::insideAsked, this, [this] { m_lessons.setOnlyThis(!m_lessons.isOnlyThis()); });
    connect(&layout, &WindowLayout::fitted, this, &WindowLessons::showParts);
    connect(&layout, &WindowLayout::startShows, this, &WindowLessons::listOnStartPage);
    makeBanner();
    makeEdge();
    actions.add({.id = ActionId::Handout,
                 .menu = "File",
                 .text = "Lesson as a handout…",
                 .keys = "",
                 .tip = "Write the open lesson as pages for a browser.",
                 .run = [this] { m_lessons.writeHandout(); },
                 .whyNot = [this] { return m_lessons.lesson() ? QString() : tr("Open a lesson first."); },
                 .needsScene = false});
}

void WindowLessons::makeBanner() {
    QLabel& banner = m_centre.banner();
    connect(&m_lessons, &LessonPanel::bannerChanged, this, [this, &banner] {
        banner.setText(m_lessons.banner());
        banner.setVisible(!banner.text().isEmpty());
    });
    followTheme(&banner, [this, &banner] {
        const Theme& theme = Theme::current();
        showParts();  // the docks have made their headings anew
        banner.setFont(theme.text(13, 600));
        banner.setMargin(theme.px(6));
        banner.setStyleSheet(QStringLiteral("background: %1; border-bottom: 2px solid %2;")
                                 .arg(theme.colors().tint.name(), theme.colors().accent.name()));
    });
}

void WindowLessons::makeEdge() {
    m_edge->setObjectName("edge");
    m_edge->setMovable(false);
    m_edge->toggleViewAction()->setVisible(false);  // it is no panel
    m_inspectorTab->setObjectName("inspectorTab");
    m_inspectorTab->setText(tr("Inspector"));
    m_edge->addWidget(m_inspectorTab);
    m_window.addToolBar(Qt::RightToolBarArea, m_edge);
    m_edge->hide();
    connect(m_inspectorTab, &QAbstractButton::clicked, this, [this] {
        PanelDock& dock = m_docks[PanelId::Inspector];
        dock.show(), dock.raise();
        m_edge->hide();
    });
}

// The lessons on the start page, with how far the reader has come.
void WindowLessons::listOnStartPage() {
    std::vector<StartLesson> entries;
    const LessonShelf& shelf = m_lessons.shelf();
    for (int i = 0; i < shelf.rowCount(); ++i) {
        const auto text = [&](int role) { return shelf.data(shelf.index(i), role); };
        const lessons::Lesson& lesson = shelf.listed(i);
        entries.push_back({text(LessonShelf::NameRole).toString(), text(LessonShelf::TitleRole).toString(),
                           text(LessonShelf::SummaryRole).toString(), text(LessonShelf::PageRole).toInt(),
                           text(LessonShelf::PagesRole).toInt(), lesson.minutes, lectureOf(lesson.lecture)});
    }
    m_centre.start().setLessons(entries);
}

void WindowLessons::open(const QString& name) {
    if (m_lessons.open(name)) show();
}

bool WindowLessons::openAt(const std::filesystem::path& folder) {
    // One of the program's keeps its progress.
    std::error_code ignored;
    if (const QString name = toQString(folder.filename().string());
        m_lessons.shelf().findListed(name) &&
        std::filesystem::equivalent(folder, lessons::lessonFolder() / folder.filename(), ignored)) {
        open(name);
        return true;
    }
    auto lesson = lessons::readLesson(folder);
    if (!lesson) {
        m_centre.errors().report(tr("This lesson could not be read."), lesson.errors());
        return false;
    }
    lessons::Lesson own = std::move(lesson).value();
    own.name = QFileInfo(toQString(folder.string())).canonicalFilePath().toStdString();
    if (!m_lessons.openOwn(std::move(own))) return false;
    show();
    return true;
}

void WindowLessons::openPage(const QString& lesson, const QString& heading) {
    open(lesson);
    const lessons::Lesson* const opened = m_lessons.lesson();
    if (!opened) return;
    for (std::size_t i = 0; i < opened->pages.size(); ++i)
        if (toQString(opened->pages[i].heading) == heading) m_lessons.goTo(int(i));
}

// Among the recent files, with the page.
void WindowLessons::remember() const {
    const lessons::Lesson* const lesson = m_lessons.lesson();
    if (!lesson || lesson->folder.empty()) return;
    const QString file = QFileInfo(toQString((lesson->folder / "lesson.md").string())).absoluteFilePath();
    const int again = int(returningPages(*lesson)), page = m_lessons.page() + 1 - again;
    if (recentFiles().empty() || recentFiles().front().file != file) addRecentFile(file, onOneLine(lesson->title));
    rememberPlace(
        file, page > 0 ? tr("lesson, page %1 of %2").arg(page).arg(int(lesson->pages.size()) - again) : tr("lesson"),
        {});
}

void WindowLessons::show() {
    m_layout.showViews();  // a scene that was closed, and is the lesson's, is not opened anew
    showParts();
    emit changed();
}

void WindowLessons::begin() {
    m_opener.cancel();
    emit begins();
    m_aside.emplace();
    m_layout.setKept(false);
    m_aside->thumbnails = m_centre.views().hasThumbnails();
    m_aside->looks.stage = m_document.stage();
    m_aside->looks.step = m_document.stepper().level();
    m_aside->looks.algorithm = m_document.stepper().showsAlgorithm();
    m_centre.views().fill(m_aside->looks);
    if (!m_layout.showsScene()) return;
    m_aside->state = m_shown.now();
    m_aside->scene.emplace(m_document);
    for (const PanelDock* dock : m_docks.all())
        if (!dock->isHidden()) m_aside->panels << dock->row().id;
}

void WindowLessons::end() {
    const Before before = *std::exchange(m_aside, std::nullopt);
    m_edge->hide();
    m_centre.views().setThumbnails(before.thumbnails);
    m_centre.views().setHeld(false);
    m_around.status.setQuiet(false);
    showHeading(m_docks[PanelId::Lesson], true);
    if (!before.scene) m_layout.showStart();  // which does not keep the lesson's panels
    m_layout.setKept(true);
    if (!before.scene) return m_shown.showPlace(before.looks);
    before.scene->putBack(m_document);
    m_shown.showPlace(before.state ? *before.state : before.looks);
    m_around.strip.setVisible(true);
    m_around.timelineBar.setVisible(true);
    m_layout.fit(WindowLayout::Fit::Always);
    for (PanelDock* dock : m_docks.all()) dock->setVisible(before.panels.contains(dock->row().id));
    emit changed();
    emit m_document.said(tr("Your scene is as it was."));
}

QString WindowLessons::name() const {
    return isOpen() && m_lessons.lesson() ? toQString(m_lessons.lesson()->title) : QString();
}

QString WindowLessons::title() const {
    const QString title = tr("Lesson: %1").arg(name());
    return m_aside->scene ? title + tr(" · your scene stays as it was") : title;
}

// On show are the lesson, what its page names, and, unless it is only this, what was there before; nothing that is hidden
// until a question is answered.
void WindowLessons::showParts() {
    using lessons::Part;
    if (!m_aside || !m_lessons.lesson() || !m_layout.showsViews() || m_presentation.changesWindow()) return;
    const bool only = m_lessons.isOnlyThis();
    const auto& needed = m_lessons.run().isAtEnd() ? std::vector<Part>() : m_lessons.run().current().panels;
    for (PanelDock* dock : m_docks.all()) {
        const PanelId id = dock->row().id;
        const bool wanted = has(needed, dock->row().part) || (!only && m_aside->panels.contains(id));
        dock->setVisible(id == PanelId::Lesson || (wanted && m_docks.whyHidden(id).isEmpty()));
    }
    m_docks[PanelId::Lesson].raise();
    const bool isTimed = !m_document.hidden().hides(Part::Timeline) && (!only || has(needed, Part::Timeline));
    m_around.timelineBar.setVisible(isTimed);
    m_docks.rail().setVisible(!only && !m_layout.isWide());
    if (only) m_around.strip.setCompact(true);
    // A held picture fills the window, but for the lesson.
    const bool isHeld = m_lessons.isHeld();
    showHeading(m_docks[PanelId::Lesson], !isHeld);
    m_around.status.setQuiet(isHeld);
    m_centre.views().setHeld(isHeld);
    m_centre.views().setThumbnails(!isHeld && m_aside->thumbnails);
    m_around.strip.setVisible(!isHeld);
    m_edge->setVisible(!isHeld && m_docks[PanelId::Inspector].isHidden() &&
                       m_docks.whyHidden(PanelId::Inspector).isEmpty());
    sizePanels();
    emit changed();
}

// The page has the width of its lines, whatever stood there before.
void WindowLessons::sizePanels() {
    PanelDock *const lesson = &m_docks[PanelId::Lesson], *const settings = &m_docks[PanelId::Settings];
    const double width = m_window.width() < 1440 ? 392 : 468;
    m_window.resizeDocks({lesson}, {int(width * (0.4 + 0.6 * Theme::current().scale()))}, Qt::Horizontal);
    // The card of a question has the settings that it is about; the panel above it shows some rows and scrolls.
    if (const int low = Theme::current().px(190); !settings->isHidden() && !settings->isFloating())
        m_window.resizeDocks({settings, lesson}, {low, std::max(low, m_window.height() - low)}, Qt::Vertical);
}

}  // namespace app
