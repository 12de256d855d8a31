#include "app/desktop/cue_picture.h"

#include <QPainter>

#include "app/core/text.h"
#include "app/panels/state_picture.h"
#include "app/view3d/space_picture.h"
#include "lessons/expression/changed_frames.h"

namespace app {

namespace {

using lessons::TalkPicture;
using pipeline::Error;
using pipeline::Result;

// B of a view that is compared: nothing, after `why` was said, where it is not one of the cue's own.
QImage otherPicture(const lessons::WindowState& state, const lessons::BufferShown& view,
                    const std::shared_ptr<const pipeline::Scene>& scene, const PictureLook& look,
                    const pipeline::Stop& stop, std::string& why) {
    constexpr std::string_view kSetting = "setting ", kBuffer = "buffer ";
    const std::string& with = view.compared->with;
    if (with.starts_with(kBuffer)) {
        lessons::WindowState other = state;
        lessons::BufferShown shown = view;
        shown.buffer = with.substr(kBuffer.size());
        shown.compared.reset(), shown.range.reset();
        other.views = {shown};
        const auto frame = frameOf(other, scene, stop);
        return frame ? pictureOf(*frame, other, shown, look, stop) : QImage();
    }
    if (!with.starts_with(kSetting)) {
        why = "the comparison with " + with + " needs the window";
        return {};
    }
    const std::string change = with.substr(kSetting.size());
    auto changed = lessons::withChanges(*scene, std::span(&change, 1));
    if (!changed) {
        why = pipeline::format(changed.errors());
        return {};
    }
    const auto frame = frameOf(state, std::make_shared<const pipeline::Scene>(std::move(changed).value()), stop);
    return frame ? pictureOf(*frame, state, view, look, stop) : QImage();
}

Result<TalkPicture> bufferPicture(const lessons::WindowState& state,
                                  const std::shared_ptr<const pipeline::Scene>& scene, std::size_t number,
                                  const PictureLook& look, const pipeline::Stop& stop) {
    if (number >= state.views.size()) return Error{{}, "the cue has no such view", {}};
    const lessons::BufferShown& view = state.views[number];
    const pipeline::FramePtr frame = frameOf(state, scene, stop);
    if (!frame) return Error{{}, "stopped", {}};
    TalkPicture made;
    const std::string mode = view.compared ? view.compared->mode : "a";
    QImage picture = mode == "b" ? QImage() : pictureOf(*frame, state, view, look, stop);
    if (mode != "a") {
        const QImage other = otherPicture(state, view, scene, look, stop, made.leftOut);
        if (mode == "difference")
            made.leftOut = "the picture of the difference needs the window; A is at the left and B at the right";
        if (mode == "b") {
            picture = other.isNull() ? pictureOf(*frame, state, view, look, stop) : other;
        } else if (!other.isNull() && !picture.isNull()) {
            const double share = mode == "wipe" ? view.compared->wipe : 0.5;
            Wipe wipe;
            wipe.share = share;
            const int border = wipe.border(look.size.width());
            QPainter painter(&picture);
            painter.setCompositionMode(QPainter::CompositionMode_Source);
            painter.drawImage(QPoint(border, 0), other, QRect(border, 0, other.width() - border, other.height()));
        }
    }
    if (stop.stop_requested()) return Error{{}, "stopped", {}};
    if (picture.isNull()) {
        const auto name = pipeline::findBuffer(view.buffer);
        return Error{{}, view.buffer + ": " + (name ? frame->whyAbsent(*name) : "the scene has no such buffer"), {}};
    }
    made.png = pngBytes(picture);
    return made;
}

}  // namespace

Result<TalkPicture> drawCueView(const lessons::WindowState& state, const std::shared_ptr<const pipeline::Scene>& scene,
                                lessons::ViewLeaf view, glm::ivec2 size, const pipeline::Stop& stop) {
    static const FontSystem s_fonts;
    if (!s_fonts.ready()) return Error{{}, "no font system for the letters of the views", {}};
    const auto number = std::size_t(view.number);
    if (view.kind == lessons::ViewLeaf::Kind::Buffer)
        return bufferPicture(state, scene, number, {.size = QSize(size.x, size.y)}, stop);
    if (number >= state.spaces.size()) return Error{{}, "the cue has no such view", {}};
    const auto space = spacePicture(state, state.spaces[number], scene, size, stop);
    if (!space) return space.errors();
    const auto image = renderBeside(*space);
    if (!image) return image.errors();
    return TalkPicture{pngBytes(*image)};
}

}  // namespace app
