#pragma once
#include <QLineF>
#include <QPainter>
#include <QRectF>
#include <QString>
#include <vector>

#include "pipeline/inspect/formula.h"

namespace app {

// How a piece of a formula is painted. Colours come from the theme when it is.
enum class MathTone : unsigned char { Normal, Quiet, Vector };

// Glyphs, or a stroke, at a place relative to its box.
struct MathPiece {
    enum class Kind : unsigned char { Glyphs, Rule, Strike, Underline };
    Kind kind = Kind::Glyphs;
    QPointF at{};  // of glyphs: the start of the base line
    QString text{};
    QFont font{};
    QLineF stroke{};  // of a rule, a strike, an underline
    MathTone tone = MathTone::Normal;
    pipeline::VectorCode vector = pipeline::VectorCode::None;
};

// A part that stands for a buffer or a setting, or a leaf that changed.
struct MathPart {
    QRectF rect{};
    QString refers{};  // empty for a leaf without
    int leaf = -1;     // index among the leaves of its line, -1 for a group
    QString text{};    // as a screen reader says it
};

// A box of a formula. The base line is y = 0; y grows downwards.
struct MathBox {
    double width = 0, ascent = 0, descent = 0;
    std::vector<MathPiece> pieces{};
    std::vector<MathPart> parts{};

    void place(const MathBox& box, double x, double y);
};

// What a formula looks like at size s (pixels).
//   bold   numbers in bold: results
MathBox layoutFormula(const pipeline::Formula& formula, double s, bool bold = false);

// The leaves of a formula, left to right, as text: two formulas of one shape differ in the leaves
// that differ.
std::vector<QString> leavesOf(const pipeline::Formula& formula);

void paintMath(QPainter& painter, const MathBox& box, QPointF origin);

}  // namespace app
