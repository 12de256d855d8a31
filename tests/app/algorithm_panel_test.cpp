#include "app/panels/algorithm_panel.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QPushButton>
#include <QSlider>
#include <QTest>

#include "app/panels/algorithm_view.h"
#include "tests/support/scenes.h"

namespace app {
namespace {

using pipeline::LineStatus;

struct AlgorithmPanelTest : testing::Test {
    Document document;
    AlgorithmPanel panel{document};

    AlgorithmPanelTest() {
        panel.resize(460, 700);
        panel.show();
        pipeline::Scene scene = test::pyramid();
        scene.settings.cull = pipeline::CullMode::None;
        document.setScene(scene);
        EXPECT_TRUE(QTest::qWaitFor([&] { return document.stepper().steps() != nullptr; }, 30000));
    }
    void goTo(const char* place) { document.stepper().goTo(*pipeline::parsePlace(place)); }
    int litLine() {
        for (const pipeline::AlgorithmRow& row : panel.view().rows())
            if (row.status == LineStatus::Now) return row.number;
        return 0;
    }
    QPushButton* button(const QString& text) {
        for (auto* one : panel.findChildren<QPushButton*>())
            if (one->text() == text) return one;
        return nullptr;
    }
};

TEST_F(AlgorithmPanelTest, NextLineAndBackGoThroughTheLinesOfAPixel) {
    goTo("z-buffer/polygon=1/row=270/x=249");
    std::vector<pipeline::Place> places;
    for (const int line : {3, 4, 5, 6, 6}) {  // the last once more, when the step has written
        QTest::mouseClick(button("Next line"), Qt::LeftButton);
        EXPECT_EQ(litLine(), line);
        places.push_back(*document.stepper().place());
    }
    for (std::size_t i = places.size() - 1; i-- > 0;) {
        QTest::mouseClick(button("Back"), Qt::LeftButton);
        EXPECT_EQ(document.stepper().place(), places[i]);
    }
    EXPECT_EQ(document.stepper().level(), pipeline::StepLevel::Line);
}

TEST_F(AlgorithmPanelTest, SaysTheLineAndItsNumbersToAScreenReader) {
    goTo("z-buffer/polygon=1/row=270/x=250/line=5");
    const QString said = panel.view().accessibleDescription();
    EXPECT_TRUE(said.contains("Line 5 of 7: if(z < zbuffer(x, y)) then")) << said.toStdString();
    EXPECT_TRUE(said.contains("z = 671.9340 < zbuffer(250, 270) = 742.3430")) << said.toStdString();
    EXPECT_TRUE(said.contains("true, taken")) << said.toStdString();
}

TEST_F(AlgorithmPanelTest, TheArrowsStepAndControlClickRunsToALine) {
    goTo("z-buffer/polygon=1/row=270/x=250/line=4");
    QTest::keyClick(&panel.view(), Qt::Key_Down);
    EXPECT_EQ(litLine(), 5);
    QTest::keyClick(&panel.view(), Qt::Key_Up);
    EXPECT_EQ(litLine(), 4);
    emit panel.view().lineAsked(2);  // the next polygon's first pixel
    EXPECT_EQ(document.stepper().place()->number, 2);
    EXPECT_EQ(litLine(), 2);
}

TEST_F(AlgorithmPanelTest, TheLoopIsDraggedToAnotherPixelOfTheRow) {
    goTo("z-buffer/polygon=1/row=270/x=250/line=5");
    auto* slider = panel.findChild<QSlider*>();
    ASSERT_TRUE(slider->isEnabled());
    EXPECT_EQ(slider->value(), 250);
    slider->setValue(252);
    EXPECT_EQ(text(*document.stepper().place()), "z-buffer/polygon=1/row=270/x=252/line=5");
}

TEST_F(AlgorithmPanelTest, CopiesTheAlgorithmAsTextAndLatex) {
    goTo("z-buffer/polygon=1/row=270/x=250/line=5");
    emit panel.view().copyAsked(pipeline::AlgorithmFormat::Latex);
    EXPECT_TRUE(QApplication::clipboard()->text().contains("\\begin{tabular}"));
    emit panel.view().copyAsked(pipeline::AlgorithmFormat::Text);
    EXPECT_TRUE(QApplication::clipboard()->text().contains(">  5"));
}

}  // namespace
}  // namespace app
