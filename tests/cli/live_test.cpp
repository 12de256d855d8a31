#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include <unistd.h>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"

namespace {

namespace fs = std::filesystem;
using test::has;
using test::run;

bool isCoreBuilt() {
    const fs::path root = fs::path(test::scene("pyramid.scene")).parent_path().parent_path().parent_path();
    return fs::exists(root / "build" / "web" / "shadescope_core.wasm.gz");
}

TEST(Live, RefusesAFolderAndOptionsThatAPageHasNoUseFor) {
    const fs::path folder = fs::temp_directory_path();
    EXPECT_EQ(run({"export", "pyramid", "--live", "-o", folder.string()}).status, 2);
    EXPECT_EQ(run({"lesson", "export", "pyramid", "--live", "-o", ""}).status, 2);
    EXPECT_EQ(run({"export", "--live", "-o", "x.html"}).status, 2) << "neither a scene nor a cue";
    EXPECT_EQ(run({"export", "pyramid", "--live", "--format", "png", "-o", "x.html"}).status, 2);
    EXPECT_FALSE(fs::exists("x.html"));
}

TEST(Live, SaysHowToBuildTheCoreWhereThereIsNone) {
    if (isCoreBuilt()) GTEST_SKIP() << "the core of live pages is built";
    for (const auto& result : {run({"export", "pyramid", "--live", "-o", "x.html"}),
                               run({"lesson", "export", "pyramid", "--live", "-o", "x.html"})}) {
        EXPECT_EQ(result.status, 4);
        EXPECT_TRUE(has(result.err, "cmake --preset web")) << result.err;
        EXPECT_FALSE(fs::exists("x.html"));
    }
}

TEST(Live, WritesOneFileOfAtMostABudget) {
    if (!isCoreBuilt()) GTEST_SKIP() << "the core of live pages is not built: cmake --preset web && ninja -C build/web";
    const fs::path file = fs::temp_directory_path() / ("shadescope-live-" + std::to_string(::getpid()) + ".html");
    const auto result = run({"lesson", "export", "pyramid", "--live", "-o", file.string()});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_LE(fs::file_size(file), 1'900'000u) << "one lesson";
    std::ifstream in(file);
    const std::string page{std::istreambuf_iterator<char>(in), {}};
    EXPECT_TRUE(has(page, "<title>The pyramid"));
    EXPECT_TRUE(has(page, "Content-Security-Policy"));
    fs::remove(file);
}

}  // namespace
