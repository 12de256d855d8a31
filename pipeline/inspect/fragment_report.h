#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/inspect/formula.h"

namespace pipeline {

enum class FragmentVerdict : unsigned char {
    WonStays,
    Overwritten,
    NotNearer,
    PaintedLast,
    PaintedOver,
    NotYet,  // still to come: only while stepping inside the z-buffer stage
};
std::string_view name(FragmentVerdict verdict);  // "passed, stays" …
constexpr bool came(FragmentVerdict verdict) { return verdict != FragmentVerdict::NotYet; }
constexpr bool won(FragmentVerdict verdict) { return came(verdict) && verdict != FragmentVerdict::NotNearer; }

// One polygon's arrival at a pixel, in the order it was drawn.
struct FragmentReport {
    int polygon;
    double depth, stored;  // compared: the new one, and what the z-buffer held before (+inf: nothing)
    FragmentVerdict verdict;
    // That holds between the two: "<", "≥", or "=" of the first at the depth of the cleared buffer. Empty where nothing is
    // tested.
    std::string_view relation;
    // What happens then to one that won, a line each: "light 0: z' 120.3 ≤ Z'[12][44] 120.3 + 0.02: lit".
    std::vector<std::string> shadows{};
};

// "2 fragments, 1 passed; 1 to come": the depth test; "2 written" where nothing is tested.
std::string fragmentCounts(std::span<const FragmentReport> fragments);

// In as many significant digits as tell neighbours in float apart; "+∞" where nothing is stored.
std::string depthText(double depth, int digits = 7);

// "671.4539", "<", "+∞". Where both depths are the same in seven digits but differ, as in double, they have more.
struct ComparisonText {
    std::string depth, relation, stored;  // the last two are empty where none are compared
    std::string whole() const { return relation.empty() ? depth : depth + ' ' + relation + ' ' + stored; }
};
// A fragment that is still to come has its depth alone, unless the step is just at its test.
ComparisonText comparisonText(const FragmentReport& fragment, const NumberText& chosen = {}, bool isTested = false);

}  // namespace pipeline
