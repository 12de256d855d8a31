#include <QApplication>
#include <QInputDialog>
#include <QMenu>
#include <QMenuBar>
#include <QResizeEvent>
#include <QStackedWidget>
#include <QToolBar>
#include <cmath>
#include <utility>

#include "app/core/theme.h"
#include "app/desktop/actions.h"
#include "app/desktop/layout_store.h"
#include "app/desktop/main_window.h"
#include "app/desktop/panel_dock.h"
#include "app/desktop/presentation.h"
#include "app/desktop/status_line.h"
#include "app/desktop/view_area.h"
#include "app/panels/save_dialog.h"
#include "app/panels/scene_tree.h"
#include "app/panels/stage_strip.h"
#include "app/panels/start_page.h"
#include "app/panels/timeline.h"

namespace app {
namespace {

// Docks grow with the letters, but less.
double dockScale() { return 0.4 + 0.6 * Theme::current().scale(); }
// Sizes of the design at font scale 1.
int dockWidth(int pixels) { return int(pixels * dockScale()); }

}  // namespace

void MainWindow::showStartPage() {
    keepPanels();
    m_width.reset();
    showLessons();
    m_pages->setCurrentWidget(m_start);
    for (PanelDock* dock : m_docks) dock->hide();
    m_rail->hide();
    m_strip->hide();
    m_timelineBar->hide();
    m_status->hide();
    setContentsMargins(0, 0, 0, 0);
    showTitle();
    enableActions();
}

void MainWindow::showScene() {
    if (m_width) return;  // already on show
    m_pages->setCurrentWidget(m_views);
    m_strip->show();
    m_timelineBar->show();
    m_status->show();
    setContentsMargins(8, 0, 8, 0);
    fitWidth(true);
    if (m_width == Width::Wide) restoreLayout(*this);
    showTitle();
    enableActions();
    m_views->focusBuffer();
}

MainWindow::Width MainWindow::widthClass() const {
    // Larger letters need as much more room.
    const double width = this->width() / (0.5 + 0.5 * Theme::current().scale());
    return width < 1100 ? Width::Narrow : width < 1440 ? Width::Medium : Width::Wide;
}

// For the next scene, and the next start. In a narrower window panels are where there is room for them.
void MainWindow::keepPanels() const {
    if (m_width == Width::Wide && !m_aside) saveLayout(*this);
}

// Which panels are there, and what share of the width each has, stays as the user has chosen it.
void MainWindow::fitLetters() {
    if (!m_width) return;
    fitWidth(false);
    const double growth = dockScale() / std::exchange(m_dockScale, dockScale());
    if (growth == 1) return;
    QList<QDockWidget*> docks;
    QList<int> widths;
    for (PanelDock* dock : m_sideDocks) {
        // One behind a tab has no width of its own.
        if (dock->visibleRegion().isEmpty() || dock->isFloating()) continue;
        docks += dock;
        widths += int(std::lround(dock->width() * growth));
    }
    resizeDocks(docks, widths, Qt::Horizontal);
}

// Panels come and go where the window changes from one class of widths to another.
void MainWindow::fitWidth(bool always) {
    if (m_pages->currentWidget() != m_views) return;
    const Width now = widthClass();
    const bool low = height() < 800 * (0.5 + 0.5 * Theme::current().scale());
    m_strip->setCompact(low || now != Width::Wide);
    m_timeline->setCompact(low || now != Width::Wide);
    if (!always && now == m_width) return;
    m_width = now;
    const bool wide = now == Width::Wide;
    // Your renderer has the left side alone, and has it in every width.
    auto* const renderer = findChild<PanelDock*>("renderer");
    const bool checks = !renderer->isHidden();
    for (PanelDock* dock : m_sideDocks) {
        const bool isLeft = m_leftDocks.contains(dock), isRenderer = dock == renderer;
        dock->setVisible(isRenderer ? checks : isLeft ? wide && !checks : now != Width::Narrow);
    }
    m_rail->setVisible(!wide);
    // One that was chosen stays.
    const std::string views = m_views->arrangement();
    if (views == "one" || views == "two") m_views->setSecond(wide && height() >= 900);
    m_views->setThumbnails(!low);
    QList<QDockWidget*> docks, left;
    QList<int> widths;
    for (PanelDock* dock : m_sideDocks) {
        const bool isLeft = m_leftDocks.contains(dock);
        docks += dock;
        if (isLeft && dock->objectName() != "cues" && dock != renderer) left += dock;  // they have the lesson's place
        widths += dockWidth(dock == renderer ? (wide ? 384 : 300) : isLeft ? 296 : wide ? 456 : 384);
    }
    resizeDocks(docks, widths, Qt::Horizontal);
    m_dockScale = dockScale();
    // The tree shows its rows, the settings a material's; the lesson takes the rest.
    const int tree = findChild<SceneTree*>()->sizeHint().height() + Theme::current().px(44);
    const int settings = Theme::current().px(270);
    const int around = Theme::current().px(250);  // menus, stages, timeline, status, gaps
    resizeDocks(left, {tree, settings, std::max(settings, height() - around - tree - settings)}, Qt::Vertical);
    if (m_aside) showLessonParts();
    enableActions();
}

// Panels that share a place, the first in front: the cues have the lesson's, for who gives a talk takes no lesson.
void MainWindow::tabDocks() {
    for (const auto& [front, behind] :
         {std::pair("lesson", "cues"), std::pair("lesson", "renderer"), std::pair("inspector", "algorithm")}) {
        auto* const dock = findChild<PanelDock*>(front);
        tabifyDockWidget(dock, findChild<PanelDock*>(behind));
        dock->raise();
    }
}

// Whether the algorithm is in front is a part of what the window shows, which a session or a cue brings back.
void MainWindow::followAlgorithm() {
    auto *const dock = findChild<PanelDock*>("algorithm"), *const inspector = findChild<PanelDock*>("inspector");
    Stepper& stepper = m_document.stepper();
    connect(dock, &QDockWidget::visibilityChanged, this, [this, &stepper](bool isInFront) {
        if (isVisible() && m_width && !m_presentation->isOn()) stepper.setShowsAlgorithm(isInFront);
    });
    connect(&stepper, &Stepper::changed, this, [this, &stepper, dock, inspector, shown = false]() mutable {
        if (!m_width || m_presentation->isOn() ||
            std::exchange(shown, stepper.showsAlgorithm()) == stepper.showsAlgorithm())
            return;
        if (shown == dock->isInFront()) return;
        PanelDock* const front = shown ? dock : inspector;
        front->show(), front->raise();
    });
}

void MainWindow::resetLayout() {
    forgetLayout(*this);
    for (PanelDock* dock : m_docks) {
        dock->setFloating(false);
        removeDockWidget(dock);
        const bool isSide = m_sideDocks.contains(dock), isLeft = m_leftDocks.contains(dock);
        addDockWidget(isLeft   ? Qt::LeftDockWidgetArea
                      : isSide ? Qt::RightDockWidgetArea
                               : Qt::BottomDockWidgetArea,
                      dock);
    }
    tabDocks();
    m_views->setArrangement("one");
    fitWidth(true);
}

// The named layouts begin with all panels in their places.
void MainWindow::applyLayout(const char* arrangement, bool thumbnails) {
    resetLayout();
    m_views->setArrangement(arrangement);
    m_views->setThumbnails(thumbnails);
    enableActions();
}

void MainWindow::applyKeptLayout(const QString& name) {
    const auto layout = keptLayout(name);
    if (!layout) return;
    restoreState(layout->panels, kLayoutVersion);
    m_views->setArrangement(layout->arrangement.toStdString());
    m_views->setThumbnails(layout->thumbnails);
    enableActions();
}

void MainWindow::keepThisLayout() {
    bool entered = false;
    const QString name =
        QInputDialog::getText(this, tr("Keep this layout"), tr("Name"), QLineEdit::Normal, QString(), &entered)
            .trimmed();
    if (!entered || name.isEmpty()) return;
    if (keptLayout(name) && !askToReplace(this, tr("Keep this layout"), {name})) return;
    keepLayout(name,
               {saveState(kLayoutVersion), QString::fromStdString(m_views->arrangement()), m_views->hasThumbnails()});
    m_status->say(tr("Kept the layout as %1: View, Layout.").arg(name));
}

// The user's own ones stand below the named ones, each with a way to drop it.
void MainWindow::connectLayouts() {
    using A = ActionId;
    const Actions& actions = *m_actions;
    const auto on = [&](A id, auto run) { connect(actions[id], &QAction::triggered, this, run); };
    on(A::LookLayout, [this] { applyLayout("one", m_views->hasThumbnails()); });
    on(A::ExplainLayout, [this] { applyLayout("two", true); });
    on(A::CompareLayout, [this] { applyLayout("compare", m_views->hasThumbnails()); });
    on(A::FourLayout, [this] { applyLayout("four", m_views->hasThumbnails()); });
    on(A::SpaceLayout, [this] { applyLayout("space", false); });
    on(A::PictureLayout, [this] { applyLayout("buffer", m_views->hasThumbnails()); });
    on(A::KeepLayout, [this] { keepThisLayout(); });
    on(A::ResetLayout, [this] {
        if (!isMaximized()) takeFirstWindowPlace(*this);
        resetLayout();
    });
    connect(m_views, &ViewArea::changed, this, &MainWindow::enableViewActions);
    QMenu* menu = actions.menu("View/Layout");
    auto* drop = new QMenu(tr("Delete"), menu);
    QAction* before = menu->insertMenu(actions[A::ResetLayout], drop);
    connect(menu, &QMenu::aboutToShow, this, [this, menu, drop, before] {
        for (QAction* old : menu->actions())
            if (old->property("kept").toBool()) delete old;
        drop->clear();
        for (const QString& name : keptLayouts()) {
            auto* action = new QAction(name, menu);
            action->setProperty("kept", true);
            connect(action, &QAction::triggered, this, [this, name] { applyKeptLayout(name); });
            menu->insertAction(before, action);
            drop->addAction(name, this, [name] { dropLayout(name); });
        }
        drop->setEnabled(!drop->isEmpty());
    });
}

void MainWindow::enableViewActions() {
    using A = ActionId;
    const bool scene = showsScene();
    const auto enable = [&](A id, const QString& whyNot) {
        m_actions->setEnabled(id, scene && whyNot.isEmpty(), scene ? whyNot : tr("Open a scene first."));
    };
    const lessons::ViewLeaf active = m_views->active();
    enable(A::SplitRight, m_views->whyNotSplit(active, lessons::ViewTree::Kind::Row));
    enable(A::SplitBelow, m_views->whyNotSplit(active, lessons::ViewTree::Kind::Column));
    enable(A::CloseView, m_views->whyNotClose(active));
    const bool alone = m_views->tree().kind == lessons::ViewTree::Kind::Leaf;
    enable(A::EvenViews, isEven(m_views->tree()) ? tr("They are equal.") : QString());
    for (const A id : {A::NextView, A::PreviousView}) enable(id, alone ? tr("It is the only view.") : QString());
    enable(A::TurnView, {});
    enable(A::LinkViews, m_views->hasSecond() ? QString() : tr("It needs two buffer views."));
    (*m_actions)[A::LinkViews]->setChecked(m_views->isLinked());
    (*m_actions)[A::TwoBufferViews]->setChecked(m_views->hasSecond());
}

// From the rail the left panels open one at a time.
void MainWindow::showOneLeftDock(PanelDock* shown) {
    if (m_width == Width::Wide || !m_width) return;
    for (PanelDock* dock : m_leftDocks)
        if (dock != shown) dock->hide();
    resizeDocks({shown}, {dockWidth(280)}, Qt::Horizontal);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    if (!m_presents) fitWidth(false);
}

}  // namespace app
