#include "app/canvas/buffer_canvas.h"

#include "app/canvas/canvas_flip.h"
#include "app/look/accessible.h"
#include "app/widgets/follow_theme.h"

namespace app {
namespace {

template <class Mark>
void mark(QWidget& canvas, Mark& now, Mark mark) {
    if (mark == now) return;
    now = std::move(mark);
    canvas.update();
}

}  // namespace

BufferCanvas::BufferCanvas(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setMinimumSize(120, 90);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleRole(*this, QAccessible::Graphic);
    setCursor(Qt::CrossCursor);
    followTheme(this, [this] { updateAll(); });
    connect(&m_placing, &CanvasPlacing::changed, this, qOverload<>(&BufferCanvas::update));
    for (CanvasBase* base : {&m_base, &m_otherBase}) {
        connect(base, &CanvasBase::painted, this, qOverload<>(&BufferCanvas::update));
        connect(base, &CanvasBase::busyChanged, this, &BufferCanvas::paintingChanged);
    }
}

QSize BufferCanvas::sizeHint() const { return m_content.size.isEmpty() ? QSize(320, 240) : m_content.size; }

void BufferCanvas::setContent(CanvasContent content) {
    // What is picked and marked stays until it is told anew.
    content.picked = m_content.picked, content.hovered = m_content.hovered;
    content.pinned = m_content.pinned;
    content.region = m_content.region;
    content.ground = m_content.ground;
    m_content = std::move(content);
    m_placing.setPicture(m_content.size, m_content.focus);
    updateAll();
}

void BufferCanvas::setOther(std::optional<CanvasContent> other, const Wipe& wipe) {
    m_other = std::move(other);
    m_otherBase.change();
    setWipe(wipe);
}

void BufferCanvas::setWipe(const Wipe& wipe) {
    const bool wasOther = &seen() != &m_content;
    m_wipe = wipe;
    if (!m_other) m_wipe.share = 1, m_wipe.hasHandle = false;
    update();
    if (wasOther || &seen() != &m_content) emit seenChanged();
}

CanvasContent BufferCanvas::painted(const CanvasContent& content) const {
    return m_placing.isFlipped() ? upsideDown(content) : content;
}

void BufferCanvas::setPicked(std::optional<QPoint> pixel) {
    if (pixel == m_content.picked) return;
    m_content.picked = pixel;
    m_placing.setPicked(pixel);
    update();
}

void BufferCanvas::setHovered(std::optional<QPoint> pixel) { mark(*this, m_content.hovered, pixel); }
void BufferCanvas::setMarked(std::vector<QPolygonF> outlines) { mark(*this, m_content.marked, std::move(outlines)); }
void BufferCanvas::setPinned(std::vector<std::pair<int, QPoint>> pinned) {
    mark(*this, m_content.pinned, std::move(pinned));
}
void BufferCanvas::setRegion(std::optional<QRect> region) { mark(*this, m_content.region, region); }
void BufferCanvas::setShowEdges(bool show) { mark(*this, m_showEdges, show); }

void BufferCanvas::setGround(QColor ground) {
    if (ground == m_content.ground) return;
    m_content.ground = ground;
    updateAll();
}

void BufferCanvas::setEdgeView(std::optional<pipeline::EdgeView> view) {
    if (view == m_content.edgeView) return;
    m_content.edgeView = view;
    updateAll();
}

void BufferCanvas::retryPainting() {
    m_base.retry(), m_otherBase.retry();
    update();
}

void BufferCanvas::updateAll() {
    m_base.change();
    m_otherBase.change();
    update();
    emit seenChanged();
}

void BufferCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Placement placement = m_placing.placement();
    const auto draw = [&](CanvasBase& base, const CanvasContent& content, QRect part) {
        if (part.isEmpty()) return;
        painter.setClipRect(part);
        base.draw(painter, content, {placement, size(), devicePixelRatio(), m_showEdges, m_placing.isFlipped()});
        painter.setClipping(false);
    };
    const int border = m_other ? m_wipe.border(width()) : width();
    draw(m_base, m_content, {0, 0, border, height()});
    if (m_other) draw(m_otherBase, *m_other, {border, 0, width() - border, height()});
    static const auto kNoShapes = std::make_shared<const ShapePicture>();
    CanvasContent marks;  // without the images
    marks.size = m_content.size;
    if (!m_content.ground.isValid()) marks.picked = m_content.picked;  // BufferHolds draws a ring there
    marks.hovered = m_content.hovered;
    marks.marked = m_content.marked, marks.pinned = m_content.pinned, marks.region = m_content.region;
    if (m_content.shapes) marks.shapes = kNoShapes;
    paintMarks(painter, painted(marks), placement, rect());
    if (m_placing.isFlipped() && !m_content.size.isEmpty()) paintOrigin(painter, placement, m_content.size);
    paintWipe(painter, m_wipe, rect());
}

void BufferCanvas::resizeEvent(QResizeEvent*) {
    m_placing.followSize();
    emit sizeChanged();
}

}  // namespace app
