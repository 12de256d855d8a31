#pragma once
#include <vector>

#include "app/inspector/math_layout.h"
#include "pipeline/inspect/pixel_report.h"

namespace app {

// A line of words, in the text's face: a note, or what a result was.
bool isWords(const pipeline::EquationLine& line);

// Equation lines below each other: left-hand sides in a column, `=` below `=`, what is too wide
// broken before an operator and continued one em further in.
struct MathPage {
    MathBox box{};                  // from the top left corner: the base line of the box is its top
    std::vector<int> lineOfPart{};  // per part of the box: which equation line
    double height = 0;
};
// size: of the main lines in pixels; rows of vectors are 0.8 of it. width: to stay within.
MathPage layoutEquation(const std::vector<pipeline::EquationLine>& lines, double size, double width);

}  // namespace app
