#pragma once
#include <string>

#include "pipeline/inspect/formula.h"

namespace pipeline {

// A formula as MathML Core for the inside of <math>: mn numbers, mi letters and words, mo signs, msub and msup scripts,
// mfrac. A vector is an mi of the classes "v" and N, L, V, R or H; what is struck an mrow of the class "struck"; a part
// that stands for a setting or a buffer an mrow whose data-refers names it. Text is escaped.
std::string toMathml(const Formula& formula);

}  // namespace pipeline
