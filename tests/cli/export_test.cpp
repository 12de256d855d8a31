#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using test::run;
using test::scene;

Json manifestOf(const fs::path& folder) { return Json::parse(test::readText(folder / "manifest.json")); }

// A square of 2 · 128² = 32 768 triangles that faces the eye: all are as far away, so that each is compared with all that
// come after it. 6 811 of them take 32 767 + ... + 25 957 = 199 984 582 comparisons, and the next one's pass 200 million.
TEST(Export, SaysWhereThePainterGivesUp) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "wall.toml",
                    "visibility = \"painter\"\nsplit = true\nshading = \"flat\"\n"
                    "camera = { kind = \"look-at\", eye = [0, 0, 3], up = [0, 1, 0] }\n"
                    "light = [{ position = [0, 0, 1] }]\n[[object]]\nshape = \"plane\"\ntessellation = 128\n");
    const auto remarks = [&](const char* split) {
        const auto done = run({"export", folder / "wall.toml", "--size", "640x480", "--set", split, "--buffers",
                               "color", "--format", "png", "-o", folder / "out"});
        EXPECT_EQ(done.status, 0) << done.err;
        std::string of;
        const Json manifest = manifestOf(folder.path() / "out");
        for (const Json& remark : manifest["remarks"])
            if (remark["about"] == "split") of = remark["text"];
        EXPECT_EQ(done.err.find("split: ") != done.err.npos, !of.empty()) << done.err;
        EXPECT_NE(done.err.find(of), done.err.npos) << done.err;
        return of;
    };
    const std::string unordered = remarks("split=on");
    EXPECT_TRUE(unordered.starts_with("The painter has given up on 25957 of 32768 pieces of triangles")) << unordered;
    EXPECT_EQ(remarks("split=off"), "") << "nothing is compared";
}

TEST(Export, WritesWhatIsMadeFromTheFrame) {
    const test::TemporaryFolder folder;
    const auto done =
        run({"export", "shadow_bias", "-o", folder / "out", "--buffers", "color", "--format", "npy,png",
             "--shadow-verdicts", "--where", "polygon_id >= 0", "--mix", "ambient=0,diffuse.0=0,specular.0=0"});
    ASSERT_EQ(done.status, 0) << done.err;
    const test::Npy verdicts = test::readNpy(folder / "out/shadow_verdict.0.npy");
    EXPECT_EQ(verdicts.descr, "<i4");
    EXPECT_GT(std::ranges::count(verdicts.values, 2), 1000) << "acne";
    const test::Npy mask = test::readNpy(folder / "out/condition.npy");
    EXPECT_EQ(mask.descr, "|u1");
    EXPECT_EQ(std::ranges::count(mask.values, 1),
              std::ranges::count_if(verdicts.values, [](double v) { return v >= 0; }))
        << "every drawn pixel of this scene has a verdict";
    EXPECT_TRUE(std::ranges::all_of(test::readNpy(folder / "out/mix.npy").values, [](double v) { return v == 0; }))
        << "no term is left";
    for (const char* file : {"shadow_verdict.0.png", "condition.png", "mix.png"})
        EXPECT_TRUE(fs::exists(folder.path() / "out" / file)) << file;
    const Json manifest = manifestOf(folder.path() / "out");
    ASSERT_EQ(manifest["derived"].size(), 3u);
    EXPECT_EQ(manifest["derived"][0]["name"], "mix");
    EXPECT_EQ(manifest["derived"][1]["name"], "shadow_verdict.0");
    EXPECT_EQ(manifest["derived"][2]["meaning"], "1 where polygon_id >= 0 holds, else 0.");
    EXPECT_EQ(manifest["derived"][2]["files"].size(), 2u);
}

// By name as any buffer, in every format that can hold it, and without one of the frame beside it.
TEST(Export, WritesDerivedBuffersByName) {
    const test::TemporaryFolder folder;
    const auto done = run({"export", "pyramid", "-o", folder / "out", "--buffers", "expression", "--where",
                           "x + 1000 * y", "--format", "npy,csv,exr,png"});
    ASSERT_EQ(done.status, 0) << done.err;
    const test::Npy numbers = test::readNpy(folder / "out/expression.npy");
    EXPECT_EQ(numbers.descr, "<f8");
    EXPECT_EQ(numbers.values[281 * 640 + 268], 281268) << "a pixel of the right face";
    EXPECT_EQ(numbers.values[0], 0) << "nothing is drawn there";
    EXPECT_FALSE(fs::exists(folder.path() / "out/color.npy"));
    for (const char* file : {"expression.csv", "expression.exr", "expression.png"})
        EXPECT_TRUE(fs::exists(folder.path() / "out" / file)) << file;
    const Json manifest = manifestOf(folder.path() / "out");
    EXPECT_EQ(manifest["buffers"].size(), 0u);
    EXPECT_EQ(manifest["derived"][0]["maximum"].get<double>(), std::ranges::max(numbers.values));
    EXPECT_NE(run({"export", "pyramid", "-o", folder / "none", "--buffers", "condition"}).err.find("no condition"),
              std::string::npos);
    EXPECT_NE(
        run({"export", "gl_cube", "-o", folder / "none", "--buffers", "shadow_verdict.0"}).err.find("has no shadows"),
        std::string::npos);
    EXPECT_FALSE(fs::exists(folder.path() / "none"));
}

TEST(Export, RefusesWhatCannotBeMade) {
    const test::TemporaryFolder folder;
    const auto refused = [&](std::vector<std::string> more) {
        std::vector<std::string> all{"export", "pyramid", "-o", folder / "out"};
        all.insert(all.end(), more.begin(), more.end());
        const auto done = run(all);
        EXPECT_NE(done.status, 0);
        EXPECT_FALSE(fs::exists(folder.path() / "out"));
        return done.err;
    };
    EXPECT_NE(refused({"--mix", "diffuse.1=2"}).find("expected emission, ambient, diffuse.0, specular.0"),
              std::string::npos);
    EXPECT_NE(refused({"--where", "z_vew < 1"}).find("z_view"), std::string::npos);
}

TEST(Export, WritesThePyramidsBuffers) {
    const test::TemporaryFolder folder;
    const auto done = run({"export", scene("pyramid.scene"), "-o", folder / "out"});
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_EQ(done.out, "");
    EXPECT_NE(done.err.find("in " + (folder / "out").string()), std::string::npos);

    const test::Npy color = test::readNpy(folder / "out/color.npy");
    EXPECT_EQ(color.descr, "|u1");
    EXPECT_EQ(color.shape, (std::vector<std::size_t>{480, 640, 3}));
    // Lecture 1's right face, blue: 0.9·50 + 100 (0.9·0.7746 + 0.4·0.3974^8) = 114.739;
    // 255·114.739/175 = 167. Red 25.517 gives 37, green 63.755 gives 93.
    const std::size_t at = (281 * 640 + 268) * 3;
    EXPECT_EQ(color.values[at], 37);
    EXPECT_EQ(color.values[at + 1], 93);
    EXPECT_EQ(color.values[at + 2], 167);

    // Vertex 0 goes to (200, 0, 0), scale and rotation leaving the origin alone. θ = 45°, φ = 60°:
    // x_v = −200/√2, y_v = −200/(2√2), z_v = 1000 − 200·(√3/2)/√2; x_s = 320 + 200 x_v/z_v.
    const test::Npy screen = test::readNpy(folder / "out/vertices.screen.npy");
    EXPECT_EQ(screen.shape, (std::vector<std::size_t>{5, 3}));
    const double r = std::sqrt(0.5), z = 1000 - 200 * std::sqrt(0.75) * r;
    EXPECT_NEAR(screen.values[0], 320 - 200 * 200 * r / z, 1e-4);
    EXPECT_NEAR(screen.values[1], 240 + 200 * 200 * r / 2 / z, 1e-4);

    const test::Png png = test::readPng(folder / "out/color.png");
    ASSERT_EQ(png.width, 640);
    ASSERT_EQ(png.height, 480);
    EXPECT_TRUE(std::equal(png.rgb.begin(), png.rgb.end(), color.values.begin(), color.values.end()));
}

TEST(Export, ManifestHasWhatTheSpecificationLists) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(run({"export", "pyramid", "-o", folder / "out", "--size", "64x48"}).status, 0);
    const Json manifest = manifestOf(folder / "out");
    for (const char* key : {"program", "scene", "settings", "remarks", "plan", "stages", "buffers", "absent"})
        EXPECT_TRUE(manifest.contains(key)) << key;
    EXPECT_EQ(manifest["scene"]["sha256"].get<std::string>().size(), 64u);
    EXPECT_EQ(manifest["settings"]["width"], 64);
    for (const Json& buffer : manifest["buffers"]) {
        for (const char* key :
             {"name", "stage", "shape", "dtype", "unit", "space", "minimum", "maximum", "non_finite", "files"})
            EXPECT_TRUE(buffer.contains(key)) << buffer["name"] << ' ' << key;
        for (const Json& file : buffer["files"])
            EXPECT_EQ(fs::file_size(folder / ("out/" + file["file"].get<std::string>())), file["bytes"]);
    }
}

TEST(Export, ComputesWhatIsNamedEvenWhereThePlanLeavesItOut) {
    const test::TemporaryFolder folder;
    const auto done = run({"export", scene("pyramid.scene"), "-o", folder / "out", "--buffers",
                           "vertices.normal,shadow_buffer.0,n_dot_h.0", "--format", "npy", "--set", "shadow.size=32"});
    ASSERT_EQ(done.status, 0) << done.err;
    std::vector<std::string> names{"out", "out/manifest.json", "out/n_dot_h.0.npy", "out/shadow_buffer.0.npy",
                                   "out/vertices.normal.npy"};
    EXPECT_EQ(folder.names(), names);
    EXPECT_EQ(test::readNpy(folder / "out/shadow_buffer.0.npy").shape, (std::vector<std::size_t>{32, 32}));
}

TEST(Export, TakesNamesBesideAllAndAFormatOnce) {
    const test::TemporaryFolder folder;
    const auto done = run({"export", "pyramid", "-o", folder / "out", "--size", "64x48", "--format", "npy,npy",
                           "--buffers", "all,vertices.normal"});
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_TRUE(fs::exists(folder / "out/vertices.normal.npy"));
    EXPECT_TRUE(fs::exists(folder / "out/color.npy"));
    EXPECT_FALSE(fs::exists(folder / "out/n_dot_h.0.npy"));
}

TEST(Export, StopsAfterAStage) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(run({"export", "pyramid", "-o", folder / "out", "--until", "cull", "--format", "csv"}).status, 0);
    EXPECT_EQ(folder.names(),
              (std::vector<std::string>{"out", "out/manifest.json", "out/polygons.verdict.csv",
                                        "out/vertices.screen.csv", "out/vertices.view.csv", "out/vertices.world.csv"}));
    // Seen from the eye (612, 612, 500), N · (eye − vertex): left (0, −2, 1) · (412, 612, 500) < 0,
    // front and right > 0, back (−10, 0, 9) · (412, 612, 500) > 0 by a little, base faces down.
    EXPECT_EQ(test::readText(folder / "out/polygons.verdict.csv"), "polygon,value\n0,1\n1,0\n2,0\n3,0\n4,1\n");
    const Json manifest = manifestOf(folder / "out");
    std::string why;
    for (const Json& absent : manifest["absent"])
        if (absent["name"] == "color") why = absent["why"];
    EXPECT_EQ(why, "The run ends after cull.");
}

// The calls hold normals, whatever stage the run ends in.
TEST(Export, OpenGlsCallsAreTheSameWhereTheRunEndsEarly) {
    const test::TemporaryFolder folder;
    for (const std::string shading : {"flat", "gouraud"}) {
        const auto calls = [&](const char* buffer) {
            const auto out = folder / (shading + buffer);
            const auto done = run({"export", "pyramid", "-o", out, "--set", "model=opengl", "--set",
                                   "shading=" + shading, "--format", "opengl", "--buffers", buffer});
            EXPECT_EQ(done.status, 0) << done.err;
            return test::readText(out / "pyramid.gl.c");
        };
        const std::string whole = calls("color");
        EXPECT_NE(whole.find("glNormal3d"), std::string::npos);
        EXPECT_EQ(calls("z_view"), whole);
    }
}

TEST(Export, SettingsChangeThePicture) {
    const test::TemporaryFolder folder;
    // No light and no ambient light: I_max is 0, and so is every pixel.
    ASSERT_EQ(run({"export", "pyramid", "-o", folder / "out", "--buffers", "color", "--format", "npy", "--set",
                   "light.0.intensity=0", "--set", "ambient.intensity=0"})
                  .status,
              0);
    const auto values = test::readNpy(folder / "out/color.npy").values;
    EXPECT_EQ(values.size(), 640u * 480 * 3);
    EXPECT_TRUE(std::ranges::all_of(values, [](double v) { return v == 0; }));
}

TEST(Export, DoubleRunsLeaveDoubles) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(run({"export", "pyramid", "-o", folder / "out", "--buffers", "z_view,color", "--format", "npy", "--set",
                   "precision=double", "--threads", "1"})
                  .status,
              0);
    EXPECT_EQ(test::readNpy(folder / "out/z_view.npy").descr, "<f8");
    EXPECT_EQ(test::readNpy(folder / "out/color.npy").descr, "|u1");
}

TEST(Export, SaysHowManyFilesOfTheExportBeforeAreRemoved) {
    const test::TemporaryFolder folder;
    const auto exported = [&](const char* size, const char* buffers) {
        return run({"export", "pyramid", "-o", folder / "out", "--format", "npy", "--size", size, "--buffers", buffers})
            .err;
    };
    EXPECT_EQ(exported("8x8", "depth,color").find("removed"), std::string::npos);
    EXPECT_NE(exported("16x16", "color").find("; 1 of the export before removed\n"), std::string::npos);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"out", "out/color.npy", "out/manifest.json"}));
}

// A title is anything that stands on one line; a file's name is shorter.
TEST(Export, ASceneIsNamedAfterAnyTitle) {
    const test::TemporaryFolder folder;
    const std::string umlauts = [] {
        std::string text;
        for (int i = 0; i < 150; ++i) text += "ä";
        return text;
    }();
    const std::pair<std::string, std::string> cases[] = {
        {std::string(300, 'a'), std::string(200, 'a')},
        {'b' + umlauts, 'b' + umlauts.substr(0, 198)},  // no half of an ä
        {"c d", "c d"},
    };
    for (const auto& [title, name] : cases) {
        test::writeText(folder / "scene.toml", "title = \"" + title + "\"\n");
        const auto done = run({"export", folder / "scene.toml", "-o", folder / "out", "--size", "8x8", "--buffers",
                               "color", "--format", "scene,opengl", "--set", "model=opengl"});
        ASSERT_EQ(done.status, 0) << done.err;
        for (const char* ending : {".toml", ".gl.c"})
            EXPECT_TRUE(fs::exists(folder / "out" / (name + ending))) << name << ending;
    }
}

TEST(Export, NoObjectGivesTheBackground) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "empty.scene", "200, 1000, 45, 60\n0\n0\n50\n");
    const auto done = run({"export", folder / "empty.scene", "-o", folder / "out", "--size", "8x8"});
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_TRUE(std::ranges::all_of(test::readNpy(folder / "out/color.npy").values, [](double v) { return v == 0; }));
    EXPECT_TRUE(
        std::ranges::all_of(test::readNpy(folder / "out/polygon_id.npy").values, [](double v) { return v == -1; }));
}

TEST(Export, SaysWhichNamedBufferHasNoFile) {
    const test::TemporaryFolder folder;
    const auto done =
        run({"export", "pyramid", "-o", folder / "out", "--buffers", "vertices.world,color", "--format", "png"});
    EXPECT_EQ(done.status, 0);
    EXPECT_NE(done.err.find("vertices.world: no file. A picture has pixels, not vertices."), std::string::npos);
}

TEST(Export, RefusesToWriteAManifestAlone) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(run({"export", "pyramid", "-o", folder / "out", "--size", "8x8", "--buffers", "color,depth"}).status, 0);
    const auto before = folder.names();
    for (const std::vector<std::string>& more : {std::vector<std::string>{"--buffers", "vertices.world"},
                                                 {"--buffers", "vertices.world,polygons.verdict"},
                                                 {"--until", "cull"}}) {
        std::vector<std::string> arguments{"export", "pyramid", "-o", folder / "out", "--format", "png"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const auto done = run(arguments);
        EXPECT_EQ(done.status, 2) << done.err;
        EXPECT_TRUE(done.err.ends_with("no buffer has a file in png. Nothing was written.\n")) << done.err;
        EXPECT_EQ(folder.names(), before);
    }
    EXPECT_EQ(
        run({"export", "pyramid", "-o", folder / "out", "--buffers", "vertices.world", "--format", "png,scene"}).status,
        0);
}

TEST(Export, ViewsArePicturesWhereTheBuildHasThem) {
    const test::TemporaryFolder folder;
    const auto done = run({"export", "pyramid", "-o", folder / "out", "--buffers", "color", "--format", "png",
                           "--views", "--pixel", "268,281"});
#ifdef SHADESCOPE_WINDOW
    ASSERT_EQ(done.status, 0) << done.err;
    const Json manifest = manifestOf(folder / "out");
    ASSERT_FALSE(manifest["views"].empty());
    for (const Json& view : manifest["views"]) {
        const test::Png picture = test::readPng(folder / ("out/" + view.get<std::string>()));
        ASSERT_GT(picture.width, 0) << view;
        // Something is drawn: not every pixel is the first one's colour.
        const auto& rgb = picture.rgb;
        EXPECT_TRUE(std::ranges::any_of(rgb, [&](std::uint8_t value) { return value != rgb[0]; })) << view;
    }
#else
    EXPECT_EQ(done.status, 2);
    EXPECT_EQ(done.err, "shadescope export: --views: this build has no 3D views\n");
    EXPECT_FALSE(fs::exists(folder / "out"));
#endif
}

struct Wrong {
    const char* name;
    std::vector<std::string> arguments;
    std::string message;
};
void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.name; }

class WrongUsage : public testing::TestWithParam<Wrong> {};

TEST_P(WrongUsage, IsStatus2WithAReason) {
    const test::TemporaryFolder folder;
    std::vector<std::string> arguments{"export", scene("pyramid.scene"), "-o", folder / "out"};
    arguments.insert(arguments.end(), GetParam().arguments.begin(), GetParam().arguments.end());
    const auto done = run(arguments);
    EXPECT_EQ(done.status, 2);
    EXPECT_EQ(done.out, "");
    EXPECT_NE(done.err.find(GetParam().message), std::string::npos) << done.err;
    EXPECT_EQ(folder.names(), std::vector<std::string>{});
}

INSTANTIATE_TEST_SUITE_P(
    Export, WrongUsage,
    testing::Values(Wrong{"Setting", {"--set", "shadign=flat"}, "no setting \"shadign\"; the nearest is \"shading\""},
                    Wrong{"Value",
                          {"--set", "light.0.intensity=abc"},
                          "light.0.intensity is \"abc\", expected a number from -1e9 to 1e9"},
                    Wrong{"Together",
                          {"--set", "camera.near=9", "--set", "camera.far=8"},
                          "expected less than camera.far, which is 8"},
                    Wrong{"Size", {"--size", "640"}, "--size is \"640\", expected WxH, as in 640x480"},
                    Wrong{"Zero", {"--size", "0x9"}, "width is \"0\", expected a whole number from 1 to 16384"},
                    Wrong{"Huge",
                          {"--size", "16384x16384"},
                          "expected at most 4 GiB; ask for fewer buffers, or make the picture smaller"},
                    Wrong{"Buffer", {"--buffers", "colour"}, "no buffer \"colour\"; the nearest is \"color\""},
                    Wrong{"NoBuffer", {"--buffers", "nope"}, "lists all\n"},
                    Wrong{"EmptyBuffer", {"--buffers", ""}, "no buffer \"\"; there are "},
                    Wrong{"EmptyBufferAmongOthers", {"--buffers", "color,,depth"}, "no buffer \"\"; there are "},
                    Wrong{"EmptyBufferAtTheEnd", {"--buffers", "color,"}, "no buffer \"\"; there are "},
                    Wrong{"EmptyFormat", {"--format", "npy,,png"}, "no format \"\", expected npy"},
                    Wrong{"Light", {"--buffers", "n_dot_l.1"}, "no buffer \"n_dot_l.1\": this scene has 1 light"},
                    Wrong{"LightOfVerdicts",
                          {"--buffers", "shadow_verdict.7,depth"},
                          "no buffer \"shadow_verdict.7\": this scene has 1 light"},
                    Wrong{"LightOfVerdictsBesideThem",
                          {"--buffers", "shadow_verdict.1", "--shadow-verdicts"},
                          "no buffer \"shadow_verdict.1\": this scene has 1 light"},
                    Wrong{"Stage", {"--until", "zbuffer"}, "no stage \"zbuffer\"; the nearest is \"z-buffer\""},
                    Wrong{"Late",
                          {"--until", "cull", "--buffers", "color"},
                          "color comes from shading, and the run ends after cull"},
                    Wrong{"LateDerived",
                          {"--until", "cull", "--buffers", "z_ndc"},
                          "z_ndc comes from z-buffer, and the run ends after cull"},
                    Wrong{"LateCondition",
                          {"--until", "z-buffer", "--where", "n_dot_l.0 > 0"},
                          "condition comes from shading, and the run ends after z-buffer"},
                    Wrong{"Format",
                          {"--format", "npy,bmp"},
                          "no format \"bmp\", expected npy, png, csv, exr, vtk, scene, polydata, opengl"},
                    Wrong{"Threads", {"--threads", "-1"}, "--threads"}, Wrong{"Option", {"--colour"}, "--colour"},
                    Wrong{"PixelAlone", {"--pixel", "1,1"}, "--pixel goes with --views"}),
    [](const auto& wrong) { return std::string(wrong.param.name); });

}  // namespace
