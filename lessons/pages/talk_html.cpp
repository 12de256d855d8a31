#include "lessons/pages/talk_html.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <regex>

#include "lessons/pages/talk_words.h"
#include "pipeline/core/text.h"
#include "pipeline/export/html/formula_mathml.h"
#include "pipeline/export/html/html_text.h"

namespace lessons {

namespace {

using pipeline::AlgorithmRow;
using pipeline::element;
using pipeline::escapedHtml;
using pipeline::LineStatus;

std::string_view classOf(LineStatus status) {
    switch (status) {
        case LineStatus::Now: return "now";
        case LineStatus::LeftOut: return "left-out";
        case LineStatus::Elsewhere: return "elsewhere";
        case LineStatus::NotTaken: return "not-taken";
        case LineStatus::Passed:
        case LineStatus::Next:
        case LineStatus::Ahead: break;
    }
    return "line";
}

// Escaping makes none of the language's words.
std::string codeHtml(const std::string& text) {
    static const std::regex s_words(kLanguageWords);
    return std::regex_replace(escapedHtml(text), s_words, "<b>$1</b>");
}

std::string rowHtml(const AlgorithmRow& row) {
    const bool isNow = row.status == LineStatus::Now;
    std::string html = fmt::format("<li class=\"{}\"{}><span class=\"n\">{}</span><span class=\"text\">",
                                   classOf(row.status), isNow ? " aria-current=\"step\"" : "", row.number);
    html += std::string(2 * std::size_t(row.indent), ' ') + codeHtml(row.text) + "</span>";
    const bool hasValues = !row.valuesText.empty() && (isNow || !row.taken);
    if (hasValues) html += element("span class=\"values\"", row.valuesText);
    const bool isBranch = isNow && row.taken;  // its comparison, then which way it goes
    if (!row.remark.empty() && (!hasValues || isBranch))
        html += element("span class=\"remark\"", (!isBranch ? "" : *row.taken ? "● " : "– ") + row.remark);
    return html + "</li>\n";
}

// From the first number of a loop to the last, with the current one.
std::string loopHtml(const pipeline::AlgorithmValue::Range& range) {
    const std::string says = fmt::format("{}: {} of {} to {}", range.name, range.at, range.first, range.last);
    return fmt::format(
        "<p class=\"loop\"><span>{}</span> <span>{}</span> <progress max=\"{}\" value=\"{}\" aria-label=\"{}\">"
        "</progress> <span>{}</span></p>\n",
        escapedHtml(range.name), range.first, range.last - range.first + 1, double(range.at - range.first) + 0.5,
        escapedHtml(says), range.last);
}

std::string swatch(pipeline::Color8 color) {
    return fmt::format(
        "<svg class=\"swatch\" viewBox=\"0 0 1 1\" aria-hidden=\"true\"><rect width=\"1\" height=\"1\" "
        "fill=\"#{:02x}{:02x}{:02x}\"/></svg>",
        color.r, color.g, color.b);
}

}  // namespace

std::string sentenceHtml(const std::string& text) {
    std::string html;
    for (const SetPiece& piece : setPieces(text)) switch (piece.script) {
            case SetPiece::Script::None: html += escapedHtml(piece.text); break;
            case SetPiece::Script::Below: html += element("sub", piece.text); break;
            case SetPiece::Script::Raised: html += element("sup", piece.text); break;
        }
    return html;
}

std::string algorithmHtml(const pipeline::AlgorithmState& state) {
    const std::vector<AlgorithmRow> rows = rowsOf(state);
    const auto [first, last] = rowsAround(rows, kMostAlgorithmRows);
    const auto beyond = [](std::size_t count, std::string_view where) {
        return count == 0 ? std::string()
                          : element("p class=\"why\"",
                                    pipeline::plural(std::int64_t(count), "line") + ' ' + std::string(where));
    };
    std::string html = fmt::format("<div class=\"algorithm\" role=\"group\" aria-label=\"{}\">\n",
                                   escapedHtml(state.walk.algorithm.row->title)) +
                       beyond(first, "above") + fmt::format("<ol class=\"code\" start=\"{}\">\n", first + 1);
    for (std::size_t i = first; i < last; ++i) html += rowHtml(rows[i]);
    html += "</ol>\n" + beyond(rows.size() - last, "below");
    if (const auto* inner = pipeline::innermostLoop(rows)) html += loopHtml(*inner->range);
    for (const std::string& sentence : state.leftOut()) html += element("p class=\"why\"", sentence) + '\n';
    return html + "</div>\n";
}

std::string equationHtml(const std::vector<pipeline::EquationLine>& lines) {
    std::string html;
    for (const pipeline::EquationLine& line : lines) {
        html += fmt::format("<div role=\"math\" aria-label=\"{}\">", escapedHtml(toText(line.formula)));
        for (std::string part : pipeline::mathmlParts(line.formula)) {
            // A sign at the beginning of a part is between two, though it is the first of its element.
            for (const std::string_view sign : {"<mo>=</mo>", "<mo>+</mo>"})
                if (part.starts_with(sign)) part.insert(3, " form=\"infix\"");
            html += "<math>" + part + "</math> ";
        }
        html += "</div>\n";
    }
    return html.empty() ? html : "<div class=\"equation\">" + html + "</div>\n";
}

std::string choicesHtml(const CueQuestion& question, bool isAnswer) {
    std::string html = "<ol class=\"choices\" type=\"A\">\n";
    for (std::size_t i = 0; i < question.choices.size(); ++i) {
        const bool right = isAnswer && i == question.right;
        html += fmt::format("<li{}><b>{}</b><span>{}{}</span></li>\n", right ? " class=\"right\"" : "", char('A' + i),
                            sentenceHtml(question.choices[i]), right ? " <em>● right</em>" : "");
    }
    return html + "</ol>\n";
}

std::string legendHtml(const TalkLegend& legend) {
    if (!legend.palette.empty()) {
        std::string bars;
        for (std::size_t i = 0; i < legend.palette.size(); ++i) {
            const pipeline::Color8 c = legend.palette[i];
            // A little wider than 1, so that no line of the ground is between two.
            bars += fmt::format("<rect x=\"{}\" width=\"1.1\" height=\"1\" fill=\"#{:02x}{:02x}{:02x}\"/>", i, c.r, c.g,
                                c.b);
        }
        return fmt::format(
            "<p class=\"range\"><span class=\"number\">{}</span> <svg viewBox=\"0 0 {} 1\" "
            "preserveAspectRatio=\"none\" "
            "role=\"img\" aria-label=\"to\">{}</svg> <span class=\"number\">{}</span>{}</p>\n",
            escapedHtml(legend.low), legend.palette.size(), bars, escapedHtml(legend.high),
            legend.unit.empty() ? std::string() : ' ' + element("span", legend.unit));
    }
    if (legend.names.empty()) return {};
    constexpr std::size_t kMost = 12;
    std::string html = "<ul class=\"names\">\n";
    for (std::size_t i = 0; i < std::min(kMost, legend.names.size()); ++i)
        html += "<li>" + swatch(legend.names[i].first) + ' ' + escapedHtml(legend.names[i].second) + "</li>\n";
    if (legend.names.size() > kMost) html += element("li", fmt::format("and {} more", legend.names.size() - kMost));
    return html + "</ul>\n";
}

}  // namespace lessons
