#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"

namespace {

using Json = nlohmann::json;
using test::has;
using test::run;
using test::scene;

TEST(Inspect, PrintsTheEquationWithItsNumbers) {
    const auto done = run({"inspect", scene("pyramid.scene"), "--pixel", "268,281"});
    EXPECT_EQ(done.status, 0);
    EXPECT_TRUE(has(done.out, "I_b = k_b I_a + S_0 I_0 [ k_b (N·L) + k_s (R·V)^n ]")) << done.out;
    EXPECT_TRUE(has(done.out, "0.9·50 + 1·100 [ 0.9·0.7746 + 0.4·0.3974^8 ]"));
    EXPECT_TRUE(has(done.out, "114.739"));
    EXPECT_TRUE(has(done.out, "passed, stays"));
}

TEST(Inspect, AsJson) {
    const Json json = Json::parse(run({"inspect", "pyramid", "--pixel", "268,281", "--json"}).out);
    EXPECT_EQ(json["polygon"], 2);
    EXPECT_NEAR(json["intensity"][2].get<double>(), 114.739, 5e-4);
    EXPECT_EQ(json["color"], Json::array({37, 93, 167}));
    EXPECT_EQ(json["fragments"][0]["verdict"], "passed, stays");
    // The third polygon of pyramid.des: 3,(0,1,4), 3,(1,2,4), 3,(2,3,4) … in its line 11. Base, behind it, faces away;
    // the shoelace sum of its corners on the screen is derived in lecture1_pyramid_test.cpp. Snapped, they move by at
    // most √2/512 px each, along an outline of less than 350 px.
    EXPECT_EQ(json["defined_at"], (Json{{"file", "pyramid.des"}, {"line", 11}, {"column", 23}}));
    ASSERT_EQ(json["culled"].size(), 1u);
    EXPECT_NEAR(json["culled"][0]["signed_area"].get<double>(), -1991.6, 1);
}

TEST(Inspect, NamesTheScenesFileWhereTheMeshStandsInIt) {
    const test::TemporaryFolder folder;
    const std::string file = (folder / "s.toml").string();
    test::writeText(file,
                    "width = 9\nheight = 9\n[camera]\nkind = \"look-at\"\neye = [0, 0, 5]\nup = [0, 1, 0]\n"
                    "[[object]]\nvertices = [[-5, -5, 0], [5, -5, 0], [0, 5, 0]]\npolygons = [[0, 1, 2]]\n");
    EXPECT_TRUE(has(run({"inspect", file, "--pixel", "4,4"}).out, "defined at   " + file + ":9:13\n"));
    const Json json = Json::parse(run({"inspect", file, "--pixel", "4,4", "--json"}).out);
    EXPECT_EQ(json["defined_at"], (Json{{"file", file}, {"line", 9}, {"column", 13}}));
    const Json shape = Json::parse(run({"inspect", "lambert", "--pixel", "320,240", "--json"}).out);
    EXPECT_TRUE(shape["covered"] == true && shape["defined_at"].is_null()) << "a built-in shape stands in no file";
}

TEST(Inspect, WritesTheEquationForAPage) {
    const auto latex = run({"inspect", "pyramid", "--pixel", "268,281", "--format", "latex"});
    EXPECT_EQ(latex.status, 0) << latex.err;
    EXPECT_TRUE(latex.out.starts_with("% \\usepackage")) << latex.out;
    const auto background = run({"inspect", "pyramid", "--pixel", "0,0", "--format", "latex"});
    EXPECT_EQ(background.status, 0);
    EXPECT_EQ(background.out, "");
    EXPECT_EQ(background.err, "pixel 0, 0 shows the background: it has no equation\n");
    EXPECT_TRUE(has(latex.out, "I_{\\text{g}} &= "));
    const auto markdown = run({"inspect", "pyramid", "--pixel", "268,281", "--format", "markdown"});
    EXPECT_TRUE(markdown.out.starts_with("$$\n")) << markdown.out;
}

TEST(Inspect, RefusesAPixelOutsideThePicture) {
    for (const char* pixel : {"640,0", "0,480", "-1,0", "1", "1,2,3", "a,b", ""}) {
        const auto done = run({"inspect", "pyramid", std::string("--pixel=") + pixel});
        EXPECT_EQ(done.status, 2) << pixel;
        EXPECT_EQ(done.out, "");
    }
    EXPECT_TRUE(has(run({"inspect", "pyramid", "--pixel", "640,0"}).err,
                    "--pixel is \"640,0\", expected X,Y with X from 0 to 639 and Y from 0 to 479"));
    EXPECT_EQ(run({"inspect", "pyramid", "--pixel", "639,479"}).status, 0);
}

TEST(Inspect, CountsAndListsThePixelsForWhichAConditionHolds) {
    const auto text = run({"inspect", "pyramid", "--where", "polygon_id == 2 && x < 260"});
    EXPECT_EQ(text.status, 0) << text.err;
    EXPECT_TRUE(has(text.out, "pixels where something was drawn"));
    const Json json = Json::parse(run({"inspect", "pyramid", "--where", "polygon_id == 2 && x < 260", "--json"}).out);
    EXPECT_GT(json["count"], 20);
    EXPECT_EQ(json["pixels"].size(), json["count"]);
    EXPECT_EQ(json["drawn"], 2686);  // the fragments that won, lecture 1's pyramid
    for (const Json& pixel : json["pixels"]) EXPECT_LT(pixel[0], 260);
    EXPECT_TRUE(has(text.out, "and " + std::to_string(json["count"].get<int>() - 20) + " more"));
    EXPECT_TRUE(has(run({"inspect", "pyramid", "--where", "x <"}).err, "--where:1:4: found the end"));
}

TEST(Inspect, PrintsATableInEveryFormat) {
    const auto text = run({"inspect", "pyramid", "--table", "polygons"});
    EXPECT_EQ(text.status, 0);
    EXPECT_TRUE(has(text.out, "back-facing")) << text.out;
    EXPECT_TRUE(has(text.out, "114.739"));
    const auto csv = run({"inspect", "pyramid", "--table", "objects", "--format", "csv"});
    EXPECT_TRUE(csv.out.starts_with("i,name,num_pts,w_pts,num_polys,polys,kr,kg,kb,ks,n,")) << csv.out;
    EXPECT_TRUE(has(csv.out, "0,pyramid,5,0 to 4,5,0 to 4,0.2,0.5,0.9,0.4,8,"));
    EXPECT_TRUE(has(run({"inspect", "pyramid", "--table", "lights", "--format", "markdown"}).out, "| Lx |"));
    EXPECT_TRUE(has(run({"inspect", "pyramid", "--table", "vertices", "--format", "latex"}).out, "\\end{tabular}"));
    const Json json = Json::parse(run({"inspect", "pyramid", "--table", "lights", "--json"}).out);
    EXPECT_EQ(json["columns"][2]["lecture"], "Lx");
    EXPECT_EQ(json["rows"][0][2], 500);
}

TEST(Inspect, WritesTheSectionAlongARow) {
    const auto csv = run({"inspect", "pyramid", "--row", "281"});
    EXPECT_EQ(csv.status, 0) << csv.err;
    EXPECT_TRUE(csv.out.starts_with("x,seen,z_view.1,z_view.2,flat.r,")) << csv.out.substr(0, 80);
    EXPECT_TRUE(has(run({"inspect", "pyramid", "--row", "281", "--format", "svg"}).out, "<svg"));
    const Json json = Json::parse(run({"inspect", "pyramid", "--row", "281", "--json"}).out);
    EXPECT_EQ(json["row"], 281);
    EXPECT_EQ(json["width"], 640);
    EXPECT_EQ(json["depth"], "z_view");
    // At x = 268 the third polygon is seen, and its flat intensity is that of lecture1_pyramid_test.cpp.
    int seen = -1;
    for (const Json& polygon : json["runs"])
        for (const Json& sample : polygon["samples"])
            if (sample["x"] == 268 && sample["seen"] == true) seen = polygon["polygon"];
    EXPECT_EQ(seen, 2);
    ASSERT_EQ(json["intensity"]["flat"].size(), 640u);
    EXPECT_NEAR(json["intensity"]["flat"][268][2].get<double>(), 114.7386, 5e-5);
    EXPECT_TRUE(json["intensity"]["phong"][0].is_null()) << "nothing is drawn there";
    EXPECT_EQ(run({"inspect", "pyramid", "--row", "281", "--format", "csv", "--json"}).status, 2);
    EXPECT_EQ(run({"inspect", "pyramid", "--row", "480"}).status, 2);
    EXPECT_EQ(run({"inspect", "pyramid", "--row", "281", "--format", "latex"}).status, 2);
}

TEST(Inspect, HoldsShadowsAgainstRays) {
    const Json json = Json::parse(run({"inspect", "shadow_bias", "--shadow-verdicts", "--json"}).out);
    EXPECT_GT(json[0]["acne"], 1000) << "a coarse shadow buffer without a bias";
    EXPECT_TRUE(has(run({"inspect", "shadow_bias", "--shadow-verdicts"}).out, "acne"));
    // As export refuses it.
    for (const std::vector<std::string>& lit :
         {std::vector<std::string>{"gl_cube"}, {"pyramid", "--set", "light.0.shadow=off"}}) {
        std::vector<std::string> inspect{"inspect"},
            write{"export", "-o", "/proc/none", "--buffers", "color,condition", "--where", "x > 1"};
        for (std::vector<std::string>* all : {&inspect, &write}) {
            all->insert(all->end(), lit.begin(), lit.end());
            all->push_back("--shadow-verdicts");
        }
        const auto printed = run(inspect), written = run(write);
        EXPECT_EQ(printed.status, 2);
        EXPECT_EQ(written.status, 2);
        EXPECT_EQ(printed.out, "");
        EXPECT_TRUE(printed.err.starts_with("--shadow-verdicts: ")) << printed.err;
        EXPECT_EQ(printed.err, written.err);
    }
}

// The pyramid has five vertices and as many polygons; with the estimated root, which is within 3.44 % and no nearer than
// some tenths of a per cent for most lengths, no normal of the five has length 1.
TEST(Inspect, CountsWhatHolds) {
    const auto whole = run({"inspect", "pyramid", "--contracts"});
    EXPECT_EQ(whole.status, 0) << whole.out;
    EXPECT_TRUE(has(whole.out, "p_v = R (p − E)")) << whole.out;
    EXPECT_TRUE(has(whole.out, "A light at infinity has its origin anywhere."));
    const auto naive = run({"inspect", "pyramid", "--contracts", "--json", "--set", "numerics.normalize=estimate"});
    EXPECT_EQ(naive.status, 1);
    std::size_t violated = 0;
    for (const Json& one : Json::parse(naive.out)) {
        if (one["contract"] == "unit-polygon-normals") {
            EXPECT_EQ(one["checked"], 5);
            EXPECT_LT(one["hold"], 5);
            EXPECT_LT(one["worst"]["error"].get<double>(), 0.0344);
            EXPECT_TRUE(has(one["worst"]["place"].get<std::string>(), "polygon "));
            ++violated;
        }
        if (one["contract"] == "view") {
            EXPECT_EQ(one["hold"], 5);
        }
    }
    EXPECT_EQ(violated, 1u);
    EXPECT_EQ(run({"inspect", "pyramid", "--contracts", "--pixel", "1,1"}).status, 2);
}

TEST(Inspect, WantsAPixelOrATable) {
    for (const std::vector<std::string>& wrong :
         {std::vector<std::string>{"inspect", "pyramid"},
          {"inspect", "pyramid", "--where", ""},
          {"inspect", "pyramid", "--where", "z_vew < 1"},
          {"inspect", "pyramid", "--where", "x < 1", "--pixel", "1,1"},
          {"inspect", "pyramid", "--table", "pixels"},
          {"inspect", "pyramid", "--table", "lights", "--pixel", "1,1"},
          {"inspect", "pyramid", "--pixel", "1,1", "--format", "csv"},
          {"inspect", "pyramid", "--table", "lights", "--format", "xml"},
          {"inspect", "pyramid", "--table", "lights", "--format", "csv", "--json"}}) {
        const auto done = run(wrong);
        EXPECT_EQ(done.status, 2) << wrong.back();
        EXPECT_EQ(done.out, "") << wrong.back();
    }
}

// Some seconds of rays: to sixteen places of an area light.
// Some seconds of rays: to sixteen places of an area light.
TEST(Inspect, CtrlCIsStatus130) {
    const auto done = test::runAndInterrupt(
        {"inspect", "soft_shadow", "--shadow-verdicts", "--size", "1600x1200", "--threads", "1"}, 300);
    EXPECT_EQ(done.status, 130);
    EXPECT_EQ(done.out, "");
    EXPECT_EQ(done.err, "Cancelled.\n");
}

}  // namespace
