#include "app/desktop/slide_picture.h"

#include <QPainter>

#include "app/core/derived_buffers.h"
#include "app/core/mix_model.h"
#include "app/core/text.h"
#include "app/core/theme.h"
#include "app/desktop/view_area.h"
#include "app/panels/state_picture.h"
#include "app/view3d/view3d_panel.h"
#include "pipeline/export/png_file.h"
#include "pipeline/formats/png_scene.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/formats/toml_writer.h"

namespace app {
namespace {

using pipeline::Error;
using pipeline::Result;
using What = SlideRequest::What;

Result<QImage> bufferPicture(const Document& document, const WindowState& state, std::size_t view, QSize size,
                             const SlideRequest& request) {
    if (view >= state.views.size()) return Error{{}, "there is no second buffer view", {}};
    const auto known = [&](const pipeline::BufferName& name) { return document.derived().made(name); };
    const QImage image =
        pictureOf(*document.frame(), state, state.views[view], {size, request.transparent, request.marks, known});
    if (image.isNull()) return Error{{}, "the buffer " + state.views[view].buffer + " is not there", {}};
    return image;
}

Result<QImage> onePicture(const Document& document, ViewArea& views, const WindowState& state, What what, QSize size,
                          const SlideRequest& request) {
    switch (what) {
        case What::First: return bufferPicture(document, state, 0, size, request);
        case What::Second: return bufferPicture(document, state, 1, size, request);
        case What::Space: return views.view3d().view().picture(size, request.transparent);
        case What::Beside: break;
    }
    return Error{{}, "nothing to show", {}};
}

void writeCaption(QPainter& painter, const QRect& box, const Document& document) {
    const Theme& theme = Theme::current();
    QFont strong = theme.text(13, 600), plain = theme.text(13);
    for (QFont* font : {&strong, &plain}) font->setPixelSize(std::max(8, int(0.5 * box.height())));
    const auto& stage = stageInfo(document.stage());
    const QString label = toQString(stage.label);
    const QString words = document.stepper().isInside() ? document.stepper().words() : toQString(stage.summary);
    const int left = box.left() + box.height() / 4;
    painter.setFont(strong);
    painter.setPen(theme.colors().accent);
    painter.drawText(box.adjusted(left, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, label);
    const int from = left + QFontMetrics(strong).horizontalAdvance(label) + box.height() / 3;
    painter.setFont(plain);
    painter.setPen(theme.colors().text);
    painter.drawText(QRect(from, box.top(), box.right() - from, box.height()), Qt::AlignVCenter | Qt::AlignLeft,
                     QFontMetrics(plain).elidedText(words, Qt::ElideRight, box.right() - from));
}

}  // namespace

Result<QImage> slidePicture(const Document& document, ViewArea& views, const SlideRequest& request) {
    if (!document.frame()) return Error{{}, "the first frame is not there yet", {}};
    WindowState state;
    views.fill(state);
    if (const auto pixel = document.pixel()) state.pixel = {pixel->x, pixel->y};
    state.condition = document.derived().text().toStdString();
    state.mix = mixText(document.mixer().mix());
    QImage image(request.size, QImage::Format_ARGB32_Premultiplied);
    image.fill(request.transparent ? QColor(Qt::transparent) : Theme::current().colors().view);
    const int caption = request.caption ? request.size.height() / 18 : 0;
    const QSize room(request.size.width(), request.size.height() - caption);
    QPainter painter(&image);
    std::vector<std::pair<What, QRect>> parts{{request.what, QRect(QPoint(0, 0), room)}};
    if (request.what == What::Beside) {
        const int gap = room.width() / 60, half = (room.width() - gap) / 2;
        parts = {{What::First, QRect(0, 0, half, room.height())},
                 {What::Space, QRect(room.width() - half, 0, half, room.height())}};
    }
    for (const auto& [what, place] : parts) {
        const auto part = onePicture(document, views, state, what, place.size(), request);
        if (!part) return part;
        painter.drawImage(place, *part);
    }
    if (caption > 0) writeCaption(painter, QRect(0, room.height(), room.width(), caption), document);
    return image;
}

std::string slidePng(const QImage& image, const Document& document, const WindowState& state) {
    std::vector<pipeline::PngText> texts;
    const auto scene = toTomlScene(document.scene());
    if (scene && scene->size() <= pipeline::kMaxCarriedScene) {
        WindowState carried = state;  // the scene stands beside it
        carried.scene.clear(), carried.set.clear(), carried.sceneText.clear();
        texts = {{pipeline::kSceneChunk, *scene}, {pipeline::kStateChunk, toToml(carried)}};
    }
    const QImage straight = image.convertToFormat(QImage::Format_RGBA8888);
    std::vector<std::uint8_t> bytes;
    bytes.reserve(std::size_t(straight.width()) * std::size_t(straight.height()) * 4);
    for (int y = 0; y < straight.height(); ++y)
        bytes.insert(bytes.end(), straight.constScanLine(y), straight.constScanLine(y) + 4 * straight.width());
    return pipeline::pngOf(bytes, {straight.width(), straight.height()}, texts);
}

}  // namespace app
