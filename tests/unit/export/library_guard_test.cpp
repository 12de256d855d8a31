#include "app/cli/library_guard.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>

#include "pipeline/export/folder/staging.h"
#include "tests/support/files.h"

namespace app {
namespace {

constexpr const char* kSentence = "^shadescope: a library that draws text or 3D views failed";

class LibraryGuardDeathTest : public testing::Test {
protected:
    void SetUp() override {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        GTEST_SKIP() << "a sanitizer answers signals itself";
#endif
        GTEST_FLAG_SET(death_test_style, "threadsafe");
    }
};

TEST_F(LibraryGuardDeathTest, EndsWithASentenceWhereALibraryCrashes) {
    for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGTRAP})
        EXPECT_EXIT(
            {
                const LibraryGuard guard;
                std::raise(signal);
            },
            testing::ExitedWithCode(4), kSentence);
}

// Its own thread's CPU time alone counts.
TEST_F(LibraryGuardDeathTest, EndsWithASentenceWhereALibraryGoesRoundForEver) {
    EXPECT_EXIT(
        {
            const LibraryGuard guard(1);
            for (volatile unsigned i = 0;;) i = i + 1;
        },
        testing::ExitedWithCode(4), kSentence);
}

TEST_F(LibraryGuardDeathTest, RemovesTheHiddenFolder) {
    const test::TemporaryFolder folder;
    const auto crash = [&] {
        const auto staging = pipeline::Staging::begin(folder / "out");
        if (!staging || folder.names().empty()) std::exit(0);
        const LibraryGuard guard;
        std::raise(SIGSEGV);
    };
    EXPECT_EXIT(crash(), testing::ExitedWithCode(4), kSentence);
    EXPECT_EQ(folder.names(), std::vector<std::string>{});
}

// A fault of our own is not the library's: it ends the program as ever.
TEST_F(LibraryGuardDeathTest, AnswersNothingAfterItsEnd) {
    const auto crash = [] {
        std::signal(SIGSEGV, SIG_DFL);
        { const LibraryGuard guard; }
        std::raise(SIGSEGV);
    };
    EXPECT_EXIT(crash(), testing::KilledBySignal(SIGSEGV), "");
}

}  // namespace
}  // namespace app
