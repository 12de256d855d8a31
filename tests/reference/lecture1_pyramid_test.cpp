// Lecture 1's example, worked by hand. Every expected number is derived in the comment above it from
// the lecture's files and formulas; none comes from the program.
#include <gtest/gtest.h>

#include "pipeline/inspect/pixel_report.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

class Pyramid : public testing::TestWithParam<Precision> {
protected:
    Pyramid() {
        scene.settings.precision = GetParam();
        frame = test::frameOf(scene);
        // The rounding of the precision, over sums of a few terms of the given size.
        eps = GetParam() == Precision::Float ? 1e-6 : 1e-14;
    }
    AnyBuffer buffer(BufferId id, int light = -1) const { return *frame->buffer({id, light}); }
    void expectRow(const AnyBuffer& b, std::size_t row, Vec3d expected, double tolerance) const {
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(b.value(0, row, c), expected[c], tolerance) << "row " << row << " channel " << c;
    }
    Scene scene = test::pyramid();
    FramePtr frame;
    double eps = 0;
};

INSTANTIATE_TEST_SUITE_P(FloatAndDouble, Pyramid, testing::Values(Precision::Float, Precision::Double),
                         [](const auto& instance) { return instance.param == Precision::Float ? "Float" : "Double"; });

// Scale x by 1.8, no rotation, move x by 200:
//   (0,0,0) (150,0,0) (150,150,0) (0,150,0) (75,75,150) -> x' = 1.8 x + 200, y, z unchanged.
TEST_P(Pyramid, WorldCoordinates) {
    const AnyBuffer world = buffer(BufferId::VerticesWorld);
    const Vec3d expected[]{{200, 0, 0}, {470, 0, 0}, {470, 150, 0}, {200, 150, 0}, {335, 75, 150}};
    for (std::size_t i = 0; i < 5; ++i) expectRow(world, i, expected[i], 1000 * eps);
}

// theta = 45, phi = 60: sin theta = cos theta = r = 0.7071067812, sin phi = s = 0.8660254038, cos phi = 1/2.
//   x_v = r (y - x);  y_v = -r (x + y) / 2 + s z;  z_v = 1000 - s r (x + y) - z / 2
// vertex 4: x_v = r (75 - 335) = -183.8477631; y_v = -r 205 + 0.8660254038·150 = -144.9568901 + 129.9038106
//   = -15.0530796; z_v = 1000 - 0.6123724357·410 - 75 = 673.9273014.
TEST_P(Pyramid, ViewCoordinates) {
    const AnyBuffer view = buffer(BufferId::VerticesView);
    const Vec3d expected[]{{-141.4213562, -70.7106781, 877.5255129},
                           {-332.3401872, -166.1700936, 712.1849552},
                           {-226.2741700, -219.2031022, 620.3290899},
                           {-35.3553391, -123.7436868, 785.6696475},
                           {-183.8477631, -15.0530796, 673.9273014}};
    for (std::size_t i = 0; i < 5; ++i) expectRow(view, i, expected[i], 1000 * eps + 1e-7);
}

// x_s = 320 + 200 x_v / z_v, y_s = 240 - 200 y_v / z_v; the depth stored is z_v.
// vertex 0: 320 - 200·141.4213562/877.5255129 = 320 - 32.2318507; 240 + 200·70.7106781/877.5255129 = 240 + 16.1159253.
TEST_P(Pyramid, ScreenCoordinates) {
    const AnyBuffer screen = buffer(BufferId::VerticesScreen);
    const Vec3d expected[]{{287.7681494, 256.1159253, 877.5255129},
                           {226.6702590, 286.6648705, 712.1849552},
                           {247.0470550, 310.6731655, 620.3290899},
                           {310.9999478, 271.5001826, 785.6696475},
                           {265.4398827, 244.4672710, 673.9273014}};
    for (std::size_t i = 0; i < 5; ++i) expectRow(screen, i, expected[i], 1000 * eps + 1e-7);
}

// N = (v1 - v0) x (v2 - v0), normalised.
//   Left  (0,1,4): (270,0,0) x (135,75,150) = (0, -40500, 20250) -> (0, -2, 1)/sqrt 5
//   Front (1,2,4): (0,150,0) x (-135,75,150) = (22500, 0, 20250) -> (10, 0, 9)/sqrt 181
//   Right (2,3,4): mirror image of Left -> (0, 2, 1)/sqrt 5;  Back: (-10, 0, 9)/sqrt 181;  Base: (0, 0, -1)
TEST_P(Pyramid, PolygonNormals) {
    const AnyBuffer normals = buffer(BufferId::PolygonsNormal);
    const double a = 1 / std::sqrt(5.0), b = 1 / std::sqrt(181.0);
    const Vec3d expected[]{{0, -2 * a, a}, {10 * b, 0, 9 * b}, {0, 2 * a, a}, {-10 * b, 0, 9 * b}, {0, 0, -1}};
    for (std::size_t i = 0; i < 5; ++i) expectRow(normals, i, expected[i], 10 * eps);
}

// Left and Base face away: with y down the shoelace sums of their screen corners are +696.9 and +1991.6
// px², so their signed areas (front positive) are negative. Front 895.3, Right 1756.8, Back 36.4 are kept.
TEST_P(Pyramid, LeftAndBaseAreCulled) {
    const AnyBuffer verdicts = buffer(BufferId::PolygonsVerdict);
    const int kKept = 0, kBackFacing = 1;
    const int expected[]{kBackFacing, kKept, kKept, kKept, kBackFacing};
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(verdicts.flat(i), expected[i]) << "polygon " << i;
}

// I = k_d·50 + 100 (k_d (N·L) + 0.4 (R·V)^8), L = (1,1,1)/sqrt 3, V from the mean of the vertices to the eye
// (612.372, 612.372, 500).
//   Front: N·L = 19/sqrt 543 = 0.8153680; R = 2 (N·L) N - L = (0.6347663, -0.5773503, 0.5135547);
//     V at (425, 75, 50) = (0.2582599, 0.7406733, 0.6202458); R·V = 0.0548369, ^8 = 8.2e-11.
//     blue 45 + 90·0.8153680 = 118.3831239
//   Right: N·L = 3/sqrt 15 = 0.7745967; R = (-0.5773503, 0.8082904, 0.1154701);
//     V at (335, 125, 50) = (0.3857729, 0.6778434, 0.6258654); R·V = 0.3974369, ^8 = 6.2248e-4, 40 of it 0.0248988.
//     blue 45 + 69.7137002 + 0.0248988 = 114.7386006
//   Back: N·L = (-10 + 9)/sqrt 543 = -0.0429141 < 0: the ambient part alone, blue 45.
TEST_P(Pyramid, IntensitiesOfTheVisiblePolygons) {
    const AnyBuffer intensity = buffer(BufferId::PolygonsIntensity);
    expectRow(intensity, 1, {26.3073609, 65.7684022, 118.3831239}, 200 * eps + 1e-7);
    expectRow(intensity, 2, {25.5168338, 63.7547338, 114.7386006}, 200 * eps + 1e-7);
    expectRow(intensity, 3, {10, 25, 45}, 100 * eps);
}

// I_max = 0.9·50 + 100 (0.9 + 0.4) = 175. FB = round(255 I / 175):
//   Front 38.33, 95.83, 172.50 (172.5011) -> 38 96 173; Right 37.18, 92.90, 167.19 -> 37 93 167; Back 14.57, 36.43, 65.57 -> 15 36 66.
TEST_P(Pyramid, FrameBufferValues) {
    const AnyBuffer color = buffer(BufferId::Color), ids = buffer(BufferId::PolygonId);
    const Vec3d expected[]{{}, {38, 96, 173}, {37, 93, 167}, {15, 36, 66}};
    int seen[4]{};
    for (std::size_t y = 0; y < 480; ++y) {
        for (std::size_t x = 0; x < 640; ++x) {
            const int polygon = int(ids.value(x, y));
            const Vec3d value{color.value(x, y, 0), color.value(x, y, 1), color.value(x, y, 2)};
            if (polygon < 0) {
                ASSERT_EQ(value, Vec3d(0)) << x << ' ' << y;
                continue;
            }
            ASSERT_TRUE(polygon >= 1 && polygon <= 3)
                << "polygon " << polygon << " is culled, and seen at " << x << ' ' << y;
            ASSERT_EQ(value, expected[polygon]) << x << ' ' << y;
            ++seen[polygon];
        }
    }
    // As many pixels as square pixels of area, give or take the border: half a pixel along the outline of
    // about 70 + 70 + 60 px for each.
    EXPECT_NEAR(seen[1], 895.3, 50);
    EXPECT_NEAR(seen[2], 1756.8, 75);
    EXPECT_NEAR(seen[3], 36.4, 36.4);
}

// Pixel (268, 281), centre (268.5, 281.5): the ray meets Right's plane (z/150 at y between 150 and 75:
// 2 y + z = 300 in world space) at z_v = 671.4539, worked out from the plane in view space.
TEST_P(Pyramid, DepthOfOnePixel) {
    // Ray through the centre: x_v = (268.5 - 320)/200 z_v = -0.2575 z_v, y_v = (240 - 281.5)/200 z_v = -0.2075 z_v.
    // World: y = eye.y + r x_v - r/2 y_v - s r z_v, z = 500 + s y_v - z_v / 2, with r = 0.70710678, s = 0.86602540:
    //   y = 612.37244 + (-0.18208 + 0.07336231 - 0.61237244) z_v = 612.37244 - 0.72109008 z_v
    //   z = 500 + (-0.17970027 - 0.5) z_v = 500 - 0.67970027 z_v
    // 2 y + z = 300: 1724.74487 - 2.12188043 z_v = 300, z_v = 671.4539.
    EXPECT_NEAR(buffer(BufferId::ZView).value(268, 281), 671.4539, 0.05);  // snapping moves corners by up to 1/512 px
}

TEST_P(Pyramid, ReflectionVectorIsTwiceNDotLTimesNMinusL) {
    // Right: 2·0.7745967·(0, 0.8944272, 0.4472136) - 0.5773503 (1, 1, 1) = (-0.5773503, 0.8082904, 0.1154701).
    const PixelReport report = inspectPixel(*frame, {268, 281});
    ASSERT_EQ(report.polygon, 2);
    ASSERT_EQ(report.evaluations.size(), 1u);
    const LightReport& light = report.evaluations[0].lights[0];
    const Vec3d expected{-0.577350269, 0.808290377, 0.115470054};
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(light.R[c], expected[c], 10 * eps + 1e-9);
    EXPECT_NEAR(light.nDotL, 0.774596669, 10 * eps + 1e-9);
    EXPECT_NEAR(light.rDotV, 0.397436949, 10 * eps + 1e-9);
}

TEST_P(Pyramid, TheShadowBufferIsLeftOutAndSaysWhy) {
    const FramePtr plain = test::frameOf(scene, {});
    const PlanStep& step = plain->plan()[index(StageId::ShadowBuffer)];
    EXPECT_EQ(step.action, Action::LeaveOut);
    EXPECT_EQ(step.why, "The only object is convex: it cannot shadow itself.");
    EXPECT_EQ(plain->whyAbsent({BufferId::ShadowBuffer, 0}), "The only object is convex: it cannot shadow itself.");
}

// Gouraud: vertex normals by the mean. Vertex 4 touches Left, Front, Right, Back: the sum of
// (0,-2,1)/sqrt 5, (10,0,9)/sqrt 181, (0,2,1)/sqrt 5, (-10,0,9)/sqrt 181 is (0, 0, positive): N = (0, 0, 1).
// Vertex 0 touches Left, Back, Base: (0,-.8944,.4472) + (-.7433,0,.6690) + (0,0,-1) = (-.7433,-.8944,.1162),
// length 1.16875: N = (-0.6360, -0.7653, 0.0994).
TEST_P(Pyramid, VertexNormalsAreTheMeanOfThePolygonsAround) {
    const AnyBuffer normals = buffer(BufferId::VerticesNormal);
    expectRow(normals, 4, {0, 0, 1}, 10 * eps);
    expectRow(normals, 0, {-0.6360, -0.7653, 0.0994}, 1e-4);
}

}  // namespace
}  // namespace pipeline
