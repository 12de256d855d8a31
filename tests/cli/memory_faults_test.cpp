// Allocations that fail, one after the other, in the program as a user starts it.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"
#include "tests/support/sweep.h"

namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

// Of libpixman, which begins before anything of the program runs and does not look at what malloc gives it.
constexpr std::size_t kLoader = 9;

constexpr const char* kSentence =
    "shadescope: not enough memory; a smaller picture (--size) and fewer buffers (--buffers) need less\n";

// Commands over scenes of several formats. With one thread, which counts the same from run to run.
struct Case {
    const char* name;
    Arguments arguments;
    bool writes = false;  // into a folder, which is added
};
const std::vector<Case> kCases{
    {"planOfAScene", {"plan", "pyramid"}},
    {"planOfToml", {"plan", "translucent", "--json"}},
    {"inspect", {"inspect", "teapot", "--size", "32x24", "--pixel", "16,12"}},
    {"inspectATable", {"inspect", "pyramid", "--table", "polygons", "--format", "latex"}},
    // Not exports: libraries that write pictures end the process by themselves where they have no memory.
};

class AllocationFails : public testing::TestWithParam<Case> {
protected:
    void SetUp() override {
        if (!test::kHasFaults) GTEST_SKIP() << "a sanitizer has allocations of its own";
    }
    Arguments arguments(const std::string& out) const {
        Arguments all = GetParam().arguments;
        if (GetParam().writes) all.insert(all.end(), {"-o", out});
        return all;
    }
};

// Two in a row fail, for operator new tries once more. Where a library can do without, the output is the same; else there
// is a message and status 4, and nothing is left.
TEST_P(AllocationFails, OnceEndsWithAMessageAndLeavesNothing) {
    const test::TemporaryFolder folder;
    const auto counts = test::countFaults(arguments(folder / "whole/out"));
    const auto whole = test::run(arguments(folder / "whole/out"));
    ASSERT_EQ(whole.status, 0) << whole.err;
    ASSERT_GT(counts.allocations, 1000u);
    const std::vector<std::string> written = folder.names();
    int refused = 0;
    for (const std::size_t i : test::sweep(counts.allocations)) {
        if (i < kLoader) continue;
        SCOPED_TRACE(testing::Message() << "allocation " << i + 1 << " of " << counts.allocations);
        fs::remove_all(folder / "whole");
        const auto done = test::runWithFaults({{"FAIL_AT", i + 1}, {"FAIL_TIMES", 2}}, arguments(folder / "whole/out"));
        if (done.status == 0) {
            EXPECT_EQ(done.out.size(), whole.out.size());
            EXPECT_EQ(folder.names(), GetParam().writes ? written : std::vector<std::string>{});
        } else {
            EXPECT_EQ(done.status, 4) << done.err;
            EXPECT_FALSE(done.err.empty());
            EXPECT_EQ(folder.names(), std::vector<std::string>{});
            ++refused;
        }
    }
    EXPECT_GT(refused, 0);
}

// One that fails by itself may be tried again: then all is as ever.
TEST_P(AllocationFails, OnceAndNotAgainChangesNothingOrEndsWithAMessage) {
    const test::TemporaryFolder folder;
    const auto counts = test::countFaults(arguments(folder / "whole/out"));
    const std::vector<std::string> written = folder.names();
    std::size_t done0 = 0, runs = 0;
    for (const std::size_t i : test::sweep(counts.allocations)) {
        if (i < kLoader) continue;
        SCOPED_TRACE(testing::Message() << "allocation " << i + 1 << " of " << counts.allocations);
        fs::remove_all(folder / "whole");
        const auto done = test::runWithFaults({{"FAIL_AT", i + 1}}, arguments(folder / "whole/out"));
        EXPECT_TRUE(done.status == 0 || (done.status == 4 && !done.err.empty())) << done.status << done.err;
        EXPECT_EQ(folder.names(), done.status == 0 && GetParam().writes ? written : std::vector<std::string>{});
        done0 += done.status == 0, ++runs;
    }
    EXPECT_GT(done0, runs / 2);
}

// From then on nothing can be had: one sentence, and what is left goes with the next run.
TEST_P(AllocationFails, FromThenOnEndsWithOneSentenceAndTearsNothing) {
    const test::TemporaryFolder folder;
    const auto counts = test::countFaults(arguments(folder / "whole/out"));
    ASSERT_GT(counts.allocations, 1000u);
    fs::remove_all(folder / "whole");
    for (const std::size_t i : test::sweep(counts.allocations)) {
        if (i < kLoader) continue;
        SCOPED_TRACE(testing::Message() << "allocation " << i + 1 << " of " << counts.allocations);
        const auto done = test::runWithFaults({{"FAIL_FROM", i + 1}}, arguments(folder / "a/out"));
        if (done.status != 0) {  // at its end all was done
            EXPECT_EQ(done.status, 4) << done.err;
            EXPECT_TRUE(done.err.ends_with(kSentence)) << done.err;
            EXPECT_EQ(folder.names(), std::vector<std::string>{});
        }
        fs::remove_all(folder / "a");
    }
}

INSTANTIATE_TEST_SUITE_P(Of, AllocationFails, testing::ValuesIn(kCases),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
