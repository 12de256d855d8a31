// What no single value is wrong about is told at the place of a value that it comes from.
#include "pipeline/scene/key_places.h"

#include <gtest/gtest.h>

#include "pipeline/formats/lecture/lecture_formats.h"
#include "pipeline/formats/toml/toml_scene.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

Result<NamedFile> anyFile(std::string_view name) {
    return NamedFile{"3 1\n0 0 0 9e8 0 0 0 9e8 0\n3 0 1 2\n0.2 0.5 0.9 0.4 200\n", std::string(name)};
}

std::string refusalOf(const std::string& text) {
    const auto scene = readTomlScene({text, "s.toml"}, anyFile);
    return scene ? "read" : format(scene.errors());
}

const std::string kOpenGl = "model = \"opengl\"\n";

TEST(KeyPlaces, TakesTheFirstKeyThatWasGivenThenTheFirstTable) {
    KeyPlaces places;
    places.add("light.0", {"f", 1, 1});
    places.add("camera.far", {"f", 2, 2});
    Error far{{}, "a"}, light{{}, "b"}, unknown{{}, "c"};
    far.keys = {"camera.near", "camera.far"};
    light.keys = {"light.0.x"};
    unknown.keys = {"width"};
    const Errors placed = places.placed({far, light, unknown});
    EXPECT_EQ(placed[0].where, (SourceLocation{"f", 2, 2}));
    EXPECT_EQ(placed[1].where, (SourceLocation{"f", 1, 1}));
    EXPECT_EQ(placed[2].where, SourceLocation());
    places.add("camera.near", {"f", 3, 3});
    EXPECT_EQ(places.placed({far})[0].where, (SourceLocation{"f", 3, 3}));
}

TEST(KeyPlaces, OfATomlSceneAreThoseOfItsValues) {
    EXPECT_EQ(refusalOf("[camera]\nnear = 5\nfar = 4\n"),
              "s.toml:2:8: camera.near is 5, expected less than camera.far, which is 4\n");
    EXPECT_EQ(
        refusalOf("[[light]]\nposition = [0, 0, 0]\n"),
        "s.toml:2:12: light 0 is at infinity in the direction (0, 0, 0), expected a direction that is not zero\n");
    EXPECT_EQ(refusalOf("[[light]]\nkind = \"area\"\nfacing = [0, 0, 0]\n"),
              "s.toml:3:10: area light 0 faces the direction (0, 0, 0), expected a direction that is not zero\n");
    EXPECT_EQ(refusalOf(kOpenGl + "[[light]]\nspot_cutoff = 120\n"),
              "s.toml:3:15: light.0.spot_cutoff is 120, expected an angle from 0 to 90, or 180 for no spot\n");
    EXPECT_EQ(refusalOf(kOpenGl + "[[light]]\nspot_cutoff = 30\nspot_direction = [0, 0, 0]\n"),
              "s.toml:4:18: the spot of light 0 points nowhere, expected a direction that is not zero\n");
    EXPECT_EQ(refusalOf("[[object]]\nshape = \"box\"\ntranslation = [9e8, 9e8, 0]\n"),
              "s.toml:3:15: object 0 reaches 1.27e9 world units, expected at most 1e9\n");
}

TEST(KeyPlaces, AreTheTablesWhereNoValueWasGiven) {
    std::string lights;
    for (int k = 0; k < 9; ++k) lights += "[[light]]\n";
    EXPECT_EQ(refusalOf(kOpenGl + lights), "s.toml:10:1: 9 lights, expected at most 8 in OpenGL's model\n");
    // A mesh's own file has the exponent and the vertices; the scene names it in [[object]].
    EXPECT_EQ(refusalOf(kOpenGl + "[[object]]\nmesh = \"t.des\"\n"),
              "s.toml:2:1: material.0.n is 200, expected at most 128 in OpenGL's model\n"
              "s.toml:2:1: object 0 reaches 1.27e9 world units, expected at most 1e9\n");
}

// Front and back are told apart, each with its own value and place.
TEST(KeyPlaces, OfABackMaterialAreItsOwn) {
    const std::string box = kOpenGl + "[[object]]\nshape = \"box\"\n";
    EXPECT_EQ(refusalOf(box + "material = { n = 3 }\nback_material = { n = 200 }\n"),
              "s.toml:5:23: back_material.0.n is 200, expected at most 128 in OpenGL's model\n");
    EXPECT_EQ(refusalOf(box + "material = { n = 130 }\nback_material = { n = 3 }\n"),
              "s.toml:4:18: material.0.n is 130, expected at most 128 in OpenGL's model\n");
    EXPECT_EQ(refusalOf(box + "back_material = { n = -1 }\n"),
              "s.toml:4:23: back_material.0.n is -1, expected a number from 0 to 1000000\n");
}

// Whether a picture fits depends on what is asked of it: its size alone is no reason to refuse the file.
TEST(KeyPlaces, ALargePictureIsRead) { EXPECT_EQ(refusalOf("width = 16384\nheight = 16384\n"), "read"); }

TEST(KeyPlaces, OfALectureSceneAreItsNumbersAndItsObjects) {
    const auto refusal = [](const std::string& light, const std::string& scale) {
        const std::string text = "200, 1000, 45, 60\n1\nt.des\n" + scale + "\n0, 0, 0\n0, 0, 0\n1\n" + light + "\n50\n";
        const auto scene = readLectureScene({text, "s.scene"}, anyFile);
        return scene ? "read" : format(scene.errors());
    };
    EXPECT_EQ(refusal("1, 1, 1, 100", "1e-9, 1e-9, 1e-9"), "read");
    EXPECT_EQ(
        refusal("0, 0, 0, 100", "1e-9, 1e-9, 1e-9"),
        "s.scene:8:1: light 0 is at infinity in the direction (0, 0, 0), expected a direction that is not zero\n");
    EXPECT_EQ(refusal("1, 1, 1, 100", "1, 1, 1"),
              "s.scene:3:1: object 0 reaches 1.27e9 world units, expected at most 1e9\n");
}

}  // namespace
}  // namespace pipeline
