#include "pipeline/export/figure/figure.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <new>

#include "pipeline/export/figure/figure_layout.h"

namespace pipeline {
namespace {

constexpr double kMmPerPoint = 25.4 / 72;
constexpr double kMostPngSide = 32767;  // cairo's
constexpr double kLeastPixel = 1e-3;    // of a pixel's side, in pt
constexpr int kBarStops = 64;

struct FreeFigure {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
    void operator()(cairo_pattern_t* pattern) const { cairo_pattern_destroy(pattern); }
};
using FigureSurface = std::unique_ptr<cairo_surface_t, FreeFigure>;
using FigureContext = std::unique_ptr<cairo_t, FreeFigure>;
using FigurePattern = std::unique_ptr<cairo_pattern_t, FreeFigure>;

cairo_status_t appendBytes(void* text, const unsigned char* bytes, unsigned size) try {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), size);
    return CAIRO_STATUS_SUCCESS;
} catch (const std::bad_alloc&) {
    return CAIRO_STATUS_NO_MEMORY;
}

void setInk(cairo_t* c, Color8 color) { cairo_set_source_rgb(c, color.r / 255.0, color.g / 255.0, color.b / 255.0); }

const PlotColors& inkOf(const Figure& figure) {
    return plotColors(figure.isForProjector ? PlotTheme::Projector : PlotTheme::Light);
}

void write(cairo_t* c, const Figure& figure, double x, double base, const std::string& text) {
    setLetters(c, figure);
    cairo_move_to(c, x, base);
    setInk(c, inkOf(figure).text);
    cairo_show_text(c, text.c_str());
}

// The same over the picture: a rim of paper keeps the letters legible.
void writeOver(cairo_t* c, const Figure& figure, double x, double base, const std::string& text) {
    setLetters(c, figure);
    cairo_move_to(c, x, base);
    cairo_text_path(c, text.c_str());
    setInk(c, inkOf(figure).background);
    cairo_set_line_width(c, 0.3 * figure.letters);
    cairo_stroke(c);
    write(c, figure, x, base, text);
}

// Pixels that nothing was drawn in have the colour of paper. They are not transparent: viewers would mix their black in.
FigureSurface pixelsOf(const Figure& figure, const FigureLayout& layout) {
    FigureSurface pixels(cairo_image_surface_create(CAIRO_FORMAT_RGB24, layout.columns, layout.rows));
    unsigned char* bytes = cairo_image_surface_get_data(pixels.get());
    if (!bytes) throw std::bad_alloc();
    const int stride = cairo_image_surface_get_stride(pixels.get());
    for (int y = 0; y < layout.rows; ++y)
        for (int x = 0; x < layout.columns; ++x) {
            const std::size_t column = std::size_t(layout.first.x + x), row = std::size_t(layout.first.y + y);
            const bool isClear = figure.seen && figure.seen->value(column, row) < 0;
            const Color8 color =
                isClear ? inkOf(figure).background : elementColor(figure.buffer, column, row, figure.range);
            const std::uint32_t argb = unsigned(color.r) << 16 | unsigned(color.g) << 8 | unsigned(color.b);
            std::copy_n(reinterpret_cast<const unsigned char*>(&argb), 4, bytes + y * stride + 4 * x);
        }
    cairo_surface_mark_dirty(pixels.get());
    return pixels;
}

// Between the pixels, much thinner than they are.
void drawGrid(cairo_t* c, const Figure& figure, const FigureLayout& layout) {
    for (int x = 1; x < layout.columns; ++x)
        cairo_move_to(c, layout.left + x * layout.pixel, layout.top), cairo_rel_line_to(c, 0, layout.pictureHeight());
    for (int y = 1; y < layout.rows; ++y)
        cairo_move_to(c, layout.left, layout.top + y * layout.pixel), cairo_rel_line_to(c, layout.pictureWidth(), 0);
    setInk(c, inkOf(figure).text);
    cairo_set_line_width(c, std::min(0.25, layout.pixel / 8));
    cairo_stroke(c);
}

// A rim of paper keeps them apart from a dark picture.
void drawOutlines(cairo_t* c, const Figure& figure, const FigureLayout& layout) {
    for (const Figure::Outline& outline : figure.outlines) {
        cairo_new_sub_path(c);
        for (const glm::dvec2& corner : outline)
            cairo_line_to(c, layout.left + (corner.x - layout.first.x) * layout.pixel,
                          layout.top + (corner.y - layout.first.y) * layout.pixel);
        cairo_close_path(c);
    }
    cairo_set_line_join(c, CAIRO_LINE_JOIN_ROUND);
    setInk(c, inkOf(figure).background);
    cairo_set_line_width(c, 1.25);
    cairo_stroke_preserve(c);
    setInk(c, inkOf(figure).text);
    cairo_set_line_width(c, 0.5);
    cairo_stroke(c);
}

void drawLines(cairo_t* c, const Figure& figure, const FigureLayout& layout) {
    cairo_save(c);
    cairo_rectangle(c, layout.left, layout.top, layout.pictureWidth(), layout.pictureHeight());
    cairo_clip(c);
    if (figure.hasGrid) drawGrid(c, figure, layout);
    if (!figure.outlines.empty()) drawOutlines(c, figure, layout);
    cairo_restore(c);
}

void drawPicture(cairo_t* c, const Figure& figure, const FigureLayout& layout) {
    const FigureSurface pixels = pixelsOf(figure, layout);
    cairo_save(c);
    cairo_translate(c, layout.left, layout.top);
    cairo_scale(c, layout.pixel, layout.pixel);
    cairo_set_source_surface(c, pixels.get(), 0, 0);
    cairo_pattern_set_filter(cairo_get_source(c), CAIRO_FILTER_NEAREST);
    cairo_rectangle(c, 0, 0, layout.columns, layout.rows);
    cairo_fill(c);
    cairo_restore(c);
    drawLines(c, figure, layout);
    setInk(c, inkOf(figure).text);
    cairo_set_line_width(c, 0.5);
    cairo_rectangle(c, layout.left, layout.top, layout.pictureWidth(), layout.pictureHeight());
    cairo_stroke(c);
}

void drawNames(cairo_t* c, const Figure& figure, const FigureLayout& layout) {
    const double em = figure.letters;
    double y = layout.top;
    for (const FigureLayout::Entry& entry : layout.scale) {
        setInk(c, paletteColor(figure.buffer.info->palette, entry.value, figure.range.first, figure.range.last));
        cairo_rectangle(c, layout.barLeft, y, layout.barWidth, 1.2 * em);
        cairo_fill_preserve(c);
        setInk(c, inkOf(figure).text);
        cairo_set_line_width(c, 0.5);
        cairo_stroke(c);
        write(c, figure, layout.barLeft + layout.barWidth + 0.5 * em, y + 0.95 * em, entry.text);
        y += 1.6 * em;
    }
    if (layout.namesLeftOut > 0)
        write(c, figure, layout.barLeft, y + 0.95 * em, fmt::format("+ {}", layout.namesLeftOut));
}

void drawBar(cairo_t* c, const Figure& figure, const FigureLayout& layout) {
    if (layout.barWidth == 0) return;
    if (layout.isOfNames) return drawNames(c, figure, layout);
    const PaletteRange range = figure.range;
    const FigurePattern colors(cairo_pattern_create_linear(0, layout.top + layout.barHeight, 0, layout.top));
    for (int i = 0; i <= kBarStops; ++i) {
        const double t = double(i) / kBarStops;
        const double value = (1 - t) * range.first + t * range.last;
        const Color8 color = paletteColor(figure.buffer.info->palette, value, range.first, range.last);
        cairo_pattern_add_color_stop_rgb(colors.get(), t, color.r / 255.0, color.g / 255.0, color.b / 255.0);
    }
    cairo_rectangle(c, layout.barLeft, layout.top, layout.barWidth, layout.barHeight);
    cairo_set_source(c, colors.get());
    cairo_fill_preserve(c);
    setInk(c, inkOf(figure).text);
    cairo_set_line_width(c, 0.5);
    cairo_stroke(c);
    const double em = figure.letters;
    // Upwards, as on an axis; the outer numbers stay inside the bar's height.
    const double first = layout.top + layout.barHeight, last = layout.top + 0.75 * em;
    for (std::size_t i = 0; i < layout.scale.size(); ++i) {
        const double t = layout.scale.size() > 1 ? double(i) / double(layout.scale.size() - 1) : 0;
        write(c, figure, layout.barLeft + layout.barWidth + 0.5 * em, (1 - t) * first + t * last, layout.scale[i].text);
    }
    if (!layout.unit.empty()) write(c, figure, layout.barLeft, layout.top + layout.pictureHeight(), layout.unit);
}

// A square around the pixel, its numbers at the end of a line towards the middle of the picture.
void drawMark(cairo_t* c, const Figure& figure, const FigureLayout& layout) {
    if (!figure.pixel) return;
    const double em = figure.letters;
    const glm::ivec2 at = *figure.pixel - layout.first;
    const double x = layout.left + (at.x + 0.5) * layout.pixel, y = layout.top + (at.y + 0.5) * layout.pixel;
    const double side = std::max(layout.pixel, 0.5 * em);
    const std::string text =
        fmt::format("{}, {}: {}", figure.pixel->x, figure.pixel->y, valueText(figure.buffer, *figure.pixel));
    setLetters(c, figure);
    const double width = widthOf(c, text);
    const double right = layout.left + layout.pictureWidth(), bottom = layout.top + layout.pictureHeight();
    const bool isBelow = bottom - y > y - layout.top;
    const double least = layout.left + 0.5 * em;
    const double textLeft = std::max(least, std::min(x + em, right - width - 0.5 * em));
    const double base = isBelow ? std::min(y + 4 * em, bottom - 0.5 * em) : std::max(y - 3 * em, layout.top + em);
    const double end = isBelow ? base - 0.9 * em : base + 0.3 * em;
    const double from = y + (isBelow ? 0.5 : -0.5) * side;
    const auto stroke = [&](Color8 ink, double line) {
        setInk(c, ink);
        cairo_set_line_width(c, line);
        cairo_rectangle(c, x - side / 2, y - side / 2, side, side);
        cairo_stroke(c);
        cairo_move_to(c, x, from);
        cairo_line_to(c, textLeft + std::min(em, width / 2), end);
        cairo_stroke(c);
    };
    stroke(inkOf(figure).background, 2.5);
    stroke(inkOf(figure).text, 1);
    writeOver(c, figure, textLeft, base, text);
}

// A round number of pixels, at most a quarter of the picture.
void drawScale(cairo_t* c, const Figure& figure, const FigureLayout& layout) {
    if (!figure.hasScale) return;
    const double em = figure.letters;
    const double most = std::max(1.0, layout.columns / 4.0), power = std::pow(10, std::floor(std::log10(most)));
    const double length = most >= 5 * power ? 5 * power : most >= 2 * power ? 2 * power : power;
    const double left = layout.left + em, y = layout.top + layout.pictureHeight() - em;
    const auto stroke = [&](Color8 ink, double line) {
        setInk(c, ink);
        cairo_set_line_width(c, line);
        cairo_move_to(c, left, y), cairo_rel_line_to(c, length * layout.pixel, 0);
        for (const double end : {left, left + length * layout.pixel})
            cairo_move_to(c, end, y - 0.3 * em), cairo_line_to(c, end, y + 0.3 * em);
        cairo_stroke(c);
    };
    stroke(inkOf(figure).background, 2.5);
    stroke(inkOf(figure).text, 1);
    writeOver(c, figure, left, y - 0.5 * em, fmt::format("{} px", length));
}

// `scale`: units of the surface in a pt.
void drawFigure(cairo_surface_t* surface, const Figure& figure, const FigureLayout& layout, double scale) {
    const FigureContext context(cairo_create(surface));
    cairo_t* c = context.get();
    cairo_scale(c, scale, scale);
    setInk(c, inkOf(figure).background);
    cairo_paint(c);
    drawPicture(c, figure, layout);
    drawBar(c, figure, layout);
    drawScale(c, figure, layout);
    drawMark(c, figure, layout);
    for (std::size_t i = 0; i < layout.caption.size(); ++i)
        write(c, figure, layout.left, layout.captionTop + layout.lineHeight * double(i) + figure.letters,
              layout.caption[i]);
    if (cairo_status(c) == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
}

FigureLayout measured(const Figure& figure) {
    const FigureSurface none(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
    const FigureContext metrics(cairo_create(none.get()));
    return layOut(figure, metrics.get());
}

// How many dots a metre has: the chunk pHYs, right after the header, which is 33 bytes long with the signature.
void stateDots(std::string& png, double dotsPerInch) {
    constexpr std::size_t kHeader = 33;
    const auto number = [](std::uint32_t value) {
        return std::string{char(value >> 24), char(value >> 16), char(value >> 8), char(value)};
    };
    const std::string dots = number(std::uint32_t(std::lround(dotsPerInch / 0.0254)));
    const std::string chunk = "pHYs" + dots + dots + '\1';
    const auto sum = crc32(0, reinterpret_cast<const unsigned char*>(chunk.data()), unsigned(chunk.size()));
    png.insert(kHeader, number(std::uint32_t(chunk.size() - 4)) + chunk + number(std::uint32_t(sum)));
}

// Pixels stay squares: else a viewer may blur them.
void keepSquares(std::string& svg) {
    const std::string_view tag = "<image ", style = "style=\"image-rendering:pixelated\" ";
    if (const std::size_t at = svg.find(tag); at != svg.npos) svg.insert(at + tag.size(), style);
}

// The library numbers surfaces through a whole process: without the numbers the same figure has the same bytes.
void dropNumbers(std::string& svg) {
    for (const std::string_view name : {"\"surface", "\"image", "#image"})
        for (std::size_t at = svg.find(name); at != svg.npos; at = svg.find(name, at + 1)) {
            const std::size_t digits = at + name.size(), end = svg.find_first_not_of("0123456789", digits);
            if (end != svg.npos) svg.erase(digits, end - digits);
        }
}

}  // namespace

Figure figureOf(const Frame& frame, AnyBuffer buffer) {
    Figure figure;
    const BufferInfo& info = *buffer.info;
    if (info.domain == Domain::Pixel && info.palette != Palette::Color) {
        figure.seen = frame.buffer({BufferId::PolygonId});
        if (figure.seen && (figure.seen->columns() != buffer.columns() || figure.seen->rows() != buffer.rows()))
            figure.seen.reset();
    }
    BufferStatistics found = statistics(buffer);
    if (figure.seen && info.element == Element::Real) {
        constexpr double kInfinite = std::numeric_limits<double>::infinity();
        double least = kInfinite, most = -kInfinite;
        for (std::size_t y = 0; y < buffer.rows(); ++y)
            for (std::size_t x = 0; x < buffer.columns(); ++x)
                for (int c = 0; figure.seen->value(x, y) >= 0 && c < info.channels; ++c)
                    if (const double value = buffer.value(x, y, c); std::isfinite(value))
                        least = std::min(least, value), most = std::max(most, value);
        if (least <= most) found.min = least, found.max = most;
    }
    figure.range = fittingRange(buffer, found, frame.scene().settings.depthFormat);
    figure.buffer = std::move(buffer);
    return figure;
}

std::string captionOf(const Figure& figure, const Scene& scene, std::string_view meaning) {
    std::string text(meaning);
    if (!text.empty() && text.back() != '.') text += '.';
    text += fmt::format(" {} of {}, {} × {}{}", figure.buffer.name.text(), scene.name, figure.buffer.columns(),
                        figure.buffer.rows(), figure.buffer.info->domain == Domain::Texel ? " texels" : " pixels");
    if (figure.pixel)
        text += fmt::format("; at {}, {}: {}{}{}", figure.pixel->x, figure.pixel->y,
                            valueText(figure.buffer, *figure.pixel), figure.buffer.info->unit.empty() ? "" : " ",
                            figure.buffer.info->unit);
    return text + '.';
}

FigureSize sizeOf(const Figure& figure) {
    const FigureLayout layout = measured(figure);
    return {layout.width * kMmPerPoint, layout.height * kMmPerPoint};
}

Result<std::string> figureFile(const Figure& figure, FigureFormat format) {
    if (figure.outlines.size() > kMostOutlines)
        return Error{{},
                     fmt::format("{} polygons have edges here", figure.outlines.size()),
                     fmt::format("at most {}: a smaller part, or no edges", kMostOutlines)};
    const FigureLayout layout = measured(figure);
    if (!(layout.pixel >= kLeastPixel))
        return Error{{},
                     fmt::format("no room for the picture in a width of {} mm", figure.width),
                     "a wider figure, smaller letters or no palette bar"};
    std::string bytes;
    const double dots = figure.dotsPerInch / 72;
    if (format == FigureFormat::Png && std::max(layout.width, layout.height) * dots > kMostPngSide)
        return Error{{}, "the figure is too large for a PNG", "fewer dots per inch, or SVG or PDF"};
    FigureSurface surface;
    if (format == FigureFormat::Svg) {
        surface.reset(cairo_svg_surface_create_for_stream(appendBytes, &bytes, layout.width * kMmPerPoint,
                                                          layout.height * kMmPerPoint));
        cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_MM);
        drawFigure(surface.get(), figure, layout, kMmPerPoint);
    } else if (format == FigureFormat::Pdf) {
        surface.reset(cairo_pdf_surface_create_for_stream(appendBytes, &bytes, layout.width, layout.height));
        // The same figure has the same bytes, whenever it is written.
        cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
        drawFigure(surface.get(), figure, layout, 1);
    } else {
        surface.reset(cairo_image_surface_create(CAIRO_FORMAT_RGB24, int(std::ceil(layout.width * dots)),
                                                 int(std::ceil(layout.height * dots))));
        drawFigure(surface.get(), figure, layout, dots);
        if (cairo_surface_write_to_png_stream(surface.get(), appendBytes, &bytes) != CAIRO_STATUS_SUCCESS)
            throw std::bad_alloc();
        stateDots(bytes, figure.dotsPerInch);
    }
    cairo_surface_finish(surface.get());
    if (cairo_surface_status(surface.get()) == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
    if (format == FigureFormat::Svg) keepSquares(bytes), dropNumbers(bytes);
    return bytes;
}

}  // namespace pipeline
