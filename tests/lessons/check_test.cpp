#include "lessons/check.h"

#include "tests/lessons/pyramid_scene.h"

namespace lessons {
namespace {

// What checkLesson says of a page of the pyramid that has help and no other fault; "…" behind the place and the words.
std::string faultsOf(std::string page, std::string_view then = "") {
    page += "hint: Look.\nworks: So it is.\n";
    const auto lesson =
        parseLesson("title: T\nlecture: L\nsummary: S\ncan: do it\nscene: pyramid\n# One\n" + page + std::string(then),
                    "lesson.md", [](std::string_view) -> pipeline::Result<pipeline::Scene> { return pyramidScene(); });
    if (!lesson) return "not read: " + format(lesson.errors());
    return format(checkLesson(*lesson));
}
void expectFault(const std::string& page, const std::string& fault) {
    EXPECT_EQ(faultsOf(page).substr(0, fault.size()), fault) << page << faultsOf(page);
}

// Row 310, N_z of Front 0.66896, two polygons dropped: lesson_data_test.cpp derives them.
TEST(CheckLesson, ALessonWithoutFaultHasNone) {
    EXPECT_EQ(
        faultsOf("Text.\nquestion: Row?\nanswer: floor(buffer(vertices.screen, 2, y))\nmistake y-up: 169\n  No.\n"),
        "");
}

TEST(CheckLesson, FindsWhatIsWrongWithAnswersAndMistakes) {
    expectFault("Text.\nquestion: Row?\nanswer: 310\nmistake y-up: 300 + 10\n  No.\n",
                "lesson.md:10:1: the mistake y-up is 310, which is a right answer");
    expectFault("Text.\nquestion: Row?\nanswer: 310\nmistake y-up: 5\n  No.\nmistake twice: 5\n  No.\n",
                "lesson.md:12:1: the mistakes y-up and twice are both 5");
    expectFault("Text.\nquestion: N?\nanswer: 2/3\n", "lesson.md:8:1: the answer 0.6666666666666666 has more digits");
    expectFault("Text.\nquestion: Q?\nanswer: 1/0\n", "lesson.md:9:9: 1/0 is +∞");
    expectFault("Text.\nquestion: Q?\nanswer: 5\nmistake y-up: buffer(z_view, 700, 1)\n  No.\n", "not read: ");
}

TEST(CheckLesson, FindsWhatIsWrongWithChoices) {
    expectFault("Text.\nquestion: Q?\nchoice: A | if 1 = 1\nchoice: B | if verdict(1) = kept\n",
                "lesson.md:8:1: 2 of 2 options hold, expected exactly one");
    expectFault("Text.\nquestion: Q?\nchoice: A | if 1 = 2\nchoice: B | if 1 = 3\n",
                "lesson.md:8:1: 0 of 2 options hold, expected exactly one");
    expectFault("Text.\nquestion: Q?\nchoice y-up: A | if 1 = 1\nchoice: B | if 1 = 2\n",
                "lesson.md:9:1: the option of the mistake y-up holds");
    expectFault("Text.\nquestion: Q?\nseveral: A | if 1 = 1\nseveral: B | if 1 = 1\n",
                "lesson.md:8:1: 2 of 2 options hold, expected one or more, not all");
}

TEST(CheckLesson, FindsWhatIsWrongWithClicksAndUntil) {
    expectFault("Text.\nquestion: Q?\nclick: polygon\nanswer: pick.polygon > 7\n",
                "lesson.md:8:1: no polygon is right");
    expectFault("Text.\nquestion: Q?\nclick: polygon\nanswer: pick.polygon >= 0\n",
                "lesson.md:8:1: every polygon is right");
    expectFault(
        "Text.\nquestion: Q?\nclick: polygon\nanswer: pick.polygon = 1\nmistake y-up: pick.polygon = 1\n  No.\n",
        "lesson.md:11:1: no wrong polygon is the mistake y-up");
    expectFault("Text.\nquestion: Q?\nclick: pixel\nnear: [700, 2] within 3 px\n",
                "lesson.md:8:1: the place (700, 2) is outside of the picture");
    expectFault("Text.\nquestion: Q?\nuntil: setting(material.0.n) < 9\nfree: material.0.n\nanswer: material.0.n = 4\n",
                "lesson.md:8:1: the condition holds from the beginning");
    expectFault("Text.\nquestion: Q?\nuntil: setting(material.0.n) < 5\nfree: material.0.n\nanswer: material.0.n = 6\n",
                "lesson.md:8:1: the condition does not hold with material.0.n=6");
}

// The handout of the lesson before this stood with 0.669 in a table above the question whose answer it is.
TEST(CheckLesson, FindsAnswersThatTheFirstHalfGivesAway) {
    const std::string row = "question: Row?\nanswer: floor(buffer(vertices.screen, 2, y))\n";
    expectFault("It is 310 here.\n" + row, "lesson.md:6:1: the first half gives the answer before it is asked for");
    expectFault("It is {300 + 10}.\n" + row, "lesson.md:7:8: the first half gives the answer before it is asked for");
    EXPECT_EQ(faultsOf("screen: Wait.\n\nNot 31 and not 3100.\n" + row), "");
    const std::string normal = "question: N?\nanswer: buffer(polygons.normal, 1, z)\ntolerance: 0.0006\n";
    expectFault("buffers: polygons.normal\n\nText.\n" + normal,
                "lesson.md:6:1: the table of polygons.normal gives the answer");
    expectFault("buffers: n_dot_l.0\n\nText.\nquestion: Q?\nanswer: buffer(n_dot_l.0, 240, 281)\ntolerance: 0.0006\n",
                "lesson.md:10:1: the view of n_dot_l.0 gives the answer");
    EXPECT_EQ(
        faultsOf("Text.\n" + normal, "## then\nbuffers: polygons.normal\n\nIt is {buffer(polygons.normal, 1, z)}.\n"),
        "");
    expectFault(
        "hides: polygons.verdict\n\nThere are {count(polygons.verdict = kept)}.\nquestion: How many?\nanswer: 3\n",
        "lesson.md:9:18: the text reads polygons.verdict, which this page hides");
    expectFault("hides: color\n\nText.\nquestion: How many?\nanswer: 3\n",
                "lesson.md:6:1: this page hides color and shows it");
}

TEST(CheckLesson, FindsPagesThatSpeakOfKeysOnPaper) {
    expectFault("Press Enter.\nquestion: Q?\nanswer: 1\n", "lesson.md:6:1: on paper this page says \"press \"");
    EXPECT_EQ(faultsOf("Text.\n\nscreen: Press Enter.\nquestion: Q?\nanswer: 1\n"), "");
    expectFault("Text.\nquestion: Click it.\nanswer: 1\n", "lesson.md:8:1: on paper this page says \"click\"");
    EXPECT_EQ(faultsOf("Text.\nquestion: Click it.\nanswer: 1\npaper: Which?\n"), "");
}

TEST(CheckLesson, EndsWhenItIsStopped) {
    const auto lesson =
        parseLesson("title: T\nlecture: L\nsummary: S\nscene: pyramid\n# One\nText.\n# Two\nText.\n# Three\nText.\n",
                    "l.md", [](std::string_view) -> pipeline::Result<pipeline::Scene> { return pyramidScene(); });
    std::stop_source source;
    std::size_t pages = 0;
    const pipeline::Errors errors = checkLesson(*lesson, source.get_token(), [&](std::size_t) {
        if (++pages == 2) source.request_stop();
    });
    EXPECT_EQ(format(errors), "stopped\n");
    EXPECT_EQ(pages, 2u);
}

}  // namespace
}  // namespace lessons
