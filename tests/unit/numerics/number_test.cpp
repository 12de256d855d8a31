// Numbers in texts: what is one, and that both ways of reading it agree.
#include "pipeline/core/number.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

namespace pipeline {
namespace {

TEST(ReadNumber, TakesTheWholeTextOrNothing) {
    EXPECT_EQ(readNumber("0.5"), 0.5);
    EXPECT_EQ(readNumber("-1e3"), -1000);
    EXPECT_EQ(readNumber(".25"), 0.25);
    EXPECT_EQ(readNumber("3."), 3);
    for (const char* text : {"", "-", ".", "+1", " 1", "1 ", "1e", "0x10", "1,5", "1e999", "1e-999", "e5", "--1"})
        EXPECT_FALSE(readNumber(text)) << text;
}

TEST(ReadNumber, LeadingNumberEndsWhereTheNumberDoes) {
    const auto length = [](std::string_view text) { return leadingNumber(text).length; };
    EXPECT_EQ(length("12*3"), 2u);
    EXPECT_EQ(length("1e+4)"), 4u);
    EXPECT_EQ(length("1e)"), 1u) << "an exponent without digits is none";
    EXPECT_EQ(length("1..4"), 2u);
    EXPECT_EQ(length("x"), 0u);
    EXPECT_FALSE(leadingNumber("1e999").fits);
    EXPECT_EQ(length("1e999 "), 5u);
}

// The independent reference is each other: glibc's strtod and libstdc++'s from_chars are different code.
TEST(ReadNumber, StrtodReadsTheSameBits) {
    const auto agree = [](const std::string& text) {
        const LeadingNumber a = leadingNumber(text), b = leadingNumberByStrtod(text);
        EXPECT_EQ(a.length, b.length) << text;
        EXPECT_EQ(a.fits, b.fits) << text;
        EXPECT_EQ(std::bit_cast<std::uint64_t>(a.value), std::bit_cast<std::uint64_t>(b.value)) << text;
    };
    for (const char* text : {"",
                             "-",
                             "-.",
                             "1.e5",
                             "1.e",
                             "0x1p3",
                             "infinity",
                             "-inf",
                             "INFx",
                             " 1",
                             "1e400",
                             "-1e-400",
                             "4.9e-324",
                             "2.4e-324",
                             "2.5e-324",
                             "1e-310",
                             "1.7976931348623159e308",
                             "9007199254740993",
                             "-0",
                             "0e5",
                             "00012",
                             "1e00000000000000000005",
                             "1E5",
                             "1e5.5",
                             "+5"})
        agree(text);
    std::mt19937_64 random(7);
    for (int i = 0; i < 2000; ++i) {
        const auto value = std::bit_cast<double>(random());
        if (!(value - value == 0)) continue;
        char digits[64];
        const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
        agree(std::string(digits, end));
        EXPECT_EQ(readNumber(std::string_view(digits, std::size_t(end - digits))), value);
    }
}

}  // namespace
}  // namespace pipeline
