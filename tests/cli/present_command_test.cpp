// Checking a cue list without the window.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"

namespace {

using test::run;

TEST(PresentCheck, BothLecturesAreRight) {
    for (const auto& [lecture, questions] : {std::pair("lecture1.cues", 8), std::pair("lecture2.cues", 7)}) {
        const auto done = run({"present", "--check", std::string(SHADESCOPE_SCENES) + "/../manual/" + lecture});
        EXPECT_EQ(done.status, 0) << done.err;
        const std::string found = " " + std::to_string(questions) + " questions are right.";
        EXPECT_NE(done.out.find(found), std::string::npos) << done.out;
    }
}

TEST(PresentCheck, WhatDoesNotFitIsToldWithItsCue) {
    const test::TemporaryFolder folder;
    const std::string file = (folder / "talk.cues").string();
    test::writeText(
        file,
        "[[cue]]\nname = \"One\"\nscene = \"pyramid\"\npixel = [700, 0]\n"
        "sliders = [\"light.0.intensity\", \"light.7.intensity\"]\n"
        "[[cue]]\nname = \"Two\"\nscene = \"no_such_scene\"\n"
        "[[cue]]\nname = \"Three\"\nscene = \"pyramid\"\nask = \"Q\"\nchoices = [\"a\", \"b\"]\nright = \"A\"\n");
    const auto done = run({"present", "--check", file});
    EXPECT_EQ(done.status, 3);
    EXPECT_NE(done.err.find("cue \"One\": "), std::string::npos) << done.err;
    EXPECT_NE(done.err.find(":5:33: cue \"One\": "), std::string::npos) << "the second slider" << done.err;
    EXPECT_NE(done.err.find("cue \"Two\": "), std::string::npos) << done.err;
    EXPECT_NE(
        done.err.find(file + ": cue \"Three\": asks and is the last cue, expected a cue after it, which is the answer"),
        std::string::npos)
        << done.err;
    EXPECT_EQ(run({"present", "--check", (folder / "none.cues").string()}).status, 3);
    EXPECT_EQ(run({"present", "--check"}).status, 2);
}

// Beside a question, and beside its answer, the choices have the place of the algorithm.
TEST(PresentCheck, AnAlgorithmThatChoicesHideIsToldAndIsNoError) {
    const test::TemporaryFolder folder;
    const std::string file = (folder / "talk.cues").string();
    const std::string steps = "scene = \"pyramid\"\nplace = \"z-buffer/polygon=2\"\nalgorithm = true\n";
    test::writeText(
        file,
        "[[cue]]\nname = \"Asks\"\nscene = \"pyramid\"\nask = \"Q\"\nchoices = [\"a\", \"b\"]\nright = \"A\"\n"
        "[[cue]]\nname = \"Answers\"\n" +
            steps + "[[cue]]\nname = \"Steps\"\n" + steps);
    const auto done = run({"present", "--check", file});
    EXPECT_EQ(done.status, 0) << done.err;
    const std::string sentence = ": the algorithm stays hidden; the choices are in its place.";
    EXPECT_NE(done.out.find("cue \"Answers\"" + sentence), std::string::npos) << done.out;
    EXPECT_EQ(done.out.find("cue \"Steps\"" + sentence), std::string::npos) << done.out;
}

}  // namespace
