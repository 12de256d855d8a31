// A page of a lesson in the window whose picture is held: by the mouse on it, by keys, by a screen reader.
#include <QAccessible>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTest>
#include <QToolButton>

#include "app/buffer_view/buffer_header.h"
#include "app/buffer_view/buffer_holds.h"
#include "app/buffer_view/buffer_view.h"
#include "app/buffer_view/held_band.h"
#include "app/canvas/buffer_canvas.h"
#include "app/docks/panel_dock.h"
#include "app/document/hand.h"
#include "app/holds/held_files.h"
#include "app/holds/hold_grip.h"
#include "app/lesson/lesson_panel.h"
#include "app/look/theme.h"
#include "app/views/view_area.h"
#include "lessons/library.h"
#include "pipeline/scene/settings_table.h"
#include "pipeline/scene/view.h"
#include "tests/app/window/held_lesson_fixture.h"

namespace app {
namespace {

// A lamp at infinity stands around the ball by the angle between L and the line of sight: on its middle it shines from the eye.
TEST_F(HeldLesson, ADraggedLampShinesFromWhereItIsSeen) {
    open("diffuse");
    const pipeline::Vec3d before = L();
    const pipeline::View view = makeView(document().scene());
    const glm::dvec2 ball = *projected(view, {0, 0, 0});
    dragTo(onCanvas(glm::ivec2(ball)));
    const pipeline::Vec3d toEye = glm::normalize(view.eye), now = glm::normalize(L());
    // The cursor is within a pixel of the middle; the ball's radius of some 170 pixels are 90°: less than 2°.
    EXPECT_GT(glm::dot(toEye, now), std::cos(glm::radians(2.0)));
    EXPECT_NEAR(glm::length(L()), glm::length(before), 1e-3 * glm::length(before)) << "a lamp keeps its length";
    ASSERT_TRUE(document().history().stack()->canUndo());
    document().history().stack()->undo();
    EXPECT_EQ(L(), before) << "the drag is one step of undo";
}

TEST_F(HeldLesson, EscPutsItBackAndLeavesNoStepOfUndo) {
    open("diffuse");
    const pipeline::Vec3d before = L();
    QTest::mousePress(&grip(), Qt::LeftButton, {}, middle());
    QTest::mouseMove(&grip(), middle() + QPoint(60, 0));
    EXPECT_NE(L(), before);
    QTest::keyClick(&grip(), Qt::Key_Escape);
    EXPECT_EQ(L(), before);
    QTest::mouseRelease(&grip(), Qt::LeftButton, {}, middle());
    EXPECT_EQ(L(), before);
    EXPECT_FALSE(document().history().stack()->canUndo());
}

TEST_F(HeldLesson, ByKeysAloneItMovesBothWaysAndComesHome) {
    open("diffuse");
    const pipeline::Vec3d before = L();
    grip().setFocus();
    for (const Qt::Key key : {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down}) {
        const pipeline::Vec3d was = L();
        QTest::keyClick(&grip(), key);
        EXPECT_NE(L(), was) << key;
    }
    QTest::keyClick(&grip(), Qt::Key_Home);
    EXPECT_EQ(L(), before);
}

TEST_F(HeldLesson, AScreenReaderHasASliderWithTheWordsBesideIt) {
    open("diffuse");
    QAccessibleInterface* spoken = QAccessible::queryAccessibleInterface(&grip());
    EXPECT_EQ(spoken->role(), QAccessible::Slider);
    EXPECT_EQ(spoken->text(QAccessible::Name), "Lamp");
    // The page shows N·L of its ringed point with two digits, and its angle.
    EXPECT_TRUE(spoken->text(QAccessible::Description).startsWith(QStringLiteral("N·L ")))
        << spoken->text(QAccessible::Description).toStdString();
    EXPECT_GE(grip().width(), 44);
}

// The lamp far out on the other side lights the ringed point no more: N·L is 0 or less, and that is the play's condition.
TEST_F(HeldLesson, ThePlayIsDoneOnceItsConditionWasTrueAndStaysSo) {
    open("diffuse");
    EXPECT_FALSE(hand().isPlayed());
    const QPoint right(canvas()->width() - 30, placeOfGrip().y());
    dragTo(right);
    ASSERT_TRUE(QTest::qWaitFor([&] { return hand().isPlayed(); }, 10000));
    QTest::keyClick(&grip(), Qt::Key_Home);
    ASSERT_TRUE(waitForFrame());
    EXPECT_TRUE(hand().isPlayed());
}

TEST_F(HeldLesson, ThePictureHasTheRoom) {
    open("diffuse");
    EXPECT_FALSE(window.views().first().header().isVisible());
    EXPECT_FALSE(find<QWidget>("stageStrip")->isVisible());
    const QImage shot = canvas()->grab().toImage();
    EXPECT_EQ(shot.pixelColor(3, shot.height() - 3), QColor(Qt::black)) << "around the picture it is black";
    find<QToolButton>("onlyThis")->click();
    EXPECT_TRUE(window.views().first().header().isVisible());
    EXPECT_TRUE(find<QWidget>("stageStrip")->isVisible());
}

// The apex of pyramid.des is its vertex 4.
// What leads nowhere, and what tells of the computation, waits; the answer brings the way on.
TEST_F(HeldLesson, BesideItStandsWhatThePageIsAbout) {
    open("diffuse");
    for (const char* name : {"previousPage", "nextPage", "onlyThis", "writeHandout", "statusError", "statusThreads"})
        EXPECT_FALSE(find<QWidget>(name)->isVisible()) << name;
    EXPECT_EQ(find<QLabel>("statusNan")->text(), "");
    auto* more = find<QToolButton>("lessonMore");
    ASSERT_TRUE(more->isVisible());
    QStringList entries;
    for (const QAction* entry : more->menu()->actions()) entries << entry->text();
    EXPECT_EQ(entries, (QStringList{"Only this", "Write this lesson as a handout…"}));
    type("48");
    press("Return");
    EXPECT_TRUE(find<QWidget>("nextPage")->isVisible());
    EXPECT_TRUE(find<QWidget>("nextPage")->hasFocus());
    more->menu()->actions()[0]->trigger();
    ASSERT_TRUE(waitForFrame());
    EXPECT_FALSE(window.findChild<LessonPanel*>()->isOnlyThis());
    for (const char* name : {"previousPage", "onlyThis", "writeHandout", "statusThreads"})
        EXPECT_TRUE(find<QWidget>(name)->isVisible()) << name;
    EXPECT_FALSE(more->isVisible());
}

TEST_F(HeldLesson, TheFileBesideThePictureFollowsTheVertex) {
    open("pyramid");
    auto* files = find<HeldFiles>("heldFiles");
    for (auto* other : window.findChildren<HeldFiles*>())
        if (other->isVisible()) files = other;
    ASSERT_TRUE(files->isVisible());
    const auto lineOfApex = [&] {
        const QStringList lines = files->toPlainText().split('\n');
        const qsizetype at = lines.indexOf("vertex 4");
        return at > 0 ? lines[at - 1] : QString();
    };
    const double x = findSetting(document().scene(), "vertex.0.4.x")->get(document().scene());
    EXPECT_EQ(lineOfApex(), QString("(%1,75,150)").arg(x));
    dragTo(placeOfGrip() + QPoint(-40, -10));
    const double moved = findSetting(document().scene(), "vertex.0.4.x")->get(document().scene());
    EXPECT_NE(moved, x);
    EXPECT_TRUE(lineOfApex().startsWith(QString("(%1,").arg(moved))) << lineOfApex().toStdString();
}

// "Which rod is the mirror direction? Click it.": there the eye is held by all of the picture.
TEST_F(HeldLesson, AClickOnAHeldPicturePicksAndMovesNothing) {
    open("reflection");
    ASSERT_TRUE(hand().holdOfEye());
    const pipeline::Scene before = document().scene();
    QTest::mouseClick(canvas(), Qt::LeftButton, {}, onCanvas({320, 200}));
    EXPECT_EQ(document().pointing().pixel(), glm::ivec2(320, 200));
    EXPECT_TRUE(document().scene() == before);
    EXPECT_FALSE(document().history().stack()->canUndo());
}

// One doubling of n for each doubling of z on the figure's axis: from 0.05 to 15 in log(300) parts of the track.
TEST_F(HeldLesson, TheNearPlaneIsMovedOnTheAxisOfTheCodes) {
    open("depth-precision");
    auto& band = this->band();
    ASSERT_EQ(grip().parentWidget(), &band);
    EXPECT_TRUE(band.accessibleDescription().contains("the objects")) << "their codes are what is asked";
    const auto near = [&] { return findSetting(document().scene(), "camera.near")->get(document().scene()); };
    EXPECT_EQ(near(), 0.05);
    const QLineF track = band.track().value();
    dragTo(placeOfGrip() + QPoint(int(track.dx() / 2), 0));
    EXPECT_NEAR(near(), std::sqrt(0.05 * 15), 0.03) << "half of the way is the geometric mean";
    grip().setFocus();
    QTest::keyClick(&grip(), Qt::Key_Home);
    EXPECT_EQ(near(), 0.05) << "and not the timeline's first step";
}

// "How much red light leaves the ringed point in the dark?" 0.8 · 60 = 48, whatever the lamp does.
TEST_F(HeldLesson, NothingMovesAtTheAnswerAndTheEquationFollows) {
    open("diffuse");
    const QRect before = canvas()->geometry();
    const QPoint ring = onCanvas({211, 268});
    ASSERT_TRUE(band().isVisible()) << "its place is kept from the beginning";
    EXPECT_EQ(band().accessibleDescription(), "");
    EXPECT_FALSE(find<QPushButton>("lookInside")->isVisible());
    find<QLineEdit>("answer")->setText("48");
    find<QPushButton>("check")->click();
    ASSERT_TRUE(waitForFrame());
    EXPECT_EQ(canvas()->geometry(), before);
    EXPECT_EQ(onCanvas({211, 268}), ring);
    const QString first = band().accessibleDescription();
    EXPECT_TRUE(first.startsWith("k_r I_a 48.0 + k_r I_0 max(0, N·L) ")) << first.toStdString();
    dragTo(QPoint(canvas()->width() - 30, placeOfGrip().y()));
    EXPECT_TRUE(QTest::qWaitFor([&] { return band().accessibleDescription().endsWith("0.0 = 48.0"); }, 5000))
        << band().accessibleDescription().toStdString();
}

// There the picture's frame comes later than the answer: of the lamp where the hand has left it.
TEST_F(HeldLesson, NothingMovesAtTheAnswerWithALampThatWasMoved) {
    open("diffuse");
    Theme::current().set(ThemeId::Projector);
    grip().setFocus();
    press("Shift+Right");
    ASSERT_TRUE(waitForFrame());
    const QPoint ring = onCanvas({211, 268});
    find<QLineEdit>("answer")->setText("48");
    find<QPushButton>("check")->click();
    ASSERT_TRUE(waitForFrame());
    EXPECT_EQ(onCanvas({211, 268}), ring);
    Theme::current().set(ThemeId::Light);
}

// "Your view is not the page's." is not said of what the play asks for.
TEST_F(HeldLesson, WhatAHandMovesIsTheReadersOwn) {
    for (const char* lesson : {"diffuse", "pyramid"}) {
        open(lesson);
        grip().setFocus();
        press("Right");
        EXPECT_FALSE(run().isElsewhere()) << lesson;
        document().edit(*withSetting(document().scene(), "ambient.intensity=7"), "other", Document::Change::Done);
        EXPECT_TRUE(run().isElsewhere()) << lesson;
    }
}

// A small screen has no room for both: the file whose vertex is held is shown, of the other the name.
TEST_F(HeldLesson, EachFileIsNamedOnceWhereThereIsNoRoom) {
    open("pyramid");
    for (const double scale : {1.0, 1.5, 2.0, 1.0})
        for (const int height : {900, 720, 600}) {
            Theme::current().setScale(scale);
            window.resize(1366, height);
            QCoreApplication::processEvents();
            for (auto* files : window.findChildren<HeldFiles*>()) {
                if (!files->isVisible()) continue;
                EXPECT_EQ(files->toPlainText().count("pyramid.scene"), 1) << height << ' ' << scale;
                EXPECT_EQ(files->toPlainText().count("vertex 4"), 1) << height << ' ' << scale;
            }
        }
}

TEST_F(HeldLesson, WordsWiderThanThePictureAreBroken) {
    open("pyramid");
    Theme::current().setScale(1.5);
    find<QPushButton>("showMe")->click();
    find<QPushButton>("showSure")->click();
    ASSERT_TRUE(waitForFrame());
    for (auto* words : canvas()->findChildren<QWidget*>("holdWords"))
        EXPECT_TRUE(words->isHidden() || canvas()->rect().contains(words->geometry()));
    Theme::current().setScale(1);
}

TEST_F(HeldLesson, ASpotStaysInItsRowByMouseAndKeys) {
    open("z-buffer");
    run().goTo(7);  // "Where two planes cross", row 240
    ASSERT_TRUE(QTest::qWaitFor([&] { return run().texts().has_value(); }, 10000));
    ASSERT_TRUE(waitForFrame());
    const auto spot = [&] { return document().pointing().pixel().value_or(glm::ivec2(-1)); };
    dragTo(placeOfGrip() + QPoint(120, 70));
    const glm::ivec2 dragged = spot();
    EXPECT_EQ(dragged.y, 240);
    EXPECT_GT(dragged.x, 100);
    QTest::keyClick(&grip(), Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_EQ(spot(), dragged + glm::ivec2(10, 0));
    QTest::mouseClick(canvas(), Qt::LeftButton, {}, onCanvas({300, 100}));
    EXPECT_EQ(spot(), glm::ivec2(300, 240)) << "a click elsewhere moves it along its row";
}

TEST_F(HeldLesson, LookInsideShowsTheInstrumentsAndThePictureAgain) {
    open("diffuse");
    find<QLineEdit>("answer")->setText("48");
    find<QPushButton>("check")->click();
    ASSERT_TRUE(waitForFrame());
    auto* inside = find<QPushButton>("lookInside");
    for (auto* other : window.findChildren<QPushButton*>("lookInside"))
        if (other->isVisible()) inside = other;
    ASSERT_TRUE(inside->isVisible());
    inside->click();
    EXPECT_TRUE(window.views().first().header().isVisible());
    EXPECT_TRUE(find<QWidget>("stageStrip")->isVisible());
    inside->click();
    EXPECT_FALSE(window.views().first().header().isVisible());
}

// Without the lesson nothing can be held any more.
TEST_F(HeldLesson, NothingIsLeftInTheHandWhenTheLessonIsClosed) {
    open("diffuse");
    find<QToolButton>("closeLesson")->click();
    EXPECT_TRUE(hand().holds().empty());
    EXPECT_TRUE(window.views().first().header().isVisibleTo(&window.views().first()));
}

}  // namespace
}  // namespace app
