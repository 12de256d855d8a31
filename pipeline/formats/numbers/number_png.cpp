#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <span>

#include "pipeline/formats/numbers/inflate.h"
#include "pipeline/formats/numbers/number_file.h"
#include "pipeline/formats/text/bytes.h"

// PNG (ISO/IEC 15948) without a library: the same reader, with the same words, in the program and in a browser.

namespace pipeline {

namespace {

constexpr std::size_t kChunk = 12;  // length, type and check sum of a chunk

std::uint32_t crc(std::string_view bytes) {
    std::uint32_t sum = ~0u;
    for (const char byte : bytes) {
        sum ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1) ^ (sum & 1 ? 0xEDB88320u : 0u);
    }
    return ~sum;
}

struct PngFile {
    std::size_t width = 0, height = 0;
    unsigned depth = 0, type = 0;
    bool interlaced = false;
    std::string_view palette;
    std::string packed;
    std::size_t at = 8;  // of the chunk that is read, for messages

    std::size_t samples() const { return type == 2 ? 3 : type == 6 ? 4 : type == 4 ? 2 : 1; }
    std::size_t lineBytes(std::size_t columns) const { return (columns * samples() * depth + 7) / 8; }
    bool isKnown() const {
        const bool small = depth == 1 || depth == 2 || depth == 4, whole = depth == 8 || depth == 16;
        return type == 0   ? small || whole
               : type == 3 ? small || depth == 8
                           : (type == 2 || type == 4 || type == 6) && whole;
    }
};

// The chunks up to the end of the pixels; those that say nothing of them are passed over.
bool readChunks(std::string_view bytes, PngFile& png) {
    for (;; png.at += kChunk) {
        if (!hasBytes(bytes, png.at, kChunk)) return !png.packed.empty();
        const std::size_t size = numberAt<std::uint32_t>(bytes, png.at, std::endian::big);
        const std::string_view kind = bytes.substr(png.at + 4, 4);
        if (kind != "IDAT" && !png.packed.empty()) return true;
        if (!hasBytes(bytes, png.at + kChunk, size)) return false;
        const std::string_view chunk = bytes.substr(png.at + 8, size);
        const bool matters = kind == "IHDR" || kind == "PLTE" || kind == "IDAT";
        if (matters && crc(bytes.substr(png.at + 4, 4 + size)) !=
                           numberAt<std::uint32_t>(bytes, png.at + 8 + size, std::endian::big))
            return false;
        if ((kind == "IHDR") != (png.at == 8)) return false;
        if (kind == "IHDR") {
            if (size != 13) return false;
            png.width = numberAt<std::uint32_t>(chunk, 0, std::endian::big);
            png.height = numberAt<std::uint32_t>(chunk, 4, std::endian::big);
            png.depth = static_cast<unsigned char>(chunk[8]), png.type = static_cast<unsigned char>(chunk[9]);
            png.interlaced = chunk[12] != 0;
            if (!png.isKnown() || png.width == 0 || png.height == 0 || chunk[10] != 0 || chunk[11] != 0) return false;
        }
        if (kind == "PLTE") png.palette = chunk;
        if (kind == "IDAT") png.packed += chunk;
        png.at += size;
    }
}

// The pixels of every `step`-th column and row: the whole picture, or a pass of an interlaced one.
struct Pass {
    std::size_t x, y, stepX, stepY;
    std::size_t columns(const PngFile& png) const { return png.width > x ? (png.width - x + stepX - 1) / stepX : 0; }
    std::size_t rows(const PngFile& png) const { return png.height > y ? (png.height - y + stepY - 1) / stepY : 0; }
    std::size_t bytes(const PngFile& png) const {
        return columns(png) == 0 ? 0 : rows(png) * (png.lineBytes(columns(png)) + 1);
    }
};
constexpr std::array kWhole{Pass{0, 0, 1, 1}};
constexpr std::array kAdam7{Pass{0, 0, 8, 8}, Pass{4, 0, 8, 8}, Pass{0, 4, 4, 8}, Pass{2, 0, 4, 4},
                            Pass{0, 2, 2, 4}, Pass{1, 0, 2, 2}, Pass{0, 1, 1, 2}};

int paeth(int a, int b, int c) {
    const int p = a + b - c, toA = std::abs(p - a), toB = std::abs(p - b), toC = std::abs(p - c);
    return toA <= toB && toA <= toC ? a : toB <= toC ? b : c;
}

// A line of bytes out of its filter. before: the line above.
bool unfilter(const unsigned char* in, std::size_t step, const std::vector<std::uint8_t>& before,
              std::vector<std::uint8_t>& line) {
    if (in[0] > 4) return false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const int a = i < step ? 0 : line[i - step], b = before[i], c = i < step ? 0 : before[i - step];
        const int add = in[0] == 1 ? a : in[0] == 2 ? b : in[0] == 3 ? (a + b) / 2 : in[0] == 4 ? paeth(a, b, c) : 0;
        line[i] = std::uint8_t(in[i + 1] + add);
    }
    return true;
}

// Channel `c` of the x-th pixel in a line, 0 to 255 or 65535; below 0: a colour that the palette has not.
double sampleAt(const PngFile& png, const std::vector<std::uint8_t>& line, std::size_t x, std::size_t c) {
    const std::size_t sample = x * png.samples() + (png.type == 3 ? 0 : c);
    if (png.depth == 16) return line[2 * sample] * 256.0 + line[2 * sample + 1];
    const std::size_t bit = sample * png.depth;
    const unsigned highest = (1u << png.depth) - 1;
    const unsigned value = (unsigned(line[bit / 8]) >> (8 - png.depth - bit % 8)) & highest;
    if (png.type != 3) return value * 255 / highest;
    return 3 * value + 2 < png.palette.size() ? double(static_cast<unsigned char>(png.palette[3 * value + c])) : -1;
}

}  // namespace

Result<NumberFile> readPngNumbers(std::string_view bytes, const std::string& name, std::size_t most) {
    if (!bytes.starts_with("\x89PNG\r\n\x1a\n")) return wrongAt(name, 0, "no PNG file", "its signature");
    PngFile png;
    const bool whole = readChunks(bytes, png);
    const auto damaged = [&] {
        return wrongAt(name, std::min(png.at, bytes.size()), "a damaged picture", "a PNG file");
    };
    if (png.height != 0 && png.width > most / png.height / 4)
        return wrongAt(name, 16, fmt::format("a picture of {} × {}", png.width, png.height),
                       fmt::format("at most {} pixels", most / 4));
    if (!whole) return damaged();
    const std::span<const Pass> passes = png.interlaced ? std::span<const Pass>(kAdam7) : kWhole;
    std::size_t size = 0;
    for (const Pass& pass : passes) size += pass.bytes(png);
    const auto raw = inflated(png.packed, size);
    if (!raw) return damaged();
    const std::size_t channels = png.type == 0 || png.type == 4 ? 1 : 3;  // without alpha
    NumberFile file{name, {png.height, png.width}, {}};
    if (channels > 1) file.shape.push_back(channels);
    file.kind = png.depth == 16 ? NumberKind::Levels16 : NumberKind::Levels8;
    file.values.resize(png.width * png.height * channels);
    const auto* in = reinterpret_cast<const unsigned char*>(raw->data());
    for (const Pass& pass : passes) {
        const std::size_t columns = pass.columns(png), step = std::max<std::size_t>(1, png.samples() * png.depth / 8);
        std::vector<std::uint8_t> before(png.lineBytes(columns)), line(before.size());
        for (std::size_t row = 0; columns > 0 && row < pass.rows(png); ++row, in += line.size() + 1) {
            if (!unfilter(in, step, before, line)) return damaged();
            double* const to = &file.values[(pass.y + row * pass.stepY) * png.width * channels];
            for (std::size_t i = 0; i < columns * channels; ++i) {
                const double value = sampleAt(png, line, i / channels, i % channels);
                if (value < 0) return damaged();
                to[(pass.x + i / channels * pass.stepX) * channels + i % channels] = value;
            }
            std::swap(before, line);
        }
    }
    return file;
}

}  // namespace pipeline
