// The halves of a power in float, against long double.
#include "pipeline/core/power.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace pipeline {
namespace {

// Of a float: the distance to the next.
long double unitInTheLastPlace(float x) {
    int exponent;
    std::frexp(x, &exponent);
    return std::ldexp(1.0L, exponent - 24);
}

TEST(Power, LogOfOneMinusIsCloseToTheLastPlace) {
    EXPECT_EQ(logOneMinus(0.0F), 0);
    long double worst = 0;
    // Every 1009th float from the smallest normal one to the last below 1.
    for (std::uint32_t bits = 0x00800000; bits < 0x3f800000; bits += 1009) {
        const auto q = std::bit_cast<float>(bits);
        const float log = logOneMinus(q);
        worst = std::max(worst, std::abs(log - std::log1p(-static_cast<long double>(q))) / unitInTheLastPlace(log));
    }
    EXPECT_LT(worst, 1.2);
    const float last = std::bit_cast<float>(0x3f7fffffU);  // 1 - 2^-24
    EXPECT_NEAR(logOneMinus(last), -24 * std::log(2.0), 1e-6);
}

TEST(Power, ExpIsCloseToTheLastPlaceAndEndsIn0) {
    EXPECT_EQ(expOfNegative(0.0F), 1);
    EXPECT_EQ(expOfNegative(-0.0F), 1);
    long double worst = 0;
    for (std::uint32_t bits = 0x80000000; bits <= std::bit_cast<std::uint32_t>(-87.0F); bits += 1009) {
        const auto y = std::bit_cast<float>(bits);
        const float power = expOfNegative(y);
        worst = std::max(worst, std::abs(power - std::exp(static_cast<long double>(y))) / unitInTheLastPlace(power));
    }
    EXPECT_LT(worst, 1.2);
    EXPECT_EQ(expOfNegative(std::nextafter(-87.0F, -88.0F)), 0);
    EXPECT_EQ(expOfNegative(-std::numeric_limits<float>::infinity()), 0);
    EXPECT_EQ(expOfNegative(std::numeric_limits<float>::quiet_NaN()), 0);
}

}  // namespace
}  // namespace pipeline
