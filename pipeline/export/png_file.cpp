#include "pipeline/export/png_file.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/core/text.h"
#include "pipeline/core/version.h"
#include "pipeline/export/byte_file.h"

namespace pipeline {

namespace {

struct Texts {
    std::array<std::string, 5> values;
    std::array<png_text, 5> chunks{};
    int count = 0;
};

void describe(const ExportItem& item, Texts& texts) {
    static std::array<std::string, 5> keys{"Title", "Software", "Palette", "Range", kSceneChunk};
    static char none[] = "";
    texts.values = {item.buffer.name.text(), "Shadescope " + std::string(programVersion()),
                    std::string(paletteName(item.buffer.info->palette)),
                    shortestText(item.range.first) + ' ' + shortestText(item.range.last),
                    item.scene ? *item.scene : std::string()};
    texts.count = item.scene ? 5 : 4;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        texts.chunks[i].compression = PNG_TEXT_COMPRESSION_NONE;
        texts.chunks[i].key = keys[i].data();
        texts.chunks[i].text = texts.values[i].data();
        texts.chunks[i].text_length = texts.values[i].size();
    }
    // In UTF-8, and packed: the other chunks are for people with a viewer, this one is for this program.
    png_text& scene = texts.chunks[4];
    scene.compression = PNG_ITXT_COMPRESSION_zTXt;
    scene.itxt_length = scene.text_length, scene.text_length = 0;
    scene.lang = scene.lang_key = none;
}

// What is written, and where to.
struct Picture8 {
    std::size_t columns, rows;
    std::function<void(std::size_t row, std::vector<Color8>& colors)> fill;
    std::function<bool(std::span<const std::byte>)> put;  // false: give up
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
bool encode(png_structp png, png_infop info, Picture8& picture, std::vector<Color8>& row, Texts* texts) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_write_fn(png, &picture, append, flush);
    png_set_IHDR(png, info, static_cast<png_uint_32>(picture.columns), static_cast<png_uint_32>(picture.rows), 8,
                 PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    if (texts) png_set_text(png, info, texts->chunks.data(), texts->count);
    png_write_info(png, info);
    for (std::size_t y = 0; y < picture.rows; ++y) {
        picture.fill(y, row);
        png_write_row(png, &row[0].x);
    }
    png_write_end(png, info);
    return true;
}

bool writePicture(Picture8 picture, Texts* texts) {
    std::vector<Color8> row(picture.columns);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    const bool encoded = info && encode(png, info, picture, row, texts);
    png_destroy_write_struct(&png, &info);
    return encoded;
}

}  // namespace

std::string_view paletteName(Palette palette) {
    switch (palette) {
        case Palette::Sequential: return "ember";
        case Palette::Diverging: return "slope";
        case Palette::Categorical: return "eight";
        case Palette::Verdict: return "verdict";
        case Palette::Direction: return "direction";
        case Palette::Color: return "color";
    }
    return {};
}

// Flat areas pack well; this is what smooth ones come to.
std::uint64_t pngEstimate(const AnyBuffer& buffer) { return 1000 + buffer.rows() * buffer.columns() * 3 / 2; }

Result<std::uint64_t> writePng(const ExportItem& item, const std::filesystem::path& file) {
    ByteFile out(file);
    Texts texts;
    describe(item, texts);
    const auto fill = [&](std::size_t y, std::vector<Color8>& row) {
        for (std::size_t x = 0; x < row.size(); ++x) row[x] = elementColor(item.buffer, x, y, item.range);
    };
    const auto put = [&](std::span<const std::byte> bytes) {
        out.write(bytes);
        return out.good();
    };
    const bool encoded = out.good() && writePicture({item.buffer.columns(), item.buffer.rows(), fill, put}, &texts);
    if (!encoded && out.good()) return Error{{file.string()}, "could not write: the picture is too large for PNG", {}};
    return out.close();
}

std::string pngOf(const Buffer2D<Color8>& picture) {
    std::string bytes;
    const auto fill = [&](std::size_t y, std::vector<Color8>& row) {
        std::copy_n(picture.pixels.begin() + std::ptrdiff_t(y * row.size()), row.size(), row.begin());
    };
    const auto put = [&](std::span<const std::byte> more) {
        bytes.append(reinterpret_cast<const char*>(more.data()), more.size());
        return true;
    };
    if (!writePicture({std::size_t(picture.size.x), std::size_t(picture.size.y), fill, put}, nullptr)) return {};
    return bytes;
}

}  // namespace pipeline
