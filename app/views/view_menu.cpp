#include "app/views/view_menu.h"

#include <QAction>
#include <QMenu>

#include "app/views/active_view.h"
#include "app/views/view_edits.h"

namespace app {

using lessons::ViewTree;

void addViewMenu(QMenu& menu, lessons::ViewLeaf leaf, ActiveView& active, ViewEdits& edits,
                 const std::function<void(SavedAs)>& save) {
    menu.setToolTipsVisible(true);
    menu.addSeparator();
    const bool isBuffer = leaf.kind == lessons::ViewLeaf::Kind::Buffer;
    const auto add = [&](const QString& text, auto run) { return menu.addAction(text, &active, run); };
    const auto addSave = [&](const QString& text, SavedAs as) {
        add(text, [&active, leaf, save, as] {
            active.goTo(leaf);
            save(as);
        });
    };
    if (isBuffer) {
        addSave(ActiveView::tr("Save this buffer…"), SavedAs::Files);
        addSave(ActiveView::tr("Figure…"), SavedAs::Figure);
        menu.addSeparator();
    }
    QAction* right =
        add(ActiveView::tr("Split to the right"), [&edits, leaf] { edits.split(leaf, ViewTree::Kind::Row); });
    QAction* below = add(ActiveView::tr("Split below"), [&edits, leaf] { edits.split(leaf, ViewTree::Kind::Column); });
    add(isBuffer ? ActiveView::tr("3D view here") : ActiveView::tr("Buffer here"),
        [&edits, leaf] { edits.turn(leaf); });
    QAction* close = add(ActiveView::tr("Close this view"), [&edits, leaf] { edits.close(leaf); });
    QObject::connect(&menu, &QMenu::aboutToShow, &active, [=, &edits] {
        const auto enable = [](QAction* action, const QString& whyNot) {
            action->setEnabled(whyNot.isEmpty());
            action->setToolTip(whyNot);
        };
        enable(right, edits.whyNotSplit(leaf, ViewTree::Kind::Row));
        enable(below, edits.whyNotSplit(leaf, ViewTree::Kind::Column));
        enable(close, edits.whyNotClose(leaf));
    });
}

}  // namespace app
