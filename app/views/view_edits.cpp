#include "app/views/view_edits.h"

#include "app/views/active_view.h"
#include "app/views/stage_in_views.h"
#include "app/views/view_grid.h"

namespace app {

using lessons::ViewLeaf;
using lessons::ViewTree;

ViewLeaf ViewEdits::added(ViewLeaf::Kind kind) const { return {kind, freeNumber(m_grid.tree(), kind)}; }

void ViewEdits::split(ViewLeaf leaf, ViewTree::Kind direction) {
    if (!whyNotSplit(leaf, direction).isEmpty()) return;
    const ViewLeaf other = added(ViewLeaf::Kind::Buffer);
    ViewTree tree = m_grid.tree();
    lessons::split(tree, leaf, direction, other);
    m_stage.showAnother(m_grid.views().buffer(other.number));
    m_grid.setTree(std::move(tree));
    m_active.goTo(other);
}

QString ViewEdits::whyNotSplit(ViewLeaf leaf, ViewTree::Kind direction) const {
    ViewTree tree = m_grid.tree();
    if (!lessons::split(tree, leaf, direction, added(ViewLeaf::Kind::Buffer)))
        return ViewGrid::tr("There are %1 views, as many as there can be.").arg(lessons::kMostViews);
    if (m_grid.hasRoomFor(tree)) return {};
    const lessons::ViewSize least = m_grid.views().leastSize();
    return ViewGrid::tr("There is no room: a view needs %1 by %2 pixels.").arg(least.width).arg(least.height);
}

void ViewEdits::close(ViewLeaf leaf) {
    ViewTree tree = m_grid.tree();
    if (!lessons::close(tree, leaf)) return;
    m_grid.setTree(std::move(tree));
    if (leaf.number > 0) m_grid.views().remove(leaf);  // the first ones are what the others begin with
    m_active.goTo(m_active.leaf());
}

QString ViewEdits::whyNotClose(ViewLeaf leaf) const {
    ViewTree tree = m_grid.tree();
    return lessons::close(tree, leaf) ? QString() : ViewGrid::tr("It is the only view.");
}

void ViewEdits::turn(ViewLeaf leaf) {
    const bool isBuffer = leaf.kind == ViewLeaf::Kind::Buffer;
    const ViewLeaf other = added(isBuffer ? ViewLeaf::Kind::Space : ViewLeaf::Kind::Buffer);
    ViewTree tree = m_grid.tree();
    if (!replace(tree, leaf, other)) return;
    m_grid.setTree(std::move(tree));
    m_active.goTo(other);
}

void ViewEdits::makeEven() {
    ViewTree tree = m_grid.tree();
    lessons::makeEven(tree);
    m_grid.setTree(std::move(tree));
}

}  // namespace app
