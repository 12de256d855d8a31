#include "pipeline/export/html/formula_mathml.h"

#include <gtest/gtest.h>

#include "pipeline/inspect/formula_parts.h"

namespace pipeline {
namespace {

TEST(FormulaMathml, HasAnElementForEverySign) {
    EXPECT_EQ(toMathml(text("= 0.9")), "<mo>=</mo><mn>0.9</mn>");
    EXPECT_EQ(toMathml(text("max(0, ")),
              "<mi mathvariant=\"normal\">max</mi><mo stretchy=\"false\">(</mo><mn>0</mn><mo>,</mo>");
    EXPECT_EQ(toMathml(text("−1\u2009991.6")), "<mo form=\"prefix\">−</mo><mn>1\u2009991.6</mn>");
    EXPECT_EQ(toMathml(text("2−3")), "<mn>2</mn><mo>−</mo><mn>3</mn>") << "a difference";
    EXPECT_EQ(toMathml(sub("I", "max")),
              "<msub><mrow><mi>I</mi></mrow><mrow><mi mathvariant=\"normal\">max</mi></mrow></msub>");
    EXPECT_EQ(toMathml(power(symbol("x"), text("4"))), "<msup><mrow><mi>x</mi></mrow><mrow><mn>4</mn></mrow></msup>");
    EXPECT_EQ(toMathml(fraction(text("1"), text("2"))),
              "<mfrac><mrow><mn>1</mn></mrow><mrow><mn>2</mn></mrow></mfrac>");
    EXPECT_EQ(toMathml(vector(VectorCode::N)), "<mi mathvariant=\"normal\" class=\"v N\">N</mi>");
    EXPECT_EQ(toMathml(struck(text("0"))), "<mrow class=\"struck\"><mn>0</mn></mrow>");
}

TEST(FormulaMathml, NamesWhatAPartStandsForAndEscapesIt) {
    EXPECT_EQ(toMathml(text("8", "material.0.n")), "<mrow data-refers=\"material.0.n\"><mn>8</mn></mrow>");
    EXPECT_EQ(toMathml(text("<", "\"><b>")), "<mrow data-refers=\"&quot;&gt;&lt;b&gt;\"><mo>&lt;</mo></mrow>");
    EXPECT_EQ(toMathml(symbol("<i>")), "<mi>&lt;i&gt;</mi>");
}

}  // namespace
}  // namespace pipeline
