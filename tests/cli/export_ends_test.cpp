// Exports that cannot be written, wholly or in part, or are told to stop.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <filesystem>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"

namespace {

namespace fs = std::filesystem;
using test::run;

TEST(ExportEnds, AnUnwritableFolderIsStatus4AndLeavesNothing) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "file", "");
    const auto inPlace = run({"export", "pyramid", "-o", folder / "file"});
    EXPECT_EQ(inPlace.status, 4);
    EXPECT_EQ(inPlace.err, (folder / "file").string() + ": could not write: Not a directory\n");
    EXPECT_EQ(run({"export", "pyramid", "-o", folder / "file/out"}).status, 4);
    EXPECT_EQ(run({"export", "pyramid", "-o", "/proc/out"}).status, 4);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"file"});
}

// Ctrl+C, a terminal that is closed, a plain kill.
TEST(ExportEnds, BeingAskedToStopLeavesNothing) {
    for (const int signal : {SIGINT, SIGHUP, SIGTERM}) {
        const test::TemporaryFolder folder;
        const auto before = std::signal(signal, SIG_DFL);  // the tests may run under nohup themselves
        // Some seconds of work: 81 million numbers as text.
        const auto done =
            test::runAndInterrupt({"export", "pyramid", "-o", folder / "out", "--size", "3000x3000", "--buffers",
                                   "position,normal,view_vector", "--format", "csv", "--set", "camera.scale=6"},
                                  300, signal);
        std::signal(signal, before);
        EXPECT_EQ(done.status, 130);
        // A busy machine may still be reading the scene.
        EXPECT_TRUE(done.err == "Cancelled. Nothing was written.\n" || done.err == "Cancelled.\n") << done.err;
        EXPECT_EQ(folder.names(), std::vector<std::string>{});
    }
}

// As on a full disk: told, with its status, and nothing half written.
TEST(ExportEnds, ALimitOfAFilesSizeIsStatus4) {
    const test::TemporaryFolder folder;
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    const rlimit small{10000, before.rlim_max};  // the program takes it over
    setrlimit(RLIMIT_FSIZE, &small);
    const auto done = run({"export", "pyramid", "-o", folder / "out", "--buffers", "depth", "--format", "npy"});
    setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_EQ(done.status, 4);
    EXPECT_NE(done.err.find("depth.npy: could not write: File too large\n"), std::string::npos) << done.err;
    EXPECT_EQ(folder.names(), std::vector<std::string>{});
}

// As nohup has it.
TEST(ExportEnds, ASignalThatIsIgnoredStopsNothing) {
    const test::TemporaryFolder folder;
    const auto before = std::signal(SIGHUP, SIG_IGN);  // the program takes this over
    const auto done =
        test::runAndInterrupt({"export", "pyramid", "-o", folder / "out", "--size", "2000x2000", "--buffers",
                               "position,normal", "--format", "csv", "--set", "camera.scale=4"},
                              100, SIGHUP);
    std::signal(SIGHUP, before);
    EXPECT_EQ(done.status, 0) << done.err;
    EXPECT_TRUE(fs::exists(folder / "out/position.csv"));
}

// opengl draws OpenGL's model alone; the pyramid has Phong's.
TEST(ExportEnds, AFormatThatCannotHoldTheSceneIsLeftOutWithARemark) {
    const test::TemporaryFolder folder;
    const auto out = folder / "out";
    const auto done = run({"export", "pyramid", "-o", out, "--buffers", "color", "--format", "csv,opengl"});
    EXPECT_EQ(done.status, 0) << done.err;
    EXPECT_NE(done.err.find("left out: --format opengl: "), std::string::npos) << done.err;
    EXPECT_TRUE(fs::exists(out / "color.csv"));
    EXPECT_FALSE(fs::exists(out / "pyramid.gl.c"));
    // Where nothing is left to write, the command is wrong.
    EXPECT_EQ(run({"export", "pyramid", "-o", folder / "none", "--format", "opengl"}).status, 2);
    EXPECT_FALSE(fs::exists(folder / "none"));
}

}  // namespace
