// The four arithmetics that the stages compute in.
#include <gtest/gtest.h>

#include <bit>

#include "pipeline/core/numerics.h"
#include "pipeline/run/frame_data.h"
#include "tests/support/scenes.h"

using namespace pipeline;

namespace {

// x = 1 + 2^-112 is the number next to 1 in binary128: x - 1 keeps the difference, and no shorter type can.
TEST(Quad, holds113Bits) {
    const Quad next = Quad(1) + std::numeric_limits<Quad>::epsilon();
    EXPECT_EQ(double(next - Quad(1)), 0x1p-112);
    EXPECT_EQ(double(Quad(1) + std::numeric_limits<Quad>::epsilon() / 2 - Quad(1)), 0.0);
    EXPECT_EQ(std::numeric_limits<Quad>::digits, 113);
}

// (√2)² = 2 and exp(log1p(x)) = 1 + x within a few of the type's own rounding units, not of double's.
TEST(Quad, itsFunctionsAreAsPrecise) {
    const Quad eps = std::numeric_limits<Quad>::epsilon();
    EXPECT_LE(double(abs(sqrt(Quad(2)) * sqrt(Quad(2)) - Quad(2)) / eps), 4);
    EXPECT_LE(double(abs(exp(log1p(Quad(0.3))) - (Quad(1) + Quad(0.3))) / eps), 4);
    EXPECT_LE(double(abs(pow(Quad(3), Quad(0.5)) - sqrt(Quad(3))) / eps), 4);
    EXPECT_EQ(double(floor(Quad(-0.5))), -1);
    EXPECT_FALSE(isfinite(std::numeric_limits<Quad>::infinity()));
}

double largestDifference(const Frame& a, const Frame& b, BufferName name) {
    const AnyBuffer x = *a.buffer(name), y = *b.buffer(name);
    double largest = 0;
    for (std::size_t i = 0; i < x.count(); ++i)
        if (std::isfinite(x.flat(i)) && std::isfinite(y.flat(i)))
            largest = std::max(largest, std::abs(x.flat(i) - y.flat(i)));
    return largest;
}

// Each arithmetic has about 2^11 to 2^49 times the rounding error of the next: whatever a stage computes on the way
// must not be narrower than its type. Depths of the pyramid are about 1000: one rounding unit of double there is
// 2^-44, of long double 2^-55; a buffer holds at most a double, so half of 2^-43 is left of any comparison.
TEST(Precision, everyArithmeticIsCloserToQuadThanTheOneBefore) {
    Scene scene = test::pyramid();
    scene.settings.shading = Shading::Phong;
    scene.settings.width = 160, scene.settings.height = 120;
    scene.camera.pixelsPerUnit = 0.25;
    const BufferSet wanted = setOf({BufferId::ZView, BufferId::Intensity, BufferId::PolygonId});
    const auto frame = [&](Precision precision) {
        scene.settings.precision = precision;
        return test::frameOf(scene, wanted);
    };
    const FramePtr quad = frame(Precision::Quad);
    ASSERT_TRUE(dataOf<Quad>(*quad));
    const FramePtr inFloat = frame(Precision::Float), inDouble = frame(Precision::Double),
                   extended = frame(Precision::Extended);
    EXPECT_EQ(largestDifference(*inDouble, *quad, {BufferId::PolygonId}), 0);
    const double z[]{largestDifference(*inFloat, *quad, {BufferId::ZView}),
                     largestDifference(*inDouble, *quad, {BufferId::ZView}),
                     largestDifference(*extended, *quad, {BufferId::ZView})};
    EXPECT_GT(z[0], 1e-6);
    EXPECT_LT(z[0], 1e-2);
    EXPECT_GT(z[1], 0);
    EXPECT_LT(z[1], 1e-9);
    EXPECT_LE(z[2], 0x1p-43);
    const double i[]{largestDifference(*inFloat, *quad, {BufferId::Intensity}),
                     largestDifference(*inDouble, *quad, {BufferId::Intensity}),
                     largestDifference(*extended, *quad, {BufferId::Intensity})};
    EXPECT_GT(i[0], 1e-7);
    EXPECT_LT(i[0], 1e-2);
    EXPECT_GT(i[1], 0);
    EXPECT_LT(i[1], 1e-10);
    EXPECT_LE(i[2], 0x1p-45);
}

// What long double leaves over double's last bit is far below that bit: rounded to double, extended and quad agree
// but where a value lies within 2^-64 of the middle between two doubles.
TEST(Precision, extendedAndQuadRoundToTheSameDoublesNearlyEverywhere) {
    Scene scene = test::pyramid();
    scene.settings.width = scene.settings.height = 64;
    scene.settings.shading = Shading::Gouraud;
    scene.camera.pixelsPerUnit = 0.1;
    scene.settings.precision = Precision::Extended;
    const AnyBuffer a = *test::frameOf(scene, {})->buffer({BufferId::Intensity});
    scene.settings.precision = Precision::Quad;
    const AnyBuffer b = *test::frameOf(scene, {})->buffer({BufferId::Intensity});
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.count(); ++i) different += a.flat(i) != b.flat(i);
    EXPECT_LE(different, a.count() / 100);
}

}  // namespace
