#include "pipeline/core/text.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <vector>

namespace pipeline {
namespace {

TEST(ShortestText, ReadsBackAsTheSameDouble) {
    for (const double value : {0.1, 1.0 / 3, 2.5e-17, 123456789.0, 6.02e23, -0.75, 99999999.5,
                               std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max()})
        EXPECT_EQ(std::strtod(shortestText(value).c_str(), nullptr), value) << shortestText(value);
}

TEST(ShortestText, WritesWholeNumbersAndPowersPlainly) {
    EXPECT_EQ(shortestText(640), "640");
    EXPECT_EQ(shortestText(100000), "100000");
    EXPECT_EQ(shortestText(1e9), "1e9");
    EXPECT_EQ(shortestText(1e-9), "1e-9");
    EXPECT_EQ(shortestText(0.25), "0.25");
}

TEST(InQuotes, KeepsAMessageOnOneLineAndUtf8Whole) {
    EXPECT_EQ(inQuotes("a\nb\x1b[31m"), "\"a?b?[31m\"");
    // 59 letters, then a character of two bytes: it does not fit and goes as a whole.
    EXPECT_EQ(inQuotes(std::string(59, 'x') + "ρ!"), '"' + std::string(59, 'x') + "…\"");
}

TEST(EditDistance, CountsChangesAdditionsAndRemovals) {
    EXPECT_EQ(editDistance("kitten", "sitting"), 3u);  // k→s, e→i, +g
    EXPECT_EQ(editDistance("", "abc"), 3u);
    EXPECT_EQ(editDistance("abc", "abc"), 0u);
}

TEST(Nearest, TakesTheFirstOfEquals) {
    const std::vector<std::string> names{"depth", "death", "color"};
    EXPECT_EQ(nearest("colour", names), "color");
    EXPECT_EQ(nearest("depth", names), "depth");
    EXPECT_EQ(nearest("deth", names), "depth");  // one letter away from both
    EXPECT_EQ(nearest("x", {}), "");
}

}  // namespace
}  // namespace pipeline
