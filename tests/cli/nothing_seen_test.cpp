// Where nothing is seen every command says why, and what to set.
#include <gtest/gtest.h>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"

using test::has, test::run, test::scene;

namespace {

// An object of opacity 0 draws nothing: what is said is the same for all commands, once.
TEST(NothingSeen, IsSaidByEveryCommand) {
    const std::string why = "wholly transparent (α = 0): set material.0.alpha=1";
    const std::string file = scene("pyramid.scene"), set = "material.0.alpha=0";
    const auto times = [&](const std::string& text) {
        std::size_t count = 0;
        for (std::size_t at = 0; (at = text.find(why, at)) != text.npos; ++at) ++count;
        return count;
    };
    const test::TemporaryFolder folder;
    const std::string out = folder / "out";
    for (const std::vector<std::string>& command : {std::vector<std::string>{"plan", file},
                                                    {"plan", file, "--counts"},
                                                    {"inspect", file, "--pixel", "1,1"},
                                                    {"inspect", file, "--row", "1"},
                                                    {"bench", file, "--repeat", "1", "--warm-up", "0"},
                                                    {"export", file, "-o", out}}) {
        std::vector<std::string> arguments = command;
        const auto seen = run(arguments);
        EXPECT_EQ(times(seen.out + seen.err), 0u) << command[0];
        arguments.insert(arguments.end(), {"--set", set});
        const auto unseen = run(arguments);
        EXPECT_EQ(unseen.status, 0) << unseen.err;
        EXPECT_EQ(times(unseen.out + unseen.err), 1u) << command[0] << unseen.err;
    }
    EXPECT_EQ(times(test::readText(folder / "out/manifest.json")), 1u);
}

}  // namespace
