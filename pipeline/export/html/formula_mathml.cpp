#include "pipeline/export/html/formula_mathml.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "pipeline/export/html/html_text.h"

namespace pipeline {

namespace {

using Kind = Formula::Kind;

constexpr std::string_view kThinSpace = "\u2009";  // between groups of three digits
// A minus after one of these, or at the beginning, is a sign and no difference: "(−0.577".
constexpr std::array<std::string_view, 6> kOpening{"(", "[", ",", "=", "·", "+"};
constexpr std::array<std::string_view, 5> kFences{"(", ")", "[", "]", "|"};

bool mathDigit(char c) { return c >= '0' && c <= '9'; }
bool mathLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// One code point of UTF-8.
std::string_view mathSign(std::string_view text) {
    std::size_t end = 1;
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) ++end;
    return text.substr(0, end);
}

std::string_view mathNumber(std::string_view text) {
    std::size_t end = 0;
    while (end < text.size()) {
        if (mathDigit(text[end]) || text[end] == '.')
            ++end;
        else if (text.substr(end).starts_with(kThinSpace) && end + kThinSpace.size() < text.size() &&
                 mathDigit(text[end + kThinSpace.size()]))
            end += kThinSpace.size();
        else
            break;
    }
    return text.substr(0, end);
}

// A text may hold several signs: "[", "= 0.9", "max(0, ".
std::string mathTokens(std::string_view text) {
    std::string out;
    std::string_view before;
    while (!text.empty()) {
        if (text.front() == ' ') {
            text.remove_prefix(1);
            continue;
        }
        std::string_view token;
        if (mathDigit(text.front())) {
            token = mathNumber(text);
            out += element("mn", token);
        } else if (mathLetter(text.front())) {
            token = text.substr(0, std::size_t(std::ranges::find_if_not(text, mathLetter) - text.begin()));
            out += element("mi mathvariant=\"normal\"", token);
        } else {
            token = mathSign(text);
            const bool isSign = (token == "−" || token == "-") &&
                                (before.empty() || std::ranges::find(kOpening, before) != kOpening.end());
            const bool isFence = std::ranges::find(kFences, token) != kFences.end();
            out += element(isFence ? "mo stretchy=\"false\"" : isSign ? "mo form=\"prefix\"" : "mo", token);
        }
        before = token;
        text.remove_prefix(token.size());
    }
    return out;
}

std::string mathGroup(std::string_view start, const Formula& part) {
    return '<' + std::string(start) + '>' + toMathml(part) + "</" + std::string(start.substr(0, start.find(' '))) + '>';
}

std::string scriptMathml(const Formula& script) {
    const bool hasSub = !toText(script.parts[1]).empty(), hasSuper = !toText(script.parts[2]).empty();
    if (!hasSub && !hasSuper) return toMathml(script.parts[0]);
    const std::string tag = hasSub && hasSuper ? "msubsup" : hasSub ? "msub" : "msup";
    std::string out = '<' + tag + '>' + mathGroup("mrow", script.parts[0]);
    if (hasSub) out += mathGroup("mrow", script.parts[1]);
    if (hasSuper) out += mathGroup("mrow", script.parts[2]);
    return out + "</" + tag + '>';
}

std::string bareMathml(const Formula& formula) {
    switch (formula.kind) {
        case Kind::Text: return mathTokens(formula.text);
        case Kind::Symbol: return formula.text.empty() ? std::string() : element("mi", formula.text);
        case Kind::Vector: return element("mi mathvariant=\"normal\" class=\"v " + formula.text + '"', formula.text);
        case Kind::Script: return scriptMathml(formula);
        case Kind::Fraction:
            return "<mfrac>" + mathGroup("mrow", formula.parts[0]) + mathGroup("mrow", formula.parts[1]) + "</mfrac>";
        case Kind::Struck: return mathGroup("mrow class=\"struck\"", formula.parts[0]);
        case Kind::Row: break;
    }
    std::string row;
    for (const Formula& part : formula.parts) row += toMathml(part);
    return row;
}

}  // namespace

std::string toMathml(const Formula& formula) {
    const std::string bare = bareMathml(formula);
    if (formula.refers.empty()) return bare;
    return "<mrow data-refers=\"" + escapedHtml(formula.refers) + "\">" + bare + "</mrow>";
}

std::vector<std::string> mathmlParts(const Formula& formula) {
    std::vector<std::string> parts;
    const std::vector<Formula> row =
        formula.kind == Formula::Kind::Row && formula.refers.empty() ? formula.parts : std::vector<Formula>{formula};
    for (const Formula& one : row) {
        const std::string words = toText(one);
        const std::size_t first = words.find_first_not_of(' ');
        const bool begins = one.kind == Formula::Kind::Text && first != std::string::npos &&
                            (words[first] == '=' || words[first] == '+');
        if (begins || parts.empty()) parts.emplace_back();
        parts.back() += toMathml(one);
    }
    return parts;
}

}  // namespace pipeline
