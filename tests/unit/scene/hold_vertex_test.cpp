// A vertex in the hand, the rim of a highlight, and the files that a vertex changes.
#include <cmath>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/lecture/lecture_formats.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/formats/toml/toml_scene.h"
#include "pipeline/formats/toml/toml_writer.h"
#include "pipeline/scene/hold/hold.h"
#include "pipeline/scene/hold/lecture_text.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

Scene builtIn(std::string_view name) { return readScene(builtInScene(name)->file).value(); }
Scene after(const Scene& scene, std::string_view values) { return withSettings(scene, values).value(); }

// The pyramid's apex, whose own box is 150 wide: 1.3 · 75 around its middle.
Hold apex() {
    Hold hold{Hold::Kind::Vertex,
              0,
              {"vertex.0.4.x", "vertex.0.4.y", "vertex.0.4.z"},
              Vec3d(75),
              Vec3d(0),
              0,
              97.5,
              "Apex",
              ""};
    hold.vertex = 4;
    return hold;
}
Hold rimOf(std::size_t ball) {
    return {Hold::Kind::Rim, ball, {"material." + std::to_string(ball) + ".n"}, {}, {}, 1, 512, "Rim", "n"};
}

std::vector<double> verdictsOf(const Scene& scene) {
    const FramePtr frame = test::frameOf(scene);
    const auto verdicts = frame->buffer({BufferId::PolygonsVerdict});
    std::vector<double> all;
    for (std::size_t i = 0; i < verdicts->columns() * verdicts->rows(); ++i)
        all.push_back(verdicts->value(i % verdicts->columns(), i / verdicts->columns()));
    return all;
}

// As if the file had another line.
TEST(VertexSetting, IsAsIfTheFileHadAnotherLine) {
    const Scene moved = after(builtIn("pyramid"), "vertex.0.4.x=100; vertex.0.4.y=13; vertex.0.4.z=172");
    std::ifstream file(builtInScene("pyramid")->file.parent_path() / "pyramid.des");
    std::string text((std::istreambuf_iterator<char>(file)), {});
    text.replace(text.find("(75,75,150)"), 11, "(100,13,172)");
    Errors errors;
    const auto other = readObjectDescription({text, "o.des"}, errors);
    ASSERT_TRUE(errors.empty()) << format(errors);
    const auto made = makeMesh(other.mesh);
    const Mesh &a = *moved.objects[0].mesh, &b = *made;
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.triangles, b.triangles);
    EXPECT_EQ(a.facts.high, b.facts.high);
    EXPECT_EQ(a.facts.convex, b.facts.convex);
    EXPECT_TRUE(a.file.empty()) << "the file says something else";
}

TEST(VertexSetting, IsSavedWithTheScene) {
    const Scene moved = after(builtIn("ambient"), "vertex.0.7.y=-3.25");
    const auto text = toTomlScene(moved);
    ASSERT_TRUE(text);
    const auto read = readTomlScene({*text, "saved"}, {});
    ASSERT_TRUE(read) << format(read.errors());
    EXPECT_EQ(read->objects[0].mesh->positions, moved.objects[0].mesh->positions);
    EXPECT_EQ(after(moved, "vertex.0.7.y=-3.25").objects[0].mesh, moved.objects[0].mesh) << "nothing changed";
}

TEST(VertexSetting, HasAKeyOfItsOwn) {
    const Scene scene = builtIn("pyramid");
    EXPECT_EQ(findSetting(scene, "vertex.0.4.z")->key(), "vertex.0.4.z");
    EXPECT_EQ(findSetting(scene, "vertex.0.4.z")->get(scene), 150);
    for (const char* key : {"vertex.0.5.x", "vertex.1.0.x", "vertex.0.4.w", "vertex.0.4", "vertex.0.", "vertex.-1.0.x"})
        EXPECT_FALSE(findSetting(scene, key)) << key;
    EXPECT_EQ(format(findSetting(scene, "vertex.0.5.x").errors()),
              "no setting \"vertex.0.5.x\", expected vertex 0 to 4 of object 0\n");
}

// Whole units of the file: half a unit is 0.9 world units along x and 0.5 along y and z. With θ = 45°, φ = 60° and
// 200 px / z_v, z_v above 600, that is (0.9 + 0.5) · 0.71 / 3 = 0.33 px across and (1.4 · 0.35 + 0.5 · 0.87) / 3 = 0.31 px down.
TEST(HoldVertex, StaysUnderThePointer) {
    const Scene scene = builtIn("pyramid");
    Hold hold = apex();
    hold.turnsOver = true;
    const auto from = placeOf(scene, hold);
    ASSERT_TRUE(from);
    for (double x = -20; x <= 20; x += 10)
        for (double y = 0; y <= 20; y += 10) {
            const Assignments values = valuesAt(scene, hold, from->at, from->at + glm::dvec2(x, y));
            const auto to = placeOf(after(scene, toText(values)), hold);
            ASSERT_TRUE(to);
            EXPECT_NEAR(to->at.x, from->at.x + x, 0.34);
            EXPECT_NEAR(to->at.y, from->at.y + y, 0.34);
            for (const auto& [key, value] : values) EXPECT_EQ(value, std::round(value)) << key;
        }
}

// The cull stage is the reference: its verdicts stay, wherever the hand goes.
TEST(HoldVertex, StopsBeforeAPolygonTurnsOver) {
    Scene scene = builtIn("pyramid");
    scene.settings.cull = CullMode::Back;
    const auto from = placeOf(scene, apex());
    bool turned = false;
    for (const glm::dvec2 by : {glm::dvec2(0, 90), {90, 60}, {-90, 60}, {100, 0}, {-100, 0}, {0, -100}}) {
        const Scene moved = after(scene, toText(valuesAt(scene, apex(), from->at, from->at + by)));
        EXPECT_EQ(verdictsOf(moved), verdictsOf(scene)) << by.x << ", " << by.y;
        EXPECT_NE(moved.objects[0].mesh->positions, scene.objects[0].mesh->positions) << "as near as it gets";
        Hold over = apex();
        over.turnsOver = true;
        turned = turned ||
                 verdictsOf(after(scene, toText(valuesAt(scene, over, from->at, from->at + by)))) != verdictsOf(scene);
    }
    EXPECT_TRUE(turned) << "with over they turn";
}

TEST(HoldVertex, StaysInItsPlane) {
    const Scene scene = builtIn("pyramid");
    Hold hold = apex();
    hold.axis = {0, 0, 1};
    const auto from = placeOf(scene, hold);
    const Scene moved = after(scene, toText(valuesAt(scene, hold, from->at, from->at + glm::dvec2(15, 5))));
    EXPECT_EQ(moved.objects[0].mesh->positions[4].z, 150);
    EXPECT_NE(moved.objects[0].mesh->positions[4].x, 75);
    EXPECT_EQ(wordsOf(scene, hold), "75, 75");
    EXPECT_EQ(wordsOf(scene, apex()), "4: 75, 75, 150");
    for (const glm::ivec2 by : {glm::ivec2(1, 0), {-1, 0}, {0, 1}, {0, -1}})
        EXPECT_NE(nudged(scene, hold, by, false), valuesOf(scene, hold)) << by.x << by.y;
    for (const double odd : {double(NAN), double(INFINITY), 1e300})
        for (const auto& [key, value] : valuesAt(scene, hold, {0, 0}, {odd, odd}))
            EXPECT_TRUE(std::isfinite(value)) << key;
}

// The shading stage is the reference: inside of the rim the specular term is above half of k_s I_0, outside below.
TEST(HoldRim, IsWhereTheSpecularTermIsHalf) {
    Scene scene = builtIn("highlight_exponents");
    for (const std::size_t ball : {std::size_t(1), std::size_t(2), std::size_t(3)}) {
        const auto rim = placeOf(scene, rimOf(ball));
        ASSERT_TRUE(rim);
        const FramePtr frame = test::frameOf(scene);
        const auto specular = frame->buffer({BufferId::Specular, 0});
        ASSERT_TRUE(specular);
        const double half = scene.objects[ball].material.specular.x * scene.lights[0].intensity / 2;
        const auto at = [&](double x) { return specular->value(std::size_t(x), std::size_t(rim->at.y)); };
        EXPECT_GT(at(rim->at.x - 1.5), half) << ball;
        EXPECT_LT(at(rim->at.x + 1.5), half) << ball;
    }
}

// From a place to n and back; Blinn-Phong's H turns half as far, and its n has a factor of its own.
TEST(HoldRim, AnExponentHasAPlaceAndAPlaceAnExponent) {
    Scene scene = builtIn("highlight_exponents");
    for (const Model model : {Model::Phong, Model::BlinnPhong}) {
        scene.settings.model = model;
        const auto from = placeOf(scene, rimOf(2));
        ASSERT_TRUE(from);
        for (const double n : {3.0, 8.0, 31.0, 60.0, 150.0}) {
            const auto to = placeOf(after(scene, "material.2.n=" + std::to_string(n)), rimOf(2));
            EXPECT_EQ(valuesAt(scene, rimOf(2), from->at, to->at)[0].second, n);
        }
        EXPECT_EQ(nudged(scene, rimOf(2), {1, 0}, false)[0].second, 31) << "outwards n falls";
        EXPECT_EQ(nudged(scene, rimOf(2), {-1, 0}, true)[0].second, 64);
    }
}

TEST(LectureText, HasOneVertexALine) {
    const Scene scene = after(builtIn("pyramid"), "vertex.0.4.x=100");
    const std::vector<LectureLine> lines = objectLines(scene.objects[0]);
    ASSERT_EQ(lines.size(), 1u + 5 + 5 + 3);
    EXPECT_EQ(lines[5].text, "(100,75,150)");
    EXPECT_EQ(lines[5].vertex, 4u);
    EXPECT_EQ(lines[10].text, "4,(0,3,2,1)");
    // What it says is what the reader reads.
    std::string text;
    for (const LectureLine& line : lines) text += line.text + '\n';
    Errors errors;
    const auto read = readObjectDescription({text, "o.des"}, errors);
    EXPECT_EQ(format(errors), "");
    EXPECT_EQ(read.mesh.positions, scene.objects[0].mesh->positions);
    EXPECT_EQ(sceneLines(scene, "pyramid.des")[0].text, "200, 1000, 45, 60");
    EXPECT_TRUE(sceneLines(builtIn("ambient"), "a.des").empty()) << "a look-at camera";
}

}  // namespace
}  // namespace pipeline
