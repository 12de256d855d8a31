#include "pipeline/core/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <vector>

#include "pipeline/core/number.h"
#include "pipeline/core/printable.h"

namespace pipeline {

std::string shortestText(double value) {
    // Left to itself to_chars writes 100000 as 1e+05; people read whole numbers better.
    const bool whole = std::abs(value) < 1e7 && value == std::trunc(value);
    std::array<char, 32> digits;
    const auto end = whole
                         ? std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed)
                         : std::to_chars(digits.data(), digits.data() + digits.size(), value);
    std::string text(digits.data(), end.ptr);
    if (const auto e = text.find('e'); e != text.npos) {  // "1e+09" to "1e9", "1e-09" to "1e-9"
        const std::size_t sign = e + 1, digit = text.find_first_not_of('0', sign + 1);
        text.erase(sign + 1, digit - sign - 1);
        if (text[sign] == '+') text.erase(sign, 1);
    }
    return text;
}

std::string textBeyond(double value, double bound) {
    for (int digits = 3; digits < 17; ++digits) {
        const std::string text = fmt::format("{:.{}g}", value, digits);
        const double rounded = readNumber(text).value_or(value);
        if (rounded != bound) return shortestText(rounded);
    }
    return shortestText(value);
}

std::string inQuotes(std::string_view words) {
    constexpr std::size_t kLongest = 60;
    if (words.size() <= kLongest) return '"' + escaped(words) + '"';
    std::string_view start = words.substr(0, kLongest);
    while (!start.empty() && (static_cast<unsigned char>(start.back()) & 0xc0) == 0x80) start.remove_suffix(1);
    if (!start.empty() && static_cast<unsigned char>(start.back()) >= 0xc0)
        start.remove_suffix(1);  // no half character
    return '"' + escaped(start) + "…\"";
}

std::string plural(std::int64_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

bool sameLetters(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return std::ranges::equal(a, b, {}, lower, lower);
}

std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);  // distances of a's first i letters to every start of b
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

std::string nearest(std::string_view text, std::span<const std::string> candidates) {
    const std::string_view start = text.substr(0, 100);  // no name is longer; input may be
    const auto best = std::ranges::min_element(
        candidates, {}, [&](const std::string& candidate) { return editDistance(start, candidate); });
    return best == candidates.end() ? std::string() : *best;
}

namespace {

bool holds(std::string_view whole, std::string_view part) {
    constexpr std::size_t kLeast = 3;  // fewer letters stand in too many words
    return part.size() >= kLeast && whole.find(part) != whole.npos;
}

// "a", "b" and "c"
std::string listed(std::span<const std::string> names) {
    std::string list;
    for (std::size_t i = 0; i < names.size(); ++i)
        list += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + inQuotes(names[i]);
    return list;
}

}  // namespace

std::string insteadOf(std::string_view text, std::span<const std::string> known, std::string_view command) {
    const std::string best = nearest(text, known);
    if (best.empty()) return "there is none";
    if (editDistance(text.substr(0, 100), best) <= (text.size() + 2) / 3 || holds(text, best))
        return "the nearest is " + inQuotes(best);
    const auto whole = std::ranges::find_if(known, [&](const std::string& name) { return holds(name, text); });
    if (whole != known.end()) return "the nearest is " + inQuotes(*whole);
    constexpr std::size_t kMost = 10, kNearest = 3;  // names in a message
    if (known.size() <= kMost) return (known.size() == 1 ? "there is " : "there are ") + listed(known);
    std::vector<std::pair<std::size_t, std::size_t>> order;  // distance and place
    for (std::size_t i = 0; i < known.size(); ++i) order.emplace_back(editDistance(text.substr(0, 100), known[i]), i);
    std::ranges::partial_sort(order, order.begin() + kNearest);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < kNearest; ++i) names.push_back(known[order[i].second]);
    const std::string all = command.empty() ? "" : "; " + std::string(command) + " lists all";
    return "there are " + std::to_string(known.size()) + ", the nearest are " + listed(names) + all;
}

}  // namespace pipeline
