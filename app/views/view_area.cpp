#include "app/views/view_area.h"

#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "app/buffer_view/buffer_holds.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/thumbnail_strip.h"
#include "app/view3d/view3d_panel.h"
#include "app/widgets/follow_theme.h"

namespace app {

using lessons::ViewLeaf;
using pipeline::BufferName;

namespace {

std::size_t countOf(const lessons::ViewTree& tree, ViewLeaf::Kind kind) {
    return std::size_t(std::ranges::count(leavesOf(tree), kind, &ViewLeaf::kind));
}

}  // namespace

ViewArea::ViewArea(Document& document, QWidget* parent, ViewDress dress)
    : QWidget(parent),
      m_grid(new ViewGrid(document, dress, this)),
      m_missing(styled(new QLabel(this), {.name = "missingViews", .tone = 2, .size = 12, .wraps = true})),
      m_thumbnails(new ThumbnailStrip(document)),
      m_active(*m_grid),
      m_links(*m_grid, m_active),
      m_stage(document, *m_grid),
      m_edits(*m_grid, m_active, m_stage) {
    setObjectName("viewArea");
    auto* column = spaced(new QVBoxLayout(this), {});
    column->addWidget(m_grid, 1);
    column->addWidget(m_missing);
    column->addWidget(m_thumbnails);
    m_missing->hide();
    m_thumbnails->setVisible(dress == ViewDress::Full);

    connect(&m_grid->views(), &ViewSet::made, this, [this, dress](ViewLeaf leaf) { takeView(leaf, dress); });
    connect(m_grid, &ViewGrid::missing, this, &ViewArea::tellMissing);
    connect(m_grid, &ViewGrid::rebuilt, this, &ViewArea::markThumbnail);  // the active view may have gone
    connect(m_grid, &ViewGrid::rebuilt, this, &ViewArea::giveHolds);
    connect(&m_active, &ActiveView::focused, this, &ViewArea::markThumbnail);
    connect(m_grid, &ViewGrid::changed, this, &ViewArea::changed);
    connect(&m_active, &ActiveView::changed, this, &ViewArea::changed);
    connect(&m_links, &ViewLinks::changed, this, &ViewArea::changed);
    followTheme(this, [this, column] {
        column->setSpacing(m_grid->gap());
        m_missing->setContentsMargins(Theme::current().px(8), 0, Theme::current().px(8), Theme::current().px(2));
        m_grid->applyTheme();
    });

    connect(m_thumbnails, &ThumbnailStrip::chosen, this, &ViewArea::showBuffer);
    connect(&document, &Document::stageChanged, this, [this] { m_stage.showStage(); });
    connect(&document.stepper(), &Stepper::changed, this, [this] { m_stage.followStepper(); });
    connect(&document, &Document::sceneOpened, this, [this] {
        m_sliders.clear();
        m_stage.showStage();
    });
}

// A view that has just been made.
void ViewArea::takeView(ViewLeaf leaf, ViewDress dress) {
    if (dress == ViewDress::Full)
        addViewMenu(*m_grid->views().menuOf(leaf), leaf, m_active, m_edits, [this](SavedAs as) { emit saveAsked(as); });
    if (leaf.kind == ViewLeaf::Kind::Space) return;
    BufferView& view = m_grid->views().buffer(leaf.number);
    connect(&view, &BufferView::bufferChanged, this, [this, &view] {
        if (&view == &activeBuffer()) markThumbnail();
        giveHolds();
    });
    m_links.add(view);
    m_stage.begin(view);
}

void ViewArea::markThumbnail() { m_thumbnails->setCurrent(activeBuffer().buffer()); }

// To the first view on show that has the picture's pixels.
void ViewArea::giveHolds() {
    const auto shown = shownBuffers();
    // While an arrangement is set, a view may be on its way.
    const auto first = std::ranges::find_if(shown, [](const BufferView* view) { return view && view->isOfPixels(); });
    for (const auto& [number, view] : m_grid->views().buffers())
        if (view) view->features().holds->setOn(first != shown.end() && view == *first);
}

void ViewArea::setHeld(bool held) {
    for (const auto& [number, view] : m_grid->views().buffers()) view->features().holds->setHeld(held);
}

// The sentence takes some of the views' height: where it stands, more of them may have no room, but never fewer.
void ViewArea::tellMissing(std::size_t count) {
    const lessons::ViewSize least = m_grid->views().leastSize();
    m_missing->setText(count == 1 ? tr("1 view has no room here.") : tr("%1 views have no room here.").arg(count));
    m_missing->setToolTip(tr("A view needs %1 by %2 pixels. Make the window larger, or hide a panel.")
                              .arg(least.width)
                              .arg(least.height));
    m_missing->setVisible(count > 0);
}

bool ViewArea::setArrangement(const std::string& nameOrText) {
    auto wanted = lessons::arrangementOf(nameOrText);
    if (!wanted) return false;
    lessons::ViewTree tree = std::move(wanted).value();
    m_grid->views().renumber(tree, m_grid->tree());
    if (arrangementName(tree) != arrangementName(m_grid->tree())) m_links.choose(std::nullopt);
    m_grid->setTree(std::move(tree));
    return true;
}

bool ViewArea::hasSecond() const { return countOf(m_grid->tree(), ViewLeaf::Kind::Buffer) > 1; }

void ViewArea::setSecond(bool shown) {
    if (shown != hasSecond()) setArrangement(shown ? "two" : "one");
}

void ViewArea::setAlone(bool alone) { m_grid->setAlone(alone ? std::optional(m_active.leaf()) : std::nullopt); }

bool ViewArea::hasThumbnails() const { return !m_thumbnails->isHidden(); }
void ViewArea::setThumbnails(bool shown) { m_thumbnails->setVisible(shown); }

void ViewArea::showBuffer(const BufferName& buffer) {
    if (activeBuffer().parentWidget()->isHidden()) setArrangement("one");
    activeBuffer().setBuffer(buffer);
}

void ViewArea::showBuffers(const std::vector<BufferName>& buffers) {
    const auto views = m_grid->views().buffersFrom(m_grid->tree());
    for (std::size_t i = 0; i < std::min(views.size(), buffers.size()); ++i) views[i]->setBuffer(buffers[i]);
}

void ViewArea::fill(lessons::WindowState& state) const {
    state.arrangement = arrangement();
    state.linked = m_links.chosen();
    state.sliders = m_sliders;
    state.views.clear();
    state.spaces.clear();
    for (const View3dPanel* space : shownSpaces()) state.spaces.push_back(space->state());
    for (const BufferView* view : shownBuffers()) state.views.push_back(view->state());
}

pipeline::Errors ViewArea::lookAt(const lessons::WindowState& state) {
    pipeline::Errors errors;
    const auto add = [&](const pipeline::Errors& more) { errors.insert(errors.end(), more.begin(), more.end()); };
    const auto wanted = lessons::arrangementOf(state.arrangement);
    if (!wanted) add(wanted.errors());
    setArrangement(wanted ? state.arrangement : "one");
    m_links.choose(state.linked);
    m_sliders = state.sliders;
    const auto buffers = m_grid->views().buffersFrom(m_grid->tree());
    for (std::size_t i = 0; i < std::min(buffers.size(), state.views.size()); ++i)
        add(buffers[i]->lookAt(state.views[i]));
    const auto spaces = shownSpaces();
    for (std::size_t i = 0; i < std::min(spaces.size(), state.spaces.size()); ++i)
        add(spaces[i]->lookAt(state.spaces[i]));
    m_links.stay();
    emit changed();
    return errors;
}

BufferView& ViewArea::first() const { return *m_grid->views().buffersFrom(m_grid->tree()).front(); }

BufferView& ViewArea::second() {
    ViewSet& views = m_grid->views();
    if (views.buffers().size() < 2) views.buffer(freeNumber(m_grid->tree(), ViewLeaf::Kind::Buffer));
    return *views.buffersFrom(m_grid->tree())[1];
}

View3dPanel& ViewArea::view3d() const { return *shownSpaces().front(); }

std::vector<BufferView*> ViewArea::shownBuffers() const {
    auto views = m_grid->views().buffersFrom(m_grid->tree());
    views.resize(std::max<std::size_t>(countOf(m_grid->tree(), ViewLeaf::Kind::Buffer), 1));
    return views;
}

std::vector<View3dPanel*> ViewArea::shownSpaces() const {
    auto views = m_grid->views().spacesFrom(m_grid->tree());
    views.resize(std::max<std::size_t>(countOf(m_grid->tree(), ViewLeaf::Kind::Space), 1));
    return views;
}

}  // namespace app
