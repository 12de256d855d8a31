#include "lessons/expression/value.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lessons {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(ValueText, HasUpToFourDecimalsUnlessTheCountIsGiven) {
    EXPECT_EQ(toText({{175.0}, {}}), "175");
    EXPECT_EQ(toText({{0.77459666}, {}}), "0.7746");
    EXPECT_EQ(toText({{0.9}, {}}), "0.9");
    EXPECT_EQ(toText({{100.00001}, {}}), "100");
    EXPECT_EQ(toText({{0.77459666}, {}}, 1), "0.8");
    EXPECT_EQ(toText({{175.0}, {}}, 3), "175.000");
}

TEST(ValueText, GroupsOfThreeStandApartBeforeThePointOnly) {
    EXPECT_EQ(toText({{-1991.6384}, {}}, 4), "\u22121\u202f991.6384");
    EXPECT_EQ(toText({{1234567.0}, {}}), "1\u202f234\u202f567");
    EXPECT_EQ(toText({{999.0}, {}}), "999");
}

TEST(ValueText, WhatRoundsToZeroHasNoSign) { EXPECT_EQ(toText({{-0.0004}, {}}, 3), "0.000"); }

TEST(ValueText, WholeComponentsOfAVectorStayShort) {
    EXPECT_EQ(toText({{0, 0.8944272, -0.4472136}, {}}, 3), "(0, 0.894, \u22120.447)");
}

TEST(ValueText, WordsAndNumbersThatAreNotFinite) {
    EXPECT_EQ(toText({{}, "back-facing"}, 3), "back-facing");
    EXPECT_EQ(toText({{kInfinity}, {}}), "+∞");
    EXPECT_EQ(toText({{-kInfinity}, {}}), "\u2212∞");
    EXPECT_EQ(toText({{std::nan("")}, {}}), "NaN");
}

TEST(NumberIn, TakesWhatPeopleType) {
    EXPECT_EQ(numberIn(" 0.669 "), 0.669);
    EXPECT_EQ(numberIn("0,669"), 0.669);
    EXPECT_EQ(numberIn("-4e-3"), -0.004);
    EXPECT_EQ(numberIn("\u2212"
                       "4"),
              -4.0);
    EXPECT_EQ(numberIn("+4"), 4.0);
    EXPECT_EQ(numberIn(toText({{-1991.5}, {}})), -1991.5) << "and what the program writes, with its groups of digits";
}

TEST(NumberIn, RefusesWhatIsNoFiniteNumber) {
    for (const char* text : {"", "  ", "four", "4 px", "1e999", "nan", "inf", "+-4", "1.2.3", "0x10"})
        EXPECT_FALSE(numberIn(text)) << text;
}

}  // namespace
}  // namespace lessons
