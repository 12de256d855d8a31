#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

namespace pipeline {

// Numbers are read as std::from_chars reads them: in any locale with a point, without a leading +, rounded to the nearest
// double; "inf" and "nan" are numbers too.

// The number that a text begins with.
struct LeadingNumber {
    double value = 0;
    std::size_t length = 0;  // bytes of the text; 0: it begins with no number
    bool fits = true;        // false: too large or too small for a double; then `value` is 0
};
LeadingNumber leadingNumber(std::string_view text);

// The number that a text is as a whole; nothing where it is none, or one that no double holds.
std::optional<double> readNumber(std::string_view text);

// The same by strtod, for a standard library without from_chars for double (libc++ 19). In the locale "C".
LeadingNumber leadingNumberByStrtod(std::string_view text);

}  // namespace pipeline
