#include "app/canvas/loupe.h"

#include <QPainter>

#include "app/canvas/buffer_canvas.h"
#include "app/look/theme.h"

namespace app {

namespace {

constexpr int kPixels = 9, kZoom = 12, kLoupeMargin = 8;

}  // namespace

Loupe::Loupe(BufferCanvas* canvas) : QWidget(canvas), m_canvas(canvas) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    resize(kPixels * kZoom + 2, kPixels * kZoom + 2);
    hide();
    connect(m_canvas, &BufferCanvas::seenChanged, this, [this] {
        m_base.change();
        update();
    });
    connect(&m_base, &CanvasBase::painted, this, qOverload<>(&Loupe::update));
}

void Loupe::follow() {
    const int right = m_canvas->width() - width() - kLoupeMargin;
    const QPoint cursor = m_canvas->mapFromGlobal(QCursor::pos());
    const auto isNear = [&](int x) {
        return QRect(x, kLoupeMargin, width(), height()).adjusted(-24, -24, 24, 24).contains(cursor);
    };
    if (isNear(m_onLeft ? kLoupeMargin : right)) m_onLeft = !m_onLeft;
    move(m_onLeft ? kLoupeMargin : right, kLoupeMargin);
    update();
}

void Loupe::paintEvent(QPaintEvent*) {
    const CanvasContent& content = m_canvas->content();
    const std::optional<QPoint> centre = content.hovered ? content.hovered : content.picked;
    QPainter painter(this);
    const QRect inner = rect().adjusted(1, 1, -1, -1);
    if (centre) {
        const QPointF middle = m_canvas->placing().toShown(QPointF(*centre) + QPointF(0.5, 0.5));
        const Placement placement{QPointF(inner.center()) + QPointF(0.5, 0.5) - middle * kZoom, kZoom};
        painter.setClipRect(inner);
        m_base.draw(painter, m_canvas->seen(),
                    {placement, size(), devicePixelRatio(), true, m_canvas->placing().isFlipped()});
        painter.setClipping(false);
        const QRectF frame(placement.toWidget(middle - QPointF(0.5, 0.5)), QSizeF(kZoom, kZoom));
        painter.setPen(QPen(Qt::black, 4));
        painter.drawRect(frame);
        painter.setPen(QPen(Qt::white, 2));
        painter.drawRect(frame);
    }
    painter.setPen(Theme::current().colors().outline);
    painter.setBrush(centre ? QBrush(Qt::NoBrush) : QBrush(Theme::current().colors().surface));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

}  // namespace app
