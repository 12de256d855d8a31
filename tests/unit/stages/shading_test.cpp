#include "pipeline/stages/shading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "pipeline/inspect/pixel_report.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

constexpr Vec3d kUp{0, 0, 1};
const Material kMatter{{0.2, 0.5, 0.9}, Vec3d(0.4), 8};

LightSample<double> sample(Vec3d towards, Vec3d eye, Material material = kMatter) {
    return sampleLight<double>({}, {LightKind::AtInfinity, towards, 100, Vec3d(1), true}, material,
                               {Vec3d(0), kUp, normalized(eye)});
}

TEST(PhongModel, RIsTwiceNDotLTimesNMinusL) {
    const LightSample<double> s = sample({3, 0, 4}, kUp);  // L = (0.6, 0, 0.8), R = 1.6 N - L = (-0.6, 0, 0.8)
    EXPECT_NEAR(s.R.x, -0.6, 1e-15);
    EXPECT_NEAR(s.R.z, 0.8, 1e-15);
    EXPECT_NEAR(s.nDotL, 0.8, 1e-15);
    EXPECT_NEAR(s.rDotV, 0.8, 1e-15);
    // 100·0.5·0.8 and 100·0.4·0.8^8 = 40·0.16777216.
    EXPECT_NEAR(s.diffuse.g, 40, 1e-12);
    EXPECT_NEAR(s.specular.g, 6.7108864, 1e-12);
}

TEST(PhongModel, ALightBehindTheSurfaceAddsNothing) {
    // R·V would be positive here: only N·L > 0 lets it count.
    const LightSample<double> s = sample({1, 0, -1}, {-1, 0, -1});
    EXPECT_GT(s.rDotV, 0);
    EXPECT_EQ(s.diffuse, Vec3d(0));
    EXPECT_EQ(s.specular, Vec3d(0));
}

TEST(PhongModel, AnEyeOffTheMirrorSideSeesNoHighlight) {
    for (double exponent : {0.0, 1.0, 32.5}) {  // a negative cosine to the power 32.5 is not a number
        Material material = kMatter;
        material.exponent = exponent;
        const LightSample<double> s = sample({1, 0, 0.1}, {1, 0, 0.1}, material);
        ASSERT_LT(s.rDotV, 0);
        EXPECT_EQ(s.specular, Vec3d(0)) << exponent;
    }
}

TEST(PhongModel, ExponentsZeroAndOneAreTheConstantAndTheCosine) {
    Material material = kMatter;
    material.exponent = 0;
    EXPECT_NEAR(sample({3, 0, 4}, kUp, material).specular.r, 40, 1e-12);
    material.exponent = 1;
    EXPECT_NEAR(sample({3, 0, 4}, kUp, material).specular.r, 40 * 0.8, 1e-12);
}

// pow of a float cosine errs by 0.15 at exponent 10^6; through half the squared distance it stays below 2·10^-7
// for vectors that are known exactly. Reference: the angle's own cosine, in long double.
TEST(PhongModel, ThePowerHoldsAtAnyExponent) {
    for (double exponent : {1.0, 32.0, 1e3, 1e4, 1e6}) {
        EXPECT_EQ(powerOfCosine<float>({0, 0, 1}, {0, 0, 1}, float(exponent)), 1);
        for (int i = 0; i < 200; ++i) {
            // b at an exact small offset from a = (0, 0, 1): x is the whole of the angle.
            const float x = float(i) * float(std::min(0.9, std::sqrt(8 / exponent))) / 200;
            const Vec3<float> a{0, 0, 1}, b{x, 0, std::sqrt(1 - x * x)};
            const long double cosine = std::sqrt(1 - (long double)x * (long double)x);
            const double expected = double(std::pow(cosine, (long double)exponent));
            EXPECT_NEAR(powerOfCosine(a, b, float(exponent)), expected, 1.5e-6) << exponent << ' ' << i;
        }
    }
}

TEST(PhongModel, ALightInTheSurfacePointAddsNothing) {
    const Light light{LightKind::Point, {1, 2, 3}, 100, Vec3d(1), true};
    const LightSample<double> s = sampleLight<double>({}, light, kMatter, {{1, 2, 3}, kUp, kUp});
    EXPECT_EQ(s.L, Vec3d(0));
    EXPECT_EQ(s.diffuse + s.specular, Vec3d(0));
}

TEST(Numerics, NormalizedCoversTheWholeRange) {
    for (float scale : {1e-38f, 1e-20f, 1.f, 1e18f, 3e37f}) {
        const Vec3<float> n = normalized(Vec3<float>(3 * scale, 0, 4 * scale));
        EXPECT_NEAR(n.x, 0.6f, 1e-6f) << scale;
        EXPECT_NEAR(n.z, 0.8f, 1e-6f) << scale;
    }
    EXPECT_EQ(normalized(Vec3<float>(0)), Vec3<float>(0));
    EXPECT_EQ(normalized(Vec3<float>(std::numeric_limits<float>::infinity(), 0, 0)), Vec3<float>(0));
}

TEST(Numerics, AnglesKeepTheirDigitsWhenSmall) {
    // 10^-5 radians: a dot product of float unit vectors rounds to 1 here.
    EXPECT_NEAR(angleBetween(Vec3<float>(0, 0, 1), Vec3<float>(1e-5f, 0, 1)), 1e-5f, 1e-11f);
}

TEST(FrameBuffer, RoundsClampsAndIsNeverUndefined) {
    EXPECT_EQ(frameBufferValue({87.5, 175, 350}, 175), Color8(128, 255, 255));  // 127.5 rounds up
    EXPECT_EQ(frameBufferValue({-1, 0, 0.3}, 175), Color8(0));
    EXPECT_EQ(frameBufferValue({1, 2, 3}, 0), Color8(0));  // I_max = 0: black, no division
    EXPECT_EQ(frameBufferValue(Vec3d(std::numeric_limits<double>::quiet_NaN()), 1), Color8(0));
    EXPECT_EQ(frameBufferValue(Vec3d(std::numeric_limits<double>::infinity()), 1), Color8(255));
}

// max k_d = 0.9 of one material, max k_s = 0.7 of the other: 0.9·50 + 100 (0.9 + 0.7) + 10·0.5 (0.9 + 0.7).
TEST(FrameBuffer, TheMaximumIntensityTakesTheLargestCoefficients) {
    const std::vector<Material> materials{{{0.2, 0.5, 0.9}, Vec3d(0.4), 8}, {Vec3d(0.1), Vec3d(0.7), 1}};
    const std::vector<Light> lights{{LightKind::AtInfinity, kUp, 100, Vec3d(1), true},
                                    {LightKind::AtInfinity, kUp, 10, {0.5, 0.25, 0}, true}};
    EXPECT_NEAR(maximumIntensity(Model::Phong, materials, lights, {50, Vec3d(1)}), 45 + 160 + 8, 1e-12);
    // What takes light away does not make the picture darker as a whole, and two of it do not make light.
    std::vector<Light> withDark = lights;
    withDark.push_back({LightKind::AtInfinity, kUp, -70, Vec3d(1), true});
    EXPECT_NEAR(maximumIntensity(Model::Phong, materials, withDark, {50, Vec3d(1)}), 45 + 160 + 8, 1e-12);
    EXPECT_EQ(maximumIntensity(Model::Phong, {{Vec3d(-1), Vec3d(-1), 8}}, lights, {-50, Vec3d(1)}), 0);
}

// Lights of one colour each: in red 0.5·10 + 100, in green 0.5·10 + 120, in blue 0.5·10; never their sum.
TEST(FrameBuffer, ColouredLightsDoNotAddUpInTheMaximumIntensity) {
    const std::vector<Material> materials{{Vec3d(0.5), Vec3d(0.5), 8}};
    const std::vector<Light> lights{{LightKind::AtInfinity, kUp, 100, {1, 0, 0}, true},
                                    {LightKind::AtInfinity, kUp, 120, {0, 1, 0}, true}};
    EXPECT_NEAR(maximumIntensity(Model::Phong, materials, lights, {10, Vec3d(1)}), 125, 1e-12);
}

Scene litSphere(Shading shading) {
    Scene scene = test::pyramid();
    scene.objects[0].mesh = test::sphere(150, 12, 16);
    scene.objects[0].transform = {};
    scene.settings.shading = shading;
    return scene;
}

TEST(Shading, FlatHasOneValueAPolygon) {
    const FramePtr frame = test::frameOf(litSphere(Shading::Flat));
    const AnyBuffer ids = *frame->buffer({BufferId::PolygonId}), intensity = *frame->buffer({BufferId::Intensity});
    const AnyBuffer polygons = *frame->buffer({BufferId::PolygonsIntensity});
    int covered = 0;
    for (std::size_t i = 0; i < ids.count(); ++i) {
        if (ids.flat(i) < 0) continue;
        ++covered;
        ASSERT_EQ(intensity.flat(3 * i + 2), polygons.value(0, std::size_t(ids.flat(i)), 2));
    }
    EXPECT_GT(covered, 1000);
}

// The normal of vertex 0 is 0.8 along L: 0.5·0.8. The polygon's own, 1 along L, would give 0.5; so it does where normals
// are computed, and in the other models.
TEST(Shading, OpenGlsFlatShadingTakesTheGivenNormalOfTheFirstVertex) {
    Scene scene;
    scene.settings.width = scene.settings.height = 9;
    scene.settings.precision = Precision::Double;
    scene.settings.model = Model::OpenGl, scene.settings.shading = Shading::Flat;
    scene.settings.normalWeight = NormalWeight::Given;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, 0, 5}, scene.camera.up = {0, 1, 0};
    Mesh mesh = *test::mesh({{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}}, {{0, 1, 2, 3}});
    mesh.normals = {{0.6, 0, 0.8}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    scene.objects.push_back({"square", makeMesh(std::move(mesh)), {}, {Vec3d(0.5), Vec3d(0), 8, Vec3d(0)}});
    scene.lights.push_back({LightKind::AtInfinity, {0, 0, 1}, 1, Vec3d(1), false});
    scene.ambient.intensity = 0;
    const auto intensity = [&] { return test::frameOf(scene)->buffer({BufferId::Intensity})->value(4, 4); };
    EXPECT_NEAR(intensity(), 0.4, 1e-15);
    const AnyBuffer N = *test::frameOf(scene)->buffer({BufferId::Normal});
    EXPECT_NEAR(N.value(4, 4, 0), 0.6, 1e-15);
    scene.settings.normalWeight = NormalWeight::Mean;
    EXPECT_NEAR(intensity(), 0.5, 1e-15);
    scene.settings.normalWeight = NormalWeight::Given, scene.settings.model = Model::BlinnPhong;
    EXPECT_NEAR(intensity(), 0.5, 1e-15);
}

// A pixel's intensity is the mean of its triangle's vertices, weighted by the barycentrics.
TEST(Shading, GouraudInterpolatesTheVerticesIntensities) {
    Scene scene = litSphere(Shading::Gouraud);
    scene.lights[0].castsShadow = false;
    const FramePtr frame = test::frameOf(scene);
    const AnyBuffer seen = *frame->buffer({BufferId::ObjectId}),
                    vertices = *frame->buffer({BufferId::VerticesIntensity});
    for (int y = 160; y < 320; y += 7) {
        for (int x = 240; x < 400; x += 7) {
            if (seen.value(std::size_t(x), std::size_t(y)) < 0) continue;
            const PixelReport r = inspectPixel(*frame, {x, y});
            double expected = 0;
            for (int i = 0; i < 3; ++i)
                expected += r.barycentric[i] * vertices.value(0, std::size_t(r.vertices[std::size_t(i)]), 1);
            ASSERT_NEAR(r.intensity.g, expected, 1e-4);
        }
    }
}

// Phong shading catches the highlight that Gouraud shading misses: its brightest pixel is brighter.
TEST(Shading, PhongCatchesTheHighlightThatGouraudMisses) {
    const auto brightest = [](Shading shading) {
        Scene scene = litSphere(shading);
        scene.objects[0].material.exponent = 200;
        scene.camera.pixelsPerUnit = 4;  // a pixel spans half a degree of the sphere
        scene.objects[0].mesh = test::sphere(150, 7, 9);
        return statistics(*test::frameOf(scene)->buffer({BufferId::Specular, 0})).max;
    };
    EXPECT_GT(brightest(Shading::Phong), 39);  // of 40: the mirror direction is on the sphere
    EXPECT_LT(brightest(Shading::Gouraud), 30);
}

TEST(Shading, NormalsAreUnitAfterInterpolation) {
    const FramePtr frame = test::frameOf(litSphere(Shading::Phong));
    const AnyBuffer normal = *frame->buffer({BufferId::Normal}), seen = *frame->buffer({BufferId::ObjectId});
    for (std::size_t i = 0; i < seen.count(); ++i)
        if (seen.flat(i) >= 0) {
            ASSERT_NEAR(std::hypot(normal.flat(3 * i), normal.flat(3 * i + 1), normal.flat(3 * i + 2)), 1, 3e-7);
        }
}

TEST(Shading, WithoutALightOnlyTheAmbientTermIsLeft) {
    Scene scene = litSphere(Shading::Phong);
    scene.lights.clear();
    const FramePtr frame = test::frameOf(scene);
    EXPECT_EQ(statistics(*frame->buffer({BufferId::Intensity})).max, 45);  // 0.9·50
}

TEST(Shading, AnEmptySceneIsBackground) {
    Scene scene;
    const FramePtr frame = test::frameOf(scene);
    EXPECT_EQ(statistics(*frame->buffer({BufferId::Color})).max, 0);
    EXPECT_EQ(statistics(*frame->buffer({BufferId::PolygonId})).max, -1);
}

// A camera somewhere, and the point that its ray through a pixel's centre reaches.
View viewFrom(Vec3d eye, Vec3d target, double fovY) {
    Scene scene = test::spheres();
    scene.camera.kind = CameraKind::LookAt, scene.camera.eye = eye, scene.camera.target = target;
    scene.camera.up = kUp, scene.camera.fovY = fovY, scene.camera.near = 1, scene.camera.far = 1e4;
    return makeView(scene);
}

// Whatever the interpolated normal says, with every way of shading, with and without leaving out. Planes that are within
// rounding and the flatness of the spheres' quads of the light's direction are not asked.
TEST(Shadow, IsZeroWhereThePlaneFacesAwayAndOneWithoutAShadow) {
    Scene scene = test::spheres();
    ASSERT_TRUE(scene.lights[0].castsShadow && !scene.lights[1].castsShadow);
    scene.lights[0].position = {-500, 500, 100};  // across the viewing direction
    for (const Model model : {Model::Phong, Model::BlinnPhong, Model::OpenGl})
        for (const Shading shading : {Shading::Flat, Shading::Gouraud, Shading::Phong})
            for (const bool leaveOut : {true, false}) {
                scene.settings.model = model, scene.settings.shading = shading, scene.settings.leaveOut = leaveOut;
                const FramePtr frame = test::frameOf(scene);
                const auto at = [&](BufferId id, int light = -1) { return *frame->buffer({id, light}); };
                const AnyBuffer polygons = at(BufferId::PolygonId), normals = at(BufferId::PolygonsNormal);
                const AnyBuffer of[]{at(BufferId::Shadow, 0), at(BufferId::Shadow, 1)};
                const Vec3d L = normalized(scene.lights[0].position);
                int away = 0;
                for (std::size_t i = 0; i < polygons.count(); ++i) {
                    const double polygon = polygons.flat(i);
                    if (polygon < 0) continue;
                    ASSERT_EQ(of[1].flat(i), 1);
                    if (model == Model::OpenGl) {
                        ASSERT_EQ(of[0].flat(i), 1);
                        continue;
                    }
                    const auto row = std::size_t(polygon);
                    const Vec3d n{normals.value(0, row, 0), normals.value(0, row, 1), normals.value(0, row, 2)};
                    if (glm::dot(n, L) > -1e-3) continue;
                    ++away;
                    ASSERT_EQ(of[0].flat(i), 0) << i;
                }
                EXPECT_GT(away, model == Model::OpenGl ? -1 : 500);
            }
}

TEST(ViewVector, OfAPixelPointsFromWhatItsRayReachesToTheEye) {
    for (const double fovY : {5.0, 40.0, 120.0}) {
        const View view = viewFrom({300, -200, 100}, {0, 10, 20}, fovY);
        for (const glm::ivec2 pixel : {glm::ivec2(0, 0), glm::ivec2(17, 31), view.size - 1})
            for (const double z : {1.0, 77.0, 5000.0}) {
                const Vec3d surface = worldPoint(view, glm::dvec2(pixel) + 0.5, z);
                const Vec3d expected = normalized(view.eye - surface), V = towardsEye<double>(view, pixel);
                EXPECT_LT(glm::length(V - expected), 1e-11) << fovY << ' ' << pixel.x << ' ' << z;
            }
    }
}

// Far from the origin eye and surface differ in their last digits alone; the pixel's ray does not know where they are.
TEST(ViewVector, OfAPixelKeepsItsDigitsFarFromTheOrigin) {
    const Vec3d far(3e6, -2e6, 1e6);
    const View view = viewFrom(far + Vec3d(30, -20, 10), far, 40);
    const glm::ivec2 pixel(17, 31);
    const Vec3d exact = towardsEye<double>(view, pixel);
    // Two dozen roundings of numbers below 2, each of 2^-24 at most.
    EXPECT_LT(glm::length(Vec3d(towardsEye<float>(view, pixel)) - exact), 24 * 0x1p-24);
    const Vec3<float> surface(worldPoint(view, glm::dvec2(pixel) + 0.5, 3));  // floats stand 1/4 apart there
    EXPECT_GT(glm::length(Vec3d(towardsEye<float>(view, surface)) - exact), 1e-3);
}

}  // namespace
}  // namespace pipeline
