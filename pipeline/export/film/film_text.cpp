#include "pipeline/export/film/film_text.h"

#include <algorithm>
#include <cstdint>
#include <new>

namespace pipeline {
namespace {

constexpr double kStripGround = 0.09;
constexpr int kPitch = 20, kCode = 13, kStripMargin = 10, kPadding = 6;  // pixels
constexpr double kLit = 0.25, kInk = 0.92, kGrey = 0.55;

}  // namespace

FilmText::FilmText(int width, int height)
    : m_width(width),
      m_height(height),
      m_surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)),
      m_context(cairo_create(m_surface.get())) {
    fill(0, height, kStripGround);
}

void FilmText::setFace(Face face, double size) {
    cairo_select_font_face(m_context.get(), face == Face::Words ? "Inter" : "JetBrains Mono", CAIRO_FONT_SLANT_NORMAL,
                           face == Face::BoldCode ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(m_context.get(), size);
}

double FilmText::widthOf(const std::string& text) const {
    cairo_text_extents_t extents;
    cairo_text_extents(m_context.get(), text.c_str(), &extents);
    return extents.x_advance;
}

void FilmText::write(double x, double base, const std::string& text, double grey) {
    cairo_set_source_rgb(m_context.get(), grey, grey, grey);
    cairo_move_to(m_context.get(), x, base);
    cairo_show_text(m_context.get(), text.c_str());
}

void FilmText::fill(int top, int height, double grey) {
    cairo_set_source_rgb(m_context.get(), grey, grey, grey);
    cairo_rectangle(m_context.get(), 0, top, m_width, height);
    cairo_fill(m_context.get());
}

void FilmText::copyTo(Buffer2D<Color8>& picture, int top) const {
    cairo_surface_flush(m_surface.get());
    if (cairo_status(m_context.get()) == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
    const unsigned char* bytes = cairo_image_surface_get_data(m_surface.get());
    const int stride = cairo_image_surface_get_stride(m_surface.get());
    for (int y = 0; bytes && y < m_height; ++y)
        for (int x = 0; x < m_width; ++x) {
            std::uint32_t argb = 0;
            std::copy_n(bytes + y * stride + 4 * x, 4, reinterpret_cast<unsigned char*>(&argb));
            // A grey of sixteen: the colours of a GIF are for the buffer.
            picture.at({x, top + y}) = Color8(std::uint8_t((argb & 255u) / 17 * 17));
        }
}

int algorithmStripHeight(std::size_t lines) { return 2 * kPadding + kPitch * int(lines); }

void drawAlgorithmStrip(const std::optional<AlgorithmState>& state, std::size_t lines, int top,
                        Buffer2D<Color8>& picture) {
    using Face = FilmText::Face;
    FilmText strip(picture.size.x, algorithmStripHeight(lines));
    int y = kPadding;
    for (const AlgorithmRow& row : state ? rowsOf(*state) : std::vector<AlgorithmRow>()) {
        const bool isLit = row.status == LineStatus::Now;
        if (isLit) strip.fill(y, kPitch, kLit);
        const bool isGrey = row.status == LineStatus::NotTaken || row.status == LineStatus::LeftOut ||
                            row.status == LineStatus::Elsewhere;
        const double base = y + 0.5 * kPitch + 0.35 * kCode;
        strip.setFace(isLit ? Face::BoldCode : Face::Code, kCode);
        const std::string code = std::to_string(row.number) + std::string(row.number < 10 ? 2 : 1, ' ') +
                                 std::string(2 * std::size_t(row.indent), ' ') + row.text;
        strip.write(kStripMargin, base, code, isGrey ? kGrey : kInk);
        const double end = kStripMargin + strip.widthOf(code) + kStripMargin;
        const std::string values = row.valuesText.empty() ? row.remark
                                   : row.taken            ? row.valuesText + "  " + row.remark
                                                          : row.valuesText;
        const double x = picture.size.x - kStripMargin - strip.widthOf(values);
        // What has no room beside its line gives way.
        if (x > end) strip.write(x, base, values, isGrey ? kGrey : kInk);
        y += kPitch;
    }
    strip.copyTo(picture, top);
}

}  // namespace pipeline
