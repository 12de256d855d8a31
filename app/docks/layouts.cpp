#include "app/docks/layouts.h"

#include <QInputDialog>
#include <QMainWindow>
#include <QMenu>
#include <optional>

#include "app/commands/actions.h"
#include "app/docks/layout_store.h"
#include "app/docks/status_line.h"
#include "app/docks/window_layout.h"
#include "app/views/view_area.h"
#include "app/widgets/save_dialog.h"

namespace app {

Layouts::Layouts(QMainWindow& window, Actions& actions, ViewArea& views, WindowLayout& layout, StatusLine& status)
    : QObject(&window), m_window(window), m_views(views), m_layout(layout), m_status(status) {
    addNamed(actions);
    actions.add({.id = ActionId::KeepLayout,
                 .menu = "View/Layout",
                 .text = "Keep this layout…",
                 .keys = "",
                 .tip = "Keep panels and views as they are, under a name.",
                 .run = [this] { keepThis(); }});
    actions.add({.id = ActionId::ResetLayout,
                 .menu = "View/Layout",
                 .text = "Reset",
                 .keys = "",
                 .tip = "Put all panels back in their places.",
                 .run = [this] { reset(); }});
    connect(&actions, &Actions::menusFilled, this, [this, &actions] { addKeptMenu(actions); });
    connect(this, &Layouts::applied, &actions, &Actions::refresh);
}

void Layouts::addNamed(Actions& actions) {
    using A = ActionId;
    struct Named {
        A id;
        const char *text, *keys, *tip, *arrangement;
        std::optional<bool> thumbnails = {};  // nothing: as they are
    };
    static constexpr Named kNamed[]{
        {A::LookLayout, "Look", "Ctrl+Shift+1", "A buffer beside the 3D view.", "one"},
        {A::ExplainLayout, "Explain", "Ctrl+Shift+2",
         "Two buffers one above the other, beside the 3D view, and the buffers small.", "two", true},
        {A::CompareLayout, "Compare", "Ctrl+Shift+3", "Two buffers side by side.", "compare"},
        {A::FourLayout, "Four views", "Ctrl+Shift+6",
         "Three buffers that explain the stage, and the 3D view, in two rows.", "four"},
        {A::SpaceLayout, "3D view alone", "Ctrl+Shift+4", "The 3D view in the whole middle.", "space", false},
        {A::PictureLayout, "One buffer alone", "Ctrl+Shift+5", "A buffer in the whole middle.", "buffer"}};
    for (const Named& named : kNamed)
        actions.add(
            {.id = named.id,
             .menu = "View/Layout",
             .text = named.text,
             .keys = named.keys,
             .tip = named.tip,
             .run = [this, named] { apply(named.arrangement, named.thumbnails.value_or(m_views.hasThumbnails())); },
             .startsGroup = named.id == A::LookLayout});
}

// The user's own layouts are below the named ones, each with a way to delete it.
void Layouts::addKeptMenu(const Actions& actions) {
    QMenu* const menu = actions.menu("View/Layout");
    auto* drop = new QMenu(tr("Delete"), menu);
    QAction* const before = menu->insertMenu(actions[ActionId::ResetLayout], drop);
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
