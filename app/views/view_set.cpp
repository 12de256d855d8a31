#include "app/views/view_set.h"

#include <QFrame>
#include <QVBoxLayout>
#include <algorithm>

#include "app/buffer_view/buffer_features.h"
#include "app/buffer_view/buffer_header.h"
#include "app/buffer_view/buffer_range.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/range_bar.h"
#include "app/look/hidden_in_window.h"
#include "app/view3d/view3d_panel.h"
#include "app/widgets/follow_theme.h"

namespace app {

using lessons::ViewLeaf;
using lessons::ViewTree;

namespace {

// The numbers of one kind: those of the tree, as they are read, then the others.
template <class View>
std::vector<int> numbersFrom(const ViewTree& tree, ViewLeaf::Kind kind, const std::map<int, View*>& views) {
    std::vector<int> numbers;
    for (const ViewLeaf leaf : leavesOf(tree))
        if (leaf.kind == kind && views.contains(leaf.number)) numbers.push_back(leaf.number);
    for (const auto& [number, view] : views)
        if (std::ranges::count(numbers, number) == 0) numbers.push_back(number);
    return numbers;
}

template <class View>
std::vector<View*> viewsFrom(const ViewTree& tree, ViewLeaf::Kind kind, const std::map<int, View*>& views) {
    std::vector<View*> all;
    for (const int number : numbersFrom(tree, kind, views)) all.push_back(views.at(number));
    return all;
}

}  // namespace

ViewSet::ViewSet(Document& document, QWidget& room, ViewDress dress)
    : m_document(document), m_room(room), m_dress(dress) {}

BufferView& ViewSet::buffer(int number) {
    BufferView*& view = m_buffers[number];
    if (view) return *view;
    const ViewLeaf leaf{ViewLeaf::Kind::Buffer, number};
    view = new BufferView(m_document);
    frame(view, leaf);
    view->setBare(m_dress == ViewDress::Bare);
    if (m_dress == ViewDress::Bare)
        connect(&view->features().range->foot(), &RangeBar::shown, this, &ViewSet::alignPictures);
    emit made(leaf);
    return *view;
}

// An audience compares pictures: one above a histogram is as high as one beside it.
void ViewSet::alignPictures() {
    const bool any = std::ranges::any_of(m_buffers, [](const auto& one) {
        return !isHiddenInWindow(*one.second) && !one.second->features().range->foot().isHidden();
    });
    for (const auto& one : m_buffers) one.second->features().range->foot().keepRoom(any);
}

View3dPanel& ViewSet::space(int number) {
    View3dPanel*& view = m_spaces[number];
    if (view) return *view;
    const ViewLeaf leaf{ViewLeaf::Kind::Space, number};
    view = new View3dPanel(m_document);
    frame(view, leaf);
    view->setBare(m_dress == ViewDress::Bare);
    emit made(leaf);
    return *view;
}

void ViewSet::make(ViewLeaf leaf) {
    if (leaf.kind == ViewLeaf::Kind::Buffer)
        buffer(leaf.number);
    else
        space(leaf.number);
}

void ViewSet::remove(ViewLeaf leaf) {
    QWidget* frame = frameOf(leaf);
    if (leaf.kind == ViewLeaf::Kind::Buffer)
        m_buffers.erase(leaf.number);
    else
        m_spaces.erase(leaf.number);
    if (frame) frame->deleteLater();
}

void ViewSet::frame(QWidget* view, ViewLeaf leaf) {
    const bool isSpace = leaf.kind == ViewLeaf::Kind::Space;
    const QString number = leaf.number > (isSpace ? 0 : 1) ? QString::number(leaf.number + 1) : QString();
    const QString name = isSpace ? "view3d" : leaf.number == 0 ? "first" : number.isEmpty() ? "second" : "buffer";
    auto* frame = new QFrame(&m_room);
    frame->hide();
    frame->setObjectName(name + number + "Frame");
    if (!isSpace) view->setObjectName(name + number + "BufferView");
    frame->setProperty("kind", "panel");
    auto* column = new QVBoxLayout(frame);
    column->setContentsMargins(1, 1, 1, 1);
    column->addWidget(view);
    followTheme(frame, [this, frame] { frame->setMinimumSize(leastSize().width, leastSize().height); });
}

std::vector<BufferView*> ViewSet::buffersFrom(const ViewTree& tree) const {
    return viewsFrom(tree, ViewLeaf::Kind::Buffer, m_buffers);
}

std::vector<View3dPanel*> ViewSet::spacesFrom(const ViewTree& tree) const {
    return viewsFrom(tree, ViewLeaf::Kind::Space, m_spaces);
}

void ViewSet::renumber(ViewTree& tree, const ViewTree& before) const {
    const auto buffers = numbersFrom(before, ViewLeaf::Kind::Buffer, m_buffers);
    const auto spaces = numbersFrom(before, ViewLeaf::Kind::Space, m_spaces);
    lessons::renumber(tree, ViewLeaf::Kind::Buffer, buffers);
    lessons::renumber(tree, ViewLeaf::Kind::Space, spaces);
}

QWidget* ViewSet::frameOf(ViewLeaf leaf) const {
    if (leaf.kind == ViewLeaf::Kind::Space) {
        const auto found = m_spaces.find(leaf.number);
        return found == m_spaces.end() ? nullptr : found->second->parentWidget();
    }
    const auto found = m_buffers.find(leaf.number);
    return found == m_buffers.end() ? nullptr : found->second->parentWidget();
}

std::vector<QWidget*> ViewSet::frames() const {
    std::vector<QWidget*> all;
    for (const auto& [number, view] : m_buffers) all.push_back(view->parentWidget());
    for (const auto& [number, view] : m_spaces) all.push_back(view->parentWidget());
    return all;
}

QMenu* ViewSet::menuOf(ViewLeaf leaf) const {
    return leaf.kind == ViewLeaf::Kind::Buffer ? m_buffers.at(leaf.number)->header().menu()
                                               : m_spaces.at(leaf.number)->menu();
}

void ViewSet::giveKeys(ViewLeaf leaf) {
    if (leaf.kind == ViewLeaf::Kind::Buffer)
        m_buffers.at(leaf.number)->takeKeys();
    else
        m_spaces.at(leaf.number)->setFocus(Qt::ShortcutFocusReason);
}

// A header, a foot, and a picture to be seen between them.
lessons::ViewSize ViewSet::leastSize() const {
    const Theme& theme = Theme::current();
    if (m_dress == ViewDress::Bare) return {theme.px(120), theme.px(90)};  // a picture and its name
    return {std::max(282, theme.px(250)), std::max(222, theme.px(100))};
}

}  // namespace app
