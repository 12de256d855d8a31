#include "app/canvas/thumbnail.h"

#include <algorithm>

#include "app/canvas/buffer_image.h"
#include "app/canvas/shape_painter.h"

namespace app {

using pipeline::AnyBuffer;
using pipeline::BufferInfo;
using pipeline::Domain;

namespace {

QImage shapesImage(const pipeline::Frame& frame, const AnyBuffer& buffer, const BufferLook& look, const QRectF& focus,
                   QSize size, double pixelRatio) {
    QImage image((QSizeF(size) * pixelRatio).toSize(), QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(pixelRatio);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    const ShapePicture shapes = shapePicture(frame, buffer, look, true);
    const double zoom = size.width() / focus.width();
    paintShapes(painter, shapes, -focus.topLeft() * zoom, zoom, QRect(QPoint(), size));
    return image;
}

// Few samples a pixel, not all there are: a thumbnail must not cost what its view costs.
QImage sampledImage(const AnyBuffer& buffer, const BufferLook& look, const QRectF& focus, QSize size,
                    const std::optional<AnyBuffer>& polygonId) {
    const BufferInfo& info = *buffer.info;
    const QSize sampled = size.width() < focus.width() ? 2 * size : size;
    const double step = focus.width() / sampled.width();
    const auto at = [](double place, std::size_t count) {
        return std::min(std::size_t(std::max(0.0, place)), count - 1);
    };
    const bool isPicture = isColorPicture(info, lessons::ShownChannel::All),
               onPixels = info.domain == Domain::Pixel && polygonId;
    QImage image(sampled, QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < sampled.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        const std::size_t row = at(focus.top() + (y + 0.5) * step, buffer.rows());
        for (int x = 0; x < sampled.width(); ++x) {
            const std::size_t column = at(focus.left() + (x + 0.5) * step, buffer.columns());
            const bool drawn = isPicture || (onPixels ? polygonId->value(column, row) >= 0
                                                      : buffer.value(column, row) != info.neutral);
            const pipeline::Color8 c = elementColor(buffer, column, row, look.range);
            line[x] = drawn ? qRgb(c.r, c.g, c.b) : 0;
        }
    }
    return image.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

}  // namespace

QImage thumbnail(const pipeline::Frame& frame, const AnyBuffer& buffer, QSize size,
                 const std::optional<AnyBuffer>& polygonId, double pixelRatio) {
    const BufferInfo& info = *buffer.info;
    const pipeline::Settings& settings = frame.scene().settings;
    constexpr auto kAll = lessons::ShownChannel::All;
    const BufferLook look{kAll, fittingRange(buffer, kAll, channelStatistics(buffer, kAll), settings.depthFormat)};
    const bool onPicture = info.domain != Domain::Texel;
    const QSize whole =
        onPicture ? QSize(settings.width, settings.height) : QSize(int(buffer.columns()), int(buffer.rows()));
    const QRectF all(QPointF(0, 0), QSizeF(whole));
    QRectF focus = onPicture ? focusOn(boundsOf(frame, true), whole) & all : all;
    if (focus.isEmpty()) focus = all;
    const QSize fitted = focus.size().scaled(size, Qt::KeepAspectRatio).toSize().expandedTo({1, 1});
    if (standsOnShapes(info)) return shapesImage(frame, buffer, look, focus, fitted, pixelRatio);
    QImage image = sampledImage(buffer, look, focus, (QSizeF(fitted) * pixelRatio).toSize(), polygonId);
    image.setDevicePixelRatio(pixelRatio);
    return image;
}

}  // namespace app
