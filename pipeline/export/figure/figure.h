#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pipeline/buffers/palette.h"
#include "pipeline/core/result.h"
#include "pipeline/export/figure/plot_file.h"
#include "pipeline/run/frame.h"

namespace pipeline {

enum class FigureFormat : std::uint8_t { Svg, Pdf, Png };

// A buffer of pixels or texels on paper: its picture, the palette's bar with its unit, a marked pixel with its value, a
// scale bar and a caption.
struct Figure {
    AnyBuffer buffer;
    PaletteRange range;                 // at the ends of the bar; the first value is at the top
    std::optional<AnyBuffer> seen{};    // polygon_id: where it is negative the paper stays white; nothing: all is drawn
    std::optional<glm::ivec2> pixel{};  // column and row of the buffer
    struct Part {
        glm::ivec2 first, last;  // columns and rows of the buffer, both drawn
        bool operator==(const Part&) const = default;
    };
    std::optional<Part> part{};  // nothing: the whole buffer
    bool hasBar = true;          // colours and directions have none
    bool hasScale = false;       // a length in pixels
    bool hasGrid = false;        // lines between the pixels
    // Closed outlines that are drawn over the picture, in pixels; (0, 0) is the top left corner of the first one.
    using Outline = std::vector<glm::dvec2>;
    std::vector<Outline> outlines{};
    std::string caption{};        // UTF-8; empty: none
    double width = 84;            // of the whole figure, in mm
    double letters = 8;           // the text's size, in pt
    bool isForProjector = false;  // the theme's colours of lines and letters
    double dotsPerInch = 300;     // of a PNG
};

inline constexpr double kLeastFigure = 20, kMostFigure = 1000;  // its width in mm
inline constexpr double kLeastLetters = 4, kMostLetters = 48;   // pt
inline constexpr double kLeastDots = 36, kMostDots = 2400;      // per inch
inline constexpr std::size_t kMostOutlines = 100'000;           // of a figure

// A figure of one buffer of a frame: only what was drawn has colours and counts for the range. The frame buffer and
// buffers of texels are drawn whole.
Figure figureOf(const Frame& frame, AnyBuffer buffer);
// The buffers that polygonOutlines reads.
BufferSet outlineBuffers();
// The outlines of the polygons that go on to the z-buffer, for a buffer of pixels: those that reach into `part`, or into
// the picture. Polygons that are partly nearer than the near plane have none.
std::vector<Figure::Outline> polygonOutlines(const Frame& frame, const std::optional<Figure::Part>& part);
// "view-space depth of the visible point; nothing drawn: 0. z_view of pyramid.scene, 640 × 480 pixels; at 268, 281: 671.45."
std::string captionOf(const Figure& figure, const Scene& scene, std::string_view meaning);

// In mm.
struct FigureSize {
    double width, height;
};
FigureSize sizeOf(const Figure& figure);

// The bytes of a file. In a PDF and a PNG the size in mm is stated as well. Errors: too large for a PNG, no room for the
// picture beside its bar, or more outlines than kMostOutlines.
Result<std::string> figureFile(const Figure& figure, FigureFormat format);

}  // namespace pipeline
