#include "app/docks/window_layout.h"

#include <QCoreApplication>
#include <QMainWindow>
#include <QStackedWidget>
#include <QToolBar>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/buffer_view/buffer_view.h"
#include "app/docks/layout_store.h"
#include "app/docks/panel_docks.h"
#include "app/docks/status_line.h"
#include "app/docks/window_centre.h"
#include "app/document/document.h"
#include "app/look/theme.h"
#include "app/settings/scene_tree.h"
#include "app/stages/stage_strip.h"
#include "app/stages/timeline.h"
#include "app/start/start_page.h"
#include "app/talk/presentation.h"
#include "app/views/view_area.h"

namespace app {
namespace {

// Docks grow with the text, but less.
double dockScale() { return 0.4 + 0.6 * Theme::current().scale(); }
// Sizes of the design at font scale 1.
int dockWidth(int pixels) { return int(pixels * dockScale()); }

}  // namespace

WindowLayout::WindowLayout(QMainWindow& window, Document& document, const WindowCentre& centre,
                           const AroundViews& around, PanelDocks& docks, const Presentation& presentation)
    : QObject(&window),
      m_window(window),
      m_document(document),
      m_centre(centre),
      m_views(centre.views()),
      m_around(around),
      m_docks(docks),
      m_presentation(presentation) {
    followAlgorithm();
    m_soon.setSingleShot(true);
    m_soon.setInterval(1000);
    connect(&m_soon, &QTimer::timeout, this, [this] {
        if (showsViews() && !m_presentation.changesWindow()) keep();
    });
    for (PanelDock* dock : m_docks.all()) {
        dock->installEventFilter(this);
        connect(dock->toggleViewAction(), &QAction::triggered, this, [this, dock](bool shown) {
            if (!shown || !showsViews()) return;
            if (m_docks.left().contains(dock)) showOneLeftDock(dock);
            giveRoomTo(dock);
        });
    }
}

bool WindowLayout::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::Show:
        case QEvent::Hide:
        case QEvent::Move:
        case QEvent::Resize: m_soon.start(); break;
        default: break;
    }
    return QObject::eventFilter(watched, event);
}

bool WindowLayout::showsScene() const { return showsViews() && m_document.hasScene(); }

void WindowLayout::showStart() {
    keep();
    m_width.reset();
    emit startShows();
    m_centre.pages().setCurrentWidget(&m_centre.start());
    for (PanelDock* dock : m_docks.all()) dock->hide();
    m_docks.rail().hide();
    m_around.strip.hide();
    m_around.timelineBar.hide();
    m_around.status.hide();
    m_window.setContentsMargins(0, 0, 0, 0);
    emit changed();
}

void WindowLayout::showViews() {
    if (showsViews()) return;
    m_centre.pages().setCurrentWidget(&m_views);
    m_around.strip.show();
    m_around.timelineBar.show();
    m_around.status.show();
    m_window.setContentsMargins(8, 0, 8, 0);
    fit(Fit::Always);
    if (isWide()) restoreLayout(m_window);
    emit changed();
    m_views.activeBuffer().takeKeys();
}

WindowLayout::Width WindowLayout::widthClass() const {
    // Larger letters need as much more room.
    const double width = m_window.width() / (0.5 + 0.5 * Theme::current().scale());
    return width < 1100 ? Width::Narrow : width < 1440 ? Width::Medium : Width::Wide;
}

// In a narrower window panels are where there is room for them.
void WindowLayout::keep() const {
    if (isWide() && m_isKept) saveLayout(m_window);
}

// Which panels are there, and what share of the width each has, stays as the user has chosen it.
void WindowLayout::fitText() {
    if (!showsViews()) return;
    fit(Fit::AnotherClass);
    const double growth = dockScale() / std::exchange(m_dockScale, dockScale());
    if (growth == 1) return;
    QList<QDockWidget*> docks;
    QList<int> widths;
    for (PanelDock* dock : m_docks.sides()) {
        // One behind a tab has no width of its own.
        if (dock->visibleRegion().isEmpty() || dock->isFloating()) continue;
        docks += dock;
        widths += int(std::lround(dock->width() * growth));
    }
    m_window.resizeDocks(docks, widths, Qt::Horizontal);
}

// Panels come and go where the window changes from one class of widths to another.
void WindowLayout::fit(Fit when) {
    if (m_centre.pages().currentWidget() != &m_views) return;
    const Width now = widthClass();
    const bool low = m_window.height() < 800 * (0.5 + 0.5 * Theme::current().scale());
    m_around.strip.setCompact(low || now != Width::Wide);
    m_around.timeline.setCompact(low || now != Width::Wide);
    if (when == Fit::AnotherClass && now == m_width) return;
    m_width = now;
    showPanels();
    m_docks.rail().setVisible(!isWide());
    // One that was chosen stays.
    const std::string views = m_views.arrangement();
    if (views == "one" || views == "two") m_views.setSecond(isWide() && m_window.height() >= 900);
    m_views.setThumbnails(!low);
    sizePanels();
    emit fitted();
    emit changed();
}

// The user's own renderer has the left side alone, and has it in every width.
void WindowLayout::showPanels() {
    PanelDock* const renderer = &m_docks[PanelId::Renderer];
    const bool checks = !renderer->isHidden();
    for (PanelDock* dock : m_docks.sides()) {
        const bool isLeft = m_docks.left().contains(dock), isRenderer = dock == renderer;
        dock->setVisible(isRenderer ? checks : isLeft ? isWide() && !checks : m_width != Width::Narrow);
    }
}

void WindowLayout::sizePanels() {
    QList<QDockWidget*> docks, left;
    QList<int> widths;
    for (PanelDock* dock : m_docks.sides()) {
        const bool isLeft = m_docks.left().contains(dock), isRenderer = dock->row().id == PanelId::Renderer;
        // Cues and renderer have the lesson's place.
        if (isLeft && dock->row().id != PanelId::Cues && !isRenderer) left += dock;
        if (dock->isHidden()) continue;  // its width would be that of the others on its side
        docks += dock;
        widths += dockWidth(isRenderer ? (isWide() ? 384 : 300) : isLeft ? 296 : isWide() ? 456 : 384);
    }
    m_window.resizeDocks(docks, widths, Qt::Horizontal);
    m_dockScale = dockScale();
    // The tree shows its rows, the settings a material's; the lesson takes the rest.
    const int tree = m_docks.panels().scene->sizeHint().height() + Theme::current().px(44);
    const int settings = Theme::current().px(270);
    const int around = Theme::current().px(250);  // menus, stages, timeline, status, gaps
    m_window.resizeDocks(left, {tree, settings, std::max(settings, m_window.height() - around - tree - settings)},
                         Qt::Vertical);
}

// Whether the algorithm is in front is a part of what the window shows, which a session or a cue brings back.
void WindowLayout::followAlgorithm() {
    PanelDock *const dock = &m_docks[PanelId::Algorithm], *const inspector = &m_docks[PanelId::Inspector];
    Stepper& stepper = m_document.stepper();
    connect(dock, &QDockWidget::visibilityChanged, this, [this, &stepper](bool isInFront) {
        if (m_window.isVisible() && showsViews() && !m_presentation.isOn()) stepper.setShowsAlgorithm(isInFront);
    });
    connect(&stepper, &Stepper::changed, this, [this, &stepper, dock, inspector, shown = false]() mutable {
        if (!showsViews() || m_presentation.isOn() ||
            std::exchange(shown, stepper.showsAlgorithm()) == stepper.showsAlgorithm())
            return;
        if (shown == dock->isInFront()) return;
        PanelDock* const front = shown ? dock : inspector;
        front->show(), front->raise();
    });
}

void WindowLayout::putBack() {
    forgetLayout(m_window);
    m_docks.putBack();
    m_views.setArrangement("one");
    fit(Fit::Always);
}

// Those that are now at the left first.
void WindowLayout::giveViewsRoom() {
    for (const Qt::DockWidgetArea area : {Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea})
        for (PanelDock* dock : m_docks.all()) {
            if (m_views.grid().withoutRoom() == 0) return;
            if (dock->isFloating() || dock->isHidden() || m_window.dockWidgetArea(dock) != area) continue;
            dock->hide();
            QCoreApplication::sendPostedEvents(&m_window, QEvent::LayoutRequest);
        }
}

// A window that its panels do not fit into would grow beyond its screen: the others go, those that were there first.
void WindowLayout::giveRoomTo(const PanelDock* shown) {
    for (PanelDock* dock : m_docks.all()) {
        const QSize least = m_window.minimumSizeHint();
        if (least.width() <= m_window.width() && least.height() <= m_window.height()) return;
        if (dock != shown && !dock->isFloating() && dock->isVisible()) dock->hide();
    }
}

// From the rail the left panels open one at a time.
void WindowLayout::showOneLeftDock(PanelDock* shown) {
    if (isWide() || !showsViews()) return;
    for (PanelDock* dock : m_docks.left())
        if (dock != shown) dock->hide();
    m_window.resizeDocks({shown}, {dockWidth(280)}, Qt::Horizontal);
}

}  // namespace app
