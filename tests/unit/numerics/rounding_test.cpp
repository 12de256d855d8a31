// What vectors compute in another way than the stages' text, with the same bits: here the claims that this rests on.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "pipeline/core/numerics.h"
#include "pipeline/stages/shading.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

// The inverse of a triangle's area: rounded once from double, or divided in float where float holds the area.
TEST(Rounding, InversesOfAreasUpTo24BitsAreTheSameFromFloatAndFromDouble) {
    std::uint32_t different = 0;
    for (std::uint32_t area = 1; area < 1U << 24; ++area) different += 1 / float(area) != float(1 / double(area));
    EXPECT_EQ(different, 0U);
}

// Where a vertex stands on the screen: a number in double over a z that is a float, from the inverse of z.
TEST(Rounding, AQuotientFromAnInverseHasTheBitsOfADivision) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> mantissa(1, 2);
    std::uniform_int_distribution<int> exponent(-60, 60);
    const auto fromInverse = [](double v, double z) {
        const double inverse = 1 / z, guess = v * inverse;
        return std::fma(std::fma(-guess, z, v), inverse, guess);
    };
    for (int i = 0; i < 1'000'000; ++i) {
        double v = mantissa(random), z = double(float(mantissa(random)));
        v = std::ldexp(v, exponent(random)), z = std::ldexp(z, exponent(random) / 2);
        ASSERT_EQ(fromInverse(v, z), v / z) << v << " / " << z;
        ASSERT_EQ(fromInverse(-v, z), -v / z) << -v << " / " << z;
    }
    // Quotients as near to halfway between two doubles as v lets them be: from q / 2 times z, q of 54 bits and odd.
    for (std::uint64_t k = 1; k < 1U << 16; k += 2) {
        const double z = double((1U << 23) + k);
        for (const std::uint64_t q : {(1ULL << 53) + 1, (1ULL << 53) + 3, (1ULL << 54) - 1}) {
            const double near = double(static_cast<long double>(q) / 2 * z);
            for (const double v : {std::nextafter(near, 0.0), near, std::nextafter(near, 1e300)})
                ASSERT_EQ(fromInverse(v, z), v / z) << v << " / " << z;
        }
    }
    EXPECT_EQ(fromInverse(0, 3), 0);
    EXPECT_FALSE(std::signbit(fromInverse(0, 3)));
}

// What the frame buffer rounds, beside every step of it: estimated in float, unless that is too near to tell. In ambient
// light alone an intensity is k I_a; red is whole, so that the largest is I_a.
TEST(Rounding, ColorsBesideTheirStepsAreThoseOfTheirFormula) {
    constexpr double kAmbient = 175;
    Scene scene = test::pyramid();
    scene.settings.width = 8, scene.settings.height = 4;
    scene.camera.screenDistance = 2;
    scene.lights.clear();
    scene.ambient.intensity = kAmbient;
    int below = 0, above = 0;
    for (int step = 0; step < 255; ++step) {
        const double half = (step + 0.5) / 255;
        for (int places = -6; places <= 6; ++places) {
            scene.objects[0].material.diffuse = {1, half * (1 + places * 0x1p-24), half * (1 + places * 0x1p-22)};
            const FramePtr frame = test::frameOf(scene, setOf({BufferId::Color, BufferId::Intensity}), 1);
            const auto color = frame->buffer({BufferId::Color}), intensity = frame->buffer({BufferId::Intensity});
            for (std::size_t i = 0; i < 3 * 8 * 4; i += 3) {
                const Vec3d of(intensity->flat(i), intensity->flat(i + 1), intensity->flat(i + 2));
                const Color8 expected = frameBufferValue(of, kAmbient);
                const Vec3d found(color->flat(i), color->flat(i + 1), color->flat(i + 2));
                ASSERT_EQ(found, Vec3d(expected)) << step << ' ' << of.y << ' ' << of.z;
                if (of.x == 0) continue;
                below += expected.y == step, above += expected.y == step + 1;
            }
        }
    }
    // Pixels on either side of their steps.
    EXPECT_GT(below, 1000);
    EXPECT_GT(above, 1000);
}

}  // namespace
}  // namespace pipeline
