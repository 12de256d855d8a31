// TGA and BMP, as small renderers write them.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "pipeline/formats/numbers/number_file.h"
#include "pipeline/formats/text/bytes.h"

namespace pipeline {

namespace {

// A picture of so many pixels with this many bytes each, in the file's order: blue first, rows upwards or not.
struct Bitmap {
    std::size_t width = 0, height = 0, bytesOfPixel = 0;
    bool bottomUp = false, mirrored = false;
};

std::optional<Error> wrongExtent(const Bitmap& bitmap, const std::string& name, std::size_t at, std::size_t most) {
    if (bitmap.width == 0 || bitmap.height == 0) return wrongAt(name, at, "no size", "width and height");
    if (bitmap.width > most / 4 / bitmap.height)
        return wrongAt(name, at, fmt::format("a picture of {} × {}", bitmap.width, bitmap.height),
                       fmt::format("at most {} pixels", most / 4));
    return {};
}

// `pixelAt` gives the offset of the pixel that stands at a column and a row of the file.
template <class PixelAt>
NumberFile numbersOf(const Bitmap& bitmap, const std::string& name, std::string_view bytes, const PixelAt& pixelAt) {
    NumberFile file{name, {bitmap.height, bitmap.width}, {}};
    file.kind = NumberKind::Levels8;
    const std::size_t channels = bitmap.bytesOfPixel >= 3 ? 3 : 1;
    if (channels == 3) file.shape.push_back(3);
    file.values.reserve(bitmap.width * bitmap.height * channels);
    for (std::size_t y = 0; y < bitmap.height; ++y)
        for (std::size_t x = 0; x < bitmap.width; ++x) {
            const std::size_t at =
                pixelAt(bitmap.mirrored ? bitmap.width - 1 - x : x, bitmap.bottomUp ? bitmap.height - 1 - y : y);
            for (std::size_t c = channels; c-- > 0;) file.values.push_back(numberAt<std::uint8_t>(bytes, at + c));
        }
    return file;
}

}  // namespace

Result<NumberFile> readTga(std::string_view bytes, const std::string& name, std::size_t most) {
    constexpr std::size_t kHeader = 18, kMostRun = 128;
    if (bytes.size() < kHeader) return wrongAt(name, bytes.size(), "the end of the file", "a header of 18 bytes");
    const auto byte = [&](std::size_t at) { return numberAt<std::uint8_t>(bytes, at); };
    const int kind = byte(2) & ~8;
    const bool isPacked = (byte(2) & 8) != 0, isGrey = kind == 3;
    if (byte(1) != 0 || (kind != 2 && kind != 3))
        return wrongAt(name, 1, "a TGA picture with a palette, or none", "colours or greys, packed or not");
    const int bits = byte(16);
    if (isGrey ? bits != 8 : bits != 24 && bits != 32)
        return wrongAt(name, 16, fmt::format("{} bits for each pixel", bits), isGrey ? "8" : "24 or 32");
    const Bitmap bitmap{numberAt<std::uint16_t>(bytes, 12), numberAt<std::uint16_t>(bytes, 14), std::size_t(bits / 8),
                        (byte(17) & 0x20) == 0, (byte(17) & 0x10) != 0};
    if (const auto wrong = wrongExtent(bitmap, name, 12, most)) return *wrong;
    const std::size_t start = kHeader + byte(0), size = bitmap.bytesOfPixel, count = bitmap.width * bitmap.height;
    if (!isPacked) {
        if (!hasBytes(bytes, start, count * size))
            return wrongAt(name, bytes.size(), "the end of the file", fmt::format("{} bytes of pixels", count * size));
        return numbersOf(bitmap, name, bytes,
                         [&](std::size_t x, std::size_t y) { return start + (y * bitmap.width + x) * size; });
    }
    std::vector<std::size_t> pixels;  // offsets
    if (bytes.size() / (1 + size) < count / kMostRun / 2)
        return wrongAt(name, bytes.size(), "the end of the file", fmt::format("{} pixels", count));
    pixels.reserve(count);
    for (std::size_t at = start; pixels.size() < count;) {
        if (!hasBytes(bytes, at, 1)) return wrongAt(name, at, "the end of the file", fmt::format("{} pixels", count));
        const std::size_t run = (byte(at) & 127u) + 1;
        const bool isRepeated = byte(at) >= 128;
        if (!hasBytes(bytes, ++at, (isRepeated ? 1 : run) * size) || run > count - pixels.size())
            return wrongAt(name, at, "a packet that does not fit", fmt::format("{} pixels", count));
        for (std::size_t i = 0; i < run; ++i) pixels.push_back(isRepeated ? at : at + i * size);
        at += (isRepeated ? 1 : run) * size;
    }
    return numbersOf(bitmap, name, bytes, [&](std::size_t x, std::size_t y) { return pixels[y * bitmap.width + x]; });
}

Result<NumberFile> readBmp(std::string_view bytes, const std::string& name, std::size_t most) {
    constexpr std::size_t kHeaders = 14 + 40;
    if (!bytes.starts_with("BM") || bytes.size() < kHeaders) return wrongAt(name, 0, "no BMP file", "its header");
    const auto word = [&](std::size_t at) { return numberAt<std::uint32_t>(bytes, at); };
    const auto wide = std::int64_t(numberAt<std::int32_t>(bytes, 18)),
               high = std::int64_t(numberAt<std::int32_t>(bytes, 22));
    const int bits = numberAt<std::uint16_t>(bytes, 28);
    const std::uint32_t packing = word(30);
    // Masks of colours, as 32 bits have them: blue in the lowest byte.
    const bool hasMasks = packing == 3 && bits == 32 && hasBytes(bytes, 54, 12) && word(54) == 0xff0000 &&
                          word(58) == 0xff00 && word(62) == 0xff;
    if ((bits != 8 && bits != 24 && bits != 32) || (packing != 0 && !hasMasks))
        return wrongAt(name, 28, fmt::format("{} bits for each pixel, packing {}", bits, packing),
                       "8, 24 or 32 bits, not packed");
    const Bitmap bitmap{std::size_t(std::max<std::int64_t>(0, wide)), std::size_t(high < 0 ? -high : high),
                        std::size_t(bits / 8), high > 0, false};
    if (const auto wrong = wrongExtent(bitmap, name, 18, most)) return *wrong;
    const std::size_t start = word(10), line = (bitmap.width * bitmap.bytesOfPixel + 3) / 4 * 4;
    if (!hasBytes(bytes, start, line * bitmap.height))
        return wrongAt(name, bytes.size(), "the end of the file",
                       fmt::format("{} bytes of pixels", line * bitmap.height));
    const auto at = [&](std::size_t x, std::size_t y) { return start + y * line + x * bitmap.bytesOfPixel; };
    if (bits != 8) return numbersOf(bitmap, name, bytes, at);
    const std::size_t palette = 14 + std::size_t(word(14));
    std::size_t last = 0;
    for (std::size_t y = 0; y < bitmap.height; ++y)
        for (std::size_t x = 0; x < bitmap.width; ++x)
            last = std::max<std::size_t>(last, numberAt<std::uint8_t>(bytes, at(x, y)));
    if (!hasBytes(bytes, palette, 4 * (last + 1)))
        return wrongAt(name, palette, "the end of the file", fmt::format("a palette of {} colours", last + 1));
    Bitmap coloured = bitmap;
    coloured.bytesOfPixel = 4;
    return numbersOf(coloured, name, bytes, [&](std::size_t x, std::size_t y) {
        return palette + 4 * std::size_t(numberAt<std::uint8_t>(bytes, at(x, y)));
    });
}

}  // namespace pipeline
