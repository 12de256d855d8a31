#include "lessons/expression/value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/core/number.h"

namespace lessons {
namespace {

constexpr std::string_view kMinusSign = "\u2212", kGroup = "\u202f";  // narrow, and no line ends there
constexpr double kExactWhole = 9007199254740992.0;                    // 2^53: up to here a double counts in ones

// Without digits up to four decimals, as many as tell something.
std::string numberText(double number, std::optional<int> digits) {
    if (std::isnan(number)) return "NaN";
    if (std::isinf(number)) return std::string(number < 0 ? kMinusSign : "+") + "∞";
    std::string plain = fmt::format("{:.{}f}", std::abs(number), digits.value_or(4));
    if (!digits) plain.erase(plain.find_last_not_of('0') + 1);
    if (plain.ends_with('.')) plain.pop_back();
    const std::size_t point = std::min(plain.find('.'), plain.size());
    std::string text;
    // What rounds to zero has no sign.
    if (number < 0 && plain.find_first_not_of("0.") != std::string::npos) text += kMinusSign;
    for (std::size_t i = 0; i < point; ++i) {
        if (i > 0 && (point - i) % 3 == 0) text += kGroup;
        text += plain[i];
    }
    return text + plain.substr(point);
}

bool isWhole(double number) { return std::abs(number) < kExactWhole && number == std::trunc(number); }

}  // namespace

std::string toText(const Value& value, std::optional<int> digits) {
    if (!value.words.empty() || value.numbers.empty()) return value.words;
    if (value.numbers.size() == 1) return numberText(value.numbers.front(), digits);
    // Whole components stay short: a vector's 0 and 1 are exact more often than not.
    std::string text = "(";
    for (const double number : value.numbers) {
        if (text.size() > 1) text += ", ";
        text += numberText(number, isWhole(number) ? std::nullopt : digits);
    }
    return text + ")";
}

std::optional<double> numberIn(std::string_view text) {
    std::string plain(text);
    for (std::size_t at; (at = plain.find(kMinusSign)) != std::string::npos;)
        plain.replace(at, kMinusSign.size(), 1, '-');
    for (std::size_t at; (at = plain.find(kGroup)) != std::string::npos;) plain.erase(at, kGroup.size());
    std::replace(plain.begin(), plain.end(), ',', '.');
    const auto isSpace = [](char c) { return c == ' ' || c == '\t'; };
    while (!plain.empty() && isSpace(plain.back())) plain.pop_back();
    std::string_view digits = plain;
    while (!digits.empty() && isSpace(digits.front())) digits.remove_prefix(1);
    if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
    const std::optional<double> number = pipeline::readNumber(digits);
    return number && std::isfinite(*number) ? number : std::nullopt;
}

}  // namespace lessons
