// What a ViewArea shows; how its views stand is in view_area_layout.cpp.
#include "app/desktop/view_area.h"

#include <QLabel>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/core/stage_buffer.h"
#include "app/desktop/even_splitter.h"
#include "app/panels/buffer_canvas.h"
#include "app/panels/buffer_view.h"
#include "app/panels/follow_theme.h"
#include "app/panels/thumbnail_strip.h"
#include "app/view3d/view3d_panel.h"

namespace app {

using pipeline::BufferName;

ViewArea::ViewArea(Document& document, QWidget* parent, ViewDress dress)
    : QWidget(parent),
      m_document(document),
      m_middle(new QWidget(this)),
      m_missing(new QLabel(this)),
      m_thumbnails(new ThumbnailStrip(document)),
      m_tree(*lessons::arrangementNamed("one")),
      m_dress(dress) {
    setObjectName("viewArea");
    auto* middle = new QVBoxLayout(m_middle);
    middle->setContentsMargins(0, 0, 0, 0);
    m_middle->installEventFilter(this);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_middle, 1);
    column->addWidget(m_missing);
    column->addWidget(m_thumbnails);
    m_missing->setObjectName("missingViews");
    m_missing->setProperty("tone", 2);
    m_missing->setWordWrap(true);
    m_missing->hide();
    m_thumbnails->setVisible(dress == ViewDress::Full);
    followTheme(this, [this, column] {
        column->setSpacing(gap());
        m_missing->setFont(Theme::current().text(12));
        for (auto* splitter : findChildren<EvenSplitter*>()) splitter->setHandleWidth(gap());
        // Room for one view: the others come and go.
        m_middle->setMinimumSize(leastView().width, leastView().height);
        layOut();
    });

    connect(m_thumbnails, &ThumbnailStrip::chosen, this, &ViewArea::showBuffer);
    connect(&document, &Document::stageChanged, this, &ViewArea::showStage);
    // Going inside, or out again, shows buffers that are there.
    connect(&document.stepper(), &Stepper::changed, this, [this] {
        if (std::exchange(m_inside, m_document.stepper().isInside()) != m_document.stepper().isInside()) showInside();
    });
    connect(&document, &Document::sceneOpened, this, [this] {
        m_kept.sliders.clear();
        showStage();
    });
    m_focus.begin([this](QWidget* now) { takeFocus(now); });
}

std::vector<BufferView*> ViewArea::inOrder() const {
    std::vector<BufferView*> views;
    for (const lessons::ViewLeaf leaf : leavesOf(m_tree))
        if (leaf.kind == lessons::ViewLeaf::Kind::Buffer)
            if (const auto found = m_buffers.find(leaf.number); found != m_buffers.end())
                views.push_back(found->second);
    for (const auto& [number, view] : m_buffers)
        if (std::ranges::count(views, view) == 0) views.push_back(view);
    return views;
}

void ViewArea::showStage() {
    if (!m_document.hasScene()) return;
    m_inside = m_document.stepper().isInside();
    const auto useful = usefulBuffers(m_document.stage(), m_document.scene(), m_inside);
    const bool isFree = arrangementName(m_tree).empty();
    std::size_t next = 0;
    for (BufferView* view : inOrder()) {
        if (next == 0 || !isFree || view->parentWidget()->isHidden()) view->setBuffer(useful[next % useful.size()]);
        ++next;
    }
}

void ViewArea::showInside() {
    if (!m_document.hasScene() || !m_inside) return;
    const auto useful = usefulBuffers(m_document.stage(), m_document.scene(), true);
    std::size_t next = 0;
    for (BufferView* view : inOrder()) {
        if (bufferInfo(view->buffer().id).stage > m_document.stage()) view->setBuffer(useful[next % useful.size()]);
        ++next;
    }
}

void ViewArea::showBuffer(const BufferName& buffer) {
    if (activeBuffer().parentWidget()->isHidden()) setArrangement("one");
    activeBuffer().setBuffer(buffer);
}

void ViewArea::showBuffers(const std::vector<BufferName>& buffers) {
    const auto views = inOrder();
    for (std::size_t i = 0; i < std::min(views.size(), buffers.size()); ++i) views[i]->setBuffer(buffers[i]);
}

std::vector<BufferView*> ViewArea::shownBuffers() const {
    std::vector<BufferView*> shown;
    for (const lessons::ViewLeaf leaf : leavesOf(m_tree))
        if (leaf.kind == lessons::ViewLeaf::Kind::Buffer) shown.push_back(m_buffers.at(leaf.number));
    if (shown.empty()) shown.push_back(&first());
    return shown;
}

void ViewArea::fill(lessons::WindowState& state) const {
    state.arrangement = arrangement();
    state.linked = m_kept.linked;
    state.sliders = m_kept.sliders;
    state.views.clear();
    state.spaces.clear();
    for (const lessons::ViewLeaf leaf : leavesOf(m_tree))
        if (leaf.kind == lessons::ViewLeaf::Kind::Space) state.spaces.push_back(m_spaces.at(leaf.number)->state());
    for (const BufferView* view : shownBuffers()) state.views.push_back(view->state());
    if (state.spaces.empty()) state.spaces.push_back(view3d().state());
}

pipeline::Errors ViewArea::lookAt(const lessons::WindowState& state) {
    pipeline::Errors errors;
    const auto add = [&](const pipeline::Errors& more) { errors.insert(errors.end(), more.begin(), more.end()); };
    const auto wanted = lessons::arrangementOf(state.arrangement);
    if (!wanted) add(wanted.errors());
    setArrangement(wanted ? state.arrangement : "one");
    m_kept.linked = state.linked;
    m_kept.sliders = state.sliders;
    const auto buffers = inOrder();
    for (std::size_t i = 0; i < std::min(buffers.size(), state.views.size()); ++i)
        add(buffers[i]->lookAt(state.views[i]));
    std::size_t next = 0;
    for (const lessons::ViewLeaf leaf : leavesOf(m_tree))
        if (leaf.kind == lessons::ViewLeaf::Kind::Space && next < state.spaces.size())
            add(m_spaces.at(leaf.number)->lookAt(state.spaces[next++]));
    if (next == 0 && !state.spaces.empty()) add(view3d().lookAt(state.spaces.front()));
    m_leadsSoon = false;  // each stands where the state says
    emit changed();
    return errors;
}

bool ViewArea::hasSecond() const {
    return std::ranges::count(leavesOf(m_tree), lessons::ViewLeaf::Kind::Buffer, &lessons::ViewLeaf::kind) > 1;
}

void ViewArea::setSecond(bool shown) {
    if (shown != hasSecond()) setArrangement(shown ? "two" : "one");
}

BufferView& ViewArea::first() const { return *inOrder().front(); }

BufferView& ViewArea::second() {
    if (m_buffers.size() < 2) bufferView(freeNumber(m_tree, lessons::ViewLeaf::Kind::Buffer));
    return *inOrder()[1];
}

BufferView& ViewArea::activeBuffer() const {
    const lessons::ViewLeaf leaf = active();
    return leaf.kind == lessons::ViewLeaf::Kind::Buffer ? *m_buffers.at(leaf.number) : first();
}

View3dPanel& ViewArea::view3d() const {
    for (const lessons::ViewLeaf leaf : leavesOf(m_tree))
        if (leaf.kind == lessons::ViewLeaf::Kind::Space) return *m_spaces.at(leaf.number);
    return *m_spaces.begin()->second;
}

lessons::LinkedPicture ViewArea::pictureIn(BufferView& view) const {
    const QSize size = view.canvas()->content().size;
    if (view.parentWidget()->isHidden()) return {};
    return {size.width(), size.height(), bufferInfo(view.buffer().id).domain == pipeline::Domain::Texel};
}

void ViewArea::lead(BufferView& view) {
    if (!isLinked()) return;
    for (const auto& [number, other] : m_buffers)
        if (other != &view && moveTogether(pictureIn(*other), pictureIn(view)))
            other->canvas()->follow(view.canvas()->look());
}

void ViewArea::join(BufferView& view) {
    if (!isLinked()) return;
    for (const auto& [number, other] : m_buffers)
        if (other != &view && moveTogether(pictureIn(*other), pictureIn(view)))
            return view.canvas()->follow(other->canvas()->look());
}

// Once the views have their new sizes.
void ViewArea::leadSoon() {
    m_leadsSoon = true;
    QTimer::singleShot(0, this, [this] {
        if (std::exchange(m_leadsSoon, false)) lead(activeBuffer());
    });
}

// Whole zooms: one pixel of a view's width more, and it shows the same part a step larger.
void ViewArea::agreeSoon() {
    if (!isLinked() || std::exchange(m_agreesSoon, true)) return;
    QTimer::singleShot(0, this, [this] {
        m_agreesSoon = false;
        const BufferCanvas& leading = *activeBuffer().canvas();
        const auto asked = leading.part();
        if (!isLinked() || !asked) return;
        for (const auto& [number, other] : m_buffers) {
            const auto its = other->canvas()->part();
            const bool isSame = its && its->factor == asked->factor && its->center == asked->center;
            if (isSame && other->canvas()->zoom() != leading.zoom() &&
                moveTogether(pictureIn(*other), pictureIn(activeBuffer())))
                other->canvas()->follow(leading.look());
        }
    });
}

void ViewArea::setLinked(bool linked) {
    m_kept.linked = linked;
    if (linked) lead(activeBuffer());
    emit changed();
}

bool ViewArea::hasThumbnails() const { return !m_thumbnails->isHidden(); }
void ViewArea::setThumbnails(bool shown) { m_thumbnails->setVisible(shown); }

}  // namespace app
