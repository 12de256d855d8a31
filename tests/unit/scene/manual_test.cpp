// What the manual names is there.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

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

// The targets of "](…)" in a page, without what follows a #; addresses on the net and code left out.
std::vector<std::filesystem::path> linksOf(const std::filesystem::path& page) {
    std::ifstream file(page);
    EXPECT_TRUE(file) << page;
    std::vector<std::filesystem::path> links;
    const std::regex code("`[^`]*`");
    for (std::string text; std::getline(file, text);) {
        const std::string line = std::regex_replace(text, code, "");
        for (std::size_t at = line.find("]("); at != line.npos; at = line.find("](", at + 1)) {
            const std::string target = line.substr(at + 2, line.find_first_of(")#", at) - at - 2);
            if (!target.empty() && target.find("://") == target.npos) links.push_back(page.parent_path() / target);
        }
    }
    return links;
}

TEST(Manual, EveryLinkAndPictureIsThereAndEveryPageIsReached) {
    const std::filesystem::path manual = resourceFolder() / "manual";
    std::set<std::filesystem::path> reached{manual / "README.md"};
    std::vector<std::filesystem::path> waiting{manual / "README.md"};
    while (!waiting.empty()) {
        const std::filesystem::path page = waiting.back();
        waiting.pop_back();
        for (const std::filesystem::path& link : linksOf(page)) {
            EXPECT_TRUE(std::filesystem::exists(link)) << page << " names " << link;
            const std::filesystem::path target = link.lexically_normal();
            if (target.extension() == ".md" && reached.insert(target).second) waiting.push_back(target);
        }
    }
    for (const auto& entry : std::filesystem::directory_iterator(manual))
        EXPECT_TRUE(entry.path().extension() != ".md" || reached.contains(entry.path()))
            << "no page leads to " << entry.path();
}

}  // namespace
}  // namespace pipeline
