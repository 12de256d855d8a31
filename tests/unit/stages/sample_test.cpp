#include "pipeline/core/sample.h"

#include <gtest/gtest.h>

#include <numeric>

namespace pipeline {
namespace {

std::vector<double> oneTo(int n) {
    std::vector<double> values(static_cast<std::size_t>(n));
    std::iota(values.rbegin(), values.rend(), 1.0);  // the largest first: order must not matter
    return values;
}

TEST(Summarize, FindsMinimumMedianAndPercentile) {
    EXPECT_EQ(summarize(oneTo(5)).median, 3);
    EXPECT_EQ(summarize(oneTo(4)).median, 2.5);
    EXPECT_EQ(summarize(oneTo(20)).min, 1);
    EXPECT_EQ(summarize(oneTo(20)).p95, 19);  // 19 of 20 values are 95 %
    EXPECT_EQ(summarize(oneTo(21)).p95, 20);  // 19.95 of 21, so 20
    EXPECT_EQ(summarize({7.5}).p95, 7.5);
}

// Binomial tables for p = 1/2, two-sided 95 %: the ranks that Hahn and Meeker list.
TEST(Summarize, BoundsTheMedianByOrderStatistics) {
    EXPECT_FALSE(summarize(oneTo(5)).medianInterval);                                // 2 · 2^-5 = 6.25 %
    EXPECT_EQ(summarize(oneTo(6)).medianInterval, (std::pair{1.0, 6.0}));            // 2 · 2^-6 = 3.1 %
    EXPECT_EQ(summarize(oneTo(10)).medianInterval, (std::pair{2.0, 9.0}));           // 2 · 11 / 1024 = 2.1 %
    EXPECT_EQ(summarize(oneTo(20)).medianInterval, (std::pair{6.0, 15.0}));          // 4.1 %
    EXPECT_EQ(summarize(oneTo(100)).medianInterval, (std::pair{40.0, 61.0}));        // 3.5 %
    EXPECT_EQ(summarize(oneTo(10000)).medianInterval, (std::pair{4902.0, 5099.0}));  // (n ± 1.96 · 100) / 2
}

}  // namespace
}  // namespace pipeline
