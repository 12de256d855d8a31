#include "app/inspector/math_page.h"

#include <QFontMetricsF>
#include <algorithm>

#include "app/look/text.h"
#include "app/look/theme.h"

namespace app {

namespace {

using pipeline::EquationLine;
using pipeline::Formula;
using FormulaKind = Formula::Kind;

bool isText(const Formula& part, const char* text) { return part.kind == FormulaKind::Text && part.text == text; }

// Rows within rows are one row, unless they stand for something together.
void flatten(const Formula& formula, std::vector<Formula>& parts) {
    if (formula.kind == FormulaKind::Row && formula.refers.empty()) {
        for (const Formula& part : formula.parts) flatten(part, parts);
    } else {
        parts.push_back(formula);
    }
}

Formula rowOf(std::vector<Formula>::const_iterator begin, std::vector<Formula>::const_iterator end) {
    Formula row;
    row.parts.assign(begin, end);
    return row;
}

struct Line {
    Formula left;                   // of the first =
    std::vector<Formula> segments;  // may stand on lines of their own; the first begins with =
    bool isRow = false;
};

bool isNumber(const Formula& part) {
    if (part.kind == FormulaKind::Script) return isNumber(part.parts[0]);  // with its power of ten
    if (part.kind != FormulaKind::Text || part.text.empty()) return false;
    const QString text = toQString(part.text);
    return text[0].isDigit() || (text.size() > 1 && text[0] == QChar(0x2212) && text[1].isDigit());
}

Line split(const EquationLine& equation) {
    std::vector<Formula> parts;
    flatten(equation.formula, parts);
    Line line;
    line.isRow = equation.role == "row";
    auto from = std::find_if(parts.begin(), parts.end(), [](const Formula& p) { return isText(p, "="); });
    line.left = rowOf(parts.begin(), from);
    int depth = 0;
    auto start = from;
    for (auto part = from; part != parts.end(); ++part) {
        const bool breaks = part != from && ((depth <= 1 && isText(*part, "+")) || (depth == 0 && isText(*part, "=")) ||
                                             (line.isRow && depth == 0 && isText(*part, "·")));
        if (breaks) {
            line.segments.push_back(rowOf(start, part));
            start = part;
        }
        if (part->kind == FormulaKind::Text)
            for (const char c : part->text) depth += (c == '(' || c == '[') - (c == ')' || c == ']');
    }
    line.segments.push_back(rowOf(start, parts.end()));
    return line;
}

// A number alone behind the last = is the line's result.
bool isResult(const EquationLine& equation, const Line& line, const Formula& segment) {
    return &segment == &line.segments.back() && equation.role != "symbols" && equation.role != "numbers" &&
           !segment.parts.empty() && isText(segment.parts.front(), "=") && segment.parts.size() == 2 &&
           isNumber(segment.parts.back());
}

// Gives the leaves of a line numbers of their own: segments are laid out one by one.
MathBox numbered(MathBox box, int& leaves) {
    int count = 0;
    for (MathPart& part : box.parts) {
        if (part.leaf < 0) continue;
        part.leaf += leaves;
        ++count;
    }
    leaves += count;
    return box;
}

struct PageMaker {
    double size, width;
    double column = 0;  // of the = signs
    MathPage page{};
    int line = 0;

    void add(const MathBox& box, double x, double baseline) {
        page.box.place(box, x, baseline);
        page.lineOfPart.resize(page.box.parts.size(), line);
    }

    // One line of the page: boxes on a base line, as high as the pitch at least.
    void addRow(const std::vector<std::pair<double, MathBox>>& boxes, double pitch) {
        double ascent = 0.5 * pitch, descent = 0.18 * pitch;
        for (const auto& [x, box] : boxes) {
            ascent = std::max(ascent, box.ascent);
            descent = std::max(descent, box.descent);
        }
        const double height = std::max(pitch, ascent + descent + 0.2 * size);
        const double baseline = page.height + (height - ascent - descent) / 2 + ascent;
        for (const auto& [x, box] : boxes) add(box, x, baseline);
        page.height += height;
    }

    void addLine(const EquationLine& equation);
    void addRemark(const EquationLine& equation);
    void addWords(const QString& text, double x);
};

MathBox remarkBox(const QString& text) {
    const QFont font = Theme::current().mono(12);
    MathBox box;
    box.width = QFontMetricsF(font).horizontalAdvance(text);
    box.ascent = 0.8 * font.pixelSize();
    box.descent = 0.2 * font.pixelSize();
    box.pieces.push_back({.text = text, .font = font});
    return box;
}

bool isAngle(const std::string& remark) { return remark.ends_with("°"); }

void PageMaker::addLine(const EquationLine& equation) {
    const Line source = split(equation);
    const double s = source.isRow ? 0.8 * size : size, pitch = source.isRow ? 1.45 * s : 1.5 * s;
    const double begin = source.isRow ? 2.5 * size : column;
    int leaves = 0;
    std::vector<std::pair<double, MathBox>> row;
    row.emplace_back(0, numbered(layoutFormula(source.left, s), leaves));
    if (row[0].second.width > begin - 0.3 * s && row[0].second.width > 0) {
        // A left-hand side that does not fit its column has a line of its own.
        addRow(row, pitch);
        row.clear();
    }
    double x = begin;
    for (const Formula& segment : source.segments) {
        const MathBox box = numbered(layoutFormula(segment, s, isResult(equation, source, segment)), leaves);
        const double gap = x > begin ? 0.22 * s : 0;
        if (x > begin && x + gap + box.width > width) {
            addRow(row, pitch);
            row.clear();
            const bool startsWithEqual = !segment.parts.empty() && isText(segment.parts.front(), "=");
            x = startsWithEqual ? begin : begin + s;
            row.emplace_back(x, box);
        } else {
            x += gap;
            row.emplace_back(x, box);
        }
        x += box.width;
    }
    if (isAngle(equation.remark)) {
        const MathBox remark = remarkBox(toQString(equation.remark));
        if (x + 0.3 * s + remark.width > width) {
            addRow(row, pitch);
            row.clear();
        }
        row.emplace_back(width - remark.width, remark);
    }
    addRow(row, pitch);
}

void PageMaker::addRemark(const EquationLine& equation) {
    if (!equation.remark.empty() && !isAngle(equation.remark)) addWords(toQString(equation.remark), column);
}

// Words in the text's face, broken between words.
void PageMaker::addWords(const QString& text, double x) {
    const QFont font = Theme::current().text(12);
    const QFontMetricsF metrics(font);
    QString words;
    const auto flush = [&] {
        MathBox box;
        box.pieces.push_back({.text = words, .font = font, .tone = MathTone::Quiet});
        box.width = metrics.horizontalAdvance(words);
        box.ascent = metrics.ascent();
        box.descent = metrics.descent();
        addRow({{x, box}}, 1.5 * font.pixelSize());
    };
    for (const QString& word : text.split(' ')) {
        const QString longer = words.isEmpty() ? word : words + ' ' + word;
        if (!words.isEmpty() && x + metrics.horizontalAdvance(longer) > width) {
            flush();
            words = word;
        } else {
            words = longer;
        }
    }
    flush();
}

}  // namespace

bool isWords(const EquationLine& line) { return line.role == "note" || line.role == "was"; }

MathPage layoutEquation(const std::vector<EquationLine>& lines, double size, double width) {
    PageMaker maker{.size = size, .width = width};
    maker.column = 3 * size;
    for (const EquationLine& line : lines) {
        // Air where the rows of vectors begin, and where the next evaluation does.
        if (maker.line > 0 && line.role == "row" && lines[std::size_t(maker.line) - 1].role != "row")
            maker.page.height += 0.3 * size;
        if (maker.line > 0 && line.role == "symbols") maker.page.height += 0.6 * size;
        if (isWords(line)) {
            maker.addWords(toQString(toText(line.formula)), line.role == "was" ? maker.column : 0);
        } else {
            maker.addLine(line);
            maker.addRemark(line);
        }
        ++maker.line;
    }
    return maker.page;
}

}  // namespace app
