#include "app/frames/copied_value.h"

#include <QStringList>
#include <array>
#include <cassert>
#include <charconv>

#include "app/look/text.h"

namespace app {

QString clearedText(const QString& stored) { return QStringLiteral("nothing drawn (cleared to %1)").arg(stored); }

QString copiedValue(const pipeline::AnyBuffer& buffer, glm::ivec2 pixel, bool isDrawn) {
    assert(pixel.x >= 0 && std::size_t(pixel.x) < buffer.columns());
    assert(pixel.y >= 0 && std::size_t(pixel.y) < buffer.rows());
    const auto channels = std::size_t(buffer.channels());
    const std::size_t first = (std::size_t(pixel.y) * buffer.columns() + std::size_t(pixel.x)) * channels;
    QStringList numbers;
    std::visit(
        [&](const auto& values) {
            for (std::size_t c = 0; c < channels; ++c) {
                std::array<char, 32> digits;  // the longest double has 24
                const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), values[first + c]).ptr;
                numbers << QString::fromLatin1(digits.data(), end - digits.data());
            }
        },
        buffer.data);
    return QStringLiteral("%1 at %2, %3: ").arg(toQString(buffer.name.text())).arg(pixel.x).arg(pixel.y) +
           (isDrawn ? numbers.join(' ') : clearedText(numbers.join(' ')));
}

QString whyNoValue(const pipeline::BufferInfo& info) {
    switch (info.domain) {
        case pipeline::Domain::Pixel: return {};
        case pipeline::Domain::Texel: return "The texels of a shadow buffer are not those of the picture.";
        case pipeline::Domain::Polygon:
        case pipeline::Domain::Vertex: break;
    }
    return "This buffer stands on polygons or vertices and has no pixels.";
}

}  // namespace app
