#include "pipeline/export/buffers/png_file.h"

#include <png.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <csetjmp>
#include <functional>
#include <new>
#include <span>
#include <string>
#include <vector>

#include "pipeline/core/text.h"
#include "pipeline/core/version.h"
#include "pipeline/export/buffers/byte_file.h"

namespace pipeline {

namespace {

struct Texts {
    std::vector<PngText> values;  // the chunks point into them
    std::vector<png_text> chunks;
};

// In UTF-8 and packed what is for this program; the others are for people with a viewer.
png_text chunkOf(PngText& value, bool packed) {
    static char none[] = "";
    png_text chunk{};
    chunk.compression = packed ? PNG_ITXT_COMPRESSION_zTXt : PNG_TEXT_COMPRESSION_NONE;
    chunk.key = value.key.data();
    chunk.text = value.text.data();
    (packed ? chunk.itxt_length : chunk.text_length) = value.text.size();
    if (packed) chunk.lang = chunk.lang_key = none;
    return chunk;
}

void describe(const ExportItem& item, Texts& texts) {
    texts.values = {{"Title", item.buffer.name.text()},
                    {"Software", "Shadescope " + std::string(programVersion())},
                    {"Palette", std::string(paletteName(item.buffer.info->palette))},
                    {"Range", shortestText(item.range.first) + ' ' + shortestText(item.range.last)}};
    const std::size_t plain = texts.values.size();
    if (item.scene) texts.values.push_back({kSceneChunk, *item.scene});
    if (item.scene && item.state) texts.values.push_back({kStateChunk, *item.state});
    for (std::size_t i = 0; i < texts.values.size(); ++i) texts.chunks.push_back(chunkOf(texts.values[i], i >= plain));
}

// What is written, and where to.
struct Picture8 {
    std::size_t columns, rows;
    std::size_t channels;  // 3, or 4 with transparency
    std::function<void(std::size_t row, std::vector<png_byte>& bytes)> fill;
    std::function<bool(std::span<const std::byte>)> put;  // false: give up
    Packing packing = Packing::Small;
};

void append(png_structp png, png_bytep bytes, png_size_t size) {
    const auto& picture = *static_cast<const Picture8*>(png_get_io_ptr(png));
    if (!picture.put(std::as_bytes(std::span(bytes, size)))) png_error(png, "");
}
void flush(png_structp) {}
void fail(png_structp png, png_const_charp) { longjmp(png_jmpbuf(png), 1); }
void ignore(png_structp, png_const_charp) {}

// libpng reports by longjmp: everything with a destructor lives in the caller. False when it
// gave up.
bool encode(png_structp png, png_infop info, Picture8& picture, std::vector<png_byte>& row, Texts* texts) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_write_fn(png, &picture, append, flush);
    png_set_IHDR(png, info, static_cast<png_uint_32>(picture.columns), static_cast<png_uint_32>(picture.rows), 8,
                 picture.channels == 4 ? PNG_COLOR_TYPE_RGBA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    // The other two filters take a third more time, and make these pictures no smaller.
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE | PNG_FILTER_SUB | PNG_FILTER_UP);
    if (picture.packing == Packing::Fast) {
        png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
        png_set_compression_level(png, 1);
    }
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    if (texts) png_set_text(png, info, texts->chunks.data(), int(texts->chunks.size()));
    png_write_info(png, info);
    for (std::size_t y = 0; y < picture.rows; ++y) {
        if (WriterWatch::stopped(picture.columns)) return false;  // of an even picture hardly a byte comes out
        picture.fill(y, row);
        png_write_row(png, row.data());
    }
    png_write_end(png, info);
    return true;
}

bool writePicture(Picture8 picture, Texts* texts) {
    std::vector<png_byte> row(picture.columns * picture.channels);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    const bool encoded = info && encode(png, info, picture, row, texts);
    png_destroy_write_struct(&png, &info);
    return encoded;
}

}  // namespace

// Flat areas pack well; this is what smooth ones come to.
std::uint64_t pngEstimate(const AnyBuffer& buffer) { return 1000 + buffer.rows() * buffer.columns() * 3 / 2; }

Result<std::uint64_t> writePng(const ExportItem& item, const std::filesystem::path& file) {
    ByteFile out(file);
    Texts texts;
    describe(item, texts);
    const auto fill = [&](std::size_t y, std::vector<png_byte>& row) {
        for (std::size_t x = 0; x < item.buffer.columns(); ++x) {
            const Color8 color = elementColor(item.buffer, x, y, item.range);
            for (std::size_t c = 0; c < 3; ++c) row[3 * x + c] = color[int(c)];
        }
    };
    const auto put = [&](std::span<const std::byte> bytes) {
        out.write(bytes);
        return out.good();
    };
    const bool encoded = out.good() && writePicture({item.buffer.columns(), item.buffer.rows(), 3, fill, put}, &texts);
    if (WriterWatch::stopped(0)) return writeError(file, ECANCELED);
    if (!encoded && out.good())
        return Error{{file.string()},
                     "could not write: the picture is too large for PNG, or there is not enough memory"};
    return out.close();
}

namespace {

// The file's bytes. A picture that a frame has is not too large for libpng, which gives up for lack of memory alone.
std::string bytesOf(std::size_t columns, std::size_t rows, std::size_t channels,
                    std::function<void(std::size_t, std::vector<png_byte>&)> fill, Texts* texts,
                    Packing packing = Packing::Small) {
    std::string bytes;
    const auto put = [&](std::span<const std::byte> more) {
        try {
            bytes.append(reinterpret_cast<const char*>(more.data()), more.size());
            return true;
        } catch (const std::bad_alloc&) {  // not through libpng, which is C
            return false;
        }
    };
    if (!writePicture({columns, rows, channels, std::move(fill), put, packing}, texts)) throw std::bad_alloc();
    return bytes;
}

}  // namespace

std::string pngOf(const Buffer2D<Color8>& picture, Packing packing) {
    const auto fill = [&](std::size_t y, std::vector<png_byte>& row) {
        for (int x = 0; x < picture.size.x; ++x)
            for (int c = 0; c < 3; ++c) row[std::size_t(x) * 3 + std::size_t(c)] = picture.at({x, int(y)})[c];
    };
    return bytesOf(std::size_t(picture.size.x), std::size_t(picture.size.y), 3, fill, nullptr, packing);
}

std::string pngOf(std::span<const std::uint8_t> rgba, glm::ivec2 size, const std::vector<PngText>& texts) {
    assert(rgba.size() == std::size_t(size.x) * std::size_t(size.y) * 4);
    Texts carried{texts, {}};
    for (PngText& text : carried.values) carried.chunks.push_back(chunkOf(text, true));
    const auto fill = [&](std::size_t y, std::vector<png_byte>& row) {
        std::copy_n(rgba.begin() + std::ptrdiff_t(y * row.size()), row.size(), row.begin());
    };
    return bytesOf(std::size_t(size.x), std::size_t(size.y), 4, fill, &carried);
}

}  // namespace pipeline
