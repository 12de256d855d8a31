// A lesson that asks a question of each kind, in the real panel.
#include <QAccessible>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>

#include "tests/app/panels/lesson_panel_fixture.h"

namespace app {
namespace {

// One question of each kind. What is asked needs no picture to be known: 2 + 3, and a pyramid of five polygons.
constexpr char kAsking[] = R"(title: Asking
lecture: L
summary: S
can: add two and three
next: pyramid
scene: pyramid

# A number
hides: normal
Two and three.
question: How much is 2 + 3?
answer: 2 + 3
mistake off-by-base: 2 * 3
  You multiplied.
hint: It is above {2 + 2}.
hint: Count on from 2: 3, 4 …
works: 2 + 3
right: Yes, 2 + 3 is {answer}.
points: 2

## then
buffers: normal
The sum is an **unmistakable** 5.

# A choice
Text.
question: Which is right?
choice off-by-base: Six. | if 1 = 2 | That is the product.
choice: Five. | if 2 + 3 = 5

# Several
Text.
question: Which are even?
several: Two | if mod(2, 2) = 0 | polygon 1
several: Three | if mod(3, 2) = 0
several: Four | if mod(4, 2) = 0

# A click
Text.
question: Which polygon has number 1?
click: polygon
answer: pick.polygon = 1

# Until
Text.
question: Make n at most 3.
until: setting(material.0.n) <= 3
free: material.0.n
answer: material.0.n = 3

# An order
Text.
question: Count upwards.
order: two | by 2
order: three | by 3
order: one | by 1
ends: least | most
mistake file-order: A, B, C
  As they stood.
)";

class AskingLesson : public LessonPanelTest {
protected:
    AskingLesson() {
        const pipeline::Scene pyramid = panel->shelf().find("pyramid")->pages.front().first.state.scene;
        auto lesson = lessons::parseLesson(
            kAsking, "lesson.md", [&](std::string_view) -> pipeline::Result<pipeline::Scene> { return pyramid; });
        EXPECT_TRUE(lesson) << format(lesson ? pipeline::Errors() : lesson.errors());
        lessons::Lesson own = std::move(lesson).value();
        own.name = "asking";
        EXPECT_TRUE(panel->openOwn(std::move(own)));
        EXPECT_TRUE(isFilled());
    }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QWidget* at = QApplication::focusWidget() ? QApplication::focusWidget() : panel.get();
        QTest::keyClick(at, key, modifiers);
    }
    // What a screen reader can reach in the panel: names, descriptions and values, those of invisible parts too.
    static QString everythingRead(QAccessibleInterface* part) {
        QString all;
        for (const auto kind : {QAccessible::Name, QAccessible::Description, QAccessible::Value, QAccessible::Help})
            all += part->text(kind) + '\n';
        if (auto* text = part->textInterface()) all += text->text(0, text->characterCount()) + '\n';
        for (int i = 0; i < part->childCount(); ++i)
            if (auto* child = part->child(i)) all += everythingRead(child);
        return all;
    }
    QString everythingRead() { return everythingRead(QAccessible::queryAccessibleInterface(panel.get())); }
};

TEST_F(AskingLesson, TheSecondHalfIsReadByNobodyBeforeTheAnswer) {
    const pipeline::BufferName normal{pipeline::BufferId::Normal};
    EXPECT_FALSE(everythingRead().contains("unmistakable"));
    EXPECT_EQ(panel->findChild<QWidget*>("lessonThen"), nullptr);
    EXPECT_TRUE(document.hidden().hides(normal));
    answer("5");
    EXPECT_TRUE(everythingRead().contains("unmistakable"));
    EXPECT_FALSE(document.hidden().hides(normal));
    panel->goTo(1);
    EXPECT_FALSE(everythingRead().contains("unmistakable")) << "nor on another page";
}

TEST_F(AskingLesson, AKnownMistakeHasItsNameAndSentenceAndCostsAQuarter) {
    answer("6");
    EXPECT_EQ(part<QWidget>("note").accessibleName(), "△ Known mistake: polygons counted for triangles");
    EXPECT_EQ(comment(), "You multiplied.");
    EXPECT_EQ(part<QLabel>("worth").text(), "Question · now worth 1.5 of 2 points");
    EXPECT_EQ(part<QLabel>("tries").text(), "2 tries left");
    EXPECT_EQ(part<QLineEdit>("answer").selectedText(), "6") << "the next number takes its place";
    answer("700");
    EXPECT_TRUE(part<QWidget>("note").accessibleName().startsWith("○"));
    EXPECT_TRUE(comment().contains("too large"));
    answer("words");  // no number: costs nothing
    EXPECT_EQ(part<QLabel>("tries").text(), "1 try left");
}

TEST_F(AskingLesson, ThreeTriesShowTheAnswerWithItsWorking) {
    for (const char* wrong : {"100", "200", "300"}) answer(wrong);
    EXPECT_TRUE(panel->run().isSettled());
    const QString shown = part<QTextBrowser>("solution").toPlainText();
    EXPECT_TRUE(shown.contains("5") && shown.contains("2 + 3") && shown.contains("Tried: 100")) << shown.toStdString();
    EXPECT_EQ(part<QLabel>("worth").text(), "Question · 0 of 2 points");
    EXPECT_TRUE(part<QPushButton>("nextPage").isEnabled());
}

TEST_F(AskingLesson, EnterChecksOnceAndTheSameValueCostsNothingAgain) {
    auto& field = part<QLineEdit>("answer");
    field.setFocus();
    field.setText("700");
    press(Qt::Key_Return);
    ASSERT_EQ(panel->run().attempt()->progress().tries.size(), 1u);
    EXPECT_EQ(part<QLabel>("tries").text(), "2 tries left");
    press(Qt::Key_Enter);
    EXPECT_EQ(panel->run().attempt()->progress().tries.size(), 1u);
    EXPECT_EQ(part<QLabel>("tries").text(), "2 tries left");
    EXPECT_TRUE(comment().startsWith("You tried this answer already.")) << comment().toStdString();
    field.setText("5");
    press(Qt::Key_Enter);
    EXPECT_EQ(panel->run().attempt()->progress().tries.size(), 2u);
    EXPECT_EQ(panel->run().attempt()->state(), lessons::Attempt::State::Right);
}

// From the first page to the last, and to the next lesson, without a mouse.
TEST_F(AskingLesson, TheKeyboardAloneGoesThroughTheLesson) {
    panel->findChild<QLineEdit*>("answer")->setFocus();
    press(Qt::Key_H, Qt::AltModifier);
    EXPECT_NE(panel->findChild<QTextBrowser*>("hint1"), nullptr);
    panel->findChild<QLineEdit*>("answer")->setFocus();
    press(Qt::Key_5);
    press(Qt::Key_Return);
    ASSERT_TRUE(panel->run().isSettled());
    press(Qt::Key_Return);  // Next has the focus
    ASSERT_EQ(panel->page(), 1);
    ASSERT_TRUE(isFilled());
    press(Qt::Key_1);
    press(Qt::Key_Return);
    EXPECT_FALSE(panel->run().isSettled() && panel->run().attempt()->state() == lessons::Attempt::State::Right);
    press(Qt::Key_Left, Qt::AltModifier);
    EXPECT_EQ(panel->page(), 0);
    press(Qt::Key_Right, Qt::AltModifier);
    ASSERT_EQ(panel->page(), 1);
    panel->goTo(2);
    ASSERT_TRUE(isFilled());
    press(Qt::Key_1);
    press(Qt::Key_3);
    press(Qt::Key_Return);
    EXPECT_TRUE(panel->run().isSettled());
    press(Qt::Key_Return);
    ASSERT_EQ(panel->page(), 3);
    ASSERT_TRUE(isFilled());
    auto& things = part<QComboBox>("things");
    things.setFocus();
    press(Qt::Key_Down);
    press(Qt::Key_Down);  // polygon 1
    press(Qt::Key_Return);
    EXPECT_TRUE(panel->run().isSettled());
    press(Qt::Key_Return);
    ASSERT_EQ(panel->page(), 4);
    ASSERT_TRUE(isFilled());
    press(Qt::Key_S, Qt::AltModifier);
    EXPECT_FALSE(panel->run().isSettled()) << "it asks once";
    press(Qt::Key_Space);
    EXPECT_TRUE(panel->run().isSettled());
    press(Qt::Key_Return);
    ASSERT_EQ(panel->page(), 5);
    ASSERT_TRUE(isFilled());
    auto& order = part<QListWidget>("order");
    order.setFocus();
    press(Qt::Key_3);
    press(Qt::Key_Up, Qt::AltModifier);
    press(Qt::Key_Up, Qt::AltModifier);
    EXPECT_EQ(order.item(0)->data(Qt::AccessibleTextRole), "one, 1 of 3");
    EXPECT_EQ(order.currentRow(), 0) << "the row keeps the selection";
    press(Qt::Key_Return);
    EXPECT_EQ(panel->run().attempt()->state(), lessons::Attempt::State::Right);
    press(Qt::Key_Return);
    ASSERT_TRUE(panel->run().isAtEnd());
    EXPECT_TRUE(part<QPushButton>("beginNext").hasFocus());
    press(Qt::Key_Return);
    EXPECT_EQ(panel->lesson()->name, "pyramid");
}

TEST_F(AskingLesson, AClickInAViewTogglesItsOption) {
    panel->goTo(2);
    ASSERT_TRUE(isFilled());
    document.pointing().select(lessons::Selection{lessons::Selection::Kind::Polygon, 1});
    EXPECT_TRUE(part<QAbstractButton>("option1").isChecked());
    panel->goTo(3);
    ASSERT_TRUE(isFilled());
    EXPECT_EQ(panel->banner(), "Click the polygon that answers the question.");
    document.pointing().select(lessons::Selection{lessons::Selection::Kind::Polygon, 1});
    EXPECT_EQ(part<QLabel>("picked").text(), "Your polygon: 1");
    click("check");
    EXPECT_TRUE(panel->run().isSettled());
}

TEST_F(AskingLesson, RowsAreMovedByTheMouse) {
    panel->goTo(5);
    ASSERT_TRUE(isFilled());
    auto& order = part<QListWidget>("order");
    EXPECT_TRUE(order.model()->moveRow({}, 2, {}, 0)) << "as a drop does";
    EXPECT_EQ(order.item(0)->text(), "1   one");
    EXPECT_EQ(order.item(2)->text(), "3   three");
    click("check");
    EXPECT_TRUE(panel->run().isSettled());
}

TEST_F(AskingLesson, UntilJudgesTheReadersOwnFrame) {
    panel->goTo(4);
    ASSERT_TRUE(isFilled());
    click("check");
    EXPECT_FALSE(panel->run().isSettled());
    QSignalSpy ready(&document.frames(), &FrameFeed::frameReady);
    document.change(*pipeline::findSetting(document.scene(), "material.0.n"), 2);
    ASSERT_TRUE(ready.wait());
    EXPECT_TRUE(part<QLabel>("gauge").text().startsWith("Now 2,")) << part<QLabel>("gauge").text().toStdString();
    click("check");
    EXPECT_TRUE(panel->run().isSettled());
}

TEST_F(AskingLesson, AClickerTurnsPagesThatHaveNoOpenQuestion) {
    EXPECT_FALSE(panel->run().turn(1)) << "the question is open";
    EXPECT_EQ(panel->page(), 0);
    answer("5");
    EXPECT_TRUE(panel->run().turn(1));
    EXPECT_EQ(panel->page(), 1);
    EXPECT_TRUE(panel->run().turn(-1));
    EXPECT_EQ(panel->page(), 0);
}

TEST_F(AskingLesson, ResultsAreKeptInOneFileAndForgotten) {
    answer("6");
    answer("5");
    EXPECT_TRUE(LessonResults::file().startsWith(settingsFolder.path()));
    {
        const auto kept = LessonResults().progress("asking", "A number");
        ASSERT_EQ(kept.tries.size(), 2u);
        EXPECT_EQ(kept.tries[0].given, "6");
        EXPECT_EQ(kept.tries[0].mistake, "off-by-base");
        EXPECT_EQ(kept.outcome, lessons::Progress::Outcome::Right);
    }
    panel->goTo(1);
    panel->goTo(0);
    ASSERT_TRUE(isFilled());
    EXPECT_TRUE(panel->run().isSettled()) << "it was answered before";
    EXPECT_TRUE(text().contains("Two and three"));
    panel->goTo(panel->run().pageCount());
    EXPECT_TRUE(part<QTextBrowser>("endPages").toPlainText().contains("△ 1 A number, 1.5 of 2"));
    EXPECT_TRUE(part<QTextBrowser>("endMistakes").toPlainText().contains("polygons counted for triangles (page 1)"));
    EXPECT_TRUE(part<QTextBrowser>("endCan").toPlainText().contains("add two and three"));
    panel->run().results().forget();
    EXPECT_TRUE(LessonResults().isEmpty());
    EXPECT_FALSE(QFile::exists(LessonResults::file()));
}

}  // namespace
}  // namespace app
