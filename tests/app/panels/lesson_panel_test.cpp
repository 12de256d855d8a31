#include "tests/app/panels/lesson_panel_fixture.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemModelTester>
#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBrowser>

#include "app/look/theme.h"
#include "pipeline/formats/built_in_scenes.h"

// The real panel on a real document: pages set the window, numbers come from its frames.
namespace {

using app::Document;
using app::FrameFeed;
using app::LessonPanel;
using app::LessonPanelTest;
using app::LessonShelf;

int rowOf(const LessonShelf& shelf, const char* name) {
    for (int row = 0; row < shelf.rowCount(); ++row)
        if (shelf.index(row).data(LessonShelf::NameRole).toString() == name) return row;
    return -1;
}

TEST_F(LessonPanelTest, ShelfListsTheLessonsAsAProperModel) {
    LessonShelf shelf;
    QAbstractItemModelTester tester(&shelf, QAbstractItemModelTester::FailureReportingMode::Fatal);
    ASSERT_GE(shelf.rowCount(), 1);
    const QModelIndex row = shelf.index(rowOf(shelf, "pyramid"));
    EXPECT_EQ(row.data(LessonShelf::NameRole).toString(), "pyramid");
    EXPECT_EQ(row.data(LessonShelf::PageRole).toInt(), 0);
    EXPECT_EQ(row.data(LessonShelf::PagesRole).toInt(), 9);
    const auto progress = [&row] { return row.data(LessonShelf::ProgressRole).toString(); };
    EXPECT_EQ(progress(), "Not begun, 9 pages");
    EXPECT_TRUE(row.data().toString().endsWith('\n' + progress()));
    shelf.setPage(*shelf.find("pyramid"), 4);
    EXPECT_EQ(progress(), "Page 4 of 9");
    shelf.setPage(*shelf.find("pyramid"), 9);
    EXPECT_EQ(progress(), "Read, 9 pages");
    ASSERT_NE(shelf.find("pyramid"), nullptr);
    EXPECT_EQ(shelf.find("piramid"), nullptr);
}

// A list of one lesson whose header is right and whose page names no scene that there is.
TEST_F(LessonPanelTest, WhatIsWrongInALessonIsSaidWhenItIsOpened) {
    QTemporaryDir folder;
    QDir(folder.path()).mkpath(QStringLiteral("lessons/wrong"));
    QFile file(folder.filePath(QStringLiteral("lessons/wrong/lesson.md")));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("title: Wrong\nlecture: 1\nsummary: One page.\nscene: piramid\n\n# First\n\nText.\n");
    file.close();
    const std::filesystem::path resources = pipeline::resourceFolder();
    pipeline::setResourceFolder(folder.path().toStdString());
    LessonShelf shelf;
    const lessons::Lesson* const found = shelf.find("wrong");
    pipeline::setResourceFolder(resources);
    ASSERT_EQ(shelf.rowCount(), 1);
    EXPECT_EQ(shelf.listed(0).title, "Wrong");
    EXPECT_EQ(found, nullptr);
    ASSERT_FALSE(shelf.errors().empty());
    EXPECT_EQ(shelf.errors().front().where.line, 4);
}

TEST_F(LessonPanelTest, AClickInTheListOpensTheLesson) {
    auto& list = *panel->findChild<QListView*>();
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualRect(list.model()->index(0, 0)).center());
    ASSERT_NE(panel->lesson(), nullptr);
    EXPECT_EQ(panel->page(), 0);
    EXPECT_TRUE(document.hasScene());
}

TEST_F(LessonPanelTest, APageSetsTheWindow) {
    std::vector<std::string> buffers;
    QObject::connect(panel.get(), &LessonPanel::showViews, panel.get(), [&](const lessons::WindowState& window) {
        buffers.clear();
        for (const lessons::BufferShown& view : window.views) buffers.push_back(view.buffer);
    });
    ASSERT_TRUE(panel->open("pyramid"));
    goTo(4);  // Which polygon is nearest
    EXPECT_EQ(document.stage(), pipeline::StageId::ZBuffer);
    EXPECT_FALSE(document.pointing().pixel());
    EXPECT_EQ(document.scene().settings.cull, pipeline::CullMode::None);
    EXPECT_EQ(buffers, (std::vector<std::string>{"z_view"}));
    goTo(6);  // the next page does not keep what this one has set
    EXPECT_EQ(document.scene().settings.cull, pipeline::CullMode::Back);
    EXPECT_EQ(document.stage(), pipeline::StageId::Shading);
    EXPECT_EQ(document.pointing().pixel(), glm::ivec2(268, 281));
    EXPECT_EQ(buffers, (std::vector<std::string>{"color"}));
}

TEST_F(LessonPanelTest, EveryPageIsFilledFromTheDocumentsFrames) {
    ASSERT_TRUE(panel->open("pyramid"));
    for (int page = 0; page < 8; ++page) goTo(page);
    goTo(7);
    EXPECT_TRUE(text().contains("is 0.7746")) << text().toStdString();
}

// The author has questions of "pyramid" return in "camera", whoever reads it. Here those of a lesson that this student has
// done do: of two the one before the last.
TEST_F(LessonPanelTest, QuestionsReturnOnlyFromLessonsThatWereDoneInTheirOrder) {
    const auto first = [&](const char* name) {
        EXPECT_TRUE(panel->open(name));
        const lessons::Page& page = panel->lesson()->pages.front();
        const std::string from = page.from ? page.from->lesson : "";
        panel->close();
        return from;
    };
    const auto settle = [&](const char* name) {
        const lessons::Lesson& lesson = *panel->shelf().find(name);
        for (const lessons::Page& page : lesson.pages)
            panel->run().results().keep(lesson, page, {lessons::Progress::Outcome::Right, 0, {}});
    };
    EXPECT_EQ(first("camera"), "") << "nothing was answered yet";
    settle("shadows");
    EXPECT_EQ(first("camera"), "");
    settle("pyramid");
    EXPECT_EQ(first("camera"), "shadows");
    EXPECT_EQ(first("pyramid"), "") << "none return in the first lesson";
    // Begun, it keeps them, and the page at which it was left.
    ASSERT_TRUE(panel->open("camera"));
    panel->run().results().keep(*panel->lesson(), panel->lesson()->pages[0],
                                {lessons::Progress::Outcome::Shown, 0, {}});
    const int returning = int(lessons::returningPages(*panel->lesson()));
    EXPECT_EQ(returning, 2);
    panel->goTo(returning + 2);
    panel->close();
    settle("z-buffer");
    EXPECT_EQ(first("camera"), "shadows");
    ASSERT_TRUE(panel->open("camera"));
    EXPECT_EQ(panel->page(), returning + 2);
    panel->run().results().forget();
    panel->close();
    EXPECT_EQ(first("camera"), "");
}

TEST_F(LessonPanelTest, NextWaitsForTheAnswer) {
    ASSERT_TRUE(panel->open("pyramid"));
    EXPECT_FALSE(part<QPushButton>("previousPage").isEnabled());
    goTo(1);
    EXPECT_TRUE(part<QPushButton>("previousPage").isEnabled());
    EXPECT_FALSE(part<QPushButton>("nextPage").isEnabled());
    answer("310");  // floor(240 − 200·y_v/z_v) of vertex 2
    EXPECT_TRUE(part<QPushButton>("nextPage").isEnabled());
}

TEST_F(LessonPanelTest, AnswersAreCheckedAgainstThePagesOwnFrame) {
    ASSERT_TRUE(panel->open("pyramid"));
    goTo(1);  // y_s of vertex 2 is 310.673 (tests/lessons/lesson_data_test.cpp)
    answer("311");
    EXPECT_TRUE(comment().contains("the rounding is not")) << comment().toStdString();

    // The reader turns the camera: what judges and what is said stay those of the page.
    const auto theta = pipeline::findSetting(document.scene(), "camera.theta");
    ASSERT_TRUE(theta);
    QSignalSpy ready(&document.frames(), &FrameFeed::frameReady);
    document.change(*theta, 60);
    ASSERT_TRUE(ready.wait());
    ASSERT_TRUE(part<QWidget>("setWindow").isVisible());
    click("setWindow");
    EXPECT_FALSE(part<QWidget>("setWindow").isVisible());
    EXPECT_FALSE(document.history().stack()->canUndo()) << "a page is no step of undo";
    answer("310");
    EXPECT_TRUE(comment().contains("is 310.673")) << comment().toStdString();
}

// In a low panel too, and below a long page: what is said to an answer is seen without scrolling.
TEST_F(LessonPanelTest, WhatIsSaidToAnAnswerIsInSight) {
    ASSERT_TRUE(panel->open("pyramid"));
    for (const int height : {700, 400, 300}) {
        panel->resize(420, height);
        goTo(1);
        auto* area = panel->findChild<QScrollArea*>();
        answer(qPrintable(QString::number(height)));
        ASSERT_TRUE(QTest::qWaitFor([&] { return !comment().isEmpty(); }, 10000));
        const QTextBrowser& said = part<QTextBrowser>("comment");
        const auto isInSight = [&] {
            const int top = said.mapTo(area->viewport(), QPoint()).y();
            return top >= 0 &&
                   top + std::min(said.height(), area->viewport()->height() / 2) <= area->viewport()->height();
        };
        EXPECT_TRUE(QTest::qWaitFor(isInSight, 2000)) << height << " high";
    }
}

// Large letters: the name of the lesson stands whole, on lines of its own.
TEST_F(LessonPanelTest, TheTitleIsNotCut) {
    ASSERT_TRUE(panel->open("pyramid"));
    for (const double scale : {1.0, 1.5, 2.0}) {
        app::Theme::current().setScale(scale);
        QCoreApplication::processEvents();
        const QLabel& whole = part<QLabel>("lessonWholeTitle");
        if (!whole.isVisible()) continue;  // it fits between the buttons
        EXPECT_EQ(whole.text(), "The pyramid from its file to its last pixel");
        EXPECT_GE(whole.height(), whole.heightForWidth(whole.width())) << scale;
        EXPECT_LE(whole.mapTo(panel.get(), QPoint(whole.width(), 0)).x(), panel->width()) << scale;
    }
    EXPECT_TRUE(part<QLabel>("lessonWholeTitle").isVisible()) << "at 200 % it does not fit between the buttons";
    app::Theme::current().setScale(1);
}

TEST_F(LessonPanelTest, TheHintIsFilledInAndCosts) {
    ASSERT_TRUE(panel->open("pyramid"));
    goTo(3);
    click("hint");
    EXPECT_TRUE(part<QTextBrowser>("hint1").toPlainText().contains("v01 = (0, 150, 0)"));
    EXPECT_TRUE(part<QLabel>("worth").text().contains("now worth"));
}

TEST_F(LessonPanelTest, ProgressIsRemembered) {
    ASSERT_TRUE(panel->open("pyramid"));
    panel->goTo(4);
    EXPECT_EQ(panel->shelf().index(rowOf(panel->shelf(), "pyramid")).data(LessonShelf::PageRole).toInt(), 5);
    Document other;
    LessonPanel later(other);
    ASSERT_TRUE(later.open("pyramid"));
    EXPECT_EQ(later.page(), 4);
    later.goTo(int(later.lesson()->pages.size()) - 1);  // read to its end: from the beginning next time
    later.close();
    EXPECT_EQ(later.lesson(), nullptr);
    ASSERT_TRUE(later.open("pyramid"));
    EXPECT_EQ(later.page(), 0);
}

TEST_F(LessonPanelTest, VectorsHaveTheirColourOnThePage) {
    ASSERT_TRUE(panel->open("pyramid"));
    goTo(5);  // has N·L
    const auto& page = part<QTextBrowser>("lessonText");
    const QTextCursor found = page.document()->find("N·L");
    ASSERT_FALSE(found.isNull());
    QTextCursor n(page.document());
    n.setPosition(found.selectionStart() + 1);
    EXPECT_EQ(n.charFormat().foreground().color(), app::Theme::current().colors().N);
    EXPECT_FALSE(text().contains('_')) << text().toStdString();  // subscripts, not signs
    const QImage picture = panel->grab().toImage();
    int pixels = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            pixels += picture.pixelColor(x, y) == app::Theme::current().colors().N;
    EXPECT_GT(pixels, 5);
}

TEST_F(LessonPanelTest, AnOwnLessonStandsBesideTheOthersAndMayChange) {
    const int before = panel->shelf().rowCount();
    lessons::Lesson own = *panel->shelf().find("pyramid");
    own.name = "/somewhere/my lesson", own.title = "Mine";
    ASSERT_TRUE(panel->openOwn(own));
    EXPECT_EQ(panel->lesson()->title, "Mine");
    ASSERT_EQ(panel->shelf().rowCount(), before + 1);
    EXPECT_EQ(panel->shelf().index(before).data(LessonShelf::NameRole).toString(), "/somewhere/my lesson");
    const std::size_t whole = own.pages.size();
    panel->goTo(int(whole) - 1);
    own.pages.resize(2), own.title = "Mine, shorter";  // its author goes on writing
    ASSERT_TRUE(panel->openOwn(own));
    EXPECT_EQ(panel->shelf().rowCount(), before + 1);
    EXPECT_EQ(panel->lesson()->title, "Mine, shorter");
    EXPECT_LT(panel->page(), 2);
    EXPECT_TRUE(isFilled());
    panel->close();
    ASSERT_TRUE(panel->open("pyramid"));
    EXPECT_EQ(panel->lesson()->pages.size(), whole);
}

TEST_F(LessonPanelTest, AnUnknownLessonOpensNothing) {
    EXPECT_FALSE(panel->open("piramid"));
    EXPECT_EQ(panel->lesson(), nullptr);
}

}  // namespace
