#include "app/look/accessible.h"

#include <gtest/gtest.h>

#include <QAccessible>
#include <QComboBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "app/canvas/buffer_canvas.h"
#include "app/inspector/gain_bar.h"
#include "app/inspector/math_view.h"
#include "app/widgets/segmented.h"
#include "app/widgets/value_slider.h"

namespace app {
namespace {

QAccessible::Role roleOf(QWidget& widget) { return QAccessible::queryAccessibleInterface(&widget)->role(); }

TEST(Spoken, ASliderHasItsNumberAndItsEnds) {
    ValueSlider slider(0, 4, 0);
    slider.setValue(1.5);
    QAccessibleInterface* spoken = QAccessible::queryAccessibleInterface(&slider);
    ASSERT_EQ(spoken->role(), QAccessible::Slider);
    QAccessibleValueInterface* number = spoken->valueInterface();
    ASSERT_NE(number, nullptr);
    EXPECT_EQ(number->currentValue().toDouble(), 1.5);
    EXPECT_EQ(number->minimumValue().toDouble(), 0);
    EXPECT_EQ(number->maximumValue().toDouble(), 4);
    EXPECT_EQ(spoken->text(QAccessible::Value), "1.5");
}

TEST(Spoken, AListToChooseFromIsNamedByALabel) {
    QWidget panel;
    QComboBox box(&panel);
    box.addItem("1×");
    nameComboBox(box, "Speed");
    const auto labels = QAccessible::queryAccessibleInterface(&box)->relations(QAccessible::Label);
    ASSERT_EQ(labels.size(), 1);
    EXPECT_EQ(labels[0].first->text(QAccessible::Name), "Speed");
    EXPECT_TRUE(qobject_cast<QWidget*>(labels[0].first->object())->isHidden()) << "for the reader alone";
}

TEST(Spoken, AScreenReaderSetsAValueAsAKeyDoes) {
    ValueSlider slider(0, 4, 0);
    QSignalSpy released(&slider, &ValueSlider::released);
    QAccessibleValueInterface* number = QAccessible::queryAccessibleInterface(&slider)->valueInterface();
    number->setCurrentValue(2.5);
    number->setCurrentValue(99);
    ASSERT_EQ(released.count(), 2);
    EXPECT_EQ(released[0][0].toDouble(), 2.5);
    EXPECT_EQ(released[1][0].toDouble(), 4) << "the end of its scale";

    GainBar gain;
    QSignalSpy moved(&gain, &GainBar::moved);
    QAccessible::queryAccessibleInterface(&gain)->valueInterface()->setCurrentValue(0.5);
    ASSERT_EQ(moved.count(), 1);
    EXPECT_EQ(moved[0][0].toDouble(), 0.5);
}

TEST(Spoken, WhatPaintsItselfIsNoEmptyFrame) {
    BufferCanvas canvas;
    EXPECT_EQ(roleOf(canvas), QAccessible::Graphic);
    MathView equation;
    EXPECT_EQ(roleOf(equation), QAccessible::Equation);
    Segmented choice({"flat", "phong"});
    EXPECT_EQ(roleOf(*choice.findChild<QPushButton*>()), QAccessible::RadioButton);
}

// The choice is where Tab stops, whichever was made first; the arrows go on from there.
TEST(Spoken, SeveralChoicesAreOneStopOfTab) {
    Segmented choice({"flat", "gouraud", "phong"});
    choice.setCurrent(1);
    const auto buttons = choice.findChildren<QPushButton*>();
    ASSERT_EQ(buttons.size(), 3);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(bool(buttons[i]->focusPolicy() & Qt::TabFocus), i == 1) << i;
    choice.setCurrent(2);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(bool(buttons[i]->focusPolicy() & Qt::TabFocus), i == 2) << i;
}

}  // namespace
}  // namespace app
