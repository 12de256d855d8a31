// Arrangements of views: split, closed, named, as text, and in a room that is too small.
#include "lessons/state/view_tree.h"

#include <gtest/gtest.h>

#include "lessons/state/linked_views.h"

namespace lessons {
namespace {

using Kind = ViewTree::Kind;
constexpr ViewLeaf kA{ViewLeaf::Kind::Buffer, 0}, kB{ViewLeaf::Kind::Buffer, 1}, kC{ViewLeaf::Kind::Buffer, 2},
    kSpace{ViewLeaf::Kind::Space, 0};

ViewTree tree(std::string_view words) {
    const auto parsed = parseViewTree(words);
    EXPECT_TRUE(parsed) << words;
    return parsed ? *parsed : ViewTree();
}
std::string wrong(std::string_view words) {
    const auto parsed = parseViewTree(words);
    return parsed ? "" : parsed.errors().front().expected;
}

TEST(ViewTree, ItsTextReadsAsTheSameTree) {
    for (const char* words : {"buffer", "3d", "buffer | 3d", "612: buffer | 408: 3d",
                              "(buffer | buffer) / (buffer | 3d)", "buffer / buffer / (3: 3d | 1: (buffer / 3d))"}) {
        EXPECT_EQ(text(tree(words)), words);
        EXPECT_EQ(tree(text(tree(words))), tree(words));
    }
    EXPECT_EQ(text(tree(" 2:buffer|2 : ( 7: 3d )")), "buffer | 3d") << "equal weights say nothing";
}

TEST(ViewTree, LeavesAreNumberedAsTheyAreRead) {
    const ViewTree four = tree("(buffer | buffer) / (3d | buffer)");
    EXPECT_EQ(leavesOf(four), (std::vector{kA, kB, kSpace, kC}));
    EXPECT_EQ(neighbour(four, kC, 1), kA);
    EXPECT_EQ(neighbour(four, kA, -1), kC);
    EXPECT_EQ(neighbour(four, kB, 1), kSpace);
    EXPECT_EQ(neighbour(four, {ViewLeaf::Kind::Buffer, 7}, 1), kA);
    EXPECT_EQ(freeNumber(four, ViewLeaf::Kind::Buffer), 3);
    EXPECT_EQ(freeNumber(four, ViewLeaf::Kind::Space), 1);
}

TEST(ViewTree, ViewsThatAreThereKeepTheirNumbers) {
    ViewTree four = *arrangementNamed("four");
    renumber(four, ViewLeaf::Kind::Buffer, {3, 0});
    EXPECT_EQ(leavesOf(four), (std::vector{ViewLeaf{ViewLeaf::Kind::Buffer, 3}, kA, kB, kSpace}));
    EXPECT_FALSE(haveSameViews(four, *arrangementNamed("four")));
    EXPECT_TRUE(haveSameViews(tree("3: buffer | 1: 3d"), tree("buffer | 3d")));
}

TEST(ViewTree, WhatIsNoArrangementIsToldWithWhatWouldBe) {
    EXPECT_EQ(wrong(""), "a name, or buffer and 3d with | and / between them");
    EXPECT_EQ(wrong("buffr"), "a name, or buffer and 3d with | and / between them");
    EXPECT_EQ(wrong("buffer | 3d / buffer"), "parentheses where | and / meet");
    EXPECT_EQ(wrong("buffer |"), "a name, or buffer and 3d with | and / between them");
    EXPECT_EQ(wrong("(buffer | 3d"), "a closing parenthesis");
    EXPECT_EQ(wrong("buffer 3d"), "| or /, or the end");
    EXPECT_EQ(wrong("buffer | (buffer | 3d)"), "no parentheses around a row within a row");
    EXPECT_EQ(wrong("99999999999: buffer | 3d"), "a weight from 1 to 1000000");
    EXPECT_NE(wrong("0: buffer | 3d"), "");
    EXPECT_NE(wrong(std::string(100000, '(')), "") << "and does not fall over";
    std::string many = "buffer";
    for (int i = 1; i < 17; ++i) many += " | buffer";
    EXPECT_EQ(wrong(many), "at most 16 views");
}

TEST(ViewTree, NamesAreFoundAgainWhateverTheSizes) {
    for (const std::string& name : arrangementNames()) {
        const ViewTree named = *arrangementNamed(name);
        EXPECT_EQ(arrangementName(named), name);
        EXPECT_EQ(arrangementText(named), name);
        EXPECT_EQ(arrangementOf(name).value(), named);
    }
    const ViewTree wide = tree("3: buffer | 1: 3d");
    EXPECT_EQ(arrangementName(wide), "one");
    EXPECT_EQ(arrangementText(wide), "3: buffer | 1: 3d") << "its sizes are kept";
    EXPECT_EQ(arrangementName(tree("3d | buffer")), "") << "that is a free one";
    EXPECT_FALSE(arrangementNamed("five"));
    EXPECT_FALSE(arrangementOf("five"));
    EXPECT_TRUE(linksViews(*arrangementNamed("compare")) && linksViews(*arrangementNamed("four")));
    EXPECT_FALSE(linksViews(*arrangementNamed("two")));
}

// A half of a half beside a half: 2 : 1 : 1.
TEST(ViewTree, ASplitHalvesTheView) {
    ViewTree all = tree("buffer | 3d");
    ASSERT_TRUE(split(all, kSpace, Kind::Row, kB));
    EXPECT_EQ(text(all), "2: buffer | 1: 3d | 1: buffer");
    ASSERT_TRUE(split(all, kA, Kind::Column, kC));
    EXPECT_EQ(text(all), "2: (buffer / buffer) | 1: 3d | 1: buffer");
    EXPECT_EQ(leavesOf(all), (std::vector{kA, kC, kSpace, kB}));
    EXPECT_FALSE(split(all, {ViewLeaf::Kind::Space, 5}, Kind::Row, {})) << "it is not there";
    ViewTree one = tree("3d");
    ASSERT_TRUE(split(one, kSpace, Kind::Column, kA));
    EXPECT_EQ(text(one), "3d / buffer");
}

TEST(ViewTree, ThereIsAMostOfViews) {
    ViewTree all = tree("buffer");
    for (int i = 1; i < int(kMostViews); ++i)
        ASSERT_TRUE(
            split(all, {ViewLeaf::Kind::Buffer, i - 1}, i % 2 ? Kind::Row : Kind::Column, {ViewLeaf::Kind::Buffer, i}));
    EXPECT_FALSE(split(all, kA, Kind::Row, {ViewLeaf::Kind::Buffer, 16}));
    EXPECT_EQ(leavesOf(all).size(), kMostViews);
    EXPECT_EQ(parseViewTree(text(all)).value().parts.size(), 2u);
}

// Of 6 : 4 with 1 : 2 inside the 4, the inner ones take 4/3 and 8/3: 18 : 4 : 8, or 9 : 2 : 4.
TEST(ViewTree, ClosingGivesTheRoomToTheNeighboursAndFlattens) {
    ViewTree all = tree("6: buffer | 4: (buffer / (1: buffer | 2: 3d))");
    ASSERT_TRUE(close(all, kB));
    EXPECT_EQ(text(all), "9: buffer | 2: buffer | 4: 3d");
    ASSERT_TRUE(close(all, kA));
    EXPECT_EQ(text(all), "2: buffer | 4: 3d");
    ASSERT_TRUE(close(all, kC));
    EXPECT_EQ(text(all), "3d");
    EXPECT_FALSE(close(all, kSpace)) << "the only view stays";
    EXPECT_FALSE(close(all, kA));
}

TEST(ViewTree, AViewCanBecomeAnother) {
    ViewTree all = tree("buffer | 3d");
    ASSERT_TRUE(replace(all, kSpace, kB));
    EXPECT_EQ(arrangementName(all), "compare");
    EXPECT_FALSE(replace(all, kSpace, kB));
}

TEST(LinkedViews, TheUserChoosesElseTheArrangement) {
    EXPECT_TRUE(areLinked(*arrangementNamed("compare"), {}));
    EXPECT_TRUE(areLinked(*arrangementNamed("four"), {}));
    EXPECT_FALSE(areLinked(*arrangementNamed("two"), {}));
    EXPECT_FALSE(areLinked(*arrangementNamed("compare"), false));
    EXPECT_TRUE(areLinked(*arrangementNamed("two"), true));
}

TEST(LinkedViews, PicturesOfTheSamePixelsMoveTogether) {
    EXPECT_TRUE(moveTogether({640, 480}, {640, 480}));
    EXPECT_FALSE(moveTogether({640, 480}, {480, 640}));
    EXPECT_FALSE(moveTogether({1024, 1024, true}, {1024, 1024})) << "a texel is no pixel, whatever the sizes";
    EXPECT_FALSE(moveTogether({}, {})) << "there is no picture";
}

// Two columns, the first of two views: 2 * 240 + 8 wide, 2 * 180 + 8 high.
TEST(ViewTree, KnowsTheRoomThatItNeeds) {
    EXPECT_EQ(smallest(*arrangementNamed("two"), {240, 180}, 8), (ViewSize{488, 368}));
    EXPECT_EQ(smallest(*arrangementNamed("buffer"), {240, 180}, 8), (ViewSize{240, 180}));
}

TEST(ViewTree, WhereThereIsNoRoomTheLastViewsGo) {
    const ViewTree four = *arrangementNamed("four");
    const auto shown = [&](int width, int height) { return text(fitted(four, {width, height}, {240, 180}, 8)); };
    EXPECT_EQ(shown(488, 368), "(buffer | buffer) / (buffer | 3d)");
    EXPECT_EQ(shown(488, 367), "buffer | buffer");
    EXPECT_EQ(shown(487, 367), "buffer");
    EXPECT_EQ(shown(10, 10), "buffer") << "one always stays";
}

// Two views above each other need 2 · 180 + 8: the one beside them would give no height.
TEST(ViewTree, WhereHeightIsMissingTheViewBesideStays) {
    const ViewTree two = *arrangementNamed("two");
    EXPECT_EQ(text(fitted(two, {1000, 368}, {240, 180}, 8)), "(buffer / buffer) | 3d");
    EXPECT_EQ(text(fitted(two, {1000, 367}, {240, 180}, 8)), "buffer | 3d");
    EXPECT_EQ(text(fitted(two, {487, 368}, {240, 180}, 8)), "buffer / buffer") << "where width is, it goes";
}

}  // namespace
}  // namespace lessons
