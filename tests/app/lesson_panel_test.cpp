#include "app/panels/lesson_panel.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QImage>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBrowser>
#include <QToolButton>

#include "app/core/theme.h"

// The real panel on a real document: pages set the window, numbers come from its frames.
namespace {

using app::Document;
using app::LessonPanel;
using app::LessonShelf;

class LessonPanelTest : public testing::Test {
protected:
    static void SetUpTestSuite() {
        QCoreApplication::setOrganizationName("shadescope-test");
        QCoreApplication::setApplicationName("lesson-panel-test");
        QSettings::setDefaultFormat(QSettings::IniFormat);
    }
    LessonPanelTest() {
        // Progress of its own, which goes with the folder.
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settingsFolder.path());
        QSettings().clear();
        panel = std::make_unique<LessonPanel>(document);
        panel->resize(296, 600);
        panel->show();
    }

    template <class Widget>
    Widget& part(const char* name) {
        auto* found = panel->findChild<Widget*>(name);
        EXPECT_NE(found, nullptr) << name;
        return *found;
    }
    void click(const char* button) { QTest::mouseClick(&part<QAbstractButton>(button), Qt::LeftButton); }
    QString text() { return part<QTextBrowser>("lessonText").toPlainText(); }
    QString comment() { return part<QTextBrowser>("comment").toPlainText(); }
    // The page's numbers are there when nothing stands for them any more.
    bool isFilled() {
        return QTest::qWaitFor([this] { return !document.busy() && document.frame() && !text().contains(u'…'); }, 5000);
    }
    void goTo(int page) {
        panel->goTo(page);
        ASSERT_TRUE(isFilled()) << text().toStdString();
    }
    void answer(const char* typed) {
        part<QLineEdit>("answer").setText(typed);
        click("check");
    }

    QTemporaryDir settingsFolder;
    Document document;
    std::unique_ptr<LessonPanel> panel;
};

TEST_F(LessonPanelTest, ShelfListsTheLessonsAsAProperModel) {
    LessonShelf shelf;
    QAbstractItemModelTester tester(&shelf, QAbstractItemModelTester::FailureReportingMode::Fatal);
    ASSERT_GE(shelf.rowCount(), 1);
    const QModelIndex row = shelf.index(0);
    EXPECT_EQ(row.data(LessonShelf::NameRole).toString(), "pyramid");
    EXPECT_EQ(row.data(LessonShelf::PageRole).toInt(), 0);
    EXPECT_EQ(row.data(LessonShelf::PagesRole).toInt(), 8);
    const auto progress = [&row] { return row.data(LessonShelf::ProgressRole).toString(); };
    EXPECT_EQ(progress(), "Not begun, 8 pages");
    EXPECT_TRUE(row.data().toString().endsWith('\n' + progress()));
    shelf.setPage(*shelf.find("pyramid"), 4);
    EXPECT_EQ(progress(), "Page 4 of 8");
    shelf.setPage(*shelf.find("pyramid"), 8);
    EXPECT_EQ(progress(), "Read, 8 pages");
    ASSERT_NE(shelf.find("pyramid"), nullptr);
    EXPECT_EQ(shelf.find("piramid"), nullptr);
}

TEST_F(LessonPanelTest, AClickInTheListOpensTheLesson) {
    auto& list = *panel->findChild<QListView*>();
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualRect(list.model()->index(0, 0)).center());
    ASSERT_NE(panel->lesson(), nullptr);
    EXPECT_EQ(panel->page(), 0);
    EXPECT_TRUE(document.hasScene());
}

TEST_F(LessonPanelTest, APageSetsTheWindow) {
    QSignalSpy buffers(panel.get(), &LessonPanel::showBuffers);
    ASSERT_TRUE(panel->open("pyramid"));
    goTo(4);  // Which polygon is nearest
    EXPECT_EQ(document.stage(), pipeline::StageId::ZBuffer);
    EXPECT_FALSE(document.pixel());
    EXPECT_EQ(document.scene().settings.cull, pipeline::CullMode::None);
    EXPECT_EQ(buffers.last()[0].toStringList(), QStringList({"z_view"}));
    goTo(6);  // the next page does not keep what this one has set
    EXPECT_EQ(document.scene().settings.cull, pipeline::CullMode::Back);
    EXPECT_EQ(document.stage(), pipeline::StageId::Shading);
    EXPECT_EQ(document.pixel(), glm::ivec2(268, 281));
    EXPECT_EQ(buffers.last()[0].toStringList(), QStringList({"color"}));
}

TEST_F(LessonPanelTest, EveryPageIsFilledFromTheDocumentsFrames) {
    ASSERT_TRUE(panel->open("pyramid"));
    for (int page = 0; page < 8; ++page) goTo(page);
    goTo(7);
    EXPECT_TRUE(text().contains("= 26.307")) << text().toStdString();
}

TEST_F(LessonPanelTest, ButtonsTurnThePagesWithinTheLesson) {
    ASSERT_TRUE(panel->open("pyramid"));
    auto &previous = part<QToolButton>("previousPage"), &next = part<QToolButton>("nextPage");
    EXPECT_FALSE(previous.isEnabled());
    EXPECT_EQ(previous.toolTip(), "Already at the first page.");
    click("nextPage");
    EXPECT_EQ(panel->page(), 1);
    EXPECT_TRUE(previous.isEnabled());
    for (int i = 0; i < 20; ++i) click("nextPage");
    EXPECT_EQ(panel->page(), 7);
    EXPECT_FALSE(next.isEnabled());
    EXPECT_EQ(next.toolTip(), "Already at the last page.");
}

TEST_F(LessonPanelTest, AnswersAreCheckedAgainstThePagesOwnFrame) {
    ASSERT_TRUE(panel->open("pyramid"));
    goTo(1);  // y_s of vertex 2 is 310.673 (tests/lessons/lesson_data_test.cpp)
    answer("311");
    EXPECT_TRUE(comment().contains("the rounding is not")) << comment().toStdString();

    // The reader turns the camera: what judges and what is said stay those of the page.
    const auto theta = pipeline::findSetting(document.scene(), "camera.theta");
    ASSERT_TRUE(theta);
    QSignalSpy ready(&document, &Document::frameReady);
    document.change(*theta, 60);
    ASSERT_TRUE(ready.wait());
    answer("310");
    EXPECT_TRUE(comment().contains("y_s is 310.673")) << comment().toStdString();
}

TEST_F(LessonPanelTest, TheHintIsFilledIn) {
    ASSERT_TRUE(panel->open("pyramid"));
    goTo(3);
    click("hint");
    EXPECT_TRUE(comment().contains("v01 = (0, 150, 0)")) << comment().toStdString();
}

TEST_F(LessonPanelTest, SettingTheWindowAgainUndoesWhatTheReaderHasChanged) {
    ASSERT_TRUE(panel->open("pyramid"));
    goTo(6);
    const auto exponent = pipeline::findSetting(document.scene(), "material.0.n");
    ASSERT_TRUE(exponent);
    document.change(*exponent, 2);
    document.pick(glm::ivec2(1, 1));
    click("setWindow");
    EXPECT_EQ(exponent->get(document.scene()), 8);
    EXPECT_EQ(document.pixel(), glm::ivec2(268, 281));
    document.undoStack()->undo();  // and can itself be undone
    EXPECT_EQ(exponent->get(document.scene()), 2);
}

TEST_F(LessonPanelTest, ProgressIsRemembered) {
    ASSERT_TRUE(panel->open("pyramid"));
    panel->goTo(4);
    EXPECT_EQ(panel->shelf().index(0).data(LessonShelf::PageRole).toInt(), 5);
    Document other;
    LessonPanel later(other);
    ASSERT_TRUE(later.open("pyramid"));
    EXPECT_EQ(later.page(), 4);
    later.goTo(7);  // read to its end: from the beginning next time
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
    lessons::Lesson own = *panel->shelf().find("pyramid");
    own.name = "/somewhere/my lesson", own.title = "Mine";
    ASSERT_TRUE(panel->openOwn(own));
    EXPECT_EQ(panel->lesson()->title, "Mine");
    ASSERT_EQ(panel->shelf().rowCount(), 2);
    EXPECT_EQ(panel->shelf().index(1).data(LessonShelf::NameRole).toString(), "/somewhere/my lesson");
    panel->goTo(7);
    own.pages.resize(2), own.title = "Mine, shorter";  // its author goes on writing
    ASSERT_TRUE(panel->openOwn(own));
    EXPECT_EQ(panel->shelf().rowCount(), 2);
    EXPECT_EQ(panel->lesson()->title, "Mine, shorter");
    EXPECT_LT(panel->page(), 2);
    EXPECT_TRUE(isFilled());
    panel->close();
    ASSERT_TRUE(panel->open("pyramid"));
    EXPECT_EQ(panel->lesson()->pages.size(), 8u);
}

TEST_F(LessonPanelTest, AnUnknownLessonOpensNothing) {
    EXPECT_FALSE(panel->open("piramid"));
    EXPECT_EQ(panel->lesson(), nullptr);
}

}  // namespace
