#include "app/tables/algorithm_panel.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QPushButton>
#include <QScrollArea>
#include <QSlider>
#include <QTest>

#include "app/look/theme.h"
#include "app/tables/algorithm_view.h"
#include "app/tables/code_words.h"
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

// Both depths as `inspect pyramid --set cull=none --pixel 250,270` prints them when all is drawn.
TEST_F(AlgorithmPanelTest, FragmentsCompareTheOneThatIsBeingTested) {
    const auto says = [this](const char* text) {  // once the step's frame is there
        const auto* const tables = panel.findChild<QWidget*>("stepTables");
        return QTest::qWaitFor([&] { return tables->accessibleDescription().contains(text); }, 10000);
    };
    goTo("z-buffer/polygon=1/row=270/x=250/line=5");
    EXPECT_TRUE(says("polygon 0, 742.3430 < +∞, ● in the buffer"));
    EXPECT_TRUE(says("polygon 1, 671.9340 < 742.3430, ◐ being tested"));
    goTo("z-buffer/polygon=1/row=270/x=250");
    EXPECT_TRUE(says("polygon 0, 742.3430 < +∞, overwritten; polygon 1, 671.9340 < 742.3430, ● in the buffer"));
}

// From the last row it is read as far as everything else: no letters below those of the theme's text. What is too long
// goes on in the next line, and none of it is lost.
TEST_F(AlgorithmPanelTest, CodeIsNeverSmallerThanTheThemesTextAndFoldsInstead) {
    goTo("z-buffer/polygon=1/row=270/x=250/line=5");
    const AlgorithmView& view = panel.view();
    Theme& theme = Theme::current();
    const ThemeId before = theme.id();
    for (const ThemeId id : {ThemeId::Projector, ThemeId::Light}) {
        theme.set(id);
        for (const double scale : {1.0, 1.25, 2.0}) {
            theme.setScale(scale);
            bool isFolded = false;
            for (const int width : {330, 460, 1000}) {
                panel.resize(width, 700);
                QCoreApplication::processEvents();
                SCOPED_TRACE(testing::Message() << int(id) << ", text " << scale << ", " << width << " wide");
                EXPECT_GE(view.codeFont().pixelSize(), theme.text().pixelSize());
                for (const pipeline::AlgorithmRow& row : view.rows()) {
                    const QStringList lines = view.codeLines(row.number);
                    EXPECT_EQ(lines.join(' ').toStdString(), row.text);
                    for (const QString& line : lines)
                        if (line.contains(' ')) {
                            EXPECT_LE(codeWidth(view.codeFont(), line), view.width()) << line.toStdString();
                        }
                    isFolded |= lines.size() > 1;
                }
                EXPECT_TRUE(QRect(QPoint(), view.size()).contains(view.currentRect()));
            }
            EXPECT_TRUE(isFolded || scale < 2) << "nothing of 13 letters a line fits at twice the size";
        }
        theme.setScale(id == ThemeId::Projector ? 1.25 : 1);
    }
    theme.set(before);
}

// In a low panel, at each of the lines, the last ones too; one that is higher than the room is read from its top on.
TEST_F(AlgorithmPanelTest, TheLitLineIsWholeInSightInLargeLetters) {
    Theme::current().setScale(2);
    panel.resize(540, 410);
    const auto* area = panel.findChild<QScrollArea*>();
    for (const int line : {3, 5, 6}) {
        goTo(qPrintable(QStringLiteral("z-buffer/polygon=1/row=270/x=250/line=%1").arg(line)));
        QCoreApplication::processEvents();
        ASSERT_EQ(litLine(), line);
        const QRect lit = panel.view().currentRect().translated(panel.view().pos());
        EXPECT_GE(lit.top(), 0) << line;
        const bool isWhole = lit.bottom() <= area->viewport()->height();
        EXPECT_TRUE(isWhole || (lit.top() == 0 && lit.height() > area->viewport()->height())) << line;
    }
    Theme::current().setScale(1);
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
