#include "app/desktop/view_menu.h"

#include <QAction>
#include <QMenu>

#include "app/desktop/view_area.h"

namespace app {

using lessons::ViewTree;

void addViewMenu(QMenu* menu, ViewArea& area, lessons::ViewLeaf leaf) {
    menu->setToolTipsVisible(true);
    menu->addSeparator();
    const bool isBuffer = leaf.kind == lessons::ViewLeaf::Kind::Buffer;
    const auto add = [&](const QString& text, auto run) { return menu->addAction(text, &area, run); };
    const auto addSave = [&](const QString& text, ViewArea::SavedAs as) {
        add(text, [&area, leaf, as] {
            area.active().goTo(leaf);
            emit area.saveAsked(as);
        });
    };
    if (isBuffer) {
        addSave(ViewArea::tr("Save this buffer…"), ViewArea::SavedAs::Files);
        addSave(ViewArea::tr("Figure…"), ViewArea::SavedAs::Figure);
        menu->addSeparator();
    }
    ViewEdits& edits = area.edits();
    QAction* right =
        add(ViewArea::tr("Split to the right"), [&edits, leaf] { edits.split(leaf, ViewTree::Kind::Row); });
    QAction* below = add(ViewArea::tr("Split below"), [&edits, leaf] { edits.split(leaf, ViewTree::Kind::Column); });
    add(isBuffer ? ViewArea::tr("3D view here") : ViewArea::tr("Buffer here"), [&edits, leaf] { edits.turn(leaf); });
    QAction* close = add(ViewArea::tr("Close this view"), [&edits, leaf] { edits.close(leaf); });
    QObject::connect(menu, &QMenu::aboutToShow, &area, [=, &edits] {
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
