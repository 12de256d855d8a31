#include "pipeline/compare/own/own_blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/core/number.h"
#include "pipeline/core/text.h"

namespace pipeline::foreign {
std::string_view BlockWords::next() {
    constexpr std::string_view kSpace = " \t\r\n\f\v";
    m_rest.remove_prefix(std::min(m_rest.find_first_not_of(kSpace), m_rest.size()));
    const std::string_view word = m_rest.substr(0, m_rest.find_first_of(kSpace));
    m_rest.remove_prefix(word.size());
    return word;
}

std::optional<double> numberIn(std::string_view word) {
    if (word == "true" || word == "True") return 1;
    if (word == "false" || word == "False") return 0;
    if (word.starts_with('+')) word.remove_prefix(1);
    return readNumber(word);
}

std::string numberText(double x) {
    if (std::isinf(x)) return x > 0 ? "Infinity" : "-Infinity";
    return shortestText(x);
}

Error wrongWord(std::string_view word, std::string expected) {
    constexpr std::size_t kShown = 40;
    return {SourceLocation{"output of the program"},
            fmt::format("found {}", word.empty() ? "its end" : inQuotes(std::string(word.substr(0, kShown)))),
            std::move(expected)};
}

std::string callsText(const OwnContract& contract, const std::vector<OwnElement>& elements) {
    const auto taken = contract.taken();
    const bool isEven = std::ranges::none_of(taken, [](const OwnParameter& one) { return isList(one.kind); });
    std::size_t columns = 0;
    for (const OwnParameter& one : taken) columns += sizeOf(one.kind);
    std::string text = fmt::format("{} {} {}\n", contract.name, elements.size(), isEven ? columns : 0);
    for (const OwnElement& element : elements) {
        for (std::size_t i = 0; i < element.in.size(); ++i) {
            if (i > 0) text += ' ';
            text += numberText(element.in[i]);
        }
        text += '\n';
    }
    return text;
}

Result<OwnResults> readResults(const OwnContract& contract, std::size_t calls, std::string_view text) {
    BlockWords words(text);
    const std::string_view name = words.next();
    if (name != contract.name)
        return wrongWord(name, fmt::format("\"{} {} {}\"", contract.name, calls, contract.size()));
    for (const std::size_t size : {calls, contract.size()}) {
        const std::string_view word = words.next();
        const auto there = readNumber(word);
        if (!there || *there != double(size))
            return wrongWord(word, fmt::format("{} {}", size, size == calls ? "rows" : "columns"));
    }
    OwnResults results(calls);
    for (std::size_t row = 0; row < calls; ++row) {
        OwnValue value;
        bool isFinite = true;
        for (std::size_t i = 0; i < contract.size(); ++i) {
            const std::string_view word = words.next();
            const auto number = numberIn(word);
            if (!number)
                return wrongWord(word, fmt::format("a number, in row {} of {} of {}", row + 1, calls, contract.name));
            value.at[i] = *number;
            isFinite = isFinite && !std::isnan(*number);
        }
        if (isFinite) results[row] = value;
    }
    if (const std::string_view word = words.next(); !word.empty())
        return wrongWord(word, fmt::format("nothing after the {} rows of {}", calls, contract.name));
    return results;
}

}  // namespace pipeline::foreign
