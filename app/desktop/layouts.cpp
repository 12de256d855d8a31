#include "app/desktop/layouts.h"

#include <QInputDialog>
#include <QMainWindow>
#include <QMenu>

#include "app/desktop/actions.h"
#include "app/desktop/layout_store.h"
#include "app/desktop/status_line.h"
#include "app/desktop/view_area.h"
#include "app/desktop/window_layout.h"
#include "app/panels/save_dialog.h"

namespace app {

// The user's own ones stand below the named ones, each with a way to delete it.
Layouts::Layouts(QMainWindow& window, const Actions& actions, ViewArea& views, WindowLayout& layout, StatusLine& status)
    : QObject(&window), m_window(window), m_views(views), m_layout(layout), m_status(status) {
    using A = ActionId;
    const auto on = [&](A id, auto run) { connect(actions[id], &QAction::triggered, this, run); };
    on(A::LookLayout, [this] { apply("one", m_views.hasThumbnails()); });
    on(A::ExplainLayout, [this] { apply("two", true); });
    on(A::CompareLayout, [this] { apply("compare", m_views.hasThumbnails()); });
    on(A::FourLayout, [this] { apply("four", m_views.hasThumbnails()); });
    on(A::SpaceLayout, [this] { apply("space", false); });
    on(A::PictureLayout, [this] { apply("buffer", m_views.hasThumbnails()); });
    on(A::KeepLayout, [this] { keepThis(); });
    on(A::ResetLayout, [this] { reset(); });
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
            connect(action, &QAction::triggered, this, [this, name] { applyKept(name); });
            menu->insertAction(before, action);
            drop->addAction(name, this, [name] { dropLayout(name); });
        }
        drop->setEnabled(!drop->isEmpty());
    });
}

// The named layouts begin with all panels in their places.
void Layouts::apply(const char* arrangement, bool thumbnails) {
    m_layout.putBack();
    m_views.setArrangement(arrangement);
    m_views.setThumbnails(thumbnails);
    emit applied();
}

void Layouts::applyKept(const QString& name) {
    const auto layout = keptLayout(name);
    if (!layout) return;
    m_window.restoreState(layout->panels, kLayoutVersion);
    m_views.setArrangement(layout->arrangement.toStdString());
    m_views.setThumbnails(layout->thumbnails);
    emit applied();
}

void Layouts::keepThis() {
    bool entered = false;
    const QString name =
        QInputDialog::getText(&m_window, tr("Keep this layout"), tr("Name"), QLineEdit::Normal, QString(), &entered)
            .trimmed();
    if (!entered || name.isEmpty()) return;
    if (keptLayout(name) && !askToReplace(&m_window, tr("Keep this layout"), {name})) return;
    keepLayout(name, {m_window.saveState(kLayoutVersion), QString::fromStdString(m_views.arrangement()),
                      m_views.hasThumbnails()});
    m_status.say(tr("Kept the layout as %1: View, Layout.").arg(name));
}

void Layouts::reset() {
    if (!m_window.isMaximized()) takeFirstWindowPlace(m_window);
    m_layout.putBack();
}

}  // namespace app
