// Tests that end their process, take too long or fail, for tests/runner/check. None of them is one of the project's.
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

namespace {

TEST(Tame, Passes) {}
TEST(Tame, IsLeftOut) { GTEST_SKIP() << "for a reason"; }

TEST(Unruly, Passes) { std::fputs("no end of line", stdout); }
TEST(Unruly, Crashes) {
    std::puts("before the crash");
    std::fflush(stdout);
    std::raise(SIGSEGV);
}
TEST(Unruly, PassesAfterTheCrash) {}
TEST(Unruly, EndsTheProcessAsIfAllWereWell) { std::_Exit(0); }
TEST(Unruly, NeverEnds) {
    for (;;) pause();
}
TEST(Unruly, Fails) { EXPECT_EQ(1 + 1, 3) << "told"; }
TEST(Unruly, DISABLED_IsNotRun) { FAIL(); }

// Wrong only once all have passed, as what a sanitizer finds at the end.
struct WrongAtItsEnd : testing::Test {
    static void TearDownTestSuite() {
        std::atexit([] { std::_Exit(3); });
    }
};
TEST_F(WrongAtItsEnd, Passes) {}

class Numbered : public testing::TestWithParam<int> {};
TEST_P(Numbered, IsSmall) { EXPECT_LT(GetParam(), 3); }
INSTANTIATE_TEST_SUITE_P(Numbers, Numbered, testing::Values(1, 2, 30));

}  // namespace
