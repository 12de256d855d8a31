// Blinn-Phong and OpenGL's model, by hand; Phong's is in shading_test.cpp.
#include "pipeline/illumination/illumination.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/illumination/opengl.h"
#include "pipeline/run/frame_data.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

constexpr Vec3d kUp{0, 0, 1};
const double kRoot = std::sqrt(0.5);

Illumination blinn(double factor = 1) { return {Model::BlinnPhong, factor, false, false}; }
Illumination openGl() { return {Model::OpenGl, 1, false, false}; }

// L at 45 degrees on one side of N, V along N: H stands at 22.5 degrees from N.
TEST(BlinnPhong, TheHalfwayVectorStandsHalfway) {
    Light light;
    light.position = {1, 0, 1};
    Material material;
    material.specular = Vec3d(0.5), material.exponent = 2, material.diffuse = {0.2, 0.4, 0.8};
    const LightSample<double> s = sampleLight<double>(blinn(), light, material, {Vec3d(0), kUp, kUp});
    EXPECT_NEAR(s.nDotH, std::cos(std::acos(-1) / 8), 1e-15);
    // cos² 22.5° = (1 + cos 45°) / 2
    EXPECT_NEAR(s.specular.x, 0.5 * (1 + kRoot) / 2, 1e-15);
    EXPECT_NEAR(s.diffuse.z, 0.8 * kRoot, 1e-15);
}

// N·H is positive here: only N·L > 0 lets it count.
TEST(BlinnPhong, ALightBehindTheSurfaceAddsNothing) {
    Light light;
    light.position = {1, 0, -0.5};
    Material material;
    material.specular = Vec3d(1);
    for (const Illumination& model : {blinn(), openGl()}) {
        const LightSample<double> s = sampleLight<double>(model, light, material, {Vec3d(0), kUp, kUp});
        EXPECT_GT(s.nDotH, 0);
        EXPECT_EQ(s.diffuse, Vec3d(0));
        EXPECT_EQ(s.specular, Vec3d(0));
    }
}

TEST(BlinnPhong, TheFactorMultipliesTheExponent) {
    Light light;
    light.position = {1, 0, 1};
    Material material;
    material.specular = Vec3d(1), material.exponent = 3;
    const auto power = [&](double factor) {
        return sampleLight<double>(blinn(factor), light, material, {Vec3d(0), kUp, kUp}).specularPower;
    };
    EXPECT_NEAR(power(4), std::pow((1 + kRoot) / 2, 6), 1e-15);  // (cos 22.5°)^12
}

// Near the mirror direction R leaves V twice as fast as H leaves N: cos^n(2a) and cos^4n(a) agree
// to second order, 1 - 2 n a².
TEST(BlinnPhong, FourTimesTheExponentIsAboutPhongsHighlight) {
    Material material;
    material.specular = Vec3d(1), material.exponent = 20;
    for (double degrees : {0.5, 1.0, 2.0}) {
        const double a = degrees * std::acos(-1) / 180;
        Light light;
        light.position = {std::sin(2 * a), 0, std::cos(2 * a)};
        const Surface<double> at{Vec3d(0), kUp, kUp};
        const double phong = sampleLight<double>({}, light, material, at).specularPower;
        const double matched = sampleLight<double>(blinn(4), light, material, at).specularPower;
        const double equal = sampleLight<double>(blinn(1), light, material, at).specularPower;
        EXPECT_NEAR(matched, phong, 20 * 20 * a * a * a * a * 4);  // the fourth order
        EXPECT_GT(equal, matched);
    }
}

TEST(BlinnPhong, AmbientLightHasACoefficientOfItsOwn) {
    Material material;
    material.diffuse = Vec3d(0.9), material.ambient = {0.1, 0.2, 0.3};
    const AmbientLight ambient{2, {1, 0.5, 0}};
    EXPECT_EQ(ambientTerm<double>(Model::BlinnPhong, ambient, material), Vec3d(0.2, 0.2, 0));
    EXPECT_EQ(ambientTerm<double>(Model::Phong, ambient, material), Vec3d(1.8, 0.9, 0));
}

TEST(OpenGl, AttenuationIsOneOverAQuadraticOfTheDistance) {
    Light light;
    light.kind = LightKind::Point, light.position = {0, 0, 2};
    light.gl.constant = 1, light.gl.linear = 0.5, light.gl.quadratic = 0.25;
    EXPECT_EQ(attenuation<double>(light, Vec3d(0)), 1.0 / 3);  // 1 + 1 + 1
    light.kind = LightKind::AtInfinity;
    EXPECT_EQ(attenuation<double>(light, Vec3d(0)), 1);
    light.kind = LightKind::Point, light.gl.constant = light.gl.linear = light.gl.quadratic = 0;
    EXPECT_EQ(attenuation<double>(light, Vec3d(0)), 0);
}

TEST(OpenGl, ASpotEndsAtItsCutOffAndFadesByItsExponent) {
    Light light;
    light.gl.spotDirection = {0, 0, -5};
    const auto at = [&](double degrees, double cutoff, double exponent) {
        light.gl.spotCutoff = cutoff, light.gl.spotExponent = exponent;
        const double a = degrees * std::acos(-1) / 180;
        return spotFactor<double>(light, {std::sin(a), 0, std::cos(a)});
    };
    EXPECT_NEAR(at(60, 70, 2), 0.25, 1e-15);
    EXPECT_EQ(at(60, 70, 0), 1);
    EXPECT_EQ(at(71, 70, 0), 0);
    EXPECT_EQ(at(120, 180, 9), 1);  // no spot
    EXPECT_EQ(at(120, 90, 0), 0);   // behind the lamp
}

// With exponent 0 the specular part is there wherever the light falls, even where N·H is below 0.
TEST(OpenGl, ZeroToTheZeroIsOne) {
    Light light;
    light.position = {1, 0, 0.1};
    Material material;
    material.specular = Vec3d(0.5), material.exponent = 0;
    const Vec3d behind = normalized(Vec3d(-0.5, 0, -1));
    EXPECT_EQ(sampleLight<double>(openGl(), light, material, {Vec3d(0), kUp, behind}).specular, Vec3d(0.5));
}

TEST(OpenGl, ALightsOwnAmbientPartFadesWithIt) {
    Light light;
    light.kind = LightKind::Point, light.position = {0, 0, -2};  // below the surface: only ambient light
    light.gl.constant = 0, light.gl.linear = 1, light.gl.ambient = {1, 0.5, 0};
    Material material;
    material.ambient = Vec3d(0.5);
    const LightSample<double> s = sampleLight<double>(openGl(), light, material, {Vec3d(0), kUp, kUp});
    EXPECT_EQ(s.ambient, Vec3d(0.25, 0.125, 0));
    EXPECT_EQ(s.diffuse + s.specular, Vec3d(0));
}

// Also where float has no number as small or as large: the direction counts, not its length.
TEST(Illumination, ADirectionOfAnyLengthLightsAlike) {
    Scene scene = test::pyramid();
    scene.settings.width = 64, scene.settings.height = 48, scene.settings.shading = Shading::Phong;
    for (const Model model : {Model::Phong, Model::OpenGl}) {
        scene.settings.model = model;
        scene.lights[0].gl.spotCutoff = 60, scene.lights[0].gl.spotDirection = {-1, -1, -1};
        const FramePtr plain = test::frameOf(scene);
        for (const double factor : {0x1p-150, 0x1p-40, 0x1p40}) {
            Scene scaled = scene;
            scaled.lights[0].position *= factor, scaled.lights[0].gl.spotDirection *= factor;
            EXPECT_EQ(test::firstDifference(*plain, *test::frameOf(scaled)), "") << factor;
        }
    }
}

TEST(OpenGl, ALightInEyeSpaceMovesWithTheEye) {
    Scene scene;
    scene.settings.model = Model::OpenGl;
    Light head;
    head.kind = LightKind::Point, head.position = {0, 1, -3};  // a unit above the axis, three ahead
    head.gl.space = LightSpace::Eye, head.gl.spotDirection = {0, 0, -1};
    scene.lights = {head};
    View view;
    view.eye = {10, 0, 0}, view.right = {0, 1, 0}, view.up = {0, 0, 1}, view.forward = {-1, 0, 0};
    const Light light = lightsInWorldSpace(scene, view)[0];
    EXPECT_EQ(light.position, Vec3d(7, 0, 1));
    EXPECT_EQ(light.gl.spotDirection, Vec3d(-1, 0, 0));
}

// A square seen from behind: lit on the side that shows, with the back material, only when asked.
TEST(OpenGl, TwoSidedLightingTurnsTheNormalOfABackFace) {
    Scene scene;
    scene.objects.push_back({"square",
                             test::mesh({{-1, -1, 0}, {-1, 1, 0}, {1, 1, 0}, {1, -1, 0}}, {{0, 1, 2, 3}}),
                             {},
                             {{1, 0, 0}, Vec3d(0), 1, {0, 0, 0}}});
    scene.objects[0].backMaterial = Material{{0, 1, 0}, Vec3d(0), 1, {0, 0, 0}};
    scene.lights.resize(1);
    scene.lights[0].castsShadow = false;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, 0, 5}, scene.camera.target = Vec3d(0), scene.camera.up = {0, 1, 0};
    scene.settings.width = scene.settings.height = 9;
    scene.settings.cull = CullMode::None, scene.settings.model = Model::OpenGl;
    for (Shading shading : {Shading::Flat, Shading::Gouraud, Shading::Phong}) {
        scene.settings.shading = shading;
        scene.settings.twoSided = false;
        const auto color = [&] { return dataOf<float>(*test::frameOf(scene, {}))->shading->color.at({4, 4}); };
        EXPECT_EQ(color(), Color8(0, 0, 0));
        scene.settings.twoSided = true;
        EXPECT_EQ(color(), Color8(0, 255, 0));
    }
}

// Emission 0.75 and a light that adds 0.75 make 1, and the terms still sum to it.
TEST(OpenGl, AVertexColourIsClampedBeforeItIsInterpolated) {
    Scene scene = test::pyramid();
    scene.settings.model = Model::OpenGl, scene.settings.shading = Shading::Gouraud;
    scene.objects[0].material.emission = Vec3d(0.75);
    scene.lights[0].intensity = 1, scene.ambient.intensity = 1;
    const FramePtr frame = test::frameOf(scene);
    const AnyBuffer vertices = *frame->buffer({BufferId::VerticesIntensity});
    for (std::size_t i = 0; i < vertices.count(); ++i) EXPECT_LE(vertices.flat(i), 1);
    EXPECT_EQ(vertices.value(0, 0, 2), 1);  // 0.75 + ambient 0.7
    const AnyBuffer intensity = *frame->buffer({BufferId::Intensity}), emission = *frame->buffer({BufferId::Emission});
    const AnyBuffer ambient = *frame->buffer({BufferId::Ambient});
    const AnyBuffer diffuse = *frame->buffer({BufferId::Diffuse, 0}),
                    specular = *frame->buffer({BufferId::Specular, 0});
    for (std::size_t i = 0; i < intensity.count(); ++i) {
        float sum = float(emission.flat(i)) + float(ambient.flat(i));
        sum += float(diffuse.flat(i));
        sum += float(specular.flat(i));
        ASSERT_EQ(sum, float(intensity.flat(i)));
    }
}

// A sphere's exact normals, scaled by (1, 1, 1e-6): n = (1, 0, 1)/√2 becomes (1e-6, 0, 1), not (1, 0, 1e-6).
TEST(GivenNormals, GoWithTheCofactors) {
    Scene scene;
    auto base = std::make_shared<Mesh>(*test::mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
    base->normals = {{kRoot, 0, kRoot}, {0, 0, 1}, {0, 0, 0}};
    scene.objects.push_back({"triangle", base, {{1, 1, 1e-6}, {}, {}}, {}});
    scene.settings.precision = Precision::Double, scene.settings.normalWeight = NormalWeight::Given;
    const AnyBuffer normals = *test::frameOf(scene)->buffer({BufferId::VerticesNormal});
    EXPECT_NEAR(normals.flat(0), 1e-6, 1e-15);
    EXPECT_NEAR(normals.flat(2), 1, 1e-11);
    EXPECT_EQ(normals.flat(8), 1);                  // none given: the polygon's
    scene.objects[0].transform.scale = {1, 1, -1};  // mirrored: the outward side stays outward
    EXPECT_NEAR(test::frameOf(scene)->buffer({BufferId::VerticesNormal})->flat(2), -kRoot, 1e-15);
    scene.objects[0].transform.scale = {1, 1, 0};  // flattened: no infinity, ±z
    EXPECT_EQ(test::frameOf(scene)->buffer({BufferId::VerticesNormal})->flat(2), 1);
}

// A material's own highlight is that of the other model, to the last bit, whatever model the scene has.
TEST(Illumination, AMaterialMayHaveTheOtherModelsHighlight) {
    const Light light{LightKind::AtInfinity, {1, -2, 3}, 2, {1, 0.5, 0.25}, true};
    const Surface<double> at{Vec3d(0), kUp, normalized(Vec3d(0.2, 0.4, 1))};
    Material material{Vec3d(0.5), Vec3d(0.7), 9};
    const LightSample<double> phong = sampleLight<double>({}, light, material, at);
    const LightSample<double> blinn = sampleLight<double>({Model::BlinnPhong}, light, material, at);
    ASSERT_NE(phong.specular, blinn.specular);
    material.highlight = Highlight::BlinnPhong;
    EXPECT_EQ(sampleLight<double>({}, light, material, at).specular, blinn.specular);
    EXPECT_EQ(sampleLight<double>({Model::OpenGl}, light, material, at).specularPower, blinn.specularPower);
    material.highlight = Highlight::Phong;
    EXPECT_EQ(sampleLight<double>({Model::BlinnPhong}, light, material, at).specular, phong.specular);
}

}  // namespace
}  // namespace pipeline
