#include "app/check/check_panel.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "app/check/check_cases.h"
#include "app/check/check_knob.h"
#include "app/check/check_pictures.h"
#include "app/check/check_plot.h"
#include "app/look/theme.h"
#include "app/widgets/folding_panes.h"
#include "app/widgets/value_slider.h"
#include "pipeline/export/json/json_value.h"
#include "pipeline/scene/settings_table.h"
#include "tests/app/window/small_screen.h"

namespace {

using app::CheckCases;
using app::CheckPlot;
using app::KnobErrors;
using pipeline::check::Case;
using pipeline::check::CaseResult;
using pipeline::check::caseTable;
using pipeline::check::Group;

std::size_t numberOf(const char* id) { return std::size_t(pipeline::check::findCase(id) - caseTable().data()); }

struct CheckPanelTest : testing::Test {
    app::Document document;
    app::CheckPanel panel{document};

    // Not shown, it runs nothing of itself.
    CheckPanelTest() { panel.resize(1500, 900); }
    template <class Widget>
    Widget& part(const char* name = nullptr) {
        return *panel.findChild<Widget*>(name ? QString(name) : QString());
    }
    CheckCases& cases() { return part<CheckCases>(); }
    void wait() {
        ASSERT_TRUE(QTest::qWaitFor([&] { return !panel.running(); }, 60000));
    }
    void waitForCurve() {
        ASSERT_TRUE(QTest::qWaitFor([&] { return !part<CheckPlot>().plot().curve.empty(); }, 60000));
    }
};

// A case that no stage has: what the table shows of it is known.
CaseResult resultOf(std::size_t which, bool holds) {
    CaseResult result;
    result.what = &caseTable()[which];
    result.finding.naive = std::nan("");
    result.finding.oursText = "3 of 4";
    result.holds = holds;
    result.reason = holds ? "" : "one is missing";
    return result;
}

}  // namespace

TEST_F(CheckPanelTest, FitsASmallScreenInEveryTheme) {
    panel.show();
    test::expectFitsASmallScreen(panel);
}

// Titles keep room for sixteen broad letters; ours and the bound, which the details have too, go before.
TEST_F(CheckPanelTest, TitlesStayLegibleInLargeLettersAndNothingIsOutOfReach) {
    panel.setGroup(Group::Geometry);
    panel.show();
    test::onSmallScreens(panel, {1.0, 1.25, 1.5, 2.0}, [&] {
        const QFontMetrics metrics(app::Theme::current().text(13));
        EXPECT_GE(cases().columnWidth(1), metrics.averageCharWidth() * 16);
        EXPECT_EQ(cases().horizontalScrollBar()->maximum(), 0);
        auto& panes = part<app::FoldingPanes>();
        panes.bringToFront(1);
        QCoreApplication::processEvents();
        const auto& open = part<QPushButton>("checkOpen");
        EXPECT_TRUE(open.isVisible());
        EXPECT_LE(open.mapTo(&panel, QPoint(open.width(), 0)).x(), panel.width());
        panes.bringToFront(0);
    });
}

TEST_F(CheckPanelTest, RunningAllBringsTheCasesToTheFront) {
    panel.show();
    wait();
    ASSERT_NO_FATAL_FAILURE(test::foldToSecondPart(panel));
    EXPECT_FALSE(cases().isVisible());
    auto& run = part<QPushButton>("checkRunAll");
    EXPECT_TRUE(panel.rect().contains(QRect(run.mapTo(&panel, QPoint()), run.size())));
    run.click();
    EXPECT_TRUE(cases().isVisible());
    wait();
    app::Theme::current().setScale(1);
}

// The colour of a verdict says as much as its word: it stays in the selected row.
TEST_F(CheckPanelTest, ASelectedRowKeepsItsColours) {
    CheckCases table;
    app::CheckResults results(caseTable().size());
    results[0] = resultOf(0, true);
    table.resize(900, 300);
    table.setCases(results, {});
    table.selectRow(table.item(0, 6)->text() == "●" ? 0 : 1);
    table.show();
    const int row = table.currentRow();
    const QImage shown = table.viewport()->grab(table.visualItemRect(table.item(row, 6))).toImage();
    const QColor wanted = app::Theme::current().colors().run;
    int found = 0;
    for (int y = 0; y < shown.height(); ++y)
        for (int x = 0; x < shown.width(); ++x) found += shown.pixelColor(x, y) == wanted;
    EXPECT_GT(found, 10);
}

TEST_F(CheckPanelTest, RunsAllCasesWhenItIsFirstShown) {
    panel.show();
    EXPECT_TRUE(panel.running());
    EXPECT_FALSE(part<QPushButton>("checkRunAll").isEnabled());
    wait();
    EXPECT_EQ(cases().rowCount(), int(caseTable().size()));
    for (int row = 0; row < cases().rowCount(); ++row)
        EXPECT_EQ(cases().item(row, 6)->data(Qt::AccessibleTextRole).toString(), "holds")
            << cases().item(row, 0)->text().toStdString();
    const QString all = QString::number(caseTable().size());
    EXPECT_TRUE(part<QLabel>("checkHead").text().startsWith(all + " of " + all + " hold, in "));
    panel.hide();
    panel.show();
    EXPECT_FALSE(panel.running()) << "what is known is not computed again";
}

TEST_F(CheckPanelTest, RunsOneCase) {
    panel.select(numberOf("G1"));
    part<QPushButton>("checkRunOne").click();
    wait();
    EXPECT_EQ(part<QLabel>("checkHead").text(), "1 of 1 hold");
    EXPECT_TRUE(part<QLabel>("checkVerdict").text().startsWith("● holds"));
    part<QPushButton>("checkCopy").click();
    const auto json = pipeline::Json::parse(QApplication::clipboard()->text().toStdString());
    ASSERT_EQ(json["results"].elements().size(), 1u);
    EXPECT_EQ(json["results"][0]["case"], "G1");
    EXPECT_EQ(json["results"][0]["holds"], true);
    EXPECT_EQ(json["hold"], 1);
}

TEST_F(CheckPanelTest, StopsWhenItIsClosed) {
    panel.show();
    panel.close();
    wait();
    EXPECT_FALSE(panel.running());
}

TEST_F(CheckPanelTest, ShowsTheCasesOfAGroupAndSelectsOneOfThem) {
    panel.select(numberOf("G1"));
    panel.setGroup(Group::Depth);
    EXPECT_EQ(cases().rowCount(), std::ranges::count(caseTable(), Group::Depth, &Case::group));
    EXPECT_EQ(caseTable()[panel.selected()].group, Group::Depth);
    EXPECT_EQ(part<QLabel>("checkCommand").text(), "also: shadescope check --group depth");
    panel.setGroup(std::nullopt);
    EXPECT_EQ(cases().rowCount(), int(caseTable().size()));
}

TEST_F(CheckPanelTest, TheKeysGoThroughTheTable) {
    panel.select(numberOf("G1"));
    QTest::keyClick(&cases(), Qt::Key_Down);
    EXPECT_EQ(panel.selected(), numberOf("G1") + 1);
    QTest::keyClick(&cases(), Qt::Key_Up);
    EXPECT_EQ(panel.selected(), numberOf("G1"));
    EXPECT_EQ(part<QLabel>("checkTitle").text().toStdString(), std::string(caseTable()[panel.selected()].title));
}

TEST(CheckCasesTest, WhatBreaksComesFirst) {
    app::CheckResults results(caseTable().size());
    results[0] = resultOf(0, true);
    results[7] = resultOf(7, false);
    CheckCases table;
    table.setCases(results, std::nullopt);
    EXPECT_EQ(table.item(0, 0)->text().toStdString(), std::string(caseTable()[7].id));
    EXPECT_EQ(table.item(0, 2)->text(), "NaN");
    EXPECT_EQ(table.item(0, 3)->text(), "3 of 4");
    EXPECT_EQ(table.item(0, 6)->text(), "▲");
    EXPECT_EQ(table.item(0, 6)->toolTip(), "breaks: one is missing");
    EXPECT_EQ(table.item(1, 6)->text(), "●");
    EXPECT_EQ(table.item(2, 6)->text(), "not run");
}

TEST_F(CheckPanelTest, OpensACaseWithTheValueOfItsSlider) {
    panel.select(numberOf("S10"));
    auto& field = part<QLineEdit>("checkValue");
    field.setText("2500");
    emit field.editingFinished();
    QTest::keyClick(&cases(), Qt::Key_Return);
    ASSERT_TRUE(document.hasScene());
    const auto exponent = [&] { return findSetting(document.scene(), "material.0.n")->get(document.scene()); };
    EXPECT_EQ(exponent(), 2500);
    // From then on the scene follows; a drag is one step of undo.
    auto& slider = part<app::ValueSlider>("checkSlider");
    emit slider.moved(100);  // a quarter of the way from 1 to 10⁶: 10^1.5, three digits of it
    emit slider.moved(200);
    emit slider.released(200);
    EXPECT_EQ(exponent(), 1000);
    EXPECT_EQ(field.text(), "1000");
    document.history().stack()->undo();
    EXPECT_EQ(exponent(), 2500);
    EXPECT_FALSE(document.history().stack()->canUndo());
    // Another case's slider is none of this scene.
    panel.select(numberOf("T7"));
    const pipeline::Scene before = document.scene();
    emit slider.released(10);
    EXPECT_EQ(document.scene(), before);
}

TEST_F(CheckPanelTest, EveryCaseWithASceneOpensAtBothEndsOfItsKnob) {
    for (std::size_t i = 0; i < caseTable().size(); ++i) {
        panel.select(i);
        EXPECT_EQ(part<QPushButton>("checkOpen").isEnabled(), caseTable()[i].scene != nullptr);
        EXPECT_EQ(panel.openAsScene(), caseTable()[i].scene != nullptr)
            << caseTable()[i].id << ": " << part<QLabel>("checkMessage").text().toStdString();
        if (caseTable()[i].knob.setting.empty()) continue;
        part<app::CheckKnob>().setValue(caseTable()[i].knob.low);
        EXPECT_TRUE(panel.openAsScene()) << caseTable()[i].id;
        EXPECT_FALSE(document.scene().name.empty()) << caseTable()[i].id;
    }
}

// At exponent 10^6 pow of a float dot product shows rings, ours none; at 1 both are the same to a step of 255.
TEST_F(CheckPanelTest, ShowsBothFormsSideBySide) {
    const auto differing = [&] {
        EXPECT_TRUE(QTest::qWaitFor([&] { return panel.pictures().complete(); }, 60000));
        return part<QLabel>("checkDifference").text().split(' ').first().toInt();
    };
    panel.select(numberOf("S10"));
    EXPECT_GT(differing(), 1000);
    part<app::CheckKnob>().setValue(1);
    emit part<app::CheckKnob>().changed(1, true);
    EXPECT_LT(differing(), 100);
    panel.select(numberOf("N1"));  // no setting is its naive form
    EXPECT_TRUE(QTest::qWaitFor([&] { return panel.pictures().complete(); }, 60000));
    EXPECT_TRUE(part<QLabel>("checkDifference").text().startsWith("No setting"));
    panel.select(numberOf("G13"));  // a file
    EXPECT_TRUE(panel.pictures().isHidden());
}

TEST_F(CheckPanelTest, RefusesAValueOutsideOfTheRange) {
    panel.select(numberOf("S10"));
    auto& field = part<QLineEdit>("checkValue");
    for (const char* wrong : {"0", "1e7", "nan", "much"}) {
        field.setText(wrong);
        emit field.editingFinished();
        EXPECT_EQ(field.toolTip(), QString(wrong) + " is no number from 1 to 1000000");
        EXPECT_EQ(part<app::CheckKnob>().value(), 1e6);
    }
}

TEST_F(CheckPanelTest, PlotsBothFormsOverTheKnobsRange) {
    panel.select(numberOf("S10"));
    waitForCurve();
    const Case& which = *pipeline::check::findCase("S10");
    const auto& curve = part<CheckPlot>().plot().curve;
    ASSERT_EQ(curve.size(), app::KnobCurve::kPoints);
    EXPECT_EQ(curve.front().at, 1);
    EXPECT_NEAR(curve[24].at, 1000, 1e-9) << "the middle of six decades";
    EXPECT_EQ(curve.back().at, 1e6);
    // A cosine in float is off by 2^-25 or so; the power of 10⁶ makes that 10⁶ times as much.
    EXPECT_GT(curve.back().naive, 1e-2);
    for (const KnobErrors& errors : curve) EXPECT_LE(errors.ours, which.bound) << errors.at;
    ASSERT_TRUE(QTest::qWaitFor([&] { return part<CheckPlot>().plot().now.has_value(); }, 60000));
    EXPECT_EQ(part<CheckPlot>().plot().now->naive, curve.back().naive) << "the slider stands at the stiff end";
    EXPECT_TRUE(part<CheckPlot>().accessibleDescription().startsWith("exponent e 1e+06: naive 0.1"))
        << part<CheckPlot>().accessibleDescription().toStdString();
}

TEST_F(CheckPanelTest, StartsAtTheStiffEndEvenWhereThatIsTheLower) {
    panel.select(numberOf("T7"));  // the camera's angle from the axis: stiff at 10⁻⁶ degrees
    waitForCurve();
    EXPECT_EQ(part<app::CheckKnob>().value(), 1e-6);
}

TEST(CheckPlotLayout, KeepsWithinThePictureAndLeavesGaps) {
    Case which;
    which.measure = "error";
    which.bound = 1e-3;
    which.knob = {.label = "knob", .low = 1, .high = 100};
    const double nan = std::nan("");
    app::KnobPlot plot{&which, {{1, nan, 0}, {3, 1, 0}, {10, 2, 0}, {30, nan, 0}, {100, HUGE_VAL, 1e-4}}, {}, 100};
    plot.now = KnobErrors{100, nan, 1e-4};
    const pipeline::PlotDrawing drawing = layOut(plot, {500, 300, 14});
    const auto inside = [](pipeline::Vec2<double> at) { return at.x >= 0 && at.x <= 500 && at.y >= 0 && at.y <= 300; };
    std::vector<std::size_t> dashed;
    for (const pipeline::PlotLine& line : drawing.lines) {
        for (const auto& point : line.points) EXPECT_TRUE(inside(point)) << point.x << ' ' << point.y;
        if (line.dash == pipeline::PlotDash::Dashed) dashed.push_back(line.points.size());
    }
    EXPECT_EQ(dashed, std::vector<std::size_t>{2}) << "of the naive form two values are numbers";
    for (const pipeline::PlotText& text : drawing.texts) EXPECT_TRUE(inside(text.at)) << text.text;
    const auto has = [&](const char* words) {
        return std::ranges::count(drawing.texts, words, &pipeline::PlotText::text);
    };
    EXPECT_EQ(has("NaN"), 1);
    EXPECT_EQ(has("1e-4"), 2) << "on the axis, and beside the slider";
    EXPECT_EQ(has("bound 0.001"), 1);
    EXPECT_EQ(has("0"), 1) << "errors of 0 have a row of their own";
}
