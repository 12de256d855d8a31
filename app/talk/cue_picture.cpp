#include "app/talk/cue_picture.h"

#include <QPainter>
#include <algorithm>

#include "app/canvas/state_picture.h"
#include "app/frames/other_source.h"
#include "app/look/text.h"
#include "app/view3d/space_picture.h"

namespace app {

namespace {

using lessons::TalkPicture;
using lessons::TalkRoom;
using pipeline::Error;
using pipeline::Result;
using SourceKind = OtherSource::Kind;

lessons::TalkLegend legendOf(const ShownBuffer& shown) {
    constexpr int kSteps = 32;
    lessons::TalkLegend legend;
    for (const LegendEntry& entry : shown.legend)
        legend.names.emplace_back(pipeline::Color8(entry.color.red(), entry.color.green(), entry.color.blue()),
                                  entry.text.toStdString());
    if (shown.scale.histogram.empty()) return legend;
    const pipeline::PaletteRange range = shown.look.range;
    const auto [low, high] = std::minmax(range.first, range.last);
    legend.low = valueText(shown.buffer, low, 8).toStdString();
    legend.high = valueText(shown.buffer, high, 8).toStdString();
    legend.unit = shown.buffer.info->unit;
    for (int i = 0; i < kSteps; ++i)
        legend.palette.push_back(
            paletteColor(shown.scale.palette, low + (high - low) * (i + 0.5) / kSteps, range.first, range.last));
    return legend;
}

// The two sides of a comparison.
struct CueSides {
    std::vector<std::string> names;  // of A and of B
    std::shared_ptr<const pipeline::Scene> scene;
    lessons::BufferShown view;  // of B
    std::string whyNoB;         // else empty
};

CueSides sidesOf(const lessons::BufferShown& view, const std::shared_ptr<const pipeline::Scene>& scene) {
    CueSides sides{{view.buffer}, nullptr, view, {}};
    const auto fail = [&](const std::string& why) {
        sides.whyNoB = "A is shown alone: " + why;
        return sides;
    };
    const auto source = sourceNamed(view.compared->with, *scene);
    if (!source) return fail(format(source.errors()));
    if (source->kind == SourceKind::Before) return fail("a page does not know the scene before the last change.");
    if (source->kind == SourceKind::File) return fail("a comparison with a file needs the window.");
    const auto a = pipeline::findAnyBuffer(view.buffer);
    const auto b = a ? otherBuffer(*source, *a, *scene) : std::nullopt;
    sides.scene = otherScene(*source, scene, nullptr);
    if (!b || !sides.scene) return fail("this scene has no such B.");
    sides.view.buffer = b->text();
    if (*b != *a) sides.view.range.reset();
    if (source->kind == SourceKind::Setting) {
        const auto named = [&](const pipeline::Scene& of) {
            return (toQString(view.buffer) + ", " + captionOf(source->setting, of)).toStdString();
        };
        sides.names = {named(*scene), named(*sides.scene)};
    } else {
        const bool isBuffer = source->kind == SourceKind::Buffer || source->kind == SourceKind::PreviousStage;
        sides.names.push_back(sides.view.buffer + (isBuffer ? "" : ", " + nameOf(*source).toStdString()));
    }
    return sides;
}

// Between two sides; the window has a handle there.
void drawBorder(QImage& picture, const Wipe& wipe) {
    QPainter painter(&picture);
    const int x = wipe.border(picture.width());
    painter.fillRect(x - 3, 0, 6, picture.height(), Qt::black);
    painter.fillRect(x - 1, 0, 2, picture.height(), Qt::white);
}

// Why a frame lacks a view's buffer, else that it was stopped.
Error whyNone(const pipeline::FramePtr& frame, const lessons::BufferShown& view, const pipeline::Stop& stop) {
    if (!frame || stop.stop_requested()) return {{}, "stopped", {}};
    const auto name = pipeline::findBuffer(view.buffer);
    return {{}, name ? frame->whyAbsent(*name) : "the scene has no such buffer", {}};
}

Result<TalkPicture> bufferPicture(const lessons::WindowState& state,
                                  const std::shared_ptr<const pipeline::Scene>& scene, std::size_t number,
                                  PictureLook look, const pipeline::Stop& stop) {
    if (number >= state.views.size()) return Error{{}, "the cue has no such view", {}};
    const lessons::BufferShown& view = state.views[number];
    const CueSides sides = view.compared ? sidesOf(view, scene) : CueSides{{view.buffer}, nullptr, view, {}};
    const std::string mode = view.compared && sides.whyNoB.empty() ? view.compared->mode : "a";
    TalkPicture made{.png = {}, .leftOut = sides.whyNoB, .names = sides.names};

    pipeline::FramePtr frame;
    std::optional<ShownBuffer> a, b;
    if (mode != "b") {
        frame = frameOf(state, scene, stop);
        a = frame ? shownOf(*frame, state, view, look, stop) : std::nullopt;
        if (!a) return whyNone(frame, view, stop);
    }
    if (mode != "a") {
        lessons::WindowState other = state;
        other.views = {sides.view};
        const pipeline::FramePtr frameB = frameOf(other, sides.scene, stop);
        b = frameB ? shownOf(*frameB, other, sides.view, look, stop) : std::nullopt;
        if (!b && mode == "b") return whyNone(frameB, sides.view, stop);
        if (!b) made.leftOut = "A is shown alone: " + whyNone(frameB, sides.view, stop).found;
        if (a && b && a->content.size != b->content.size) {
            made.leftOut = "A is shown alone: B has another size.";
            b.reset();
        }
        if (!frame) frame = frameB;
    }
    if (stop.stop_requested()) return Error{{}, "stopped", {}};

    CanvasPictures pictures{a ? a->content : b->content, {}, {}};
    if (a && b) {
        if (mode == "difference")
            made.leftOut = "The picture of the difference needs the window. A is at the left and B at the right.";
        pictures.b = b->content;
        pictures.wipe.share = mode == "wipe" ? view.compared->wipe : 0.5;
    } else if (made.names.size() == 2) {
        made.names.erase(made.names.begin() + (a ? 1 : 0));
    }
    look.compared = &pictures;
    QImage picture = pictureOf(*frame, state, a ? view : sides.view, look, stop);
    if (picture.isNull()) return Error{{}, "stopped", {}};
    if (pictures.b) drawBorder(picture, pictures.wipe);
    made.png = pngBytes(picture);
    made.legend = legendOf(a ? *a : *b);
    return made;
}

}  // namespace

Result<TalkPicture> drawCueView(const lessons::WindowState& state, const std::shared_ptr<const pipeline::Scene>& scene,
                                lessons::ViewLeaf view, const TalkRoom& room, const pipeline::Stop& stop) {
    static const FontSystem s_fonts;
    if (!s_fonts.ready()) return Error{{}, "no font system for the text of the views", {}};
    const auto number = std::size_t(view.number);
    if (view.kind == lessons::ViewLeaf::Kind::Buffer)
        return bufferPicture(state, scene, number, {.size = QSize(room.size.x, room.size.y), .growth = room.growth},
                             stop);
    if (number >= state.spaces.size()) return Error{{}, "the cue has no such view", {}};
    const auto space = spacePicture(state, state.spaces[number], scene, room.size, room.growth, stop);
    if (!space) return space.errors();
    const auto image = renderBeside(*space);
    if (!image) return image.errors();
    return TalkPicture{pngBytes(*image)};
}

}  // namespace app
