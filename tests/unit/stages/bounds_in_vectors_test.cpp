#include <gtest/gtest.h>

#include <random>

#include "pipeline/simd/transform.h"
#include "pipeline/stages/shadow_buffer.h"

namespace pipeline {
namespace {

// Of as many points as are left over behind any vector, of which some have the largest and the smallest numbers.
TEST(BoundsInVectors, AreThoseOfOneByOne) {
    std::mt19937 random(3);
    const auto component = [&] {
        const float magnitudes[]{1, 1e-40F, 1e30F, 0};
        return std::uniform_real_distribution<float>(-1, 1)(random) * magnitudes[random() % 4];
    };
    View view;
    view.placeEye({0.5, -3, 1e10}), view.right = {0.6, 0.8, 0}, view.up = {0, 0, -1}, view.forward = {-0.8, 0.6, 0};
    for (std::size_t count = 0; count < 70; ++count) {
        std::vector<Vec3<float>> points(count);
        for (Vec3<float>& point : points) point = {component(), component(), component()};
        const Bounds one = boundsIn<float>(view, points), several = boundsInVectors(view, points);
        EXPECT_EQ(one.low, several.low) << count;
        EXPECT_EQ(one.high, several.high) << count;
        EXPECT_EQ(largestIn<float>(points), largestInVectors(points)) << count;
    }
}

}  // namespace
}  // namespace pipeline
