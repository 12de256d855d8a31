#include "app/canvas/canvas_placing.h"

#include <QWidget>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/canvas/canvas_flip.h"

namespace app {

namespace {

constexpr std::array kZooms{0.1, 0.125, 0.2,  0.25, 1.0 / 3, 0.5, 2.0 / 3, 1.0,  1.5,  2.0,  3.0,  4.0,  5.0, 6.0,
                            8.0, 10.0,  12.0, 16.,  20.,     24., 32.,     40.0, 48.0, 56.0, 72.0, 96.0, 128.};

QRectF shownBy(const CanvasPlacing& placing, QRectF picture) {
    return QRectF(placing.toShown(picture.topLeft()), placing.toShown(picture.bottomRight())).normalized();
}

QPointF middleOf(QPoint pixel) { return QPointF(pixel) + QPointF(0.5, 0.5); }

}  // namespace

QPointF CanvasPlacing::toShown(QPointF picture) const {
    return m_flipped ? upsideDown(picture, m_picture.height()) : picture;
}

void CanvasPlacing::setPicture(QSize size, const QRectF& focus) {
    const bool isNewSize = size != m_picture;
    m_picture = size;
    m_worthIt = focus;
    if (!isNewSize) return;
    m_part ? placePart() : fit();
    if (!m_part) emit resized();
}

void CanvasPlacing::followSize() {
    if (m_fits) placeFocus();
    if (m_part) placePart();
}

void CanvasPlacing::setPicked(std::optional<QPoint> pixel) {
    m_picked = pixel;
    if (!pixel || m_fits) return;
    const QPointF at = m_placement.toWidget(toShown(middleOf(*pixel)));
    const double margin = std::min(0.5 * m_placement.zoom + 8, 0.4 * std::min(m_view.width(), m_view.height()));
    const QRectF inner = QRectF(m_view.rect()).adjusted(margin, margin, -margin, -margin);
    const QPointF inside(std::clamp(at.x(), inner.left(), inner.right()),
                         std::clamp(at.y(), inner.top(), inner.bottom()));
    if (inside != at) place({m_placement.origin + inside - at, m_placement.zoom});
}

void CanvasPlacing::setFlipped(bool flipped) {
    if (flipped == m_flipped) return;
    m_flipped = flipped;
    m_part.reset();
    // What was in the middle of the view stays there.
    const QPointF middle = m_placement.toPicture(QRectF(m_view.rect()).center());
    m_focus.moveTop(m_picture.height() - m_focus.bottom());
    place({QRectF(m_view.rect()).center() - upsideDown(middle, m_picture.height()) * zoom(), zoom()});
}

double CanvasPlacing::nextZoom(double zoom, int steps) {
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

void CanvasPlacing::fit(bool whole) {
    m_part.reset();
    m_fits = true;
    const QRectF all(QPointF(0, 0), QSizeF(m_picture));
    m_focus = whole || m_worthIt.isEmpty() ? all : shownBy(*this, m_worthIt);
    placeFocus();
}

void CanvasPlacing::toggleFit() {
    const bool showsFocus = m_fits && m_focus == shownBy(*this, m_worthIt);
    fit(showsFocus);
    emit moved();
}

std::optional<lessons::BufferShown::Zoom> CanvasPlacing::part() const {
    if (m_part) return m_part;
    if (m_fits || m_picture.isEmpty()) return {};
    const QPointF center = toShown(m_placement.toPicture(QRectF(m_view.rect()).center()));
    return lessons::BufferShown::Zoom{
        m_placement.zoom, {center.x(), center.y()}, {double(m_view.width()), double(m_view.height())}};
}

void CanvasPlacing::showPart(const std::optional<lessons::BufferShown::Zoom>& part) {
    if (!part) return fit();
    m_part = part;
    m_fits = false;
    placePart();
}

CanvasPlacing::Look CanvasPlacing::look() const {
    return {m_fits, shownBy(*this, m_focus), m_placement.zoom,
            toShown(m_placement.toPicture(QRectF(m_view.rect()).center()))};
}

void CanvasPlacing::follow(const Look& look) {
    m_part.reset();
    m_fits = look.fits;
    if (m_fits) {
        m_focus = shownBy(*this, look.focus);
        return placeFocus();
    }
    place({QRectF(m_view.rect()).center() - toShown(look.center) * look.zoom, look.zoom});
}

void CanvasPlacing::placePart() {
    if (m_picture.isEmpty()) return;
    const double larger = std::min(m_view.width() / m_part->view[0], m_view.height() / m_part->view[1]);
    double zoom = std::clamp(m_part->factor * larger, kZooms.front(), 2 * kZooms.back());
    if (larger != 1 && zoom >= 2) zoom = std::floor(zoom);
    const QPointF center = toShown({m_part->center[0], m_part->center[1]});
    place({QRectF(m_view.rect()).center() - center * zoom, zoom});
}

void CanvasPlacing::placeFocus() {
    double zoom = 1;
    if (!m_focus.isEmpty()) {
        const double fitting = std::min(m_view.width() / m_focus.width(), m_view.height() / m_focus.height());
        zoom = fitting >= 2 ? std::floor(fitting) : std::max(fitting, 0.01);
    }
    // No empty strip where there is more of the picture on the other side: the view holds all of the focus either way.
    const auto filled = [](double origin, double extent, double view) {
        return extent < view ? origin : std::clamp(origin, view - extent, 0.0);
    };
    const QPointF origin = QRectF(m_view.rect()).center() - m_focus.center() * zoom;
    const QSizeF size = QSizeF(m_picture) * zoom;
    place(
        {{filled(origin.x(), size.width(), m_view.width()), filled(origin.y(), size.height(), m_view.height())}, zoom});
}

void CanvasPlacing::place(Placement placement) {
    // Half of the view at most may be empty: the picture cannot be lost.
    const QSizeF size = QSizeF(m_picture) * placement.zoom;
    const auto limit = [](double origin, double extent, double view) {
        return std::clamp(origin, std::min(view / 2 - extent, (view - extent) / 2),
                          std::max(view / 2, (view - extent) / 2));
    };
    placement.origin.setX(std::round(limit(placement.origin.x(), size.width(), m_view.width())));
    placement.origin.setY(std::round(limit(placement.origin.y(), size.height(), m_view.height())));
    const bool isNewZoom = placement.zoom != m_placement.zoom;
    m_placement = placement;
    if (isNewZoom) emit zoomChanged(zoom());
    emit changed();
}

void CanvasPlacing::setZoom(double zoom, QPointF anchor) {
    m_fits = false;
    m_part.reset();
    const QPointF picture = m_placement.toPicture(anchor);
    place({anchor - picture * zoom, zoom});
    emit moved();
}

void CanvasPlacing::setZoom(double zoom) {
    const QPointF middle = QRectF(m_view.rect()).center();
    const QPointF at = m_picked ? m_placement.toWidget(toShown(middleOf(*m_picked))) : middle;
    setZoom(zoom, QRectF(m_view.rect()).contains(at) ? at : middle);
}

void CanvasPlacing::drag(QPointF origin) {
    m_fits = false;
    m_part.reset();
    place({origin, m_placement.zoom});
    emit moved();
}

// As it is placed, and then turned: a pixel's upper border is its own, also of one that stands upside down.
QPoint CanvasPlacing::pixelUnder(QPointF view) const {
    const QPointF p = m_placement.toPicture(view);
    const QPoint pixel(int(std::floor(p.x())), int(std::floor(p.y())));
    return m_flipped ? upsideDown(pixel, m_picture.height()) : pixel;
}

std::optional<QPoint> CanvasPlacing::pixelAt(QPointF view) const {
    const QPoint pixel = pixelUnder(view);
    if (!QRect(QPoint(0, 0), m_picture).contains(pixel)) return {};
    return pixel;
}

QRectF CanvasPlacing::focusInView() const {
    const QRectF focus = shownBy(*this, m_worthIt);
    return QRectF(m_placement.toWidget(focus.topLeft()), focus.size() * zoom());
}

QRect CanvasPlacing::visiblePart() const {
    const QPointF a = toShown(m_placement.toPicture({0, 0}));
    const QPointF b = toShown(m_placement.toPicture(QPointF(m_view.width(), m_view.height())));
    return QRectF(a, b).normalized().toAlignedRect() & QRect(QPoint(0, 0), m_picture);
}

}  // namespace app
