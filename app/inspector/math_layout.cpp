#include "app/inspector/math_layout.h"

#include <QFontMetricsF>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/look/text.h"
#include "app/look/theme.h"

namespace app {

namespace {

using pipeline::Formula;
using FormulaKind = Formula::Kind;

// How much room stands between two neighbours of a row; in ems.
enum class Spacing : unsigned char { Plain, Operator, Dot, Open, Close, Bracket, Comma };

Spacing spacingOf(const Formula& part) {
    if (part.kind != FormulaKind::Text) return Spacing::Plain;
    static const QStringList operators{"=", "+", "−", "-", "<", ">", "≤", "≥", "≠", "≈", "×", ":="};
    const QString text = toQString(part.text).trimmed();
    if (operators.contains(text)) return Spacing::Operator;
    if (text == "·") return Spacing::Dot;
    if (text == "," || text == ";") return Spacing::Comma;
    if (text == "[" || text == "]") return Spacing::Bracket;
    if (text.endsWith('(') || text.endsWith("·") || text == "|") return Spacing::Open;
    if (text.startsWith(')') || text.startsWith("·")) return Spacing::Close;
    return Spacing::Plain;
}

double gapBetween(const Formula& left, const Formula& right, bool leftIsSign) {
    const Spacing a = spacingOf(left), b = spacingOf(right);
    const auto isWide = [](const Formula& f) {
        return f.kind == FormulaKind::Fraction || f.kind == FormulaKind::Struck;
    };
    if (isWide(left) || isWide(right)) return 0.22;
    if (leftIsSign || a == Spacing::Open || b == Spacing::Close || b == Spacing::Comma) return 0;
    if (a == Spacing::Operator || b == Spacing::Operator) return 0.22;
    if (a == Spacing::Dot || b == Spacing::Dot) return 0.17;
    if (a == Spacing::Comma) return 0.22;
    return a == Spacing::Plain && b == Spacing::Plain ? 0.17 : 0.12;
}

struct Context {
    double s;
    bool bold, quiet;
    int* leaf;  // counts the leaves
};

MathBox layout(const Formula& formula, Context context);

QFont fontFor(const Formula& leaf, const Context& c) {
    QFont font = Theme::current().formula(1);
    font.setPixelSize(std::max(1, int(std::lround(c.s))));
    font.setItalic(leaf.kind != FormulaKind::Text);
    font.setBold(leaf.kind == FormulaKind::Vector || (c.bold && spacingOf(leaf) == Spacing::Plain));
    return font;
}

MathBox layoutLeaf(const Formula& leaf, const Context& c) {
    MathBox box;
    const QFont font = fontFor(leaf, c);
    const QString text = toQString(leaf.text);
    box.width = QFontMetricsF(font).horizontalAdvance(text);
    box.ascent = 0.72 * c.s;
    box.descent = 0.22 * c.s;
    const bool isVector = leaf.kind == FormulaKind::Vector;
    box.pieces.push_back({.at = {0, 0},
                          .text = text,
                          .font = font,
                          .tone = c.quiet    ? MathTone::Quiet
                                  : isVector ? MathTone::Vector
                                             : MathTone::Normal,
                          .vector = leaf.vector});
    if (isVector) {
        const double y = 0.22 * c.s;
        box.pieces.push_back({.kind = MathPiece::Kind::Underline,
                              .stroke = {0, y, box.width, y},
                              .tone = MathTone::Vector,
                              .vector = leaf.vector});
        box.descent = y + 3;
    }
    box.parts.push_back(
        {.rect = {0, -box.ascent, box.width, box.ascent + box.descent}, .leaf = (*c.leaf)++, .text = text});
    return box;
}

MathBox layoutRow(const std::vector<const Formula*>& parts, const Context& c) {
    MathBox row;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (i > 0) {
            // A minus after nothing or after an operator or a bracket is a sign: it stands at its number.
            const bool afterOperator =
                i == 1 || spacingOf(*parts[i - 2]) == Spacing::Operator || spacingOf(*parts[i - 2]) == Spacing::Open;
            const bool leftIsSign =
                parts[i - 1]->kind == FormulaKind::Text && parts[i - 1]->text == "−" && afterOperator;
            row.width += c.s * gapBetween(*parts[i - 1], *parts[i], leftIsSign);
        }
        row.place(layout(*parts[i], c), row.width, 0);
    }
    return row;
}

MathBox layoutScript(const Formula& formula, const Context& c) {
    MathBox box = layout(formula.parts[0], c);
    Context small = c;
    small.s = 0.7 * c.s;
    const double x = box.width + 0.04 * c.s;
    const MathBox sub = layout(formula.parts[1], small), super = layout(formula.parts[2], small);
    const double descent = box.descent;
    box.place(sub, x, 0.18 * c.s);
    box.width = x;
    box.place(super, x, -0.36 * c.s);
    box.width = x + std::max(sub.width, super.width);
    if (sub.width == 0) box.descent = descent;
    return box;
}

MathBox layoutFraction(const Formula& formula, const Context& c) {
    Context inner = c;
    inner.s = 0.86 * c.s;
    const MathBox top = layout(formula.parts[0], inner), bottom = layout(formula.parts[1], inner);
    MathBox box;
    const double width = std::max(top.width, bottom.width) + 0.3 * c.s, rule = -0.25 * c.s, gap = 0.12 * c.s;
    box.place(top, (width - top.width) / 2, rule - gap - top.descent);
    box.place(bottom, (width - bottom.width) / 2, rule + gap + bottom.ascent);
    box.pieces.push_back({.kind = MathPiece::Kind::Rule, .stroke = {0, rule, width, rule}});
    box.width = width;
    return box;
}

MathBox layoutStruck(const Formula& formula, const Context& c) {
    Context quiet = c;
    quiet.quiet = true;
    MathBox box = layout(formula.parts[0], quiet);
    // Slanted, so that it does not hide a minus sign.
    box.pieces.push_back({.kind = MathPiece::Kind::Strike, .stroke = {-1, -0.08 * c.s, box.width + 1, -0.5 * c.s}});
    return box;
}

MathBox layout(const Formula& formula, Context c) {
    MathBox box;
    switch (formula.kind) {
        case FormulaKind::Text:
        case FormulaKind::Symbol:
        case FormulaKind::Vector: box = layoutLeaf(formula, c); break;
        case FormulaKind::Row: {
            std::vector<const Formula*> parts;
            for (const Formula& part : formula.parts) parts.push_back(&part);
            box = layoutRow(parts, c);
            break;
        }
        case FormulaKind::Script: box = layoutScript(formula, c); break;
        case FormulaKind::Fraction: box = layoutFraction(formula, c); break;
        case FormulaKind::Struck: box = layoutStruck(formula, c); break;
    }
    if (!formula.refers.empty())
        box.parts.push_back({.rect = {0, -box.ascent, box.width, box.ascent + box.descent},
                             .refers = toQString(formula.refers),
                             .text = toQString(toText(formula))});
    return box;
}

void collectLeaves(const Formula& formula, std::vector<QString>& leaves) {
    if (formula.kind == FormulaKind::Text || formula.kind == FormulaKind::Symbol || formula.kind == FormulaKind::Vector)
        leaves.push_back(toQString(formula.text));
    for (const Formula& part : formula.parts) collectLeaves(part, leaves);
}

}  // namespace

void MathBox::place(const MathBox& box, double x, double y) {
    for (MathPiece piece : box.pieces) {
        piece.at += QPointF(x, y);
        piece.stroke.translate(x, y);
        pieces.push_back(std::move(piece));
    }
    for (MathPart part : box.parts) {
        part.rect.translate(x, y);
        parts.push_back(std::move(part));
    }
    width = std::max(width, x + box.width);
    ascent = std::max(ascent, box.ascent - y);
    descent = std::max(descent, box.descent + y);
}

MathBox layoutFormula(const Formula& formula, double s, bool bold) {
    int leaf = 0;
    return layout(formula, {s, bold, false, &leaf});
}

std::vector<QString> leavesOf(const Formula& formula) {
    std::vector<QString> leaves;
    collectLeaves(formula, leaves);
    return leaves;
}

void paintMath(QPainter& painter, const MathBox& box, QPointF origin) {
    const Theme& theme = Theme::current();
    const ThemeColors& colors = theme.colors();
    for (const MathPiece& piece : box.pieces) {
        const QColor color = piece.tone == MathTone::Quiet    ? colors.text3
                             : piece.tone == MathTone::Vector ? theme.vector(piece.vector)
                                                              : colors.text;
        const QLineF stroke = piece.stroke.translated(origin);
        switch (piece.kind) {
            case MathPiece::Kind::Glyphs:
                painter.setFont(piece.font);
                painter.setPen(color);
                painter.drawText(piece.at + origin, piece.text);
                break;
            case MathPiece::Kind::Rule:
                painter.setPen(QPen(color, 1.3));
                painter.drawLine(stroke);
                break;
            case MathPiece::Kind::Strike:
                painter.setPen(QPen(colors.failed, 2));
                painter.drawLine(stroke);
                break;
            case MathPiece::Kind::Underline: {
                QPen pen(color, 2);
                pen.setCapStyle(piece.vector == pipeline::VectorCode::H ? Qt::RoundCap : Qt::FlatCap);
                if (piece.vector == pipeline::VectorCode::V) {  // a double line: its dash is too long for a letter
                    pen.setWidthF(1);
                    painter.setPen(pen);
                    painter.drawLine(stroke.translated(0, -1));
                    painter.drawLine(stroke.translated(0, 1));
                    break;
                }
                if (const auto dash = Theme::dash(piece.vector); !dash.isEmpty()) pen.setDashPattern(dash);
                painter.setPen(pen);
                painter.drawLine(stroke);
                break;
            }
        }
    }
}

}  // namespace app
