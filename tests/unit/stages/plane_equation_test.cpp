#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "pipeline/stages/rasterize.h"

namespace pipeline {
namespace {

// A triangle with these corners, pixels, and 1/z there, the farthest first; none where it has no area.
RasterTriangle<float> triangleOf(std::array<glm::dvec2, 3> corners, std::array<float, 3> w) {
    std::sort(w.begin(), w.end());
    RasterTriangle<float> t{};
    for (std::size_t i = 0; i < 3; ++i) t.snapped.corners[i] = snap<double>(Vec2<double>(corners[i]), 8);
    if (t.snapped.area2() < 0) std::swap(t.snapped.corners[1], t.snapped.corners[2]);
    if (t.snapped.area2() == 0) return t;
    t.w = w;
    t.weights = {Vec3<float>(1, 0, 0), Vec3<float>(0, 1, 0), Vec3<float>(0, 0, 1)};
    t.inverseArea2 = float(1 / double(t.snapped.area2()));
    t.plane = planeEquation<double>(t.snapped, t.w, true);
    return t;
}

// Calls visit(pixel, 1/z) for the pixels a triangle covers.
template <class Visit>
void forEachInverseZ(const RasterTriangle<float>& t, Visit visit) {
    if (t.snapped.area2() == 0) return;
    forEachCovered(t.snapped, {glm::ivec2(0), glm::ivec2(512)},
                   [&](glm::ivec2 pixel, const auto& e) { visit(pixel, interpolate(t, pixel, e, true).inverseZ, e); });
}

// 1/z is linear in the picture: the mean of the corners' by the areas opposite them, whole numbers that are exact in long
// double. All terms are above 0. The plane errs by at most 3 + 8 kSteepest = 11 halves of the last place of the least 1/z.
// Weights err by fewer: each is rounded three times (its edge function, the inverse area, their product), its product once,
// and two sums once each; the differences once. 12 · 2^-24 holds for both, with room for what is of second order.
TEST(PlaneEquation, IsAsAccurateAsWeightsOfAnyTriangle) {
    std::mt19937 random(7);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    int planes = 0, others = 0;
    for (int n = 0; n < 3000; ++n) {
        // Moderate ones; splinters; and those whose corners are up to 2^20 times as far away as each other.
        const int kind = n % 3;
        const double size = std::exp2(uniform(2, 8)), thin = kind == 1 ? std::exp2(uniform(-9, 0)) : 1;
        const glm::dvec2 at{uniform(-50, 400), uniform(-50, 400)}, along{uniform(-1, 1), uniform(-1, 1)};
        const glm::dvec2 across(-along.y, along.x);
        const auto corner = [&](double x, double y) { return at + size * (x * along + thin * y * across); };
        const auto inverse = [&] { return float(std::exp2(uniform(0, kind == 2 ? 20 : 0.3))); };
        const double y1 = uniform(0, 0.3), x2 = uniform(0, 1);
        const std::array<float, 3> w{inverse(), inverse(), inverse()};
        const RasterTriangle<float> t = triangleOf({corner(0, 0), corner(1, y1), corner(x2, 1)}, w);
        ++(t.plane.holds ? planes : others);
        forEachInverseZ(t, [&](glm::ivec2 pixel, float pixelW, const std::array<std::int64_t, 3>& e) {
            long double sum = 0, area = 0;
            for (std::size_t i = 0; i < 3; ++i) sum += (long double)(e[i]) * t.w[i], area += (long double)(e[i]);
            const double exact = double(sum / area);
            ASSERT_LE(std::abs(double(pixelW) - exact), 12 * 0x1p-24 * exact) << n << " " << pixel.x << " " << pixel.y;
        });
    }
    EXPECT_GT(planes, 500);
    EXPECT_GT(others, 500);
}

// Nothing is added to a depth that all corners share: steps of 0 are 0.
TEST(PlaneEquation, KeepsADepthThatIsTheSameEverywhere) {
    for (const float w : {1.0F, 0.1F, 1.0F / 3, 0x1.fffffep-20F}) {
        const RasterTriangle<float> t =
            triangleOf({glm::dvec2(3.3, 4.1), glm::dvec2(99.7, 17.2), glm::dvec2(41.9, 88.8)}, {w, w, w});
        ASSERT_TRUE(t.plane.holds);
        int pixels = 0;
        forEachInverseZ(t, [&](glm::ivec2, float found, const auto&) {
            ++pixels;
            EXPECT_EQ(found, w);
        });
        EXPECT_GT(pixels, 1000);
    }
}

// A scene twice as large has depths twice as far away, to the last bit: all numbers of a plane are products of w.
TEST(PlaneEquation, GoesWithAScaleOfTwo) {
    const std::array<glm::dvec2, 3> corners{glm::dvec2(3.3, 4.1), glm::dvec2(99.7, 17.2), glm::dvec2(41.9, 88.8)};
    const RasterTriangle<float> one = triangleOf(corners, {0.31F, 0.37F, 0.42F});
    const RasterTriangle<float> half = triangleOf(corners, {0.31F / 64, 0.37F / 64, 0.42F / 64});
    ASSERT_TRUE(one.plane.holds && half.plane.holds);
    std::vector<float> found;
    forEachInverseZ(one, [&](glm::ivec2, float w, const auto&) { found.push_back(w); });
    std::size_t i = 0;
    forEachInverseZ(half, [&](glm::ivec2, float w, const auto&) { ASSERT_EQ(found[i++], 64 * w); });
    EXPECT_GT(i, 1000u);
}

}  // namespace
}  // namespace pipeline
