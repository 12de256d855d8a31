#include "app/docks/panel_docks.h"

#include <QAction>
#include <QMainWindow>
#include <QToolBar>
#include <algorithm>

#include "app/document/document.h"
#include "app/look/icons.h"
#include "app/settings/settings_panel.h"
#include "app/widgets/follow_theme.h"

namespace app {

PanelDocks::PanelDocks(QMainWindow& window, Document& document, ViewArea& views)
    : QObject(&window), m_window(window), m_document(document), m_rail(window.addToolBar(tr("Panels"))) {
    m_rail->setObjectName("rail");
    m_rail->setMovable(false);
    m_rail->setOrientation(Qt::Vertical);
    window.addToolBar(Qt::LeftToolBarArea, m_rail);
    const PanelNeeds needs{document, views, *this, m_panels};
    for (const PanelRow& row : panelTable()) {
        auto* dock = new PanelDock(row, row.make(needs, &window), &window);
        window.addDockWidget(row.area, dock);
        m_all += dock;
        if (row.area == Qt::LeftDockWidgetArea) m_left += dock;
        if (row.area != Qt::BottomDockWidgetArea) m_sides += dock;
        QAction* toggle = dock->toggleViewAction();
        window.addAction(toggle);
        m_rail->addAction(toggle);
    }
    tab();
    followTheme(m_rail, [this] {
        const int size = Theme::current().px(18);
        m_rail->setIconSize(QSize(size, size));
    });
}

// Panels that share a place, the first in front: the cues have the lesson's, because a talk needs no lesson.
void PanelDocks::tab() {
    using P = PanelId;
    for (const auto& [front, behind] :
         {std::pair(P::Lesson, P::Cues), std::pair(P::Lesson, P::Renderer), std::pair(P::Inspector, P::Algorithm)}) {
        m_window.tabifyDockWidget(&(*this)[front], &(*this)[behind]);
        (*this)[front].raise();
    }
}

void PanelDocks::putBack() {
    for (PanelDock* dock : m_all) {
        dock->setFloating(false);
        m_window.removeDockWidget(dock);
        m_window.addDockWidget(dock->row().area, dock);
    }
    tab();
}

void PanelDocks::showSetting(const QString& key) {
    const PanelDock& dock = (*this)[PanelId::Settings];
    if (!dock.isInFront()) dock.toggleViewAction()->trigger();
    m_panels.settings->showSetting(key);
}

QString PanelDocks::whyHidden(PanelId id) const {
    using lessons::Part;
    const lessons::Hidden& hidden = m_document.hidden();
    if (hidden.count() == 0) return {};
    const PanelRow& row = (*this)[id].row();
    const bool isHidden = row.showsValues || (row.part && hidden.hides(*row.part)) ||
                          (id == PanelId::Algorithm && hidden.hides(Part::Inspector));
    return isHidden ? tr("After your answer.") : QString();
}

void PanelDocks::enable(bool hasScene) {
    for (const PanelDock* dock : m_all)
        dock->toggleViewAction()->setEnabled(hasScene && whyHidden(dock->row().id).isEmpty());
}

}  // namespace app
