// What the manual names is there.
#include <gtest/gtest.h>

#include <fstream>
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
    // A row: | notion | `scene` | stage | where to look |
    for (std::string line; std::getline(page, line);) {
        const auto begin = line.find("| `"), end = line.find("` |", begin + 3);
        if (!line.starts_with("| ") || begin == line.npos || end == line.npos || begin != line.find('|', 1)) continue;
        const std::string scene = line.substr(begin + 3, end - begin - 3);
        EXPECT_TRUE(there.contains(scene)) << scene << " is not a built-in scene";
        named.insert(scene);
    }
    EXPECT_GT(named.size(), 14u);
}

}  // namespace
}  // namespace pipeline
