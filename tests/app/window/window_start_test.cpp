// The start page: what is in sight on small screens, its filter, what it opens, and where it takes up again.
#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTest>
#include <algorithm>

#include "app/commands/actions.h"
#include "app/commands/command_palette.h"
#include "app/docks/panel_docks.h"
#include "app/docks/panel_table.h"
#include "app/document/recent_files.h"
#include "app/lesson/lesson_panel.h"
#include "app/look/theme.h"
#include "app/start/start_card.h"
#include "app/start/start_lesson_row.h"
#include "app/start/start_line.h"
#include "app/start/start_order.h"
#include "app/start/start_page.h"
#include "app/start/start_view_card.h"
#include "app/talk/cue_model.h"
#include "app/talk/presentation.h"
#include "app/widgets/segmented.h"
#include "pipeline/formats/built_in_scenes.h"
#include "tests/app/color_math.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

class WindowStart : public WindowTest {
protected:
    ~WindowStart() override { Theme::current().setScale(1); }

    void settle() {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        QCoreApplication::processEvents();
    }
    void be(ThemeId theme, QSize size, double scale = 0) {
        Theme::current().set(theme);
        if (scale > 0) Theme::current().setScale(scale);
        window.resize(size);
        settle();
    }
    bool isWhole(const QWidget* widget) const {
        return widget->isVisible() && widget->visibleRegion() == QRegion(widget->rect());
    }
    // Of the lecture that is on show, in reading order.
    template <class Widget>
    QList<Widget*> shown() {
        QList<Widget*> all;
        for (Widget* one : window.findChildren<Widget*>())
            if (one->isVisible()) all += one;
        return all;
    }
    void type(const QString& text) {
        auto* field = find<QLineEdit>("startFilter");
        field->setFocus();
        field->setText(text);
        settle();
    }
    QStringList menuTexts(const QMenu& menu) const {
        QStringList texts;
        for (const QAction* action : menu.actions()) texts += action->text();
        return texts;
    }
    QMenu* menu(const QString& path, const QString& title) {
        QMenu* const top = window.actions().menu(path);
        emit top->aboutToShow();
        for (const QAction* action : top->actions())
            if (action->menu() && action->text() == title) return action->menu();
        ADD_FAILURE() << title.toStdString() << " is not in the menu " << path.toStdString();
        return nullptr;
    }
};

// What somebody with five minutes sees without scrolling.
TEST_F(WindowStart, OnASmallScreenPicturesEightScenesAndAllLessonsAreInSight) {
    for (const QSize size : {QSize(1280, 720), QSize(1366, 768), QSize(1440, 900)})
        for (const ThemeId theme : {ThemeId::Light, ThemeId::Dark, ThemeId::Projector})
            for (const int lecture : {0, 1}) {
                be(theme, size);
                SCOPED_TRACE(testing::Message() << size.width() << ", theme " << int(theme) << ", lecture " << lecture);
                QTest::mouseClick(find<QWidget>("startLecture")->findChildren<QPushButton*>()[lecture], Qt::LeftButton);
                settle();
                const auto cards = shown<StartCard>();
                ASSERT_GE(cards.size(), 12);
                for (qsizetype i = 0; i < 8; ++i) EXPECT_TRUE(isWhole(cards[i])) << cards[i]->text().toStdString();
                const auto firsts = shown<StartViewCard>();
                ASSERT_EQ(firsts.size(), 1);
                const auto pictures = firsts[0]->findChildren<StartButton*>();
                EXPECT_EQ(pictures.size(), 4);
                for (const StartButton* picture : pictures) EXPECT_TRUE(isWhole(picture));
                const auto lessons = shown<LessonRow>();
                EXPECT_EQ(lessons.size(), lecture == 0 ? 13 : 5);
                for (const LessonRow* row : lessons) EXPECT_TRUE(isWhole(row)) << row->text().toStdString();
            }
}

TEST_F(WindowStart, AWideScreenShowsBothLecturesWhole) {
    be(ThemeId::Dark, {1920, 1080});
    EXPECT_FALSE(find<QWidget>("startLecture")->isVisible());
    EXPECT_EQ(shown<StartCard>().size(), 27) << "31 scenes, of which four are lecture 1's pictures";
    EXPECT_EQ(shown<LessonRow>().size(), 18);
    for (const QWidget* part : shown<StartButton>()) EXPECT_TRUE(isWhole(part)) << part->objectName().toStdString();
}

TEST_F(WindowStart, LargeTextGivesUpPicturesBeforeLessonsAndKeepsTheOneToGoOnWithInSight) {
    QSettings().setValue("lessons/smooth/page", 2);
    openPyramid();
    window.files().close();  // the page lists anew
    be(ThemeId::Light, {1366, 768}, 1.5);
    for (const StartViewCard* first : shown<StartViewCard>())
        for (const StartButton* picture : first->findChildren<StartButton*>()) EXPECT_FALSE(picture->isVisible());
    auto* row = find<LessonRow>("lesson:smooth");
    EXPECT_TRUE(QTest::qWaitFor([&] { return isWhole(row); }, 5000));
    const auto cards = shown<StartCard>();
    ASSERT_GE(cards.size(), 8);
    for (qsizetype i = 0; i < 8; ++i) EXPECT_TRUE(isWhole(cards[i])) << cards[i]->text().toStdString();
}

TEST_F(WindowStart, EnterInTheFilterOpensTheFirstHit) {
    type("teapot");
    QTest::keyClick(find<QLineEdit>("startFilter"), Qt::Key_Return);
    ASSERT_TRUE(document().hasScene());
    EXPECT_EQ(document().scene().name, "Teapot");
}

// A lecture's choice does not hide a hit in the other one.
TEST_F(WindowStart, TheFilterSearchesBothLecturesAndStaysInSightAtTheTop) {
    be(ThemeId::Light, {1280, 720});
    auto* area = find<QScrollArea>("startScroll");
    auto* field = find<QLineEdit>("startFilter");
    QTest::mouseClick(find<QWidget>("startLecture")->findChildren<QPushButton*>()[2], Qt::LeftButton);
    settle();
    ASSERT_GT(area->verticalScrollBar()->maximum(), 0) << "both lectures scroll";
    area->verticalScrollBar()->setValue(area->verticalScrollBar()->maximum());
    settle();
    EXPECT_TRUE(isWhole(field));
    type("l");
    EXPECT_EQ(area->verticalScrollBar()->value(), 0);
    QTest::mouseClick(find<QWidget>("startLecture")->findChildren<QPushButton*>()[0], Qt::LeftButton);
    type("z-fighting");
    EXPECT_TRUE(find<StartCard>("scene:z_fighting")->isVisible());
    type("no such thing");
    auto* none = find<QPushButton>("startNoMatch");
    EXPECT_EQ(none->text(), "No scene or lesson matches no such thing. Clear the filter");
    none->click();
    EXPECT_TRUE(find<StartCard>("scene:lambert")->isVisible());
    EXPECT_FALSE(none->isVisible());
}

TEST_F(WindowStart, ThePlaceholderOfTheFilterIsLegible) {
    for (const ThemeId theme : {ThemeId::Light, ThemeId::Dark, ThemeId::Projector}) {
        be(theme, {1366, 768});
        const QPalette palette = find<QLineEdit>("startFilter")->palette();
        const QColor ground = Theme::current().colors().raised, words = palette.color(QPalette::PlaceholderText);
        EXPECT_EQ(words.alpha(), 255) << "what is mixed with the ground is fainter than its colour";
        EXPECT_GE(test::contrast(words, ground), theme == ThemeId::Projector ? 7 : 4.5) << int(theme);
    }
}

TEST_F(WindowStart, BeginsWithTheLectureThatWasLastUsed) {
    be(ThemeId::Light, {1366, 768});
    EXPECT_TRUE(find<StartCard>("scene:lambert")->isVisible()) << "lecture 1 at first";
    EXPECT_FALSE(find<StartCard>("scene:teapot")->isVisible());
    QTest::mouseClick(find<QWidget>("startLecture")->findChildren<QPushButton*>()[1], Qt::LeftButton);
    MainWindow again;
    again.resize(1366, 768);
    again.show();
    EXPECT_TRUE(again.findChild<StartCard*>("scene:teapot")->isVisible());
    EXPECT_FALSE(again.findChild<StartCard*>("scene:lambert")->isVisible());
}

TEST_F(WindowStart, EachOfTheFirstPicturesOpensItsOwnScene) {
    for (auto* picture : find<StartViewCard>("view:four-pictures")->findChildren<StartButton*>())
        if (picture->text() == "Back faces culled") QTest::keyClick(picture, Qt::Key_Return);
    ASSERT_TRUE(document().hasScene());
    EXPECT_EQ(document().scene().name, "Back-face culling");
}

TEST_F(WindowStart, ArrowsMoveFromCardToCardAndUpToTheFirstPictures) {
    auto* first = find<StartCard>("scene:ambient");
    first->setFocus();
    press("Right");
    EXPECT_TRUE(find<StartCard>("scene:lambert")->hasFocus());
    press("Down");
    EXPECT_TRUE(find<StartCard>("scene:interpolation")->hasFocus());
    press("Up");
    press("Up");
    EXPECT_TRUE(find<StartViewCard>("view:four-pictures")->hasFocus());
    press("Down");
    EXPECT_TRUE(first->hasFocus());
}

TEST_F(WindowStart, ALessonThatWasLeftIsLitAndAmongTheRecentFilesWithItsPage) {
    window.lessons().open("smooth");
    ASSERT_TRUE(window.lessons().isOpen());
    window.findChild<LessonPanel*>()->close();
    settle();
    ASSERT_TRUE(find<StartPage>("startPage")->isVisible());
    const RecentFile recent = recentFiles().front();
    EXPECT_EQ(nameOf(recent), "Flat, Gouraud, Phong");
    EXPECT_TRUE(recent.where.startsWith("lesson")) << recent.where.toStdString();
    EXPECT_TRUE(find<LessonRow>("lesson:smooth")->lesson().isBegun());
    // From there it goes on as the lesson of the program, with its progress.
    const auto lines = shown<StartLine>();
    const auto line =
        std::ranges::find(lines, QString("Flat, Gouraud, Phong"), [](StartLine* one) { return one->text(); });
    ASSERT_NE(line, lines.end());
    QTest::mouseClick(*line, Qt::LeftButton);
    ASSERT_TRUE(window.findChild<LessonPanel*>()->lesson());
    EXPECT_EQ(window.findChild<LessonPanel*>()->lesson()->name, "smooth");
}

TEST_F(WindowStart, ATalkGoesOnAtItsLastCue) {
    const QString talk = startOrder()[0].talk;
    auto* button = find<QPushButton>("talk:four-pictures");
    EXPECT_EQ(button->text(), "Begin");
    ASSERT_TRUE(window.openFile(talk));
    ASSERT_TRUE(waitForFrame());
    window.actions()[ActionId::NextCue]->trigger();
    ASSERT_TRUE(waitForFrame());
    EXPECT_EQ(recentFiles().front().where, "talk, cue 2 of 36");
    window.files().close();
    settle();
    EXPECT_EQ(button->text(), "Go on");
    button->click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.presentation().isOn(); }, 20000));
    EXPECT_EQ(window.cues().model().current(), 1);
    window.presentation().end();
}

TEST_F(WindowStart, ToolsAndMenusNameTalksLessonsAndScenes) {
    for (const char* tool : {"tool:Give a talk…", "tool:Error against run time…", "tool:Stiff and extreme cases…",
                             "tool:Check my renderer…", "tool:Find the error…"})
        EXPECT_TRUE(find<StartLine>(tool)->isVisible()) << tool;
    const QStringList talks = menuTexts(*menu("File", "Give a talk"));
    EXPECT_TRUE(talks.join('\n').contains("Lecture 1:") && talks.join('\n').contains("Lecture 2:"))
        << talks.join('\n').toStdString();
    QSettings().setValue("lessons/smooth/page", 1000);  // beyond its end: read
    const QMenu& lessons = *menu("Learn", "Lessons of Lecture 1");
    int ticks = 0;
    for (const QAction* action : lessons.actions()) {
        ticks += action->isChecked();
        EXPECT_EQ(action->isChecked(), action->text() == "Flat, Gouraud, Phong") << action->text().toStdString();
    }
    EXPECT_EQ(ticks, 1);
    EXPECT_EQ(lessons.actions().size(), 13);
    EXPECT_EQ(menu("Learn", "Lessons of Lecture 2")->actions().size(), 5);
}

TEST_F(WindowStart, ANewSceneIsOneShape) {
    for (QAction* shape : menu("File", "New")->actions()) {
        shape->trigger();
        ASSERT_TRUE(QTest::qWaitFor([&] { return document().hasScene(); }, 10000)) << shape->text().toStdString();
        ASSERT_TRUE(waitForFrame());
        EXPECT_EQ(document().scene().objects.size(), 1u);
        const auto ids = document().frames().shown()->buffer({pipeline::BufferId::PolygonId});
        ASSERT_TRUE(ids);
        std::size_t drawn = 0;
        for (std::size_t y = 0; y < ids->rows(); ++y)
            for (std::size_t x = 0; x < ids->columns(); ++x) drawn += ids->value(x, y) >= 0;
        EXPECT_GT(double(drawn) / double(ids->rows() * ids->columns()), 0.05) << shape->text().toStdString();
    }
}

TEST_F(WindowStart, ThePaletteFindsTalksAndLessonsByTheWordsOfATeacher) {
    window.actions()[ActionId::RunCommand]->trigger();
    auto* field = find<QLineEdit>("commandField");
    const auto first = [&](const QString& typed) {
        field->setText(typed);
        return window.findChild<CommandPalette*>()->findChild<QListWidget*>()->item(0)->text();
    };
    EXPECT_EQ(first("lecture"), "Lecture 1 as a talk");
    EXPECT_TRUE(first("talk").contains("alk"));
    EXPECT_EQ(first("lesson shadows"), "Who stands in the light");
    window.findChild<CommandPalette*>()->close();
}

TEST(PanelTable, NoTwoPanelsHaveTheSameIcon) {
    QStringList icons;
    for (const PanelRow& row : panelTable()) icons += row.icon;
    EXPECT_EQ(QSet<QString>(icons.begin(), icons.end()).size(), icons.size()) << icons.join(' ').toStdString();
}

}  // namespace
}  // namespace app
