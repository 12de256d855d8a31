#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/commands/actions.h"
#include "app/stages/stage_card.h"
#include "app/stages/stage_strip.h"
#include "app/stages/step_bar.h"
#include "app/stages/timeline.h"
#include "app/views/view_area.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

using pipeline::StageId;

class WindowSteps : public WindowTest {
protected:
    Stepper& stepper() { return document().stepper(); }
    void openAndCount() {
        openPyramid();
        ASSERT_TRUE(QTest::qWaitFor([this] { return stepper().steps() != nullptr; }, 30000));
    }
    void settle() {
        EXPECT_TRUE(QTest::qWaitFor([this] { return !document().frames().busy() && stepper().isSettled(); }, 30000));
    }
};

TEST_F(WindowSteps, KeysStepInsideAndBackIsTheSamePicture) {
    openAndCount();
    press("Home");
    settle();
    EXPECT_EQ(*stepper().moment(), stepper().steps()->first());
    std::vector<QImage> forth;
    std::vector<pipeline::Moment> moments;
    while (stepper().isInside()) {
        settle();
        forth.push_back(pictureOnScreen());
        moments.push_back(*stepper().moment());
        press("F10");
    }
    ASSERT_GT(forth.size(), 15u);  // vertices, verdicts, normals, polygons, terms, polygons
    for (std::size_t i = forth.size(); i-- > 0;) {
        press("Shift+F10");
        settle();
        EXPECT_EQ(*stepper().moment(), moments[i]);
        EXPECT_EQ(pictureOnScreen(), forth[i]) << text(*stepper().place());
    }
}

TEST_F(WindowSteps, TheSelectionIsWhatCtrlF10RunsTo) {
    openAndCount();
    EXPECT_FALSE(window.actions()[ActionId::RunToSelection]->isEnabled());
    document().pointing().pick(glm::ivec2(268, 281));
    EXPECT_TRUE(window.actions()[ActionId::RunToSelection]->isEnabled());
    press("Ctrl+F10");
    settle();
    EXPECT_EQ(document().stage(), StageId::ZBuffer);
    EXPECT_EQ(stepper().steps()->pixelOf(*stepper().moment()), glm::ivec2(268, 281));
    EXPECT_EQ(window.views().first().buffer().id, pipeline::BufferId::ZView);
}

// The step's pixel is in the middle, so large that numbers can be read in the pixels; a view that somebody drags stays
// until Follow is pressed. What has only names is shown whole.
TEST_F(WindowSteps, ViewsMarkThePixelOfTheAlgorithmsStepAndFollowIt) {
    openAndCount();
    window.views().setArrangement("compare");
    window.views().links().set(false);  // linked views stand at the same place
    stepper().setLevel(pipeline::StepLevel::Line);
    const glm::ivec2 pixel(268, 281);
    document().pointing().pick(pixel);
    press("Ctrl+F10");
    settle();
    ASSERT_EQ(stepper().steps()->pixelOf(*stepper().moment()), pixel);
    window.views().showBuffers({{pipeline::BufferId::ZView}, {pipeline::BufferId::PolygonId}});
    settle();
    const auto views = window.views().shownBuffers();
    ASSERT_EQ(views.size(), 2u);
    const auto middleOf = [](const BufferView& view) { return QRectF(view.canvas()->rect()).center(); };
    const auto pixelIn = [&](const BufferView& view) {
        const CanvasPlacing& placing = view.canvas()->placing();
        const glm::ivec2 at = *stepper().steps()->pixelOf(*stepper().moment());
        return placing.placement().toWidget(placing.toShown(QPointF(at.x + 0.5, at.y + 0.5)));
    };
    const auto isFollowed = [&](const BufferView& view) {
        return (pixelIn(view) - middleOf(view)).manhattanLength() < 2 && view.canvas()->placing().zoom() >= 68;
    };
    for (const BufferView* view : views) {
        EXPECT_TRUE(view->findChild<QWidget*>("stepMark")->isVisible());
        EXPECT_FALSE(view->findChild<QPushButton*>("followStep")->isVisible());
    }
    EXPECT_TRUE(isFollowed(*views[0]));
    EXPECT_FALSE(views[0]->state().zoom) << "nobody chose this part; a saved state must not keep it";
    EXPECT_LT(views[1]->canvas()->placing().zoom(), 68);
    EXPECT_TRUE(QRectF(views[1]->canvas()->rect()).contains(pixelIn(*views[1])));
    document().pointing().pick(std::nullopt);
    EXPECT_TRUE(views[1]->canvas()->accessibleDescription().startsWith("x 268 y 281 → "))
        << views[1]->canvas()->accessibleDescription().toStdString();

    CanvasPlacing& placing = views[0]->canvas()->placing();
    placing.drag(placing.placement().origin + QPointF(60, 0));
    const QPointF left = placing.placement().origin;
    for (int i = 0; i < 12; ++i) press("F10");
    settle();
    ASSERT_TRUE(stepper().steps()->pixelOf(*stepper().moment()));
    EXPECT_EQ(placing.placement().origin, left);
    auto* follow = views[0]->findChild<QPushButton*>("followStep");
    ASSERT_TRUE(follow->isVisible());
    EXPECT_TRUE(views[0]->state().zoom) << "a part that somebody dragged to is kept";
    follow->click();
    EXPECT_TRUE(isFollowed(*views[0]));
    EXPECT_FALSE(follow->isVisible());
    window.resize(window.width() - 150, window.height() - 100);
    settle();
    EXPECT_TRUE(isFollowed(*views[0])) << "a view of another size";
    stepper().leave();
    settle();
    EXPECT_FALSE(views[0]->findChild<QWidget*>("stepMark")->isVisible());
}

// The timeline has little room: of a long place its end is cut.
TEST_F(WindowSteps, ThePlaceOfALineBeginsWithTheLine) {
    openAndCount();
    stepper().setLevel(pipeline::StepLevel::Line);
    document().pointing().pick(glm::ivec2(268, 281));
    press("Ctrl+F10");
    settle();
    press("F10");
    settle();
    ASSERT_TRUE(stepper().place()->line);
    const QString words = find<QLabel>("stepWords")->text();
    EXPECT_TRUE(words.startsWith(QString("line %1, ").arg(*stepper().place()->line))) << words.toStdString();
}

TEST_F(WindowSteps, SpacePlaysUnlessAButtonHasTheFocus) {
    openAndCount();
    auto* button = find<QPushButton>("runCommand");
    button->setFocus();
    QTest::keyClick(button, Qt::Key_Space);
    EXPECT_FALSE(stepper().isPlaying());
    QTest::keyClick(QApplication::activePopupWidget() ? QApplication::activePopupWidget() : button, Qt::Key_Escape);
    find<StepBar>("stepBar")->setFocus();
    press("Space");
    EXPECT_TRUE(stepper().isPlaying());
    press("Space");
    EXPECT_FALSE(stepper().isPlaying());
}

TEST_F(WindowSteps, PlayIsNoLongerPressedWhenItHasComeToTheEnd) {
    openAndCount();
    const QAction* play = window.actions()[ActionId::Play];
    find<StepBar>("stepBar")->setFocus();
    press("Home");
    stepper().setLevel(Stepper::Level::Stage);
    stepper().setSpeed(16);
    press("Space");
    ASSERT_TRUE(stepper().isPlaying());
    EXPECT_TRUE(play->isChecked());
    ASSERT_TRUE(QTest::qWaitFor([this] { return !stepper().isPlaying(); }, 20000));
    EXPECT_FALSE(play->isChecked());
}

TEST_F(WindowSteps, AVertexAppearsAsItIsTransformed) {
    openAndCount();
    press("Home");
    settle();
    for (int vertices = 0; vertices <= 5; ++vertices) {
        const auto& shapes = canvas()->content().shapes;
        ASSERT_TRUE(shapes);
        ASSERT_EQ(shapes->points.size(), std::size_t(vertices));
        for (const ShapePoint& point : shapes->points) EXPECT_LT(point.vertex, vertices);
        press("F10");
        settle();
    }
}

TEST_F(WindowSteps, AKeyThatDoesNothingSaysWhy) {
    openAndCount();
    canvas()->setFocus();
    QSignalSpy said(&document(), &Document::said);
    press("F10");
    ASSERT_EQ(said.count(), 1);
    EXPECT_EQ(said.front().front().toString(), "Already at the last step; Home goes to the first.");
}

TEST_F(WindowSteps, BookmarksHaveKeys) {
    openAndCount();
    stepper().goTo(*pipeline::parsePlace("z-buffer/polygon=2"));
    settle();
    press("Ctrl+Shift+B");
    press("End");
    EXPECT_FALSE(stepper().isInside());
    press("Ctrl+1");
    EXPECT_EQ(text(*stepper().place()), "z-buffer/polygon=2");
    EXPECT_FALSE(window.actions()[ActionId::Bookmark2]->isEnabled());
    EXPECT_NE(canvas()->placing().zoom(), 1);
    press("Ctrl+0");
    EXPECT_EQ(canvas()->placing().zoom(), 1) << "1:1 is no bookmark";
}

TEST_F(WindowSteps, ADoubleClickOnACardEndsTheStageAndLaterOnesAreNotYet) {
    openAndCount();
    StageStrip& strip = *find<StageStrip>("stageStrip");
    QTest::mouseDClick(&strip.card(StageId::Cull), Qt::LeftButton);
    settle();
    EXPECT_TRUE(stepper().isInside());
    EXPECT_EQ(document().frames().shown()->until(), StageId::Cull);
    EXPECT_FALSE(strip.card(StageId::Cull).status().time.isEmpty());  // it has run, for this frame or one before
    EXPECT_NE(strip.card(StageId::Cull).status().state, StageState::InProgress);
    EXPECT_EQ(strip.card(StageId::ShadowBuffer).status().state, StageState::LeftOut);
    EXPECT_EQ(strip.card(StageId::ZBuffer).status().state, StageState::NotYet);
    EXPECT_FALSE(window.views().second().message().contains("left out"));
}

}  // namespace
}  // namespace app
