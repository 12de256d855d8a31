#include "pipeline/scene/area_light.h"

#include <gtest/gtest.h>

#include "pipeline/inspect/pixel_report.h"
#include "pipeline/scene/settings_table.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

Light areaLight(Vec3d position, Vec3d facing, double width, double height, int samples) {
    Light light{LightKind::Area, position, 100, Vec3d(1), true};
    light.area = {facing, width, height, samples};
    return light;
}

TEST(AreaLight, ItsWidthRunsAcrossZ) {
    // Facing (0.6, 0, −0.8): z × facing points along +y, and facing × y = (0.8, 0, 0.6).
    const AreaSides sides = sidesOf(areaLight({}, {3, 0, -4}, 2, 5, 4));
    EXPECT_NEAR(glm::length(sides.width - Vec3d(0, 2, 0)), 0, 1e-15);
    EXPECT_NEAR(glm::length(sides.height - Vec3d(4, 0, 3)), 0, 1e-15);
    const AreaSides down = sidesOf(areaLight({}, {0, 0, -1}, 2, 5, 4));
    EXPECT_EQ(down.width, Vec3d(2, 0, 0));
    EXPECT_EQ(down.height, Vec3d(0, -5, 0));
}

TEST(AreaLight, ItsSamplesAreTheCentresOfCellsAlike) {
    const auto places = samplePlaces(areaLight({10, 20, 30}, {0, 0, -1}, 4, 2, 2));
    ASSERT_EQ(places.size(), 4u);
    EXPECT_EQ(places[0], Vec3d(9, 20.5, 30));
    EXPECT_EQ(places[1], Vec3d(11, 20.5, 30));
    EXPECT_EQ(places[2], Vec3d(9, 19.5, 30));
    EXPECT_EQ(samplePlaces(areaLight({}, {0, 0, -1}, 4, 0, 3)).size(), 3u);  // a line
    EXPECT_EQ(samplePlaces(areaLight({1, 2, 3}, {0, 0, -1}, 0, 0, 3)), (std::vector<Vec3d>{{1, 2, 3}}));
    EXPECT_EQ(samplePlaces(areaLight({1, 2, 3}, {1, 1, 1}, 4, 2, 1)), (std::vector<Vec3d>{{1, 2, 3}}));
}

// With one sample, or no size, an area light is the point light at its centre: every buffer, bit for bit.
TEST(AreaLight, WithoutExtentIsThePointLight) {
    for (unsigned seed = 0; seed < 16; ++seed) {
        Scene point = test::randomScene(seed);
        Light light{LightKind::Point, {1, -2, 4}, 50, Vec3d(1), true};
        point.lights = {light};
        point.settings.shadowFilter = int(seed % 3);
        Scene one = point, small = point;
        one.lights[0].kind = small.lights[0].kind = LightKind::Area;
        one.lights[0].area = {{1, 2, -3}, 2, 1, 1};
        small.lights[0].area = {{1, 2, -3}, 0, 0, 5};
        const FramePtr expected = test::frameOf(point);
        ASSERT_EQ(test::firstDifference(*expected, *test::frameOf(one)), "") << seed;
        ASSERT_EQ(test::firstDifference(*expected, *test::frameOf(small)), "") << seed;
    }
}

// A wall whose plane runs through the middle of the light: half of the samples face it, with or without shadow buffers.
TEST(AreaLight, EverySampleIsAskedWhetherThePolygonFacesIt) {
    Scene scene;
    scene.settings.width = scene.settings.height = 8;
    scene.settings.shadowSize = 32, scene.settings.cull = CullMode::None;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {5, 0, 0}, scene.camera.target = {0, 0, 0};
    scene.objects.push_back(
        {"wall", test::mesh({{0, -9, -9}, {0, 9, -9}, {0, 9, 9}, {0, -9, 9}}, {{0, 1, 2, 3}}), {}, {}});
    scene.lights = {areaLight({0, 0, 12}, {0, 0, -1}, 2, 1, 4)};
    for (bool leaveOut : {true, false}) {
        scene.settings.leaveOut = leaveOut;
        const AnyBuffer shadow = *test::frameOf(scene)->buffer({BufferId::Shadow, 0});
        for (std::size_t i = 0; i < shadow.count(); ++i) ASSERT_EQ(shadow.flat(i), 0.5);
    }
}

TEST(AreaLight, InOpenGlsModelIsAPoint) {
    Scene area = test::openGlCube();
    area.lights[0].kind = LightKind::Area, area.lights[0].position = {1, 2, 3};
    area.lights[0].gl.linear = 0.25;
    Scene point = area;
    point.lights[0].kind = LightKind::Point;
    EXPECT_EQ(test::firstDifference(*test::frameOf(point, setOf({BufferId::Color, BufferId::Intensity})),
                                    *test::frameOf(area, setOf({BufferId::Color, BufferId::Intensity})),
                                    setOf({BufferId::Color, BufferId::Intensity})),
              "");
    EXPECT_EQ(findSetting(area, "light.0.width")->setting->idle(area), "OpenGL's model has no shadows.");
    EXPECT_EQ(findSetting(area, "light.0.linear")->setting->idle(area), "");
    EXPECT_TRUE(inspectPixel(*test::frameOf(area), {320, 240}).shadowPlaces.empty());
}

TEST(AreaLight, AShadowFactorIsNamed) {
    const Light area = areaLight({}, {0, 0, -1}, 1, 1, 4);
    EXPECT_EQ(shadowPlace(area, 1), "lit");
    EXPECT_EQ(shadowPlace(area, 0.4375), "penumbra (S = 0.44)");
    EXPECT_EQ(shadowPlace(area, 0), "umbra");
    EXPECT_EQ(shadowPlace({LightKind::Point}, 0), "umbra");
    EXPECT_EQ(shadowPlace({LightKind::Point}, 4.0 / 9), "filtered edge (S = 0.44)");
    Light mild;
    mild.castsShadow = false;
    EXPECT_EQ(shadowPlace(mild, 1), "lit, casts no shadow");
}

TEST(AreaLight, RefusesWhatItCannotBe) {
    const auto check = [](auto change) {
        Scene scene = test::pyramid();
        scene.lights = {areaLight({0, 0, 500}, {0, 0, -1}, 10, 10, 4)};
        change(scene);
        const Errors errors = checkScene(scene);
        return errors.empty() ? std::string("accepted") : format(errors[0]);
    };
    EXPECT_EQ(check([](Scene&) {}), "accepted");
    EXPECT_EQ(check([](Scene& s) { s.lights[0].area.facing = Vec3d(0); }),
              "area light 0 faces the direction (0, 0, 0), expected a direction that is not zero");
}

TEST(AreaLight, ItsShadowBuffersAreDrawnAgainWhenItMovesOnly) {
    Scene scene = test::pyramid();
    scene.settings.shadowSize = 32;
    scene.objects.push_back(scene.objects[0]);
    scene.objects[1].transform.translation = {0, 300, 0};
    scene.lights = {areaLight({0, 0, 500}, {0, 0, -1}, 10, 10, 3)};
    const FramePtr first = test::frameOf(scene, {});
    EXPECT_EQ(first->run(StageId::ShadowBuffer).counts, "54 shadow buffers of 32²");
    const auto actionAfter = [&](auto change) {
        Scene other = scene;
        change(other.lights[0]);
        return test::frameOf(other, {}, 0, first)->plan()[index(StageId::ShadowBuffer)].action;
    };
    EXPECT_EQ(actionAfter([](Light& l) { l.color = {1, 0.5, 0}; }), Action::Reuse);
    EXPECT_EQ(actionAfter([](Light& l) { l.intensity = 7; }), Action::Reuse);
    EXPECT_EQ(actionAfter([](Light& l) { l.position.x = 1; }), Action::Run);
    EXPECT_EQ(actionAfter([](Light& l) { l.area.width = 11; }), Action::Run);
    EXPECT_EQ(actionAfter([](Light& l) { l.area.facing = {0, 1, -1}; }), Action::Run);
    EXPECT_EQ(actionAfter([](Light& l) { l.area.samples = 2; }), Action::Run);
}

}  // namespace
}  // namespace pipeline
