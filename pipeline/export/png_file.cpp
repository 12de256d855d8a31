#include "pipeline/export/png_file.h"

#include <png.h>

#include <array>
#include <csetjmp>
#include <string>
#include <vector>

#include "pipeline/core/text.h"
#include "pipeline/core/version.h"
#include "pipeline/export/byte_file.h"

namespace pipeline {

namespace {

struct Texts {
    std::array<std::string, 4> values;
    std::array<png_text, 4> chunks{};
};

void describe(const ExportItem& item, Texts& texts) {
    static std::array<std::string, 4> keys{"Title", "Software", "Palette", "Range"};
    texts.values = {item.buffer.name.text(), "Shadescope " + std::string(programVersion()),
                    std::string(paletteName(item.buffer.info->palette)),
                    shortestText(item.range.first) + ' ' + shortestText(item.range.last)};
    for (std::size_t i = 0; i < keys.size(); ++i) {
        texts.chunks[i].compression = PNG_TEXT_COMPRESSION_NONE;
        texts.chunks[i].key = keys[i].data();
        texts.chunks[i].text = texts.values[i].data();
        texts.chunks[i].text_length = texts.values[i].size();
    }
}

void append(png_structp png, png_bytep bytes, png_size_t size) {
    auto& out = *static_cast<ByteFile*>(png_get_io_ptr(png));
    out.write(std::as_bytes(std::span(bytes, size)));
    if (!out.good()) png_error(png, "");
}
void flush(png_structp) {}
void fail(png_structp png, png_const_charp) { longjmp(png_jmpbuf(png), 1); }
void ignore(png_structp, png_const_charp) {}

// libpng reports by longjmp: everything with a destructor lives in the caller. False when it
// gave up.
bool encode(png_structp png, png_infop info, const ExportItem& item, std::vector<Color8>& row, Texts& texts,
            ByteFile& out) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    const AnyBuffer& buffer = item.buffer;
    png_set_write_fn(png, &out, append, flush);
    png_set_IHDR(png, info, static_cast<png_uint_32>(buffer.columns()), static_cast<png_uint_32>(buffer.rows()), 8,
                 PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_text(png, info, texts.chunks.data(), static_cast<int>(texts.chunks.size()));
    png_write_info(png, info);
    for (std::size_t y = 0; y < buffer.rows(); ++y) {
        for (std::size_t x = 0; x < row.size(); ++x) row[x] = elementColor(buffer, x, y, item.range);
        png_write_row(png, &row[0].x);
    }
    png_write_end(png, info);
    return true;
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
    std::vector<Color8> row(item.buffer.columns());
    Texts texts;
    describe(item, texts);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    const bool encoded = info && out.good() && encode(png, info, item, row, texts, out);
    png_destroy_write_struct(&png, &info);
    if (!encoded && out.good()) return Error{{file.string()}, "could not write: the picture is too large for PNG", {}};
    return out.close();
}

}  // namespace pipeline
