// Pictures that are too large for what is asked of them, and for the machine.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"

namespace {

using Arguments = std::vector<std::string>;

// 2^28 pixels: the plan needs none of them, and the colour alone needs few bytes of each.
TEST(Memory, aPlanNeedsNone) {
    const auto plan = test::run({"plan", "pyramid", "--size", "16384x16384"});
    EXPECT_EQ(plan.status, 0) << plan.err;
    const auto counted = test::run({"plan", "pyramid", "--size", "16384x16384", "--counts"});
    EXPECT_EQ(counted.status, 2);
    EXPECT_NE(counted.err.find("--size 16384x16384: the buffers of a 16384 × 16384 picture"), std::string::npos)
        << counted.err;
}

// What a file asks for is judged after --size, and where it stays too large it is the file that is bad input.
TEST(Memory, isJudgedAfterTheSettings) {
    const test::TemporaryFolder folder;
    const std::string file = folder / "large.toml";
    test::writeText(file, "width = 16384\nheight = 16384\n[[object]]\nshape = \"sphere\"\n");
    const auto inspected = [&](Arguments more) {
        Arguments all{"inspect", file, "--pixel", "1,1"};
        all.insert(all.end(), more.begin(), more.end());
        return test::run(all);
    };
    EXPECT_EQ(inspected({"--size", "16x16"}).status, 0);
    const auto refused = inspected({"--no-leave-out"});
    EXPECT_EQ(refused.status, 3);
    EXPECT_TRUE(refused.err.starts_with(file + ": the buffers of a 16384 × 16384 picture")) << refused.err;
}

// 3500² pixels of 207 bytes are 2.4 GiB: fewer than the program may take, and more than there are here.
TEST(Memory, thatIsNotThereIsAnError) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "a sanitizer reserves more addresses than the limit leaves, and the program would not start";
#endif
    const test::TemporaryFolder folder;
    const std::string out = folder / "out";
    const auto done = test::runWithin(std::size_t{1} << 30, {"export", "pyramid", "--size", "3500x3500", "-o", out,
                                                             "--no-leave-out", "--threads", "1"});
    EXPECT_EQ(done.status, 4);
    EXPECT_EQ(done.err,
              "shadescope: not enough memory; a smaller picture (--size) and fewer buffers (--buffers) need less\n");
    EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
