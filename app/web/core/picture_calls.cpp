#include <algorithm>
#include <array>
#include <cmath>

#include "app/web/core/core.h"
#include "pipeline/buffers/buffer2d.h"
#include "pipeline/buffers/palette.h"
#include "pipeline/inspect/compare.h"

// Buffers, and the pictures that they make.

namespace web {

using pipeline::AnyBuffer;
using pipeline::Color8;
using pipeline::PaletteRange;

namespace {

std::vector<std::uint8_t> s_pixels;  // RGBA of the last picture
std::optional<AnyBuffer> s_buffer;   // keeps the memory that the page reads

ShownScene& shownOf(int which) { return which != 1 || !core().other ? core().own : *core().other; }

Json placeJson(const AnyBuffer& buffer) {
    const void* start = std::visit([](const auto& span) { return static_cast<const void*>(span.data()); }, buffer.data);
    return {{"pointer", std::uintptr_t(start)}, {"count", buffer.count()},   {"shape", buffer.shape},
            {"dtype", buffer.dtype()},          {"unit", buffer.info->unit}, {"space", buffer.info->space},
            {"meaning", buffer.info->meaning}};
}

void put(std::uint8_t*& out, Color8 color, bool drawn) {
    out[0] = color.r, out[1] = color.g, out[2] = color.b, out[3] = drawn ? 255 : 0;
    out += 4;
}

// The range that shows all. That of bytes does not depend on what they are.
PaletteRange rangeOf(const AnyBuffer& buffer, pipeline::DepthFormat format) {
    const bool isBytes =
        buffer.info->palette == pipeline::Palette::Color && buffer.info->element == pipeline::Element::UInt8;
    return fittingRange(buffer, isBytes ? pipeline::BufferStatistics{} : statistics(buffer), format);
}

// What is drawn most often: three bytes a pixel.
void paintBytes(std::span<const std::uint8_t> numbers, std::size_t columns, pipeline::Tile part,
                const std::array<std::uint8_t, 256>& shares) {
    std::uint8_t* out = s_pixels.data();
    for (int y = part.min.y; y < part.max.y; ++y) {
        const std::uint8_t* number = numbers.data() + 3 * (std::size_t(y) * columns + std::size_t(part.min.x));
        for (int x = part.min.x; x < part.max.x; ++x, number += 3)
            put(out, {shares[number[0]], shares[number[1]], shares[number[2]]}, true);
    }
}

// Neighbours are often equal, above all in flat shading. channel: of three, the one that is shown alone; below 0: all of
// them as a colour. drawn: the ids of what is seen; null: everything is shown.
template <class T>
void paint(const AnyBuffer& buffer, std::span<const T> numbers, pipeline::Tile part, int channel, PaletteRange range,
           const std::int32_t* drawn) {
    const auto channels = std::size_t(buffer.channels());
    const bool isColor = channels == 3 && channel < 0;
    const pipeline::Palette palette = buffer.info->palette;
    const std::size_t used = isColor ? 3 : 1, from = isColor ? 0 : std::size_t(std::max(channel, 0));
    // A byte has one of 256 shares of a colour.
    std::array<std::uint8_t, 256> shares{};
    if constexpr (std::is_same_v<T, std::uint8_t>)
        for (std::size_t v = 0; v < shares.size(); ++v)
            shares[v] = paletteColor(pipeline::Palette::Color, double(v), range.first, range.last)[0];
    const auto colorOf = [&](const T* number) {
        if (!isColor) return paletteColor(palette, double(number[0]), range.first, range.last);
        if constexpr (std::is_same_v<T, std::uint8_t>)
            return Color8(shares[number[0]], shares[number[1]], shares[number[2]]);
        Color8 color;
        for (int c = 0; c < 3; ++c) {
            const Color8 share = paletteColor(pipeline::Palette::Color, double(number[c]), range.first, range.last);
            if (std::isnan(double(number[c]))) return share;
            color[c] = share[c];
        }
        return color;
    };
    if constexpr (std::is_same_v<T, std::uint8_t>)
        if (isColor && !drawn) return paintBytes(numbers, buffer.columns(), part, shares);
    std::array<T, 3> last{};
    Color8 color = colorOf(last.data());
    std::uint8_t* out = s_pixels.data();
    for (int y = part.min.y; y < part.max.y; ++y)
        for (int x = part.min.x; x < part.max.x; ++x) {
            const std::size_t i = std::size_t(y) * buffer.columns() + std::size_t(x);
            const T* number = numbers.data() + i * channels + from;
            bool same = true;
            for (std::size_t c = 0; c < used; ++c) same = same && number[c] == last[c];  // NaN differs from itself
            if (!same) {
                for (std::size_t c = 0; c < used; ++c) last[c] = number[c];
                color = colorOf(number);
            }
            put(out, color, !drawn || drawn[i] >= 0);
        }
}

// How the reader's picture differs from the one that it is compared with. name: "color AE", buffer and metric.
std::optional<pipeline::BufferDifference> differenceOf(std::string_view name) {
    const std::size_t space = name.find(' ');
    const auto metrics = pipeline::metricTable();
    const auto metric =
        std::ranges::find(metrics, space == name.npos ? "AE" : name.substr(space + 1), &pipeline::MetricInfo::name);
    if (!core().other || metric == metrics.end()) {
        refuse("nothing to compare with");
        return {};
    }
    const auto a = bufferNamed(core().own, name.substr(0, space)),
               b = bufferNamed(*core().other, name.substr(0, space));
    if (!a || !b) return {};
    if (const std::string why = whyNotComparable(*a, *b); !why.empty()) {
        refuse(why);
        return {};
    }
    return compareBuffers(*a, *b, -1, metric->id, {}, {});
}

}  // namespace

// The names of the buffers that the frame holds.
WEB_CALL(held) int webHeld() {
    Json list = Json::array();
    for (const AnyBuffer& buffer : core().own.now().buffers()) list.push_back(buffer.name.text());
    return give(list);
}

// The numbers themselves: pointer, shape, dtype. which: as of picture().
WEB_CALL(buffer) int webBuffer(const char* text, int size, int which) {
    s_buffer = bufferNamed(shownOf(which), textAt(text, size));
    return s_buffer ? give(placeJson(*s_buffer)) : 0;
}

// RGBA in the window's palette; where nothing is drawn, alpha 0. which: 0 the reader's, 1 what it is compared with, 2 the
// difference of both, of "BUFFER METRIC".
// first, last: the ends of the palette where `own` is not 0, else the range that shows all. Of a buffer of the picture's
// size the part from column x and row y on, else all.
WEB_CALL(picture)
int webPicture(const char* text, int size, int which, int channel, int own, double first, double last, int x, int y,
               int width, int height) {
    const pipeline::Frame& frame = shownOf(which).now();
    std::optional<AnyBuffer> buffer;
    std::optional<pipeline::BufferDifference> difference;
    if (which == 2) {
        difference = differenceOf(textAt(text, size));
        if (difference) buffer = difference->values;
    } else {
        buffer = bufferNamed(shownOf(which), textAt(text, size));
    }
    if (!buffer) return 0;
    const pipeline::BufferInfo& info = *buffer->info;
    const PaletteRange range = own ? PaletteRange{first, last} : rangeOf(*buffer, frame.scene().settings.depthFormat);
    const bool masks = info.domain == pipeline::Domain::Pixel && info.id != pipeline::BufferId::Color;
    const auto ids = masks ? frame.buffer({pipeline::BufferId::PolygonId}) : std::nullopt;
    const auto* drawn = ids ? std::get<std::span<const std::int32_t>>(ids->data).data() : nullptr;
    const int columns = int(buffer->columns()), rows = int(buffer->rows());
    const pipeline::Settings& settings = frame.scene().settings;
    pipeline::Tile part{{0, 0}, {columns, rows}};
    const bool isWithin = x >= 0 && y >= 0 && width > 0 && height > 0 && x <= columns - width && y <= rows - height;
    if (isWithin && columns == settings.width && rows == settings.height) part = {{x, y}, {x + width, y + height}};
    s_pixels.resize(4 * std::size_t(part.max.x - part.min.x) * std::size_t(part.max.y - part.min.y));
    std::visit([&](const auto& numbers) { paint(*buffer, numbers, part, channel, range, drawn); }, buffer->data);
    Json stops = Json::array();
    for (const Color8 color : pipeline::paletteStops(info.palette)) stops.push_back({color.r, color.g, color.b});
    Json json = placeJson(*buffer);
    json["pixels"] = std::uintptr_t(s_pixels.data());
    json["width"] = columns, json["height"] = rows;
    json["part"] = {part.min.x, part.min.y, part.max.x - part.min.x, part.max.y - part.min.y};
    json["stops"] = stops;
    json["scale"] = info.palette == pipeline::Palette::Sequential || info.palette == pipeline::Palette::Diverging;
    if (difference) json["largest"] = difference->largest, json["differing"] = difference->differing;
    json["first"] = range.first, json["last"] = range.last;
    json["channels"] = info.channels;
    return give(json);
}

}  // namespace web
