#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/sweep.h"

// What other tests rely on.

TEST(Sweep, TakesEverySampleInALongRun) {
    for (const std::size_t n : {0u, 1u, 2u, 50u, 51u, 3000u}) {
        const auto samples = test::sweep(n, true);
        ASSERT_EQ(samples.size(), n);
        for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(samples[i], i);
    }
}

TEST(Sweep, TakesFiftyDifferentSamplesElseWithTheFirstAndTheLast) {
    for (const std::size_t n : {50u, 51u, 99u, 100u, 2785u}) {
        const auto samples = test::sweep(n, false);
        ASSERT_EQ(samples.size(), 50u);
        EXPECT_EQ(samples.front(), 0u);
        EXPECT_EQ(samples.back(), n - 1);
        EXPECT_TRUE(std::ranges::is_sorted(samples, std::less_equal<>())) << n;  // none twice
    }
    EXPECT_EQ(test::sweep(3, false), (std::vector<std::size_t>{0, 1, 2}));
}
