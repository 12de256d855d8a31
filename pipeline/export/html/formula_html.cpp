#include "pipeline/export/html/formula_html.h"

#include "pipeline/export/html/html_text.h"

namespace pipeline {

namespace {

using Kind = Formula::Kind;

// As the text stands apart; in a fraction and in scripts signs are close anyway.
std::string rowHtml(const Formula& row) {
    std::string html, before;
    for (const Formula& part : row.parts) {
        const std::string text = toText(part);
        if (text.empty()) continue;
        if (standApart(before, text)) html += ' ';
        html += toHtml(part);
        before = text;
    }
    return html;
}

std::string within(std::string_view tag, const Formula& part) {
    const std::string html = toHtml(part);
    return html.empty() ? html : '<' + std::string(tag) + '>' + html + "</" + std::string(tag) + '>';
}

}  // namespace

std::string toHtml(const Formula& formula) {
    switch (formula.kind) {
        case Kind::Text: return escapedHtml(formula.text);
        case Kind::Symbol: return formula.text.empty() ? std::string() : element("i", formula.text);
        case Kind::Vector: return element("b class=\"vector " + formula.text + '"', formula.text);
        case Kind::Row: return rowHtml(formula);
        case Kind::Script:
            return toHtml(formula.parts[0]) + within("sub", formula.parts[1]) + within("sup", formula.parts[2]);
        case Kind::Fraction:
            return "<span class=fraction><span>" + toHtml(formula.parts[0]) + "</span><span>" +
                   toHtml(formula.parts[1]) + "</span></span>";
        case Kind::Struck: return within("s", formula.parts[0]);
    }
    return {};
}

std::string_view formulaStyle() {
    return R"(
sub, sup { font-size: .72em; line-height: 0; }
b.vector { font-style: italic; border-bottom: 2px solid; }
b.N { color: #174C72; } b.L { color: #7A6718; border-bottom-style: dashed; }
b.V { color: #137C71; border-bottom-style: double; border-bottom-width: 3px; }
b.R { color: #7A0C12; border-bottom-style: dotted; } b.H { color: #7A47DC; border-bottom-style: groove; }
.fraction { display: inline-flex; flex-direction: column; vertical-align: middle; text-align: center; }
.fraction > :first-child { border-bottom: 1px solid; padding: 0 .2em; }
)";
}

}  // namespace pipeline
