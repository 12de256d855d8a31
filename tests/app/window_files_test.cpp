// What the window writes: nothing is lost without a question, and what cannot be written is told as that.
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTimer>

#include "app/core/session_file.h"
#include "app/desktop/actions.h"
#include "app/desktop/view_area.h"
#include "app/panels/check_panel.h"
#include "app/panels/cue_panel.h"
#include "app/panels/error_list.h"
#include "app/panels/lesson_panel.h"
#include "tests/app/window_fixture.h"

namespace app {
namespace {

class WindowFiles : public WindowTest {
protected:
    // A file that is no lesson's is open, and changed.
    void changeTwoPyramids() {
        ASSERT_TRUE(window.openFile(resourceScene("two_pyramids.scene")));
        ASSERT_TRUE(waitForFrame());
        document().change(*findSetting(document().scene(), "camera.theta"), 47.25);
        ASSERT_TRUE(document().isChanged());
    }
};

TEST_F(WindowFiles, ALessonInTheListAsksBeforeChangesAreLost) {
    changeTwoPyramids();
    auto* lessons = window.findChild<LessonPanel*>();
    auto* list = lessons->findChild<QListView*>();
    answer("Go back", [list] { emit list->activated(list->model()->index(0, 0)); });
    EXPECT_EQ(document().scene().name, "two_pyramids.scene");
    EXPECT_EQ(document().scene().camera.theta, 47.25);
    EXPECT_TRUE(document().undoStack()->canUndo());
    EXPECT_EQ(lessons->lesson(), nullptr) << "the list is still on show";
    answer("Drop", [list] { emit list->activated(list->model()->index(0, 0)); });
    EXPECT_NE(lessons->lesson(), nullptr);
    EXPECT_FALSE(document().isChanged());
}

TEST_F(WindowFiles, ALessonsNextPageAsksWhereAnotherSceneIsOpen) {
    window.openLesson("pyramid");
    changeTwoPyramids();
    auto* lessons = window.findChild<LessonPanel*>();
    answer("Go back", [this] { find<QAbstractButton>("nextPage")->click(); });
    EXPECT_EQ(lessons->page(), 0);
    EXPECT_EQ(document().scene().camera.theta, 47.25);
    answer("Drop", [this] { find<QAbstractButton>("nextPage")->click(); });
    EXPECT_EQ(lessons->page(), 1);
    find<QAbstractButton>("nextPage")->click();  // within its own scene nothing is asked
    EXPECT_EQ(lessons->page(), 2);
}

TEST_F(WindowFiles, ALessonOfASceneThatWasClosedIsShownAgain) {
    window.openLesson("pyramid");
    ASSERT_TRUE(waitForFrame());
    window.actions()[ActionId::Close]->trigger();
    ASSERT_FALSE(window.views().isVisible());
    window.openLesson("pyramid");
    EXPECT_TRUE(window.views().isVisible());
}

TEST_F(WindowFiles, ACaseAsASceneAsksBeforeChangesAreLost) {
    changeTwoPyramids();
    window.actions()[ActionId::Check]->trigger();
    auto* checks = window.findChild<CheckPanel*>();
    ASSERT_NE(checks, nullptr);
    std::size_t which = 0;
    while (!pipeline::check::caseTable()[which].scene) ++which;
    checks->select(which);
    answer("Go back", [checks] { EXPECT_FALSE(checks->openAsScene()); });
    EXPECT_EQ(document().scene().camera.theta, 47.25);
    answer("Drop", [checks] { EXPECT_TRUE(checks->openAsScene()); });
    EXPECT_NE(document().scene().name, "two_pyramids.scene");
    checks->close();
}

}  // namespace
}  // namespace app
