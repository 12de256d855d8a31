#include "lessons/pages/handout_figure.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "lessons/derived_buffer.h"
#include "lessons/expression/changed_frames.h"
#include "pipeline/buffers/palette.h"
#include "pipeline/export/buffers/png_file.h"
#include "pipeline/export/html/formula_html.h"
#include "pipeline/export/html/html_text.h"
#include "pipeline/inspect/formula_parts.h"
#include "pipeline/stages/cull.h"
#include "pipeline/steps/steps.h"

namespace lessons {

namespace {

using pipeline::AnyBuffer;
using pipeline::Color8;
using pipeline::Domain;
using pipeline::Palette;
using pipeline::PaletteRange;
using pipeline::Tile;

constexpr std::size_t kMostFigureRows = 40, kMostCategories = 8;
constexpr double kTallest = 24;  // of a picture, rem

// "1.5·10^−6" with its power set high.
std::string numberHtml(double value) {
    return toHtml(pipeline::numeral(pipeline::withMinus(fmt::format("{:.4g}", value))));
}

std::string cssColor(Color8 c) { return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b); }

std::string pictureOf(const AnyBuffer& buffer, PaletteRange range, ShownChannel shown, Tile part) {
    pipeline::Buffer2D<Color8> picture(part.max - part.min, Color8(0));
    const int channel = shown < ShownChannel::Luminance ? index(shown) : -1;
    const auto colorAt = [&](std::size_t x, std::size_t y) {
        if (channel < 0 || channel >= buffer.channels()) return elementColor(buffer, x, y, range);
        return pipeline::paletteColor(buffer.info->palette, buffer.value(x, y, channel), range.first, range.last);
    };
    for (int y = part.min.y; y < part.max.y; ++y)
        for (int x = part.min.x; x < part.max.x; ++x)
            picture.at(glm::ivec2(x, y) - part.min) = colorAt(std::size_t(x), std::size_t(y));
    return pngOf(picture);
}

// Widens `box` to hold what a buffer shows.
void include(const AnyBuffer& buffer, Tile& box) {
    const auto isDrawn = [&](int x, int y) {
        for (int c = 0; c < buffer.channels(); ++c)
            if (buffer.value(std::size_t(x), std::size_t(y), c) != buffer.info->neutral) return true;
        return false;
    };
    for (int y = 0; y < int(buffer.rows()); ++y)
        for (int x = 0; x < int(buffer.columns()); ++x)
            if (isDrawn(x, y)) box.min = glm::min(box.min, {x, y}), box.max = glm::max(box.max, {x + 1, y + 1});
}

// The two ends of a scale, and the colours between them.
std::string scaleLegend(const AnyBuffer& buffer, PaletteRange range) {
    std::string stops;
    for (const Color8 color : paletteStops(buffer.info->palette)) stops += ", " + cssColor(color);
    const std::string unit = buffer.info->unit.empty() ? "" : ' ' + pipeline::escapedHtml(buffer.info->unit);
    return fmt::format("{} <span class=scale style=\"background: linear-gradient(90deg{})\"></span> {}{}",
                       numberHtml(range.first), stops, numberHtml(range.last), unit);
}

// What there is of ids, by their colours; nothing where there are more than colours.
std::string categoryLegend(const pipeline::Frame& frame, const AnyBuffer& buffer) {
    std::set<double> there;
    for (std::size_t i = 0; i < buffer.count() && there.size() <= kMostCategories; ++i)
        if (buffer.flat(i) >= 0) there.insert(buffer.flat(i));
    if (there.size() > kMostCategories) return {};
    std::string html;
    for (const double value : there) {
        const Color8 color = pipeline::paletteColor(buffer.info->palette, value, 0, 0);
        std::string label = fmt::format("{:.0f}", value);
        if (buffer.name.id == pipeline::BufferId::ObjectId)
            label += ' ' + frame.scene().objects[std::size_t(value)].name;
        html += fmt::format("<span class=swatch style=\"background: {}\"></span> {} ", cssColor(color),
                            pipeline::escapedHtml(label));
    }
    return html;
}

std::string legend(const pipeline::Frame& frame, const AnyBuffer& buffer, PaletteRange range) {
    switch (buffer.info->palette) {
        case Palette::Sequential:
        case Palette::Diverging: return scaleLegend(buffer, range);
        case Palette::Categorical: return categoryLegend(frame, buffer);
        case Palette::Direction:
            return fmt::format("x, y, z as red, green, blue: {} to {}", numberHtml(range.first),
                               numberHtml(range.last));
        case Palette::Color:
            return buffer.info->element == pipeline::Element::UInt8
                       ? std::string()
                       : fmt::format("from {} to {}", numberHtml(range.first), numberHtml(range.last));
        case Palette::Verdict:
        case Palette::ShadowVerdict:
        case Palette::Truth: return {};
    }
    return {};
}

std::string pictureHtml(const pipeline::Frame& frame, const AnyBuffer& buffer, Tile part,
                        const std::optional<glm::ivec2>& pixel, const std::string& caption, const BufferShown& look) {
    const glm::ivec2 size(int(buffer.columns()), int(buffer.rows()));
    const bool ofPixels = buffer.info->domain == Domain::Pixel;
    if (!ofPixels) part = {{0, 0}, size};
    const PaletteRange range = look.range
                                   ? PaletteRange{(*look.range)[0], (*look.range)[1]}
                                   : fittingRange(buffer, statistics(buffer), frame.scene().settings.depthFormat);
    // A tall one, as the faces of a shadow buffer below one another, is narrower: it has to fit on a sheet.
    const glm::dvec2 shown(part.max - part.min);
    const std::string narrow =
        shown.y > shown.x ? fmt::format(" style=\"max-width: {:.2f}rem\"", kTallest * shown.x / shown.y) : "";
    std::string html =
        fmt::format("<div class=picture{}><img src=\"{}\" alt=\"{}\">", narrow,
                    pipeline::imageSource("png", pictureOf(buffer, range, look.channel, part)),
                    pipeline::escapedHtml(pictureSentence(buffer, part, ofPixels ? pixel : std::nullopt)));
    if (pixel && ofPixels) {
        const glm::dvec2 at = 100.0 * (glm::dvec2(*pixel - part.min) + 0.5) / glm::dvec2(part.max - part.min);
        html += fmt::format("<span class=pick style=\"left: {:.3f}%; top: {:.3f}%\"></span>", at.x, at.y);
    }
    html += "</div><figcaption>" + caption;
    if (part.max - part.min != size)
        html += fmt::format(" Columns {} to {}, rows {} to {} of {} × {}.", part.min.x, part.max.x - 1, part.min.y,
                            part.max.y - 1, size.x, size.y);
    if (const std::string colours = legend(frame, buffer, range); !colours.empty()) html += "<br>" + colours;
    return html + "</figcaption>";
}

std::string cellHtml(const AnyBuffer& buffer, std::size_t row, int channel) {
    const double value = buffer.value(0, row, channel);
    if (buffer.info->palette != Palette::Verdict) return "<td class=number>" + numberHtml(value) + "</td>";
    return pipeline::element("td", name(static_cast<pipeline::Verdict>(value)));
}

std::string tableHtml(const AnyBuffer& buffer, const std::string& caption) {
    const bool isColor = buffer.info->palette == Palette::Color;
    std::string html = "<table><caption>" + caption + "</caption><thead><tr>" +
                       pipeline::element("th", buffer.info->domain == Domain::Polygon ? "polygon" : "vertex");
    for (int c = 0; c < buffer.channels(); ++c)
        html += buffer.channels() == 1
                    ? "<th></th>"
                    : pipeline::element("th class=number",
                                        std::string_view(isColor ? "rgb" : "xyz").substr(std::size_t(c), 1));
    html += "</tr></thead><tbody>\n";
    const std::size_t rows = std::min(buffer.rows(), kMostFigureRows);
    for (std::size_t row = 0; row < rows; ++row) {
        html += fmt::format("<tr><td>{}</td>", row);
        for (int c = 0; c < buffer.channels(); ++c) html += cellHtml(buffer, row, c);
        html += "</tr>\n";
    }
    html += "</tbody></table>";
    return rows == buffer.rows() ? html : html + fmt::format("<p>and {} more</p>", buffer.rows() - rows);
}

// "Gouraud: color The colour of each pixel."
std::string captionOf(const pipeline::BufferName& name, const std::string& meaning, std::string_view note) {
    const std::string before = note.empty() ? std::string() : pipeline::escapedHtml(std::string(note)) + ": ";
    return before + pipeline::element("code", name.text()) + ' ' + pipeline::escapedHtml(meaning);
}

std::string bufferFigure(const pipeline::Frame& frame, const AnyBuffer& buffer, Tile part,
                         const std::optional<glm::ivec2>& pixel, const std::string& meaning, const BufferShown& look,
                         std::string_view note) {
    const std::string caption = captionOf(buffer.name, meaning, note);
    const Domain domain = buffer.info->domain;
    const bool isPicture = domain == Domain::Pixel || domain == Domain::Texel;
    return "<figure>" +
           (isPicture ? pictureHtml(frame, buffer, part, pixel, caption, look) : tableHtml(buffer, caption)) +
           "</figure>\n";
}

// What view A is compared with, where that is in a page's own frames: "setting KEY=VALUE" or "buffer NAME".
std::string comparedFigure(const BufferShown& view, const pipeline::BufferName& name, const pipeline::Frame& frame,
                           Tile part, const std::optional<glm::ivec2>& pixel, const pipeline::Stop& stop) {
    constexpr std::string_view kSetting = "setting ", kBuffer = "buffer ";
    const std::string& with = view.compared->with;
    if (with.starts_with(kBuffer)) {
        const auto other = pipeline::findBuffer(with.substr(kBuffer.size()));
        return other ? figureHtml(frame, *other, part, pixel, view, "B") : std::string();
    }
    if (!with.starts_with(kSetting) || pipeline::isDerived(name.id)) return {};
    const std::string change = with.substr(kSetting.size());
    ChangedFrames changed;
    const auto other = changed.frame(frame, std::span(&change, 1), frame.wanted(), stop);
    return other ? figureHtml(**other, name, part, pixel, view, change) : std::string();
}

}  // namespace

pipeline::FramePtr frameShown(const PageState& state, const pipeline::FramePtr& frame, const pipeline::Stop& stop) {
    if (!state.window.place) return frame;
    const pipeline::Steps steps(frame);
    return steps.frameAt(steps.momentOf(*state.window.place), 0, stop);
}

std::string figuresHtml(const PageState& state, const pipeline::FramePtr& whole, const Hidden& hidden,
                        const pipeline::Stop& stop) {
    const pipeline::FramePtr frame = frameShown(state, whole, stop);
    if (!frame) return {};
    const std::vector<pipeline::BufferName> buffers = shownBuffers(state);
    const std::optional<glm::ivec2> pixel = pickedPixel(state);
    const Tile part = partToShow(*frame, buffers, pixel);
    const auto mix = pipeline::parseMix(state.window.mix, state.scene.lights.size());
    const DerivedRecipe recipe{state.window.condition, mix ? *mix : pipeline::TermMix()};
    std::string html;
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const pipeline::BufferName& name = buffers[i];
        const bool isYetToCome = !frame->buffer(name) && whole->buffer(name);  // at the page's place in the frame
        if (hidden.hides(name) || isYetToCome) continue;
        // Of a view that is compared: A, B, or both where the window wipes, blinks or takes the difference.
        const BufferShown& view = state.window.views[i];
        const auto& compared = view.compared;
        const std::string other =
            compared && compared->mode != "a" ? comparedFigure(view, name, *frame, part, pixel, stop) : std::string();
        if (compared && compared->mode == "b" && !other.empty()) {
            html += other;
            continue;
        }
        if (pipeline::isDerived(name.id)) {
            const auto made = derive(name, recipe, *frame, {.stop = stop});
            if (made) html += bufferFigure(*frame, made->buffer, part, pixel, made->meaning, view, {});
        } else {
            html += figureHtml(*frame, name, part, pixel, view);
        }
        html += other;
    }
    return html;
}

std::string pictureSentence(const AnyBuffer& buffer, Tile part, const std::optional<glm::ivec2>& pixel) {
    const std::string unit = buffer.info->unit.empty() ? "" : ' ' + std::string(buffer.info->unit);
    const auto valueAt = [&](glm::ivec2 at) {
        Value value;
        for (int c = 0; c < buffer.channels(); ++c)
            value.numbers.push_back(buffer.value(std::size_t(at.x), std::size_t(at.y), c));
        return toText(value) + unit;
    };
    Tile drawn{{int(buffer.columns()), int(buffer.rows())}, {0, 0}};
    include(buffer, drawn);
    std::string text = fmt::format("{}: {} ", buffer.name.text(), buffer.info->meaning);
    if (drawn.max.x == 0) return text + "Nothing is drawn yet.";
    const pipeline::BufferStatistics found = pipeline::statistics(buffer);
    text += fmt::format("Drawn are columns {} to {} and rows {} to {} of {} by {} pixels.", drawn.min.x,
                        drawn.max.x - 1, drawn.min.y, drawn.max.y - 1, buffer.columns(), buffer.rows());
    if (buffer.info->palette == Palette::Sequential || buffer.info->palette == Palette::Diverging)
        text += fmt::format(" Values go from {}{} to {}{}.", toText({{found.min}, {}}), unit, toText({{found.max}, {}}),
                            unit);
    const bool inside =
        pixel && pixel->x >= part.min.x && pixel->x < part.max.x && pixel->y >= part.min.y && pixel->y < part.max.y;
    if (inside)
        text += fmt::format(" At the ring, pixel {}, {}, the value is {}.", pixel->x, pixel->y, valueAt(*pixel));
    return text;
}

Tile partToShow(const pipeline::Frame& frame, std::span<const pipeline::BufferName> buffers,
                const std::optional<glm::ivec2>& pixel) {
    const glm::ivec2 size(frame.scene().settings.width, frame.scene().settings.height);
    Tile box{size, {0, 0}};
    if (pixel) box = {*pixel, *pixel + 1};
    for (const pipeline::BufferName& name : buffers)
        if (const auto buffer = frame.buffer(name); buffer && buffer->info->domain == Domain::Pixel)
            include(*buffer, box);
    // As wide as the wider of the two asks for, and a quarter of that on each side.
    const glm::dvec2 shares = glm::dvec2(box.max - box.min) / glm::dvec2(size);
    const double share = std::max(shares.x, shares.y);
    if (share <= 0 || share > 0.5) return {{0, 0}, size};
    const glm::ivec2 part = glm::max(glm::ivec2(glm::ceil(1.5 * share * glm::dvec2(size))), glm::ivec2(1));
    const glm::ivec2 low = glm::clamp((box.min + box.max - part) / 2, glm::ivec2(0), size - part);
    return {low, low + part};
}

std::string figureHtml(const pipeline::Frame& frame, const pipeline::BufferName& name, Tile part,
                       const std::optional<glm::ivec2>& pixel, const BufferShown& look, std::string_view note) {
    if (const auto buffer = frame.buffer(name))
        return bufferFigure(frame, *buffer, part, pixel, std::string(buffer->info->meaning), look, note);
    return "<figure><figcaption>" + captionOf(name, frame.whyAbsent(name), note) + "</figcaption></figure>\n";
}

// Backgrounds are printed too: they are what the legend shows.
std::string_view paperStyle() {
    return R"(
body { margin: 0; background: #FFFFFF; color: #171A1F; font: 16px/1.5 Inter, system-ui, sans-serif; }
main { max-width: 50rem; margin: 0 auto; padding: 2rem 1.25rem 4rem; }
pre { white-space: pre-wrap; overflow-wrap: anywhere; }
h1 { font-size: 1.75rem; line-height: 1.2; margin: 0 0 .25rem; }
h2 { font-size: 1.25rem; margin: 0 0 .5rem; }
.pictures { display: flex; flex-wrap: wrap; gap: 1rem; margin: .75rem 0; }
)";
}

std::string_view figureStyle() {
    return R"(
figure { flex: 1 1 17rem; max-width: 24rem; margin: 0; }
figcaption, caption { color: #4A525D; font-size: .8rem; line-height: 1.35; padding-top: .3rem; text-align: left; }
.picture { position: relative; border: 1px solid #D0D5DC; line-height: 0; }
.picture img { width: 100%; image-rendering: pixelated; }
@media print { .pictures { display: block; } figure { display: inline-block; width: 17rem; margin: 0 1rem .75rem 0; vertical-align: top; } }
.pick { position: absolute; width: 1rem; height: 1rem; margin: -.5rem 0 0 -.5rem; border: 2px solid #000; border-radius: 50%;
        outline: 2px solid #fff; outline-offset: -4px; box-sizing: border-box; box-shadow: 0 0 0 1.5px #fff; }
.scale, .swatch { display: inline-block; height: .7rem; vertical-align: -.05rem; border: 1px solid #828A95;
                  print-color-adjust: exact; -webkit-print-color-adjust: exact; }
.scale { width: 5rem; } .swatch { width: .7rem; }
table { border-collapse: collapse; font-size: .85rem; }
th, td { text-align: left; padding: .1rem .8rem .1rem 0; border-bottom: 1px solid #D0D5DC; }
th { color: #4A525D; font-weight: 500; } .number { text-align: right; font-variant-numeric: tabular-nums; }
)";
}

}  // namespace lessons
