// Programs that somebody else has written are ended in time, with their children.
#include <gtest/gtest.h>

#include <csignal>
#include <string>

#include "app/cli/commands/foreign_program.h"

namespace {

using app::ProgramLimits;
using app::runProgram;
const ProgramLimits kShort{std::chrono::milliseconds(300), 1000, {}};

bool fails(const pipeline::Result<app::ProgramOutput>& run, const char* part) {
    return run && run->failure.find(part) != std::string::npos;
}

TEST(ForeignProgram, GetsItsInputAndGivesItsOutput) {
    const std::string large(300'000, 'x');  // more than a pipe holds
    const auto run = runProgram("cat; echo words >&2", large, {}, {});
    ASSERT_TRUE(run) << format(run.errors());
    EXPECT_EQ(run->output, large);
    EXPECT_EQ(run->messages, "words\n");
    EXPECT_TRUE(runProgram("exec 0<&-; echo done", large, {}, {}));  // one that does not read
}

TEST(ForeignProgram, IsEndedAfterItsTime) {
    for (const char* endless : {"sleep 60", "exec 1>&- 2>&-; sleep 60", "while :; do :; done"}) {
        const auto start = std::chrono::steady_clock::now();
        const auto run = runProgram(endless, "", kShort, {});
        EXPECT_TRUE(fails(run, "still running after 0.3 s")) << endless;
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
    }
}

TEST(ForeignProgram, IsEndedWithTheChildrenThatItLeftBehind) {
    const auto run = runProgram("sleep 60 >/dev/null 2>&1 & echo $!", "", {}, {});
    ASSERT_TRUE(run) << format(run.errors());
    const pid_t child = pid_t(std::stol(run->output));
    // It was killed before runProgram came back; on a busy machine it may take a while to end, and to be waited for.
    const auto gone = runProgram("for i in $(seq 100); do grep State /proc/" + std::to_string(child) +
                                     "/status | grep -qv Z || exit 0; sleep 0.05; done; exit 1",
                                 "", {}, {});
    ASSERT_TRUE(gone);
    EXPECT_EQ(gone->failure, "");
}

TEST(ForeignProgram, IsEndedWhenItWritesWithoutEnd) {
    const auto run = runProgram("yes", "", {std::chrono::seconds(20), 1000, {}}, {});
    EXPECT_TRUE(fails(run, "wrote more than"));
}

TEST(ForeignProgram, IsEndedWhenSomebodyAsks) {
    std::stop_source source;
    source.request_stop();
    EXPECT_TRUE(fails(runProgram("sleep 60", "", {}, source.get_token()), "asked to stop"));
}

TEST(ForeignProgram, SaysHowItEnded) {
    const auto run = runProgram("echo why >&2; exit 3", "", {}, {});
    EXPECT_TRUE(fails(run, "ended with status 3"));
    EXPECT_EQ(run->messages, "why\n");
    EXPECT_TRUE(fails(runProgram("kill -SEGV $$", "", {}, {}), "ended by signal 11"));
}

TEST(ForeignProgram, HasNoEnvironmentButThree) {
    ::setenv("SHADESCOPE_SECRET", "1", 1);
    const auto run = runProgram("env", "", {}, {});
    ::unsetenv("SHADESCOPE_SECRET");
    ASSERT_TRUE(run);
    EXPECT_EQ(run->output.find("SECRET"), std::string::npos);
    EXPECT_NE(run->output.find("LANG=C.UTF-8"), std::string::npos);
}

}  // namespace
