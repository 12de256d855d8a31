#include "lessons/prose.h"

#include "lessons/pages/talk_words.h"
#include "tests/lessons/html_of.h"
#include "tests/lessons/pyramid_scene.h"

namespace lessons {
namespace {

Prose proseFrom(std::string_view text, const pipeline::Scene& scene) {
    const Line line{text, {"f", 3, 1}};
    const auto prose = parseProse({&line, 1}, {scene});
    EXPECT_TRUE(prose) << text;
    return prose ? *prose : Prose{};
}

TEST(SetPieces, HaveTheSymbolsOfTheLecturesBelowAndRaised) {
    using Script = SetPiece::Script;
    using Pieces = std::vector<SetPiece>;
    EXPECT_EQ(setPieces("I = k_r I_max"), (Pieces{{"I = k"}, {"r", Script::Below}, {" I"}, {"max", Script::Below}}));
    EXPECT_EQ(setPieces("k_s c_l (R·e)^p, largest"), (Pieces{{"k"},
                                                             {"s", Script::Below},
                                                             {" c"},
                                                             {"l", Script::Below},
                                                             {" (R·e)"},
                                                             {"p", Script::Raised},
                                                             {", largest"}}));
    // Names of buffers, settings and files, and powers of two stay as they are written.
    for (const char* plain : {"z_view", "back_face_culling", "mask_r", "k_ambient", "2^32", ""}) {
        const Pieces whole = *plain ? Pieces{{plain}} : Pieces{};
        EXPECT_EQ(setPieces(plain), whole) << plain;
    }
}

TEST(ProseText, AFrameFillsTheHoles) {
    const pipeline::Scene scene = pyramidScene();
    const Prose prose = proseFrom("N·L is {buffer(n_dot_l.0, 268, 281) : 4}, I_max {pixel(268, 281).i_max}.", scene);
    const auto text = filled(prose, *frameOf(scene, buffersOf(prose)));
    ASSERT_TRUE(text);
    EXPECT_EQ(*text, "N·L is 0.7746, I_max 175.");
    EXPECT_EQ(withGaps(prose), "N·L is …, I_max ….");
}

TEST(ProseText, AHoleThatTheFrameCannotFillIsNamed) {
    const pipeline::Scene scene = pyramidScene();
    const Prose prose = proseFrom("It is {buffer(z_view, 0, 0)}.", scene);  // nothing is drawn there
    const auto text = filled(prose, *frameOf(scene, buffersOf(prose)));
    ASSERT_FALSE(text);
    EXPECT_EQ(format(text.errors()), "f:3:8: buffer(z_view, 0, 0) is +∞, expected a finite number\n");
}

// 120 kB of holes in one line: each is told its place from the one before it.
TEST(ProseText, TheLastOfManyHolesKnowsItsColumn) {
    const pipeline::Scene scene = pyramidScene();
    std::string text;
    for (int i = 0; i < 40'000; ++i) text += "{1}";
    const Prose prose = proseFrom(text + "\u00e4{2}", scene);
    ASSERT_EQ(prose.holes.size(), 40'001u);
    EXPECT_EQ(prose.holes.back().expression.root.where.column, 120'003);
    const auto whole = filled(prose, *frameOf(scene, pipeline::BufferSet()));
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->size(), 40'000u + 2 + 1);
}

// A lesson may come from anywhere; its handout runs nothing and asks no network.
TEST(ProseHtml, LeadsNowhereButAtAClick) {
    EXPECT_EQ(htmlOf("[a](javascript:alert(1)) ![of b](http://example.org/b.png)"), "<p><a>a</a> of b</p>\n");
    EXPECT_EQ(htmlOf("![b](//example.org/b.png)[c](data:text/html,x)"), "<p>b<a>c</a></p>\n");
    EXPECT_EQ(htmlOf("[a](https://example.org/) ![b](b.png)"), "<p><a href=\"https://example.org/\">a</a> b</p>\n");
}

TEST(ProseText, AnEscapedBraceIsABrace) {
    const pipeline::Scene scene = pyramidScene();
    EXPECT_EQ(withGaps(proseFrom("a \\{b} c", scene)), "a {b} c");
}

TEST(ProseText, ErrorsCountCharactersAndNotBytes) {
    const pipeline::Scene scene = pyramidScene();
    const Line lines[]{{"·· {bufer}", {"f", 3, 1}}, {"{1 : 20} {1", {"f", 4, 1}}};
    const auto prose = parseProse(lines, {scene});
    ASSERT_FALSE(prose);
    EXPECT_EQ(format(prose.errors()),
              "f:3:5: no function \"bufer\"; the nearest is \"buffer\"\n"
              "f:4:5: found \"20\", expected a number of digits from 0 to 12\n"
              "f:4:10: found \"{\" without its end, expected \"}\" in the same line\n");
}

}  // namespace
}  // namespace lessons
