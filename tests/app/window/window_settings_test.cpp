#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTabBar>
#include <QTest>

#include "app/canvas/buffer_canvas.h"
#include "app/look/theme.h"
#include "app/settings/scene_tree.h"
#include "app/settings/settings_panel.h"
#include "app/widgets/number_field.h"
#include "app/widgets/segmented.h"
#include "app/widgets/value_slider.h"
#include "tests/app/quiet.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

class WindowSettings : public WindowTest {
protected:
    double value(const char* key) {
        const auto setting = findSetting(document().scene(), key);
        return setting ? setting->get(document().scene()) : NAN;
    }
    QImage color() {
        const auto buffer = *document().frames().shown()->buffer({pipeline::BufferId::Color});
        const auto& bytes = std::get<std::span<const std::uint8_t>>(buffer.data);
        return QImage(bytes.data(), int(buffer.columns()), int(buffer.rows()), 3 * qsizetype(buffer.columns()),
                      QImage::Format_RGB888)
            .copy();
    }
    void select(const char* item) {
        auto* tree = find<SceneTree>("sceneTree");
        for (int row = 0; row < tree->count(); ++row)
            if (tree->item(row)->text() == item)
                QTest::mouseClick(tree->viewport(), Qt::LeftButton, Qt::NoModifier,
                                  tree->visualItemRect(tree->item(row)).center());
        EXPECT_TRUE(test::waitUntilQuiet());  // the other controls are built
    }
};

TEST_F(WindowSettings, DraggedSliderShowsFramesWhileItMovesAndIsOneStepOfUndo) {
    openPyramid();
    const QImage before = color();
    const double valueBefore = value("material.0.kr");
    auto* slider = find<ValueSlider>("material.0.kr");
    QSignalSpy frames(&document().frames(), &FrameFeed::frameReady);

    QTest::mousePress(slider, Qt::LeftButton, Qt::NoModifier, slider->position(0.3).toPoint());
    QImage last = before;
    for (const double to : {0.5, 0.7, 0.9}) {
        QTest::mouseMove(slider, slider->position(to).toPoint());
        const auto count = frames.count();
        ASSERT_TRUE(QTest::qWaitFor([&] { return frames.count() > count || !document().frames().busy(); }, 10000));
        ASSERT_TRUE(waitForFrame());
        EXPECT_NE(color(), last) << "no new picture at " << to << " while the button is still down";
        last = color();
    }
    QTest::mouseRelease(slider, Qt::LeftButton, Qt::NoModifier, slider->position(0.9).toPoint());
    ASSERT_TRUE(waitForFrame());

    EXPECT_NEAR(value("material.0.kr"), 0.9, 0.02);
    EXPECT_EQ(document().history().stack()->count(), 1);
    EXPECT_TRUE(document().history().stack()->undoText().startsWith("k_r red 0.2 → 0.9"));
    press("Ctrl+Z");
    ASSERT_TRUE(waitForFrame());
    EXPECT_EQ(value("material.0.kr"), valueBefore);
    EXPECT_EQ(color(), before);
    press("Ctrl+Shift+Z");
    ASSERT_TRUE(waitForFrame());
    EXPECT_EQ(color(), last);
}

TEST_F(WindowSettings, NumbersAreNotCutInLargeLetters) {
    openPyramid();
    auto* panel = window.findChild<SettingsPanel*>();
    auto* scroll = panel->findChild<QScrollArea*>();
    for (const double scale : {1.0, 1.4, 2.0})
        for (const QSize size : {QSize(1280, 720), QSize(1920, 1080)}) {
            Theme::current().setScale(scale);
            window.resize(size);
            for (auto* dock : window.findChildren<QDockWidget*>())
                if (dock->objectName() == "settings" && dock->isHidden()) dock->toggleViewAction()->trigger();
            EXPECT_TRUE(test::waitUntilQuiet());
            auto* tabs = panel->findChild<QTabBar*>();
            for (int tab = tabs->count() - 1; tab >= 0; --tab) {
                tabs->setCurrentIndex(tab);
                EXPECT_TRUE(test::waitUntilQuiet());
                EXPECT_LE(scroll->widget()->width(), scroll->viewport()->width())
                    << "tab " << tab << " at " << scale << ", " << size.width();
            }
        }
    Theme::current().setScale(1);
}

// 200 pixels are the slider's range, 0 to 1; k_r begins at 0.2.
TEST_F(WindowSettings, ANumberIsDraggedSidewaysInOneStepOfUndo) {
    openPyramid();
    auto* field = find<NumberField>("material.0.kr");
    canvas()->setFocus();
    const QPoint from = field->rect().center();
    QTest::mousePress(field, Qt::LeftButton, Qt::NoModifier, from);
    QTest::mouseMove(field, from + QPoint(20, 0));
    QTest::mouseMove(field, from + QPoint(40, 0));
    EXPECT_DOUBLE_EQ(value("material.0.kr"), 0.4);
    QTest::mouseRelease(field, Qt::LeftButton, Qt::NoModifier, from + QPoint(40, 0));
    EXPECT_FALSE(field->hasFocus());
    EXPECT_EQ(document().history().stack()->count(), 1);
    press("Ctrl+Z");
    EXPECT_DOUBLE_EQ(value("material.0.kr"), 0.2);
    QTest::mouseClick(field, Qt::LeftButton, Qt::NoModifier, from);
    EXPECT_TRUE(field->hasFocus()) << "a click is for typing";
    EXPECT_EQ(document().history().stack()->index(), 0);
}

TEST_F(WindowSettings, LightIsChangedByANumberAndThePictureOnTheScreenFollows) {
    openPyramid();
    const glm::ivec2 pixel(268, 281);  // on the right face
    const QColor before = shownColor(canvas()->grab().toImage(), pixel);
    EXPECT_EQ(before, frameColor(pixel));
    select("light 0");
    auto* field = window.findChild<NumberField*>("light.0.x");
    ASSERT_NE(field, nullptr);
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, "-5");
    QTest::keyClick(field, Qt::Key_Return);
    ASSERT_TRUE(waitForFrame());
    EXPECT_EQ(value("light.0.x"), -5);
    const QColor after = shownColor(canvas()->grab().toImage(), pixel);
    EXPECT_NE(after, before);
    EXPECT_EQ(after, frameColor(pixel));
}

TEST_F(WindowSettings, WrongNumberIsRefusedWhereItStands) {
    openPyramid();
    auto* field = window.findChild<NumberField*>("material.0.n");
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, "-1");  // a highlight of exponent -1 would have no bound
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_EQ(value("material.0.n"), 8);
    EXPECT_FALSE(field->toolTip().isEmpty());
    QTest::keyClick(field, Qt::Key_Escape);
    EXPECT_EQ(field->text(), "8");
}

// A field's own Ctrl+Z would have nothing to undo there, and keep the key from the window.
TEST_F(WindowSettings, WhatWasEnteredInAFieldIsUndoneWhileItHasTheFocus) {
    openPyramid();
    auto* field = window.findChild<NumberField*>("material.0.n");
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, "20");
    QTest::keyClick(field, Qt::Key_Return);
    ASSERT_EQ(value("material.0.n"), 20);
    QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(value("material.0.n"), 8);
    EXPECT_EQ(field->text(), "8");
    QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(value("material.0.n"), 20);
    // What is being typed is the field's.
    field->selectAll();
    QTest::keyClicks(field, "30");
    QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(value("material.0.n"), 20);
    EXPECT_NE(field->text(), "30");
}

TEST_F(WindowSettings, PutBackUndoesTheLastChange) {
    openPyramid();
    auto* field = window.findChild<NumberField*>("material.0.n");
    field->setFocus();
    QTest::keyClick(field, Qt::Key_Up);
    EXPECT_EQ(value("material.0.n"), 9);
    auto* note = find<QLabel>("lastChange");
    ASSERT_TRUE(note->isVisible());
    EXPECT_TRUE(note->text().contains("was 8."));
    emit note->linkActivated("undo");
    EXPECT_EQ(value("material.0.n"), 8);
    EXPECT_FALSE(note->isVisible());
}

}  // namespace
}  // namespace app
