// How the views of a ViewArea stand. The decisions are ViewTree's; here its leaves become frames, its rows and columns
// splitters.
#include <QAction>
#include <QApplication>
#include <QEvent>
#include <QFrame>
#include <QMenu>
#include <QScopedValueRollback>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>

#include "app/core/stage_buffer.h"
#include "app/desktop/even_splitter.h"
#include "app/desktop/view_area.h"
#include "app/panels/buffer_canvas.h"
#include "app/panels/buffer_header.h"
#include "app/panels/buffer_view.h"
#include "app/panels/follow_theme.h"
#include "app/panels/thumbnail_strip.h"
#include "app/view3d/view3d_panel.h"

namespace app {

using Kind = lessons::ViewTree::Kind;

lessons::ViewSize ViewArea::room() const { return {m_middle->width(), m_middle->height()}; }
int ViewArea::gap() const { return Theme::current().px(8); }

// A header, a foot, and a picture to be seen between them.
lessons::ViewSize ViewArea::leastView() const {
    const Theme& theme = Theme::current();
    if (m_dress == ViewDress::Bare) return {theme.px(120), theme.px(90)};  // a picture and its name
    return {std::max(282, theme.px(250)), std::max(222, theme.px(100))};
}

QWidget* ViewArea::framed(QWidget* view, lessons::ViewLeaf leaf) {
    const bool isSpace = leaf.kind == lessons::ViewLeaf::Kind::Space;
    const QString number = leaf.number > (isSpace ? 0 : 1) ? QString::number(leaf.number + 1) : QString();
    const QString name = isSpace ? "view3d" : leaf.number == 0 ? "first" : number.isEmpty() ? "second" : "buffer";
    auto* frame = new QFrame(m_middle);
    frame->hide();
    frame->setObjectName(name + number + "Frame");
    if (!isSpace) view->setObjectName(name + number + "BufferView");
    frame->setProperty("kind", "panel");
    auto* column = new QVBoxLayout(frame);
    column->setContentsMargins(1, 1, 1, 1);
    column->addWidget(view);
    followTheme(frame, [this, frame] { frame->setMinimumSize(leastView().width, leastView().height); });
    return frame;
}

BufferView& ViewArea::bufferView(int number) {
    BufferView*& view = m_buffers[number];
    if (view) return *view;
    const lessons::ViewLeaf leaf{lessons::ViewLeaf::Kind::Buffer, number};
    view = new BufferView(m_document);
    framed(view, leaf);
    view->setBare(m_dress == ViewDress::Bare);
    if (m_dress == ViewDress::Full) addMenu(view->header().menu(), leaf);
    connect(view, &BufferView::bufferChanged, this, [this, view](const pipeline::BufferName& name) {
        if (view == &activeBuffer()) m_thumbnails->setCurrent(name);
        join(*view);
    });
    connect(view->canvas(), &BufferCanvas::moved, this, [this, view] { lead(*view); });
    connect(view->canvas(), &BufferCanvas::zoomChanged, this, &ViewArea::agreeSoon);
    connect(view->canvas(), &BufferCanvas::resized, this, [this, view] { join(*view); });
    if (m_document.hasScene()) {
        const auto useful = usefulBuffers(m_document.stage(), m_document.scene(), m_document.stepper().isInside());
        view->setBuffer(useful[std::min(m_buffers.size(), useful.size()) - 1]);
    }
    return *view;
}

View3dPanel& ViewArea::spaceView(int number) {
    View3dPanel*& view = m_spaces[number];
    if (view) return *view;
    const lessons::ViewLeaf leaf{lessons::ViewLeaf::Kind::Space, number};
    view = new View3dPanel(m_document);
    framed(view, leaf);
    view->setBare(m_dress == ViewDress::Bare);
    if (m_dress == ViewDress::Full) addMenu(view->menu(), leaf);
    return *view;
}

QWidget* ViewArea::viewOf(lessons::ViewLeaf leaf) const {
    if (leaf.kind == lessons::ViewLeaf::Kind::Space) {
        const auto found = m_spaces.find(leaf.number);
        return found == m_spaces.end() ? nullptr : found->second;
    }
    const auto found = m_buffers.find(leaf.number);
    return found == m_buffers.end() ? nullptr : found->second;
}

QWidget* ViewArea::frameOf(lessons::ViewLeaf leaf) const {
    QWidget* view = viewOf(leaf);
    return view ? view->parentWidget() : nullptr;
}

bool ViewArea::setArrangement(const std::string& nameOrText) {
    auto wanted = lessons::arrangementOf(nameOrText);
    if (!wanted) return false;
    lessons::ViewTree tree = std::move(wanted).value();
    // The views that are there go on, those on show first.
    std::vector<int> buffers, spaces;
    const auto add = [](std::vector<int>& numbers, int number) {
        if (std::ranges::count(numbers, number) == 0) numbers.push_back(number);
    };
    for (const lessons::ViewLeaf leaf : leavesOf(m_tree))
        add(leaf.kind == lessons::ViewLeaf::Kind::Buffer ? buffers : spaces, leaf.number);
    for (const auto& [number, view] : m_buffers) add(buffers, number);
    for (const auto& [number, view] : m_spaces) add(spaces, number);
    renumber(tree, lessons::ViewLeaf::Kind::Buffer, buffers);
    renumber(tree, lessons::ViewLeaf::Kind::Space, spaces);
    if (arrangementName(tree) != arrangementName(m_tree)) m_kept.linked.reset();
    setTree(std::move(tree));
    return true;
}

void ViewArea::setTree(lessons::ViewTree tree) {
    const bool wasLinked = isLinked();
    m_tree = std::move(tree);
    m_alone = false;
    layOut();
    if (isLinked() && !wasLinked) leadSoon();
    emit changed();
}

void ViewArea::makeEven() {
    lessons::ViewTree tree = m_tree;
    lessons::makeEven(tree);
    setTree(std::move(tree));
}

void ViewArea::setAlone(bool alone) {
    m_alone = alone;
    layOut();
    emit changed();
}

// Frames move from the old splitters to the new ones, and are what they were.
void ViewArea::layOut() {
    if (m_laysOut) return;  // a frame that moves may give the middle another size for a moment
    const QScopedValueRollback guard(m_laysOut, true);
    bufferView(0), spaceView(0);
    for (const lessons::ViewLeaf leaf : leavesOf(m_tree))
        leaf.kind == lessons::ViewLeaf::Kind::Buffer ? void(bufferView(leaf.number)) : void(spaceView(leaf.number));
    const bool isLaidOut = m_middle->isVisible();
    const lessons::ViewTree whole = m_alone ? lessons::ViewTree{Kind::Leaf, active()} : m_tree;
    lessons::ViewTree shown = isLaidOut ? fitted(whole, room(), leastView(), gap()) : whole;
    tellMissing(leavesOf(whole).size() - leavesOf(shown).size());
    if (m_root && haveSameViews(shown, m_shown)) {
        m_shown = std::move(shown);
        return setShares(m_root, m_shown);
    }
    QWidget* focus = QApplication::focusWidget();
    m_middle->setUpdatesEnabled(false);
    m_shown = std::move(shown);
    if (m_root) m_middle->layout()->removeWidget(m_root);
    std::vector<QWidget*> frames;
    for (const auto& [number, view] : m_buffers) frames.push_back(view->parentWidget());
    for (const auto& [number, view] : m_spaces) frames.push_back(view->parentWidget());
    for (QWidget* frame : frames) frame->hide(), frame->setParent(m_middle);
    if (qobject_cast<EvenSplitter*>(m_root)) delete m_root;
    m_root = build(m_shown);
    m_middle->layout()->addWidget(m_root);
    for (const lessons::ViewLeaf leaf : leavesOf(m_shown)) frameOf(leaf)->show();
    m_root->show();
    for (const QWidget* frame : frames) followThemeAgain(*frame);
    setShares(m_root, m_shown);
    m_middle->setUpdatesEnabled(true);
    if (focus && focus->isVisible() && m_middle->isAncestorOf(focus)) focus->setFocus();
    m_thumbnails->setCurrent(activeBuffer().buffer());  // the active view may have gone
}

std::size_t ViewArea::withoutRoom() const { return m_alone ? 0 : leavesOf(m_tree).size() - leavesOf(m_shown).size(); }

// The sentence takes some of the views' height: where it stands, more of them may have no room, but never fewer.
void ViewArea::tellMissing(std::size_t count) {
    m_missing->setText(count == 1 ? tr("1 view has no room here.") : tr("%1 views have no room here.").arg(count));
    m_missing->setToolTip(tr("A view needs %1 by %2 pixels. Make the window larger, or hide a panel.")
                              .arg(leastView().width)
                              .arg(leastView().height));
    m_missing->setVisible(count > 0);
}

QWidget* ViewArea::build(const lessons::ViewTree& tree) {
    if (tree.kind == Kind::Leaf) return frameOf(tree.leaf);
    auto* splitter = new EvenSplitter(tree.kind == Kind::Row ? Qt::Horizontal : Qt::Vertical, m_middle);
    splitter->setChildrenCollapsible(false);
    splitter->setHandleWidth(gap());
    splitter->setMinimumSize(1, 1);  // the window does not grow for views: those without room are not shown
    for (const lessons::ViewTree& part : tree.parts) splitter->addWidget(build(part));
    connect(splitter, &EvenSplitter::sharesChanged, this, &ViewArea::takeShares);
    return splitter;
}

void ViewArea::setShares(QWidget* part, const lessons::ViewTree& tree) {
    auto* splitter = qobject_cast<EvenSplitter*>(part);
    if (!splitter) return;
    QList<int> shares;
    for (const lessons::ViewTree& one : tree.parts) shares << one.weight;
    splitter->setShares(shares);
    for (int i = 0; i < splitter->count(); ++i) setShares(splitter->widget(i), tree.parts[std::size_t(i)]);
}

void ViewArea::readShares(const QWidget* part, lessons::ViewTree& tree) const {
    const auto* splitter = qobject_cast<const EvenSplitter*>(part);
    for (int i = 0; splitter && i < splitter->count(); ++i) {
        tree.parts[std::size_t(i)].weight = splitter->shares()[i];
        readShares(splitter->widget(i), tree.parts[std::size_t(i)]);
    }
}

void ViewArea::takeShares() {
    readShares(m_root, m_shown);
    if (haveSameViews(m_tree, m_shown)) m_tree = m_shown;
    emit changed();
}

bool ViewArea::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_middle && (event->type() == QEvent::Resize || event->type() == QEvent::Show)) {
        layOut();
        emit changed();  // there may be room for more, or for less
    }
    return QWidget::eventFilter(watched, event);
}

lessons::ViewLeaf ViewArea::active() const {
    return contains(m_shown, m_active) ? m_active : leavesOf(m_shown).front();
}

void ViewArea::takeFocus(const QWidget* now) {
    for (const lessons::ViewLeaf leaf : leavesOf(m_shown)) {
        QWidget* frame = frameOf(leaf);
        const bool isActive = now && frame->isAncestorOf(now);
        if (leaf.kind == lessons::ViewLeaf::Kind::Space && frame->property("active").toBool() != isActive) {
            frame->setProperty("active", isActive);
            frame->style()->polish(frame);
        }
        if (!isActive || leaf == m_active) continue;
        m_active = leaf;
        m_thumbnails->setCurrent(activeBuffer().buffer());
        emit changed();
    }
}

void ViewArea::goTo(lessons::ViewLeaf leaf) {
    if (!contains(m_shown, leaf)) return;
    if (leaf.kind == lessons::ViewLeaf::Kind::Buffer)
        m_buffers.at(leaf.number)->takeKeys();
    else
        m_spaces.at(leaf.number)->setFocus(Qt::ShortcutFocusReason);
    m_active = leaf;
    emit changed();
}

void ViewArea::focusBuffer() { activeBuffer().takeKeys(); }

void ViewArea::goToNext(int step) {
    const QWidget* frame = frameOf(active());
    // From outside the first one.
    const bool isThere = QApplication::focusWidget() && frame->isAncestorOf(QApplication::focusWidget());
    goTo(isThere ? neighbour(m_shown, active(), step) : active());
}

void ViewArea::splitView(lessons::ViewLeaf leaf, Kind direction) {
    if (!whyNotSplit(leaf, direction).isEmpty()) return;
    const lessons::ViewLeaf added{lessons::ViewLeaf::Kind::Buffer, freeNumber(m_tree, lessons::ViewLeaf::Kind::Buffer)};
    lessons::ViewTree tree = m_tree;
    split(tree, leaf, direction, added);
    BufferView& view = bufferView(added.number);
    // What no other view shows.
    std::vector<pipeline::BufferName> taken;
    for (const lessons::ViewLeaf other : leavesOf(m_tree))
        if (other.kind == lessons::ViewLeaf::Kind::Buffer) taken.push_back(m_buffers.at(other.number)->buffer());
    if (m_document.hasScene())
        for (const auto& name : usefulBuffers(m_document.stage(), m_document.scene(), m_document.stepper().isInside()))
            if (std::ranges::count(taken, name) == 0) {
                view.setBuffer(name);
                break;
            }
    setTree(std::move(tree));
    goTo(added);
}

void ViewArea::closeView(lessons::ViewLeaf leaf) {
    lessons::ViewTree tree = m_tree;
    if (!lessons::close(tree, leaf)) return;
    QWidget* frame = frameOf(leaf);
    setTree(std::move(tree));
    if (leaf.number > 0) {  // the first ones are what the others begin with
        if (leaf.kind == lessons::ViewLeaf::Kind::Buffer)
            m_buffers.erase(leaf.number);
        else
            m_spaces.erase(leaf.number);
        frame->deleteLater();
    }
    goTo(active());
}

void ViewArea::turnView(lessons::ViewLeaf leaf) {
    const auto kind =
        leaf.kind == lessons::ViewLeaf::Kind::Buffer ? lessons::ViewLeaf::Kind::Space : lessons::ViewLeaf::Kind::Buffer;
    const lessons::ViewLeaf other{kind, freeNumber(m_tree, kind)};
    lessons::ViewTree tree = m_tree;
    if (!replace(tree, leaf, other)) return;
    setTree(std::move(tree));
    goTo(other);
}

QString ViewArea::whyNotSplit(lessons::ViewLeaf leaf, Kind direction) const {
    lessons::ViewTree tree = m_tree;
    if (!split(tree, leaf, direction,
               {lessons::ViewLeaf::Kind::Buffer, freeNumber(m_tree, lessons::ViewLeaf::Kind::Buffer)}))
        return tr("There are %1 views, as many as there can be.").arg(lessons::kMostViews);
    if (fitted(tree, room(), leastView(), gap()) == tree) return {};
    return tr("There is no room: a view needs %1 by %2 pixels.").arg(leastView().width).arg(leastView().height);
}

QString ViewArea::whyNotClose(lessons::ViewLeaf leaf) const {
    lessons::ViewTree tree = m_tree;
    return lessons::close(tree, leaf) ? QString() : tr("It is the only view.");
}

void ViewArea::addMenu(QMenu* menu, lessons::ViewLeaf leaf) {
    menu->setToolTipsVisible(true);
    menu->addSeparator();
    const bool isBuffer = leaf.kind == lessons::ViewLeaf::Kind::Buffer;
    if (isBuffer) {
        menu->addAction(tr("Save this buffer…"), this, [this, leaf] {
            goTo(leaf);
            emit saveAsked(SavedAs::Files);
        });
        menu->addAction(tr("Figure…"), this, [this, leaf] {
            goTo(leaf);
            emit saveAsked(SavedAs::Figure);
        });
        menu->addSeparator();
    }
    QAction* right = menu->addAction(tr("Split to the right"), this, [this, leaf] { splitView(leaf, Kind::Row); });
    QAction* below = menu->addAction(tr("Split below"), this, [this, leaf] { splitView(leaf, Kind::Column); });
    menu->addAction(isBuffer ? tr("3D view here") : tr("Buffer here"), this, [this, leaf] { turnView(leaf); });
    QAction* close = menu->addAction(tr("Close this view"), this, [this, leaf] { closeView(leaf); });
    connect(menu, &QMenu::aboutToShow, this, [=, this] {
        const auto enable = [](QAction* action, const QString& whyNot) {
            action->setEnabled(whyNot.isEmpty());
            action->setToolTip(whyNot);
        };
        enable(right, whyNotSplit(leaf, Kind::Row));
        enable(below, whyNotSplit(leaf, Kind::Column));
        enable(close, whyNotClose(leaf));
    });
}

}  // namespace app
