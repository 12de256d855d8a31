#include "pipeline/inspect/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/scenes.h"

using namespace pipeline;

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity(), kNan = std::numeric_limits<double>::quiet_NaN();

// A buffer of a table's row over numbers that the test keeps.
template <class T>
AnyBuffer bufferOf(BufferId id, std::vector<std::size_t> shape, const std::vector<T>& numbers) {
    return {{id}, &bufferInfo(id), std::move(shape), std::span<const T>(numbers), nullptr};
}

AnyBuffer depths(const std::vector<double>& numbers) { return bufferOf(BufferId::ZView, {1, numbers.size()}, numbers); }

BufferDifference compared(const AnyBuffer& a, const AnyBuffer& b, DifferenceMetric metric = DifferenceMetric::Error) {
    return compareBuffers(a, b, -1, metric, {}, {});
}

}  // namespace

TEST(Difference, MetricsAreThoseOfTheirFormulas) {
    // a = 1, b = 4: a − b = −3, its square 9, over 4: 0.75, squared: 0.5625; all exact in binary.
    EXPECT_EQ(difference(DifferenceMetric::Error, 1, 4), -3);
    EXPECT_EQ(difference(DifferenceMetric::Absolute, 1, 4), 3);
    EXPECT_EQ(difference(DifferenceMetric::Squared, 1, 4), 9);
    EXPECT_EQ(difference(DifferenceMetric::RelativeAbsolute, 1, 4), 0.75);
    EXPECT_EQ(difference(DifferenceMetric::RelativeSquared, 1, 4), 0.5625);
}

TEST(Difference, RelativeMetricsStayWithinTwoAndFourWhateverTheScale) {
    for (const double scale : {1e-300, 1e-20, 1.0, 1e200}) {
        EXPECT_EQ(difference(DifferenceMetric::RelativeAbsolute, scale, -scale), 2);
        EXPECT_EQ(difference(DifferenceMetric::RelativeSquared, scale, -scale), 4);
        EXPECT_EQ(difference(DifferenceMetric::RelativeAbsolute, scale, 0), 1);
    }
    EXPECT_EQ(difference(DifferenceMetric::RelativeAbsolute, 0, 0), 0);
}

TEST(Difference, CountsWhatDiffersAndFindsTheWorst) {
    const std::vector<double> a{1, 2, 3, 4}, b{1, 2.5, 1, 4};
    const BufferDifference found = compared(depths(a), depths(b));
    EXPECT_EQ(found.compared, 4u);
    EXPECT_EQ(found.differing, 2u);
    EXPECT_EQ(found.largest, 2);   // 3 − 1
    EXPECT_EQ(found.mean, 0.625);  // (0.5 + 2) / 4
    EXPECT_EQ(found.worst, 2u);
    EXPECT_EQ(found.values.flat(1), -0.5);
    EXPECT_EQ(found.values.info->palette, Palette::Diverging);
    EXPECT_TRUE(isDifference(*found.values.info));
}

TEST(Difference, OfEqualOnesTheFirstIsTheWorst) {
    const std::vector<double> a{0, 5, 0, 5}, b{0, 6, 0, 4};
    EXPECT_EQ(compared(depths(a), depths(b)).worst, 1u);
}

TEST(Difference, TheSameHasNoWorst) {
    const std::vector<double> a{1, kInf, -kInf, kNan, 0.0}, b{1, kInf, -kInf, kNan, -0.0};
    const BufferDifference found = compared(depths(a), depths(b));
    EXPECT_EQ(found.differing, 0u);
    EXPECT_EQ(found.worst, std::nullopt);
}

TEST(Difference, WhatOnlyOneSideHasIsCountedApartAndHasNoNumber) {
    const std::vector<double> a{kInf, 2, kNan, 4}, b{1, 2, 3, 5};
    const BufferDifference found = compared(depths(a), depths(b));
    EXPECT_EQ(found.differing, 3u);
    EXPECT_EQ(found.oneSided, 2u);
    EXPECT_EQ(found.compared, 2u);
    EXPECT_TRUE(std::isnan(found.values.flat(0)));
    EXPECT_EQ(found.worst, 3u);  // a number wins over what has none
    const std::vector<double> c{kInf, 7, 8, 4};
    const std::vector<double> d{kInf, kInf, 8, 4};
    EXPECT_EQ(compared(depths(c), depths(d)).worst, 1u);
}

TEST(Difference, MasksSayWhatIsDrawnOnEachSide) {
    const std::vector<double> a{1, 1, 1, 1}, b{1, 1, 9, 9};
    const std::vector<bool> inA{true, true, true, false}, inB{true, false, true, false};
    const auto found = compareBuffers(depths(a), depths(b), -1, DifferenceMetric::Absolute, inA, inB);
    EXPECT_EQ(found.compared, 2u);
    EXPECT_EQ(found.oneSided, 1u);   // the second
    EXPECT_EQ(found.differing, 2u);  // the second and the third; nobody drew the fourth
    EXPECT_EQ(found.drawn, (std::vector<bool>{true, true, true, false}));
}

TEST(Difference, OfSeveralChannelsTheOneThatDiffersMost) {
    const std::vector<std::uint8_t> a{10, 20, 30, 1, 1, 1}, b{11, 15, 31, 1, 1, 1};
    const AnyBuffer x = bufferOf(BufferId::Color, {1, 2, 3}, a), y = bufferOf(BufferId::Color, {1, 2, 3}, b);
    const auto all = compared(x, y);
    EXPECT_EQ(all.values.shape, (std::vector<std::size_t>{1, 2}));
    EXPECT_EQ(all.values.flat(0), 5);  // green: 20 − 15
    EXPECT_EQ(all.differing, 1u);
    EXPECT_EQ(compareBuffers(x, y, 0, DifferenceMetric::Error, {}, {}).values.flat(0), -1);  // red alone
}

TEST(Difference, NamesAreTheSameOrNot) {
    const std::vector<std::int32_t> a{7, 3, 3}, b{7, 900, 4};
    const auto found = compared(bufferOf(BufferId::PolygonId, {1, 3}, a), bufferOf(BufferId::PolygonId, {1, 3}, b));
    EXPECT_EQ(found.differing, 2u);
    EXPECT_EQ(found.largest, 1);  // 3 − 900 would mean nothing
}

TEST(Difference, BuffersOfDifferentShapesSayWhyTheyCannotBeCompared) {
    const std::vector<double> a(6), b(4);
    const std::string why =
        whyNotComparable(bufferOf(BufferId::ZView, {2, 3}, a), bufferOf(BufferId::ZView, {2, 2}, b));
    EXPECT_EQ(why, "A is 3 × 2, B is 2 × 2.");
    EXPECT_EQ(whyNotComparable(bufferOf(BufferId::ZView, {2, 3}, a), bufferOf(BufferId::NDotL, {2, 3}, a)), "");
}

TEST(StageDifferences, AFrameDoesNotDifferFromItself) {
    const FramePtr frame = test::frameOf(test::pyramid());
    for (const AnyBuffer& buffer : frame->buffers()) {
        const StageDifference row = stageDifference(*frame, *frame, buffer.name);
        EXPECT_EQ(row.differing, 0u) << row.buffer.text();
        EXPECT_EQ(row.worst, std::nullopt) << row.buffer.text();
    }
}

TEST(StageDifferences, AnotherExponentFirstShowsInTheSpecularTerm) {
    Scene scene = test::pyramid();
    const FramePtr a = test::frameOf(scene);
    scene.objects[0].material.exponent = 1;
    const FramePtr b = test::frameOf(scene);
    std::vector<std::string> different;
    for (const AnyBuffer& buffer : a->buffers())
        if (stageDifference(*a, *b, buffer.name).differing > 0) different.push_back(buffer.name.text());
    ASSERT_FALSE(different.empty());
    EXPECT_EQ(different.front(), "specular.0");  // R·V, and all before it, has no exponent
    EXPECT_EQ(different.back(), "color");
}
