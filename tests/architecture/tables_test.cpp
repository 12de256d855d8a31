#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "pipeline/core/stage.h"

// One search for a stage's name finds its files, its row and its test.
namespace {

// "z-buffer" stands in z_buffer.h and z_buffer.cpp.
std::string fileStem(std::string_view stage) {
    std::string stem(stage);
    std::ranges::replace(stem, '-', '_');
    return stem;
}

class StageFiles : public testing::TestWithParam<pipeline::StageId> {};

TEST_P(StageFiles, AreNamedAsItsRow) {
    const std::filesystem::path root = SHADESCOPE_ROOT;
    const std::string stem = fileStem(pipeline::stageInfo(GetParam()).name);
    for (const std::string& path : {"pipeline/stages/" + stem + ".h", "pipeline/stages/" + stem + ".cpp",
                                    "tests/unit/stages/" + stem + "_test.cpp"}) {
        EXPECT_TRUE(std::filesystem::is_regular_file(root / path)) << path << " is missing";
    }
}

INSTANTIATE_TEST_SUITE_P(Tables, StageFiles, testing::ValuesIn(pipeline::kStages),
                         [](const auto& stage) { return fileStem(pipeline::stageInfo(stage.param).name); });

}  // namespace
