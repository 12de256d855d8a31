#include "app/canvas/buffer_image.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/look/number_format.h"
#include "app/look/numbers.h"
#include "pipeline/inspect/compare.h"
#include "pipeline/run/frame_data.h"
#include "pipeline/study/shadow_verdict.h"

namespace app {

using pipeline::AnyBuffer;
using pipeline::BufferId;
using pipeline::BufferInfo;
using pipeline::BufferStatistics;
using pipeline::Color8;
using pipeline::Domain;
using pipeline::Element;
using pipeline::Frame;
using pipeline::Palette;
using pipeline::PaletteRange;

namespace {

QRgb rgb(Color8 c) { return qRgb(c.r, c.g, c.b); }

// Gives every pixel where something was drawn the colour colorOf(its index), in reading order; the others none.
template <class ColorOf>
void fillDrawn(QImage& image, const std::vector<bool>& drawn, ColorOf colorOf) {
    const auto width = std::size_t(image.width());
    for (int y = 0; y < image.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t i = std::size_t(y) * width + x;
            line[x] = drawn.empty() || drawn[i] ? colorOf(i) : QRgb(0);
        }
    }
}

// Colours of one channel. Neighbours are often equal, above all in flat shading.
template <class T>
void fillScalar(QImage& image, std::span<const T> numbers, std::size_t channels, std::size_t channel, Palette palette,
                PaletteRange range, const std::vector<bool>& drawn) {
    T lastValue{};
    QRgb lastColor = rgb(paletteColor(palette, 0, range.first, range.last));
    fillDrawn(image, drawn, [&](std::size_t i) {
        const T value = numbers[i * channels + channel];
        if (value != lastValue) {  // NaN too: it differs from itself
            lastValue = value;
            lastColor = rgb(paletteColor(palette, double(value), range.first, range.last));
        }
        return lastColor;
    });
}

// Each number has its own share of the colour, whatever its neighbours are.
void fillColor(QImage& image, std::span<const std::uint8_t> numbers, PaletteRange range,
               const std::vector<bool>& drawn) {
    std::array<std::uint8_t, 256> shares{};
    for (std::size_t v = 0; v < shares.size(); ++v)
        shares[v] = paletteColor(Palette::Color, double(v), range.first, range.last)[0];
    fillDrawn(image, drawn, [&](std::size_t i) {
        const std::uint8_t* v = &numbers[3 * i];
        return qRgb(shares[v[0]], shares[v[1]], shares[v[2]]);
    });
}

// A number's share of a colour, rounded as paletteColor() rounds it, without its call for each of a million numbers.
std::uint8_t shareOf(double value, PaletteRange range, int channel) {
    const double t = (value - range.first) / (range.last - range.first);
    if (!(t >= 0 && t <= 1)) return paletteColor(Palette::Color, value, range.first, range.last)[channel];
    const double share = 255 * t;
    const int below = int(share);
    return std::uint8_t(below + (share - below >= 0.5));
}

template <class T>
void fillColor(QImage& image, std::span<const T> numbers, PaletteRange range, const std::vector<bool>& drawn) {
    T last[3]{};
    QRgb lastColor = 0;
    fillDrawn(image, drawn, [&](std::size_t i) {
        const T* v = &numbers[3 * i];
        if (lastColor == 0 || v[0] != last[0] || v[1] != last[1] || v[2] != last[2]) {
            std::copy_n(v, 3, last);
            Color8 color;
            for (int c = 0; c < 3; ++c) color[c] = shareOf(double(v[c]), range, c);
            lastColor = rgb(color);
        }
        return lastColor;
    });
}

// A distance: infinite where nothing was drawn.
bool isDepth(const BufferInfo& info) { return std::isinf(info.neutral); }

// Differences are told in three digits that matter, whatever they differ in.
QString differenceText(double value) {
    const double size = std::abs(value);
    if (!(size < 1e6)) return value < 0 ? QChar(0x2212) + errorText(size) : errorText(size);
    if (value == std::round(value)) return number(value, 0);
    if (size < 1e-3) return value < 0 ? QChar(0x2212) + errorText(size) : errorText(size);
    return number(value, size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : size >= 0.1 ? 3 : size >= 0.01 ? 4 : 5);
}

bool isZero(const QString& text) {
    return std::ranges::all_of(text, [](QChar c) { return c == '0' || c == '.'; });
}

QString verdictText(double value) {
    const auto table = pipeline::shadowVerdictTable();
    if (!(value >= 0 && value < double(table.size()))) return "none";
    const std::string_view name = table[std::size_t(value)].name;
    return QString::fromUtf8(name.data(), qsizetype(name.size()));
}

}  // namespace

bool isVector(const BufferInfo& info) { return info.palette == Palette::Direction && info.unit.empty(); }

Palette shownPalette(const BufferInfo& info, lessons::ShownChannel channel) {
    if (info.channels == 1 || channel == lessons::ShownChannel::All) return info.palette;
    if (info.palette == Palette::Direction) return Palette::Diverging;
    return info.element == Element::UInt8 ? Palette::Color : Palette::Sequential;
}

bool standsOnShapes(const BufferInfo& info) {
    return info.domain == pipeline::Domain::Vertex || info.domain == pipeline::Domain::Polygon;
}

bool hasRange(const BufferInfo& info, lessons::ShownChannel channel) {
    const Palette palette = shownPalette(info, channel);
    return palette == Palette::Sequential || palette == Palette::Diverging ||
           (palette == Palette::Color && info.element == Element::Real);
}

BufferStatistics channelStatistics(const AnyBuffer& buffer, lessons::ShownChannel channel) {
    BufferStatistics found;
    if (buffer.info->element == Element::UInt8 && buffer.info->palette == Palette::Color) return found;
    if (channel == lessons::ShownChannel::All || buffer.channels() == 1) return statistics(buffer);
    double min = INFINITY, max = -INFINITY;
    const auto channels = std::size_t(buffer.channels());
    const std::vector<bool> with = pipeline::rowsWithValue(buffer);
    std::visit(
        [&](const auto& numbers) {
            for (std::size_t i = std::size_t(index(channel)); i < numbers.size(); i += channels) {
                if (!with.empty() && !with[i / channels]) continue;
                const double value = double(numbers[i]);
                found.nan += std::isnan(value);
                found.infinite += std::isinf(value);
                found.negative += value < 0;
                if (!std::isfinite(value)) continue;
                ++found.finite;
                min = std::min(min, value);
                max = std::max(max, value);
            }
        },
        buffer.data);
    if (found.finite > 0) {
        found.min = min;
        found.max = max;
    }
    return found;
}

PaletteRange fittingRange(const AnyBuffer& buffer, lessons::ShownChannel channel, const BufferStatistics& found,
                          pipeline::DepthFormat format) {
    if (channel == lessons::ShownChannel::All || buffer.channels() == 1)
        return pipeline::fittingRange(buffer, found, format);
    switch (shownPalette(*buffer.info, channel)) {
        case Palette::Diverging: {
            const double end = isVector(*buffer.info) ? 1 : std::max(std::abs(found.min), std::abs(found.max));
            return {-end, end};
        }
        case Palette::Sequential: return {found.max, std::min(0.0, found.min)};  // more is lighter
        default: return {0, 255};
    }
}

bool isColorPicture(const BufferInfo& info, lessons::ShownChannel channel) {
    return info.palette == Palette::Color && info.stage == pipeline::StageId::Shading &&
           channel == lessons::ShownChannel::All;
}

std::optional<AnyBuffer> polygonsUnder(const Frame& frame, const BufferInfo& info) {
    if (info.domain != Domain::Pixel) return {};
    std::optional<AnyBuffer> polygons = frame.buffer({BufferId::PolygonId});
    if (!polygons || info.stage != pipeline::StageId::Shading) return polygons;
    pipeline::readStages(frame, [&](const auto& data) {
        if (!data.shading || data.shading->pixelIsShaded.empty()) return;
        const auto& all = std::get<std::span<const std::int32_t>>(polygons->data);
        const auto shaded = std::make_shared<std::vector<std::int32_t>>(all.begin(), all.end());
        for (std::size_t i = 0; i < shaded->size(); ++i)
            if (!data.shading->pixelIsShaded[i]) (*shaded)[i] = pipeline::kNothing;
        polygons->data = std::span<const std::int32_t>(*shaded);
        polygons->owner = shaded;
    });
    return polygons;
}

std::vector<bool> drawnElements(const AnyBuffer& buffer, const std::optional<AnyBuffer>& polygonId,
                                lessons::ShownChannel channel) {
    const BufferInfo& info = *buffer.info;
    if (auto rows = pipeline::rowsWithValue(buffer); !rows.empty()) return rows;
    if (isColorPicture(info, channel)) return {};
    if (info.domain == Domain::Pixel && polygonId) {
        // At outlines there may be no verdict.
        const AnyBuffer& codes = info.palette == Palette::ShadowVerdict ? buffer : *polygonId;
        std::vector<bool> drawn(codes.count());
        std::visit(
            [&](const auto& numbers) {
                for (std::size_t i = 0; i < drawn.size(); ++i) drawn[i] = numbers[i] >= 0;
            },
            codes.data);
        return drawn;
    }
    if (!std::isinf(info.neutral)) return {};
    std::vector<bool> drawn(buffer.count());
    for (std::size_t i = 0; i < drawn.size(); ++i) drawn[i] = buffer.flat(i) != info.neutral;
    return drawn;
}

QImage bufferImage(const AnyBuffer& buffer, const BufferLook& look, const std::vector<bool>& drawn) {
    QImage image(int(buffer.columns()), int(buffer.rows()), QImage::Format_ARGB32_Premultiplied);
    std::visit(
        [&](const auto& numbers) {
            const auto channels = std::size_t(buffer.channels());
            if (channels == 3 && look.channel == lessons::ShownChannel::All)
                fillColor(image, numbers, look.range, drawn);
            else
                fillScalar(image, numbers, channels, std::size_t(firstOf(look.channel)),
                           shownPalette(*buffer.info, look.channel), look.range, drawn);
        },
        buffer.data);
    return image;
}

std::vector<int> histogram(const AnyBuffer& buffer, const BufferLook& look, const std::vector<bool>& drawn, int bins) {
    std::vector<int> counts(std::size_t(bins), 0);
    const auto channels = std::size_t(buffer.channels());
    const double length = look.range.last - look.range.first;
    if (length == 0) return counts;
    const auto begin = std::size_t(firstOf(look.channel));
    const std::size_t end = look.channel == lessons::ShownChannel::All ? channels : begin + 1;
    const auto outside = std::size_t(bins);  // a bin beyond the others
    counts.push_back(0);
    const auto binOf = [&](double value) {
        const double t = (value - look.range.first) / length;
        return t >= 0 && t <= 1 ? std::min(std::size_t(t * bins), outside - 1) : outside;
    };
    std::visit(
        [&](const auto& numbers) {
            // Neighbours are often equal.
            auto last = numbers.empty() ? 0 : numbers[0];
            std::size_t bin = numbers.empty() ? 0 : binOf(double(last));
            for (std::size_t i = 0; i * channels < numbers.size(); ++i) {
                if (!drawn.empty() && !drawn[i]) continue;
                for (std::size_t c = begin; c < end; ++c) {
                    const auto value = numbers[i * channels + c];
                    if (value != last) last = value, bin = binOf(double(value));
                    ++counts[bin];
                }
            }
        },
        buffer.data);
    counts.pop_back();
    return counts;
}

QString valueText(const AnyBuffer& buffer, double value, int characters) {
    const BufferInfo& info = *buffer.info;
    QString text;
    if (info.palette == Palette::ShadowVerdict) return verdictText(value);
    if (info.element == Element::Real)
        if (const auto chosen = chosenText(value, characters)) return *chosen;
    if (isDifference(info)) return differenceText(value);
    if (info.element != Element::Real)
        text = number(value, 0);
    else if (isDepth(info))
        text = depth(value, std::holds_alternative<std::span<const double>>(buffer.data));
    else if (info.unit == "intensity")
        text = intensity(value);
    else if (isVector(info))
        text = component(value);
    else
        text = info.unit.empty() ? dotProduct(value) : number(value, 2);
    if (value != 0 && std::isfinite(value) && isZero(text))
        return (value < 0 ? QString(QChar(0x2212)) : QString()) + errorText(std::abs(value));
    if (characters <= 0 || text.size() <= characters || !text.contains('.')) return text;
    const int decimals = int(text.size() - text.indexOf('.')) - 1 - int(text.size() - characters);
    return number(value, std::max(0, decimals));
}

QStringList elementText(const AnyBuffer& buffer, std::size_t x, std::size_t y, lessons::ShownChannel channel,
                        int characters) {
    QStringList texts;
    const bool isEmpty = buffer.hasValue && !(*buffer.hasValue)[y];
    for (int c = 0; c < buffer.channels(); ++c)
        if (channel == lessons::ShownChannel::All || index(channel) == c)
            texts << (isEmpty ? QStringLiteral("–") : valueText(buffer, buffer.value(x, y, c), characters));
    return texts;
}

}  // namespace app
