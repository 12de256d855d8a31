#pragma once
#include <string>
#include <utility>
#include <vector>

#include "lessons/state/cue_list.h"
#include "pipeline/inspect/pixel_report.h"
#include "pipeline/steps/algorithm.h"

// What an audience reads beside the pictures of a cue: in the clean view, and on the page of a talk.

namespace lessons {

// Of an equation the lines that a hall can read: symbols, numbers and result, at most four, and the frame buffer's. Of
// many lights the first lines, but no symbols without their numbers. Without remarks and sentences.
std::vector<pipeline::EquationLine> shortEquation(std::vector<pipeline::EquationLine> lines);

// The rows of an algorithm on show, first and one behind the last: all, or 11 around the current one.
std::pair<std::size_t, std::size_t> rowsAround(const std::vector<pipeline::AlgorithmRow>& rows, std::size_t most);
inline constexpr std::size_t kMostAlgorithmRows = 11;

// The words of the lectures' language, which are set bold: a regular expression with one group.
inline constexpr char kLanguageWords[] = "\\b(for each|for all|if|then)\\b";

// A sentence in pieces, with the lectures' symbols as they are set: r below in k_r, n raised in (R·V)^n.
struct SetPiece {
    enum class Script : unsigned char { None, Below, Raised };
    std::string text;
    Script script = Script::None;
    bool operator==(const SetPiece&) const = default;
};
std::vector<SetPiece> setPieces(const std::string& sentence);

// Below a question that has no caption.
inline constexpr char kVoteByHand[] = "Talk to your neighbour, then vote by hand.";

}  // namespace lessons
