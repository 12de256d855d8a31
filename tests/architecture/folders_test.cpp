// A folder holds what belongs together, few enough files to be read as a list; a room has a line in CONTRIBUTING.md.
#include <gtest/gtest.h>

#include <map>

#include "tests/architecture/source_tree.h"

namespace architecture {
namespace {

constexpr int kMostFiles = 60;

// "FOLDER: what is wrong with it" for every folder of sources.
std::vector<std::string> badFolders(const SourceTree& tree) {
    std::map<std::string, int> files;
    std::string tableOfFolders;
    for (const SourceFile& file : tree) {
        if (file.path == "CONTRIBUTING.md")
            for (const std::string& line : file.lines)
                if (line.starts_with("| `")) tableOfFolders += line;
        const bool isCode = file.path.ends_with(".cpp") || file.path.ends_with(".h");
        if (isCode) ++files[file.path.substr(0, file.path.rfind('/'))];
    }
    std::vector<std::string> bad;
    for (const auto& [folder, count] : files) {
        const std::string last = folder.substr(folder.rfind('/') + 1) + "/`";
        const std::string above = folder.substr(0, folder.rfind('/')) + "/`";
        const bool isRoom =
            folder.starts_with("app/") || folder.starts_with("pipeline/") || folder.starts_with("lessons/");
        const bool hasLine = !isRoom || tableOfFolders.find('`' + folder + "/`") != std::string::npos ||
                             (tableOfFolders.find('`' + above) != std::string::npos &&
                              tableOfFolders.find('`' + last) != std::string::npos);
        if (count > kMostFiles) bad.push_back(folder + ": " + std::to_string(count) + " files");
        if (!hasLine) bad.push_back(folder + ": no line in CONTRIBUTING.md");
    }
    return bad;
}

TEST(Folders, AreFewFilesEachAndHaveALineInContributing) {
    SourceTree tree{{"CONTRIBUTING.md", {"| `app/look/` | themes; `small/` text |"}},
                    {"app/look/theme.h", {""}},
                    {"app/look/small/text.h", {""}}};
    EXPECT_TRUE(badFolders(tree).empty());
    tree.push_back({"tests/unit/job_test.cpp", {""}});
    tree.push_back({"app/jobs/job.h", {""}});
    EXPECT_EQ(badFolders(tree), std::vector<std::string>{"app/jobs: no line in CONTRIBUTING.md"});
    for (int i = 0; i < kMostFiles; ++i) tree.push_back({"app/look/" + std::to_string(i) + ".cpp", {""}});
    EXPECT_EQ(badFolders(tree).back(), "app/look: 61 files");
    for (const std::string& line : badFolders(readSourceTree(SHADESCOPE_ROOT))) ADD_FAILURE() << line;
}

}  // namespace
}  // namespace architecture
