#include "pipeline/inspect/formula.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>

namespace pipeline {

namespace {

using Kind = Formula::Kind;

bool isLeaf(const Formula& f) { return f.kind == Kind::Text || f.kind == Kind::Symbol || f.kind == Kind::Vector; }

// Rows of one part are as good as the part.
bool isSingle(const Formula& f) {
    if (f.kind == Kind::Row) return f.parts.size() == 1 && isSingle(f.parts[0]);
    return isLeaf(f);
}

bool isEmpty(const Formula& f) {
    if (f.kind == Kind::Row) return std::ranges::all_of(f.parts, isEmpty);
    return isLeaf(f) && f.text.empty();
}

bool endsWithAny(std::string_view text, std::span<const std::string_view> endings) {
    return std::ranges::any_of(endings, [&](std::string_view s) { return text.ends_with(s); });
}
bool startsWithAny(std::string_view text, std::span<const std::string_view> starts) {
    return std::ranges::any_of(starts, [&](std::string_view s) { return text.starts_with(s); });
}

std::string enclosed(const Formula& part) {
    const std::string text = toText(part);
    return isSingle(part) || (text.starts_with('(') && text.ends_with(')')) ? text : '(' + text + ')';
}

// LaTeX for what Text and Symbol hold beside letters, digits and plain punctuation.
constexpr std::array<std::pair<std::string_view, std::string_view>, 34> kLatex{{
    {"·", "\\cdot "},   {"−", "-"},         {"×", "\\times "},   {"≥", "\\ge "},         {"≤", "\\le "},
    {"≠", "\\ne "},     {"≈", "\\approx "}, {"∞", "\\infty "},   {"°", "^{\\circ}"},     {"→", "\\to "},
    {"\u2009", "\\,"},  {"Σ", "\\sum "},    {"α", "\\alpha "},   {"β", "\\beta "},       {"γ", "\\gamma "},
    {"λ", "\\lambda "}, {"ρ", "\\rho "},    {"θ", "\\theta "},   {"φ", "\\varphi "},     {"ϕ", "\\phi "},
    {"π", "\\pi "},     {"²", "^{2}"},      {"³", "^{3}"},       {"\\", "\\backslash "}, {"{", "\\{"},
    {"}", "\\}"},       {"_", "\\_"},       {"%", "\\%"},        {"&", "\\&"},           {"#", "\\#"},
    {"$", "\\$"},       {"~", "\\sim "},    {"^", "\\hat{\\ }"}, {"…", "\\ldots "},
}};

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::size_t endOfWords(std::string_view text, std::size_t from) {
    std::size_t end = from;
    for (std::size_t i = from; i < text.size() && (isLetter(text[i]) || text[i] == ' '); ++i)
        if (isLetter(text[i])) end = i + 1;
    return end;
}

// Upright: operators and numbers as they are, words in \text, hexadecimal numbers in \texttt.
std::string latexText(std::string_view text) {
    std::string latex;
    for (std::size_t i = 0; i < text.size();) {
        if (text.substr(i).starts_with("0x")) {
            const std::size_t end = std::min(text.find_first_not_of("0123456789abcdefxp.+-", i), text.size());
            latex.append("\\texttt{").append(text.substr(i, end - i)) += '}';
            i = end;
            continue;
        }
        if (isLetter(text[i])) {
            const std::size_t end = endOfWords(text, i);
            const bool function = end < text.size() && text[end] == '(';
            latex.append(function ? "\\operatorname{" : "\\text{").append(text.substr(i, end - i)) += '}';
            i = end;
            continue;
        }
        const auto found =
            std::ranges::find_if(kLatex, [&](const auto& entry) { return text.substr(i).starts_with(entry.first); });
        if (found == kLatex.end())
            latex += text[i++];
        else {
            latex += found->second;
            i += found->first.size();
        }
    }
    while (latex.ends_with(' ')) latex.pop_back();
    return latex;
}

std::string latexSymbol(std::string_view symbol) {
    const bool letters = std::ranges::all_of(symbol, isLetter);
    if (letters) return symbol.size() == 1 ? std::string(symbol) : "\\mathit{" + std::string(symbol) + '}';
    return latexText(symbol);
}

}  // namespace

// (N·L), round(255·I_b/I_max)
bool standApart(std::string_view left, std::string_view right) {
    constexpr std::array<std::string_view, 6> kTightAfter{"(", "·", "/", "|", " ", "\u2009"};
    constexpr std::array<std::string_view, 8> kTightBefore{")", "·", "/", "|", " ", ",", "\u2009", "°"};
    return !left.empty() && !right.empty() && !endsWithAny(left, kTightAfter) && !startsWithAny(right, kTightBefore);
}

std::string toText(const Formula& formula) {
    switch (formula.kind) {
        case Kind::Text:
        case Kind::Symbol:
        case Kind::Vector: return formula.text;
        case Kind::Row: {
            std::string text;
            for (const Formula& part : formula.parts) {
                const std::string next = toText(part);
                if (standApart(text, next)) text += ' ';
                text += next;
            }
            return text;
        }
        case Kind::Script: {
            std::string text = enclosed(formula.parts[0]);
            if (!isEmpty(formula.parts[1])) text += '_' + enclosed(formula.parts[1]);
            if (!isEmpty(formula.parts[2])) text += '^' + enclosed(formula.parts[2]);
            return text;
        }
        case Kind::Fraction: {
            const auto side = [](const Formula& part) {
                return part.kind == Kind::Script ? toText(part) : enclosed(part);
            };
            return side(formula.parts[0]) + '/' + side(formula.parts[1]);
        }
        case Kind::Struck: return '~' + toText(formula.parts[0]) + '~';
    }
    return {};
}

std::string toLatex(const Formula& formula) {
    switch (formula.kind) {
        case Kind::Text: return latexText(formula.text);
        case Kind::Symbol: return latexSymbol(formula.text);
        case Kind::Vector: return "\\boldsymbol{" + formula.text + '}';
        case Kind::Row: {
            std::string latex;
            for (const Formula& part : formula.parts) {
                const std::string next = toLatex(part);
                if (!latex.empty() && !next.empty()) latex += ' ';
                latex += next;
            }
            return latex;
        }
        case Kind::Script: {
            const std::string base = toLatex(formula.parts[0]);
            std::string latex = isSingle(formula.parts[0]) ? base : '{' + base + '}';
            if (!isEmpty(formula.parts[1])) latex += "_{" + toLatex(formula.parts[1]) + '}';
            if (!isEmpty(formula.parts[2])) latex += "^{" + toLatex(formula.parts[2]) + '}';
            return latex;
        }
        case Kind::Fraction: return "\\frac{" + toLatex(formula.parts[0]) + "}{" + toLatex(formula.parts[1]) + '}';
        case Kind::Struck: return "\\cancel{" + toLatex(formula.parts[0]) + '}';
    }
    return {};
}

std::string latexWords(std::string_view text) {
    constexpr std::string_view kPower = "·10^";  // 1.5·10^−6
    std::string latex;
    for (std::size_t i = 0; i < text.size();) {
        if (text.substr(i).starts_with(kPower)) {
            i += kPower.size();
            const bool negative = text.substr(i).starts_with("−");
            if (negative) i += std::string_view("−").size();
            const std::size_t end = std::min(text.find_first_not_of("0123456789", i), text.size());
            latex.append("$\\cdot 10^{").append(negative ? "-" : "").append(text.substr(i, end - i)) += "}$";
            i = end;
            continue;
        }
        const auto found =
            std::ranges::find_if(kLatex, [&](const auto& entry) { return text.substr(i).starts_with(entry.first); });
        if (found == kLatex.end()) {
            latex += text[i++];
            continue;
        }
        std::string_view sign = found->second;
        while (sign.ends_with(' ')) sign.remove_suffix(1);
        // \{ \% \_ are signs of text too; \cdot and ^{2} are not.
        const bool isText = sign.size() == 2 && sign[0] == '\\' && !isLetter(sign[1]);
        latex += isText ? std::string(sign) : '$' + std::string(sign) + '$';
        i += found->first.size();
    }
    return latex;
}

}  // namespace pipeline
