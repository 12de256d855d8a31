#include "app/panels/compare_bar.h"

#include <gtest/gtest.h>

#include <QCoreApplication>

#include "app/core/theme.h"

namespace {

TEST(CompareBar, InALowViewItIsOneRow) {
    QWidget view;
    app::CompareBar bar(&view);
    bar.setFinding("They differ at 12 pixels.", {});
    view.show();
    bar.resize(200, 100);  // too narrow for the buttons beside the choices
    const auto heightIn = [&](int height) {
        bar.fit(height);
        QCoreApplication::processEvents();
        return bar.sizeHint().height();
    };
    const int all = heightIn(1000), low = heightIn(200);
    EXPECT_LT(low, all - app::Theme::current().px(20)) << "a row of words and buttons";
    EXPECT_LT(all, 3 * low) << "two rows, not three";
    EXPECT_EQ(heightIn(1000), all);
}

}  // namespace
