#include "lessons/games/drill.h"

#include <gtest/gtest.h>

#include <set>

namespace lessons {
namespace {

std::vector<DrillRound> drill(std::uint64_t seed, std::size_t rounds, const std::vector<std::string>& kinds = {}) {
    auto made = makeDrill(seed, rounds, kinds);
    EXPECT_TRUE(made) << format(made ? pipeline::Errors() : made.errors());
    return made ? std::move(made).value() : std::vector<DrillRound>();
}

// Counted anew from the buffers, with integers: 8 steps of 255 at one pixel in 200 that either picture draws.
TEST(Drill, EveryTwoPicturesOfARoundDifferVisiblyAndInOneSettingAlone) {
    for (const DrillRound& round : drill(3, 6)) {
        SCOPED_TRACE(round.scene + ' ' + round.setting.key());
        ASSERT_GE(round.pictures.size(), 2u);
        ASSERT_LE(round.pictures.size(), 3u);
        for (std::size_t i = 0; i < round.pictures.size(); ++i)
            for (std::size_t k = 0; k < i; ++k) {
                const pipeline::Frame &a = *round.pictures[i].frame, &b = *round.pictures[k].frame;
                pipeline::Scene same = a.scene();
                round.setting.set(same, round.setting.get(b.scene()));
                EXPECT_EQ(same, b.scene()) << "only this setting differs";
                EXPECT_NE(round.pictures[i].value, round.pictures[k].value);
                const auto colorA = a.buffer({pipeline::BufferId::Color}),
                           colorB = b.buffer({pipeline::BufferId::Color});
                const auto idA = a.buffer({pipeline::BufferId::PolygonId});
                const auto idB = b.buffer({pipeline::BufferId::PolygonId});
                std::size_t drawn = 0, seen = 0;
                for (std::size_t y = 0; y < colorA->rows(); ++y)
                    for (std::size_t x = 0; x < colorA->columns(); ++x) {
                        bool isSeen = false;
                        for (int c = 0; c < 3; ++c)
                            isSeen |= std::abs(colorA->value(x, y, c) - colorB->value(x, y, c)) >= 8;
                        const bool isDrawn = idA->value(x, y) >= 0 || idB->value(x, y) >= 0;
                        drawn += isDrawn, seen += isDrawn && isSeen;
                    }
                EXPECT_GE(200 * seen, drawn);
            }
        const auto value = [&](std::size_t i) {
            const auto color = round.pictures[i].frame->buffer({pipeline::BufferId::Color});
            std::array<double, 3> at{};
            for (int c = 0; c < 3; ++c)
                at[std::size_t(c)] = color->value(std::size_t(round.pixel.x), std::size_t(round.pixel.y), c);
            return at;
        };
        std::set<std::array<double, 3>> colors;
        for (std::size_t i = 0; i < round.pictures.size(); ++i) colors.insert(value(i));
        EXPECT_GE(colors.size(), 2u) << "the pixel gives something away";
    }
}

TEST(Drill, TheSameSeedGivesTheSameRoundsAndNoneTwice) {
    const auto a = drill(7, 5, {"shading", "cull"}), b = drill(7, 5, {"shading", "cull"});
    std::set<std::pair<std::string, std::string>> met;
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].scene, b[i].scene);
        EXPECT_EQ(a[i].pictures[0].value, b[i].pictures[0].value);
        EXPECT_TRUE(a[i].kind->name == "shading" || a[i].kind->name == "cull");
        EXPECT_TRUE(met.emplace(a[i].scene, a[i].kind->name).second) << a[i].scene;
    }
    EXPECT_EQ(drillPages(7, a).questions, drillPages(7, b).questions);
}

TEST(Drill, EveryKindHasARound) {
    for (const DrillKind& kind : drillKinds()) EXPECT_EQ(drill(1, 1, {std::string(kind.name)}).size(), 1u) << kind.name;
}

// The answers ring a pixel and name the values; the class's page does neither.
TEST(Drill, TheClassesPageTellsNothing) {
    const auto rounds = drill(3, 1, {"shading"});
    const DrillPages pages = drillPages(3, rounds);
    EXPECT_EQ(pages.questions.find("gives it away"), std::string::npos);
    EXPECT_EQ(pages.questions.find("A: " + rounds[0].pictures[0].value), std::string::npos);
    EXPECT_NE(pages.answers.find("A: " + rounds[0].pictures[0].value), std::string::npos);
    EXPECT_NE(pages.answers.find("class=equation"), std::string::npos);
    EXPECT_EQ(pages.answers.find("<script"), std::string::npos);
}

TEST(Drill, SaysWhatItCannotDoAndStops) {
    const auto unknown = makeDrill(1, 1, {"shadings"});
    ASSERT_FALSE(unknown);
    EXPECT_EQ(format(unknown.errors()), "no kind \"shadings\"; the nearest is \"shading\"\n");
    std::stop_source source;
    std::size_t told = 0;
    const auto stopped = makeDrill(1, 5, {}, source.get_token(), [&](std::size_t) {
        ++told;
        source.request_stop();
    });
    EXPECT_FALSE(stopped);
    EXPECT_EQ(told, 1u);
}

}  // namespace
}  // namespace lessons
