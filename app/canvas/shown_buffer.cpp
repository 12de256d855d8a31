#include "app/canvas/shown_buffer.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "app/canvas/buffer_legend.h"
#include "app/frames/large_frame.h"
#include "app/jobs/free_in_background.h"
#include "app/look/luminance.h"
#include "app/look/numbers.h"
#include "app/look/text.h"
#include "lessons/games/look_text.h"
#include "pipeline/run/frame_remarks.h"

namespace app {

using pipeline::AnyBuffer;
using pipeline::BufferId;
using pipeline::BufferInfo;
using pipeline::BufferName;
using pipeline::Domain;
using pipeline::Element;
using pipeline::Frame;
using pipeline::Palette;
using pipeline::PaletteRange;

namespace {

// What of the drawn elements is no number, and how many different ones there are.
struct Findings {
    std::size_t drawn = 0, nan = 0, infinite = 0, distinct = 0;  // distinct: 257 stands for more than 256
    double min = INFINITY;
    std::size_t minAt = 0;
};

Findings look(const AnyBuffer& buffer, const std::vector<bool>& drawn, lessons::ShownChannel channel) {
    Findings found;
    const auto channels = std::size_t(buffer.channels());
    // Bytes are numbers, and nobody counts colours.
    if (isColorPicture(*buffer.info, channel) && buffer.info->element == Element::UInt8) return found;
    const auto c = std::size_t(firstOf(channel));
    std::vector<double> values;  // the distinct ones, sorted
    std::visit(
        [&](const auto& numbers) {
            double last = NAN;
            for (std::size_t i = 0; i * channels < numbers.size(); ++i) {
                if (!drawn.empty() && !drawn[i]) continue;
                ++found.drawn;
                const double value = double(numbers[i * channels + c]);
                if (std::isnan(value)) {
                    ++found.nan;
                } else if (std::isinf(value)) {
                    ++found.infinite;
                } else if (value != last) {
                    last = value;
                    if (value < found.min) {
                        found.min = value;
                        found.minAt = i;
                    }
                    if (values.size() > 256) continue;
                    const auto at = std::lower_bound(values.begin(), values.end(), value);
                    if (at == values.end() || *at != value) values.insert(at, value);
                }
            }
        },
        buffer.data);
    found.distinct = values.size();
    return found;
}

QString noticeOf(const Findings& found, bool countsDistinct) {
    QStringList parts;
    if (countsDistinct && found.distinct > 1 && found.distinct <= 256)
        parts << QString("%1 distinct values").arg(found.distinct);
    if (found.nan > 0) parts << QString("%1 NaN").arg(found.nan);
    if (found.infinite > 0) parts << QString("%1 infinite").arg(found.infinite);
    return parts.join(", ");
}

bool isDrawn(const QImage& image, QPoint pixel) { return image.isNull() || qAlpha(image.pixel(pixel)) != 0; }

// Values in a pixel, then which polygon it shows and how many fragments came.
std::function<QStringList(int, int)> textOf(const AnyBuffer& buffer, lessons::ShownChannel channel,
                                            const std::optional<AnyBuffer>& polygons,
                                            const std::optional<AnyBuffer>& overdraw, const QImage& image) {
    return [=](int x, int y) {
        if (!isDrawn(image, {x, y})) return QStringList("no value");
        constexpr int kCharacters = 8;  // of 11 px in 56
        QStringList lines = elementText(buffer, std::size_t(x), std::size_t(y), channel, kCharacters);
        if (!polygons || lines.size() > 1) return lines;
        const double polygon = polygons->value(std::size_t(x), std::size_t(y));
        if (polygon < 0) return lines;
        QString second = QString("p%1").arg(int(polygon));
        const int fragments = overdraw ? int(overdraw->value(std::size_t(x), std::size_t(y))) : 0;
        if (fragments > 1) second += QString(" ×%1").arg(fragments);
        return lines << second;
    };
}

QRectF drawnRectangle(const std::vector<bool>& drawn, QSize size) {
    QRect found;
    for (int y = 0; y < size.height() && !drawn.empty(); ++y)
        for (int x = 0; x < size.width(); ++x)
            if (drawn[std::size_t(y) * std::size_t(size.width()) + std::size_t(x)]) found |= QRect(x, y, 1, 1);
    return focusOn(QRectF(found), size);
}

// The number of pixels that show a surface, opaque or translucent; 0 if it is not known.
std::size_t coveredPixels(const std::optional<AnyBuffer>& polygons, const std::optional<AnyBuffer>& layers) {
    if (!polygons) return 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < polygons->count(); ++i)
        count += polygons->flat(i) >= 0 || (layers && layers->flat(i) > 0);
    return count;
}

QString descriptionOf(const AnyBuffer& buffer, const QSize& size, const Findings& found) {
    QString text = QString("%1, %2 by %3").arg(toQString(buffer.name.text())).arg(size.width()).arg(size.height());
    if (buffer.info->domain != Domain::Pixel || found.drawn == 0) return text;
    text += QString(", %1 % covered")
                .arg(number(100.0 * double(found.drawn) / double(buffer.rows() * buffer.columns()), 2));
    if (buffer.channels() == 1 && std::isfinite(found.min)) {
        const bool isDistance = std::isinf(buffer.info->neutral);
        text += QString(", %1 %2 at %3, %4")
                    .arg(isDistance ? "nearest" : "least", valueText(buffer, found.min))
                    .arg(found.minAt % buffer.columns())
                    .arg(found.minAt / buffer.columns());
    }
    return text;
}

// A picture in colours has a ground where nothing was drawn; where that is everywhere it is no answer.
bool isGroundAlone(const Frame& frame, const AnyBuffer& buffer, const std::optional<AnyBuffer>& polygons) {
    if (buffer.info->id != BufferId::Color || frame.scene().settings.visibility == pipeline::Visibility::None)
        return false;
    if (!polygons) return false;
    const auto ids = std::get<std::span<const std::int32_t>>(polygons->data);
    return std::all_of(ids.begin(), ids.end(), [](std::int32_t id) { return id < 0; });
}

QString whyNothing(const Frame& frame) {
    const auto why = pipeline::whyNothingIsSeen(frame);
    if (!why) return "Nothing was drawn.";
    const QString text = toQString(why->text);
    return "Nothing was drawn: " + text.left(1).toLower() + text.mid(1);
}

PaletteBar::Scale scaleOf(const AnyBuffer& buffer, const BufferLook& shown, PaletteRange whole) {
    PaletteBar::Scale scale;
    const auto [a, b] = std::minmax({whole.first, whole.last, shown.range.first, shown.range.last});
    scale.low = a;
    scale.high = b;
    scale.range = shown.range;
    scale.palette = shownPalette(*buffer.info, shown.channel);
    return scale;
}

ElementCounts countsOf(const AnyBuffer& buffer, QSize size, lessons::ShownChannel channel,
                       const std::optional<PaletteBar::Scale>& scale, const std::vector<bool>& drawn,
                       std::size_t covered) {
    const BufferInfo& info = *buffer.info;
    Findings found = look(buffer, drawn, channel);
    // A picture in colours has values also where nothing was drawn.
    if (isColorPicture(info, channel)) found.drawn = covered;
    const bool isScalar = info.channels == 1 || channel != lessons::ShownChannel::All;
    const bool countsDistinct = isScalar && info.element == Element::Real && !standsOnShapes(info);
    constexpr int kBins = 64;
    return {noticeOf(found, countsDistinct), descriptionOf(buffer, size, found),
            scale ? histogram(buffer, {channel, {scale->low, scale->high}}, drawn, kBins) : std::vector<int>()};
}

}  // namespace

bool ShownBuffer::hasValue(QPoint pixel) const { return isDrawn(content.image, pixel); }

QStringList channelNames(const BufferInfo& info) {
    QStringList names;
    for (const std::string& name : lessons::channelNames(info)) names += toQString(name);
    return names;
}

QString captionOf(const BufferInfo& info, lessons::ShownChannel channel) {
    static const QStringList colors{"red", "green", "blue"};
    const bool isColor = info.palette == Palette::Color && info.id != BufferId::Barycentric;
    if (channel == lessons::ShownChannel::Luminance)
        return info.unit == "intensity" ? "luminance, before scaling" : "luminance, 1 is white";
    const bool isAll = channel == lessons::ShownChannel::All;
    const QString alone = isAll ? QString() : (isColor ? colors : channelNames(info))[index(channel)];
    if (info.element == Element::UInt8 && isColor) return isAll ? "sRGB, row 0 on top" : alone + ", row 0 on top";
    if (info.unit == "intensity") return (isAll ? QString("red green blue") : alone) + ", before scaling";
    QString meaning = toQString(info.meaning);
    if (meaning.endsWith('.')) meaning.chop(1);
    return alone.isEmpty() ? meaning : alone + ", " + meaning;
}

std::optional<ShownBuffer> showBuffer(const Frame& frame, const BufferName& name, lessons::ShownChannel channel,
                                      std::optional<PaletteRange> range) {
    const auto buffer = frame.buffer(name);
    if (!buffer) return {};
    const BufferInfo& info = *buffer->info;
    const bool isLuminance = channel == lessons::ShownChannel::Luminance && hasLuminance(info);
    if ((index(channel) >= info.channels && !isLuminance) || info.channels == 1) channel = lessons::ShownChannel::All;
    return showBuffer(frame, *buffer, drawnElements(*buffer, polygonsUnder(frame, info), channel), channel, range);
}

ShownBuffer showBuffer(const Frame& frame, const AnyBuffer& buffer, const std::vector<bool>& drawn,
                       lessons::ShownChannel channel, std::optional<PaletteRange> range, const std::stop_token& stop,
                       std::shared_ptr<const ElementCounts> counts) {
    if (channel == lessons::ShownChannel::Luminance && hasLuminance(*buffer.info)) {
        ShownBuffer shown =
            showBuffer(frame, luminanceOf(buffer), drawn, lessons::ShownChannel::All, range, stop, std::move(counts));
        shown.source = buffer;
        return shown;
    }
    const BufferInfo& info = *buffer.info;
    if (index(channel) >= info.channels || info.channels == 1) channel = lessons::ShownChannel::All;
    const auto polygons = info.domain == Domain::Pixel ? frame.buffer({BufferId::PolygonId}) : std::nullopt;
    ShownBuffer shown;
    shown.buffer = shown.source = buffer;
    shown.numbers = channelStatistics(buffer, channel);
    const PaletteRange whole = fittingRange(buffer, channel, shown.numbers, frame.scene().settings.depthFormat);
    shown.look = {channel, range.value_or(whole)};
    const pipeline::Settings& settings = frame.scene().settings;
    CanvasContent& content = shown.content;
    content.isOfManyPolygons = isLarge(frame);
    if (stop.stop_requested()) return shown;
    if (standsOnShapes(info)) {
        content.size = {settings.width, settings.height};
        content.shapes = freedInBackground(
            std::make_shared<const ShapePicture>(shapePicture(frame, buffer, shown.look, false, stop)));
        if (stop.stop_requested()) return shown;
        content.focus = focusOn(boundsOf(frame, true), content.size);
    } else {
        content.size = {int(buffer.columns()), int(buffer.rows())};
        content.image = bufferImage(buffer, shown.look, drawn);
        if (stop.stop_requested()) return shown;
        content.text = textOf(buffer, channel, polygons, polygons ? frame.buffer({BufferId::Overdraw}) : std::nullopt,
                              content.image);
        if (info.domain == Domain::Pixel) content.edges = outlinesIn(frame);
        content.focus = info.domain == Domain::Pixel ? focusOn(boundsOf(frame, false), content.size)
                                                     : drawnRectangle(drawn, content.size);
    }

    if (stop.stop_requested()) return shown;
    const bool isNothing = !drawn.empty() && std::ranges::find(drawn, true) == drawn.end();
    if (isNothing || isGroundAlone(frame, buffer, polygons)) shown.empty = whyNothing(frame);
    std::optional<PaletteBar::Scale> scale;
    if (hasRange(info, channel)) scale = scaleOf(buffer, shown.look, whole);
    if (!counts) {
        const bool isPicture = isColorPicture(info, channel) && info.domain == Domain::Pixel;
        const std::size_t covered =
            isPicture ? coveredPixels(polygonsUnder(frame, info), frame.buffer({BufferId::Layers})) : 0;
        counts = std::make_shared<const ElementCounts>(countsOf(buffer, content.size, channel, scale, drawn, covered));
    }
    shown.notice = counts->notice;
    if (scale) {
        shown.scale = *scale;
        shown.scale.histogram = counts->histogram;
    }
    shown.counts = std::move(counts);
    const Palette palette = shownPalette(info, channel);
    if (isOfNames(info) && palette == info.palette) shown.legend = legendOf(frame, buffer, drawn);
    return shown;
}

}  // namespace app
