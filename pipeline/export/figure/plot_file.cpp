#include "pipeline/export/figure/plot_file.h"

#include <cairo-svg.h>
#include <cairo.h>

#include <cmath>
#include <memory>
#include <new>

namespace pipeline {

namespace {

constexpr Color8 rgb(unsigned hex) {
    return {static_cast<std::uint8_t>(hex >> 16), static_cast<std::uint8_t>(hex >> 8), static_cast<std::uint8_t>(hex)};
}

struct DestroyCairo {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using CairoSurface = std::unique_ptr<cairo_surface_t, DestroyCairo>;
using Context = std::unique_ptr<cairo_t, DestroyCairo>;

// What cairo could not do for lack of memory it leaves out, and goes on.
void requireMemory(cairo_status_t status) {
    if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
}

cairo_status_t append(void* text, const unsigned char* bytes, unsigned size) try {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), size);
    return CAIRO_STATUS_SUCCESS;
} catch (const std::bad_alloc&) {
    return CAIRO_STATUS_NO_MEMORY;
}

void setColor(cairo_t* c, Color8 color) { cairo_set_source_rgb(c, color.r / 255.0, color.g / 255.0, color.b / 255.0); }

void draw(cairo_t* c, const PlotLine& line, const PlotColors& colors) {
    setColor(c, colorOf(colors, line.ink));
    cairo_set_line_width(c, line.width);
    std::vector<double> lengths = dashes(line.dash);
    for (double& length : lengths) length *= line.width;
    cairo_set_dash(c, lengths.data(), static_cast<int>(lengths.size()), 0);
    cairo_set_line_cap(c, line.dash == PlotDash::Dotted ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
    for (const Vec2<double>& point : line.points) cairo_line_to(c, point.x, point.y);
    cairo_stroke(c);
}

void draw(cairo_t* c, const PlotMarker& marker, const PlotColors& colors) {
    const double stroke = marker.size / 7;
    const double size = marker.filled ? marker.size : marker.size - stroke;
    const std::vector<Vec2<double>> corners = outline(marker.shape);
    cairo_new_path(c);
    if (corners.empty()) cairo_arc(c, marker.at.x, marker.at.y, size / 2, 0, 2 * M_PI);
    for (const Vec2<double>& corner : corners)
        cairo_line_to(c, marker.at.x + size * corner.x, marker.at.y + size * corner.y);
    cairo_close_path(c);
    cairo_set_dash(c, nullptr, 0, 0);
    cairo_set_line_width(c, stroke);
    setColor(c, marker.filled ? colorOf(colors, marker.ink) : colors.background);
    cairo_fill_preserve(c);
    // A filled one gets an edge of background, which sets it off from lines and neighbours.
    setColor(c, marker.filled ? colors.background : colorOf(colors, marker.ink));
    cairo_set_line_width(c, marker.filled ? stroke / 2 : stroke);
    cairo_stroke(c);
}

void draw(cairo_t* c, const PlotText& text, const PlotColors& colors) {
    cairo_select_font_face(c, "Inter", CAIRO_FONT_SLANT_NORMAL,
                           text.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(c, text.size);
    cairo_text_extents_t extents;
    cairo_text_extents(c, text.text.c_str(), &extents);
    const double share = text.anchor == PlotText::Anchor::Start ? 0 : text.anchor == PlotText::Anchor::Middle ? 0.5 : 1;
    cairo_save(c);
    cairo_translate(c, text.at.x, text.at.y);
    if (text.upwards) cairo_rotate(c, -M_PI / 2);
    cairo_move_to(c, -share * extents.x_advance, 0);
    cairo_text_path(c, text.text.c_str());
    // A rim of background keeps lines that cross a text away from its letters.
    setColor(c, colors.background);
    cairo_set_dash(c, nullptr, 0, 0);
    cairo_set_line_width(c, text.size / 4);
    cairo_stroke_preserve(c);
    setColor(c, colorOf(colors, text.ink));
    cairo_fill(c);
    cairo_restore(c);
}

void paint(cairo_surface_t* surface, const PlotDrawing& drawing, const PlotColors& colors, double scale) {
    const Context context(cairo_create(surface));
    cairo_t* c = context.get();
    cairo_scale(c, scale, scale);
    setColor(c, colors.background);
    cairo_paint(c);
    cairo_set_line_join(c, CAIRO_LINE_JOIN_ROUND);
    for (const PlotLine& line : drawing.lines) draw(c, line, colors);
    for (const PlotMarker& marker : drawing.markers) draw(c, marker, colors);
    for (const PlotText& text : drawing.texts) draw(c, text, colors);
    requireMemory(cairo_status(c));
}

}  // namespace

const PlotColors& plotColors(PlotTheme theme) {
    static const PlotColors light{
        rgb(0xFFFFFF), rgb(0x171A1F),
        rgb(0x4A525D), rgb(0xD0D5DC),
        rgb(0x171A1F), rgb(0x5E6672),
        rgb(0xB3261E), {rgb(0x7A6718), rgb(0x137C71), rgb(0x7A47DC), rgb(0x7A0C12), rgb(0x174C72)}};
    static const PlotColors dark{
        rgb(0x101215), rgb(0xE9EBEE),
        rgb(0xB4BBC6), rgb(0x353A43),
        rgb(0xE9EBEE), rgb(0x929AA6),
        rgb(0xFF857C), {rgb(0xFFD98C), rgb(0x44A590), rgb(0x9D83F8), rgb(0xF07426), rgb(0x8FDDFF)}};
    static const PlotColors projector{
        rgb(0xFFFFFF), rgb(0x000000),
        rgb(0x23282E), rgb(0xA3AAB4),
        rgb(0x000000), rgb(0x434A53),
        rgb(0x861212), {rgb(0x575402), rgb(0x0A3516), rgb(0x3C093E), rgb(0x7E393F), rgb(0x14557E)}};
    return theme == PlotTheme::Light ? light : theme == PlotTheme::Dark ? dark : projector;
}

Color8 colorOf(const PlotColors& colors, PlotInk ink) {
    switch (ink.role) {
        case PlotRole::Text: return colors.text;
        case PlotRole::Secondary: return colors.secondary;
        case PlotRole::Grid: return colors.grid;
        case PlotRole::Front: return colors.front;
        case PlotRole::Equal: return colors.equal;
        case PlotRole::Failed: return colors.failed;
        case PlotRole::Series: return colors.series[ink.series % kPlotColors];
    }
    return colors.text;
}

std::string plotSvg(const PlotDrawing& drawing, PlotTheme theme) {
    std::string bytes;
    const CairoSurface surface(cairo_svg_surface_create_for_stream(append, &bytes, drawing.width, drawing.height));
    paint(surface.get(), drawing, plotColors(theme), 1);
    cairo_surface_finish(surface.get());
    requireMemory(cairo_surface_status(surface.get()));
    return bytes;
}

std::string plotPng(const PlotDrawing& drawing, PlotTheme theme, double pixelsPerPoint) {
    std::string bytes;
    const CairoSurface surface(
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(std::ceil(drawing.width * pixelsPerPoint)),
                                   static_cast<int>(std::ceil(drawing.height * pixelsPerPoint))));
    paint(surface.get(), drawing, plotColors(theme), pixelsPerPoint);
    const cairo_status_t status = cairo_surface_write_to_png_stream(surface.get(), append, &bytes);
    requireMemory(status);
    if (status != CAIRO_STATUS_SUCCESS) bytes.clear();
    return bytes;
}

}  // namespace pipeline
