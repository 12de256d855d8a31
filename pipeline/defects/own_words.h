#pragma once
#include <string>
#include <vector>

#include "pipeline/defects/own_judge.h"

// Calls and results of a student's function in words, for whoever reports them.
namespace pipeline {

// "(0, 0.894427, -0.447214)", "true"; "no number" of nothing.
std::string resultText(const OwnContract& contract, const std::optional<OwnValue>& value);
// "polygon 3", "pixel 268, 281" in a picture of this width; "call 12" of a call that belongs nowhere. number: from 0.
std::string placeText(const OwnElement& element, std::size_t number, int width);
// How a call's numbers are told apart: "3 3* 1 > 3". Counts of numbers of each argument, * where it is a list, which has its
// count first; behind > that of the result, t where it is true or false.
std::string shapeText(const OwnContract& contract);
// "v0 = (0, 0, 0)", one an argument.
std::vector<std::string> argumentTexts(const OwnContract& contract, const OwnElement& element);

}  // namespace pipeline
