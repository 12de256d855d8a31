// The mean of several samples a pixel.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "pipeline/inspect/pixel_report.h"
#include "pipeline/stages/sample_pattern.h"
#include "tests/support/scenes.h"

using namespace pipeline;

namespace {

// A square of intensity 1 that fills half of the picture: what lies right of a line through its middle, seen by an
// orthographic camera from +z at one pixel a unit. Its left edge leans by `degrees` from upright.
Scene halfPlane(double degrees, double shift, int size, int samples) {
    Scene scene;
    const double c = std::cos(degrees * std::numbers::pi / 180), s = std::sin(degrees * std::numbers::pi / 180);
    const auto at = [&](double across, double along) {
        return Vec3d(shift + across * c - along * s, across * s + along * c, 0);
    };
    const double far = 4.0 * size;
    scene.objects.push_back(
        {"half", test::mesh({at(0, -far), at(far, -far), at(far, far), at(0, far)}, {{0, 1, 2, 3}}), {}, {}});
    scene.objects[0].material.diffuse = Vec3d(1);
    scene.ambient.intensity = 1;
    scene.camera.kind = CameraKind::LookAt, scene.camera.projection = ProjectionKind::Orthographic;
    scene.camera.eye = {0, 0, 1}, scene.camera.target = Vec3d(0), scene.camera.up = {0, 1, 0};
    scene.camera.height = size;
    scene.settings.width = scene.settings.height = size;
    scene.settings.precision = Precision::Double;
    scene.settings.antialiasing = samples;
    return scene;
}

// The share of the unit square around (x, y) with (x − shift) cos + y sin > 0: the signed distance d of its centre from
// the edge decides; with p = |cos|, q = |sin|, p >= q, the area on the inner side is, for |d| below (p + q) / 2,
//   1/2 + d / p                                     where |d| <= (p − q) / 2
//   1 − (((p + q) / 2 − |d|)² / (2 p q)) or its complement  beyond
double covered(double x, double y, double degrees, double shift) {
    const double c = std::cos(degrees * std::numbers::pi / 180), s = std::sin(degrees * std::numbers::pi / 180);
    const double d = (x - shift) * c + y * s, p = std::max(std::abs(c), std::abs(s)),
                 q = std::min(std::abs(c), std::abs(s));
    if (std::abs(d) >= (p + q) / 2) return d > 0 ? 1 : 0;
    if (std::abs(d) <= (p - q) / 2) return 0.5 + d / p;
    const double corner = ((p + q) / 2 - std::abs(d)) * ((p + q) / 2 - std::abs(d)) / (2 * p * q);
    return d > 0 ? 1 - corner : corner;
}

// Root mean square over the pixels that an edge crosses, over edges of many directions.
double edgeError(int samples) {
    constexpr int kSize = 24;
    double sum = 0, count = 0;
    for (int i = 0; i < 12; ++i) {
        const double degrees = 1.7 + 7.3 * i, shift = 0.37 * i - 2;
        const Scene scene = halfPlane(degrees, shift, kSize, samples);
        const FramePtr frame = test::frameOf(scene);
        const AnyBuffer found = *frame->buffer({samples > 1 ? BufferId::Antialiased : BufferId::Intensity});
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x) {
                const double expected = covered(x + 0.5 - kSize / 2.0, kSize / 2.0 - y - 0.5, degrees, shift);
                if (expected == 0 || expected == 1) continue;
                const double error = found.value(std::size_t(x), std::size_t(y)) - expected;
                sum += error * error, ++count;
            }
    }
    return std::sqrt(sum / count);
}

// The root mean square error of the covered part over edges of all directions and places, of the pattern alone.
double patternError(SamplePattern pattern, int side) {
    const std::vector<glm::dvec2> places = samplePlaces(pattern, side);
    double sum = 0, count = 0;
    for (int i = 0; i < 360; ++i)
        for (int j = 0; j < 100; ++j) {
            const double degrees = i + 0.5, shift = (j + 0.5) / 100 - 0.5;
            const double c = std::cos(degrees * std::numbers::pi / 180), s = std::sin(degrees * std::numbers::pi / 180);
            double inside = 0;
            for (const glm::dvec2& p : places) inside += (p.x - shift * c) * c + (p.y - shift * s) * s > 0;
            const double a = std::abs(c), b = std::abs(s), corners = (a + b) / 2;
            // covered() of a line at distance `shift` from the pixel's centre.
            const double p = std::max(a, b), q = std::min(a, b);
            double expected = shift <= -corners ? 1 : shift >= corners ? 0 : 0.5 - shift / p;
            if (std::abs(shift) > (p - q) / 2 && std::abs(shift) < corners) {
                const double corner = (corners - std::abs(shift)) * (corners - std::abs(shift)) / (2 * p * q);
                expected = shift < 0 ? 1 - corner : corner;
            }
            const double error = inside / double(places.size()) - expected;
            sum += error * error, ++count;
        }
    return std::sqrt(sum / count);
}

// Of N samples: on a grid, one in each of its cells and on Hammersley's points N^(-3/4); anywhere N^(-1/2), by the law
// of large numbers: the standard deviation of one of coverage a is sqrt(a (1 - a)), in the mean 0.38 here.
TEST(Antialiasing, everyPatternKeepsItsLaw) {
    using enum SamplePattern;
    for (const SamplePattern pattern : {Grid, Jittered, Random, Hammersley}) {
        for (const int side : {1, 2, 3, 4, 8, 16}) {
            const std::vector<glm::dvec2> places = samplePlaces(pattern, side);
            ASSERT_EQ(places.size(), std::size_t(side * side));
            for (const glm::dvec2& p : places) {
                EXPECT_GE(std::min(p.x, p.y), -0.5);
                EXPECT_LT(std::max(p.x, p.y), 0.5);
            }
            EXPECT_EQ(places, samplePlaces(pattern, side));
            const bool isDrawn = side > 1 && (pattern == Jittered || pattern == Random);
            EXPECT_EQ(places != samplePlaces(pattern, side, 1), isDrawn) << "another draw";
        }
        const double order = std::log2(patternError(pattern, 4) / patternError(pattern, 16)) / 4;
        EXPECT_NEAR(order, pattern == Random ? 0.5 : 0.75, 0.15) << int(pattern);
        EXPECT_EQ(samplePlaces(pattern, 1)[0], glm::dvec2(0));
    }
    EXPECT_NEAR(patternError(Random, 16), 0.38 / 16, 0.38 / 16 / 2);
    EXPECT_LT(patternError(Grid, 16), patternError(Random, 16) / 3);
}

// One sample is off by up to 1/2: over all places of an edge of coverage a the mean square is a (1 − a), of uniform
// coverage 1/6 at most. On a grid of n x n samples an edge is seen by n of them as if by one each, of cells n times as
// small, so that the error of coverage falls with n^-3/2 = N^(-3/4), N = n² samples.
TEST(Antialiasing, errorOfCoverageFallsWithTheSamplesToThePowerOfThreeQuarters) {
    double before = edgeError(1);
    EXPECT_GT(before, 0.2);
    EXPECT_LT(before, 0.45);
    for (const int n : {2, 4, 8}) {
        const double now = edgeError(n);
        const double order = std::log2(before / now) / 2;  // N grows by 4
        EXPECT_GT(order, 0.55) << n;
        EXPECT_LT(order, 0.95) << n;
        before = now;
    }
}

TEST(Antialiasing, leavesTheOtherBuffersAsTheyAre) {
    Scene scene = test::pyramid();
    scene.settings.width = 160, scene.settings.height = 120, scene.camera.pixelsPerUnit = 0.25;
    for (const Shading shading : {Shading::Flat, Shading::Gouraud, Shading::Phong}) {
        scene.settings.shading = shading;
        scene.settings.antialiasing = 1;
        const FramePtr one = test::frameOf(scene);
        scene.settings.antialiasing = 3;
        const FramePtr nine = test::frameOf(scene);
        for (const AnyBuffer& buffer : one->buffers()) {
            if (buffer.name.id == BufferId::Color || buffer.name.id == BufferId::Antialiased) continue;
            const auto other = nine->buffer(buffer.name);
            ASSERT_TRUE(other) << buffer.name.text();
            for (std::size_t i = 0; i < buffer.count(); ++i)
                ASSERT_EQ(buffer.flat(i), other->flat(i)) << buffer.name.text() << ' ' << i;
        }
        // Of one sample the mean is the sample.
        const AnyBuffer mean = *one->buffer({BufferId::Antialiased}), centre = *one->buffer({BufferId::Intensity});
        for (std::size_t i = 0; i < mean.count(); ++i) ASSERT_EQ(mean.flat(i), centre.flat(i));
    }
}

// Where the whole pixel shows one evenly lit polygon, all samples are alike, and so is their mean: bit for bit.
TEST(Antialiasing, changesNothingInsideAnEvenlyLitPolygon) {
    Scene scene = test::pyramid();
    scene.settings.width = 160, scene.settings.height = 120, scene.camera.pixelsPerUnit = 0.25;
    scene.settings.antialiasing = 3;
    const FramePtr frame = test::frameOf(scene);
    const AnyBuffer ids = *frame->buffer({BufferId::PolygonId}), mean = *frame->buffer({BufferId::Antialiased}),
                    centre = *frame->buffer({BufferId::Intensity});
    int inside = 0, mixed = 0;
    for (std::size_t y = 1; y + 1 < 120; ++y)
        for (std::size_t x = 1; x + 1 < 160; ++x) {
            bool alone = true;
            for (std::size_t j = y - 1; j <= y + 1; ++j)
                for (std::size_t i = x - 1; i <= x + 1; ++i) alone = alone && ids.value(i, j) == ids.value(x, y);
            mixed += mean.value(x, y) != centre.value(x, y);
            if (!alone) continue;
            ++inside;
            ASSERT_EQ(mean.value(x, y), centre.value(x, y)) << x << ", " << y;
        }
    EXPECT_GT(inside, 1000);
    EXPECT_GT(mixed, 20);
}

TEST(Antialiasing, isTheSameOnAnyNumberOfThreadsAndWithEverythingForcedIn) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        Scene scene = test::randomScene(seed);
        scene.settings.antialiasing = 2;
        const auto colors = [&](int threads) { return *test::frameOf(scene, {}, threads)->buffer({BufferId::Color}); };
        const AnyBuffer a = colors(1), b = colors(3);
        scene.settings.leaveOut = false;
        const AnyBuffer c = colors(2);
        for (std::size_t i = 0; i < a.count(); ++i) {
            ASSERT_EQ(a.flat(i), b.flat(i)) << "seed " << seed;
            ASSERT_EQ(a.flat(i), c.flat(i)) << "seed " << seed;
        }
    }
}

// Of one sample too: the mean is the intensity, and asked for later it is there as if it had been from the beginning.
TEST(Antialiasing, theMeanIsThereWhenItIsAskedForLater) {
    for (const int samples : {1, 2}) {
        const auto scene = std::make_shared<const Scene>(halfPlane(20, 0, 16, samples));
        FrameRequest request;
        request.wanted = setOf({BufferId::Intensity});
        const FramePtr first = runFrame(scene, request, nullptr);
        request.wanted.set(index(BufferId::Antialiased));
        const FramePtr later = runFrame(scene, request, first), anew = runFrame(scene, request, nullptr);
        ASSERT_TRUE(later->buffer({BufferId::Antialiased})) << samples;
        EXPECT_EQ(test::firstDifference(*later, *anew, request.wanted), "") << samples;
    }
}

TEST(Antialiasing, thePixelReportScalesTheMean) {
    Scene scene = halfPlane(20, 0, 16, 4);
    const FramePtr frame = test::frameOf(scene);
    const AnyBuffer mean = *frame->buffer({BufferId::Antialiased});
    int checked = 0;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            const double value = mean.value(std::size_t(x), std::size_t(y));
            if (value == 0 || value == 1) continue;
            const PixelReport report = inspectPixel(*frame, {x, y});
            ASSERT_TRUE(report.antialiased);
            EXPECT_EQ(report.antialiased->x, value);
            EXPECT_EQ(int(report.color.r), int(value * 255 + 0.5));  // I_max is 1: k_d I_a
            ++checked;
        }
    EXPECT_GT(checked, 10);
}

}  // namespace
