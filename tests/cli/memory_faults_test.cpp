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

constexpr const char* kSentence =
    "shadescope: not enough memory; a smaller picture (--size) and fewer buffers (--buffers) need less\n";

constexpr const char* kNoThread =
    "shadescope: the system gives no further thread; its limit on processes or memory is reached\n";

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
    {"exportPictures",
     {"export", "pyramid", "--size", "16x12", "--buffers", "depth,color", "--format", "npy,png,scene", "--threads",
      "1"},
     true},
    {"exportTranslucent",
     {"export", "translucent", "--size", "16x12", "--buffers", "color,depth", "--format", "exr,vtk", "--threads", "1"},
     true},
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
    // Once all files are published only the last line of the output can fail.
    static void expectNothingOrAll(const test::TemporaryFolder& folder, const std::vector<std::string>& written) {
        if (folder.names().empty()) return;
        EXPECT_EQ(folder.names(), written);
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
        SCOPED_TRACE(testing::Message() << "allocation " << i + 1 << " of " << counts.allocations);
        fs::remove_all(folder / "whole");
        const auto done = test::runWithFaults({{"FAIL_AT", i + 1}, {"FAIL_TIMES", 2}}, arguments(folder / "whole/out"));
        if (done.status == 0) {
            EXPECT_EQ(done.out.size(), whole.out.size());
            EXPECT_EQ(folder.names(), GetParam().writes ? written : std::vector<std::string>{});
        } else {
            EXPECT_EQ(done.status, 4) << done.err;
            EXPECT_FALSE(done.err.empty());
            expectNothingOrAll(folder, written);
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
        SCOPED_TRACE(testing::Message() << "allocation " << i + 1 << " of " << counts.allocations);
        fs::remove_all(folder / "whole");
        const auto done = test::runWithFaults({{"FAIL_AT", i + 1}}, arguments(folder / "whole/out"));
        EXPECT_TRUE(done.status == 0 || (done.status == 4 && !done.err.empty())) << done.status << done.err;
        if (done.status != 0)
            expectNothingOrAll(folder, written);
        else
            EXPECT_EQ(folder.names(), written);
        done0 += done.status == 0, ++runs;
    }
    EXPECT_GT(done0, runs / 2);
}

// From then on nothing can be had: one sentence, and what is left goes with the next run.
TEST_P(AllocationFails, FromThenOnEndsWithOneSentenceAndTearsNothing) {
    const test::TemporaryFolder folder;
    const auto counts = test::countFaults(arguments(folder / "whole/out"));
    ASSERT_GT(counts.allocations, 1000u);
    const std::vector<std::string> written = folder.names();
    for (const std::size_t i : test::sweep(counts.allocations)) {
        SCOPED_TRACE(testing::Message() << "allocation " << i + 1 << " of " << counts.allocations);
        fs::remove_all(folder / "whole");
        const auto done = test::runWithFaults({{"FAIL_FROM", i + 1}}, arguments(folder / "whole/out"));
        if (done.status != 0) {  // at its end all was done
            EXPECT_EQ(done.status, 4) << done.err;
            // Without memory for its stack a thread cannot be started either.
            EXPECT_TRUE(done.err.ends_with(kSentence) || done.err.ends_with(kNoThread)) << done.err;
            expectNothingOrAll(folder, written);
        }
    }
}

// As libEGL, which the window's program brings along, before main: nothing can be caught there.
TEST(AllocationFailsInALibrary, ThatAbortsWhileItStartsIsAnsweredTheSame) {
    if (!test::kHasFaults) GTEST_SKIP() << "a sanitizer answers signals itself";
    const auto done = test::runWithFaults({{"ABORT", 1}}, {"plan", "pyramid"});
    EXPECT_EQ(done.status, 4);
    EXPECT_EQ(done.err, kSentence);
}

// The first thread waits for Ctrl+C, the next are TBB's, which throws where nothing can catch it.
TEST(ThreadFails, EndsWithASentenceAndLeavesNothing) {
    if (!test::kHasFaults) GTEST_SKIP() << "a sanitizer starts threads itself";
    int refused = 0;
    for (const std::size_t from : {1, 2, 3}) {
        const test::TemporaryFolder folder;
        const auto done = test::runWithFaults({{"NO_THREAD_FROM", from}}, {"export", "translucent", "--size", "16x12",
                                                                           "--threads", "4", "-o", folder / "out"});
        if (done.status == 0) continue;  // it needed no more
        ++refused;
        EXPECT_EQ(done.status, 4) << from;
        EXPECT_EQ(done.err, kNoThread) << from;
        EXPECT_TRUE(folder.names().empty()) << from;
    }
    EXPECT_GE(refused, 2);
}

INSTANTIATE_TEST_SUITE_P(Of, AllocationFails, testing::ValuesIn(kCases),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
