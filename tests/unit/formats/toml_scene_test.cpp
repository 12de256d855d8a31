#include "pipeline/formats/toml/toml_scene.h"
#include "pipeline/formats/toml/toml_text.h"

#include <gtest/gtest.h>

#include "pipeline/formats/format_table.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/scene/settings_table.h"
#include "tests/support/files.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

Result<NamedFile> someFile(std::string_view name) {
    if (name == "t.des") return NamedFile{"3 1\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n0.2 0.5 0.9 0.4 8\n", "t.des"};
    return Error{{}, "no such file", {}};
}

Result<Scene> read(std::string_view text) { return readTomlScene({text, "s.toml"}, someFile); }
std::string errorsIn(std::string_view text) {
    const auto scene = read(text);
    return scene ? "" : format(scene.errors());
}
const std::string kSphere = "[[object]]\nshape = \"sphere\"\n";

TEST(TomlScene, ReadsSettingsVectorsAndTables) {
    const auto scene = read(R"(
title = "Two things"
look = "Look here."
width = 320
shading = "phong"
shadow.size = 64
[camera]
kind = "look-at"
eye = [1, 2.5, -3]
fov = 30
[ambient]
intensity = 0.5
color = 0.25
[[light]]
kind = "point"
position = [4, 5, 6]
color = [1, 0.5, 0]
shadow = false
attenuation = [1, 0.5, 0.25]
spot_cutoff = 30
space = "eye"
[[object]]
name = "ball"
shape = "sphere"
tessellation = 3
scale = [2, 2, 2]
turns = [[20, 1, 0, 0], [30, 0, 1, 0]]
[object.material]
diffuse = [0.1, 0.2, 0.3]
n = 20
[object.back_material]
diffuse = 1
[[object]]
mesh = "t.des"
)");
    ASSERT_TRUE(scene) << format(scene.errors());
    EXPECT_EQ(scene->name, "Two things");
    EXPECT_EQ(scene->look, "Look here.");
    EXPECT_EQ(scene->settings.width, 320);
    EXPECT_EQ(scene->settings.shading, Shading::Phong);
    EXPECT_EQ(scene->settings.shadowSize, 64);
    EXPECT_EQ(scene->camera.eye, Vec3d(1, 2.5, -3));
    EXPECT_EQ(scene->camera.fovY, 30);
    EXPECT_EQ(scene->ambient.color, Vec3d(0.25));
    ASSERT_EQ(scene->lights.size(), 1u);
    const Light& light = scene->lights[0];
    EXPECT_EQ(light.kind, LightKind::Point);
    EXPECT_EQ(light.position, Vec3d(4, 5, 6));
    EXPECT_FALSE(light.castsShadow);
    EXPECT_EQ(light.gl.specular, Vec3d(1, 0.5, 0));  // the colour, where none is given
    EXPECT_EQ(light.gl.quadratic, 0.25);
    EXPECT_EQ(light.gl.spotCutoff, 30);
    EXPECT_EQ(light.gl.space, LightSpace::Eye);
    ASSERT_EQ(scene->objects.size(), 2u);
    const Object& ball = scene->objects[0];
    EXPECT_EQ(ball.name, "ball");
    EXPECT_EQ(ball.mesh->polygonCount(), 4u * 3 * 2 * 3);
    EXPECT_EQ(ball.transform.turns, (std::vector<AxisTurn>{{20, {1, 0, 0}}, {30, {0, 1, 0}}}));
    EXPECT_EQ(ball.material.ambient, Vec3d(0.1, 0.2, 0.3));  // the diffuse one, where none is given
    EXPECT_EQ(ball.material.exponent, 20);
    ASSERT_TRUE(ball.backMaterial);
    EXPECT_EQ(ball.backMaterial->diffuse, Vec3d(1));
    EXPECT_EQ(scene->objects[1].name, "t");
    EXPECT_EQ(scene->objects[1].material.diffuse, Vec3d(0.2, 0.5, 0.9));
}

// Tables, reports and the outline tell objects by their names.
TEST(TomlScene, AnObjectWithoutANameHasItsNumber) {
    const auto scene =
        read("[[object]]\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\npolygons = [[0, 1, 2]]\n" + kSphere);
    ASSERT_TRUE(scene) << format(scene.errors());
    EXPECT_EQ(scene->objects[0].name, "object 0");
    EXPECT_EQ(scene->objects[1].name, "sphere");
}

// OpenGL's GL_LIGHT_MODEL_AMBIENT is (0.2, 0.2, 0.2) until a program sets it; a colour alone sets no intensity.
TEST(TomlScene, AnAmbientLightThatIsNotGivenIsTheModels) {
    const auto ambient = [](std::string_view text, std::string_view assignment) {
        const auto scene = withSetting(*read(text), assignment);
        return scene->ambient.lightIn(scene->settings.model);
    };
    EXPECT_EQ(ambient("model = \"opengl\"", "width=9"), Vec3d(0.2));
    EXPECT_EQ(ambient("model = \"opengl\"\n[ambient]\ncolor = [1, 0, 0.5]", "width=9"), Vec3d(0.2, 0, 0.1));
    EXPECT_EQ(ambient("model = \"opengl\"\n[ambient]\nintensity = 0", "width=9"), Vec3d(0));
    EXPECT_EQ(ambient("", "width=9"), Vec3d(0));
    EXPECT_EQ(ambient("", "model=blinn-phong"), Vec3d(0));
    EXPECT_EQ(ambient("", "model=opengl"), Vec3d(0.2));
    EXPECT_EQ(ambient("model = \"opengl\"", "model=phong"), Vec3d(0));
    EXPECT_EQ(ambient("[ambient]\nintensity = 50", "model=opengl"), Vec3d(50));
    EXPECT_EQ(ambient("model = \"opengl\"", "ambient.intensity=0"), Vec3d(0));
}

// Three letters of "abxera" are not those of "camera": too many for the nearest alone, fewer than of any other key.
TEST(TomlScene, NamesATableOnceAmongTheKeys) {
    const std::string errors = errorsIn("abxera = 1\n" + kSphere), camera = "\"camera\"";
    const std::size_t first = errors.find(camera);
    ASSERT_NE(first, errors.npos) << errors;
    EXPECT_EQ(errors.find(camera, first + 1), errors.npos) << errors;
}

TEST(TomlScene, GivesPlaceAndExpectationOfWhatIsWrong) {
    EXPECT_EQ(errorsIn("shadin = 3\n" + kSphere), "s.toml:1:1: no key \"shadin\"; the nearest is \"shading\"\n");
    EXPECT_EQ(errorsIn("[camera]\n  fov = 200\n" + kSphere),
              "s.toml:2:9: camera.fov is 200, expected a number from 0.01 to 179.99\n");
    EXPECT_EQ(errorsIn("shading = 1\n" + kSphere),
              "s.toml:1:11: shading is 1, expected \"flat\", \"gouraud\" or \"phong\"\n");
    EXPECT_EQ(errorsIn("camera.eye = [1, 2]\n" + kSphere),
              "s.toml:1:14: camera.eye is an array of 2, expected an array of 3 numbers from -1e9 to 1e9\n");
    EXPECT_EQ(errorsIn("[camera]\nfov = nan\n" + kSphere),
              "s.toml:2:7: camera.fov is not finite, expected a number from 0.01 to 179.99\n");
    EXPECT_EQ(errorsIn("[[object]]\nmesh = \"no.des\"\n"), "s.toml:2:8: no such file\n");
    EXPECT_EQ(errorsIn("[[object]]\nvertices = [[0, 0, nan], [1, 0, 0], [0, 1, 0]]\npolygons = [[0, 1, 2]]\n"),
              "s.toml:2:20: object.0.vertices is not finite, expected a number from -1e9 to 1e9\n")
        << "and no more about polygons whose vertices are not known";
    EXPECT_EQ(errorsIn("[[object]]\nshape = \"plane\"\nturns = [[20, 0, 0, 0]]\n"),
              "s.toml:3:10: the axis of a turn is (0, 0, 0), expected a direction\n");
    EXPECT_EQ(errorsIn("[[object]]\nname = \"a\"\n"),
              "s.toml:1:1: object.0 has none or several of shape, mesh, model and vertices, expected one of them\n");
    EXPECT_EQ(errorsIn("[[object]]\nmesh = \"t.des\"\ntessellation = 4\n"),
              "s.toml:3:16: no key \"object.0.tessellation\": the object is a mesh, not a built-in shape\n");
    EXPECT_EQ(errorsIn("[[object]]\nshape = \"bal\"\ntessellation = 4\n"),
              "s.toml:2:9: object.0.shape is \"bal\", expected \"plane\", \"box\", \"sphere\", \"cylinder\", "
              "\"torus\" or \"teapot\"\n")
        << "and no more about its tessellation";
    for (const char* header : {"[=]\n", "[\x04]\n", "[.a]\n", "[[\xC3\xA9]]\n"})
        EXPECT_TRUE(errorsIn(header).starts_with("s.toml:1:")) << header;
    EXPECT_TRUE(errorsIn("a = \n").starts_with("s.toml:1:")) << errorsIn("a = \n");
    EXPECT_EQ(errorsIn("title = \"nothing\"\n"), "");  // a picture of the background
}

TEST(TomlScene, ReportsSeveralErrorsInTheOrderOfTheFile) {
    EXPECT_EQ(errorsIn("width = 0\ncull = 3\n" + kSphere + "[object.material]\nn = -1\n"),
              "s.toml:1:9: width is 0, expected a whole number from 1 to 16384\n"
              "s.toml:2:8: cull is 3, expected \"none\" or \"back\"\n"
              "s.toml:6:5: material.0.n is -1, expected a number from 0 to 1000000\n");
    std::string many;
    for (int i = 0; i < 50; ++i) many += "unknown" + std::to_string(i) + " = 1\n";
    EXPECT_EQ(read(many).errors().size(), kMaxErrors);
}

TEST(TomlScene, IsKnownByItsFirstLine) {
    EXPECT_TRUE(looksLikeTomlScene("# a scene\n\ntitle = \"a\"\n"));
    EXPECT_TRUE(looksLikeTomlScene("[camera]\n"));
    EXPECT_FALSE(looksLikeTomlScene("200, 1000, 45, 60 // d\n"));
    EXPECT_FALSE(looksLikeTomlScene("v 1 2 3\n"));
    EXPECT_FALSE(looksLikeTomlScene(""));
}

// Every scene that comes with the program draws something, and says what to look at.
TEST(BuiltInScenes, RenderSomethingAndSayWhatToLookAt) {
    for (const BuiltInScene& builtIn : builtInScenes()) {
        auto read = readScene(builtIn.file);
        ASSERT_TRUE(read) << format(read.errors());
        EXPECT_TRUE(builtIn.look.ends_with('.')) << builtIn.name;
        EXPECT_FALSE(builtIn.title.empty()) << builtIn.name;
        const Scene scene = std::move(read).value();
        const BufferName seen = *findBuffer("object_id");
        const FramePtr frame = test::frameOf(scene, BufferSet().set(static_cast<std::size_t>(seen.id)));
        ASSERT_TRUE(frame);
        const auto objects = frame->buffer(seen).value();
        std::size_t drawn = 0;
        for (std::size_t i = 0; i < objects.count(); ++i) drawn += objects.flat(i) >= 0 ? 1 : 0;
        EXPECT_GT(drawn, objects.count() / 200) << builtIn.name;
    }
}

// The example of the manual is a scene.
TEST(TomlScene, TheManualsExampleCanBeRead) {
    const auto manual = readFile(resourceFolder() / "manual" / "scene-files.md");
    ASSERT_TRUE(manual);
    const auto begin = manual->find("```toml\n");
    ASSERT_NE(begin, std::string::npos);
    const auto end = manual->find("```", begin + 3);
    const auto scene = read(std::string_view(*manual).substr(begin + 8, end - begin - 8));
    EXPECT_TRUE(scene) << format(scene.errors());
}

TEST(TomlText, FindsCharactersThatStandOutsideStringsAndComments) {
    const auto at = [](std::string_view text) { return strayCharacter(text).value_or(TextPosition()); };
    EXPECT_EQ(at("model = \u00e9"), (TextPosition{1, 9}));
    EXPECT_EQ(at("a = 1 # \u00e9\nb = '\u00e9\u00e9' \u00e9"), (TextPosition{2, 10}));
    for (const char* good :
         {"title = \"\u00e9 \\\" \u00e9\"", "look = '\u00e9' # \u00e9", "a = \"\"\"\u00e9\n\u00e9\"\"\"",
          "a = \'\'\'\u00e9\n\"\u00e9\'\'\'", "\xef\xbb\xbfmodel = 1", ""})
        EXPECT_FALSE(strayCharacter(good)) << good;
}

TEST(TomlText, FindsKeysOfMorePartsThanAnySceneHas) {
    const auto keyOf = [](int parts) {
        std::string key = "a";
        for (int i = 1; i < parts; ++i) key += ".a";
        return key;
    };
    EXPECT_FALSE(deepKey(keyOf(16) + " = 1"));
    EXPECT_EQ(deepKey("b = 1\n" + keyOf(17) + " = 1"), (TextPosition{2, 32}));  // the 16th point
    EXPECT_TRUE(deepKey("[" + keyOf(17) + "]"));
    EXPECT_TRUE(deepKey("a = { \"b\" . 'c' . " + keyOf(15) + " = 1 }"));
    std::string numbers = "a = [";
    for (int i = 0; i < 100; ++i) numbers += "1.5, ";
    EXPECT_FALSE(deepKey(numbers + "]"));
    EXPECT_FALSE(deepKey("a = \"" + keyOf(100) + "\" # " + keyOf(100)));
}

// toml++ would take the tables down one inside the other, until the stack ends.
TEST(TomlScene, AKeyOfAMillionPartsIsAnError) {
    std::string text = "title = \"t\"\na";
    for (int i = 0; i < 1'000'000; ++i) text += ".a";
    EXPECT_EQ(errorsIn(text + " = 1\n"),
              "s.toml:2:32: this key has more than 16 parts, expected a key that a scene has\n");
    EXPECT_EQ(readTomlTitle(text + " = 1\n").title, "");
}

// As it is named there, with its folder: what is said of it names a file that is there.
TEST(TomlScene, AModelIsCalledAsTheSceneNamesIt) {
    const test::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "sub");
    test::writeText(folder / "sub" / "x.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    test::writeText(folder / "s.toml", "[[object]]\nmodel = \"sub/x.obj\"\n");
    const auto scene = readScene(folder / "s.toml");
    ASSERT_TRUE(scene) << format(scene.errors());
    EXPECT_EQ(scene->objects[0].mesh->file, "sub/x.obj");
    const auto alone = readScene(folder / "sub" / "x.obj");
    ASSERT_TRUE(alone) << format(alone.errors());
    EXPECT_EQ(alone->objects[0].mesh->file, "x.obj");
}

}  // namespace
}  // namespace pipeline
