#include "app/inspector/math_view.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>

#include "app/look/theme.h"

using app::MathBox;
using app::MathPiece;
using pipeline::EquationLine;
using pipeline::Formula;
using pipeline::VectorCode;
using Kind = Formula::Kind;

namespace {

Formula leaf(Kind kind, std::string text, std::string refers = {}) {
    return {kind, std::move(text), VectorCode::None, std::move(refers), {}};
}
Formula text(std::string s, std::string refers = {}) { return leaf(Kind::Text, std::move(s), std::move(refers)); }
Formula row(std::vector<Formula> parts) { return {Kind::Row, "", VectorCode::None, "", std::move(parts)}; }
Formula sub(std::string base, std::string below, std::string refers) {
    return {Kind::Script, "", VectorCode::None, std::move(refers), {leaf(Kind::Symbol, base), text(below), row({})}};
}

// I_b = 45.000 + 69.714 + 0.025 = 114.739, and the same without a left-hand side.
std::vector<EquationLine> lines(const std::string& specular = "0.025", const std::string& total = "114.739") {
    const std::vector<Formula> right{text("="), text("45.000", "ambient"),    text("+"), text("69.714", "diffuse.0"),
                                     text("+"), text(specular, "specular.0"), text("="), text(total)};
    std::vector<Formula> all{sub("I", "b", "intensity")};
    all.insert(all.end(), right.begin(), right.end());
    return {{"symbols", row(all), ""}, {"result", row(right), ""}};
}

std::vector<double> startsOf(const MathBox& box, const QString& glyphs) {
    std::vector<double> xs;
    for (const MathPiece& piece : box.pieces)
        if (piece.kind == MathPiece::Kind::Glyphs && piece.text == glyphs) xs.push_back(piece.at.x());
    return xs;
}

struct MathViewTest : testing::Test {
    app::MathView view;
    QStringList pointed;
    MathViewTest() {
        QObject::connect(&view, &app::MathView::pointedAt, [this](const QString& refers) { pointed << refers; });
        view.setLines(lines());
        view.resize(420, view.heightForWidth(420));
    }
};

}  // namespace

TEST(MathLayout, NothingIsCutOffAtAnyWidth) {
    double last = 0;
    for (int width = 700; width >= 140; width -= 20) {
        const app::MathPage page = app::layoutEquation(lines(), 18, width);
        for (const app::MathPart& part : page.box.parts) {
            EXPECT_LE(part.rect.right(), width) << "at width " << width;
            EXPECT_GE(part.rect.top(), 0);
            EXPECT_LE(part.rect.bottom(), page.height);
        }
        EXPECT_GE(page.height, last);  // what does not fit goes below
        last = page.height;
    }
}

TEST(MathLayout, EqualSignsStandBelowEachOther) {
    const auto xs = startsOf(app::layoutEquation(lines(), 18, 700).box, "=");
    ASSERT_EQ(xs.size(), 4u);         // two lines, two signs each
    EXPECT_DOUBLE_EQ(xs[0], 3 * 18);  // behind the column of left-hand sides, 3 em
    EXPECT_DOUBLE_EQ(xs[0], xs[2]);
}

TEST(MathLayout, BreaksBeforePlusAndContinuesOneEmFurtherIn) {
    const auto xs = startsOf(app::layoutEquation({lines()[1]}, 18, 54 + 100).box, "+");
    ASSERT_EQ(xs.size(), 2u);
    EXPECT_DOUBLE_EQ(xs[0], 54 + 18);
    EXPECT_DOUBLE_EQ(xs[1], 54 + 18);
}

TEST(MathLayout, ScriptsAreSmallerAndFractionsStandAroundTheirRule) {
    const MathBox script = app::layoutFormula(sub("I", "b", ""), 20);
    EXPECT_EQ(script.pieces[0].font.pixelSize(), 20);
    EXPECT_EQ(script.pieces[1].font.pixelSize(), 14);      // 0.70
    EXPECT_DOUBLE_EQ(script.pieces[1].at.y(), 0.18 * 20);  // below the base line
    const MathBox fraction =
        app::layoutFormula({Kind::Fraction, "", VectorCode::None, "", {text("114.739"), text("175")}}, 20);
    const auto rule = std::find_if(fraction.pieces.begin(), fraction.pieces.end(),
                                   [](const MathPiece& p) { return p.kind == MathPiece::Kind::Rule; });
    ASSERT_NE(rule, fraction.pieces.end());
    EXPECT_DOUBLE_EQ(rule->stroke.y1(), -0.25 * 20);
    EXPECT_LT(fraction.pieces[0].at.y(), rule->stroke.y1());
    EXPECT_GT(fraction.pieces[1].at.y(), rule->stroke.y1());
}

TEST(MathLayout, VectorsAreBoldItalicAndUnderlinedWhatIsStruckIsGreyAndStruck) {
    const MathBox n = app::layoutFormula({Kind::Vector, "N", VectorCode::N, "", {}}, 18);
    EXPECT_TRUE(n.pieces[0].font.bold() && n.pieces[0].font.italic());
    EXPECT_EQ(n.pieces[1].kind, MathPiece::Kind::Underline);
    EXPECT_EQ(n.pieces[1].vector, VectorCode::N);
    const MathBox struck = app::layoutFormula({Kind::Struck, "", VectorCode::None, "", {text("−0.21")}}, 18);
    EXPECT_EQ(struck.pieces[0].tone, app::MathTone::Quiet);
    EXPECT_EQ(struck.pieces[1].kind, MathPiece::Kind::Strike);
}

TEST_F(MathViewTest, ArrowKeysWalkThePartsThatStandForSomething) {
    for (int i = 0; i < 3; ++i) QTest::keyClick(&view, Qt::Key_Right);
    EXPECT_EQ(pointed, (QStringList{"intensity", "ambient", "diffuse.0"}));
    QTest::keyClick(&view, Qt::Key_Left);
    EXPECT_EQ(pointed.last(), "ambient");
    QTest::keyClick(&view, Qt::Key_Down);  // the ambient term of the line below
    EXPECT_EQ(pointed.last(), "ambient");
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_EQ(pointed.last(), "");
}

TEST_F(MathViewTest, HoverSaysThePartAndAClickAsksForIt) {
    QSignalSpy activated(&view, &app::MathView::activated);
    const auto xs = startsOf(app::layoutEquation(lines(), 18 * app::Theme::current().scale(), 418).box, "69.714");
    ASSERT_EQ(xs.size(), 2u);
    const QPoint at{int(xs.front()) + 10, 14};
    QTest::mouseMove(&view, at);
    QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(&view, &move);
    ASSERT_FALSE(pointed.isEmpty());
    EXPECT_EQ(pointed.last(), "diffuse.0");
    QTest::mouseClick(&view, Qt::LeftButton, {}, at);
    ASSERT_EQ(activated.size(), 1);
    EXPECT_EQ(activated[0][0].toString(), "diffuse.0");
}

TEST_F(MathViewTest, WhatChangedIsTintedAndNothingElse) {
    const QImage before = view.grab().toImage();
    view.setLines(lines(), true);
    EXPECT_EQ(view.grab().toImage(), before);  // the same lines: nothing to show
    view.setLines(lines("0.998", "115.712"), true);
    const QImage after = view.grab().toImage();
    const QColor tint = app::Theme::current().colors().tint;
    int tinted = 0;
    for (int y = 0; y < after.height(); ++y)
        for (int x = 0; x < after.width(); ++x) tinted += after.pixelColor(x, y) == tint;
    EXPECT_GT(tinted, 400);  // two numbers of about 40 × 17 pixels in each line
    EXPECT_LT(tinted, after.width() * after.height() / 3);
}

TEST_F(MathViewTest, CopyGivesTheFormulasAsText) {
    EXPECT_EQ(view.asText().split('\n')[1].toStdString(), pipeline::toText(lines()[1].formula));
    EXPECT_TRUE(view.asMarkdown().startsWith("$"));
    EXPECT_TRUE(view.asLatex().contains("I_{"));
    EXPECT_EQ(view.accessibleDescription(), view.asText());
}
