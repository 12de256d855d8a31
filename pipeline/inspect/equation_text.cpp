#include "pipeline/inspect/equation_text.h"

#include <algorithm>

namespace pipeline {
namespace {

bool isEquals(const Formula& part) { return part.kind == Formula::Kind::Text && part.text == "="; }

Formula rowOf(std::vector<Formula>::const_iterator from, std::vector<Formula>::const_iterator to) {
    Formula row;
    row.parts.assign(from, to);
    return row;
}

// "39.2°" stands behind its line; words stand on the next one.
bool isAngle(std::string_view remark) { return remark.ends_with("°"); }

// What aligned environments hold: a left side, & before the first equals sign, \\ at the end.
std::string alignedLines(const EquationLine& line) {
    const std::vector<Formula>& parts = line.formula.parts;
    const auto equals = std::ranges::find_if(parts, isEquals);
    std::string latex;
    if (equals == parts.end()) {
        latex = "&\\text{" + latexWords(toText(line.formula)) + '}';
    } else {
        latex = toLatex(rowOf(parts.begin(), equals));
        latex.append(latex.empty() ? "&" : " &").append(toLatex(rowOf(equals, parts.end())));
    }
    if (isAngle(line.remark))
        latex += "\\quad \\text{" + latexWords(line.remark) + '}';
    else if (!line.remark.empty())
        latex += " \\\\\n&\\text{" + latexWords(line.remark) + '}';
    return latex;
}

}  // namespace

std::string equationText(std::span<const EquationLine> lines, EquationFormat format) {
    std::string out;
    for (const EquationLine& line : lines) {
        if (format == EquationFormat::Text) {
            out += toText(line.formula);
            if (!line.remark.empty()) out.append("   ").append(line.remark);
            out += '\n';
            continue;
        }
        if (!out.empty()) out += " \\\\\n";
        out += alignedLines(line);
    }
    if (out.empty() || format == EquationFormat::Text) return out;
    return format == EquationFormat::Markdown
               ? "$$\n\\begin{aligned}\n" + out + "\n\\end{aligned}\n$$\n"
               : "% \\usepackage{amsmath, cancel}\n\\begin{align*}\n" + out + "\n\\end{align*}\n";
}

}  // namespace pipeline
