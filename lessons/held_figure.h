#pragma once
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/lesson.h"
#include "pipeline/inspect/pixel_report.h"

// The figure below a held picture, as shapes and terms that the window paints.

namespace lessons {

// Pixels of the figure's place: x from 0 to its width, y from 0 downwards to kFigureHeight.
inline constexpr double kFigureHeight = 132;

struct FigureShape {
    enum class Kind : std::uint8_t { Line, Box, Curve, Dot, Words };
    Kind kind = Kind::Line;
    // What it stands for, which says its colour: "code", "code in", "reach", "base", "own", "curve", "second", "at", "lamp",
    // "eye", "of"; of words also "".
    std::string_view role;
    std::vector<glm::dvec2>
        points;  // two ends; two corners; a curve's points; a middle; where words stand, at their base
    std::string text{};
    double anchor = 0.5;  // of words: 0 where they begin, 0.5 their middle, 1 where they end
};
struct FigureTerm {
    std::string symbol;  // "k_r I_a": a letter and what is behind its "_" is a subscript
    double value;        // intensity
};
struct HeldFigure {
    std::string spoken;  // for a screen reader
    std::vector<FigureShape> shapes;
    // The equation alone: its terms, their sum, and the intensity that is the whole bar, I_max.
    std::vector<FigureTerm> terms;
    std::string sumSymbol;
    double sum = 0, most = 0;
    // Where the hold whose number is on the figure's axis moves, from its low end to its high one.
    std::optional<std::array<glm::dvec2, 2>> track;

    bool empty() const { return shapes.empty() && terms.empty(); }
};

// The width of the figure, and where in it the picture's columns are: x = left + column · perColumn.
struct FigureRoom {
    double width = 0, left = 0, perColumn = 1;
};

// What a figure follows.
struct FigureSource {
    const Half& half;
    const pipeline::Scene& scene;  // as the hand has left it, of which the frame may not be yet
    const pipeline::Frame& frame;
    std::optional<glm::ivec2> pixel;
    int channel = 0;     // 0, 1, 2
    bool tells = false;  // the question is settled: counts and verdicts may be read
    // Of the frame, derived ones too; nothing while it is on its way.
    std::function<std::optional<pipeline::AnyBuffer>(const pipeline::BufferName&)> buffer;
};

// Empty where the half has no figure, and where there is nothing to show: an unlit pixel, a frame without the buffer.
HeldFigure figureOf(const FigureSource& source, const FigureRoom& room);

// The number of the hold that is moved on the figure's own axis; nothing: none is.
std::optional<std::size_t> holdOnFigure(const Held& held);

// "6.84", "−0.5": four digits at most.
std::string figureNumber(double value);
// "141.2": a term, an intensity, in the digits that its I_max asks for.
std::string termText(double value, double most);

}  // namespace lessons
