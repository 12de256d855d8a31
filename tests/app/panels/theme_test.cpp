#include "app/look/theme.h"

#include <gtest/gtest.h>

#include <QFontInfo>
#include <QPainter>
#include <QRegularExpression>
#include <algorithm>

#include "app/canvas/buffer_painter.h"
#include "app/look/style_sheet.h"
#include "tests/app/color_math.h"

using app::Theme;
using app::ThemeColors;
using app::ThemeId;
using test::contrast;
using test::Vision;

namespace {

constexpr ThemeId kThemes[]{ThemeId::Dark, ThemeId::Light, ThemeId::Projector};

struct ThemePerId : testing::TestWithParam<ThemeId> {
    const ThemeColors& c = Theme::colors(GetParam());
    bool isProjector = GetParam() == ThemeId::Projector;
};
INSTANTIATE_TEST_SUITE_P(Each, ThemePerId, testing::ValuesIn(kThemes), [](const auto& theme) {
    return std::string(theme.param == ThemeId::Dark ? "dark" : theme.param == ThemeId::Light ? "light" : "projector");
});

}  // namespace

// L* 0 and 100 without chroma; the mean L* is 50, where the weight S_L is 1: the difference is 100.
TEST(ColorMath, BlackAndWhiteDifferByAHundred) {
    EXPECT_NEAR(test::deltaE00(Qt::black, Qt::white, Vision::Normal), 100, 0.01);
    EXPECT_NEAR(contrast(Qt::black, Qt::white), 21, 1e-9);
}

// Else what was not drawn looks like the end of a palette: dark like S = 0, or white like S = 1.
TEST_P(ThemePerId, TheCheckerOfWhatWasNotDrawnIsSeenAsOne) {
    const ThemeId before = Theme::current().id();
    Theme::current().set(GetParam());
    QImage image(16, 16, QImage::Format_RGB32);
    QPainter painter(&image);
    app::paintChecker(painter, image.rect());
    Theme::current().set(before);
    for (const Vision vision : {Vision::Normal, Vision::Protan, Vision::Deutan, Vision::Tritan})
        EXPECT_GE(test::deltaE00(image.pixelColor(0, 0), image.pixelColor(8, 0), vision), 5);
}

TEST_P(ThemePerId, EveryTextIsReadableOnEveryGround) {
    const double least = isProjector ? 7 : 4.5;
    for (const QColor& ground : {c.bg, c.surface, c.raised, c.tint})
        for (const QColor& text : {c.text, c.text2, c.text3, c.accent, c.run, c.reused, c.leftOut, c.failed, c.warn})
            EXPECT_GE(contrast(text, ground), least)
                << text.name().toStdString() << " on " << ground.name().toStdString();
    EXPECT_GE(contrast(c.onFill, c.fill), least);
    for (const QColor& ground : {c.surface, c.raised}) EXPECT_GE(contrast(c.outline, ground), 3);
    for (const QColor& ground : {c.bg, c.surface, c.raised}) EXPECT_GE(contrast(c.focus, ground), 3);
}

TEST_P(ThemePerId, VectorLettersAreReadableWhereTheyStand) {
    for (const QColor& ground : {c.surface, c.view})
        for (const QColor& letter : {c.N, c.L, c.V, c.R, c.H})
            EXPECT_GE(contrast(letter, ground), isProjector ? 7 : 4.5)
                << letter.name().toStdString() << " on " << ground.name().toStdString();
}

// The design's table: the smallest difference among N, L, V, R and H for normal, protan, deutan and
// tritan vision.
TEST_P(ThemePerId, FiveVectorsStayApartInEveryVision) {
    const std::array<double, 4> promised = GetParam() == ThemeId::Dark    ? std::array{26.8, 21.6, 17.4, 17.4}
                                           : GetParam() == ThemeId::Light ? std::array{21.6, 16.5, 14.3, 14.8}
                                                                          : std::array{21.2, 11.9, 11.7, 14.7};
    const double limit = GetParam() == ThemeId::Dark ? 17 : GetParam() == ThemeId::Light ? 14 : 11.5;
    const std::array vectors{c.N, c.L, c.V, c.R, c.H};
    for (const Vision vision : {Vision::Normal, Vision::Protan, Vision::Deutan, Vision::Tritan}) {
        double smallest = 1000;
        for (std::size_t i = 0; i < vectors.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                smallest = std::min(smallest, test::deltaE00(vectors[i], vectors[j], vision));
        EXPECT_NEAR(smallest, promised[std::size_t(vision)], 0.1) << "vision " << int(vision);
        EXPECT_GE(smallest, limit) << "vision " << int(vision);
    }
}

TEST_P(ThemePerId, StyleSheetHasNoTokenLeft) {
    const QString sheet = app::styleSheet(c, [](double v) { return int(v); });
    EXPECT_FALSE(sheet.contains('@')) << sheet.toStdString();
    EXPECT_FALSE(sheet.contains(QRegularExpression("[0-9]u\\b")));
    EXPECT_FALSE(sheet.contains(QRegularExpression(":\\s*;")));
}

// The table of tokens prints contrasts with the surface; a token that was mistyped shows here.
TEST(Theme, TokensHaveTheContrastTheDesignPrints) {
    struct Row {
        QColor ThemeColors::*token;
        double dark, light, projector;
    };
    const Row rows[]{{&ThemeColors::outline, 3.75, 3.31, 6.08}, {&ThemeColors::text, 13.8, 16.6, 21.0},
                     {&ThemeColors::text2, 8.6, 7.5, 14.9},     {&ThemeColors::text3, 5.8, 5.5, 9.0},
                     {&ThemeColors::accent, 7.6, 6.3, 10.5},    {&ThemeColors::run, 8.9, 5.7, 9.3},
                     {&ThemeColors::reused, 7.6, 6.1, 10.7},    {&ThemeColors::leftOut, 5.8, 5.5, 9.0},
                     {&ThemeColors::failed, 7.0, 6.2, 10.0},    {&ThemeColors::warn, 9.9, 6.6, 10.5},
                     {&ThemeColors::focus, 9.3, 5.6, 10.5}};
    for (const Row& row : rows) {
        const auto against = [&](ThemeId id) {
            return contrast(Theme::colors(id).*row.token, Theme::colors(id).surface);
        };
        EXPECT_NEAR(against(ThemeId::Dark), row.dark, 0.06) << &row - rows;
        EXPECT_NEAR(against(ThemeId::Light), row.light, 0.06) << &row - rows;
        EXPECT_NEAR(against(ThemeId::Projector), row.projector, 0.06) << &row - rows;
    }
}

TEST(Theme, EachThemeKeepsItsOwnScaleAndTheProjectorStartsLarger) {
    Theme& theme = Theme::current();
    theme.set(ThemeId::Projector);
    EXPECT_DOUBLE_EQ(theme.scale(), 1.25);
    EXPECT_EQ(theme.px(24), 30);
    EXPECT_EQ(theme.text(13).pixelSize(), 16);  // round(16.25)
    theme.set(ThemeId::Dark);
    EXPECT_DOUBLE_EQ(theme.scale(), 1.0);
    theme.setScale(9);
    EXPECT_DOUBLE_EQ(theme.scale(), 4);
    theme.setScale(1.06);
    EXPECT_DOUBLE_EQ(theme.scale(), 1.05);
    theme.setScale(1);
    theme.set(ThemeId::Light);
}

TEST(Theme, MonoHasNoLigatures) {
    EXPECT_TRUE(Theme::current().mono().styleStrategy() & QFont::PreferNoShaping);
    EXPECT_EQ(Theme::current().mono().families().last(), "DejaVu Sans Mono");
    EXPECT_EQ(Theme::current().text().families().last(), "DejaVu Sans");
}
