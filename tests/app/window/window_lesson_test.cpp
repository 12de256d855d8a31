// A lesson in the window: the user's scene is put aside and comes back; what a page hides is hidden everywhere.
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTest>
#include <QToolBar>
#include <QToolButton>

#include "app/buffer_view/buffer_view.h"
#include "app/compare/buffer_compare.h"
#include "app/compare/compare_menu.h"
#include "app/docks/panel_dock.h"
#include "app/lesson/lesson_panel.h"
#include "app/views/view_area.h"
#include "lessons/library.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

class WindowLesson : public WindowTest {
protected:
    void writeLesson() {
        QFile file(folder.filePath("lesson.md"));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(
            "title: Hiding\nlecture: L\nsummary: S.\nscene: pyramid\n\n# First\nhides: normal, counts\nbuffers: color, "
            "normal\nText.\nquestion: 2 + 3?\nanswer: 2 + 3\n\n## then\nAfter.\n\n# Second\nset: camera.theta = "
            "20\nText.\n");
    }
    void openLesson() {
        writeLesson();
        ASSERT_TRUE(window.openFile(folder.path()));
        ASSERT_TRUE(waitForFrame());
        ASSERT_TRUE(QTest::qWaitFor([&] { return panel().run().texts().has_value(); }, 10000));
    }
    LessonPanel& panel() { return *window.findChild<LessonPanel*>(); }
    QString title() { return find<QLabel>("title")->text(); }
    bool shows(const char* dock) { return find<PanelDock>(dock)->isVisible(); }
};

TEST_F(WindowLesson, TheUsersSceneComesBackWithItsChangesAndItsSteps) {
    ASSERT_TRUE(window.openFile(resourceScene("two_pyramids.scene")));
    ASSERT_TRUE(waitForFrame());
    const auto theta = *findSetting(document().scene(), "camera.theta");
    const double before = theta.get(document().scene());
    document().change(theta, 47.25);
    document().change(theta, 50);
    document().history().stack()->undo();
    document().setStage(pipeline::StageId::Cull);
    document().pointing().pick(glm::ivec2(300, 200));
    ASSERT_TRUE(waitForFrame());
    const bool hadScene = shows("scene"), hadInspector = shows("inspector");
    const auto state = window.shown().now();

    openLesson();  // asks nothing
    EXPECT_EQ(title(), "Lesson: Hiding · your scene stays as it was");
    EXPECT_FALSE(document().history().stack()->canUndo());
    EXPECT_FALSE(document().isChanged());
    panel().goTo(1);
    EXPECT_FALSE(document().history().stack()->canUndo()) << "a page is no edit";
    find<QToolButton>("closeLesson")->click();

    EXPECT_EQ(document().scene().name, "two_pyramids.scene");
    EXPECT_EQ(theta.get(document().scene()), 47.25);
    EXPECT_EQ(window.shown().now(), state);
    EXPECT_TRUE(document().isChanged());
    EXPECT_EQ(shows("scene"), hadScene);
    EXPECT_EQ(shows("inspector"), hadInspector);
    document().history().stack()->redo();
    EXPECT_EQ(theta.get(document().scene()), 50);
    document().history().stack()->undo();
    document().history().stack()->undo();
    EXPECT_EQ(theta.get(document().scene()), before);
    EXPECT_FALSE(document().isChanged());
    EXPECT_TRUE(title().startsWith("two_pyramids.scene"));
}

TEST_F(WindowLesson, WithoutASceneClosingGoesBackToTheStartPage) {
    openLesson();
    EXPECT_EQ(title(), "Lesson: Hiding");
    find<QToolButton>("closeLesson")->click();
    EXPECT_FALSE(window.shown().now());
    EXPECT_FALSE(shows("lesson"));
}

TEST_F(WindowLesson, ItsPanelsAreNotKeptForTheNextScene) {
    window.resize(1800, 1000);  // all panels have room
    openLesson();
    ASSERT_FALSE(shows("inspector")) << "the page does without it";
    find<QToolButton>("closeLesson")->click();
    openPyramid();
    EXPECT_TRUE(shows("inspector"));
    EXPECT_TRUE(shows("scene"));
}

// Nothing was open before: the scene that is opened next has the stage and the views of a new window.
TEST_F(WindowLesson, ItsStageArrangementAnd3dOptionsStayInItWithoutASceneToo) {
    openPyramid();
    const auto expected = window.shown().now();
    MainWindow other;
    other.resize(window.size());
    other.show();
    QFile file(folder.filePath("lesson.md"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(
        "title: T\nlecture: L\nsummary: S.\nscene: pyramid\n\n# First\nstage: cull\n"
        "arrangement: (buffer / buffer) | 3d\noptions: normals = 1, handles = 0\nText.\n");
    file.close();
    ASSERT_TRUE(other.openFile(folder.path()));
    Document& document = other.document();
    ASSERT_TRUE(QTest::qWaitFor([&] { return document.stage() == pipeline::StageId::Cull; }, 10000));
    other.findChild<QToolButton*>("closeLesson")->click();
    ASSERT_TRUE(other.openFile(resourceScene("pyramid.scene")));
    ASSERT_TRUE(QTest::qWaitFor([&] { return other.shown().now() && document.frames().shown(); }, 10000));
    const auto shown = other.shown().now();
    EXPECT_EQ(shown->stage, expected->stage);
    EXPECT_EQ(shown->arrangement, expected->arrangement);
    ASSERT_FALSE(shown->spaces.empty());
    EXPECT_EQ(shown->spaces[0].options, expected->spaces[0].options);
}

TEST_F(WindowLesson, WhatAPageHidesIsHiddenUntilTheAnswer) {
    openLesson();
    const auto normalView = [&] {
        for (BufferView* view : window.views().shownBuffers())
            if (view->buffer().id == pipeline::BufferId::Normal) return view;
        return static_cast<BufferView*>(nullptr);
    };
    ASSERT_NE(normalView(), nullptr);
    EXPECT_EQ(normalView()->message(), "normal\nafter your answer");
    EXPECT_FALSE(normalView()->shown());
    EXPECT_FALSE(shows("inspector") || shows("tables") || shows("scanline"));
    EXPECT_FALSE(find<PanelDock>("inspector")->toggleViewAction()->isEnabled());
    EXPECT_FALSE(find<QAbstractButton>("inspectorTab")->isVisible()) << "nothing says that something is hidden";
    find<QLineEdit>("answer")->setText("5");
    find<QPushButton>("check")->click();
    ASSERT_TRUE(waitForFrame());
    EXPECT_TRUE(QTest::qWaitFor([&] { return normalView()->shown().has_value(); }, 10000));
    EXPECT_TRUE(find<QAbstractButton>("inspectorTab")->isVisible());
}

// Each enabled row of a menu and of the menus in it.
QStringList offered(QMenu& menu) {
    QStringList rows;
    emit menu.aboutToShow();
    for (QAction* action : menu.actions())
        if (action->menu())
            rows += offered(*action->menu());
        else if (action->isEnabled() && !action->isSeparator())
            rows += action->text();
    return rows;
}

// Another setting, buffer or stage may be the answer: this page asks for what Phong shading shows.
TEST_F(WindowLesson, NoMenuOfAViewOffersTheAnswerOfAPage) {
    const auto path = lessons::lessonFolder() / "smooth";
    ASSERT_TRUE(window.openFile(QString::fromStdString(path.string())));
    ASSERT_TRUE(waitForFrame());
    const std::vector<lessons::Page>& pages = panel().run().lesson()->pages;
    const auto page = std::ranges::find(pages, "Where is the lost highlight?", &lessons::Page::heading);
    ASSERT_NE(page, pages.end());
    panel().goTo(int(page - pages.begin()));
    ASSERT_TRUE(waitForFrame());
    ASSERT_GT(document().hidden().count(), 0u);
    BufferView* view = window.views().shownBuffers().front();
    QMenu menu;
    const auto others = [&] {
        fillCompareMenu(menu, view->compare(), document(), view->buffer());
        return offered(menu);
    };
    EXPECT_EQ(others(), QStringList({"A file…"}));
    QList<QMenu*> menus = view->findChildren<QMenu*>();
    menus.removeIf([](QMenu* each) { return qobject_cast<QMenu*>(each->parent()); });  // made anew by the one around it
    for (QMenu* each : menus)
        for (const QString& row : offered(*each))
            EXPECT_FALSE(row.contains("phong", Qt::CaseInsensitive)) << row.toStdString();
    const auto holdsPrevious = [&] {
        QTest::keyPress(view, Qt::Key_QuoteLeft);
        const bool holds = view->compare().isOn();
        QTest::keyRelease(view, Qt::Key_QuoteLeft);
        return holds;
    };
    EXPECT_FALSE(holdsPrevious());
    auto* const showMe = find<QAbstractButton>("showMe");
    ASSERT_TRUE(QTest::qWaitFor([&] { return showMe->isEnabled(); }));  // once the page's texts are there
    showMe->click();
    find<QAbstractButton>("showSure")->click();
    ASSERT_TRUE(waitForFrame());
    view = window.views().shownBuffers().front();  // the second half has views of its own
    EXPECT_TRUE(others().contains("gouraud")) << others().join(", ").toStdString();
    EXPECT_TRUE(holdsPrevious());
}

TEST_F(WindowLesson, OnlyThisHidesTheOtherPanelsAndIsRemembered) {
    openPyramid();
    window.resize(1600, 1000);
    openLesson();
    EXPECT_TRUE(shows("lesson"));
    EXPECT_FALSE(shows("scene") || shows("settings") || find<QToolBar>("timelineBar")->isVisible());
    find<QToolButton>("onlyThis")->click();
    EXPECT_TRUE(shows("scene") && shows("settings") && find<QToolBar>("timelineBar")->isVisible());
    EXPECT_FALSE(shows("inspector")) << "it is hidden until the answer";
    EXPECT_FALSE(LessonPanel(document()).isOnlyThis());
}

}  // namespace
}  // namespace app
