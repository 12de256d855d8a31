#include "app/look/numbers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/canvas/buffer_image.h"
#include "app/document/scene_outline.h"
#include "app/look/number_format.h"
#include "app/widgets/elided_label.h"
#include "tests/support/scenes.h"

namespace {

std::string utf8(const QString& text) { return text.toStdString(); }

}  // namespace

TEST(Numbers, GroupsOfThreeStandBeforeThePointOnly) {
    EXPECT_EQ(utf8(app::number(-1991.6, 1)), "−1\u2009991.6");
    EXPECT_EQ(utf8(app::number(999.12345, 5)), "999.12345");
    EXPECT_EQ(utf8(app::count(4294967295)), "4\u2009294\u2009967\u2009295");
    EXPECT_EQ(utf8(app::count(2686)), "2\u2009686");
}

// 1234 stands in 51234 and in 12345 too; the digits after a point are no whole number.
TEST(Numbers, EveryNumberOfATextHasItsGroups) {
    EXPECT_EQ(utf8(app::withGroups("1234 of 51234 polygons; 12345 of 1024², 1234567.12345 s")),
              "1\u2009234 of 51\u2009234 polygons; 12\u2009345 of 1\u2009024², 1\u2009234\u2009567.12345 s");
    EXPECT_EQ(utf8(app::withGroups("3 of 5 polygons kept")), "3 of 5 polygons kept");
    EXPECT_EQ(utf8(app::withGroups("")), "");
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

TEST(Numbers, ASignOfNumbersIsAMinusNoHyphen) {
    EXPECT_EQ(utf8(app::sixDigits(-0.25)), "−0.25");
    EXPECT_EQ(utf8(app::sixDigits(1234567)), "1.23457e+06");
    EXPECT_EQ(utf8(app::sixDigits(-0.0)), "0");
}

TEST(Numbers, FullPrecisionReadsBackTheSame) {
    for (const double value : {0.1, 1.0 / 3, 671.45391845703125, -1e-300, 0.0})
        EXPECT_EQ(app::fullPrecision(value).toDouble(), value);
}

namespace {

using Format = app::NumberFormat;

std::string in(const Format& format, double value, int characters = 0) {
    return utf8(app::written(format, value, characters).value_or("as stored"));
}

}  // namespace

// Ends of a range that their decimals would round to 0 are told in powers of ten.
TEST(ValueText, ASmallNumberIsNotZero) {
    const std::vector<float> none;
    const pipeline::AnyBuffer buffer{{pipeline::BufferId::Specular, 0},
                                     &pipeline::bufferInfo(pipeline::BufferId::Specular),
                                     {0, 0, 3},
                                     std::span(none),
                                     nullptr};
    EXPECT_EQ(app::valueText(buffer, 3e-4), "3.0e-4");
    EXPECT_EQ(app::valueText(buffer, -3e-4), QString(QChar(0x2212)) + "3.0e-4");
    EXPECT_EQ(app::valueText(buffer, 6e-4), "0.001");
    EXPECT_EQ(app::valueText(buffer, 0), "0.000");
}

TEST(NumberFormat, LeavesTheDigitsToTheNumberUnlessAskedForOthers) {
    EXPECT_EQ(in({}, 0.5), "as stored");
    EXPECT_EQ(in({}, NAN), "as stored");
    EXPECT_EQ(in({Format::Form::Fixed, 3, {}}, 1234.5), "1\u2009234.500");
    EXPECT_EQ(in({Format::Form::Scientific, 3, {}}, -1234.6), "−1.235e3");
    EXPECT_EQ(in({Format::Form::Scientific, 3, {}}, 0), "0");
    EXPECT_EQ(in({Format::Form::Fixed, 3, {}}, INFINITY), "+∞");
}

// 0.1f = 0x1.99999a · 2^-4: its 23 bits after the point are six hexadecimal digits, the last of them even.
TEST(NumberFormat, HexadecimalHasEveryBit) {
    const Format hex{Format::Form::Hexadecimal, 2, {}};
    EXPECT_EQ(in(hex, 0.75), "0x1.8p-1");
    EXPECT_EQ(in(hex, double(0.1f)), "0x1.99999ap-4");
    EXPECT_EQ(in(hex, double(0.1f), 8), "0x1.99999ap-4");
    EXPECT_EQ(in(hex, -0.0), "−0x0p+0");
    EXPECT_EQ(in(hex, -INFINITY), "−∞");
}

// At 10^4 the number has its power, beside it not; below 10^-4 too, at it not. 0 has none.
TEST(NumberFormat, PowersOfTenStandBeyondTheChosenOne) {
    const Format format{Format::Form::Fixed, 2, 4};
    EXPECT_EQ(in(format, 9999.99), "9\u2009999.99");
    EXPECT_EQ(in(format, 10000), "1.00e4");
    EXPECT_EQ(in(format, 0.0001), "0.00");
    EXPECT_EQ(in(format, 0.00009), "9.00e-5");
    EXPECT_EQ(in(format, 0), "0.00");
    EXPECT_EQ(in({Format::Form::AsStored, 2, 4}, -123456), "−1.23e5");
    EXPECT_EQ(in({Format::Form::AsStored, 2, 4}, 0.5), "as stored");
}

// "−1.2346e-5" has 10 characters; 8 are left with two digits.
TEST(NumberFormat, LeavesOutDigitsWhereThereIsLittleRoom) {
    EXPECT_EQ(in({Format::Form::Scientific, 4, {}}, -1.23456e-5), "−1.2346e-5");
    EXPECT_EQ(in({Format::Form::Scientific, 4, {}}, -1.23456e-5, 8), "−1.23e-5");
    EXPECT_EQ(in({Format::Form::Fixed, 6, {}}, 671.4539, 8), "671.4539");
}

// A strip of 1 000 squares: 2 · 1 001 vertices.
TEST(SceneOutline, CountsStandInGroups) {
    std::vector<pipeline::Vec3d> positions;
    std::vector<std::vector<std::uint32_t>> polygons;
    for (std::uint32_t i = 0; i <= 1000; ++i) {
        positions.insert(positions.end(), {{i, 0, 0}, {i, 1, 0}});
        if (i > 0) polygons.push_back({2 * i - 2, 2 * i, 2 * i + 1, 2 * i - 1});
    }
    pipeline::Scene scene = test::pyramid();
    scene.objects[0].mesh = test::mesh(std::move(positions), polygons);
    EXPECT_EQ(utf8(app::outline(scene)[1].detail), "2\u2009002 vertices, 1\u2009000 polygons");
}

// Rather no word than a piece of one.
TEST(ElidedLabel, PhrasesStandWholeOrNotAtAll) {
    const QFont font;
    const QFontMetrics metrics(font);
    const QString words = "sRGB, row 0 on top";
    const int all = metrics.horizontalAdvance(words), first = metrics.horizontalAdvance("sRGB");
    EXPECT_EQ(app::wholePhrases(words, metrics, all), words);
    EXPECT_EQ(app::wholePhrases(words, metrics, all - 1), "sRGB");
    EXPECT_EQ(app::wholePhrases(words, metrics, first), "sRGB");
    EXPECT_EQ(app::wholePhrases(words, metrics, first - 1), "");
}
