#include "app/panels/buffer_canvas.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/core/spoken.h"
#include "app/panels/follow_theme.h"

namespace app {

namespace {

constexpr std::array kZooms{0.1, 0.125, 0.2,  0.25, 1.0 / 3, 0.5, 2.0 / 3, 1.0,  1.5,  2.0,  3.0,  4.0,  5.0, 6.0,
                            8.0, 10.0,  12.0, 16.,  20.,     24., 32.,     40.0, 48.0, 56.0, 72.0, 96.0, 128.};

}  // namespace

BufferCanvas::BufferCanvas(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    speakAs(*this, QAccessible::Graphic);
    setCursor(Qt::CrossCursor);
    followTheme(this, [this] { updateAll(); });
    for (CanvasBase* base : {&m_base, &m_otherBase}) {
        connect(base, &CanvasBase::painted, this, qOverload<>(&BufferCanvas::update));
        connect(base, &CanvasBase::busyChanged, this, &BufferCanvas::paintingChanged);
    }
}

QSize BufferCanvas::sizeHint() const { return m_content.size.isEmpty() ? QSize(320, 240) : m_content.size; }

double BufferCanvas::zoom() const { return m_placement.zoom; }

double BufferCanvas::nextZoom(double zoom, int steps) {
    for (; steps > 0; --steps) {
        const auto next = std::find_if(kZooms.begin(), kZooms.end(), [&](double z) { return z > zoom * 1.001; });
        if (next != kZooms.end()) zoom = *next;
    }
    for (; steps < 0; ++steps) {
        const auto next = std::find_if(kZooms.rbegin(), kZooms.rend(), [&](double z) { return z < zoom * 0.999; });
        if (next != kZooms.rend()) zoom = *next;
    }
    return zoom;
}

double BufferCanvas::fittingZoom() const {
    if (m_focus.isEmpty()) return 1;
    const double zoom = std::min(width() / m_focus.width(), height() / m_focus.height());
    return zoom >= 2 ? std::floor(zoom) : std::max(zoom, 0.01);
}

void BufferCanvas::fit(bool whole) {
    m_part.reset();
    m_fits = true;
    const QRectF all(QPointF(0, 0), QSizeF(m_content.size));
    m_focus = whole || m_content.focus.isEmpty() ? all : toShown(m_content.focus);
    placeFocus();
}

std::optional<lessons::BufferShown::Zoom> BufferCanvas::part() const {
    if (m_part) return m_part;
    if (m_fits || m_content.size.isEmpty()) return {};
    const QPointF center = toShown(m_placement.toPicture(QRectF(rect()).center()));
    return lessons::BufferShown::Zoom{m_placement.zoom, {center.x(), center.y()}, {double(width()), double(height())}};
}

void BufferCanvas::showPart(const std::optional<lessons::BufferShown::Zoom>& part) {
    if (!part) return fit();
    m_part = part;
    m_fits = false;
    placePart();
}

QRectF BufferCanvas::toShown(QRectF picture) const {
    return QRectF(toShown(picture.topLeft()), toShown(picture.bottomRight())).normalized();
}

BufferCanvas::Look BufferCanvas::look() const {
    return {m_fits, toShown(m_focus), m_placement.zoom, toShown(m_placement.toPicture(QRectF(rect()).center()))};
}

void BufferCanvas::follow(const Look& look) {
    m_part.reset();
    m_fits = look.fits;
    if (m_fits) {
        m_focus = toShown(look.focus);
        return placeFocus();
    }
    place({QRectF(rect()).center() - toShown(look.center) * look.zoom, look.zoom});
}

void BufferCanvas::placePart() {
    if (m_content.size.isEmpty()) return;
    const double larger = std::min(width() / m_part->view[0], height() / m_part->view[1]);
    double zoom = std::clamp(m_part->factor * larger, kZooms.front(), 2 * kZooms.back());
    if (larger != 1 && zoom >= 2) zoom = std::floor(zoom);
    const QPointF center = toShown({m_part->center[0], m_part->center[1]});
    place({QRectF(rect()).center() - center * zoom, zoom});
}

void BufferCanvas::placeFocus() {
    const double zoom = fittingZoom();
    place({QRectF(rect()).center() - m_focus.center() * zoom, zoom});
}

void BufferCanvas::toggleFit() {
    const bool showsFocus = m_fits && m_focus == toShown(m_content.focus);
    fit(showsFocus);
    emit moved();
}

void BufferCanvas::place(Placement placement) {
    // Half of the view at most may be empty: the picture cannot be lost.
    const QSizeF size = QSizeF(m_content.size) * placement.zoom;
    const auto limit = [](double origin, double extent, double view) {
        return std::clamp(origin, std::min(view / 2 - extent, (view - extent) / 2),
                          std::max(view / 2, (view - extent) / 2));
    };
    placement.origin.setX(std::round(limit(placement.origin.x(), size.width(), width())));
    placement.origin.setY(std::round(limit(placement.origin.y(), size.height(), height())));
    const bool isNewZoom = placement.zoom != m_placement.zoom;
    m_placement = placement;
    if (isNewZoom) emit zoomChanged(zoom());
    update();
}

void BufferCanvas::setZoom(double zoom, QPointF anchor) {
    m_fits = false;
    m_part.reset();
    const QPointF picture = m_placement.toPicture(anchor);
    place({anchor - picture * zoom, zoom});
    emit moved();
}

QPointF BufferCanvas::anchor() const {
    if (m_content.picked) {
        const QPointF at = m_placement.toWidget(toShown(QPointF(*m_content.picked) + QPointF(0.5, 0.5)));
        if (QRectF(rect()).contains(at)) return at;
    }
    return QRectF(rect()).center();
}

void BufferCanvas::setZoom(double zoom) { setZoom(zoom, anchor()); }

void BufferCanvas::stepZoom(int steps) { setZoom(nextZoom(zoom(), steps)); }

void BufferCanvas::setContent(CanvasContent content) {
    const bool isNewSize = content.size != m_content.size;
    // What is picked and marked stays until it is told anew.
    content.picked = m_content.picked, content.hovered = m_content.hovered;
    content.pinned = m_content.pinned;
    content.region = m_content.region;
    m_content = std::move(content);
    if (isNewSize) m_part ? placePart() : fit();
    updateAll();
    if (isNewSize && !m_part) emit resized();
}

void BufferCanvas::setPicked(std::optional<QPoint> pixel) {
    if (pixel == m_content.picked) return;
    m_content.picked = pixel;
    if (pixel && !m_fits) {
        const QPointF at = m_placement.toWidget(toShown(QPointF(*pixel) + QPointF(0.5, 0.5)));
        const double margin = std::min(0.5 * m_placement.zoom + 8, 0.4 * std::min(width(), height()));
        const QRectF inner = QRectF(rect()).adjusted(margin, margin, -margin, -margin);
        const QPointF inside(std::clamp(at.x(), inner.left(), inner.right()),
                             std::clamp(at.y(), inner.top(), inner.bottom()));
        if (inside != at) place({m_placement.origin + inside - at, m_placement.zoom});
    }
    update();
}

void BufferCanvas::setEdgeView(std::optional<pipeline::EdgeView> view) {
    if (view == m_content.edgeView) return;
    m_content.edgeView = view;
    updateAll();
}

void BufferCanvas::setShowEdges(bool show) {
    if (show == m_showEdges) return;
    m_showEdges = show;
    update();
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

void BufferCanvas::drawBase(QPainter& painter, CanvasBase& base, const CanvasContent& content, QRect part) {
    if (part.isEmpty()) return;
    painter.setClipRect(part);
    base.draw(painter, content, {m_placement, size(), devicePixelRatio(), m_showEdges, m_flipped});
    painter.setClipping(false);
}

void BufferCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const int border = m_other ? m_wipe.border(width()) : width();
    drawBase(painter, m_base, m_content, {0, 0, border, height()});
    if (m_other) drawBase(painter, m_otherBase, *m_other, {border, 0, width() - border, height()});
    static const auto kNoShapes = std::make_shared<const ShapePicture>();
    CanvasContent marks;  // without the images
    marks.size = m_content.size;
    marks.picked = m_content.picked, marks.hovered = m_content.hovered;
    marks.marked = m_content.marked, marks.pinned = m_content.pinned, marks.region = m_content.region;
    if (m_content.shapes) marks.shapes = kNoShapes;
    paintMarks(painter, painted(marks), m_placement, rect());
    if (m_flipped && !m_content.size.isEmpty()) paintOrigin(painter, m_placement, m_content.size);
    paintWipe(painter, m_wipe, rect());
}

void BufferCanvas::resizeEvent(QResizeEvent*) {
    if (m_fits) placeFocus();
    if (m_part) placePart();
    emit sizeChanged();
}

}  // namespace app
