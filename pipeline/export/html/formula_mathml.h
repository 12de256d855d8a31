#pragma once
#include <string>
#include <vector>

#include "pipeline/inspect/formula.h"

namespace pipeline {

// A formula as MathML Core for the inside of <math>: mn numbers, mi letters and words, mo signs, msub and msup scripts,
// mfrac. A vector is an mi of the classes "v" and N, L, V, R or H; what is struck an mrow of the class "struck"; a part
// that stands for a setting or a buffer an mrow whose data-refers names it. Text is escaped.
std::string toMathml(const Formula& formula);
// The same in parts, from one "=" or "+" of its outer level to the next, so that a page can break the line there.
std::vector<std::string> mathmlParts(const Formula& formula);

}  // namespace pipeline
