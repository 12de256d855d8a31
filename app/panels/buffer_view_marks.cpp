// Pinned pixels and the region of a BufferView.
#include <QLabel>

#include "app/core/large_frame.h"
#include "app/core/pinned_pixels.h"
#include "app/panels/buffer_canvas.h"
#include "app/panels/buffer_header.h"
#include "app/panels/buffer_view.h"
#include "app/panels/region_panel.h"

namespace app {

void BufferView::observeMarks() {
    PinnedPixels& pins = PinnedPixels::of(m_document);
    connect(&pins, &PinnedPixels::changed, this, &BufferView::showPins);
    connect(m_canvas, &BufferCanvas::regionDragged, this, [this](QRect region) {
        const QPoint a = region.topLeft(), b = region.bottomRight();
        setRegion(Region{{a.x(), a.y()}, {b.x(), b.y()}});
    });
    connect(m_region, &RegionPanel::closed, this, [this] { setRegion({}); });
    connect(m_region, &RegionPanel::resized, this, &BufferView::placeOverlays);
    connect(&m_document, &Document::sceneOpened, this, [this] { setRegion({}); });
    connect(m_header, &BufferHeader::flipChosen, this, &BufferView::setFlipped);
    connect(m_header, &BufferHeader::measureChosen, this, &BufferView::measure);
    connect(m_header, &BufferHeader::pinChosen, this, &BufferView::togglePin);
    connect(m_header, &BufferHeader::unpinAllChosen, &pins, &PinnedPixels::clear);
}

// Around an object of many polygons it takes longer than the next frame is away: the newest mark stays until then.
void BufferView::markSelection() {
    const auto& selection = m_document.selection();
    const bool marks = m_frame && selection && standsOnPicture();
    if (!marks || !isLarge(*m_frame)) {
        m_marking.forget();
        return m_canvas->setMarked(marks ? outlinesOf(*m_frame, *selection) : std::vector<QPolygonF>());
    }
    m_marking.ask(
        [frame = m_frame, thing = *selection](const BackgroundJob::Control&) { return outlinesOf(*frame, thing); },
        [this](const std::vector<QPolygonF>& outlines) { m_canvas->setMarked(outlines); },
        BackgroundJob::Running::Finish);
}

void BufferView::setFlipped(bool flipped) {
    m_canvas->setFlipped(flipped);
    m_header->setFlipped(flipped);
    m_header->show(m_name, channel());
    placeOverlays();
}

void BufferView::setRegion(const std::optional<Region>& region) {
    m_regionShown = region;
    showRegion();
}

// Of what the view holds now, which may be the difference of a comparison.
void BufferView::showRegion() {
    const bool isPixels = m_shown && !m_shown->content.shapes;
    std::optional<QRect> rectangle;
    if (m_regionShown && isPixels) {
        const glm::ivec2 first = m_regionShown->first(), last = m_regionShown->last();
        const QRect inPicture =
            QRect(QPoint(first.x, first.y), QPoint(last.x, last.y)) & QRect(QPoint(0, 0), m_shown->content.size);
        if (!inPicture.isEmpty()) rectangle = inPicture;  // which may have become smaller
    }
    m_canvas->setRegion(rectangle);
    std::optional<Region> region;
    if (rectangle) region = {{rectangle->left(), rectangle->top()}, {rectangle->right(), rectangle->bottom()}};
    if (m_shown) m_region->show(m_shown->buffer, region, m_shown->look.channel);
    placeOverlays();
}

// Between the first two pins, or where there are none of what is visible.
void BufferView::measure() {
    if (!m_shown) return;
    const PinnedPixels& pins = PinnedPixels::of(m_document);
    if (const auto a = pins.pin(1), b = pins.pin(2); a && b && standsOnPicture()) return setRegion(Region{*a, *b});
    const QRect seen = m_canvas->visiblePart();
    setRegion(Region{{seen.left(), seen.top()}, {seen.right(), seen.bottom()}});
}

void BufferView::togglePin() {
    const auto pixel = m_document.pixel();
    if (!standsOnPicture()) return;
    if (!pixel) {
        emit m_document.said(tr("Pick a pixel first."));
        return;
    }
    if (!PinnedPixels::of(m_document).toggle(*pixel))
        emit m_document.said(tr("All nine pins are taken. P on a pinned pixel takes its pin away."));
}

void BufferView::goToPin(int number) {
    if (const auto pixel = PinnedPixels::of(m_document).pin(number)) m_document.pick(*pixel);
}

void BufferView::showPins() {
    std::vector<std::pair<int, QPoint>> marks;
    QStringList lines;
    if (m_shown && standsOnPicture())
        for (int number = 1; number <= PinnedPixels::kMost; ++number)
            if (const auto pixel = PinnedPixels::of(m_document).pin(number)) {
                marks.emplace_back(number, QPoint(pixel->x, pixel->y));
                lines << QString("%1  %2").arg(number).arg(readout(marks.back().second));
            }
    m_canvas->setPinned(std::move(marks));
    m_pins->setText(lines.join('\n'));
    m_pins->setAccessibleName(tr("Pinned pixels"));
    m_pins->setVisible(!lines.isEmpty());
    placeOverlays();
}

void BufferView::nudge(QPoint by) {
    if (!standsOnPicture() || !m_document.hasScene()) return;
    const auto from = m_document.pixel().value_or(
        glm::ivec2(m_document.scene().settings.width, m_document.scene().settings.height) / 2);
    m_document.pick(from + glm::ivec2(by.x(), by.y()));
}

}  // namespace app
