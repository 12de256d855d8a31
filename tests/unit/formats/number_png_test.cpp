// PNG without a library, against pictures that libpng has written: every kind of pixel, interlaced or not, packed in every way.
#include <gtest/gtest.h>
#include <png.h>

#include <random>

#include "pipeline/formats/numbers/number_file.h"

namespace pipeline {
namespace {

struct Kind {
    int type, depth;
};
constexpr Kind kKinds[]{{PNG_COLOR_TYPE_GRAY, 1},      {PNG_COLOR_TYPE_GRAY, 2},       {PNG_COLOR_TYPE_GRAY, 4},
                        {PNG_COLOR_TYPE_GRAY, 8},      {PNG_COLOR_TYPE_GRAY, 16},      {PNG_COLOR_TYPE_PALETTE, 1},
                        {PNG_COLOR_TYPE_PALETTE, 4},   {PNG_COLOR_TYPE_PALETTE, 8},    {PNG_COLOR_TYPE_RGB, 8},
                        {PNG_COLOR_TYPE_RGB, 16},      {PNG_COLOR_TYPE_GRAY_ALPHA, 8}, {PNG_COLOR_TYPE_GRAY_ALPHA, 16},
                        {PNG_COLOR_TYPE_RGB_ALPHA, 8}, {PNG_COLOR_TYPE_RGB_ALPHA, 16}};
enum Packing { Stored, Fixed, Dynamic };

// Samples of a picture, each 0 to 2^depth − 1, and its file.
struct Picture {
    int width, height, channels;
    std::vector<unsigned> samples;
    std::string file;
    unsigned at(int x, int y, int c) const { return samples[std::size_t((y * width + x) * channels + c)]; }
};

void append(png_structp png, png_bytep bytes, png_size_t size) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), size);
}

// Runs of equal samples between random ones: the packer finds both new bytes and repetitions.
Picture written(Kind kind, int width, int height, bool interlaced, Packing packing) {
    const int channels = kind.type == PNG_COLOR_TYPE_RGB          ? 3
                         : kind.type == PNG_COLOR_TYPE_RGB_ALPHA  ? 4
                         : kind.type == PNG_COLOR_TYPE_GRAY_ALPHA ? 2
                                                                  : 1;
    Picture picture{width, height, channels, {}, {}};
    std::mt19937 random(unsigned(kind.type * 100 + kind.depth));
    for (int i = 0; i < width * height * channels; ++i)
        picture.samples.push_back(i % 7 < 3 && i > 40 ? picture.samples[std::size_t(i - 40)]
                                                      : unsigned(random()) & ((1u << kind.depth) - 1));
    std::vector<std::vector<png_byte>> lines;
    for (int y = 0; y < height; ++y) {
        std::vector<png_byte> line(std::size_t(width * channels * kind.depth + 7) / 8);
        for (int i = 0; i < width * channels; ++i) {
            const unsigned sample = picture.samples[std::size_t(y * width * channels + i)];
            const auto bit = std::size_t(i * kind.depth);
            if (kind.depth == 16)
                line[bit / 8] = png_byte(sample >> 8), line[bit / 8 + 1] = png_byte(sample);
            else
                line[bit / 8] = png_byte(line[bit / 8] | sample << (8 - std::size_t(kind.depth) - bit % 8));
        }
        lines.push_back(line);
    }
    std::vector<png_bytep> rows;
    for (auto& line : lines) rows.push_back(line.data());
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &picture.file, append, nullptr);
    png_set_IHDR(png, info, png_uint_32(width), png_uint_32(height), kind.depth, kind.type,
                 interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_BASE,
                 PNG_FILTER_TYPE_BASE);
    if (kind.type == PNG_COLOR_TYPE_PALETTE) {
        std::vector<png_color> palette(std::size_t{1} << kind.depth);
        for (std::size_t i = 0; i < palette.size(); ++i)
            palette[i] = {png_byte(i * 3), png_byte(255 - i), png_byte(i * 7)};
        png_set_PLTE(png, info, palette.data(), int(palette.size()));
    }
    png_set_filter(png, 0, PNG_ALL_FILTERS);
    png_set_compression_level(png, packing == Stored ? 0 : 9);
    constexpr int kFixedCodes = 4;  // zlib's Z_FIXED
    if (packing == Fixed) png_set_compression_strategy(png, kFixedCodes);
    png_write_info(png, info);
    png_write_image(png, rows.data());
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    return picture;
}

// What the file means, 0 to 255 or 65535, without alpha (ISO/IEC 15948, 13.12).
double meant(const Picture& picture, Kind kind, int x, int y, int c) {
    const unsigned sample = picture.at(x, y, kind.type == PNG_COLOR_TYPE_PALETTE ? 0 : c);
    if (kind.type != PNG_COLOR_TYPE_PALETTE) return kind.depth < 8 ? sample * 255 / ((1u << kind.depth) - 1) : sample;
    return c == 0 ? (sample * 3) & 255 : c == 1 ? 255 - sample : (sample * 7) & 255;
}

TEST(NumberPng, EveryKindOfPixelIsReadAsItWasWritten) {
    for (const Kind kind : kKinds)
        for (const bool interlaced : {false, true})
            for (const Packing packing : {Stored, Fixed, Dynamic})
                for (const auto& [width, height] : {std::pair{37, 19}, {1, 1}, {3, 2}}) {
                    const Picture picture = written(kind, width, height, interlaced, packing);
                    const auto read = readPngNumbers(picture.file, "mine.png", 10000);
                    const std::string where = std::to_string(kind.type) + " " + std::to_string(kind.depth) + " " +
                                              std::to_string(interlaced) + std::to_string(packing) + " " +
                                              std::to_string(width);
                    ASSERT_TRUE(read) << where << format(read.errors());
                    const auto channels =
                        kind.type == PNG_COLOR_TYPE_GRAY || kind.type == PNG_COLOR_TYPE_GRAY_ALPHA ? 1 : 3;
                    ASSERT_EQ(read->values.size(), std::size_t(width * height * channels)) << where;
                    EXPECT_EQ(read->kind, kind.depth == 16 ? NumberKind::Levels16 : NumberKind::Levels8);
                    for (int i = 0; i < width * height * channels; ++i)
                        ASSERT_EQ(read->values[std::size_t(i)],
                                  meant(picture, kind, i / channels % width, i / channels / width, i % channels))
                            << where << " number " << i;
                }
}

TEST(NumberPng, ADamagedOrShortenedFileIsRefusedAtAByte) {
    const Picture picture = written({PNG_COLOR_TYPE_RGB, 8}, 37, 19, false, Dynamic);
    const std::size_t pixels = picture.file.find("IDAT"), end = picture.file.find("IEND") - 4;
    for (std::size_t size = 0; size < end; size += 7) {
        const auto read = readPngNumbers(std::string_view(picture.file).substr(0, size), "mine.png", 10000);
        ASSERT_FALSE(read) << size;
        EXPECT_TRUE(read.errors()[0].where.file.starts_with("mine.png:")) << size;
    }
    // Each byte from the header to the pixels' check sum is under a check sum or is one.
    for (std::size_t at = 12; at < end; ++at) {
        if (at >= 33 && at < pixels - 4) continue;  // chunks that say nothing of the pixels
        std::string spoiled = picture.file;
        spoiled[at] = char(spoiled[at] ^ 16);
        EXPECT_FALSE(readPngNumbers(spoiled, "mine.png", 10000)) << at;
    }
}

TEST(NumberPng, APictureThatAnnouncesMuchIsRefusedBeforeItIsUnpacked) {
    const Picture picture = written({PNG_COLOR_TYPE_RGB, 8}, 37, 19, false, Dynamic);
    const auto read = readPngNumbers(picture.file, "mine.png", 37 * 19 * 4 - 1);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.errors()[0].found, "a picture of 37 × 19");
}

}  // namespace
}  // namespace pipeline
