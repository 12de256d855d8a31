#include "app/canvas/palette_bar.h"

#include <gtest/gtest.h>

// 9 of 9 999 pixels: on a linear axis under a thousandth of the height, on a logarithmic one log 10 / log 10 000 of it.
TEST(PaletteBarTest, CountsStandOnTheirAxis) {
    EXPECT_NEAR(app::barHeight(9, 9999, true), 0.25, 1e-12);
    EXPECT_NEAR(app::barHeight(9, 9999, false), 9 / 9999.0, 1e-12);
    for (const bool logarithmic : {true, false}) {
        EXPECT_EQ(app::barHeight(0, 9999, logarithmic), 0);
        EXPECT_EQ(app::barHeight(9999, 9999, logarithmic), 1);
        EXPECT_EQ(app::barHeight(0, 0, logarithmic), 0);
    }
    app::PaletteBar bar;
    bar.resize(240, 44);
    app::PaletteBar::Scale scale;
    scale.low = 0, scale.high = 10;
    scale.range = {0, 10};
    scale.histogram = {1204, 0, 7, 30};
    bar.setScale(scale);
    EXPECT_EQ(bar.axisText(), QString("1\u2009204")) << "the fullest bin";
    EXPECT_EQ(bar.accessibleName(), "Range of the palette: 0 to 10");
    scale.range = {10, 0};  // with what is more in light
    bar.setScale(scale);
    EXPECT_EQ(bar.accessibleName(), "Range of the palette: 0 to 10");
    EXPECT_EQ(bar.binText({230, 5}), "7.5 to 10.0: 30");
    EXPECT_TRUE(bar.binText({230, 40}).isEmpty()) << "there is the palette";
    bar.resize(60, 44);
    EXPECT_TRUE(bar.axisText().isEmpty()) << "no room";
}
