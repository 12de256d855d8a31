#pragma once
#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "pipeline/inspect/formula.h"

namespace pipeline {

// Short names for building formulas.

inline Formula text(std::string words, std::string refers = {}) {
    Formula f;
    f.kind = Formula::Kind::Text, f.text = std::move(words), f.refers = std::move(refers);
    return f;
}
inline Formula symbol(std::string letter, std::string refers = {}) {
    Formula f = text(std::move(letter), std::move(refers));
    f.kind = Formula::Kind::Symbol;
    return f;
}
inline Formula vector(VectorCode code, std::string refers = {}) {
    static constexpr const char* kLetters[]{"", "N", "L", "V", "R", "H"};
    Formula f = symbol(kLetters[std::size_t(code)], std::move(refers));
    f.kind = Formula::Kind::Vector, f.vector = code;
    return f;
}
inline Formula row(std::vector<Formula> parts) {
    Formula f;
    f.parts = std::move(parts);
    return f;
}
inline Formula script(Formula base, Formula sub, Formula super, std::string refers = {}) {
    Formula f = row({std::move(base), std::move(sub), std::move(super)});
    f.kind = Formula::Kind::Script, f.refers = std::move(refers);
    return f;
}
inline Formula sub(std::string letter, std::string index, std::string refers = {}) {
    return script(symbol(std::move(letter)), text(std::move(index)), row({}), std::move(refers));
}
inline Formula power(Formula base, Formula exponent) {
    // A number that ends in a power of its own: 1.5·10^−6, 0x1.8p-1.
    if (base.kind == Formula::Kind::Script || base.text.find('p') != std::string::npos)
        base = row({text("("), std::move(base), text(")")});
    return script(std::move(base), row({}), std::move(exponent));
}
inline Formula fraction(Formula top, Formula bottom) {
    Formula f = row({std::move(top), std::move(bottom)});
    f.kind = Formula::Kind::Fraction;
    return f;
}
inline Formula struck(Formula what) {
    Formula f = row({std::move(what)});
    f.kind = Formula::Kind::Struck;
    return f;
}

// Numbers as the window writes them: a true minus sign, and no "-0".
inline std::string withMinus(std::string number) {
    if (number.empty() || number[0] != '-') return number;
    if (number.find_first_of("123456789") == std::string::npos) return number.substr(1);
    return fmt::format("−{}", number.substr(1));
}
inline std::string fixed(double value, int decimals) { return withMinus(fmt::format("{:.{}f}", value, decimals)); }
inline std::string shortest(double value) { return withMinus(fmt::format("{}", value)); }

// A number's text; "1.5e-6" with its power of ten set high: 1.5·10^−6. 0x1.8p-1 stays as it is.
inline Formula numeral(std::string number, std::string refers = {}) {
    const std::size_t e = number.find('e');
    if (e == std::string::npos || number.find('x') != std::string::npos)
        return text(std::move(number), std::move(refers));
    return script(text(number.substr(0, e) + "·10"), row({}), text(withMinus(number.substr(e + 1))), std::move(refers));
}

}  // namespace pipeline
