#include "app/commands/view_actions.h"

#include "app/buffer_view/buffer_header.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/commands/actions.h"
#include "app/views/view_area.h"

namespace app {
namespace {

using A = ActionId;
using TreeKind = lessons::ViewTree::Kind;

void addArrangement(Actions& actions, ViewArea& views) {
    actions.add({.id = A::TwoBufferViews,
                 .menu = "View",
                 .text = "Second buffer view",
                 .keys = "Ctrl+Alt+V",
                 .tip = "Show a second buffer below the first.",
                 .run = [&views] { views.setSecond(!views.hasSecond()); },
                 .isOn = [&views] { return views.hasSecond(); }});
    actions.add({.id = A::SplitRight,
                 .menu = "View/Views",
                 .text = "Split to the right",
                 .keys = "Ctrl+Alt+R",
                 .tip = "Give half of the active view to a new one at its right.",
                 .run = [&views] { views.edits().split(views.active().leaf(), TreeKind::Row); },
                 .whyNot = [&views] { return views.edits().whyNotSplit(views.active().leaf(), TreeKind::Row); }});
    actions.add({.id = A::SplitBelow,
                 .menu = "View/Views",
                 .text = "Split below",
                 .keys = "Ctrl+Alt+B",
                 .tip = "Give half of the active view to a new one below it.",
                 .run = [&views] { views.edits().split(views.active().leaf(), TreeKind::Column); },
                 .whyNot = [&views] { return views.edits().whyNotSplit(views.active().leaf(), TreeKind::Column); }});
    actions.add({.id = A::TurnView,
                 .menu = "View/Views",
                 .text = "Buffer or 3D view",
                 .keys = "Ctrl+Alt+D",
                 .tip = "Put a 3D view in place of the active buffer view, or a buffer view in place of the 3D view.",
                 .run = [&views] { views.edits().turn(views.active().leaf()); }});
    actions.add({.id = A::CloseView,
                 .menu = "View/Views",
                 .text = "Close the view",
                 .keys = "Ctrl+Alt+W",
                 .tip = "Give the active view's room to its neighbours.",
                 .run = [&views] { views.edits().close(views.active().leaf()); },
                 .whyNot = [&views] { return views.edits().whyNotClose(views.active().leaf()); }});
    actions.add(
        {.id = A::EvenViews,
         .menu = "View/Views",
         .text = "Equal parts",
         .keys = "Ctrl+Alt+E",
         .tip = "Make the views in a row or column the same size.",
         .run = [&views] { views.edits().makeEven(); },
         .whyNot = [&views] { return isEven(views.grid().tree()) ? ViewArea::tr("They are equal.") : QString(); }});
}

QString whyNoOther(const ViewArea& views) {
    return views.grid().tree().kind == TreeKind::Leaf ? ViewArea::tr("It is the only view.") : QString();
}

void addMoving(Actions& actions, ViewArea& views) {
    actions.add(
        {.id = A::LinkViews,
         .menu = "View/Views",
         .text = "Linked zoom",
         .keys = "Ctrl+L",
         .tip = "Buffer views of the same size zoom and move together.",
         .run = [&views] { views.links().set(!views.links().isOn()); },
         .whyNot = [&views] { return views.hasSecond() ? QString() : ViewArea::tr("It needs two buffer views."); },
         .isOn = [&views] { return views.links().isOn(); }});
    actions.add({.id = A::OriginalSize,
                 .menu = "View/Views",
                 .text = "One to one",
                 .keys = "Ctrl+0",
                 .tip = "Show the active buffer view's picture a pixel of the screen each.",
                 .run = [&views] { views.activeBuffer().canvas()->placing().setZoom(1); },
                 .inTalk = true});
    actions.add({.id = A::NextView,
                 .menu = "View/Views",
                 .text = "Next view",
                 .keys = "Ctrl+Tab",
                 .tip = "Go to the next view.",
                 .run = [&views] { views.active().goToNext(1); },
                 .whyNot = [&views] { return whyNoOther(views); },
                 .startsGroup = true});
    actions.add({.id = A::PreviousView,
                 .menu = "View/Views",
                 .text = "Previous view",
                 .keys = "Ctrl+Shift+Tab",
                 .tip = "Go to the view before.",
                 .run = [&views] { views.active().goToNext(-1); },
                 .whyNot = [&views] { return whyNoOther(views); }});
    actions.add({.id = A::Thumbnails,
                 .menu = "View",
                 .text = "Thumbnails",
                 .keys = "Ctrl+T",
                 .tip = "Show the buffers small, in the order of the stages.",
                 .run = [&views] { views.setThumbnails(!views.hasThumbnails()); },
                 .isOn = [&views] { return views.hasThumbnails(); }});
}

// Above the line over the channels of the equation.
void addHeaderMenus(const Actions& actions, ViewArea& views) {
    QMenu* const inspect = actions.menu("Inspect");
    const auto add = [&](const QString& name, void (BufferHeader::*opens)(QMenu*)) {
        auto* menu = new QMenu(name, inspect);
        const QList<QAction*> all = inspect->actions();
        inspect->insertMenu(all[all.indexOf(actions[A::RedChannel]) - 1], menu);
        QObject::connect(menu, &QMenu::aboutToShow, &views,
                         [&views, menu, opens] { (views.activeBuffer().header().*opens)(menu); });
        QObject::connect(inspect, &QMenu::aboutToShow, menu,
                         [&actions, menu] { menu->setEnabled(actions.whyNot(A::OriginalSize).isEmpty()); });
    };
    add(ViewArea::tr("Overlays"), &BufferHeader::overlayMenuOpens);
    add(ViewArea::tr("Compare with"), &BufferHeader::compareMenuOpens);
}

}  // namespace

void addViewActions(Actions& actions, ViewArea& views) {
    addArrangement(actions, views);
    addMoving(actions, views);
    QObject::connect(&views, &ViewArea::changed, &actions, &Actions::refresh);
    QObject::connect(&actions, &Actions::menusFilled, &views, [&actions, &views] { addHeaderMenus(actions, views); });
}

}  // namespace app
