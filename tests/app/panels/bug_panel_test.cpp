// The wrong picture in its window: looks are counted, stages marked and causes named, by the keys alone.
#include "app/bug_game/bug_panel.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTest>
#include <algorithm>

#include "app/bug_game/bug_box.h"
#include "app/canvas/buffer_canvas.h"
#include "tests/app/quiet.h"
#include "tests/support/scenes.h"

namespace app {
namespace {

using Phase = lessons::WrongPicture::Phase;
using pipeline::BufferId;

class BugPanelTest : public testing::Test {
protected:
    BugPanelTest() {
        panel.round().begin(kSeed);
        panel.resize(1366, 720);
        panel.show();
        QApplication::setActiveWindow(&panel);
        EXPECT_TRUE(wait());
    }
    // Until the picture is there, or what was asked of the game is answered.
    bool wait() {
        return QTest::qWaitFor([this] { return panel.round().game() && !panel.round().busy(); }, 60000);
    }
    void press(Qt::Key key, Qt::KeyboardModifiers with = Qt::NoModifier) {
        QWidget* target = panel.focusWidget() ? panel.focusWidget() : &panel;
        QTest::keyClick(target, key, with);
        ASSERT_TRUE(wait());
    }
    BugBox& box(int number) { return *panel.findChild<BugBox*>(QString("bugBox:%1").arg(number)); }
    BufferCanvas& picture() { return *panel.findChild<BufferCanvas*>("bugPicture"); }
    int blamed() { return lessons::boxOf(panel.round().game()->row()); }
    int rightCause() {
        const auto& causes = panel.round().game()->riddle().causes;
        return int(std::ranges::find(causes, panel.round().game()->row().id) - causes.begin());
    }
    std::size_t looks() { return panel.round().game()->looks().size(); }

    static constexpr std::uint64_t kSeed = 2026;
    BugPanel panel;
};

TEST_F(BugPanelTest, TheSameSeedGivesThePicturesOfTheCommand) {
    EXPECT_EQ(panel.round().game()->riddle().defect, lessons::makeRiddle(kSeed, 0)->defect);
    EXPECT_EQ(panel.round().game()->riddle().causes, lessons::makeRiddle(kSeed, 0)->causes);
}

// The card scrolls as a whole: nothing in it has a scroll bar of its own.
TEST_F(BugPanelTest, NothingScrollsInsideOfTheCard) {
    panel.resize(1280, 720);
    auto* text = panel.findChild<QPlainTextEdit*>("bugText");
    auto* looks = panel.findChild<QListWidget*>("bugLooks");
    EXPECT_FALSE(looks->isVisible()) << "there is none yet";
    for (const BufferId id : {BufferId::Normal, BufferId::Depth, BufferId::ObjectId, BufferId::Overdraw}) {
        panel.round().look(pipeline::BufferName{id});
        ASSERT_TRUE(wait());
        ASSERT_TRUE(test::waitUntilQuiet());
        EXPECT_EQ(text->verticalScrollBar()->maximum(), 0) << text->toPlainText().toStdString();
        EXPECT_TRUE(looks->isVisible());
        EXPECT_EQ(looks->verticalScrollBar()->maximum(), 0) << looks->count();
    }
}

TEST_F(BugPanelTest, ThePictureIsFreeAndABufferIsALookOnce) {
    EXPECT_EQ(looks(), 0u);
    EXPECT_TRUE(panel.round().text().startsWith("color: ")) << panel.round().text().toStdString();
    for (int i = 0; i < 2; ++i) {
        panel.round().look(pipeline::BufferName{BufferId::PolygonsVerdict});
        ASSERT_TRUE(wait());
        EXPECT_TRUE(panel.round().text().startsWith("polygons.verdict: "));
        EXPECT_EQ(looks(), 1u);
    }
    EXPECT_EQ(box(1 + int(index(pipeline::StageId::Cull))).verdict(), "1 look");
}

// The arrows are a finger on the picture; only Space looks.
TEST_F(BugPanelTest, APixelIsLookedAtByTheKeys) {
    picture().setFocus();
    press(Qt::Key_Right);
    press(Qt::Key_Down);
    EXPECT_EQ(looks(), 0u);
    press(Qt::Key_Space);
    ASSERT_EQ(looks(), 1u);
    const pipeline::Settings& settings = panel.round().game()->wrong()->scene().settings;
    EXPECT_EQ(panel.round().game()->looks()[0],
              std::to_string(settings.width / 2 + 1) + ", " + std::to_string(settings.height / 2 + 1));
    EXPECT_EQ(*picture().content().picked, QPoint(settings.width / 2 + 1, settings.height / 2 + 1));
}

TEST_F(BugPanelTest, AltAndADigitShowAStageAndMarkNothing) {
    press(Qt::Key_5, Qt::AltModifier);
    EXPECT_EQ(looks(), 1u);
    for (int number = 0; number < lessons::kBoxes; ++number) EXPECT_NE(box(number).verdict(), "marked");
}

TEST_F(BugPanelTest, AStageThatIsAccusedWronglyIsShownToHaveDoneWhatItShould) {
    const int wrong = blamed() == 1 ? 2 : 1;
    press(Qt::Key(Qt::Key_0 + wrong));
    EXPECT_EQ(box(wrong).verdict(), "marked");
    press(Qt::Key_Return);
    EXPECT_EQ(box(wrong).state(), BugBox::State::Cleared);
    EXPECT_FALSE(box(wrong).isEnabled());
    EXPECT_TRUE(panel.round().text().contains("did what it should with what it got"))
        << panel.round().text().toStdString();
    EXPECT_EQ(panel.round().game()->points(), 80);
    EXPECT_EQ(panel.round().game()->phase(), Phase::Stage);
}

// A scene and an error that a teacher has chosen; the next picture is of the round again.
TEST_F(BugPanelTest, ATeacherSetsASceneAndAnErrorOfTheirOwn) {
    auto scene = std::make_shared<pipeline::Scene>(test::pyramid());
    scene->name = "my own scene";
    panel.setOpenScene([&] { return scene; });
    panel.findChild<QPushButton*>("bugOwn")->click();
    auto* dialog = panel.findChild<QDialog*>("bugOwnDialog");
    ASSERT_TRUE(dialog);
    auto* defects = dialog->findChild<QComboBox*>("bugOwnDefect");
    EXPECT_TRUE(dialog->findChild<QComboBox*>("bugOwnScene")->currentText().startsWith("my own scene"));
    defects->setCurrentIndex(defects->findData(int(pipeline::Defect::NormalFlip)));
    for (QAbstractButton* button : dialog->findChild<QDialogButtonBox*>()->buttons())
        if (button->text() == "Begin") button->click();
    ASSERT_TRUE(wait());
    EXPECT_EQ(panel.round().game()->row().id, pipeline::Defect::NormalFlip);
    EXPECT_EQ(panel.round().game()->wrong()->scene().settings.width, scene->settings.width);
    EXPECT_TRUE(panel.findChild<QLabel*>("bugWhat")->text().contains("my own scene"));
    EXPECT_EQ(rightCause() >= 0 && rightCause() < 5, true);
    panel.round().begin(kSeed);
    ASSERT_TRUE(wait());
    EXPECT_EQ(panel.round().game()->riddle().defect, lessons::makeRiddle(kSeed, 0)->defect);
}

// Nothing casts a shadow here: no bias, no error.
TEST_F(BugPanelTest, AnErrorThatChangesNothingIsRefused) {
    auto scene = std::make_shared<pipeline::Scene>(test::pyramid());
    scene->lights[0].castsShadow = false;
    panel.round().begin(scene, pipeline::Defect::NoBias);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !panel.round().busy(); }, 60000));
    EXPECT_FALSE(panel.round().game());
    EXPECT_TRUE(panel.findChild<QLabel*>("bugWhat")->text().contains("does not change"));
}

TEST_F(BugPanelTest, AHintCostsTenPoints) {
    press(Qt::Key_H);
    EXPECT_TRUE(panel.round().text().startsWith("What can be seen: "));
    EXPECT_EQ(panel.round().game()->points(), 90);
}

TEST_F(BugPanelTest, AWholeRoundIsPlayedByTheKeysAlone) {
    press(Qt::Key(Qt::Key_0 + blamed()));
    press(Qt::Key_Return);
    ASSERT_EQ(panel.round().game()->phase(), Phase::Cause);
    EXPECT_EQ(box(blamed()).state(), BugBox::State::Wrong);
    press(Qt::Key(Qt::Key_1 + (rightCause() + 1) % 5));
    press(Qt::Key_Return);
    ASSERT_EQ(panel.round().game()->phase(), Phase::Cause) << "another cause is not taken";
    EXPECT_EQ(panel.round().game()->points(), 80);
    press(Qt::Key(Qt::Key_1 + rightCause()));
    press(Qt::Key_Return);
    ASSERT_EQ(panel.round().game()->phase(), Phase::Over);
    const std::string fix(panel.round().game()->row().fix);
    EXPECT_TRUE(panel.round().text().contains(QString::fromStdString("Right: " + fix)));
    EXPECT_TRUE(picture().wipe().hasHandle) << "right beside wrong";
    press(Qt::Key_Right);
    EXPECT_DOUBLE_EQ(picture().wipe().share, 0.52);
    const pipeline::Defect before = panel.round().game()->row().id;
    press(Qt::Key_Return);
    EXPECT_EQ(panel.round().score().number, 1u);
    EXPECT_NE(panel.round().game()->row().id, before) << "none comes twice before all have come";
}

TEST_F(BugPanelTest, ItFitsASmallScreen) {
    EXPECT_LE(panel.minimumSizeHint().width(), 1024);
    EXPECT_LE(panel.minimumSizeHint().height(), 640);
}

}  // namespace
}  // namespace app
