// The values of a buffer as people read them.
#include <algorithm>
#include <cmath>

#include "app/core/number_format.h"
#include "app/core/numbers.h"
#include "app/panels/buffer_image.h"
#include "pipeline/inspect/compare.h"
#include "pipeline/study/shadow_verdict.h"

namespace app {

using pipeline::AnyBuffer;
using pipeline::BufferId;
using pipeline::BufferInfo;
using pipeline::Element;
using pipeline::Palette;

namespace {

bool isDepth(BufferId id) {
    return id == BufferId::Depth || id == BufferId::ZView || id == BufferId::ShadowBuffer || id == BufferId::ZNdc;
}

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

QString valueText(const AnyBuffer& buffer, double value, int characters) {
    const BufferInfo& info = *buffer.info;
    QString text;
    if (info.palette == Palette::ShadowVerdict) return verdictText(value);
    if (info.element == Element::Real)
        if (const auto chosen = chosenText(value, characters)) return *chosen;
    if (isDifference(info)) return differenceText(value);
    if (info.element != Element::Real)
        text = number(value, 0);
    else if (isDepth(info.id))
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
