#pragma once
#include <string>

#include "lessons/pages/talk_page.h"
#include "lessons/state/cue_list.h"
#include "pipeline/inspect/pixel_report.h"
#include "pipeline/steps/algorithm.h"

// The parts of a cue on the page of a talk, as HTML. Text is escaped.

namespace lessons {

// A sentence with the lectures' symbols as they are set, after setPieces().
std::string sentenceHtml(const std::string& text);
// The lines with their values, the innermost loop as a bar, and why lines are left out.
std::string algorithmHtml(const pipeline::AlgorithmState& state);
// Symbols, numbers and result as MathML; empty for no lines.
std::string equationHtml(const std::vector<pipeline::EquationLine>& lines);
// As a list from A on; the answer marks the right one.
std::string choicesHtml(const CueQuestion& question, bool isAnswer);
// The palette between the values at its ends, or the colours with their names; empty where there is neither.
std::string legendHtml(const TalkLegend& legend);

}  // namespace lessons
