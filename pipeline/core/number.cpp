#include "pipeline/core/number.h"

#include <version>

#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <string>

#include "pipeline/core/text.h"

namespace pipeline {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

std::size_t digitsAt(std::string_view text, std::size_t at) {
    std::size_t end = at;
    while (end < text.size() && isDigit(text[end])) ++end;
    return end - at;
}

// Bytes of the longest beginning that is a number: strtod takes more, as hexadecimal numbers and white space.
std::size_t numberLength(std::string_view text) {
    const std::size_t sign = text.starts_with('-') ? 1 : 0;
    for (const std::string_view word : {"infinity", "inf", "nan"})
        if (sameLetters(text.substr(sign, word.size()), word)) return sign + word.size();
    const std::size_t whole = digitsAt(text, sign);
    std::size_t end = sign + whole;
    if (text.substr(end).starts_with('.')) {
        const std::size_t fraction = digitsAt(text, end + 1);
        if (whole + fraction == 0) return 0;
        end += 1 + fraction;
    }
    if (end == sign) return 0;
    if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
        std::size_t exponent = end + 1;
        if (exponent < text.size() && (text[exponent] == '-' || text[exponent] == '+')) ++exponent;
        if (const std::size_t digits = digitsAt(text, exponent); digits > 0) end = exponent + digits;
    }
    return end;
}

}  // namespace

LeadingNumber leadingNumberByStrtod(std::string_view text) {
    const std::size_t length = numberLength(text);
    if (length == 0) return {};
    const std::string word(text.substr(0, length));
    errno = 0;
    const double value = std::strtod(word.c_str(), nullptr);
    // A denormal result is one, though strtod may call it out of range.
    const bool fits = errno != ERANGE || (value != 0 && value - value == 0);
    return {fits ? value : 0, length, fits};
}

LeadingNumber leadingNumber(std::string_view text) {
#ifdef __cpp_lib_to_chars
    LeadingNumber number;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number.value);
    if (error == std::errc::invalid_argument) return {};
    number.length = static_cast<std::size_t>(end - text.data());
    number.fits = error == std::errc();
    return number;
#else
    return leadingNumberByStrtod(text);
#endif
}

std::optional<double> readNumber(std::string_view text) {
    const LeadingNumber number = leadingNumber(text);
    if (number.length == 0 || number.length != text.size() || !number.fits) return {};
    return number.value;
}

}  // namespace pipeline
