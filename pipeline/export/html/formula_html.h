#pragma once
#include <string>

#include "pipeline/inspect/formula.h"

namespace pipeline {

// A formula for a page in HTML, in elements that formulaStyle() lays out: i a letter, b.vector a vector, in the code of
// its class N L V R H, sub and sup scripts, span.fraction, s what is struck.
std::string toHtml(const Formula& formula);

// The style sheet of these, on a light ground; dashes under vectors tell them apart in grey too.
std::string_view formulaStyle();

}  // namespace pipeline
