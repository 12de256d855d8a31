// What files may say about translucent surfaces, and what is said about them.
#include <gtest/gtest.h>

#include "pipeline/export/buffers/gl_calls.h"
#include "pipeline/export/json/json.h"
#include "pipeline/formats/obj/mtl_reader.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/formats/toml/toml_scene.h"
#include "pipeline/inspect/pixel_report.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

std::shared_ptr<const Mesh> wall(double y) {
    return test::mesh({{-9, y, -9}, {9, y, -9}, {9, y, 9}, {-9, y, 9}}, {{0, 1, 2, 3}});
}

// Seen along +y, in ambient light of 100: a wall of 80 behind a pane of 40 that hides a quarter, behind one of 20 that
// hides half. 0.25·40 + 0.75·80 = 70, then 0.5·20 + 0.5·70 = 45.
Scene panes() {
    Scene scene;
    scene.settings.width = scene.settings.height = 8;
    scene.settings.precision = Precision::Double;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, 0, 0}, scene.camera.target = {0, 1, 0};
    scene.ambient.intensity = 100;
    const double greys[]{0.2, 0.4, 0.8}, alphas[]{0.5, 0.25, 1}, places[]{4, 6, 8};
    for (std::size_t i = 0; i < 3; ++i) {
        scene.objects.push_back({"pane", wall(places[i]), {}, {Vec3d(greys[i]), Vec3d(0), 1}});
        scene.objects[i].material.alpha = alphas[i];
    }
    return scene;
}

TEST(LayerReport, TellsEachLayerFromTheFarthest) {
    const FramePtr frame = test::frameOf(panes());
    const PixelReport r = inspectPixel(*frame, {4, 4});
    ASSERT_EQ(r.layers.size(), 2u);
    EXPECT_EQ(r.layers[0].polygon, 1);
    EXPECT_NEAR(r.layers[0].zView, 6, 1e-12);
    EXPECT_EQ(r.layers[0].alpha, 0.25);
    EXPECT_NEAR(r.layers[0].intensity.r, 40, 1e-12);
    EXPECT_NEAR(r.layers[0].composed.r, 70, 1e-12);
    EXPECT_EQ(r.layers[1].polygon, 0);
    EXPECT_NEAR(r.layers[1].composed.r, 45, 1e-12);
    EXPECT_EQ(r.polygon, 2);
    EXPECT_NEAR(r.intensity.r, 80, 1e-12);
    EXPECT_EQ(r.composed, r.layers[1].composed);
    EXPECT_EQ(r.fragments.size(), 1u);
    const std::string text = toText(*frame, r);
    EXPECT_NE(text.find("layers: 2 laid over (80, 80, 80)"), std::string::npos) << text;
    EXPECT_NE(text.find("  intensity = 0.375 · (80, 80, 80) + (15, 15, 15) = (45, 45, 45)"), std::string::npos) << text;
    EXPECT_NE(text.find("= 0.3750·80.000 + 15.000 = 45.000"), std::string::npos) << text;
    EXPECT_NE(text.find("FB_r = round(255·C_r/I_max) = round(255·45.000/80) = 143"), std::string::npos) << text;
    const Json json = toJson(*frame, r);
    EXPECT_EQ(json["layers"].elements().size(), 2u);
    EXPECT_EQ(json["layers"][0]["alpha"], 0.25);
    EXPECT_NEAR(json["intensity"][0].get<double>(), 45, 1e-12) << "as its buffer";
    EXPECT_NEAR(json["opaque"][0].get<double>(), 80, 1e-12);
}

TEST(LayerReport, OverTheBackground) {
    Scene scene = panes();
    scene.objects.pop_back();
    const FramePtr frame = test::frameOf(scene);
    const PixelReport r = inspectPixel(*frame, {4, 4});
    EXPECT_FALSE(r.covered);
    EXPECT_EQ(r.layers.size(), 2u);
    EXPECT_NEAR(r.composed.g, 15, 1e-12);
    EXPECT_NE(toText(*frame, r).find("background, behind translucent surfaces"), std::string::npos);
    // What the frame buffer holds can be computed from what is said: 15 of I_max, over a background of 0.
    const std::vector<EquationLine> lines = equation(frame->scene(), r, 1);
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(toText(lines[1].formula).find("= 0.3750·0.000 + 15.000 = 15.000"), 0u) << toText(lines[1].formula);
    EXPECT_EQ(toText(lines[2].formula).find("FB_g = round(255·C_g/I_max) = round(255·15.000/40) = 96"), 0u)
        << toText(lines[2].formula);
}

// The report replays what the frame did, whatever the scene.
TEST(LayerReport, AgreesWithTheBuffers) {
    for (const unsigned seed : {4u, 5u, 6u, 7u, 12u, 13u, 14u, 15u}) {
        const FramePtr frame = test::frameOf(test::randomScene(seed));
        const AnyBuffer layers = *frame->buffer({BufferId::Layers}), sum = *frame->buffer({BufferId::Translucent});
        for (int y = 0; y < 71; y += 5) {
            for (int x = 0; x < 97; x += 5) {
                const PixelReport r = inspectPixel(*frame, {x, y});
                ASSERT_EQ(double(r.layers.size()), layers.value(std::size_t(x), std::size_t(y)));
                ASSERT_EQ(r.translucent.g, sum.value(std::size_t(x), std::size_t(y), 1));
                if (!r.layers.empty()) {
                    ASSERT_EQ(r.composed, r.layers.back().composed) << seed << ' ' << x << ' ' << y;
                }
            }
        }
    }
}

TEST(AlphaInFiles, OfATomlScene) {
    const auto noFile = [](std::string_view) -> Result<NamedFile> { return Error{{}, "no such file", {}}; };
    const auto read = [&](const char* alpha) {
        const std::string text =
            std::string("translucency = \"polygons\"\n[[object]]\nshape = \"box\"\n[object.material]\nalpha = ") +
            alpha;
        return readTomlScene({text, "s.toml"}, noFile);
    };
    const auto scene = read("0.25");
    ASSERT_TRUE(scene) << format(scene.errors());
    EXPECT_EQ(scene->objects[0].material.alpha, 0.25);
    EXPECT_EQ(scene->settings.translucency, Translucency::Polygons);
    EXPECT_TRUE(read("-3"));  // acts as 0
    EXPECT_FALSE(read("nan"));
}

Material fromMtl(std::string_view lines) {
    std::vector<NamedMaterial> materials;
    Errors errors;
    MtlTallies tallies;
    const std::string text = "newmtl a\n" + std::string(lines);
    readMtl({text, "a.mtl"}, materials, tallies, errors);
    EXPECT_TRUE(errors.empty()) << format(errors);
    return materials.at(0).material;
}

TEST(AlphaInFiles, OfAMaterialLibrary) {
    EXPECT_EQ(fromMtl("Kd 1 1 1").alpha, 1);
    EXPECT_EQ(fromMtl("d 0.25").alpha, 0.25);
    EXPECT_EQ(fromMtl("Tr 0.25").alpha, 0.75);
    // Where both are given d counts, in either order: some writers have Tr mean d.
    EXPECT_EQ(fromMtl("d 0.25\nTr 0.25").alpha, 0.25);
    EXPECT_EQ(fromMtl("Tr 0.25\nd 0.25").alpha, 0.25);
    EXPECT_EQ(fromMtl("d -halo 0.25").alpha, 1);
}

// Opaque objects first; then the farther pane, then the nearer one, between glEnable and glDisable of blending.
TEST(GlCallsOfTranslucentSurfaces, ComeLastAndSorted) {
    Scene scene = panes();
    scene.settings.model = Model::OpenGl;
    scene.objects.push_back(scene.objects[0]);
    scene.objects[3].material.alpha = 0;
    const auto calls = glCalls(*test::frameOf(scene));
    ASSERT_TRUE(calls) << format(calls.errors());
    std::vector<std::string> lines;
    for (const GlCall& call : *calls) lines.push_back(toC(call));
    const auto place = [&](std::string_view line) {
        const auto found = std::ranges::find(lines, line);
        EXPECT_NE(found, lines.end()) << line;
        return found - lines.begin();
    };
    const auto blends = place("glEnable(GL_BLEND);"), ends = place("glDisable(GL_BLEND);");
    EXPECT_LT(place("glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, (const GLfloat[]){0.8, 0.8, 0.8, 1});"), blends);
    EXPECT_EQ(place("glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);"), blends + 1);
    EXPECT_EQ(place("glDepthMask(GL_FALSE);"), blends + 2);
    const auto farther = place("glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, (const GLfloat[]){0.4, 0.4, 0.4, 0.25});");
    const auto nearer = place("glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, (const GLfloat[]){0.2, 0.2, 0.2, 0.5});");
    EXPECT_LT(blends, farther);
    EXPECT_LT(farther, nearer);
    EXPECT_LT(nearer, ends);
    EXPECT_EQ(std::ranges::count(lines, "glBegin(GL_POLYGON);"), 3) << "what is wholly transparent is not drawn";
    const auto remark = std::ranges::find_if(
        *calls, [](const GlCall& c) { return c.comment.find("wrong where polygons overlap") != std::string::npos; });
    EXPECT_NE(remark, calls->end());
}

}  // namespace
}  // namespace pipeline
