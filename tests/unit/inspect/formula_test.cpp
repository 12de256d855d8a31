#include "pipeline/inspect/formula.h"

#include <gtest/gtest.h>

#include "pipeline/export/html/formula_html.h"
#include "pipeline/inspect/formula_parts.h"

namespace pipeline {
namespace {

using Kind = Formula::Kind;

Formula leaf(Kind kind, std::string text, VectorCode code = VectorCode::None) {
    Formula f;
    f.kind = kind;
    f.text = std::move(text);
    f.vector = code;
    return f;
}
Formula node(Kind kind, std::vector<Formula> parts) {
    Formula f;
    f.kind = kind;
    f.parts = std::move(parts);
    return f;
}
Formula lowered(Formula base, Formula index) {
    return node(Kind::Script, {std::move(base), std::move(index), row({})});
}
Formula dot(const char* a, VectorCode ca, const char* b, VectorCode cb) {
    return row({text("("), leaf(Kind::Vector, a, ca), text("·"), leaf(Kind::Vector, b, cb), text(")")});
}

// Lecture 1's model for one light.
Formula lectureOne() {
    return row({lowered(symbol("I"), symbol("b")), text("="), lowered(symbol("k"), symbol("b")),
                lowered(symbol("I"), symbol("a")), text("+"), lowered(symbol("S"), text("0")),
                lowered(symbol("I"), text("0")), text("["), lowered(symbol("k"), symbol("b")),
                dot("N", VectorCode::N, "L", VectorCode::L), text("+"), lowered(symbol("k"), symbol("s")),
                power(dot("R", VectorCode::R, "V", VectorCode::V), symbol("n")), text("]")});
}

TEST(Formula, ReadsAsText) {
    EXPECT_EQ(toText(lectureOne()), "I_b = k_b I_a + S_0 I_0 [ k_b (N·L) + k_s (R·V)^n ]");
    EXPECT_EQ(toText(row({text("="), text("0.9"), text("·"), text("50")})), "= 0.9·50");
    EXPECT_EQ(toText(row({text("("), text("1"), text(","), text("2"), text(")")})), "(1, 2)");
}

TEST(Formula, ReadsAsLatex) {
    EXPECT_EQ(toLatex(lectureOne()),
              "I_{b} = k_{b} I_{a} + S_{0} I_{0} [ k_{b} ( \\boldsymbol{N} \\cdot \\boldsymbol{L} ) + k_{s} "
              "{( \\boldsymbol{R} \\cdot \\boldsymbol{V} )}^{n} ]");
    EXPECT_EQ(toLatex(text("round(255·I")), "\\operatorname{round}(255\\cdot \\text{I}");
    EXPECT_EQ(toLatex(symbol("FB")), "\\mathit{FB}");
    EXPECT_EQ(toLatex(symbol("ρ")), "\\rho");
    EXPECT_EQ(toLatex(text("−1\u2009991.6 ≥ 5 %")), "-1\\,991.6 \\ge  5 \\%");
    EXPECT_EQ(toLatex(text("in the shadow of a_b")), "\\text{in the shadow of a}\\_\\text{b}");
}

TEST(Formula, FractionsAndScriptsKeepTheirParts) {
    const Formula ratio = node(Kind::Fraction, {row({text("255"), text("·"), lowered(symbol("I"), symbol("b"))}),
                                                lowered(symbol("I"), text("max"))});
    EXPECT_EQ(toText(ratio), "(255·I_b)/I_max");
    EXPECT_EQ(toLatex(ratio), "\\frac{255 \\cdot I_{b}}{I_{\\text{max}}}");
    EXPECT_EQ(toText(power(row({symbol("a"), text("+"), symbol("b")}), text("2"))), "(a + b)^2");
    EXPECT_EQ(toText(node(Kind::Script, {symbol("x"), symbol("s"), row({symbol("n"), text("+"), text("1")})})),
              "x_s^(n + 1)");
}

TEST(Formula, AClampedNumberStaysLegible) {
    const Formula clamped = row({node(Kind::Struck, {text("−0.31")}), text("0")});
    EXPECT_EQ(toText(clamped), "~−0.31~ 0");
    EXPECT_EQ(toLatex(clamped), "\\cancel{-0.31} 0");
}

TEST(Formula, IsWrittenAsHtml) {
    EXPECT_EQ(
        toHtml(lectureOne()),
        "<i>I</i><sub><i>b</i></sub> = <i>k</i><sub><i>b</i></sub> <i>I</i><sub><i>a</i></sub> + <i>S</i><sub>0</sub> "
        "<i>I</i><sub>0</sub> [ <i>k</i><sub><i>b</i></sub> (<b class=\"vector N\">N</b>·<b class=\"vector L\">L</b>) "
        "+ "
        "<i>k</i><sub><i>s</i></sub> (<b class=\"vector R\">R</b>·<b class=\"vector V\">V</b>)<sup><i>n</i></sup> ]");
    EXPECT_EQ(toHtml(node(Kind::Struck, {text("-0.2 < 0")})), "<s>-0.2 &lt; 0</s>");
    EXPECT_EQ(toHtml(node(Kind::Fraction, {symbol("I"), text("175")})),
              "<span class=fraction><span><i>I</i></span><span>175</span></span>");
    EXPECT_EQ(toHtml(row({})), "");
}

}  // namespace
}  // namespace pipeline
