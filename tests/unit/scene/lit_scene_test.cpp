// What a plan leaves out of lights and objects that show nothing, that it says true reasons, and that no bit changes.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/scenes.h"

namespace pipeline {
namespace {

const PlanPart& part(const Frame& frame, StageId stage, std::string_view name) {
    const auto& parts = frame.plan()[index(stage)].parts;
    const auto found = std::ranges::find(parts, name, &PlanPart::name);
    EXPECT_NE(found, parts.end()) << name;
    return *found;
}

// "left out: Its intensity is 0." or "runs: ..."
std::string said(const Scene& scene, std::string_view name, StageId stage = StageId::Shading) {
    const FramePtr frame = test::frameOf(scene, {});
    const PlanPart& found = part(*frame, stage, name);
    return (found.action == Action::LeaveOut ? "left out: " : "runs: ") + found.why;
}

void expectSameBits(Scene scene) {
    for (const BufferSet& wanted : {setOf({BufferId::Color, BufferId::Intensity}), test::everyBuffer()}) {
        scene.settings.leaveOut = true;
        const FramePtr with = test::frameOf(scene, wanted);
        scene.settings.leaveOut = false;
        EXPECT_EQ(test::firstDifference(*with, *test::frameOf(scene, wanted), wanted), "");
    }
}

// A box that shadows a ground, and one more light.
Scene twoLights() {
    Scene scene = test::boxOverGround();
    scene.settings.width = 64, scene.settings.height = 48, scene.settings.shadowSize = 64;
    for (Object& object : scene.objects) object.material = {Vec3d(0.5), Vec3d(0.4), 4};
    scene.lights = {{LightKind::AtInfinity, {1, -2, 3}, 1, Vec3d(1), true},
                    {LightKind::AtInfinity, {-1, -2, 3}, 1, Vec3d(1), true}};
    return scene;
}

TEST(LitScene, ABlackLightIsLeftOutWithItsShadowBuffer) {
    Scene scene = twoLights();
    for (const Model model : {Model::Phong, Model::BlinnPhong}) {
        scene.settings.model = model;
        scene.lights[1].color = Vec3d(0);
        EXPECT_EQ(said(scene, "light 1"), "left out: Its colour is black.");
        EXPECT_EQ(said(scene, "light 1", StageId::ShadowBuffer), "left out: Its colour is black.");
        EXPECT_EQ(said(scene, "light 0"), "runs: It shines, or what it adds is asked for.");
        expectSameBits(scene);
        scene.lights[1].color = {0, 1e-300, 0};
        EXPECT_TRUE(said(scene, "light 1").starts_with("runs: ")) << "a little green";
    }
    scene.settings.model = Model::OpenGl;
    scene.lights[1].color = Vec3d(0), scene.lights[1].gl.specular = Vec3d(1);
    EXPECT_TRUE(said(scene, "light 1").starts_with("runs: ")) << "its specular colour is another";
    scene.lights[1].gl.specular = scene.lights[1].gl.ambient = Vec3d(0);
    EXPECT_EQ(said(scene, "light 1"), "left out: All its colours are black.");
    expectSameBits(scene);
}

// Red light on what reflects green and blue alone.
TEST(LitScene, ALightOfAColourThatNothingReflectsIsLeftOut) {
    Scene scene = twoLights();
    scene.lights[1].color = {1, 0, 0};
    for (Object& object : scene.objects) object.material.diffuse = {0, 1, 1}, object.material.specular = {0, 0, 1};
    EXPECT_EQ(said(scene, "light 1"), "left out: No material reflects any of it.");
    expectSameBits(scene);
    scene.objects[0].material.specular.r = 1e-300;
    EXPECT_TRUE(said(scene, "light 1").starts_with("runs: "));
}

// The box is not there: what its material would reflect and what it would shadow counts no more.
TEST(LitScene, ObjectsOfAlphaZeroNeedNothing) {
    Scene scene = twoLights();
    scene.objects[0].material.specular = Vec3d(0);
    EXPECT_TRUE(said(scene, "specular of light 0").starts_with("runs: "));
    EXPECT_TRUE(said(scene, "light 0", StageId::ShadowBuffer).starts_with("runs: "));
    scene.objects[1].material.alpha = 0;
    EXPECT_EQ(said(scene, "specular of light 0"), "left out: k_s is 0 in every material that is drawn.");
    EXPECT_EQ(said(scene, "light 0", StageId::ShadowBuffer),
              "left out: Objects of alpha 0 cast none. The only object is convex: it cannot shadow itself.");
    EXPECT_EQ(said(scene, "translucent pass"), "left out: Every surface that is drawn is opaque.");
    for (const Shading shading : {Shading::Flat, Shading::Gouraud, Shading::Phong}) {
        scene.settings.shading = shading;
        expectSameBits(scene);
    }
    scene.objects[0].material.diffuse = Vec3d(0);
    EXPECT_EQ(said(scene, "light 0"), "left out: No material that is drawn reflects any of it.");
    expectSameBits(scene);
    scene.objects[0].material.alpha = 0;
    EXPECT_EQ(said(scene, "R"), "left out: No specular term reads it.");
    expectSameBits(scene);
}

// What is computed of the polygons of such an object is computed where somebody reads it.
TEST(LitScene, ObjectsOfAlphaZeroCountWhereTheirPolygonsAreRead) {
    Scene scene = twoLights();
    scene.objects[0].material.specular = Vec3d(0), scene.objects[1].material.alpha = 0;
    const FramePtr frame = test::frameOf(scene, setOf({BufferId::PolygonsIntensity}));
    EXPECT_EQ(part(*frame, StageId::Shading, "specular of light 0").action, Action::Run);
    EXPECT_EQ(part(*frame, StageId::ShadowBuffer, "light 0").action, Action::Run);
}

TEST(LitScene, ReasonsHoldForEveryValue) {
    Scene scene = twoLights();
    for (Object& object : scene.objects) object.material.specular = Vec3d(-0.5);
    EXPECT_EQ(said(scene, "specular of light 0"), "runs: A material has a k_s other than 0.");
    EXPECT_EQ(said(scene, "clipping", StageId::ZBuffer),
              "runs: Only of polygons that culling did not find whole in the picture.");
    // Culling is left out: it finds none that is whole, and every triangle is clipped, 12 of each box.
    scene.settings.cull = CullMode::None;
    const FramePtr frame = test::frameOf(scene, {});
    EXPECT_EQ(part(*frame, StageId::ZBuffer, "clipping").why,
              "Of every polygon: culling, which finds those that are whole in the picture, is left out.");
    EXPECT_FALSE(part(*frame, StageId::ZBuffer, "clipping").rule);
    const auto tallies = frame->run(StageId::ZBuffer).tallies;
    EXPECT_EQ(tallies[0].done, 24);
    EXPECT_EQ(tallies[0].leftOut, 0);
    scene.settings.model = Model::OpenGl;
    for (Light& light : scene.lights) light.kind = LightKind::Point, light.gl.constant = 2;
    EXPECT_EQ(said(scene, "attenuation of light 0"), "runs: It is not 1 at every distance.");  // 1/2 at each
}

}  // namespace
}  // namespace pipeline
