#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/core/real.h"
#include "pipeline/study/analysis.h"

namespace pipeline {

// A plot of error against run time: what it shows, and what it looks like as a plain list of lines,
// markers and texts, which painters for files (pipeline/export/figure/plot_file.h) and for the window draw.

// One setting in the plot.
struct PlotPoint {
    std::size_t point = 0;       // into StudyReport::points
    double x = 1, y = 1;         // above 0; y may be 0, which stands at the foot
    double xLow = 1, xHigh = 1;  // interval of x
    double yLow = 1, yHigh = 1;  // interval of y; y where it has none
    std::string label;           // "16"; empty for none
    bool onFront = false;
};

struct PlotSeries {
    std::string name;               // "phong"
    std::string note;               // "order 1.91"; may be empty
    std::vector<PlotPoint> points;  // along the curve
};

// Settings that have no place, and why.
struct PlotOmission {
    std::string why;
    std::vector<std::string> labels;
};

struct Plot {
    std::string title, subtitle, xLabel, yLabel;
    std::vector<PlotSeries> series;
    std::vector<PlotOmission> omissions;
    double referenceError = 0;  // errors below cannot be told from the reference's own; 0 for none
};

Plot plotOf(const StudyReport& report, const StudyAnalysis& analysis);

// What a mark of the drawing stands for; a painter's theme knows its colour.
enum class PlotRole : std::uint8_t { Text, Secondary, Grid, Front, Equal, Failed, Series };
struct PlotInk {
    PlotRole role = PlotRole::Text;
    std::size_t series = 0;  // for PlotRole::Series: colour number modulo kPlotColors
    bool operator==(const PlotInk&) const = default;
};
inline constexpr std::size_t kPlotColors = 5;

enum class PlotDash : std::uint8_t { Solid, Dashed, Dotted, DashDot, LongDash };
enum class PlotShape : std::uint8_t { Square, Triangle, Disc, Diamond, TriangleDown, Pentagon, Cross, Star };

// All coordinates in points (1/72 inch), x to the right, y down, (0, 0) at the top left.
struct PlotLine {
    std::vector<Vec2<double>> points;
    PlotInk ink;
    double width = 1;
    PlotDash dash = PlotDash::Solid;
};

struct PlotMarker {
    Vec2<double> at{0};
    PlotShape shape = PlotShape::Disc;
    double size = 0;  // largest extent
    bool filled = true;
    PlotInk ink;
    std::optional<std::size_t> point;  // into StudyReport::points; nothing in a legend
};

struct PlotText {
    Vec2<double> at{0};  // on the base line: its left end, middle or right end
    enum class Anchor : std::uint8_t { Start, Middle, End } anchor = Anchor::Start;
    std::string text;
    double size = 0;
    bool bold = false, upwards = false;  // upwards: turned by 90° counter-clockwise about `at`
    PlotInk ink;
};

// Drawn in this order: lines, markers, texts.
struct PlotDrawing {
    double width = 0, height = 0;
    std::vector<PlotLine> lines;
    std::vector<PlotMarker> markers;
    std::vector<PlotText> texts;
};

struct PlotSize {
    double width = 960, height = 600;
    double text = 16;  // size of labels; other sizes follow it
};

// Lays a plot out, both axes logarithmic. Nothing leaves the drawing and no two texts overlap: a
// label without a free place is left out, a method's name then stands in a legend. An error of 0
// stands in a row of its own at the foot.
PlotDrawing layOut(const Plot& plot, const PlotSize& size);

// Width of a text, from above: that of DejaVu Sans, wider than the fonts that are used.
double textWidth(std::string_view text, double size);

// Corners of a shape's outline about (0, 0), largest extent 1, y down; empty for a disc. Cross and
// star are closed outlines too.
std::vector<Vec2<double>> outline(PlotShape shape);
// Lengths of dash and gap in line widths; empty for a solid line.
std::vector<double> dashes(PlotDash dash);

}  // namespace pipeline
