#include "pipeline/scene/settings_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace pipeline {
namespace {

Scene twoLights() {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.addPolygon(std::array{0u, 1u, 2u});
    Scene scene;
    scene.objects.push_back({"triangle", makeMesh(mesh), {}, {}});
    scene.lights.resize(2);
    return scene;
}

Scene with(const std::string& assignment) {
    const auto scene = withSetting(twoLights(), assignment);
    EXPECT_TRUE(scene) << assignment;
    return scene ? *scene : Scene{};
}

std::string refusal(const std::string& assignment) {
    const auto scene = withSetting(twoLights(), assignment);
    return scene ? "accepted" : format(scene.errors().front());
}

TEST(SettingsTable, KeysAreUniqueAndRowsAreSound) {
    std::set<std::string_view> keys;
    for (const Setting& row : settingsTable()) {
        EXPECT_TRUE(keys.insert(row.key).second) << row.key;
        EXPECT_LE(row.min, row.low) << row.key;
        EXPECT_LT(row.low, row.high) << row.key;
        EXPECT_LE(row.high, row.max) << row.key;
        EXPECT_TRUE(row.meaning.ends_with('.')) << row.key;
        const bool named = row.kind == SettingKind::Switch || row.kind == SettingKind::Choice;
        EXPECT_EQ(row.choices.empty(), !named) << row.key;
        EXPECT_TRUE(!named || row.max == double(row.choices.size() - 1)) << row.key;
    }
}

// The claim behind "every member has a row": changing any row changes the scene, only that row
// reads differently afterwards, and putting the value back gives the scene before.
TEST(SettingsTable, EveryRowReadsAndWritesItsOwnMember) {
    Scene before = twoLights();
    before.ambient.intensity = 0;  // where none is given, it is the model's
    for (const SettingRef& ref : settingsOf(before)) {
        const double old = ref.get(before);
        Scene scene = before;
        ref.set(scene, old == ref.setting->max ? ref.setting->min : ref.setting->max);
        EXPECT_FALSE(scene == before) << ref.key();
        // k_s of all three colours is the one row that moves others.
        const auto isSpecular = [](const SettingRef& r) { return r.setting->key.starts_with("material.#.ks"); };
        for (const SettingRef& other : settingsOf(before)) {
            if (isSpecular(ref) && isSpecular(other)) continue;
            EXPECT_EQ(other.get(scene) == other.get(before), !(other == ref)) << ref.key() << " and " << other.key();
        }
        ref.set(scene, old);
        EXPECT_TRUE(scene == before) << ref.key();
    }
}

// Pieces along a side of a square: 3 · 3 polygons, then 5 · 5.
TEST(SettingsTable, TessellationRemakesAShape) {
    Scene scene = twoLights();
    scene.objects[0].shape = Shape{ShapeKind::Plane, 3};
    scene.objects[0].mesh = makeShape(*scene.objects[0].shape);
    EXPECT_EQ(scene.objects[0].mesh->polygonCount(), 9u);
    const auto finer = withSetting(scene, "object.0.tessellation=5");
    ASSERT_TRUE(finer);
    EXPECT_EQ(finer->objects[0].shape, (Shape{ShapeKind::Plane, 5}));
    EXPECT_EQ(finer->objects[0].mesh->polygonCount(), 25u);
    EXPECT_TRUE(*withSetting(scene, "object.0.tessellation=3") == scene);  // the same mesh, nothing to do again
    const auto row = findSetting(scene, "object.0.tessellation");
    ASSERT_TRUE(row);
    EXPECT_EQ(row->setting->idle(scene), "");
    EXPECT_EQ(row->setting->idle(twoLights()), "No object is a built-in shape.");
}

// What would do nothing is no setting of the object: neither listed nor taken.
TEST(SettingsTable, AMeshHasNoTessellation) {
    EXPECT_EQ(refusal("object.0.tessellation=5"),
              "no setting \"object.0.tessellation\": the object is a mesh, not a built-in shape");
    Scene scene = twoLights();
    scene.objects.push_back(scene.objects[0]);
    scene.objects[1].shape = Shape{ShapeKind::Plane, 3};
    std::vector<std::string> listed;
    for (const SettingRef& ref : settingsOf(scene))
        if (ref.key().ends_with("tessellation")) listed.push_back(ref.key());
    EXPECT_EQ(listed, std::vector<std::string>{"object.1.tessellation"});
}

TEST(SettingsTable, ACompleteSceneValueIsCovered) {
    // All that a scene holds beside names, meshes, turns and back materials.
    // Settings 23, sub-pixel bits, pattern of samples, 6 forms, planted defect and its way; camera 2 + 5 + 9 + 2 + near, far; ambient 4; light 9, its area 6, of OpenGL's model 15 more;
    // object 10, for its mesh has no tessellation; material: k_d 3, k_s 1 + 3, n, k_a 3, emission 3, alpha, highlight; one switch a rule.
    const std::size_t expected = 23 + 8 + 2 + 20 + 4 + 2 * (9 + 6 + 15) + 10 + 16 + kRuleCount;
    EXPECT_EQ(settingsOf(twoLights()).size(), expected);
}

TEST(SettingsTable, ListsLightByLight) {
    std::vector<std::string> keys;
    for (const SettingRef& ref : settingsOf(twoLights())) keys.push_back(ref.key());
    const auto at = [&](const char* key) { return std::ranges::find(keys, key) - keys.begin(); };
    EXPECT_LT(at("light.0.kind"), at("light.0.space"));
    EXPECT_EQ(at("light.0.space") + 1, at("light.1.kind"));
}

TEST(SettingsTable, ReadsAssignments) {
    EXPECT_EQ(with("shading=gouraud").settings.shading, Shading::Gouraud);
    EXPECT_EQ(with("depth_format=fixed24").settings.depthFormat, DepthFormat::Fixed24);
    EXPECT_EQ(with("camera.kind=look-at").camera.kind, CameraKind::LookAt);
    EXPECT_EQ(with("light.1.x=-2.5e2").lights[1].position.x, -250);
    EXPECT_EQ(with("light.1.kind=point").lights[1].kind, LightKind::Point);
    EXPECT_FALSE(with("light.0.shadow=off").lights[0].castsShadow);
    EXPECT_EQ(with(" width = +16384 ").settings.width, 16384);
    EXPECT_EQ(with("material.0.ks=0.4").objects[0].material.specular, Vec3d(0.4));
    EXPECT_EQ(with("object.0.sz=-1").objects[0].transform.scale, Vec3d(1, 1, -1));
}

TEST(SettingsTable, RefusesWithWhatWasExpected) {
    EXPECT_EQ(refusal("light.0.intensity=abc"), "light.0.intensity is \"abc\", expected a number from -1e9 to 1e9");
    EXPECT_EQ(refusal("width=0"), "width is \"0\", expected a whole number from 1 to 16384");
    EXPECT_EQ(refusal("width=1.5"), "width is \"1.5\", expected a whole number from 1 to 16384");
    EXPECT_EQ(refusal("shading=phnog"), "shading is \"phnog\", expected flat, gouraud or phong");
    EXPECT_EQ(refusal("light.0.shadow=yes"), "light.0.shadow is \"yes\", expected off or on");
    EXPECT_EQ(refusal("width"), "found \"width\", expected KEY=VALUE");
    for (const char* value : {"nan", "inf", "1e999", "", "1 2", "0x10", "1,5", "--1", "+-1"})
        EXPECT_NE(refusal(std::string("camera.near=") + value), "accepted") << value;
}

TEST(SettingsTable, AnswersAnUnknownKeyWithTheNearest) {
    EXPECT_EQ(refusal("shadign=flat"), "no setting \"shadign\"; the nearest is \"shading\"");
    EXPECT_EQ(refusal("light.0.intensty=1"), "no setting \"light.0.intensty\"; the nearest is \"light.0.intensity\"");
    EXPECT_EQ(refusal("light.2.x=1"), "no setting \"light.2.x\", expected light 0 to 1");
    EXPECT_NE(refusal("light.#.x=1"), "accepted");
    EXPECT_NE(refusal("camera.0.rho=1"), "accepted");
    const auto dark = withSetting(Scene{}, "light.0.x=1");
    ASSERT_FALSE(dark);
    EXPECT_EQ(format(dark.errors()[0]), "no setting \"light.0.x\": this scene has no light");
}

TEST(SettingsTable, FormatsWhatItParses) {
    const Scene scene = twoLights();
    for (const SettingRef& ref : settingsOf(scene)) {
        const bool whole = ref.setting->kind != SettingKind::Number;
        for (double value : {ref.setting->min, ref.setting->max, (ref.setting->low + ref.setting->high) / 3}) {
            if (whole) value = std::floor(value);
            const std::string text = formatSetting(ref, value);
            const auto back = parseSetting(ref, text);
            ASSERT_TRUE(back) << ref.key() << '=' << text;
            EXPECT_EQ(*back, value) << ref.key() << '=' << text;
        }
    }
}

TEST(SettingsTable, SaysWhyASettingIsIdle) {
    const auto idle = [](const Scene& scene, const char* key) {
        return std::string(findSetting(scene, key).value().setting->idle(scene));
    };
    const Scene scene = twoLights();
    EXPECT_EQ(idle(scene, "shadow.bias_value"), "Bias is automatic; choose constant to change it.");
    EXPECT_EQ(idle(with("shadow.bias=constant"), "shadow.bias_value"), "");
    EXPECT_EQ(idle(scene, "camera.eye_x"), "The camera is spherical; choose look-at to change it.");
    EXPECT_EQ(idle(with("camera.kind=look-at"), "camera.eye_x"), "");
    EXPECT_EQ(idle(with("camera.kind=look-at"), "camera.rho"), "The camera is look-at; choose spherical to change it.");
    // A spherical camera's orthographic picture has the scale of its perspective one.
    EXPECT_EQ(idle(with("camera.projection=orthographic"), "camera.distance"), "");
    EXPECT_EQ(idle(with("camera.projection=orthographic"), "camera.height"), idle(scene, "camera.eye_x"));
    EXPECT_EQ(idle(with("camera.kind=look-at"), "camera.height"),
              "The projection is perspective; choose orthographic to change it.");
    EXPECT_EQ(idle(scene, "material.0.n"), "k_s is 0 in every material.");
    Scene shinyBack = scene;
    shinyBack.objects[0].backMaterial = Material{Vec3d(0.5), Vec3d(0.5), 8};
    EXPECT_EQ(idle(shinyBack, "material.0.n"), "");
    EXPECT_EQ(idle(with("shading=phong"), "normal_weight"), "");
    Scene unshadowed = scene;
    for (Light& light : unshadowed.lights) light.castsShadow = false;
    EXPECT_EQ(idle(unshadowed, "shadow.size"), "No light casts a shadow.");
}

TEST(CheckScene, AcceptsDefaults) { EXPECT_EQ(format(checkScene(twoLights())), ""); }

TEST(CheckScene, RefusesWhatNoSingleSettingCan) {
    const auto check = [](auto change) {
        Scene scene = twoLights();
        change(scene);
        const Errors errors = checkScene(scene);
        return errors.empty() ? std::string("accepted") : format(errors[0]);
    };
    EXPECT_EQ(check([](Scene& s) { s.camera.near = 5, s.camera.far = 5; }),
              "camera.near is 5, expected less than camera.far, which is 5");
    EXPECT_EQ(check([](Scene& s) { s.camera.near = 5; }), "accepted");  // far comes from the bounds
    EXPECT_EQ(check([](Scene& s) { s.camera.kind = CameraKind::LookAt, s.camera.target = s.camera.eye; }),
              "accepted");  // scene_remarks_test.cpp has what it means
    EXPECT_EQ(check([](Scene& s) {
                  s.camera.kind = CameraKind::LookAt;
                  s.camera.up = s.camera.target - s.camera.eye;
              }),
              "accepted");  // the view falls back
    EXPECT_EQ(check([](Scene& s) { s.lights[1].position = Vec3d(0.0); }),
              "light 1 is at infinity in the direction (0, 0, 0), expected a direction that is not zero");
    EXPECT_EQ(check([](Scene& s) { s.lights[1].kind = LightKind::Point, s.lights[1].position = Vec3d(0.0); }),
              "accepted");
    EXPECT_EQ(check([](Scene& s) { s.camera.rho = std::numeric_limits<double>::quiet_NaN(); }),
              "camera.rho is nan, expected a value from 0 to 1e9");
    EXPECT_EQ(check([](Scene& s) { s.objects[0].transform.scale.x = 2e8, s.objects[0].transform.translation.x = 9e8; }),
              "object 0 reaches 1.1e9 world units, expected at most 1e9");
    // Its corners are within (1, 1, 0), √2 long: 1e9 to three digits, as the bound is.
    EXPECT_EQ(check([](Scene& s) { s.objects[0].transform.translation.x = 1e9; }),
              "object 0 reaches 1000000001 world units, expected at most 1e9");
}

}  // namespace
}  // namespace pipeline
