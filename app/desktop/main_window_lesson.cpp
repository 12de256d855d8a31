// A lesson in the MainWindow: the user's scene is put aside, the panels that a page does not need are hidden.
#include <QFileInfo>
#include <QLabel>
#include <QTimer>
#include <QToolBar>
#include <algorithm>

#include "app/core/scene_opener.h"
#include "app/core/text.h"
#include "app/core/theme.h"
#include "app/desktop/edge_tab.h"
#include "app/desktop/main_window.h"
#include "app/desktop/panel_dock.h"
#include "app/desktop/panel_table.h"
#include "app/desktop/view_area.h"
#include "app/panels/error_list.h"
#include "app/panels/follow_theme.h"
#include "app/panels/lesson_panel.h"
#include "app/panels/stage_strip.h"
#include "app/panels/start_page.h"
#include "app/panels/timeline.h"
#include "lessons/library.h"

namespace app {
namespace {

using lessons::Part;

std::optional<Part> partOf(const QString& panel) {
    const auto* const found = std::ranges::find(lessons::kPartNames, panel.toStdString());
    if (found == lessons::kPartNames.end()) return {};
    return Part(found - lessons::kPartNames.begin());
}

bool has(const std::vector<Part>& parts, std::optional<Part> part) {
    return part && std::ranges::find(parts, *part) != parts.end();
}

}  // namespace

void MainWindow::connectLessons() {
    m_lessons = findChild<LessonPanel*>();
    connect(m_lessons, &LessonPanel::opens, this, &MainWindow::beginLesson);
    connect(m_lessons, &LessonPanel::closed, this, &MainWindow::endLesson);
    connect(m_lessons, &LessonPanel::showViews, this, &MainWindow::lookAt);
    for (const auto signal : {&LessonPanel::pageChanged, &LessonPanel::onlyThisChanged})
        connect(m_lessons, signal, this, &MainWindow::showLessonParts);
    connect(&m_document, &Document::hiddenChanged, this, &MainWindow::showLessonParts);
    m_banner->setObjectName("banner");
    m_banner->hide();
    connect(m_lessons, &LessonPanel::bannerChanged, this, [this] {
        m_banner->setText(m_lessons->banner());
        m_banner->setVisible(!m_banner->text().isEmpty());
    });
    m_edge = new QToolBar(tr("Closed panels"), this);
    m_edge->setObjectName("edge");
    m_edge->setMovable(false);
    m_edge->toggleViewAction()->setVisible(false);  // it is no panel
    m_inspectorTab = new EdgeTab(m_edge);
    m_inspectorTab->setObjectName("inspectorTab");
    m_edge->addWidget(m_inspectorTab);
    addToolBar(Qt::RightToolBarArea, m_edge);
    m_edge->hide();
    connect(m_inspectorTab, &QAbstractButton::clicked, this, [this] {
        auto* dock = findChild<PanelDock*>("inspector");
        dock->show(), dock->raise();
        m_edge->hide();
    });
    followTheme(m_banner, [this] {
        const Theme& theme = Theme::current();
        m_banner->setFont(theme.text(13, 600));
        m_banner->setMargin(theme.px(6));
        m_banner->setStyleSheet(QStringLiteral("background: %1; border-bottom: 2px solid %2;")
                                    .arg(theme.colors().tint.name(), theme.colors().accent.name()));
    });
}

// The lessons on the start page, with how far the reader has come.
void MainWindow::showLessons() {
    std::vector<StartPage::LessonEntry> entries;
    const LessonShelf& shelf = m_lessons->shelf();
    for (int i = 0; i < shelf.rowCount(); ++i) {
        const auto text = [&](int role) { return shelf.data(shelf.index(i), role); };
        entries.push_back({text(LessonShelf::NameRole).toString(), text(LessonShelf::TitleRole).toString(),
                           text(LessonShelf::SummaryRole).toString(), text(LessonShelf::ProgressRole).toString(),
                           text(LessonShelf::PageRole).toInt(), text(LessonShelf::PagesRole).toInt(),
                           shelf.find(text(LessonShelf::NameRole).toString())->lecture});
    }
    m_start->setLessons(entries);
}

void MainWindow::openLesson(const QString& name) {
    if (m_lessons->open(name)) showLesson();
}

bool MainWindow::openLessonAt(const std::filesystem::path& folder) {
    auto lesson = lessons::readLesson(folder);
    if (!lesson) {
        m_errors->report(tr("This lesson could not be read."), lesson.errors());
        return false;
    }
    lessons::Lesson own = std::move(lesson).value();
    own.name = QFileInfo(toQString(folder.string())).canonicalFilePath().toStdString();
    if (!m_lessons->openOwn(std::move(own))) return false;
    showLesson();
    return true;
}

void MainWindow::showLesson() {
    showScene();  // one that was closed, and is the lesson's, is not opened anew
    showLessonParts();
    showTitle();
}

void MainWindow::beginLesson() {
    m_opener->cancel();
    leaveRenderer();  // the lesson's scene is another
    m_aside.emplace();
    m_aside->thumbnails = m_views->hasThumbnails();
    if (!showsScene()) return;
    keepPanels();
    m_aside->state = state({});
    m_aside->scene.emplace(m_document);
    for (const PanelDock* dock : m_docks)
        if (!dock->isHidden()) m_aside->panels << dock->objectName();
}

void MainWindow::endLesson() {
    const BeforeLesson before = *std::exchange(m_aside, std::nullopt);
    m_edge->hide();
    m_views->setThumbnails(before.thumbnails);
    if (!before.scene) return showStartPage();
    before.scene->putBack(m_document);
    if (before.state) showPlace(m_document, *before.state), lookAt(*before.state);
    m_strip->setVisible(true);
    m_timelineBar->setVisible(true);
    fitWidth(true);
    for (PanelDock* dock : m_docks) dock->setVisible(before.panels.contains(dock->objectName()));
    showTitle();
    emit m_document.said(tr("Your scene is as it was."));
}

QString MainWindow::lessonTitle() const {
    const QString name = tr("Lesson: %1").arg(toQString(m_lessons->lesson()->title));
    return m_aside->scene ? name + tr(" · your scene stays as it was") : name;
}

QString MainWindow::whyHidden(const QString& panel) const {
    const lessons::Hidden& hidden = m_document.hidden();
    if (hidden.count() == 0) return {};
    const auto isShown = [&](const PanelRow& row) { return row.showsValues && panel == row.name; };
    const bool isHidden = std::ranges::any_of(panelTable(), isShown) || has(hidden.parts, partOf(panel)) ||
                          (panel == QLatin1String("algorithm") && hidden.hides(Part::Inspector));
    return isHidden ? tr("After your answer.") : QString();
}

// On show are the lesson, what its page names, and, unless it is only this, what was there before; nothing that is hidden
// until a question is answered.
void MainWindow::showLessonParts() {
    if (!m_aside || !m_lessons->lesson() || !m_width || m_presents) return;
    const bool only = m_lessons->isOnlyThis();
    const auto& needed = m_lessons->run().isAtEnd() ? std::vector<Part>() : m_lessons->run().current().panels;
    for (PanelDock* dock : m_docks) {
        const QString name = dock->objectName();
        const bool wanted = has(needed, partOf(name)) || (!only && m_aside->panels.contains(name));
        dock->setVisible(name == QLatin1String("lesson") || (wanted && whyHidden(name).isEmpty()));
    }
    auto* lesson = findChild<PanelDock*>("lesson");
    lesson->raise();
    const bool isTimed = !m_document.hidden().hides(Part::Timeline) && (!only || has(needed, Part::Timeline));
    m_timelineBar->setVisible(isTimed);
    m_rail->setVisible(!only && m_width != Width::Wide);
    if (only) m_strip->setCompact(true);
    const QString why = whyHidden(QStringLiteral("inspector"));
    m_inspectorTab->setText(why.isEmpty() ? tr("Inspector") : tr("Inspector, after your answer"));
    m_inspectorTab->setEnabled(why.isEmpty());
    m_edge->setVisible(findChild<PanelDock*>("inspector")->isHidden());
    // The page has the width of its lines, whatever stood there before.
    const double width = this->width() < 1440 ? 392 : 468;
    resizeDocks({lesson}, {int(width * (0.4 + 0.6 * Theme::current().scale()))}, Qt::Horizontal);
    // The card of a question has the settings that it is about; the panel above it shows some rows and scrolls.
    auto* const settings = findChild<PanelDock*>("settings");
    if (const int low = Theme::current().px(190); !settings->isHidden() && !settings->isFloating())
        resizeDocks({settings, lesson}, {low, std::max(low, this->height() - low)}, Qt::Vertical);
    showTitle();
    enableActions();
}

}  // namespace app
