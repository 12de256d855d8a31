#include "app/views/active_view.h"

#include <QApplication>
#include <QStyle>

#include "app/buffer_view/buffer_view.h"
#include "app/views/view_grid.h"

namespace app {

using lessons::ViewLeaf;

ActiveView::ActiveView(ViewGrid& grid) : m_grid(grid) {
    m_focus.begin([this](QWidget* now) { takeFocus(now); });
}

ViewLeaf ActiveView::leaf() const {
    return contains(m_grid.shown(), m_leaf) ? m_leaf : leavesOf(m_grid.shown()).front();
}

BufferView& ActiveView::buffer() const {
    const ViewLeaf active = leaf();
    return active.kind == ViewLeaf::Kind::Buffer ? *m_grid.views().buffers().at(active.number)
                                                 : *m_grid.views().buffersFrom(m_grid.tree()).front();
}

void ActiveView::takeFocus(const QWidget* now) {
    for (const ViewLeaf leaf : leavesOf(m_grid.shown())) {
        QWidget* frame = m_grid.views().frameOf(leaf);
        const bool isActive = now && frame->isAncestorOf(now);
        if (leaf.kind == ViewLeaf::Kind::Space && frame->property("active").toBool() != isActive) {
            frame->setProperty("active", isActive);
            frame->style()->polish(frame);
        }
        if (!isActive || leaf == m_leaf) continue;
        m_leaf = leaf;
        emit focused();
        emit changed();
    }
}

void ActiveView::goTo(ViewLeaf leaf) {
    if (!contains(m_grid.shown(), leaf)) return;
    m_grid.views().giveKeys(leaf);
    m_leaf = leaf;
    emit changed();
}

void ActiveView::goToNext(int step) {
    const QWidget* frame = m_grid.views().frameOf(leaf());
    // From outside the first one.
    const bool isThere = QApplication::focusWidget() && frame->isAncestorOf(QApplication::focusWidget());
    goTo(isThere ? neighbour(m_grid.shown(), leaf(), step) : leaf());
}

}  // namespace app
