#include "app/buffer_view/buffer_region.h"

#include <QKeyEvent>
#include <QMenu>

#include "app/buffer_view/buffer_header.h"
#include "app/buffer_view/buffer_view.h"
#include "app/buffer_view/region_panel.h"
#include "app/canvas/buffer_canvas.h"
#include "app/frames/pinned_pixels.h"

namespace app {

RegionMark::RegionMark(BufferView& view) : BufferFeature(view), m_panel(new RegionPanel(view.canvas())) {
    view.header().menu()->addAction(tr("Statistics of what is visible\tM"), this, &RegionMark::measure);
    connect(&view.canvas()->input(), &CanvasInput::regionDragged, this, [this](QRect region) {
        const QPoint a = region.topLeft(), b = region.bottomRight();
        set(Region{{a.x(), a.y()}, {b.x(), b.y()}});
    });
    connect(m_panel, &RegionPanel::closed, this, [this] { set({}); });
    connect(m_panel, &RegionPanel::resized, &view, &BufferView::place);
    connect(&view.document(), &Document::sceneOpened, this, [this] { set({}); });
}

void RegionMark::set(const std::optional<Region>& region) {
    m_region = region;
    show();
    view().place();
}

void RegionMark::measure() {
    if (!view().shown()) return;
    const PinnedPixels& pins = view().document().pointing().pins();
    if (const auto a = pins.pin(1), b = pins.pin(2); a && b && view().isOfPixels()) return set(Region{*a, *b});
    const QRect seen = view().canvas()->placing().visiblePart();
    set(Region{{seen.left(), seen.top()}, {seen.right(), seen.bottom()}});
}

bool RegionMark::press(const QKeyEvent& key) {
    if (key.key() == Qt::Key_M) return measure(), true;
    if (key.key() == Qt::Key_Escape && m_region) return set({}), true;
    return false;
}

// Of the values on show, which may be the difference of a comparison.
void RegionMark::show() {
    const auto& shown = view().shown();
    std::optional<QRect> rectangle;
    if (m_region && shown && !shown->content.shapes) {
        const glm::ivec2 first = m_region->first(), last = m_region->last();
        const QRect inPicture =
            QRect(QPoint(first.x, first.y), QPoint(last.x, last.y)) & QRect(QPoint(0, 0), shown->content.size);
        if (!inPicture.isEmpty()) rectangle = inPicture;  // which may have become smaller
    }
    view().canvas()->setRegion(rectangle);
    std::optional<Region> region;
    if (rectangle) region = {{rectangle->left(), rectangle->top()}, {rectangle->right(), rectangle->bottom()}};
    if (shown) m_panel->show(shown->buffer, region, shown->look.channel);
}

// Where it covers neither the pins' values nor, if there is a choice, the region.
void RegionMark::place(CanvasRoom& room) {
    const BufferCanvas& canvas = *view().canvas();
    const int x = room.size.width() - m_panel->width() - CanvasRoom::kMargin;
    const bool isTight = room.left && *room.left > x - CanvasRoom::kMargin;
    const auto& region = canvas.content().region;
    const bool isLow = region && canvas.placing().visiblePart().center().y() < region->center().y();
    const bool onTop = isTight || isLow != canvas.placing().isFlipped();
    m_panel->move(x, onTop ? CanvasRoom::kMargin : room.size.height() - m_panel->height() - CanvasRoom::kMargin);
}

void RegionMark::write(lessons::BufferShown& state) const {
    if (!m_region) return;
    const glm::ivec2 first = m_region->first(), last = m_region->last();
    state.region = {first.x, first.y, last.x, last.y};
}

pipeline::Errors RegionMark::read(const lessons::BufferShown& state) {
    const auto& r = state.region;
    set(r ? std::optional(Region{{(*r)[0], (*r)[1]}, {(*r)[2], (*r)[3]}}) : std::nullopt);
    return {};
}

}  // namespace app
