// What a BufferCanvas marks in its picture, and which way up the picture stands.
#include "app/panels/buffer_canvas.h"
#include "app/panels/canvas_flip.h"

namespace app {

void BufferCanvas::setHovered(std::optional<QPoint> pixel) {
    if (pixel == m_content.hovered) return;
    m_content.hovered = pixel;
    update();
}

void BufferCanvas::setMarked(std::vector<QPolygonF> outlines) {
    if (outlines == m_content.marked) return;
    m_content.marked = std::move(outlines);
    update();
}

void BufferCanvas::setPinned(std::vector<std::pair<int, QPoint>> pinned) {
    if (pinned == m_content.pinned) return;
    m_content.pinned = std::move(pinned);
    update();
}

void BufferCanvas::setRegion(std::optional<QRect> region) {
    if (region == m_content.region) return;
    m_content.region = region;
    update();
}

CanvasContent BufferCanvas::painted(const CanvasContent& content) const {
    return m_flipped ? upsideDown(content) : content;
}

QPointF BufferCanvas::toShown(QPointF picture) const {
    return m_flipped ? upsideDown(picture, m_content.size.height()) : picture;
}

void BufferCanvas::setFlipped(bool flipped) {
    if (flipped == m_flipped) return;
    m_flipped = flipped;
    m_part.reset();
    // What was in the middle of the view stays there.
    const QPointF middle = m_placement.toPicture(QRectF(rect()).center());
    m_focus.moveTop(m_content.size.height() - m_focus.bottom());
    place({QRectF(rect()).center() - upsideDown(middle, m_content.size.height()) * zoom(), zoom()});
}

QRect BufferCanvas::visiblePart() const {
    const QPointF a = toShown(m_placement.toPicture({0, 0}));
    const QPointF b = toShown(m_placement.toPicture(QPointF(width(), height())));
    return QRectF(a, b).normalized().toAlignedRect() & QRect(QPoint(0, 0), m_content.size);
}

}  // namespace app
