#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pipeline {

// The five vectors of the lectures; a formula, a 3D view and a table show each in the same code.
enum class VectorCode : unsigned char { None, N, L, V, R, H };

// A formula as a tree of boxes: typeset in the window, written out as text, Markdown or LaTeX.
struct Formula {
    enum class Kind : unsigned char {
        Text,      // an operator, a number or upright words, as is
        Symbol,    // a letter in italics: I, k, n
        Vector,    // a letter in bold italics, coloured and underlined in its code
        Row,       // parts one after the other
        Script,    // parts: base, subscript, superscript (an empty Row where there is none)
        Fraction,  // parts: numerator, denominator
        Struck,    // part 0 struck through: a number that a clamp or a factor 0 removed
    };
    Kind kind = Kind::Row;
    std::string text;  // Text, Symbol, Vector (UTF-8)
    VectorCode vector = VectorCode::None;
    std::string refers;  // the buffer or setting that this part stands for: "n_dot_l.0", "material.0.n"
    std::vector<Formula> parts;
};

// How a person wants what was computed written, "1.5e-6", "0x1.8p-1"; nothing: in the digits that the lecture gives it.
using NumberText = std::function<std::optional<std::string>(double)>;

// Whether parts of a row stand apart by a space, by their texts: not at ( ) · / | , and °.
bool standApart(std::string_view left, std::string_view right);

// What is struck stands between ~.
std::string toText(const Formula& formula);
std::string toLatex(const Formula& formula);  // without $
// A sentence for the inside of \text{…}: signs that plain text lacks stand between $.
std::string latexWords(std::string_view text);

}  // namespace pipeline
