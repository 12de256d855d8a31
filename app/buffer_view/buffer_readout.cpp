#include "app/buffer_view/buffer_readout.h"

#include <QLabel>
#include <algorithm>
#include <cmath>

#include "app/buffer_view/buffer_holds.h"
#include "app/buffer_view/buffer_step.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/compare/buffer_compare.h"
#include "app/frames/copied_value.h"
#include "app/frames/shadow_texel.h"
#include "app/look/theme.h"

namespace app {

namespace {

std::optional<QPoint> toPoint(std::optional<glm::ivec2> p) {
    if (!p) return {};
    return QPoint(p->x, p->y);
}

std::optional<glm::ivec2> toVector(std::optional<QPoint> p) {
    if (!p) return {};
    return glm::ivec2(p->x(), p->y());
}

}  // namespace

PixelReadout::PixelReadout(BufferView& view, const BufferCompare& compare)
    : BufferFeature(view), m_compare(compare), m_label(labelOver(view.canvas())) {
    Document& document = view.document();
    connect(&view.canvas()->input(), &CanvasInput::picked, this, [this, &document](QPoint pixel) {
        if (this->view().isOfPixels()) document.pointing().pick(toVector(pixel));
    });
    connect(&view.canvas()->input(), &CanvasInput::nudged, this, &PixelReadout::nudge);
    connect(&view.canvas()->input(), &CanvasInput::hovered, this, &PixelReadout::hover);
    connect(&view.canvas()->placing(), &CanvasPlacing::changed, this, [this] { this->view().place(); });
    const auto follow = [this] {
        show();
        this->view().place();
    };
    connect(&document.pointing(), &Pointing::pixelChanged, this, follow);
    connect(&document.pointing(), &Pointing::hoverChanged, this, follow);
    connect(&document.stepper(), &Stepper::changed, this, follow);
}

void PixelReadout::hover(std::optional<QPoint> pixel) {
    m_localHover = pixel;
    if (view().isOfPixels()) view().document().pointing().hover(toVector(pixel));
    show();
    view().place();
}

void PixelReadout::nudge(QPoint by) {
    Document& document = view().document();
    if (!view().isOfPixels() || !document.hasScene()) return;
    const pipeline::Settings& settings = document.scene().settings;
    const auto from = document.pointing().pixel().value_or(glm::ivec2(settings.width, settings.height) / 2);
    document.pointing().pick(from + glm::ivec2(by.x(), by.y()));
}

void PixelReadout::show() {
    const Document& document = view().document();
    BufferCanvas& canvas = *view().canvas();
    const bool isOfPixels = view().isOfPixels();
    canvas.setPicked(isOfPixels ? toPoint(document.pointing().pixel()) : texelOf(document.pointing().pixel()));
    canvas.setHovered(isOfPixels     ? toPoint(document.pointing().hovered())
                      : m_localHover ? m_localHover
                                     : texelOf(document.pointing().hovered()));
    const std::optional<QPoint> pixel = saidPixel();
    // Where a picture is held, the words stand beside the hand.
    const bool isSaid = pixel && view().shown() && (!view().features().holds->isHeld() || canvas.content().hovered);
    m_label->setText(isSaid ? at(*pixel) : QString());
    m_label->setVisible(!m_label->text().isEmpty());
    if (!view().shown()) return;
    // The canvas has the focus: a screen reader reads the value first, and again with every nudge.
    const QString& description = view().shown()->counts->description;
    canvas.setAccessibleDescription(m_label->text().isEmpty() ? description
                                                              : m_label->text() + QStringLiteral(". ") + description);
}

void PixelReadout::place(CanvasRoom& room) {
    const Theme& theme = Theme::current();
    m_label->setFont(theme.mono(12));
    if (m_label->sizeHint().width() > room.size.width() - 2 * CanvasRoom::kMargin)  // A, B and their difference
        m_label->setText(m_label->text().replace("   ", "\n"));
    m_label->adjustSize();
    // Above "0, 0", where the canvas marks it.
    const int origin = view().canvas()->placing().isFlipped() ? QFontMetrics(theme.mono(12)).height() + 4 : 0;
    QRect box(QPoint(CanvasRoom::kMargin, room.bottom - m_label->height() - CanvasRoom::kMargin - origin),
              m_label->size());
    // In the lower left corner, or in the other one if what is worth looking at is there and not here.
    const QRectF focus = view().canvas()->placing().focusInView();
    const QRect other(QPoint(room.size.width() - CanvasRoom::kMargin - box.width(), box.y()), box.size());
    const QRect pixel = pixelOnCanvas();
    const auto isFree = [&](const QRect& corner) { return !focus.intersects(corner) && !corner.intersects(pixel); };
    if (!isFree(box) && isFree(other)) box = other;
    if (box.intersects(pixel)) box.moveTop(std::max(0, pixel.top() - box.height()));
    m_label->setGeometry(box);
    if (!m_label->isVisibleTo(view().canvas())) return;
    if (box.left() == CanvasRoom::kMargin) room.bottom = box.top();
    room.left = box.right();
}

std::optional<QPoint> PixelReadout::saidPixel() const {
    const CanvasContent& content = view().canvas()->content();
    if (content.hovered) return content.hovered;
    const auto step = view().isOfPixels() ? toPoint(stepPixel(view().document().stepper())) : std::nullopt;
    return step ? step : content.picked;
}

// The pixel that the label is about, with some of its neighbourhood.
QRect PixelReadout::pixelOnCanvas() const {
    const std::optional<QPoint> pixel = saidPixel();
    if (!pixel) return {};
    const CanvasPlacing& placing = view().canvas()->placing();
    const QPointF centre = placing.placement().toWidget(placing.toShown(QPointF(*pixel) + QPointF(0.5, 0.5)));
    const int reach = int(std::ceil(placing.zoom() / 2)) + CanvasRoom::kMargin;
    return QRect(centre.toPoint() - QPoint(reach, reach), QSize(2 * reach + 1, 2 * reach + 1));
}

std::optional<QPoint> PixelReadout::texelOf(std::optional<glm::ivec2> pixel) const {
    if (!pixel || !view().frame()) return {};
    return toPoint(shadowTexel(*view().frame(), std::size_t(view().buffer().light), *pixel));
}

QString PixelReadout::at(QPoint pixel) const {
    const ShownBuffer& shown = *view().shown();
    const QString place = QString("x %1 y %2").arg(pixel.x()).arg(pixel.y());
    if (!QRect(QPoint(0, 0), shown.content.size).contains(pixel)) return {};
    if (!shown.content.shapes) {
        const QString value =
            elementText(shown.buffer, std::size_t(pixel.x()), std::size_t(pixel.y()), shown.look.channel).join(' ');
        return place + " → " + (shown.hasValue(pixel) ? value : clearedText(value)) + m_compare.readout(pixel);
    }
    const int polygon = nearestPolygonAt(*shown.content.shapes, QPointF(pixel) + QPointF(0.5, 0.5));
    return polygon < 0 ? place : place + QString(" → polygon %1").arg(polygon);
}

}  // namespace app
