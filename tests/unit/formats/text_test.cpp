#include "pipeline/core/text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "pipeline/core/printable.h"
#include "pipeline/core/result.h"

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

// A number that is refused beside the bound that it passes: three digits, and more where those would read as the bound.
TEST(TextBeyond, ReadsAsAnotherNumberThanTheBound) {
    EXPECT_EQ(textBeyond(1.2734e9, 1e9), "1.27e9");
    EXPECT_EQ(textBeyond(1000000100.0, 1e9), "1000000100") << "the eighth digit is the first that differs";
    EXPECT_EQ(textBeyond(-1000000100.0, -1e9), "-1000000100");
    EXPECT_EQ(textBeyond(std::nextafter(1e9, 2e9), 1e9), "1000000000.0000001") << "2^-23 more, the next double";
    EXPECT_EQ(textBeyond(std::numeric_limits<double>::quiet_NaN(), 1e9), "nan");
    EXPECT_EQ(textBeyond(std::numeric_limits<double>::infinity(), 1e9), "inf");
}

TEST(InQuotes, KeepsAMessageOnOneLineAndUtf8Whole) {
    EXPECT_EQ(inQuotes("a\nb\x1b[31m"), "\"a\\x0ab\\x1b[31m\"");
    // 59 letters, then a character of two bytes: it does not fit and goes as a whole.
    const std::string kept(59, 'x');
    EXPECT_EQ(inQuotes(kept + "ρ!"), fmt::format("\"{}…\"", kept));
}

// U+009B is C1's start of a command, U+202E turns the direction of writing, U+200B takes no room.
TEST(Escaped, LeavesNothingThatATerminalObeys) {
    EXPECT_EQ(escaped("plain, ρ — 日本 \\x1b"), "plain, ρ — 日本 \\x1b");
    EXPECT_EQ(escaped("a\x1b[31mb\nc\t\x7f"), "a\\x1b[31mb\\x0ac\\x09\\u007f");
    EXPECT_EQ(escaped("\xc2\x9b\xe2\x80\xae\xe2\x80\x8b\xef\xbb\xbf"), "\\u009b\\u202e\\u200b\\ufeff");
    EXPECT_EQ(escaped("\xff\xc3|\xed\xa0\x80|\xc0\xaf"), "\\xff\\xc3|\\xed\\xa0\\x80|\\xc0\\xaf") << "no UTF-8";
    EXPECT_EQ(escaped(std::string_view("\0", 1)), "\\x00");
    EXPECT_EQ(escapedLines("a\nb\tc\rd"), "a\nb\tc\\x0dd");
    EXPECT_EQ(escaped(escaped("\x1b")), escaped("\x1b")) << "once is enough";
}

// U+200C joins no letters in Persian, U+200F turns the direction in Arabic.
TEST(Escaped, LeavesProseTheMarksThatLanguagesNeed) {
    EXPECT_EQ(escapedControls("a\xe2\x80\x8c\xe2\x80\x8f\r\n\tb"), "a\xe2\x80\x8c\xe2\x80\x8f\r\n\tb");
    EXPECT_EQ(escapedControls("a\x1b[31m\xc2\x9b\xff"), "a\\x1b[31m\\u009b\\xff");
}

TEST(ErrorText, IsALineWhateverIsInIt) {
    const Error error{{"a\nb", 2, 3}, "this is not TOML: \"tr\nx\x1b[31m\"", "a\nline"};
    EXPECT_EQ(format(error), "a\\x0ab:2:3: this is not TOML: \"tr\\x0ax\\x1b[31m\", expected a\\x0aline");
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

// "camra" lacks one letter of six; "schema" shares three places with "camera" at best, and needs more than a third of its
// six letters changed.
TEST(InsteadOf, NamesWhatIsNearAndElseAllThatThereIs) {
    const std::vector<std::string> names{"camera", "light", "material.0.n"};
    EXPECT_EQ(insteadOf("camra", names), "the nearest is \"camera\"");
    EXPECT_EQ(insteadOf("lights_of_the_scene", names), "the nearest is \"light\"") << "it holds it";
    EXPECT_EQ(insteadOf("material", names), "the nearest is \"material.0.n\"") << "and is held";
    EXPECT_EQ(insteadOf("schema", names), "there are \"camera\", \"light\" and \"material.0.n\"");
    EXPECT_EQ(insteadOf("xyz", std::vector<std::string>{"depth"}), "there is \"depth\"");
    EXPECT_EQ(insteadOf("x", {}), "there is none");
}

// One letter of "axxx" and of "xbxx" is in its place, none of the others.
TEST(InsteadOf, OfManyNamesTheNearestThreeAndHowManyThereAre) {
    std::vector<std::string> many{"pppp", "qqqq", "axxx", "rrrr", "ssss", "xbxx",
                                  "tttt", "uuuu", "vvvv", "wwww", "yyyy"};
    EXPECT_EQ(insteadOf("abcd", many), "there are 11, the nearest are \"axxx\", \"xbxx\" and \"pppp\"");
    EXPECT_EQ(insteadOf("abcd", many, "plan"),
              "there are 11, the nearest are \"axxx\", \"xbxx\" and \"pppp\"; plan lists all");
    many.pop_back();
    EXPECT_TRUE(insteadOf("abcd", many, "plan").ends_with("\"vvvv\" and \"wwww\"")) << "ten are read in a line";
}

}  // namespace
}  // namespace pipeline
