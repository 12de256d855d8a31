#include "pipeline/buffers/palette.h"

#include <gtest/gtest.h>

#include <limits>

#include "pipeline/stages/cull.h"

namespace pipeline {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string hex(Color8 c) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02X%02X%02X", c.r, c.g, c.b);
    return text;
}

TEST(Palette, ScalesBeginAndEndWithTheirStops) {
    EXPECT_EQ(hex(paletteColor(Palette::Sequential, 10, 10, 20)), "#FFF3C4");
    EXPECT_EQ(hex(paletteColor(Palette::Sequential, 15, 10, 20)), "#B75A70");  // the fifth of nine stops
    EXPECT_EQ(hex(paletteColor(Palette::Sequential, 20, 10, 20)), "#141B3C");
    EXPECT_EQ(hex(paletteColor(Palette::Sequential, 99, 10, 20)), "#141B3C");  // clamped
    EXPECT_EQ(hex(paletteColor(Palette::Sequential, 10, 20, 10)), "#141B3C");  // turned around
    EXPECT_EQ(hex(paletteColor(Palette::Sequential, 5, 5, 5)), "#FFF3C4");     // a range without length
    EXPECT_EQ(hex(paletteColor(Palette::Diverging, 0, -3, 3)), "#F1EFEA");
    EXPECT_EQ(hex(paletteColor(Palette::Diverging, -3, -3, 3)), "#0B3C6F");
    EXPECT_EQ(hex(paletteColor(Palette::Diverging, 3, -3, 3)), "#7A3209");
    // Half-way between #FFF3C4 and #FBD08A: (253, 225.5, 167).
    EXPECT_EQ(hex(paletteColor(Palette::Sequential, 0.5, 0, 8)), "#FDE2A7");
}

TEST(Palette, CategoriesRepeatAfterEight) {
    EXPECT_EQ(paletteColor(Palette::Categorical, 3, 0, 0), paletteColor(Palette::Categorical, 11, 0, 0));
    EXPECT_EQ(hex(paletteColor(Palette::Categorical, 0, 0, 0)), "#80B6CE");
    EXPECT_EQ(hex(paletteColor(Palette::Categorical, -1, 0, 0)), "#FFFFFF");
}

TEST(Palette, VerdictsTakeTheColourOfTheirLetter) {
    const auto color = [](Verdict v) { return hex(paletteColor(Palette::Verdict, double(v), 0, 0)); };
    EXPECT_EQ(color(Verdict::Kept), "#5E9A98");
    EXPECT_EQ(color(Verdict::BackFacing), "#C18D62");
    EXPECT_EQ(color(Verdict::Degenerate), "#927DEB");
    EXPECT_EQ(color(Verdict::OutsideLeft), "#C7D3FA");
    EXPECT_EQ(color(Verdict::OutsideFar), "#C7D3FA");
    EXPECT_EQ(color(Verdict::Clipped), "#EEDE5C");
    EXPECT_EQ(color(Verdict::Transparent), "#F6B7CF");
}

TEST(Palette, WhatIsNotFiniteIsSeen) {
    for (const Palette palette : {Palette::Sequential, Palette::Diverging, Palette::Categorical, Palette::Verdict,
                                  Palette::Direction, Palette::Color}) {
        EXPECT_EQ(hex(paletteColor(palette, std::numeric_limits<double>::quiet_NaN(), 0, 1)), "#FF00C8");
        EXPECT_EQ(hex(paletteColor(palette, kInfinity, 0, 1)), "#FFFFFF");
        EXPECT_EQ(hex(paletteColor(palette, -kInfinity, 0, 1)), "#000000");
    }
}

TEST(FittingRange, PutsTheLightEndWhereTheTableSays) {
    const auto range = [](BufferId id, double min, double max, DepthFormat format = DepthFormat::Linear) {
        AnyBuffer buffer;
        buffer.info = &bufferInfo(id);
        BufferStatistics found;
        found.min = min;
        found.max = max;
        return fittingRange(buffer, found, format);
    };
    EXPECT_EQ(range(BufferId::ZView, 600, 800), (PaletteRange{600, 800}));
    EXPECT_EQ(range(BufferId::Depth, 0, 1, DepthFormat::Float), (PaletteRange{0, 1}));
    EXPECT_EQ(range(BufferId::Depth, 0, 1, DepthFormat::Reversed), (PaletteRange{1, 0}));
    EXPECT_EQ(range(BufferId::ZView, 600, 800, DepthFormat::Reversed), (PaletteRange{600, 800}));
    EXPECT_EQ(range(BufferId::Overdraw, 0, 7), (PaletteRange{7, 0}));
    EXPECT_EQ(range(BufferId::Shadow, 1, 1), (PaletteRange{1, 0}));
    EXPECT_EQ(range(BufferId::NDotL, -0.25, 0.5), (PaletteRange{-0.5, 0.5}));
    EXPECT_EQ(range(BufferId::Normal, 0, 0.5), (PaletteRange{-1, 1}));
    EXPECT_EQ(range(BufferId::Position, -20, 30), (PaletteRange{-20, 30}));
    EXPECT_EQ(range(BufferId::Color, 3, 90), (PaletteRange{0, 255}));
    EXPECT_EQ(range(BufferId::Intensity, 3, 90), (PaletteRange{0, 90}));
}

TEST(ElementColor, ShowsColoursAsTheyAreAndNormalsAroundGrey) {
    const std::vector<std::uint8_t> bytes{1, 2, 3, 200, 100, 255};
    AnyBuffer color{
        {BufferId::Color}, &bufferInfo(BufferId::Color), {1, 2, 3}, std::span<const std::uint8_t>(bytes), {}};
    EXPECT_EQ(elementColor(color, 1, 0, {0, 255}), Color8(200, 100, 255));
    const std::vector<float> up{0, 0, 1};
    AnyBuffer normal{{BufferId::Normal}, &bufferInfo(BufferId::Normal), {1, 1, 3}, std::span<const float>(up), {}};
    EXPECT_EQ(elementColor(normal, 0, 0, {-1, 1}), Color8(128, 128, 255));  // 127.5 rounds up
}

}  // namespace
}  // namespace pipeline
