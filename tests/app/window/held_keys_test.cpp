// A lesson whose picture is held, by keys alone: which of them go to the grip, and which to the question.
#include <QLineEdit>
#include <QTest>

#include "tests/app/window/held_lesson_fixture.h"

namespace app {
namespace {

// The page of "Light from everywhere" asks for a number: the sign goes to its field, as a digit does.
TEST_F(HeldLesson, APageOpensWithTheKeysOnWhatItHolds) {
    open("diffuse");
    EXPECT_TRUE(QTest::qWaitFor([&] { return QApplication::focusWidget() == &grip(); }, 5000));
    press("-");
    EXPECT_EQ(QApplication::focusWidget(), find<QLineEdit>("answer"));
    EXPECT_EQ(find<QLineEdit>("answer")->text(), "-");
}

// "Half of the light" holds nothing.
TEST_F(HeldLesson, APageThatHoldsNothingOpensWithTheKeysOnItsQuestion) {
    open("diffuse");
    ASSERT_TRUE(QTest::qWaitFor([&] { return qobject_cast<HoldGrip*>(QApplication::focusWidget()); }, 5000));
    run().goTo(1);
    ASSERT_TRUE(QTest::qWaitFor([&] { return run().texts().has_value(); }, 10000));
    ASSERT_TRUE(waitForFrame());
    EXPECT_TRUE(window.findChild<LessonPanel*>()->isAncestorOf(QApplication::focusWidget()));
}

TEST_F(HeldLesson, OnAGripTheLessonHasItsKeys) {
    open("diffuse");
    grip().setFocus();
    press("Alt+H");
    EXPECT_EQ(run().attempt()->hintsSeen(), 1u);
    grip().setFocus();
    press("1");  // goes to the field
    EXPECT_EQ(find<QLineEdit>("answer")->text(), "1");
    grip().setFocus();
    press("Return");
    EXPECT_EQ(run().attempt()->progress().tries.size(), 1u);
    grip().setFocus();
    press("Alt+S");
    press("Return");
    EXPECT_EQ(run().attempt()->state(), lessons::Attempt::State::Shown);
}

// One option of the question reads n_dot_l.0, which no step of the hand needs.
TEST_F(HeldLesson, AStepComputesNothingForTheQuestionAlone) {
    open("smooth");
    for (int i = 0; i < 2; ++i) {
        EXPECT_FALSE(document().frames().shown()->wanted()[index(pipeline::BufferId::NDotL)]);
        grip().setFocus();
        press("Right");
        ASSERT_TRUE(waitForFrame());
    }
}

// Where a click on the picture has been answered, the keys are there.
TEST_F(HeldLesson, EnterChecksWhereThePictureHasTheKeys) {
    open("reflection");
    QTest::mouseClick(canvas(), Qt::LeftButton, {}, onCanvas({320, 200}));
    canvas()->parentWidget()->setFocus();
    press("Return");
    EXPECT_TRUE(!run().attempt()->progress().tries.empty() || run().isSettled());
}

// Every question is answered or given up. Nothing but keys moves the focus.
TEST_F(HeldLesson, TheKeyboardAloneGoesThroughAWholeLesson) {
    open("highlight");
    int right = 0;
    const int pages = run().pageCount();
    for (int i = 0; i < pages; ++i) {
        ASSERT_EQ(run().page(), i);
        ASSERT_TRUE(QTest::qWaitFor([&] { return run().texts().has_value(); }, 30000));
        ASSERT_TRUE(waitForFrame());
        const lessons::Question& question = *run().current().question;
        if (std::holds_alternative<lessons::ChoiceQuestion>(question.kind))
            type(std::to_string(1 + holdingOptions(optionsOf(question), run().context())->front()));
        if (std::holds_alternative<lessons::NumberQuestion>(question.kind))
            type(firstWord(*answerText(question, run().context())));  // without "± 0.5"
        if (i == 1 || i == 2)
            pullInwardsUntilRight();
        else
            press("Return");
        right += run().isSettled();
        if (!run().isSettled()) press("Alt+S"), press("Return");
        ASSERT_TRUE(run().isSettled()) << run().current().heading;
        press("Return");  // Next has the keys
    }
    EXPECT_TRUE(run().isAtEnd());
    EXPECT_EQ(right, 8) << "all but a click and a slider: four choices, two rims, two numbers";
}

}  // namespace
}  // namespace app
