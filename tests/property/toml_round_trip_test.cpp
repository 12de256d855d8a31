// A scene that was written as TOML and read again gives the same frame, bit for bit.
#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/formats/toml/toml_scene.h"
#include "pipeline/formats/toml/toml_writer.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

Result<Scene> readAgain(const Scene& scene) {
    const Result<std::string> text = toTomlScene(scene);
    if (!text) return text.errors();
    return readTomlScene({*text, "written.toml"}, [](std::string_view) -> Result<NamedFile> {
        return Error{{}, "the written scene names a file", {}};
    });
}

class TomlRoundTrip : public testing::TestWithParam<unsigned> {};
INSTANTIATE_TEST_SUITE_P(Shards, TomlRoundTrip, testing::Range(0u, 20u));

TEST_P(TomlRoundTrip, KeepsEveryBitOfTheFrame) {
    for (unsigned seed = GetParam(); seed < 400; seed += 20) {
        for (Scene scene : {test::smallScene(seed), test::strangeScene(seed)}) {
            scene.settings.width = 40, scene.settings.height = 30;
            if (seed % 3 == 0) scene.settings.forms.power = PowerForm::Schlick;
            if (seed % 5 == 0 && !scene.objects.empty()) scene.objects[0].backMaterial = Material{Vec3d(0.1, 0.2, 0.3)};
            if (seed % 7 == 0 && !scene.objects.empty()) scene.objects[0].transform.turns = {{33.3, {1, 2, 3}}};
            if (scene.settings.model == Model::OpenGl)  // which refuses more
                for (Object& object : scene.objects)
                    object.material.exponent = std::min(object.material.exponent, 128.0);
            scene.name = "quotes \" and backslashes \\ \u00e9";  // no control characters: a title has none
            const Result<Scene> again = readAgain(scene);
            ASSERT_TRUE(again) << seed << ' ' << format(again.errors());
            EXPECT_EQ(again->name, scene.name);
            EXPECT_TRUE(again->settings == scene.settings) << seed;
            EXPECT_TRUE(again->camera == scene.camera) << seed;
            EXPECT_TRUE(again->lights == scene.lights) << seed;
            ASSERT_EQ(test::firstDifference(*test::frameOf(scene), *test::frameOf(*again)), "") << "seed " << seed;
        }
    }
}

TEST(TomlRoundTripOf, AShapeStaysAShape) {
    Scene scene = test::pyramid();
    scene.objects[0].shape = Shape{ShapeKind::Torus, 7};
    scene.objects[0].mesh = makeShape(*scene.objects[0].shape);
    const Result<Scene> again = readAgain(scene);
    ASSERT_TRUE(again) << format(again.errors());
    ASSERT_TRUE(again->objects[0].shape);
    EXPECT_TRUE(*again->objects[0].shape == *scene.objects[0].shape);
}

TEST(TomlRoundTripOf, AnUnchangedSceneWritesNoDefaults) {
    Scene scene;
    scene.name = "empty";
    EXPECT_EQ(*toTomlScene(scene), "title = \"empty\"\n");
}

// Given or not is kept too: in OpenGL's model 0.2 stands for what is not given, in the others 0.
TEST(TomlRoundTripOf, AnAmbientLightStaysGivenOrNot) {
    for (const Model model : {Model::Phong, Model::BlinnPhong, Model::OpenGl, Model::CookTorrance})
        for (const std::optional<double> intensity : {std::optional<double>(), {0.0}, {0.2}, {-0.0}, {40.0}}) {
            Scene scene;
            scene.settings.model = model;
            scene.ambient.intensity = intensity;
            const Result<Scene> again = readAgain(scene);
            ASSERT_TRUE(again) << format(again.errors());
            EXPECT_EQ(again->ambient, scene.ambient) << int(model) << ' ' << intensity.value_or(-1);
        }
}

TEST(TomlMesh, MistakesHaveTheirPlace) {
    const auto errors = [](std::string_view object) {
        const std::string text = "[[object]]\n" + std::string(object);
        const auto scene = readTomlScene({text, "x.toml"}, [](std::string_view) -> Result<NamedFile> {
            return Error{{}, "no file", {}};
        });
        return scene ? std::string("read") : format(scene.errors());
    };
    const std::string vertices = "vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\n";
    EXPECT_EQ(errors(vertices + "polygons = [[0, 1, 2]]"), "read");
    EXPECT_NE(errors(vertices).find("object.0 has no polygons"), std::string::npos) << errors(vertices);
    EXPECT_EQ(errors(vertices + "polygons = [[0, 1, 3]]"),
              "x.toml:3:20: a polygon's vertex is 3, expected a whole number from 0 to 2\n");
    EXPECT_NE(errors(vertices + "polygons = [[0, 1]]").find("x.toml:3:13"), std::string::npos);
    EXPECT_NE(errors(vertices + "polygons = [[0, 1, 2.5]]").find("x.toml:3:20"), std::string::npos);
    EXPECT_NE(errors(vertices + "normals = [[0, 0, 1]]\npolygons = [[0, 1, 2]]").find("1 normals for 3 vertices"),
              std::string::npos);
    EXPECT_NE(errors("vertices = 5\npolygons = []").find("x.toml:2:12"), std::string::npos);
    EXPECT_NE(errors(vertices + "shape = \"box\"\npolygons = [[0, 1, 2]]").find("none or several"), std::string::npos);
}

}  // namespace
}  // namespace pipeline
