// Files that somebody else has written are kept: what a command has read always, other ones unless --force is given.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <filesystem>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"

namespace {

namespace fs = std::filesystem;
using test::has;
using test::run;

constexpr const char* kMine =
    "# my own comment\ntitle = \"mine\"\nwidth = 64 # small\nheight = 48\n[camera]\nkind = \"look-at\"\neye = "
    "[0,-3,1]\n"
    "[[light]]\nposition = [0,-1,1]\nintensity = 100\n[[object]]\nshape = \"box\"\n";

TEST(KeptFiles, WhatACommandHasReadIsNeverReplaced) {
    const test::TemporaryFolder folder;
    const std::string mine = folder / "mine.toml", at = folder.path().string();
    test::writeText(mine, kMine);
    for (const std::vector<std::string>& command :
         std::vector<std::vector<std::string>>{{"export", mine, "--format", "scene", "-o", at},
                                               {"export", mine, "--format", "scene", "-o", at, "--force"},
                                               {"export", mine, "--format", "npy,scene", "-o",
                                                (folder.path() / "../" / folder.path().filename()).string()},
                                               {"figure", mine, "--format", "svg", "-o", mine},
                                               {"compare", mine, at, "-o", mine}}) {
        const auto done = run(command);
        EXPECT_EQ(done.status, 4) << command[0];
        EXPECT_TRUE(has(done.err, "mine.toml: this file was read, so it is not replaced")) << done.err;
    }
    EXPECT_EQ(test::readText(mine), kMine);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"mine.toml"});
    // Beside it there is room.
    EXPECT_EQ(run({"export", mine, "--format", "npy", "--buffers", "depth", "-o", at}).status, 0);
}

// Each command, and a file of those that it would write. They are refused before anything is computed.
TEST(KeptFiles, WhatTheProgramDidNotWriteNeedsForce) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "anna.json", "{}");
    const std::string at = folder / "out";
    fs::create_directory(at);
    for (const auto& [name, command] : std::vector<std::pair<std::string, std::vector<std::string>>>{
             {"pyramid.toml", {"export", "pyramid", "--format", "scene"}},
             {"color.png", {"export", "pyramid", "--size", "16x12"}},
             {"step_0001.png", {"film", "pyramid", "--size", "16x12"}},
             {"report.html", {"study", "pyramid", "--sweep", "shading"}},
             {"pyramid.html", {"lesson", "export", "pyramid"}},
             {"sheet-01.html", {"sheet", "light"}},
             {"class.csv", {"grade", folder / "anna.json"}},
             {"drill.html", {"drill"}},
             {"quiz.html", {"bug"}},
             {"index.html", {"site", "export"}}}) {
        test::writeText(folder / "out" / name, "mine");
        std::vector<std::string> whole = command;
        whole.insert(whole.end(), {"-o", at});
        const auto done = run(whole);
        EXPECT_EQ(done.status, 4) << name;
        EXPECT_TRUE(has(done.err, "out/" + name +
                                      ": is there, and Shadescope did not write it, expected another "
                                      "folder, or --force"))
            << done.err;
        EXPECT_EQ(test::readText(folder / "out" / name), "mine");
        EXPECT_EQ(folder.names(), (std::vector<std::string>{"anna.json", "out", "out/" + name}));
        fs::remove(folder / "out" / name);
    }
    test::writeText(folder / "out/drill.html", "mine");
    EXPECT_EQ(run({"drill", "--rounds", "1", "-o", at, "--force"}).status, 0);
    EXPECT_NE(test::readText(folder / "out/drill.html"), "mine");
    // Its own pages it replaces without being asked, also one of two.
    fs::remove(folder / "out/drill-answers.html");
    EXPECT_EQ(run({"drill", "--rounds", "1", "-o", at}).status, 0);
}

TEST(KeptFiles, AWrittenSceneIsReplacedUntilItIsChanged) {
    const test::TemporaryFolder folder;
    const std::vector<std::string> command{"export", "pyramid", "--format", "scene", "-o", folder.path().string()};
    EXPECT_EQ(run(command).status, 0);
    EXPECT_EQ(run(command).status, 0);
    const std::string changed = test::readText(folder / "pyramid.toml") + "# mine\n";
    test::writeText(folder / "pyramid.toml", changed);
    const auto done = run(command);
    EXPECT_EQ(done.status, 4);
    EXPECT_TRUE(has(done.err, "pyramid.toml: was changed since Shadescope wrote it")) << done.err;
    EXPECT_EQ(test::readText(folder / "pyramid.toml"), changed);
    auto forced = command;
    forced.emplace_back("--force");
    EXPECT_EQ(run(forced).status, 0);
}

// A class graded into the folder of its hand-ins is graded there again.
TEST(KeptFiles, TheClassAsItWasGradedIsNoHandIn) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "anna.json", R"({"version": 1, "lessons": {}})");
    const std::vector<std::string> command{"grade", folder.path().string(), "-o", folder.path().string()};
    const auto first = run(command);
    EXPECT_TRUE(fs::exists(folder / "class.json")) << first.err;
    const auto again = run(command);
    EXPECT_EQ(again.status, first.status);
    EXPECT_EQ(again.out, first.out);
    EXPECT_EQ(again.err, first.err) << "class.json is no hand-in";
}

double secondsOfChildren() {
    rusage used{};
    getrusage(RUSAGE_CHILDREN, &used);
    return double(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
           1e-6 * double(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

// A site takes 70 CPU seconds, a handout some, a comparison with names too.
TEST(KeptFiles, AFolderThatCannotBeWrittenIsRefusedBeforeAnythingIsComputed) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "file", "");
    test::writeText(folder / "anna.json", "no JSON");  // which grading would say
    const double before = secondsOfChildren();
    for (const std::vector<std::string>& command :
         std::vector<std::vector<std::string>>{{"site", "export"},
                                               {"lesson", "export", "shadows"},
                                               {"lesson", "export", "shadows", "--live"},
                                               {"present", "export", "lecture1"},
                                               {"compare", "pyramid", folder.path().string()},
                                               {"film", "pyramid", "--size", "16x12"},
                                               {"figure", "pyramid", "--format", "svg"},
                                               {"grade", folder / "anna.json"},
                                               {"sheet", "light"}}) {
        std::vector<std::string> whole = command;
        whole.insert(whole.end(), {"-o", folder / "file/out"});
        const auto done = run(whole);
        if (has(done.err, "this build has no window")) continue;
        EXPECT_EQ(done.status, 4) << command[0];
        EXPECT_EQ(done.err, (folder / "file/out").string() + ": could not write: Not a directory\n");
    }
    EXPECT_LT(secondsOfChildren() - before, 20.0) << "nothing is computed: reading lessons and scenes is all";
}

}  // namespace
