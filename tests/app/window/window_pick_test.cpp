#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <algorithm>

#include "app/canvas/buffer_canvas.h"
#include "app/inspector/inspector_panel.h"
#include "app/look/theme.h"
#include "app/settings/scene_tree.h"
#include "app/tables/tables_panel.h"
#include "app/view3d/scene_view.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

using WindowPick = WindowTest;

TEST_F(WindowPick, ClickPicksThePixelAndArrowsMoveIt) {
    openPyramid();
    QTest::mouseClick(canvas(), Qt::LeftButton, Qt::NoModifier, onCanvas({330, 250}));
    ASSERT_EQ(document().pointing().pixel(), glm::ivec2(330, 250));
    QTest::keyClick(canvas(), Qt::Key_Right);
    QTest::keyClick(canvas(), Qt::Key_Down);
    EXPECT_EQ(document().pointing().pixel(), glm::ivec2(331, 251));
    QTest::keyClick(canvas(), Qt::Key_Left, Qt::ShiftModifier);
    EXPECT_EQ(document().pointing().pixel(), glm::ivec2(321, 251));
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

// So that digits stand below each other, and do not move when one changes.
TEST_F(WindowPick, NumbersHaveTheFaceForNumbersFromTheStart) {
    openPyramid();
    document().pointing().pick(glm::ivec2(268, 281));
    EXPECT_TRUE(waitForFrame());
    int found = 0;
    for (const QLabel* label : window.findChildren<QLabel*>()) {
        const bool isValue = label->text() == "37 93 167" || label->text().startsWith("x 268 y 281");
        if (!isValue || !label->isVisible()) continue;
        ++found;
        EXPECT_EQ(label->font().families(), Theme::current().mono().families()) << label->text().toStdString();
    }
    EXPECT_GE(found, 2) << "the inspector's, and that of a view";
}

TEST_F(WindowPick, ARowOfATableIsMarkedInEveryView) {
    window.resize(1600, 1060);  // room for the views beside the tables
    openPyramid();
    auto* dock = find<QDockWidget>("tables");
    EXPECT_FALSE(dock->isVisible());
    press("Ctrl+Alt+5");
    ASSERT_TRUE(dock->isVisible());
    auto* panel = find<TablesPanel>("tablesPanel");
    TablePage& page = panel->page(pipeline::TableId::Polygons);
    ASSERT_TRUE(QTest::qWaitFor([&] { return page.model().rowCount() == 5; }));
    const QPoint row = page.view().visualRect(page.model().index(1, 0)).center();
    QTest::mouseClick(page.view().viewport(), Qt::LeftButton, Qt::NoModifier, row);
    ASSERT_EQ(document().pointing().selection(), (lessons::Selection{lessons::Selection::Kind::Polygon, 1}));
    ASSERT_EQ(canvas()->content().marked.size(), 1u);
    EXPECT_EQ(canvas()->content().marked[0].size(), 3);
    // Vertex 1 of the pyramid stands at (226.67, 286.67) in the picture.
    EXPECT_NEAR(canvas()->content().marked[0][0].x(), 226.67, 0.01);
    EXPECT_NEAR(canvas()->content().marked[0][0].y(), 286.67, 0.01);
    ASSERT_TRUE(find<SceneView>("sceneView")->isVisible());
    const auto& content = find<SceneView>("sceneView")->space().content();
    EXPECT_EQ(content->markedLoop, (std::vector<std::uint32_t>{1, 2, 4}));
    QTest::mouseClick(canvas(), Qt::LeftButton, Qt::NoModifier, onCanvas({268, 281}));
    EXPECT_FALSE(document().pointing().selection());
    EXPECT_TRUE(canvas()->content().marked.empty());
}

TEST_F(WindowPick, ARowOfTheScenePanelIsSelectedInEveryViewWithoutAPickedPixel) {
    openPyramid();
    ASSERT_FALSE(document().pointing().pixel());
    EXPECT_FALSE(document().pointing().selection()) << "the material that is shown first selects nothing";
    auto* tree = find<SceneTree>("sceneTree");
    const auto click = [&](const QString& name) {
        const auto rows = tree->findItems(name, Qt::MatchExactly);
        ASSERT_EQ(rows.size(), 1) << name.toStdString();
        QTest::mouseClick(tree->viewport(), Qt::LeftButton, Qt::NoModifier, tree->visualItemRect(rows[0]).center());
    };
    using Kind = lessons::Selection::Kind;
    const auto selected = [&] { return document().pointing().selection(); };

    const QString name = QString::fromStdString(document().scene().objects[0].name);
    click(name);
    ASSERT_EQ(selected(), (lessons::Selection{Kind::Object, 0}));
    ASSERT_EQ(canvas()->content().marked.size(), 1u);
    const QRectF box = canvas()->content().marked[0].boundingRect();
    // Every pixel that the pyramid covers is in the box, and one of them touches each of its sides.
    int left = 1 << 20, top = 1 << 20, right = -1, bottom = -1;
    const auto& frame = document().frames().whole();
    const auto object = *frame->buffer({pipeline::BufferId::ObjectId});
    for (std::size_t y = 0; y < object.rows(); ++y)
        for (std::size_t x = 0; x < object.columns(); ++x)
            if (object.value(x, y) == 0) {
                left = std::min(left, int(x)), right = std::max(right, int(x));
                top = std::min(top, int(y)), bottom = std::max(bottom, int(y));
            }
    EXPECT_NEAR(box.left(), left, 1.5);
    EXPECT_NEAR(box.right(), right + 1, 1.5);
    EXPECT_NEAR(box.top(), top, 1.5);
    EXPECT_NEAR(box.bottom(), bottom + 1, 1.5);

    click("light 0");
    EXPECT_EQ(selected(), (lessons::Selection{Kind::Light, 0}));
    click(name);
    click("material 0");
    EXPECT_FALSE(selected()) << "no view can mark a material";
    EXPECT_TRUE(canvas()->content().marked.empty());

    click(name);
    QTest::mouseClick(canvas(), Qt::LeftButton, Qt::NoModifier, onCanvas({268, 281}));
    EXPECT_FALSE(selected());
    click(name);
    EXPECT_EQ(selected(), (lessons::Selection{Kind::Object, 0})) << "the row was the current one all the while";
    press("Ctrl+Shift+G");
    EXPECT_FALSE(selected());
    EXPECT_FALSE(document().pointing().pixel());
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
    EXPECT_FALSE(document().pointing().pixel());
    const auto hints = find<QWidget>("pixelField")->findChildren<QLabel*>();
    const auto hint =
        std::ranges::find_if(hints, [](const QLabel* label) { return label->text().contains("no such"); });
    ASSERT_NE(hint, hints.end());
    EXPECT_EQ((*hint)->text(), "There is no such pixel: x, y from 0, 0 to 639, 479.");
    EXPECT_GE((*hint)->height(), (*hint)->heightForWidth((*hint)->width())) << "none of it is cut off";
    field->selectAll();
    QTest::keyClicks(field, "268, 281");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_FALSE(field->isVisible());
    EXPECT_EQ(document().pointing().pixel(), glm::ivec2(268, 281));
}

TEST_F(WindowPick, HoverTellsThePixelInTheStatusBarAndChangesNothing) {
    openPyramid();
    QTest::mouseMove(canvas(), onCanvas({320, 240}));
    EXPECT_TRUE(QTest::qWaitFor([&] { return document().pointing().hovered() == glm::ivec2(320, 240); }));
    EXPECT_TRUE(find<QLabel>("statusHovered")->text().contains("320, 240"));
    EXPECT_FALSE(document().pointing().pixel());
}

}  // namespace
}  // namespace app
