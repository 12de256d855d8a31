#include "app/canvas/state_picture.h"

#include <algorithm>
#include <cmath>

#include "app/canvas/canvas_flip.h"
#include "app/canvas/condition_bar.h"
#include "app/canvas/overlays.h"
#include "app/canvas/projected_scene.h"
#include "app/canvas/shadow_overlay.h"
#include "app/look/theme.h"
#include "lessons/derived_buffer.h"
#include "pipeline/plan/needs.h"
#include "pipeline/run/runner.h"
#include "pipeline/steps/steps.h"

namespace app {
namespace {

OverlaySet overlaysOf(const lessons::BufferShown& view) {
    OverlaySet set;
    for (const OverlayInfo& overlay : overlayTable())
        if (std::ranges::find(view.overlays, keyOf(overlay.id)) != view.overlays.end()) set.set(index(overlay.id));
    return set;
}

lessons::DerivedRecipe recipeOf(const lessons::WindowState& state, const pipeline::Scene& scene) {
    lessons::DerivedRecipe recipe{.text = state.condition};
    if (const auto mix = pipeline::parseMix(state.mix, scene.lights.size())) recipe.mix = *mix;
    return recipe;
}

// What a view shows that no frame holds: its buffer, and what is laid over it.
std::vector<pipeline::BufferName> derivedIn(const lessons::BufferShown& view) {
    std::vector<pipeline::BufferName> names;
    if (const auto name = pipeline::findDerived(view.buffer)) names.push_back(*name);
    for (const std::string& overlay : view.overlays)
        if (const auto name = pipeline::findDerived(overlay)) names.push_back(*name);
    return names;
}

// Where derived buffers of a frame come from.
struct Maker {
    const pipeline::Frame& frame;
    lessons::DerivedRecipe recipe;
    const PictureLook& look;
    const std::stop_token& stop;

    std::optional<lessons::DerivedBuffer> operator()(const pipeline::BufferName& name) const {
        if (look.known) {
            const lessons::DerivedBuffer* known = look.known(name);
            return known ? std::optional(*known) : std::nullopt;
        }
        if (!buffersFor(name, recipe, frame.scene())) return {};
        auto derived = derive(name, recipe, frame, {.stop = stop});
        return derived ? std::optional(std::move(derived).value()) : std::nullopt;
    }
};

// The buffer of a view, whoever holds it.
std::optional<ShownBuffer> shownIn(const Maker& make, const pipeline::BufferName& name,
                                   const lessons::BufferShown& view) {
    const auto range =
        view.range ? std::optional(pipeline::PaletteRange{(*view.range)[0], (*view.range)[1]}) : std::nullopt;
    const bool isMixed = name.id == pipeline::BufferId::Color && !pipeline::isPlain(make.recipe.mix);
    if (!pipeline::isDerived(name.id) && !isMixed) return showBuffer(make.frame, name, view.channel, range);
    const auto derived = make(isMixed ? pipeline::BufferName{pipeline::BufferId::Mix} : name);
    if (!derived) return {};
    const auto polygons = polygonsUnder(make.frame, *derived->buffer.info);
    ShownBuffer shown = showBuffer(make.frame, derived->buffer, drawnElements(derived->buffer, polygons, view.channel),
                                   view.channel, range, make.stop);
    if (derived->verdicts) shown.content.overlays.push_back(verdictPicture(*derived->verdicts, 0));
    return shown;
}

void layOver(const Maker& make, const lessons::BufferShown& view, CanvasContent& content) {
    for (const std::string& overlay : view.overlays) {
        const auto name = pipeline::findDerived(overlay);
        const auto derived = name ? make(*name) : std::nullopt;
        if (!derived) continue;
        if (derived->verdicts) content.overlays.push_back(verdictPicture(*derived->verdicts, kVerdictAlpha));
        if (derived->mask && overlay != view.buffer) content.overlays.push_back(veilOf(*derived->mask));
    }
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

// How much larger than on the screen, where the view fits its picture into a usual height. What is drawn over pixels of
// a certain size is that of the view, and lines and letters grow with it.
double growthOf(const lessons::BufferShown& view, const PictureLook& look) {
    constexpr double kUsualHeight = 600;
    if (!view.zoom) return look.growth > 0 ? look.growth : look.size.height() / kUsualHeight;
    return std::min(look.size.width() / view.zoom->view[0], look.size.height() / view.zoom->view[1]);
}

// content: as it is painted.
Placement placementOf(const CanvasContent& content, const lessons::BufferShown& view, const PictureLook& look) {
    const QSize size = look.size;
    const QPointF middle(size.width() / 2.0, size.height() / 2.0);
    if (view.zoom) {
        const double zoom = view.zoom->factor * growthOf(view, look);
        QPointF center(view.zoom->center[0], view.zoom->center[1]);
        if (view.flipped) center = upsideDown(center, content.size.height());
        return {middle - center * zoom, zoom};
    }
    const QRectF focus = content.focus.isEmpty() ? QRectF(QPointF(0, 0), QSizeF(content.size)) : content.focus;
    double zoom = std::min(size.width() / focus.width(), size.height() / focus.height());
    if (zoom >= 2) zoom = std::floor(zoom);
    return {middle - focus.center() * zoom, zoom};
}

CanvasContent turnedFor(CanvasContent content, const lessons::BufferShown& view, const PictureLook& look) {
    content.hasGround = !look.transparent;
    return view.flipped ? upsideDown(content) : content;
}

// What a view marks in its picture.
CanvasContent marksOf(const pipeline::Frame& frame, const lessons::WindowState& state, const lessons::BufferShown& view,
                      const CanvasContent& content) {
    CanvasContent marks;
    marks.size = content.size;
    const QRect whole({0, 0}, content.size);
    if (state.pixel) marks.picked = QPoint((*state.pixel)[0], (*state.pixel)[1]);
    for (const auto& [number, pixel] : state.pins)
        if (const QPoint at(pixel[0], pixel[1]); whole.contains(at)) marks.pinned.emplace_back(number, at);
    if (state.selected) marks.marked = outlinesOf(frame, *state.selected);
    if (view.region && !content.shapes) {
        const auto& [left, top, right, bottom] = *view.region;
        if (const QRect part = QRect(QPoint(left, top), QPoint(right, bottom)) & whole; !part.isEmpty())
            marks.region = part;
    }
    return marks;
}

// As on the screen, larger.
QImage painted(const CanvasPictures& pictures, const lessons::BufferShown& view, const PictureLook& look,
               const CanvasContent& marks, bool showsEdges, const std::stop_token& stop) {
    const CanvasContent a = turnedFor(pictures.a, view, look);
    QImage image(look.size, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    const double growth = growthOf(view, look);
    Placement placement = placementOf(a, view, look);
    placement.origin /= growth, placement.zoom /= growth;
    const QRect visible = QRectF(QPointF(0, 0), QSizeF(look.size) / growth).toAlignedRect();
    painter.scale(growth, growth);
    const int border = pictures.b ? pictures.wipe.border(visible.width()) : visible.width();
    const auto paint = [&](const CanvasContent& content, QRect part) {
        if (part.isEmpty()) return;
        painter.setClipRect(part);
        paintCanvas(painter, content, placement, visible, showsEdges, stop);
        painter.setClipping(false);
    };
    paint(a, {0, 0, border, visible.height()});
    if (pictures.b) paint(turnedFor(*pictures.b, view, look), {border, 0, visible.width() - border, visible.height()});
    paintMarks(painter, view.flipped ? upsideDown(marks) : marks, placement, visible);
    paintWipe(painter, pictures.wipe, visible);
    return stop.stop_requested() ? QImage() : image;
}

}  // namespace

pipeline::FramePtr frameOf(const lessons::WindowState& state, std::shared_ptr<const pipeline::Scene> scene,
                           std::stop_token stop) {
    pipeline::FrameRequest request{
        .wanted = pipeline::setOf({pipeline::BufferId::Color, pipeline::BufferId::PolygonId}), .stop = stop};
    for (const lessons::BufferShown& view : state.views) {
        // As in the window, showing a buffer does not compute what the scene has no use for.
        if (const auto name = pipeline::findBuffer(view.buffer); name && whyUseless(*scene, name->id).empty())
            request.wanted.set(index(name->id));
        for (const pipeline::BufferName& name : derivedIn(view))
            if (const auto needed = buffersFor(name, recipeOf(state, *scene), *scene)) request.wanted |= *needed;
        if (const auto name = pipeline::findAnyBuffer(view.buffer))
            request.wanted |= buffersOf(overlaysOf(view), name->id);
    }
    pipeline::FramePtr frame = runFrame(std::move(scene), request, nullptr);
    if (!frame || !state.place) return frame;
    const pipeline::Steps steps(frame);
    return steps.frameAt(steps.momentOf(*state.place), 0, stop);
}

std::optional<ShownBuffer> shownOf(const pipeline::Frame& frame, const lessons::WindowState& state,
                                   const lessons::BufferShown& view, const PictureLook& look,
                                   const std::stop_token& stop) {
    const auto name = pipeline::findAnyBuffer(view.buffer);
    if (!name) return {};
    const Maker make{frame, recipeOf(state, frame.scene()), look, stop};
    auto shown = shownIn(make, *name, view);
    if (!shown) return {};
    addOverlays(frame, overlaysOf(view), *shown, stop);
    if (whyNoOverlays(bufferInfo(name->id)).isEmpty()) layOver(make, view, shown->content);
    CanvasContent& content = shown->content;
    if (look.transparent && !content.image.isNull() && isColorPicture(bufferInfo(name->id), view.channel))
        clearBackground(frame, content.image);
    return stop.stop_requested() ? std::nullopt : std::move(shown);
}

QImage pictureOf(const pipeline::Frame& frame, const lessons::WindowState& state, const lessons::BufferShown& view,
                 const PictureLook& look, const std::stop_token& stop) {
    const auto name = pipeline::findAnyBuffer(view.buffer);
    if (!name) return {};
    std::optional<CanvasPictures> alone;
    if (!look.compared) {
        const auto shown = shownOf(frame, state, view, look, stop);
        if (!shown) return {};
        alone = CanvasPictures{shown->content, {}, {}};
    }
    const CanvasPictures& pictures = look.compared ? *look.compared : *alone;
    const bool onPixels = bufferInfo(name->id).domain != pipeline::Domain::Texel;
    CanvasContent marks;
    if (look.marks && onPixels) marks = marksOf(frame, state, view, pictures.a);
    return painted(pictures, view, look, marks, overlaysOf(view)[index(OverlayId::Edges)], stop);
}

}  // namespace app
