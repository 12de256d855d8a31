#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <string>

namespace {

// What the expression's parenthesis matches first in a file of the project.
std::string firstIn(const std::string& file, const std::string& expression) {
    std::ifstream in(std::string(SHADESCOPE_ROOT) + '/' + file);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    std::smatch match;
    return std::regex_search(text, match, std::regex(expression)) ? match.str(1) : "";
}

TEST(Version, IsTheSameWhereverItStands) {
    const std::string version = firstIn("CMakeLists.txt", R"(project\(shadescope VERSION (\S+))");
    ASSERT_NE(version, "");
    EXPECT_EQ(firstIn("CITATION.cff", "\nversion: (\\S+)"), version);
    EXPECT_EQ(firstIn("CHANGELOG.md", "\n## ([0-9.]+)"), version);
    EXPECT_EQ(firstIn("resources/desktop/shadescope.metainfo.xml", "<release version=\"([^\"]+)\""), version);
}

}  // namespace
