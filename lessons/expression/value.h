#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lessons {

// What an expression gives: one number, a vector of several, words (then no numbers), or a truth: the words "true" or
// "false" with the number 1 or 0.
struct Value {
    std::vector<double> numbers;
    std::string words;
    bool operator==(const Value&) const = default;
};

// For readers: "−1 991.6" (U+2212, groups of three with U+2009), "(0, 0.894, 0.447)", or the words.
// `digits` after the point, 0 to 12; without them up to four, and no zeros at the end.
std::string toText(const Value& value, std::optional<int> digits = {});

// A number as somebody types it: "0.7746", "−0,5", "4e-3". Nothing where it is not a finite number.
std::optional<double> numberIn(std::string_view text);

}  // namespace lessons
