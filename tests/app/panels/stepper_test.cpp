// Stepping inside a frame without a window: the stepper, the document behind it, the track's numbers, the timeline.
#include "app/frames/stepper.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "app/document/document.h"
#include "app/frames/stage_status.h"
#include "app/look/theme.h"
#include "app/stages/stage_card.h"
#include "app/stages/stage_strip.h"
#include "app/stages/step_bar.h"
#include "app/stages/step_track.h"
#include "app/stages/timeline.h"
#include "tests/support/scenes.h"

namespace app {
namespace {

using pipeline::BufferId;
using pipeline::Moment;
using pipeline::Place;
using pipeline::StageId;

class StepperTest : public testing::Test {
protected:
    StepperTest() {
        pipeline::Scene scene = test::pyramid();
        scene.settings.cull = pipeline::CullMode::None;
        document.frames().want(&owner, pipeline::setOf({BufferId::ZView, BufferId::Overdraw}));
        document.setScene(std::move(scene));
        EXPECT_TRUE(QTest::qWaitFor([this] { return !document.frames().busy() && stepper.steps(); }, 30000));
    }
    // Goes somewhere and waits for the state there.
    void goTo(const char* place) {
        stepper.goTo(*pipeline::parsePlace(place));
        waitForState();
    }
    void waitForState() {
        EXPECT_TRUE(QTest::qWaitFor([this] { return !document.frames().busy() && stepper.isSettled(); }, 30000));
    }
    double overdraw(std::size_t x, std::size_t y) {
        return document.frames().shown()->buffer({BufferId::Overdraw})->value(x, y);
    }
    double fragments() {
        const auto buffer = document.frames().shown()->buffer({BufferId::Overdraw});
        double sum = 0;
        for (std::size_t i = 0; i < buffer->count(); ++i) sum += buffer->flat(i);
        return sum;
    }
    QObject owner;
    Document document;
    Stepper& stepper = document.stepper();
};

TEST_F(StepperTest, InsideAStageTheDocumentShowsTheStateThere) {
    goTo("z-buffer/polygon=1");
    EXPECT_EQ(document.stage(), StageId::ZBuffer);
    EXPECT_EQ(fragments(), double(stepper.moment()->done));
    EXPECT_FALSE(document.frames().shown()->buffer({BufferId::Color}));
    EXPECT_TRUE(document.frames().whole()->buffer({BufferId::Color}));
    stepper.toLast();
    EXPECT_EQ(document.frames().shown(), document.frames().whole());
    EXPECT_EQ(document.stage(), StageId::Shading);
}

TEST_F(StepperTest, StepsByItsLevelAndBackAgain) {
    goTo("z-buffer/polygon=1");
    const Moment here = *stepper.moment();
    for (const auto level : {Stepper::Level::Polygon, Stepper::Level::Scanline, Stepper::Level::Pixel}) {
        stepper.setLevel(level);
        stepper.step(1);
        EXPECT_GT(*stepper.moment(), here);
        stepper.step(-1);
        EXPECT_EQ(*stepper.moment(), here);
    }
    stepper.setLevel(Stepper::Level::Stage);
    stepper.step(1);
    EXPECT_EQ(*stepper.moment(), (Moment{StageId::ZBuffer, stepper.steps()->total(StageId::ZBuffer)}));
}

TEST_F(StepperTest, FromTheWholeFrameTheOnlyWayIsBack) {
    EXPECT_FALSE(stepper.isInside());
    EXPECT_FALSE(stepper.canStep(1));
    EXPECT_TRUE(stepper.canStep(-1));
    stepper.step(-1);
    EXPECT_TRUE(stepper.isInside());
    EXPECT_LT(*stepper.moment(), stepper.steps()->last());
    stepper.step(1);  // the last step: the whole frame again
    EXPECT_FALSE(stepper.isInside());
    stepper.toFirst();
    EXPECT_FALSE(stepper.canStep(-1));
}

TEST_F(StepperTest, FromTheEndOfAStageStepsLeadBothWays) {
    document.setStage(pipeline::StageId::ZBuffer);
    EXPECT_FALSE(stepper.isInside());
    EXPECT_TRUE(stepper.canStep(1));
    stepper.step(1);
    EXPECT_TRUE(stepper.isInside());
    EXPECT_EQ(stepper.moment()->stage, pipeline::StageId::Shading);
    document.setStage(pipeline::StageId::ZBuffer);
    stepper.step(-1);
    EXPECT_EQ(stepper.moment()->stage, pipeline::StageId::ZBuffer);
    EXPECT_LT(*stepper.moment(), stepper.steps()->momentOf({pipeline::StageId::ZBuffer}));
}

TEST_F(StepperTest, APlaceHoldsWhileTheSceneChanges) {
    goTo("z-buffer/polygon=2/row=270/x=258");
    const Place place = *stepper.place();
    document.change(*findSetting(document.scene(), "camera.theta"), 50);
    EXPECT_TRUE(QTest::qWaitFor(
        [this] { return !document.frames().busy() && stepper.steps()->frame() == document.frames().whole(); }, 30000));
    waitForState();
    EXPECT_EQ(stepper.place(), place);
    EXPECT_EQ(document.frames().shown()->until(), StageId::ZBuffer);
    EXPECT_EQ(document.frames().shown()->scene().camera.theta, 50);
}

TEST_F(StepperTest, GoingToAStageOrAnotherSceneLeavesTheInside) {
    goTo("z-buffer/polygon=1");
    document.setStage(StageId::Cull);
    EXPECT_FALSE(stepper.isInside());
    EXPECT_EQ(document.stage(), StageId::Cull);
    EXPECT_EQ(document.frames().shown(), document.frames().whole());
    goTo("z-buffer/polygon=1");
    stepper.toggleBookmark();
    document.setScene(test::pyramid());
    EXPECT_FALSE(stepper.isInside());
    EXPECT_TRUE(stepper.bookmarks().empty());
}

TEST_F(StepperTest, BookmarksStandInTheOrderOfTheFrame) {
    for (const char* place : {"shading/polygon=2", "cull/polygon=1", "z-buffer/polygon=2/row=270"}) {
        goTo(place);
        EXPECT_EQ(stepper.bookmarkHere(), -1);
        stepper.toggleBookmark();
    }
    ASSERT_EQ(stepper.bookmarks().size(), 3u);
    EXPECT_EQ(text(stepper.bookmarks()[0]), "cull/polygon=1");
    EXPECT_EQ(text(stepper.bookmarks()[1]), "z-buffer/polygon=2/row=270");
    EXPECT_EQ(stepper.bookmarkHere(), 1);
    stepper.toggleBookmark();
    EXPECT_EQ(stepper.bookmarks().size(), 2u);
}

TEST_F(StepperTest, PlayingGoesToTheEndAndStops) {
    stepper.setLevel(Stepper::Level::Object);
    stepper.setSpeed(16);
    stepper.setPlaying(true);
    EXPECT_TRUE(stepper.isPlaying());
    EXPECT_TRUE(stepper.isInside());  // from the beginning
    EXPECT_TRUE(QTest::qWaitFor([this] { return !stepper.isPlaying(); }, 30000));
    EXPECT_FALSE(stepper.isInside());
}

TEST_F(StepperTest, CardsSayHowFarTheStageIsAndWhatIsNotYet) {
    goTo("z-buffer/polygon=2/row=270/x=258");
    const auto status = stageStatus(*stepper.steps(), *stepper.moment(), Stepper::Level::Pixel, {});
    const auto of = [&](StageId stage) { return status[index(stage)]; };
    EXPECT_EQ(of(StageId::Transform).state, StageState::Ran);
    EXPECT_EQ(of(StageId::ZBuffer).state, StageState::InProgress);
    EXPECT_TRUE(of(StageId::ZBuffer).time.endsWith("fragments")) << of(StageId::ZBuffer).time.toStdString();
    EXPECT_EQ(of(StageId::ZBuffer).counts, "polygon 2, row 270, x 258");
    EXPECT_GT(*of(StageId::ZBuffer).progress, 0);
    EXPECT_LT(*of(StageId::ZBuffer).progress, 1);
    EXPECT_EQ(of(StageId::Shading).state, StageState::NotYet);
    EXPECT_EQ(of(StageId::Shading).counts, "after Z-buffer");
}

TEST_F(StepperTest, TheTrackTakesAPlaceThereAndBack) {
    const StepTrack track{*stepper.steps(), 1200, 4};
    for (const char* place : {"transform/start", "transform/vertex=2", "cull", "normals/polygon=1",
                              "z-buffer/polygon=2", "shading/polygon=1", "shading"}) {
        const Moment moment = stepper.steps()->momentOf(*pipeline::parsePlace(place));
        EXPECT_EQ(snapped(*stepper.steps(), track.momentAt(track.xOf(moment)), Stepper::Level::Polygon), moment)
            << place;
    }
    EXPECT_EQ(track.momentAt(-50), stepper.steps()->first());
    EXPECT_EQ(track.momentAt(5000), stepper.steps()->last());
    // Five vertices; 5 372 fragments are too close.
    EXPECT_EQ(track.ticks(StageId::Transform, Stepper::Level::Pixel).size(), 5u);
    EXPECT_TRUE(track.ticks(StageId::ZBuffer, Stepper::Level::Pixel).empty());
    EXPECT_EQ(track.ticks(StageId::ZBuffer, Stepper::Level::Object).size(), 1u);
}

TEST(StageNames, FollowTheLettersAndAreShortenedWhereThereIsNoRoom) {
    Theme::current().setScale(1.5);
    const QFont usual = Theme::current().text(12, 600);
    const auto width = [&](const char* name) { return QFontMetrics(usual).horizontalAdvance(name); };
    const StageNames whole(width("Shadow buffer")), first(width("Transform"));
    EXPECT_EQ(whole.texts[3], "Shadow buffer");
    EXPECT_EQ(first.texts[3], "Shadow");
    EXPECT_EQ(first.texts[0], "Transform");
    for (const StageNames& names : {whole, first}) EXPECT_EQ(names.font.pixelSize(), usual.pixelSize());
    const StageNames narrow(width("Trans"));
    EXPECT_LT(narrow.font.pixelSize(), usual.pixelSize());
    EXPECT_GE(narrow.font.pixelSize(), 12) << "is read on any screen";
    for (const QString& name : narrow.texts)
        EXPECT_LE(QFontMetrics(narrow.font).horizontalAdvance(name), width("Trans"));
    Theme::current().setScale(1);
}

TEST_F(StepperTest, TheWheelAndTheArrowsStep) {
    StepBar bar(stepper);
    bar.resize(800, 50);
    goTo("z-buffer/polygon=1");
    QTest::keyClick(&bar, Qt::Key_Right);
    EXPECT_EQ(text(*stepper.place()), "z-buffer/polygon=2");
    QWheelEvent notch({100, 25}, {100, 25}, {}, {0, 120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&bar, &notch);
    EXPECT_EQ(text(*stepper.place()), "z-buffer/polygon=1");
    QWheelEvent back({100, 25}, {100, 25}, {}, {0, -120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&bar, &back);
    EXPECT_EQ(text(*stepper.place()), "z-buffer/polygon=2");
}

TEST_F(StepperTest, TheHandleIsWhereTheHandPutsItAtOnce) {
    StepBar bar(stepper);
    bar.resize(800, 50);
    const Moment there = stepper.steps()->momentOf(*pipeline::parsePlace("z-buffer/polygon=2"));
    const QPoint place(int(bar.xOf(there)), 30);
    QTest::mousePress(&bar, Qt::LeftButton, {}, place);  // no frame has come since
    EXPECT_EQ(stepper.moment(), there);
    EXPECT_NEAR(*bar.handleX(), bar.xOf(there), 0.01);
    QTest::mouseRelease(&bar, Qt::LeftButton, {}, place);
}

TEST_F(StepperTest, TheTimelineSaysWhereTheFrameStands) {
    std::array<QAction, 5> actions;
    Timeline timeline(document, {&actions[0], &actions[1], &actions[2], &actions[3], &actions[4]});
    EXPECT_EQ(timeline.words(), "whole frame");
    goTo("z-buffer/polygon=2");
    EXPECT_EQ(timeline.words(), "polygon 2, 3 of 5");
    stepper.setLevel(Stepper::Level::Pixel);
    goTo("z-buffer/polygon=2/row=270/x=258");
    EXPECT_EQ(timeline.words(), "polygon 2, row 270, x 258");
    for (const QWidget* control : timeline.findChildren<QWidget*>())
        if (qobject_cast<const QComboBox*>(control)) {
            EXPECT_FALSE(control->accessibleName().isEmpty()) << control->objectName().toStdString();
        }
}

}  // namespace
}  // namespace app
