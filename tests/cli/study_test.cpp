// shadescope study: reports, shards and their merge, going on after an interruption, what is refused.
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

std::vector<std::string> studyOf(const fs::path& folder, std::vector<std::string> more) {
    std::vector<std::string> arguments{
        "study", "flat_gouraud_phong", "--sweep", "shading=flat,phong", "--sweep", "tessellation=2..4*2", "--size",
        "48x36", "--repeat",           "2",       "--warm-up",          "0",       "--processes",         "1",
        "-o",    folder.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

Json read(const fs::path& file) {
    std::ifstream in(file);
    return Json::parse(in);
}

// The study without what a clock says.
Json withoutTimes(Json study) {
    // The hashes of its contents are of files that hold times.
    for (const char* member : {"load", "processes", "contents"}) study.erase(member);
    for (Json& point : study["points"]) point.erase("frame"), point.erase("stages");
    return study;
}

TEST(StudyCommand, writesEveryReport) {
    const test::TemporaryFolder folder;
    const auto done = test::run(studyOf(folder.path(), {}));
    ASSERT_EQ(done.status, 0) << done.err;
    for (const char* name : {"study.json", "study.csv", "report.html", "plot.svg", "plot.png"})
        EXPECT_TRUE(fs::exists(folder.path() / name)) << name;
    EXPECT_FALSE(fs::exists(folder.path() / "study.part.json"));
    EXPECT_NE(done.out.find("on the front"), std::string::npos) << done.out;
    const Json study = read(folder.path() / "study.json");
    ASSERT_EQ(study["points"].size(), 4u);
    for (const Json& point : study["points"]) {
        EXPECT_FALSE(point["errors"].empty());
        EXPECT_EQ(point["frame"].dump().find("null"), std::string::npos);
    }
}

// "Ran, and the answer is no", with every report; without the file that an interrupted study goes on from.
TEST(StudyCommand, aLimitThatNoSettingKeepsIsStatus1) {
    const test::TemporaryFolder folder;
    for (const auto& [limit, value, status] : std::vector<std::tuple<std::string, std::string, int>>{
             {"--within", "1e-12", 1}, {"--within", "1", 0}, {"--in", "1e-9", 1}, {"--in", "1e9", 0}}) {
        const auto out = folder / (limit + value);
        const auto done = test::run(studyOf(out, {limit, value}));
        EXPECT_EQ(done.status, status) << limit << ' ' << value << '\n' << done.out;
        EXPECT_EQ(done.out.find("No setting ") != done.out.npos, status == 1) << done.out;
        EXPECT_TRUE(fs::exists(out / "report.html"));
        EXPECT_FALSE(fs::exists(out / "study.part.json"));
    }
    const auto merged = [&](const char* limit) {
        return test::run({"study", "merge", (folder / "--in1e9/study.json").string(), "-o",
                          (folder / "merged").string(), "--within", limit})
            .status;
    };
    EXPECT_EQ(merged("1e-12"), 1);
    EXPECT_EQ(merged("1"), 0);
}

// No setting has an error or a time: there is no answer, neither of the study nor of its parts put together.
TEST(StudyCommand, ofPointsThatAllFailIsStatus1) {
    const test::TemporaryFolder folder;
    // The sphere is a few world units wide, and far outside the picture at 100 000.
    const auto study = [&](const char* places, const char* out, std::vector<std::string> more) {
        std::vector<std::string> arguments{"study",       "flat_gouraud_phong",
                                           "--sweep",     std::string("object.0.ty=") + places,
                                           "--size",      "48x36",
                                           "--repeat",    "1",
                                           "--warm-up",   "0",
                                           "--processes", "1",
                                           "-o",          folder / out};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return test::run(arguments);
    };
    const std::string none =
        "No point of the study has both a time and an error: nothing is drawn: there is nothing to compare\n";
    const auto all = study("1e5,2e5", "all", {});
    EXPECT_EQ(all.status, 1) << all.err;
    EXPECT_TRUE(all.err.ends_with(none)) << all.err;
    EXPECT_TRUE(fs::exists(folder.path() / "all/report.html"));
    EXPECT_FALSE(fs::exists(folder.path() / "all/study.part.json"));
    const auto some = study("0,1e5", "some", {});
    EXPECT_EQ(some.status, 0) << some.err;
    EXPECT_EQ(some.err.find("No point"), some.err.npos) << some.err;
    EXPECT_EQ(study("1e5,2e5", "parts", {"--shard", "1/2"}).status, 0) << "a part of a study answers nothing";
    EXPECT_EQ(study("1e5,2e5", "parts", {"--shard", "2/2"}).status, 0);
    const auto merged = test::run({"study", "merge", folder / "parts/study-1-of-2.json",
                                   folder / "parts/study-2-of-2.json", "-o", folder / "merged"});
    EXPECT_EQ(merged.status, 1) << merged.err;
    EXPECT_TRUE(merged.err.ends_with(none)) << merged.err;
}

// Errors and counters depend on the point alone, not on who computes it with what others.
TEST(StudyCommand, shardsMergeToTheSameStudy) {
    const test::TemporaryFolder whole, parts, merged;
    ASSERT_EQ(test::run(studyOf(whole.path(), {})).status, 0);
    ASSERT_EQ(test::run(studyOf(parts.path(), {"--shard", "1/3"})).status, 0);
    ASSERT_EQ(test::run(studyOf(parts.path(), {"--shard", "2/3"})).status, 0);
    ASSERT_EQ(test::run(studyOf(parts.path(), {"--shard", "3/3"})).status, 0);
    const auto part = [&](const char* name) { return (parts.path() / name).string(); };
    const auto done = test::run({"study", "merge", part("study-3-of-3.json"), part("study-1-of-3.json"),
                                 part("study-2-of-3.json"), "-o", merged.path().string()});
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_EQ(withoutTimes(read(merged.path() / "study.json")), withoutTimes(read(whole.path() / "study.json")));

    // The same as commands for several machines, one a point: here a shell runs them.
    const test::TemporaryFolder machines;
    const std::string jobs = machines / "jobs";
    ASSERT_EQ(test::run(studyOf(machines / "parts", {"--commands", jobs})).status, 0);
    EXPECT_EQ(std::ranges::count(test::readText(jobs), '\n'), 4);
    ASSERT_EQ(std::system(("sh " + jobs + " > " + jobs + ".log 2>&1").c_str()), 0) << test::readText(jobs + ".log");
    std::vector<std::string> merge{"study", "merge"};
    for (int i = 1; i <= 4; ++i) merge.push_back(machines / ("parts/study-" + std::to_string(i) + "-of-4.json"));
    merge.insert(merge.end(), {"-o", machines / "merged"});
    ASSERT_EQ(test::run(merge).status, 0);
    EXPECT_EQ(withoutTimes(read(machines / "merged/study.json")), withoutTimes(read(whole.path() / "study.json")));

    const auto less = test::run(
        {"study", "merge", part("study-1-of-3.json"), part("study-2-of-3.json"), "-o", merged.path().string()});
    EXPECT_EQ(less.status, 1);
    EXPECT_NE(less.err.find("1 of 4 points are missing"), std::string::npos) << less.err;
    const auto partial = test::run({"study", "merge", part("study-1-of-3.json"), part("study-2-of-3.json"), "--partial",
                                    "-o", merged.path().string()});
    EXPECT_EQ(partial.status, 0);
    EXPECT_NE(partial.err.find("1 of 4 points are missing"), std::string::npos) << partial.err;
}

TEST(StudyCommand, goesOnWhereItWasInterrupted) {
    const test::TemporaryFolder folder, whole;
    auto arguments = studyOf(folder.path(), {});
    for (std::string& argument : arguments)
        if (argument == "2" && &argument != &arguments.front())
            argument = "100000";  // repeats: long enough to be stopped
    const auto stopped = test::runAndInterrupt(arguments, 1500);
    ASSERT_EQ(stopped.status, 130) << stopped.err;
    ASSERT_TRUE(fs::exists(folder.path() / "study.part.json"));
    EXPECT_FALSE(fs::exists(folder.path() / "study.json"));
    const auto refused = test::run(studyOf(folder.path(), {}));
    EXPECT_EQ(refused.status, 3);
    EXPECT_NE(refused.err.find("another study"), std::string::npos) << refused.err;
    const auto again = test::run(studyOf(folder.path(), {"--restart"}));
    EXPECT_EQ(again.status, 0) << again.err;
}

// An error that the points turn out not to have is refused before any time is taken; what was found until then serves the
// next command, which is about the error that it names itself.
TEST(StudyCommand, goesOnWithTheErrorOfTheNewCommand) {
    const test::TemporaryFolder folder;
    const auto command = [&](const char* error) {
        return test::run({"study", "flat_gouraud_phong", "--sweep", "shading=flat,phong", "--set", "precision=double",
                          "--set", "depth_format=linear", "--size", "48x36", "--repeat", "2", "--processes", "1", "-o",
                          folder.path().string(), "--error", error});
    };
    const auto refused = command("depth:RMSE:storage");
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("no point has this error; there are"), std::string::npos) << refused.err;
    ASSERT_TRUE(fs::exists(folder.path() / "study.part.json"));
    EXPECT_TRUE(read(folder.path() / "study.part.json")["load"].empty());
    const auto done = command("normal:mean angle:model");
    EXPECT_EQ(done.status, 0) << done.err;
    EXPECT_NE(done.err.find("Goes on"), std::string::npos);
    EXPECT_NE(done.out.find("mean angle of normal"), std::string::npos) << done.out;
}

TEST(StudyCommand, leavesOtherFilesOfTheFolderAlone) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "times-0.json", "mine");
    EXPECT_EQ(test::run(studyOf(folder.path(), {})).status, 0);
    EXPECT_EQ(test::readText(folder / "times-0.json"), "mine");
    for (const auto& entry : fs::directory_iterator(folder.path()))
        EXPECT_FALSE(entry.path().filename().string().starts_with('.')) << entry.path();
}

TEST(StudyCommand, saysWhyAFileCannotBeRead) {
    const test::TemporaryFolder folder;
    const auto merge = [&](const fs::path& file) {
        const auto done = test::run({"study", "merge", file, "-o", folder / "out"});
        EXPECT_EQ(done.status, 3);
        return done.err;
    };
    EXPECT_EQ(merge(folder / "none.json"), (folder / "none.json").string() + ": no such file\n");
    EXPECT_EQ(merge(folder.path()), folder.path().string() + ": this is a folder, expected a file\n");
    const fs::path part = folder / "study.part.json";
    test::writeText(part, "");
    const auto done = test::run(studyOf(folder.path(), {}));
    EXPECT_EQ(done.status, 3);
    EXPECT_TRUE(done.err.starts_with(part.string() + ':')) << done.err;
    EXPECT_NE(done.err.find(": this is not JSON, expected "), std::string::npos) << done.err;
    EXPECT_TRUE(done.err.ends_with("; --restart begins this study anew\n")) << done.err;
    EXPECT_EQ(test::run(studyOf(folder.path(), {"--restart"})).status, 0);
}

TEST(StudyCommand, refusesItsFolderBeforeItMeasures) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "file", "");
    const auto seconds = [&](const fs::path& out, int status) {
        const auto start = std::chrono::steady_clock::now();
        auto arguments = studyOf(out, {});
        std::ranges::replace(arguments, "48x36", "320x240");
        const auto done = test::run(arguments);
        EXPECT_EQ(done.status, status) << done.err;
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    const double whole = seconds(folder / "out", 0);
    for (const fs::path& out : {folder / "file", folder / "file/out", fs::path("/proc/out")})
        EXPECT_LT(seconds(out, 4), whole / 4) << out << ": errors are found all the same";
    EXPECT_EQ(test::readText(folder / "file"), "");
}

TEST(StudyCommand, saysWhatIsWrong) {
    const test::TemporaryFolder folder;
    const auto message = [&](std::vector<std::string> more, int status) {
        std::vector<std::string> arguments{"study", "pyramid", "-o", (folder.path() / "out").string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const auto done = test::run(arguments);
        EXPECT_EQ(done.status, status) << done.err;
        EXPECT_FALSE(fs::exists(folder.path() / "out"));
        return done.err;
    };
    EXPECT_NE(message({}, 2).find("--sweep is missing"), std::string::npos);
    EXPECT_NE(message({"--sweep", "shadng=flat"}, 2).find("the nearest is \"shading\""), std::string::npos);
    EXPECT_NE(message({"--sweep", "shading", "--shard", "4/3"}, 2).find("I from 1 to N"), std::string::npos);
    EXPECT_NE(message({"--sweep", "shading", "--error", "color"}, 2).find("BUFFER:MEASURE"), std::string::npos);
    // Before anything is computed: the study would take as long as it has points.
    const auto error = [&](const char* text) { return message({"--sweep", "shading", "--error", text}, 2); };
    EXPECT_NE(error("colour:RMSE").find("no buffer \"colour\"; the nearest is \"color\""), std::string::npos);
    EXPECT_NE(error("shadow.1:leak").find("this scene has 1 light"), std::string::npos);
    EXPECT_NE(error("overdraw:RMSE").find("no error of overdraw is measured"), std::string::npos);
    EXPECT_NE(error("intensity:RMS")
                  .find("no model error \"RMS\" of intensity is measured; there are\n"
                        "  intensity:RMSE:model\n"),
              std::string::npos);
    EXPECT_NE(error("depth:RMSE").find("depth:RMSE:storage"), std::string::npos);
    EXPECT_NE(error("color:PSNR").find("no model error \"PSNR\""), std::string::npos) << "of which more is better";
    // A part of a study has no report.
    for (const std::vector<std::string>& more :
         {std::vector<std::string>{"--json"}, {"--within", "0.1"}, {"--in", "5"}}) {
        std::vector<std::string> arguments{"--sweep", "shading", "--shard", "1/2"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        EXPECT_NE(message(arguments, 2).find(more[0] + " does not go with --shard"), std::string::npos);
    }
    for (const char* limit : {"--within", "--in"})
        for (const char* value : {"0", "-1", "nan", "inf", "1e999", "x", ""})
            EXPECT_EQ(message({"--sweep", "shading", limit, value}, 2),
                      std::string("shadescope: ") + limit + ": found \"" + value +
                          "\", expected a number above 0\nRun shadescope study --help to see what there is.\n");
    EXPECT_NE(test::run({"study", "pyramid", "--sweep", "shading"}).err.find("--output is required"),
              std::string::npos);
    EXPECT_NE(test::run({"study", "merge", "a.json"}).err.find("--output is required"), std::string::npos);
    EXPECT_NE(error("normal:RMSE").find("\n  normal:mean angle:model\n"), std::string::npos) << "as --help names it";
    for (const char* what : {"--output DIR REQUIRED", "--sweep SWEEP REQUIRED", "normal:mean angle:model"})
        EXPECT_NE(test::run({"study", "--help"}).out.find(what), std::string::npos) << what;
    const auto merge = test::run({"study", "merge", "/nonexistent.json", "-o", folder.path().string()});
    EXPECT_EQ(merge.status, 3);
    EXPECT_NE(merge.err.find("/nonexistent.json: no such file"), std::string::npos) << merge.err;
}

// The first process that another one has started; 0: none yet. Field 4 of /proc/PID/stat, proc(5).
int childOf(int process) {
    for (const fs::directory_entry& entry : fs::directory_iterator("/proc")) {
        if (!std::isdigit(static_cast<unsigned char>(entry.path().filename().string()[0]))) continue;
        std::ifstream in(entry.path() / "stat");
        const std::string text(std::istreambuf_iterator<char>(in), {});
        const auto name = text.rfind(") ");
        if (name == text.npos) continue;
        std::istringstream rest(text.substr(name + 2));
        char state = 0;
        int parent = 0;
        if (rest >> state >> parent && parent == process) return std::stoi(entry.path().filename().string());
    }
    return 0;
}

std::string commandLineOf(int process) {
    std::ifstream in(fs::path("/proc") / std::to_string(process) / "cmdline");
    return {std::istreambuf_iterator<char>(in), {}};
}

// However a study ends, no process goes on measuring for nobody. This one takes the orphans, so that it is told how they
// ended: by force, where the study could not ask them to stop.
TEST(StudyCommand, takesItsMeasuringProcessAlong) {
    ASSERT_EQ(prctl(PR_SET_CHILD_SUBREAPER, 1), 0);
    for (const int signal : {SIGKILL, SIGSEGV, SIGTERM, SIGINT}) {
        const auto before = signal == SIGKILL ? SIG_DFL : std::signal(signal, SIG_DFL);
        const test::TemporaryFolder folder;
        int child = 0;
        std::vector<std::string> arguments = studyOf(folder.path(), {});
        *(std::ranges::find(arguments, "--repeat") + 1) = "100000";  // hours
        const auto done = test::runWhile(arguments, [&](int process) {
            for (int look = 0; child == 0 && look < 100'000; ++look) child = childOf(process);
            // Until it runs a command of its own it is not measuring: it looks whether its parent is there, and ends
            // by itself where not.
            const std::string parents = commandLineOf(process);
            for (int look = 0; child != 0 && commandLineOf(child) == parents && look < 100'000; ++look)
                std::this_thread::yield();
            ::kill(process, signal);
        });
        if (signal != SIGKILL) std::signal(signal, before);
        ASSERT_GT(child, 0);
        const bool isAsked = signal == SIGTERM || signal == SIGINT;
        EXPECT_EQ(done.status, isAsked ? 130 : 128 + signal);
        int status = 0;
        const pid_t waited = waitpid(child, &status, 0);
        if (isAsked) {
            EXPECT_EQ(waited, -1) << "the study itself has waited for it";
            EXPECT_NE(::kill(child, 0), 0);
        } else {
            EXPECT_EQ(waited, child);
            EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) << status;
        }
    }
    prctl(PR_SET_CHILD_SUBREAPER, 0);
}

}  // namespace
