#include "pipeline/stages/z_buffer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/inspect/pixel_report.h"
#include "pipeline/stages/depth.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

// Polygons facing the eye at the origin, which looks along +y with z up; 90 degrees, 8 x 8 pixels.
Scene facing(std::vector<std::pair<double, double>> sizesAndDistances) {
    Scene scene;
    scene.settings.width = scene.settings.height = 8;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, 0, 0}, scene.camera.target = {0, 1, 0}, scene.camera.fovY = 90;
    scene.camera.near = 1, scene.camera.far = 100;
    for (const auto& [s, y] : sizesAndDistances)
        scene.objects.push_back(
            {"square", test::mesh({{-s, y, -s}, {s, y, -s}, {s, y, s}, {-s, y, s}}, {{0, 1, 2, 3}}), {}, {}});
    return scene;
}

// The polygons seen, a for the first, '.' for nothing.
std::string picture(const Scene& scene) {
    const AnyBuffer ids = *test::frameOf(scene)->buffer({BufferId::ObjectId});
    std::string text = "\n";
    for (std::size_t y = 0; y < ids.rows(); ++y) {
        for (std::size_t x = 0; x < ids.columns(); ++x)
            text += ids.value(x, y) < 0 ? '.' : char('a' + int(ids.value(x, y)));
        text += '\n';
    }
    return text;
}

// At distance 10 the picture is 20 units wide: 2.5 units a pixel. The square of half size 5 spans pixels 2 to 5;
// the one of 20 at distance 50 (12.5 units a pixel) spans 2.4 to 5.6, whose centres are 2.5 to 5.5 too.
TEST(ZBuffer, NearerPolygonWinsWhateverTheOrder) {
    const char* const both = R"(
........
.bbbbbb.
.baaaab.
.baaaab.
.baaaab.
.baaaab.
.bbbbbb.
........
)";
    EXPECT_EQ(picture(facing({{5, 10}, {37.5, 50}})), both);
    std::string swapped = both;
    for (char& c : swapped) c = c == 'a' ? 'b' : c == 'b' ? 'a' : c;
    EXPECT_EQ(picture(facing({{37.5, 50}, {5, 10}})), swapped);
}

TEST(ZBuffer, OnATieTheFirstDrawnStays) {
    EXPECT_EQ(picture(facing({{5, 10}, {5, 10}})).find('b'), std::string::npos);
    const FramePtr frame = test::frameOf(facing({{5, 10}, {5, 10}}));
    EXPECT_EQ(frame->buffer({BufferId::Overdraw})->value(3, 3), 2);
    EXPECT_EQ(frame->buffer({BufferId::DepthWrites})->value(3, 3), 1);
}

TEST(ZBuffer, APolygonAtOneDepthHasThatDepthExactly) {
    for (Precision precision : {Precision::Float, Precision::Double}) {
        Scene scene = facing({{5, 8}});  // 1/8 has no rounding of its own
        scene.settings.precision = precision;
        const AnyBuffer z = *test::frameOf(scene)->buffer({BufferId::ZView});
        for (std::size_t i = 0; i < z.count(); ++i) EXPECT_TRUE(z.flat(i) == 8 || std::isinf(z.flat(i))) << z.flat(i);
    }
}

// n = 1, f = 100, z = 10. Perspective: d = f/(f-n) - fn/((f-n) z) = 100/99 (1 - 1/10) = 0.909090...; reversed 1 - d;
// orthographic d = 9/99 = 0.0909...; 16 bits: round(0.9090909·65535) = 59577 (59577.27), 24 bits: 15252014 (15252013.6).
TEST(Depth, EncodesAsTheFormulasSay) {
    View view;
    view.near = 1, view.far = 100;
    const auto d = [&](DepthFormat format) { return DepthCode(view, format).encode(10.0, 0.1); };
    EXPECT_EQ(d(DepthFormat::Linear), 10);
    EXPECT_EQ(d(DepthFormat::Float), 0x0.e8ba2fp0);  // 10/11 to 24 bits: 15252014.55 / 2^24
    EXPECT_EQ(d(DepthFormat::Reversed), double(1.0f / 11));
    EXPECT_EQ(d(DepthFormat::Fixed16), 59577.0 / 65535);
    EXPECT_EQ(d(DepthFormat::Fixed24), 15252014.0 / 16777215);
    EXPECT_EQ(d(DepthFormat::Fixed32), 3904515723.0 / 4294967295);
    // 11 bits: 0.90909 lies in [1/2, 1), steps of 2^-11: 1861.8 of them; 0.090909 in [1/16, 1/8), of 2^-14: 1489.5.
    EXPECT_EQ(d(DepthFormat::Half), 1862 * 0x1p-11);
    EXPECT_EQ(d(DepthFormat::ReversedHalf), 1489 * 0x1p-14);
    EXPECT_EQ(d(DepthFormat::Infinite), double(0.1f));  // n / z
    view.perspective = false;
    EXPECT_EQ(d(DepthFormat::Float), double(1.0f / 11));
    EXPECT_EQ(d(DepthFormat::Reversed), double(10.0f / 11));
}

// 16-bit floats have 11 bits down to 2^-14, and steps of 2^-24 below.
TEST(Depth, AHalfIsTheNearestOfItsFormat) {
    EXPECT_EQ(roundToHalf(1.0), 1);
    EXPECT_EQ(roundToHalf(0.0), 0);
    EXPECT_EQ(roundToHalf(0x1p-24), 0x1p-24);
    EXPECT_EQ(roundToHalf(0x1.8p-25), 0x1p-24);
    EXPECT_EQ(roundToHalf(0x1p-26), 0);
    EXPECT_EQ(roundToHalf(0x1.004p0 / 2), 0x1.004p0 / 2);  // 0.5 + 2^-11
    EXPECT_EQ(roundToHalf(0x1.0018p0 / 2), 0x1.0p0 / 2);
    for (double d = 1; d > 0x1p-30; d *= 0.97) {
        const double half = roundToHalf(d), step = std::exp2(std::max(std::ilogb(d), -14) - 10);
        EXPECT_LE(std::abs(half - d), step / 2) << d;
        EXPECT_EQ(std::fmod(half, step), 0) << d;
    }
}

// The width of a bin at z, from the bound of d that z falls in (numerics: z_k = f n / (f - d_k (f - n))): half a bin
// apart two planes share a depth or not, a bin and more apart they never do.
TEST(Depth, BinsAreAsWideAsTheFormulasSay) {
    View view;
    view.near = 1, view.far = 100;
    for (const auto& [format, bits] : {std::pair(DepthFormat::Fixed16, 16), std::pair(DepthFormat::Fixed24, 24),
                                       std::pair(DepthFormat::Fixed32, 32)}) {
        const DepthCode code(view, format);
        const double levels = std::ldexp(1.0, bits) - 1;
        for (double z : {1.5, 10.0, 70.0}) {
            const double width = z * z * 99 / (100 * levels);
            EXPECT_NE(code.encode(z, 1 / z), code.encode(z + 1.01 * width, 1 / (z + 1.01 * width))) << bits << ' ' << z;
            // The plane in the middle of a bin: a third of a bin to either side it is still the same.
            const double k = std::round(code.encode(z, 1 / z) * levels);
            const double middle = 100 / (100 - k / levels * 99);
            EXPECT_EQ(code.encode(middle - width / 3, 1 / (middle - width / 3)),
                      code.encode(middle + width / 3, 1 / (middle + width / 3)))
                << bits << ' ' << z;
        }
    }
    // Standard float near d = 1: a spacing of 2^-24, z² 2^-24 / n.
    const DepthCode standard(view, DepthFormat::Float);
    const double width = 70 * 70 * 0x1p-24 * 99 / 100;
    EXPECT_NE(standard.encode(70.0, 1.0 / 70), standard.encode(70 + 1.01 * width, 1 / (70 + 1.01 * width)));
    // d changes by one spacing of 2^-24 over a width: over three of them, by three.
    EXPECT_NEAR(standard.encode(70 + 3 * width, 1 / (70 + 3 * width)) - standard.encode(70.0, 1.0 / 70), 3 * 0x1p-24,
                0x1.1p-24);
    // Reversed with a far plane that counts for nothing: between 2^-24 z and 2^-23 z at every distance.
    view.far = 1e9;
    const DepthCode reversed(view, DepthFormat::Reversed);
    for (double z = 1.5; z < 1000; z *= 1.7) {
        const double next = z * (1 + 1.01 * 0x1p-23), d = reversed.encode(z, 1 / z);
        EXPECT_NE(d, reversed.encode(next, 1 / next)) << z;
        const double spacing = double(float(d) - std::nextafter(float(d), 0.0f));
        EXPECT_GE(spacing / d, 0.999 * 0x1p-24) << z;
    }
}

// A float run keeps what the format can tell apart: a bin at z = 8 is 64 · 99/100 / 2^bits wide, so planes at 8 and
// 8 + 2^-20 (both floats) lie 65 bins of 32 bits apart, but in one bin of 24 bits: there the first drawn stays.
TEST(Depth, ThirtyTwoBitsTellApartWhatTwentyFourCannot) {
    Scene scene = facing({{5, 8 + 0x1p-20}, {5, 8}});
    scene.settings.depthFormat = DepthFormat::Fixed32;
    EXPECT_EQ(picture(scene).find('a'), std::string::npos);
    EXPECT_STREQ(test::frameOf(scene)->buffer({BufferId::Depth})->dtype(), "float64");
    scene.settings.depthFormat = DepthFormat::Fixed24;
    EXPECT_EQ(picture(scene).find('b'), std::string::npos);
    EXPECT_STREQ(test::frameOf(scene)->buffer({BufferId::Depth})->dtype(), "float32");
}

TEST(Depth, EveryFormatPutsTheNearerInFront) {
    for (int format = 0; format < 6; ++format) {
        Scene scene = facing({{37.5, 50}, {5, 10}, {37.5, 60}});
        scene.settings.depthFormat = DepthFormat(format);
        EXPECT_EQ(picture(scene), R"(
........
.aaaaaa.
.abbbba.
.abbbba.
.abbbba.
.abbbba.
.aaaaaa.
........
)") << format;
    }
}

// Corners at z = 1 and z = 100, in the middle of the screen: the share of the far one is
// t = s z0 / (s z0 + (1-s) z1) = 0.5 / 50.5 = 0.00990099, not 1/2.
TEST(ZBuffer, InterpolatesInPerspective) {
    RasterTriangle<double> t{};
    t.snapped = {{glm::i64vec2(0, 0), glm::i64vec2(10 * kSubPixels, 0), glm::i64vec2(0, 10 * kSubPixels)}};
    t.inverseArea2 = 1 / double(t.snapped.area2());
    t.w = {1.0 / 100, 1, 1};
    t.weights = {Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)};
    const std::int64_t half = t.snapped.area2() / 2;
    const Fragment<double> f = interpolate(t, {4, 0}, {half, half, 0}, true);
    EXPECT_NEAR(f.barycentric.x, 0.5 / 50.5, 1e-15);
    EXPECT_NEAR(f.z, 100 / 50.5, 1e-14);
}

TEST(ZBuffer, AReplayRecordsEveryFragmentWithTheNumbersCompared) {
    const FramePtr frame = test::frameOf(facing({{37.5, 50}, {5, 10}, {37.5, 60}}));
    const PixelReport report = inspectPixel(*frame, {4, 4});
    ASSERT_EQ(report.fragments.size(), 3u);
    EXPECT_EQ(comparisonText(report.fragments[0]).whole(), "50.00000 < +∞");
    EXPECT_EQ(report.fragments[0].verdict, FragmentVerdict::Overwritten);
    EXPECT_EQ(comparisonText(report.fragments[1]).whole(), "10.00000 < 50.00000");
    EXPECT_EQ(report.fragments[1].verdict, FragmentVerdict::WonStays);
    EXPECT_EQ(comparisonText(report.fragments[2]).whole(), "60.00000 ≥ 10.00000");
    EXPECT_EQ(report.fragments[2].verdict, FragmentVerdict::NotNearer);
}

}  // namespace
}  // namespace pipeline
