#include "app/export/slide_picture.h"

#include <QPainter>

#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/canvas/state_picture.h"
#include "app/compare/buffer_compare.h"
#include "app/frames/derived_buffers.h"
#include "app/frames/mix_model.h"
#include "app/look/hidden_in_window.h"
#include "app/look/text.h"
#include "app/look/theme.h"
#include "app/view3d/view3d_panel.h"
#include "app/views/view_area.h"
#include "pipeline/export/buffers/png_file.h"
#include "pipeline/formats/png_scene.h"
#include "pipeline/formats/toml/toml_writer.h"

namespace app {
namespace {

using pipeline::Error;
using pipeline::Result;
using What = SlideRequest::What;

int captionHeight(const SlideRequest& request) { return request.caption ? request.size.height() / 18 : 0; }

struct PicturePart {
    What what = What::Buffer;
    QRect place;
};
std::vector<PicturePart> partsOf(const SlideRequest& request) {
    const QSize room(request.size.width(), request.size.height() - captionHeight(request));
    if (request.what != What::Beside) return {{request.what, QRect(QPoint(0, 0), room)}};
    const int gap = room.width() / 60, half = (room.width() - gap) / 2;
    return {{What::Buffer, QRect(0, 0, half, room.height())},
            {What::Space, QRect(room.width() - half, 0, half, room.height())}};
}

Result<QImage> bufferPicture(const SlideContent& content, QSize size, const std::stop_token& stop) {
    const lessons::WindowState& state = content.state;
    const std::size_t view = content.request.view;
    if (view >= state.views.size()) return Error{{}, "there is no such buffer view any more", {}};
    const auto known = [&](const pipeline::BufferName& name) {
        const auto found = content.derived.find(name.text());
        return found == content.derived.end() ? nullptr : &found->second;
    };
    const PictureLook look{size, content.request.transparent, content.request.marks, known,
                           content.compared ? &*content.compared : nullptr};
    const QImage image = pictureOf(*content.frame, state, state.views[view], look, stop);
    if (image.isNull()) return Error{{}, "the buffer " + state.views[view].buffer + " is not there", {}};
    return image;
}

void writeCaption(QPainter& painter, const QRect& box, const SlideContent& content) {
    const Theme& theme = Theme::current();
    QFont strong = theme.text(13, 600), plain = theme.text(13);
    for (QFont* font : {&strong, &plain}) font->setPixelSize(std::max(8, int(0.5 * box.height())));
    const int left = box.left() + box.height() / 4;
    painter.setFont(strong);
    painter.setPen(theme.colors().accent);
    painter.drawText(box.adjusted(left, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, content.stage);
    const int from = left + QFontMetrics(strong).horizontalAdvance(content.stage) + box.height() / 3;
    painter.setFont(plain);
    painter.setPen(theme.colors().text);
    painter.drawText(QRect(from, box.top(), box.right() - from, box.height()), Qt::AlignVCenter | Qt::AlignLeft,
                     QFontMetrics(plain).elidedText(content.words, Qt::ElideRight, box.right() - from));
}

}  // namespace

Result<SlideContent> slideContent(const Document& document, const ViewArea& views, const SlideRequest& request) {
    if (!document.frames().shown()) return Error{{}, "the first frame is not there yet", {}};
    SlideContent content;
    content.request = request;
    content.frame = document.frames().shown();
    lessons::WindowState& state = content.state;
    views.fill(state);
    if (const auto pixel = document.pointing().pixel()) state.pixel = {pixel->x, pixel->y};
    state.condition = document.derived().text().toStdString();
    state.mix = mixText(document.mixer().mix());
    for (const pipeline::BufferName& name : pipeline::allDerived(document.frames().shown()->scene().lights.size()))
        if (const lessons::DerivedBuffer* made = document.derived().made(name))
            content.derived.emplace(name.text(), *made);
    const std::vector<BufferView*> shown = views.shownBuffers();
    if (request.view < shown.size() && shown[request.view]->compare().showsOther())
        content.compared = shown[request.view]->canvas()->pictures();
    for (const auto& [what, place] : partsOf(request)) {
        if (what != What::Space) continue;
        if (isHiddenInWindow(views.view3d())) return Error{{}, "no 3D view is on show", {}};
        const auto space = views.view3d().view().picture(place.size(), request.transparent);
        if (!space) return space.errors();
        content.space = *space;
    }
    const auto& stage = stageInfo(document.stage());
    content.stage = toQString(stage.label);
    content.words = document.stepper().isInside() ? document.stepper().words() : toQString(stage.summary);
    return content;
}

Result<QImage> drawSlide(const SlideContent& content, const BackgroundJob::Control& control) {
    const SlideRequest& request = content.request;
    QImage image(request.size, QImage::Format_ARGB32_Premultiplied);
    image.fill(request.transparent ? QColor(Qt::transparent) : Theme::current().colors().view);
    QPainter painter(&image);
    const std::vector<PicturePart> parts = partsOf(request);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto progress = [&](double share) {
            if (control.progress) control.progress((double(i) + share) / double(parts.size()));
            return !control.stop.stop_requested();
        };
        const auto& [what, place] = parts[i];
        const auto part = what == What::Space ? renderBeside(*content.space, progress)
                                              : bufferPicture(content, place.size(), control.stop);
        if (!part) return part;
        painter.drawImage(place, *part);
        progress(1);
    }
    const int caption = captionHeight(request);
    const QRect below(0, request.size.height() - caption, request.size.width(), caption);
    if (caption > 0) writeCaption(painter, below, content);
    return image;
}

Result<QImage> slidePicture(const Document& document, const ViewArea& views, const SlideRequest& request) {
    const auto content = slideContent(document, views, request);
    return content ? drawSlide(*content, {}) : content.errors();
}

std::string slidePng(const QImage& image, const pipeline::Scene& scene, const lessons::WindowState& state) {
    std::vector<pipeline::PngText> texts;
    const auto text = toTomlScene(scene);
    if (text && text->size() <= pipeline::kMaxCarriedScene) {
        lessons::WindowState carried = state;  // the scene stands beside it
        carried.scene.clear(), carried.set.clear(), carried.sceneText.clear();
        texts = {{pipeline::kSceneChunk, *text}, {pipeline::kStateChunk, toToml(carried)}};
    }
    const QImage straight = image.convertToFormat(QImage::Format_RGBA8888);
    std::vector<std::uint8_t> bytes;
    bytes.reserve(std::size_t(straight.width()) * std::size_t(straight.height()) * 4);
    for (int y = 0; y < straight.height(); ++y)
        bytes.insert(bytes.end(), straight.constScanLine(y), straight.constScanLine(y) + 4 * straight.width());
    return pipeline::pngOf(bytes, {straight.width(), straight.height()}, texts);
}

}  // namespace app
