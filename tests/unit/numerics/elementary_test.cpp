// The functions of pipeline/core/elementary.h against the library's with 64 bits or more, whose own error of a unit in
// its last place is 2^-11 of one in double.
#include "pipeline/core/elementary.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <random>

#include "pipeline/core/angles.h"
#include "pipeline/core/power.h"
#include "tests/support/sweep.h"

namespace pipeline {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity(), kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kLibrary = 0x1p-10;  // what the reference itself may be off by, in units in the last place

// 20 000 arguments a case, two million in a long run.
int samples() { return test::longRun() ? 2'000'000 : 20'000; }

class Arguments {
public:
    double between(double low, double high) { return low + (high - low) * std::ldexp(double(m_random() >> 11), -53); }
    // Of any size, as often as another, with a sign.
    double spread(double leastExponent, double mostExponent) {
        return (m_random() & 1 ? -1 : 1) * std::exp2(between(leastExponent, mostExponent));
    }

private:
    std::mt19937_64 m_random{1};
};

// The largest error of ours(x, y), in units in the last place of the exact result. Results that are not normal are left
// out.
template <class Choose, class Ours, class Exact>
double largestError(Choose choose, Ours ours, Exact exact) {
    Arguments arguments;
    long double largest = 0;
    for (int i = 0; i < samples(); ++i) {
        const auto [x, y] = choose(arguments);
        const long double expected = exact(static_cast<long double>(x), static_cast<long double>(y));
        if (!(std::abs(expected) >= 0x1p-1022L && std::abs(expected) < 0x1p1023L)) continue;
        int exponent;
        std::frexp(expected, &exponent);
        largest = std::max(largest, std::abs(ours(x, y) - expected) / std::ldexp(1.0L, exponent - 53));
    }
    return double(largest);
}
using XY = std::array<double, 2>;

TEST(Elementary, SineAndCosineAreWithinTheirBounds) {
    const auto choose = [](Arguments& a) { return XY{a.between(-std::numbers::pi / 4, std::numbers::pi / 4), 0}; };
    const auto ours = [](auto of) { return [of](double x, double) { return of(x, 0); }; };
    EXPECT_LE(largestError(choose, ours(sinNearZero), [](auto x, auto) { return std::sin(x); }), 0.8 + kLibrary);
    EXPECT_LE(largestError(choose, ours(cosNearZero), [](auto x, auto) { return std::cos(x); }), 0.6 + kLibrary);
}

// Of degrees, whose factor to radians is not rounded: the exact value of a quarter turn's parts in long double.
TEST(Elementary, SineAndCosineOfDegreesAreWithinTheirBounds) {
    const auto choose = [](Arguments& a) { return XY{a.between(-45, 45), 0}; };
    const auto radians = [](long double x) { return x * (std::numbers::pi_v<long double> / 180); };
    EXPECT_LE(
        largestError(
            choose, [](double x, double) { return sinDegrees(x); }, [&](auto x, auto) { return std::sin(radians(x)); }),
        0.8 + 3 * kLibrary);
    EXPECT_LE(
        largestError(
            choose, [](double x, double) { return cosDegrees(x); }, [&](auto x, auto) { return std::cos(radians(x)); }),
        0.6 + 3 * kLibrary);
    // Niven's theorem: the only rational ones.
    EXPECT_EQ(sinDegrees(30), 0.5);
    EXPECT_EQ(cosDegrees(60), 0.5);
    EXPECT_EQ(sinDegrees(-150), -0.5);
}

TEST(Elementary, ExponentialsAreWithinTheirBounds) {
    for (const double range : {1.0, 40.0, 745.0}) {
        const auto choose = [&](Arguments& a) { return XY{a.between(-range, range), 0}; };
        EXPECT_LE(largestError(
                      choose, [](double x, double) { return exp(x); }, [](auto x, auto) { return std::exp(x); }),
                  0.75 + kLibrary)
            << range;
        EXPECT_LE(largestError(
                      choose, [](double x, double) { return exp2(x); }, [](auto x, auto) { return std::exp2(x); }),
                  0.75 + kLibrary)
            << range;
    }
    for (int i = -1074; i <= 1023; ++i) EXPECT_EQ(exp2(double(i)), std::ldexp(1.0, i)) << i;
}

TEST(Elementary, LogarithmsAreWithinTheirBounds) {
    const auto anywhere = [](Arguments& a) { return XY{std::abs(a.spread(-1074, 1024)), 0}; };
    const auto nearOne = [](Arguments& a) { return XY{1 + a.spread(-53, -1), 0}; };
    const auto log = [](double x, double) { return pipeline::log(x); };
    const auto log2 = [](double x, double) { return pipeline::log2(x); };
    const auto exactLog = [](auto x, auto) { return std::log(x); };
    const auto exactLog2 = [](auto x, auto) { return std::log2(x); };
    EXPECT_LE(largestError(anywhere, log, exactLog), 0.51 + kLibrary);
    EXPECT_LE(largestError(nearOne, log, exactLog), 0.51 + kLibrary);
    EXPECT_LE(largestError(anywhere, log2, exactLog2), 0.51 + kLibrary);
    EXPECT_LE(largestError(nearOne, log2, exactLog2), 0.51 + kLibrary);
    for (int i = -1074; i <= 1023; ++i) EXPECT_EQ(pipeline::log2(std::ldexp(1.0, i)), i);
}

TEST(Elementary, PowersAreWithinTheirBounds) {
    const auto exact = [](auto x, auto y) { return std::pow(x, y); };
    const auto ours = [](double x, double y) { return pow(x, y); };
    const auto anyPower = [](Arguments& a) { return XY{std::abs(a.spread(-1074, 1023)), a.spread(-10, 10)}; };
    const auto ofCosine = [](Arguments& a) { return XY{1 - std::abs(a.spread(-40, -1)), std::exp2(a.between(0, 40))}; };
    const auto whole = [](Arguments& a) { return XY{a.spread(-30, 30), std::floor(a.between(-30, 30))}; };
    EXPECT_LE(largestError(anyPower, ours, exact), 0.75 + kLibrary);
    EXPECT_LE(largestError(ofCosine, ours, exact), 0.75 + kLibrary);
    EXPECT_LE(largestError(whole, ours, exact), 0.75 + kLibrary);
}

TEST(Elementary, AnglesAreWithinTheirBounds) {
    const auto ours = [](double y, double x) { return atan2(y, x); };
    const auto exact = [](auto y, auto x) { return std::atan2(y, x); };
    const auto alike = [](Arguments& a) { return XY{a.between(-1, 1), a.between(-1, 1)}; };
    const auto anywhere = [](Arguments& a) { return XY{a.spread(-1000, 1023), a.spread(-1000, 1023)}; };
    EXPECT_LE(largestError(alike, ours, exact), 0.51 + kLibrary);
    EXPECT_LE(largestError(anywhere, ours, exact), 0.51 + kLibrary);
    const auto angle = [](double x, double) { return acos(x); };
    const auto exactAngle = [](auto x, auto) { return std::acos(x); };
    const auto cosine = [](Arguments& a) { return XY{a.between(-1, 1), 0}; };
    const auto nearOne = [](Arguments& a) { return XY{1 - std::abs(a.spread(-53, -1)), 0}; };
    const auto nearMinusOne = [](Arguments& a) { return XY{-1 + std::abs(a.spread(-53, -1)), 0}; };
    EXPECT_LE(largestError(cosine, angle, exactAngle), 0.51 + kLibrary);
    EXPECT_LE(largestError(nearOne, angle, exactAngle), 0.51 + kLibrary);
    EXPECT_LE(largestError(nearMinusOne, angle, exactAngle), 0.51 + kLibrary);
}

// pipeline/core/power.h: both ranges of a highlight in double.
TEST(Elementary, HalvesOfAPowerAreWithinTheirBounds) {
    const auto q = [](Arguments& a) { return XY{std::abs(a.spread(-1000, 0)), 0}; };
    const auto wide = [](Arguments& a) { return XY{a.between(0, 1), 0}; };
    const auto log = [](double x, double) { return logOneMinus(x); };
    const auto exactLog = [](auto x, auto) { return std::log1p(-x); };
    EXPECT_LE(largestError(q, log, exactLog), 0.9 + kLibrary);
    EXPECT_LE(largestError(wide, log, exactLog), 0.9 + kLibrary);
    const auto y = [](Arguments& a) { return XY{a.between(-708, 0), 0}; };
    EXPECT_LE(largestError(
                  y, [](double x, double) { return expOfNegative(x); }, [](auto x, auto) { return std::exp(x); }),
              0.75 + kLibrary);
    EXPECT_EQ(expOfNegative(-0.0), 1);
    EXPECT_EQ(expOfNegative(std::nextafter(-708.0, -709.0)), 0);
    EXPECT_EQ(expOfNegative(-kInfinity), 0);
    EXPECT_EQ(expOfNegative(kNaN), 0);
    EXPECT_EQ(logOneMinus(0.0), 0);
}

// Equal, both no numbers, or one unit apart where the exact result lies between two numbers.
void expectAlike(double ours, double library, const std::string& of) {
    if (std::isnan(library)) {
        EXPECT_TRUE(std::isnan(ours)) << of << " = " << ours;
    } else if (library == 0 || std::isinf(library)) {
        EXPECT_EQ(std::bit_cast<std::uint64_t>(ours), std::bit_cast<std::uint64_t>(library)) << of << " = " << ours;
    } else {
        EXPECT_GE(ours, std::nextafter(library, -kInfinity)) << of;
        EXPECT_LE(ours, std::nextafter(library, kInfinity)) << of;
    }
}

// ISO/IEC 9899, annex F, which the library keeps.
TEST(Elementary, SpecialValuesAreThoseOfC) {
    constexpr std::array kValues{0.0,
                                 -0.0,
                                 1.0,
                                 -1.0,
                                 0.5,
                                 -0.5,
                                 2.0,
                                 -2.0,
                                 3.0,
                                 -3.0,
                                 1e300,
                                 -1e300,
                                 1e-300,
                                 -1e-300,
                                 0x1p-1074,
                                 -0x1p-1074,
                                 709.5,
                                 -745.5,
                                 1024.0,
                                 -1074.0,
                                 -1076.5,
                                 0x1p53,
                                 0x1p53 + 2,
                                 -0x1p60,
                                 kNaN,
                                 kInfinity,
                                 -kInfinity,
                                 0x1.fffffffffffffp-1,
                                 0x1.0000000000001p0};
    for (const double x : kValues) {
        const std::string of = "(" + std::to_string(x);
        expectAlike(exp(x), std::exp(x), "exp" + of);
        expectAlike(exp2(x), std::exp2(x), "exp2" + of);
        expectAlike(pipeline::log(x), std::log(x), "log" + of);
        expectAlike(pipeline::log2(x), std::log2(x), "log2" + of);
        expectAlike(acos(x), std::acos(x), "acos" + of);
        for (const double y : kValues) {
            const std::string both = of + ", " + std::to_string(y);
            expectAlike(pow(x, y), std::pow(x, y), "pow" + both);
            expectAlike(atan2(x, y), std::atan2(x, y), "atan2" + both);
        }
    }
}

// Where the exact result is not within 2^-20 units of the middle between two floats, the one nearest to it.
TEST(Elementary, FloatIsRoundedFromDouble) {
    Arguments arguments;
    int close = 0;
    const auto expectNearest = [&](float ours, double exact, const char* of, float x, float y) {
        if (!(std::abs(exact) >= double(std::numeric_limits<float>::min()) && std::abs(exact) < 0x1p127)) return;
        int exponent;
        std::frexp(exact, &exponent);
        const double units = std::ldexp(exact, 24 - exponent), off = std::abs(units - std::floor(units) - 0.5);
        if (off < 0x1p-20) return void(++close);
        EXPECT_EQ(ours, float(exact)) << of << "(" << x << ", " << y << ")";
    };
    for (int i = 0; i < samples(); ++i) {
        const auto x = float(std::abs(arguments.spread(-140, 127))), y = float(arguments.spread(-10, 10));
        const auto a = float(arguments.between(-1, 1)), b = float(arguments.between(-1, 1));
        expectNearest(exp(y), exp(double(y)), "exp", y, 0);
        expectNearest(exp2(y), exp2(double(y)), "exp2", y, 0);
        expectNearest(pipeline::log2(x), pipeline::log2(double(x)), "log2", x, 0);
        expectNearest(pow(x, y), pow(double(x), double(y)), "pow", x, y);
        expectNearest(pow(std::abs(a), 30 + b), pow(double(std::abs(a)), double(30 + b)), "pow", a, b);
        expectNearest(atan2(a, b), atan2(double(a), double(b)), "atan2", a, b);
        expectNearest(atan2(y, -x), atan2(double(y), double(-x)), "atan2", y, x);
        expectNearest(acos(a), acos(double(a)), "acos", a, 0);
    }
    EXPECT_LT(close, samples() / 100);
    constexpr std::array kValues{
        0.0F, -0.0F, 1.0F, -1.0F, 0.5F, -2.0F, 3.0F, 1e30F, 1e-45F, float(kNaN), float(kInfinity), -float(kInfinity)};
    const auto expectAlikeInFloat = [](float ours, double inDouble, const char* of) {
        expectAlike(double(ours), double(float(inDouble)), of);
    };
    for (const float x : kValues) {
        expectAlikeInFloat(pipeline::log2(x), pipeline::log2(double(x)), "log2");
        expectAlikeInFloat(acos(x), acos(double(x)), "acos");
        for (const float y : kValues) {
            expectAlikeInFloat(pow(x, y), pow(double(x), double(y)), "pow");
            expectAlikeInFloat(atan2(x, y), atan2(double(x), double(y)), "atan2");
        }
    }
    for (int i = -149; i <= 127; ++i) EXPECT_EQ(pipeline::log2(std::ldexp(1.0F, i)), float(i));
}

}  // namespace
}  // namespace pipeline
