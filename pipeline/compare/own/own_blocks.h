#pragma once
#include "pipeline/core/result.h"
#include "pipeline/defects/own_judge.h"

namespace pipeline::foreign {

// How a function's calls reach a program in any language, and how its results come back: as text blocks. A block is a
// name, a number of rows, a number of columns (0 where rows differ), and the rows, all with white space between.
//     CalcNormal 5 9
//     200 0 0 470 0 0 335 75 150
//     …
// A list has its count before its elements. Numbers have the shortest text that gives them back; what is infinite is
// Infinity or -Infinity.
std::string callsText(const OwnContract& contract, const std::vector<OwnElement>& elements);

// The results, one row a call. Errors say which row, what was found and what was expected. "nan" and infinities are read as
// results that are none.
Result<OwnResults> readResults(const OwnContract& contract, std::size_t calls, std::string_view text);

// The words of an output one after the other; empty at its end.
class BlockWords {
public:
    explicit BlockWords(std::string_view text) : m_rest(text) {}
    std::string_view next();

private:
    std::string_view m_rest;
};
// Of one word, also "Infinity", "true" and "False".
std::optional<double> numberIn(std::string_view word);
std::string numberText(double x);
// What stands where something else was expected.
Error wrongWord(std::string_view word, std::string expected);

}  // namespace pipeline::foreign
