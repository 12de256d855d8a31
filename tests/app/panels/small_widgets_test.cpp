// Labels, sliders and the words over a buffer, each by itself.
#include <gtest/gtest.h>

#include <QApplication>
#include <QHelpEvent>
#include <QInputDialog>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>

#include "app/canvas/palette_bar.h"
#include "app/canvas/shown_buffer.h"
#include "app/widgets/elided_label.h"
#include "app/widgets/value_slider.h"
#include "pipeline/run/runner.h"
#include "tests/support/scenes.h"

namespace {

TEST(ElidedLabel, ItsToolTipIsTheTextThatItHasNow) {
    app::ElidedLabel label;
    label.resize(60, 20);
    label.setText("more words than there is room for");
    const auto asked = [&] {
        QHelpEvent event(QEvent::ToolTip, {5, 5}, label.mapToGlobal(QPoint(5, 5)));
        QApplication::sendEvent(&label, &event);
        return label.toolTip();
    };
    EXPECT_EQ(asked(), "more words than there is room for");
    label.setText("and more of them, quite other ones");
    EXPECT_EQ(asked(), "and more of them, quite other ones");
    label.setText("few");
    EXPECT_EQ(asked(), "");
}

TEST(ValueSlider, SidewaysTheWheelChangesNothing) {
    app::ValueSlider slider(0, 10, 1);
    slider.setValue(5);
    slider.resize(200, 30);
    slider.show();
    QApplication::setActiveWindow(&slider);
    slider.setFocus();
    ASSERT_TRUE(slider.hasFocus());
    std::vector<double> steps;
    QObject::connect(&slider, &app::ValueSlider::released, [&](double value) { steps.push_back(value); });
    const auto turn = [&](QPoint by) {
        QWheelEvent event({50, 10}, slider.mapToGlobal(QPointF(50, 10)), {}, by, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&slider, &event);
    };
    turn({120, 0}), turn({-120, 0});
    EXPECT_TRUE(steps.empty());
    turn({0, 120});
    EXPECT_EQ(steps, std::vector<double>{6});
}

TEST(PaletteBarInput, AnEndIsTypedWithAllItsDigits) {
    app::PaletteBar bar;
    bar.resize(240, 44);
    bar.show();
    app::PaletteBar::Scale scale;
    scale.low = 0, scale.high = 1e-7;
    scale.range = {0, 3e-8};
    scale.histogram = {1, 2, 3};
    bar.setScale(scale);
    std::optional<pipeline::PaletteRange> range;
    QObject::connect(&bar, &app::PaletteBar::rangeChosen, [&](pipeline::PaletteRange chosen) { range = chosen; });
    QString offered;
    const auto type = [&](const QString& typed) {
        range.reset();
        QTimer::singleShot(0, &bar, [&] {
            auto* dialog = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
            ASSERT_NE(dialog, nullptr);
            offered = dialog->textValue();
            if (!typed.isEmpty()) dialog->setTextValue(typed);
            dialog->accept();
        });
        QTest::mouseDClick(&bar, Qt::LeftButton, {}, {230, 36});
    };
    type({});
    EXPECT_EQ(offered, "3e-8");
    ASSERT_TRUE(range);
    EXPECT_EQ(range->last, 3e-8) << "as it stood there";
    type("4e-8");
    ASSERT_TRUE(range);
    EXPECT_EQ(range->last, 4e-8);
}

// Beside each other: 5 infinite of one sign and 2 of the other, with 1 NaN between.
TEST(ShownBuffer, CountsEveryInfinity) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const auto scene = std::make_shared<const pipeline::Scene>(test::pyramid());
    const auto frame =
        pipeline::runFrame(scene, {.wanted = pipeline::setOf({pipeline::BufferId::Depth}), .stop = {}}, nullptr);
    const auto numbers = std::make_shared<std::vector<float>>(
        std::vector{1.f, kInfinity, kInfinity, kInfinity, kInfinity, kInfinity, NAN, -kInfinity, -kInfinity, 2.f});
    pipeline::AnyBuffer buffer = *frame->buffer({pipeline::BufferId::Depth});
    buffer.shape = {2, 5};
    buffer.data = std::span<const float>(*numbers);
    buffer.owner = numbers;
    const auto shown = app::showBuffer(*frame, buffer, {}, lessons::ShownChannel::All, {});
    EXPECT_EQ(shown.notice, "2 distinct values, 1 NaN, 7 infinite");
}

}  // namespace
