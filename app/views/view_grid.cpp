#include "app/views/view_grid.h"

#include <QApplication>
#include <QScopedValueRollback>
#include <QVBoxLayout>
#include <utility>

#include "app/views/even_splitter.h"
#include "app/widgets/follow_theme.h"

namespace app {

using lessons::ViewTree;

ViewGrid::ViewGrid(Document& document, ViewDress dress, QWidget* parent)
    : QWidget(parent), m_views(document, *this, dress), m_tree(*lessons::arrangementNamed("one")) {
    spaced(new QVBoxLayout(this), {});
}

int ViewGrid::gap() const { return Theme::current().px(8); }

void ViewGrid::applyTheme() {
    for (auto* splitter : findChildren<EvenSplitter*>()) splitter->setHandleWidth(gap());
    // Room for one view: the others come and go.
    setMinimumSize(m_views.leastSize().width, m_views.leastSize().height);
    layOut();
}

void ViewGrid::setTree(ViewTree tree) {
    const ViewTree before = std::exchange(m_tree, std::move(tree));
    m_alone.reset();
    layOut();
    emit treeChanged(before);
    emit changed();
}

void ViewGrid::setAlone(std::optional<lessons::ViewLeaf> leaf) {
    m_alone = leaf;
    layOut();
    emit changed();
}

std::size_t ViewGrid::withoutRoom() const { return m_alone ? 0 : leavesOf(m_tree).size() - leavesOf(m_shown).size(); }

bool ViewGrid::hasRoomFor(const ViewTree& tree) const {
    return fitted(tree, room(), m_views.leastSize(), gap()) == tree;
}

void ViewGrid::layOut() {
    if (m_laysOut) return;  // a frame that moves may give the grid another size for a moment
    const QScopedValueRollback guard(m_laysOut, true);
    m_views.buffer(0), m_views.space(0);
    for (const lessons::ViewLeaf leaf : leavesOf(m_tree)) m_views.make(leaf);
    const ViewTree whole = m_alone ? ViewTree{ViewTree::Kind::Leaf, *m_alone} : m_tree;
    ViewTree shown = isVisible() ? fitted(whole, room(), m_views.leastSize(), gap()) : whole;
    emit missing(leavesOf(whole).size() - leavesOf(shown).size());
    const bool hasOthers = !m_root || !haveSameViews(shown, m_shown);
    m_shown = std::move(shown);
    if (!hasOthers) return setShares(m_root, m_shown);
    rebuild();
    emit rebuilt();
}

// Frames move from the old splitters to the new ones, and are what they were.
void ViewGrid::rebuild() {
    QWidget* focus = QApplication::focusWidget();
    setUpdatesEnabled(false);
    if (m_root) layout()->removeWidget(m_root);
    const std::vector<QWidget*> frames = m_views.frames();
    for (QWidget* frame : frames) frame->hide(), frame->setParent(this);
    if (qobject_cast<EvenSplitter*>(m_root)) delete m_root;
    m_root = build(m_shown);
    layout()->addWidget(m_root);
    for (const lessons::ViewLeaf leaf : leavesOf(m_shown)) m_views.frameOf(leaf)->show();
    m_root->show();
    for (const QWidget* frame : frames) followThemeAgain(*frame);
    setShares(m_root, m_shown);
    setUpdatesEnabled(true);
    if (focus && focus->isVisible() && isAncestorOf(focus)) focus->setFocus();
}

QWidget* ViewGrid::build(const ViewTree& tree) {
    if (tree.kind == ViewTree::Kind::Leaf) return m_views.frameOf(tree.leaf);
    auto* splitter = new EvenSplitter(tree.kind == ViewTree::Kind::Row ? Qt::Horizontal : Qt::Vertical, this);
    splitter->setChildrenCollapsible(false);
    splitter->setHandleWidth(gap());
    splitter->setMinimumSize(1, 1);  // the window does not grow for views: those without room are not shown
    for (const ViewTree& part : tree.parts) splitter->addWidget(build(part));
    connect(splitter, &EvenSplitter::sharesChanged, this, &ViewGrid::takeShares);
    return splitter;
}

void ViewGrid::setShares(QWidget* part, const ViewTree& tree) {
    auto* splitter = qobject_cast<EvenSplitter*>(part);
    if (!splitter) return;
    QList<int> shares;
    for (const ViewTree& one : tree.parts) shares << one.weight;
    splitter->setShares(shares);
    for (int i = 0; i < splitter->count(); ++i) setShares(splitter->widget(i), tree.parts[std::size_t(i)]);
}

void ViewGrid::readShares(const QWidget* part, ViewTree& tree) const {
    const auto* splitter = qobject_cast<const EvenSplitter*>(part);
    for (int i = 0; splitter && i < splitter->count(); ++i) {
        tree.parts[std::size_t(i)].weight = splitter->shares()[i];
        readShares(splitter->widget(i), tree.parts[std::size_t(i)]);
    }
}

void ViewGrid::takeShares() {
    readShares(m_root, m_shown);
    if (haveSameViews(m_tree, m_shown)) m_tree = m_shown;
    emit changed();
}

void ViewGrid::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    layOut();
    emit changed();  // there may be room for more, or for less
}

void ViewGrid::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    layOut();
    emit changed();
}

}  // namespace app
