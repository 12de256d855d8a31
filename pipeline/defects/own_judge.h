#pragma once
#include <vector>

#include "pipeline/defects/own.h"

namespace pipeline {

// One call of a function: where it belongs, its arguments, and the right result.
struct OwnElement {
    OwnPlace kind = OwnPlace::Unknown;
    std::size_t place = 0;
    std::vector<double> in;
    OwnValue right;
};

// What a program returned for a call; nothing where it returned no number.
using OwnResults = std::vector<std::optional<OwnValue>>;

// By the contract's measure; infinite where only one of two numbers is finite, or the result is none.
double differenceOf(const OwnContract& contract, const std::optional<OwnValue>& mine, const OwnValue& right);

struct OwnVerdict {
    std::size_t all = 0, wrong = 0;
    std::optional<std::size_t> first;      // the first element that differs
    std::vector<const OwnMistake*> names;  // that explain the results equally well: one, or several
    bool isRight() const { return wrong == 0; }
};

// Judges one result for each element. A mistake is named if it explains at least 99 of 100 of the elements in which it or
// the result differs from the right one.
OwnVerdict judgeOwn(const OwnContract& contract, const std::vector<OwnElement>& elements, const OwnResults& mine);

}  // namespace pipeline
