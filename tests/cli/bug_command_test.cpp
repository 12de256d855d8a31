#include <gtest/gtest.h>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"

namespace {

using test::has;
using test::run;

// Of stage 5 alone; every cause is tried, so that one is right whatever the seed.
TEST(Bug, IsPlayedFromTextsAlone) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "typed",
                    "help\nbuffers\nlook vertices.screen\nlook 320,240\nlook nonsense\nmark 1\nhint\nmark z-buffer\n"
                    "1\n2\n3\n4\n5\n");
    const auto played = test::runReading(folder / "typed", {"bug", "--seed", "7", "--pool", "z-buffer"});
    EXPECT_EQ(played.status, 0) << played.out << played.err;
    for (const char* part : {"Something is wrong", "  5 Z-buffer", "vertices.screen: ", "pixel 320, 240",
                             "\"nonsense\"", "Not Transform. This stage did what it should", "What can be seen: ",
                             "Yes: Z-buffer", "What is the cause?", "Wrong: ", "Right: ", " points: "})
        EXPECT_TRUE(has(played.out, part)) << part << " in\n" << played.out;
    EXPECT_EQ(played.out, test::runReading(folder / "typed", {"bug", "--seed", "7", "--pool", "z-buffer"}).out);
}

TEST(Bug, WhoGivesUpHasNotFoundIt) {
    const auto given = run({"bug", "--seed", "7"});  // nothing can be read
    EXPECT_EQ(given.status, 1);
    EXPECT_EQ(given.err, "");
    EXPECT_FALSE(has(given.out, "Right: "));
}

TEST(Bug, WritesAQuizWholeOrNotAtAll) {
    const test::TemporaryFolder folder;
    const auto written = run({"bug", "--seed", "2026", "--count", "1", "-o", folder / "quiz"});
    EXPECT_EQ(written.status, 0) << written.err;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"quiz", "quiz/quiz-answers.html", "quiz/quiz.html"}));
    EXPECT_TRUE(has(test::readText(folder / "quiz" / "quiz.html"), "Something is wrong in "));
    test::writeText(folder / "file", "");
    EXPECT_EQ(run({"bug", "--seed", "2026", "--count", "1", "-o", folder / "file"}).status, 4);
}

TEST(Bug, RefusesWhatItDoesNotKnow) {
    EXPECT_EQ(run({"bug", "--pool", "nowhere"}).status, 2);
    EXPECT_EQ(run({"bug", "--pool", "shadow-buffer"}).status, 2) << "no error of the game is in its own text";
    EXPECT_EQ(run({"bug", "--level", "Z"}).status, 2);
    EXPECT_EQ(run({"bug", "--count", "0"}).status, 2);
    EXPECT_EQ(run({"bug", "-o", ""}).status, 2);
    EXPECT_EQ(run({"bug", "--count", "99", "-o", "never"}).status, 2) << "more than there are";
}

}  // namespace
