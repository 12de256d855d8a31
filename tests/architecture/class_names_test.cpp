// Two classes of one name in one namespace are one to the linker, which then takes either's functions for both.
#include <gtest/gtest.h>

#include <map>
#include <regex>

#include "tests/architecture/source_tree.h"

namespace architecture {
namespace {

// "FILE:LINE: the name; where it stands already" for every class at the outermost level of a file of app/, that is at
// the first column, outside anonymous namespaces.
std::vector<std::string> sharedNames(const SourceTree& tree) {
    static const std::regex definition(R"(^(?:class|struct) (\w+)(?: final)?(?: :.*| \{.*)$)");
    std::map<std::string, std::string> places;
    std::vector<std::string> shared;
    for (const SourceFile& file : tree) {
        if (!file.path.starts_with("app/")) continue;
        bool isAnonymous = false;
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            const std::string& line = file.lines[i];
            if (line == "namespace {") isAnonymous = true;
            if (line == "}  // namespace") isAnonymous = false;
            std::smatch found;
            if (isAnonymous || !std::regex_match(line, found, definition)) continue;
            const std::string place = file.path + ':' + std::to_string(i + 1);
            if (const auto [before, isNew] = places.try_emplace(found[1], place); !isNew)
                shared.push_back(place + ": " + before->first + "; a class of this name stands at " + before->second);
        }
    }
    return shared;
}

TEST(Architecture, NoTwoClassesOfTheWindowAndTheCommandsShareAName) {
    const SourceFile job{"app/jobs/job.h", {"namespace app {", "class Job : public QObject {", "};"}};
    const auto planted = sharedNames({job, {"app/cli/job.h", {"", "struct Job {"}}});
    ASSERT_EQ(planted.size(), 1u);
    EXPECT_TRUE(planted[0].starts_with("app/cli/job.h:2:")) << planted[0];
    EXPECT_TRUE(sharedNames({job, {"app/cli/a.cpp", {"namespace {", "struct Job {", "}  // namespace"}}}).empty());
    EXPECT_TRUE(sharedNames({job, {"app/cli/a.h", {"class Job;"}}, {"pipeline/job.h", {"struct Job {"}}}).empty());
    for (const std::string& line : sharedNames(readSourceTree(SHADESCOPE_ROOT))) ADD_FAILURE() << line;
}

}  // namespace
}  // namespace architecture
