// What the manual names is there.
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>
#include <string>

#include "pipeline/formats/built_in_scenes.h"

namespace pipeline {
namespace {

// Every scene of the table of notions is a built-in one.
TEST(Manual, TheTableOfNotionsNamesScenesThatAreThere) {
    std::set<std::string> there, named;
    for (const BuiltInScene& scene : builtInScenes()) there.insert(scene.name);
    std::ifstream page(resourceFolder() / "manual" / "lectures.md");
    ASSERT_TRUE(page);
    const std::regex row(R"(\| [^|]+ \| `(\w+)` \|.*)");
    for (std::string line; std::getline(page, line);) {
        std::smatch match;
        if (!std::regex_match(line, match, row)) continue;
        EXPECT_TRUE(there.contains(match[1])) << match[1] << " is not a built-in scene";
        named.insert(match[1]);
    }
    EXPECT_GT(named.size(), 14u);
}

}  // namespace
}  // namespace pipeline
