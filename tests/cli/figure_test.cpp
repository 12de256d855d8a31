// A buffer as a figure, and "-" where a file is expected.
#include <gtest/gtest.h>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"

namespace {

using test::has;
using test::run;

TEST(FigureCommand, WritesTheFormatOfTheEnding) {
    const test::TemporaryFolder folder;
    for (const auto& [name, begin] :
         {std::pair("f.svg", "<?xml"), std::pair("f.pdf", "%PDF-"), std::pair("f.png", "\x89PNG")}) {
        const auto done =
            run({"figure", "pyramid", "-B", "z_view", "--pixel", "268,281", "--width", "84mm", "-o", folder / name});
        EXPECT_EQ(done.status, 0) << done.err;
        EXPECT_TRUE(has(done.err, "84.0 × ")) << done.err;
        EXPECT_TRUE(test::readText(folder / name).starts_with(begin));
    }
}

TEST(FigureCommand, ADashIsStandardOutput) {
    const auto done = run({"figure", "pyramid", "-o", "-"});
    EXPECT_EQ(done.status, 0);
    EXPECT_TRUE(done.out.starts_with("<?xml"));
    EXPECT_TRUE(done.out.ends_with("</svg>\n"));
    EXPECT_TRUE(has(done.err, "standard output"));
}

TEST(FigureCommand, ABufferThatIsMadeOfAFrameHasOneToo) {
    const auto done = run({"figure", "pyramid", "-B", "mix", "--mix", "ambient=solo", "-o", "-"});
    EXPECT_EQ(done.status, 0) << done.err;
    EXPECT_TRUE(done.out.starts_with("<?xml"));
}

TEST(FigureCommand, SaysWhatIsWrongBeforeItWrites) {
    const test::TemporaryFolder folder;
    const std::string file = folder / "f.svg";
    const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
        {{"--pixel", "640,0"}, "inside 640 × 480"},
        {{"--part", "10,10,5,5"}, "inside 640 × 480"},
        {{"--range", "3,3"}, "two different numbers"},
        {{"--width", "0"}, "20 to 1000 mm"},
        {{"-B", "vertices.world"}, "no pixels"},
        {{"-B", "z_vieww"}, "z_view"},
        {{"-B", "shadow_buffer.0", "--edges"}, "no picture of the camera"},
        {{"--part", "0,0,9,9", "--pixel", "20,20"}, "outside --part"}};
    for (const auto& [options, words] : wrong) {
        std::vector<std::string> arguments{"figure", "pyramid", "-o", file};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const auto done = run(arguments);
        EXPECT_EQ(done.status, 2) << options[0];
        EXPECT_TRUE(has(done.err, words)) << done.err;
    }
    EXPECT_EQ(run({"figure", "pyramid", "-o", folder / "f.tif"}).status, 2);
    EXPECT_EQ(folder.names(), std::vector<std::string>{});
}

// Several files, or what is not written as a stream: told, and no folder called "-".
TEST(FigureCommand, ADashIsNoFolder) {
    const std::vector<std::vector<std::string>> commands{
        {"export", "pyramid", "-o", "-"}, {"film", "pyramid", "-o", "-"}, {"lesson", "export", "pyramid", "-o", "-"}};
    for (const auto& arguments : commands) {
        const auto done = run(arguments);
        EXPECT_EQ(done.status, 2) << arguments[0];
        EXPECT_TRUE(has(done.err, "- is standard output")) << done.err;
    }
}

TEST(FigureCommand, AnIndexOfOneElementIsNoRange) {
    const auto done = run({"plan", "pyramid", "--set", "material.3.ks=1"});
    EXPECT_TRUE(has(done.err, "expected material 0\n")) << done.err;
}

}  // namespace
