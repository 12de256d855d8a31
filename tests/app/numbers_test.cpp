#include "app/core/numbers.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

std::string utf8(const QString& text) { return text.toStdString(); }

}  // namespace

TEST(Numbers, GroupsOfThreeStandBeforeThePointOnly) {
    EXPECT_EQ(utf8(app::number(-1991.6, 1)), "−1\u2009991.6");
    EXPECT_EQ(utf8(app::number(999.12345, 5)), "999.12345");
    EXPECT_EQ(utf8(app::count(4294967295)), "4\u2009294\u2009967\u2009295");
    EXPECT_EQ(utf8(app::count(2686)), "2\u2009686");
}

TEST(Numbers, WhatIsNoNumberIsAWord) {
    EXPECT_EQ(utf8(app::number(NAN, 3)), "NaN");
    EXPECT_EQ(utf8(app::depth(INFINITY)), "+∞");
    EXPECT_EQ(utf8(app::intensity(-INFINITY)), "−∞");
}

TEST(Numbers, RoundedZeroHasNoSign) {
    EXPECT_EQ(utf8(app::intensity(-0.0002)), "0.000");
    EXPECT_EQ(utf8(app::component(-0.0)), "0");
}

TEST(Numbers, VectorsWriteExactZeroAndOneShort) {
    EXPECT_EQ(utf8(app::vectorText(0, 0.8944271, 0.4472135)), "(0, 0.894, 0.447)");
    EXPECT_EQ(utf8(app::vectorText(-1, 0, 0.9999999)), "(−1, 0, 1.000)");
}

// A float has 24 bits: beside 671 neighbours are 2^-14 = 6.1e-5 apart, beside 1000 the same,
// beside 0.5 2^-24 = 6e-8. A double beside 671: 2^-43 = 1.1e-13, and 12 digits are enough to read.
TEST(Numbers, DepthHasTheDigitsOfItsFormat) {
    EXPECT_EQ(utf8(app::depth(671.45391)), "671.4539");
    EXPECT_EQ(utf8(app::depth(1000)), "1\u2009000.0000");
    EXPECT_EQ(utf8(app::depth(0.5)), "0.5000000");
    EXPECT_EQ(app::depth(671.45391, true).section('.', 1).size(), 12);
}

TEST(Numbers, ErrorsHaveTwoDigitsAndTimesThree) {
    EXPECT_EQ(utf8(app::errorText(3.94e-6)), "3.9e-6");
    EXPECT_EQ(utf8(app::errorText(0)), "0");
    EXPECT_EQ(utf8(app::milliseconds(0.1614)), "0.161 ms");
    EXPECT_EQ(utf8(app::milliseconds(1.2345)), "1.23 ms");
    EXPECT_EQ(utf8(app::milliseconds(12.3456)), "12.3 ms");
    EXPECT_EQ(utf8(app::milliseconds(9.9996)), "10.0 ms");
    EXPECT_EQ(utf8(app::milliseconds(1234.5)), "1\u2009235 ms");
    EXPECT_EQ(utf8(app::angle(39.2315)), "39.2°");
}

TEST(Numbers, FullPrecisionReadsBackTheSame) {
    for (const double value : {0.1, 1.0 / 3, 671.45391845703125, -1e-300, 0.0})
        EXPECT_EQ(app::fullPrecision(value).toDouble(), value);
}
