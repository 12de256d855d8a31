// Every command under hardship: stopped at random times, without threads, with little memory, on a full disk, and into a
// folder that cannot be written. Each run ends by itself, with a status of its own, and leaves all of its files or none.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <random>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"
#include "tests/support/sweep.h"

namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;
using Names = std::vector<std::string>;

const std::string kResources = SHADESCOPE_SCENES "/..";

enum class Writes { Nothing, AFolder, AFile };
struct Command {
    const char* name;
    Arguments arguments;
    Writes writes = Writes::Nothing;
    const char* file = "";
    bool isSlow = false;  // 70 CPU seconds where nothing ends it: in a long run alone
};
const std::array<Command, 19> kCommands{{
    {"export",
     {"export", "translucent", "--size", "64x48", "--buffers", "color,depth,normal", "--format", "png,npy,scene"},
     Writes::AFolder},
    {"plan", {"plan", "teapot", "--counts"}},
    {"inspect", {"inspect", "two_pyramids", "--contracts"}},
    {"study",
     {"study", "pyramid", "--size", "24x18", "--set", "camera.scale=0.03", "--sweep", "shading=flat,phong", "--repeat",
      "2", "--warm-up", "0", "--processes", "1"},
     Writes::AFolder},
    {"check", {"check", "--group", "camera", "--group", "depth"}},
    {"bench", {"bench", "pyramid", "--size", "64x48", "--repeat", "3"}},
    {"film", {"film", "pyramid", "--size", "32x24", "--pictures", "4"}, Writes::AFolder},
    {"figure", {"figure", "pyramid", "--size", "64x48"}, Writes::AFile, "figure.pdf"},
    {"lesson", {"lesson", "export", "pyramid"}, Writes::AFolder},
    {"show", {"lesson", "show", "pyramid"}},
    {"bug", {"bug", "--count", "2"}, Writes::AFolder},
    {"compare", {"compare", "", ""}, Writes::AFile, "report.html"},
    {"present", {"present", "export", kResources + "/manual/lecture1.cues"}, Writes::AFile, "talk.html"},
    {"site", {"site", "export"}, Writes::AFolder, "", true},
    {"sheet", {"sheet", kResources + "/sheets/light", "--variants", "2"}, Writes::AFolder},
    {"grade", {"grade", ""}, Writes::AFolder},
    {"drill", {"drill", "--rounds", "2"}, Writes::AFolder},
    {"stage", {"stage", "iMax", "pyramid", "--with", "echo iMax 1 1 175"}},
    {"starter", {"stage", "CalcNormal", "--starter", "python"}, Writes::AFolder},
}};

// What is hard, and in how many ways.
enum class Hardship { Interrupted, NoThread, LittleMemory, FullDisk, ReadOnly };
struct Hard {
    Hardship what;
    const char* name;
    std::size_t ways;
};
constexpr std::array<Hard, 5> kHard{{{Hardship::Interrupted, "Interrupted", 50},
                                     {Hardship::NoThread, "NoThread", 6},
                                     {Hardship::LittleMemory, "LittleMemory", 4},
                                     {Hardship::FullDisk, "FullDisk", 5},
                                     {Hardship::ReadOnly, "ReadOnly", 1}}};
constexpr std::size_t kWays = 66;
static_assert(kHard[0].ways + kHard[1].ways + kHard[2].ways + kHard[3].ways + kHard[4].ways == kWays);

class EveryCommand : public testing::TestWithParam<std::tuple<std::size_t, std::size_t>> {
protected:
    void SetUp() override {
        if (!test::kHasFaults) GTEST_SKIP() << "a sanitizer cannot be preloaded, and has memory of its own";
    }
    const Command& command() const { return kCommands[std::get<0>(GetParam())]; }
    const Hard& hard() const { return kHard[std::get<1>(GetParam())]; }

    // Of all runs of all commands those that this test makes: all in a long run, else its share of 50.
    std::vector<std::size_t> ways() const {
        std::size_t first = std::get<0>(GetParam()) * kWays;
        for (std::size_t i = 0; i < std::get<1>(GetParam()); ++i) first += kHard[i].ways;
        std::vector<std::size_t> mine;
        if (command().isSlow && !test::longRun() && hard().what != Hardship::Interrupted) return mine;
        for (const std::size_t i : test::sweep(kCommands.size() * kWays))
            if (i >= first && i < first + hard().ways) mine.push_back(i - first);
        return mine;
    }

    // What the command reads is made before, without hardship.
    void makeInputs() {
        const std::string cases = SHADESCOPE_CASES;
        test::writeText(m_folder / "anna.json", R"({"version": 1, "lessons": {}})");
        m_arguments = command().arguments;
        if (m_arguments[0] == "compare")
            m_arguments[1] = cases + "/scene.toml", m_arguments[2] = cases + "/c52_times_n";
        if (m_arguments[0] == "grade") m_arguments[1] = m_folder / "anna.json";
    }
    Arguments into(const fs::path& folder) const {
        Arguments all = m_arguments;
        if (command().writes == Writes::AFolder) all.insert(all.end(), {"-o", folder.string()});
        if (command().writes == Writes::AFile) all.insert(all.end(), {"-o", (folder / command().file).string()});
        return all;
    }
    Names namesIn(const fs::path& folder) const {
        Names names;
        if (fs::exists(folder))
            for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
                if (entry.is_regular_file()) names.push_back(entry.path().lexically_relative(folder).string());
        std::ranges::sort(names);
        return names;
    }
    // Without hardship; found when it is first asked for.
    const test::Finished& whole() {
        if (!m_whole) {
            fs::create_directory(m_folder / "whole");
            m_whole = test::run(into(m_folder / "whole"));
            m_names = namesIn(m_folder / "whole");
        }
        return *m_whole;
    }
    const Names& names() { return whole(), m_names; }

    test::Finished run(std::size_t way, const fs::path& out);

    test::TemporaryFolder m_folder;
    Arguments m_arguments;
    std::optional<test::Finished> m_whole;
    Names m_names;
};

test::Finished EveryCommand::run(std::size_t way, const fs::path& out) {
    switch (hard().what) {
        case Hardship::Interrupted: {
            // From a thousandth of a second to some: most of them while it works, in each decade as many.
            std::mt19937 random(unsigned(std::get<0>(GetParam()) * kWays + way));
            const double share = (double(way) + double(random()) / 0x1p32) / double(hard().ways);
            return test::runAndInterrupt(into(out), int(std::pow(2000.0, share)));
        }
        case Hardship::NoThread: return test::runWithFaults({{"NO_THREAD_FROM", way + 1}}, into(out));
        case Hardship::LittleMemory: return test::runWithin((way + 3) * 100'000'000, into(out));
        case Hardship::FullDisk: {
            constexpr std::size_t kBytes[]{200, 1000, 5000, 20'000, 100'000};  // 200 hold the message
            const test::FullDisk disk(kBytes[way]);
            return test::run(into(out));
        }
        case Hardship::ReadOnly: break;
    }
    return test::run(into("/proc/shadescope"));
}

TEST_P(EveryCommand, EndsByItselfAndLeavesAllOrNothing) {
    makeInputs();
    std::map<std::string, int> seen;
    for (const std::size_t way : ways()) {
        SCOPED_TRACE(testing::Message() << command().name << ", " << hard().name << ' ' << way);
        const fs::path out = m_folder / "a/out";
        fs::create_directories(out);
        const test::Finished done = run(way, out);
        const bool isCancelled = hard().what == Hardship::Interrupted && done.status == 130;
        // Without room for its libraries the loader says so, before the program begins.
        const bool isUnloaded = hard().what == Hardship::LittleMemory && done.status == 127;
        const bool isRefused = isUnloaded || (hard().what != Hardship::Interrupted && done.status == 4);
        ++seen[isCancelled ? "cancelled" : isRefused ? "refused" : "status " + std::to_string(done.status)];
        if (isRefused) {
            EXPECT_FALSE(done.err.empty()) << "it says why";
        } else if (!isCancelled) {
            EXPECT_EQ(done.status, whole().status) << done.err;
        }
        if (hard().what == Hardship::ReadOnly) {
            EXPECT_TRUE(isRefused || command().writes == Writes::Nothing) << done.status;
        }
        const Names left = namesIn(m_folder / "a");
        for (const std::string& name : left)
            EXPECT_FALSE(name.find("/.") != name.npos || name.starts_with('.')) << name;
        // What a study has measured so far is kept.
        const bool isKept = (isCancelled || isRefused) && left == Names{"out/study.part.json"};
        if ((!left.empty() && !isKept) || done.status == 0) {
            EXPECT_EQ(namesIn(out), hard().what == Hardship::ReadOnly ? Names{} : names());
        }
        fs::remove_all(m_folder / "a");
    }
    if (seen.empty()) return;
    std::string row = std::string(command().name) + ", " + hard().name + ":";
    for (const auto& [what, count] : seen) row += ' ' + std::to_string(count) + ' ' + what + ',';
    row.back() = '\n';
    std::fputs(row.c_str(), stdout);  // the table of a long run
}

INSTANTIATE_TEST_SUITE_P(Under, EveryCommand,
                         testing::Combine(testing::Range(std::size_t{0}, kCommands.size()),
                                          testing::Range(std::size_t{0}, kHard.size())),
                         [](const auto& one) {
                             return std::string(kCommands[std::get<0>(one.param)].name) +
                                    kHard[std::get<1>(one.param)].name;
                         });

// Else a new command would not be tried.
TEST(EveryCommandIsTried, AsTheHelpNamesThem) {
    const std::string help = test::run({"--help"}).out;
    const std::string list = help.substr(std::min(help.size(), help.find("ubcommands:")));
    std::size_t count = 0;
    for (std::size_t at = list.find("\n  "); at != list.npos; at = list.find("\n  ", at + 1)) {
        const std::string name = list.substr(at + 3, list.find_first_of(" \n", at + 3) - at - 3);
        if (name.empty()) continue;
        ++count;
        EXPECT_TRUE(std::ranges::any_of(kCommands, [&](const Command& one) { return one.arguments[0] == name; }))
            << name;
    }
    EXPECT_EQ(count, 17u);
}

}  // namespace
