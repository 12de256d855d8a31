#include <QLabel>
#include <QLineEdit>
#include <QTest>

#include "app/panels/buffer_canvas.h"
#include "app/panels/inspector_panel.h"
#include "tests/app/window_fixture.h"

namespace app {
namespace {

using WindowPick = WindowTest;

TEST_F(WindowPick, ClickPicksThePixelAndArrowsMoveIt) {
    openPyramid();
    QTest::mouseClick(canvas(), Qt::LeftButton, Qt::NoModifier, onCanvas({330, 250}));
    ASSERT_EQ(document().pixel(), glm::ivec2(330, 250));
    QTest::keyClick(canvas(), Qt::Key_Right);
    QTest::keyClick(canvas(), Qt::Key_Down);
    EXPECT_EQ(document().pixel(), glm::ivec2(331, 251));
    QTest::keyClick(canvas(), Qt::Key_Left, Qt::ShiftModifier);
    EXPECT_EQ(document().pixel(), glm::ivec2(321, 251));
}

TEST_F(WindowPick, InspectorFollowsThePickedPixel) {
    openPyramid();
    QTest::mouseClick(canvas(), Qt::LeftButton, Qt::NoModifier, onCanvas({330, 250}));
    auto* inspector = window.findChild<InspectorPanel*>();
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return inspector->report() && inspector->report()->pixel == glm::ivec2(330, 250); }));
    QTest::keyClick(canvas(), Qt::Key_Left);
    EXPECT_TRUE(QTest::qWaitFor([&] { return inspector->report()->pixel == glm::ivec2(329, 250); }));
    const auto& color = inspector->report()->color;
    EXPECT_EQ(QColor(color.r, color.g, color.b), frameColor({329, 250}));
}

TEST_F(WindowPick, GoToPixelTakesTwoNumbersInsideThePicture) {
    openPyramid();
    press("Ctrl+G");
    auto* field = find<QLineEdit>("pixelText");
    ASSERT_TRUE(field->isVisible());
    field->selectAll();
    QTest::keyClicks(field, "640, 10");  // one past the last column
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_TRUE(field->isVisible());
    EXPECT_FALSE(document().pixel());
    field->selectAll();
    QTest::keyClicks(field, "268, 281");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_FALSE(field->isVisible());
    EXPECT_EQ(document().pixel(), glm::ivec2(268, 281));
}

TEST_F(WindowPick, HoverTellsThePixelInTheStatusBarAndChangesNothing) {
    openPyramid();
    QTest::mouseMove(canvas(), onCanvas({320, 240}));
    EXPECT_TRUE(QTest::qWaitFor([&] { return document().hovered() == glm::ivec2(320, 240); }));
    EXPECT_TRUE(find<QLabel>("statusHovered")->text().contains("320, 240"));
    EXPECT_FALSE(document().pixel());
}

}  // namespace
}  // namespace app
