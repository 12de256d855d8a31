// Sweeps as a study takes them: keys, values, ranges, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/core/result.h"
#include "pipeline/study/sweep.h"
#include "tests/support/scenes.h"

using namespace pipeline;
using Texts = std::vector<std::string>;

namespace {

Scene sphereScene() {
    Scene scene = test::pyramid();
    Object sphere;
    sphere.name = "sphere";
    sphere.shape = Shape{ShapeKind::Sphere, 4};
    sphere.mesh = makeShape(*sphere.shape);
    scene.objects.push_back(sphere);
    return scene;
}

Texts valuesOfAxis(const Scene& scene, std::string_view text) {
    const auto axis = parseSweep(scene, text);
    return axis ? axis->values : Texts{"refused: " + format(axis.errors())};
}

TEST(Sweep, takesValuesByCommaAsSetDoes) {
    EXPECT_EQ(valuesOfAxis(test::pyramid(), "shading=flat,phong"), (Texts{"flat", "phong"}));
    EXPECT_EQ(valuesOfAxis(test::pyramid(), "camera.rho=1e3,+500"), (Texts{"1000", "500"}));
    EXPECT_EQ(valuesOfAxis(test::pyramid(), "precision=all"), (Texts{"float", "double", "extended", "quad"}));
}

TEST(Sweep, takesRangesOfNumbers) {
    EXPECT_EQ(valuesOfAxis(test::pyramid(), "width=4..7"), (Texts{"4", "5", "6", "7"}));
    EXPECT_EQ(valuesOfAxis(test::pyramid(), "shadow.size=64..1024*4"), (Texts{"64", "256", "1024"}));
    // 0.1 has no exact double: the last value is reached all the same, and is the one that was written.
    EXPECT_EQ(valuesOfAxis(test::pyramid(), "material.0.ks=0..0.3+0.1").back(), "0.3");
    EXPECT_EQ(valuesOfAxis(test::pyramid(), "material.0.ks=0..0.3+0.1").size(), 4u);
    EXPECT_EQ(valuesOfAxis(test::pyramid(), "camera.rho=1e-3..1e+3*1e3"), (Texts{"0.001", "1", "1000"}));
    // A range stops at the last value that is not beyond its end.
    EXPECT_EQ(valuesOfAxis(test::pyramid(), "width=10..25+10"), (Texts{"10", "20"}));
}

TEST(Sweep, changesTheSameSettingOfEveryObject) {
    const Scene scene = sphereScene();
    const auto axis = parseSweep(scene, "tessellation=8");
    ASSERT_TRUE(axis);
    EXPECT_EQ(sweptSettings(scene, "tessellation")->size(), 1u);  // the pyramid is a mesh
    EXPECT_EQ(sweptSettings(scene, "material.#.n")->size(), 2u);
    EXPECT_EQ(sweptSettings(scene, "object.1.tessellation")->size(), 1u);
    // "width" is the picture's, though light.#.width ends like it.
    EXPECT_EQ(sweptSettings(scene, "width")->front().key(), "width");
    const auto changed = sceneAt(scene, {&*axis, 1}, std::vector<std::string>{"8"});
    ASSERT_TRUE(changed);
    EXPECT_EQ(changed->objects[1].shape->tessellation, 8);
    EXPECT_EQ(changed->objects[0].mesh, scene.objects[0].mesh);  // not a shape
}

TEST(Sweep, refusesWhatSaysNothingOrTooMuch) {
    const Scene scene = test::pyramid();
    const auto message = [&](const std::string& text) {
        const auto sweep = parseSweeps(scene, Texts{text});
        return sweep ? "accepted" : format(sweep.errors().front());
    };
    EXPECT_EQ(message("shadng=flat"), "no setting \"shadng\"; the nearest is \"shading\"");
    EXPECT_TRUE(message("=1,640").starts_with("no setting \"\"; there are ")) << message("=1,640");
    EXPECT_EQ(message("shading=flat,flat"), "shading takes the value flat twice, expected each value once");
    EXPECT_NE(message("width=7..4").find("does not get from 7 to 4"), std::string::npos);
    EXPECT_NE(message("width=4..7*1").find("a factor that leads there"), std::string::npos);
    EXPECT_NE(message("width=4..7+0.5").find("holds 4.5, expected whole numbers"), std::string::npos);
    EXPECT_NE(message("nothing").find("KEY=VALUES or one of shading, depth"), std::string::npos);
    EXPECT_NE(message("shadow.bias_value=1,2").find("has no effect"), std::string::npos);
    EXPECT_EQ(message("tessellation=4,8"), "no setting \"tessellation\": the object is a mesh, not a built-in shape");
    EXPECT_NE(message("normals").find("needs a built-in shape"), std::string::npos);
    const auto twice = parseSweeps(scene, Texts{"width=4", "width=5"});
    EXPECT_EQ(format(twice.errors().front()), "width is swept twice, expected each setting once");
    // The sphere is object 1, the pyramid no shape; "tessellation" and "object.#.tessellation" are that one setting.
    const auto refusalOf = [](Texts texts) {
        const auto sweep = parseSweeps(sphereScene(), texts);
        return sweep ? "accepted" : format(sweep.errors().front());
    };
    EXPECT_EQ(
        refusalOf({"tessellation=4,8", "object.#.tessellation=4,8"}),
        "object.1.tessellation is swept twice, as tessellation and as object.#.tessellation, expected each setting "
        "once");
    EXPECT_EQ(refusalOf({"normals", "object.1.tessellation=5"}),
              "object.1.tessellation is swept twice, as object.#.tessellation and as object.1.tessellation, expected "
              "each setting once");
    EXPECT_EQ(refusalOf({"material.0.n=4,8", "material.1.n=4,8"}), "accepted") << "of two objects";
    const auto many = parseSweeps(scene, Texts{"width=1..300", "height=1..300"});
    EXPECT_EQ(format(many.errors().front()), "the sweep has more than 10000 points, expected fewer values");
}

// The bias value counts with a constant bias alone: an axis that chooses that one gives it its effect.
TEST(Sweep, letsOneAxisGiveAnotherItsEffect) {
    EXPECT_TRUE(parseSweeps(test::pyramid(), Texts{"shadow.bias=automatic,constant", "shadow.bias_value=1,2"}));
}

TEST(Sweep, countsPointsWithTheLastAxisFastest) {
    const auto sweep = parseSweeps(test::pyramid(), Texts{"shading=flat,phong", "width=1..3"});
    ASSERT_TRUE(sweep);
    EXPECT_EQ(pointCount(sweep->axes), 6u);
    EXPECT_EQ(valuesOf(sweep->axes, 0), (Texts{"flat", "1"}));
    EXPECT_EQ(valuesOf(sweep->axes, 1), (Texts{"flat", "2"}));
    EXPECT_EQ(valuesOf(sweep->axes, 3), (Texts{"phong", "1"}));
}

TEST(Sweep, readyMadeOnesFitTheScenesThatTheyAreFor) {
    Scene scene = sphereScene();
    scene.objects[1].material.specular = Vec3d(0.5);
    for (const NamedSweep& named : namedSweeps()) {
        const auto sweep = parseSweeps(scene, Texts{std::string(named.name)});
        ASSERT_TRUE(sweep) << named.name << ": " << format(sweep.errors());
        EXPECT_GT(pointCount(sweep->axes), 3u) << named.name;
        for (std::size_t i = 0; i < pointCount(sweep->axes); ++i)
            EXPECT_TRUE(sceneAt(scene, sweep->axes, valuesOf(sweep->axes, i))) << named.name << " point " << i;
    }
}

// OpenGL refuses an exponent above 128: a point with one would have no result.
TEST(Sweep, readyMadeExponentsStayWithinWhatTheModelTakes) {
    Scene scene = sphereScene();
    for (Object& object : scene.objects) object.material.specular = Vec3d(0.5);
    scene.settings.model = Model::OpenGl;
    for (const char* name : {"specular", "power"}) {
        const auto sweep = parseSweeps(scene, Texts{name});
        ASSERT_TRUE(sweep) << name << ": " << format(sweep.errors());
        const auto exponents = std::ranges::find(sweep->axes, "material.#.n", &SweepAxis::key);
        ASSERT_NE(exponents, sweep->axes.end());
        EXPECT_EQ(exponents->values.back(), "128") << "the sharpest highlight that there is";
        for (std::size_t i = 0; i < pointCount(sweep->axes); ++i) {
            const auto at = sceneAt(scene, sweep->axes, valuesOf(sweep->axes, i));
            EXPECT_TRUE(at) << name << " point " << i << ": " << format(at.errors());
        }
    }
}

// Of a light without a shadow there is no error of one, and the plot would show something else instead.
TEST(Sweep, shadowIsAboutTheFirstLightThatCastsOne) {
    Scene scene = test::pyramid();
    scene.lights.assign(3, scene.lights.front());
    const auto buffer = [&] {
        const auto sweep = parseSweeps(scene, Texts{"shadow"});
        return sweep && sweep->choice ? sweep->choice->buffer : "refused";
    };
    EXPECT_EQ(buffer(), "shadow.0");
    scene.lights[0].castsShadow = false;
    EXPECT_EQ(buffer(), "shadow.1");
    scene.lights[1].intensity = 0;
    EXPECT_EQ(buffer(), "shadow.2");
    scene.lights[2].color = Vec3d(0);
    EXPECT_EQ(buffer(), "refused") << "no light is left";
}

}  // namespace
