#include "app/panels/state_picture.h"

#include <algorithm>
#include <cmath>

#include "app/core/theme.h"
#include "app/panels/overlays.h"
#include "pipeline/run/runner.h"
#include "pipeline/steps/steps.h"

namespace app {
namespace {

OverlaySet overlaysOf(const BufferShown& view) {
    OverlaySet set;
    for (const OverlayInfo& overlay : overlayTable())
        if (std::ranges::find(view.overlays, overlay.key) != view.overlays.end()) set.set(index(overlay.id));
    return set;
}

// A picture in colours is black where nothing was drawn.
void clearBackground(const pipeline::Frame& frame, QImage& image) {
    const auto polygons = frame.buffer({pipeline::BufferId::PolygonId});
    if (!polygons || polygons->columns() != std::size_t(image.width()) ||
        polygons->rows() != std::size_t(image.height()))
        return;
    const auto ids = std::get<std::span<const std::int32_t>>(polygons->data);
    std::size_t i = 0;
    for (int y = 0; y < image.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < image.width(); ++x, ++i)
            if (ids[i] < 0) line[x] = 0;
    }
}

Placement placementOf(const CanvasContent& content, const BufferShown& view, QSize size) {
    const QPointF middle(size.width() / 2.0, size.height() / 2.0);
    if (view.zoom) {
        const double larger = std::min(size.width() / view.zoom->view[0], size.height() / view.zoom->view[1]);
        const double zoom = view.zoom->factor * larger;
        return {middle - QPointF(view.zoom->center[0], view.zoom->center[1]) * zoom, zoom};
    }
    const QRectF focus = content.focus.isEmpty() ? QRectF(QPointF(0, 0), QSizeF(content.size)) : content.focus;
    double zoom = std::min(size.width() / focus.width(), size.height() / focus.height());
    if (zoom >= 2) zoom = std::floor(zoom);
    return {middle - focus.center() * zoom, zoom};
}

}  // namespace

pipeline::FramePtr frameOf(const WindowState& state, std::shared_ptr<const pipeline::Scene> scene,
                           std::stop_token stop) {
    pipeline::FrameRequest request{
        .wanted = pipeline::setOf({pipeline::BufferId::Color, pipeline::BufferId::PolygonId}), .stop = stop};
    for (const BufferShown& view : state.views) {
        if (const auto name = pipeline::findBuffer(view.buffer)) request.wanted.set(index(name->id));
        request.wanted |= buffersOf(overlaysOf(view));
    }
    pipeline::FramePtr frame = runFrame(std::move(scene), request, nullptr);
    if (!frame || !state.place) return frame;
    const pipeline::Steps steps(frame);
    return steps.frameAt(steps.momentOf(*state.place), 0, stop);
}

QImage pictureOf(const pipeline::Frame& frame, const WindowState& state, const BufferShown& view,
                 const PictureLook& look) {
    const auto name = pipeline::findBuffer(view.buffer);
    if (!name) return {};
    const auto range =
        view.range ? std::optional(pipeline::PaletteRange{(*view.range)[0], (*view.range)[1]}) : std::nullopt;
    auto shown = showBuffer(frame, *name, view.channel, range);
    if (!shown) return {};
    const OverlaySet overlays = overlaysOf(view);
    addOverlays(frame, overlays, *shown);
    CanvasContent& content = shown->content;
    content.hasGround = !look.transparent;
    if (look.transparent && !content.image.isNull() && isColorPicture(bufferInfo(name->id), view.channel))
        clearBackground(frame, content.image);
    if (look.marks && state.pixel && bufferInfo(name->id).domain != pipeline::Domain::Texel)
        content.picked = QPoint((*state.pixel)[0], (*state.pixel)[1]);
    QImage image(look.size, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    const Placement placement = placementOf(content, view, look.size);
    paintCanvas(painter, content, placement, image.rect(), overlays[index(OverlayId::Edges)]);
    paintMarks(painter, content, placement, image.rect());
    return image;
}

}  // namespace app
