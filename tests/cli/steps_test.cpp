// One moment of a frame, and films of it, from the command line.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"

namespace {

namespace fs = std::filesystem;
using test::has, test::run;

TEST(ExportAt, WritesTheStateInsideAStageAndNamesItInTheManifest) {
    const test::TemporaryFolder folder;
    const auto done = run({"export", "pyramid", "-o", folder / "out", "--set", "cull=none", "--format", "npy", "--at",
                           "z-buffer/polygon=2/row=270/x=258"});
    ASSERT_EQ(done.status, 0) << done.err;
    const auto manifest = nlohmann::json::parse(test::readText(folder / "out/manifest.json"));
    EXPECT_EQ(manifest["at"], "z-buffer/polygon=2/row=270/x=258");
    EXPECT_EQ(manifest["until"], "z-buffer");
    EXPECT_FALSE(fs::exists(folder / "out/color.npy"));
    // Polygons 3 and 4 have not come, and polygon 2 has no pixel below row 270.
    const test::Npy ids = test::readNpy(folder / "out/polygon_id.npy");
    ASSERT_EQ(ids.shape, (std::vector<std::size_t>{480, 640}));
    EXPECT_EQ(ids.values[270 * 640 + 258], 2);
    for (std::size_t i = 0; i < ids.values.size(); ++i) {
        ASSERT_LE(ids.values[i], 2);
        if (ids.values[i] == 2) {
            ASSERT_LE(i, 270u * 640 + 258) << i;
        }
    }
}

TEST(ExportAt, RefusesAPlaceThatIsNone) {
    const test::TemporaryFolder folder;
    for (const char* place : {"zbuffer", "z-buffer/vertex=1", "cull/row=3"}) {
        const auto done = run({"export", "pyramid", "-o", folder / "out", "--at", place});
        EXPECT_EQ(done.status, 2) << place;
        EXPECT_NE(done.err.find("expected"), std::string::npos) << done.err;
    }
    // Five polygons, five vertices, one object, one light, 480 rows.
    for (const char* place :
         {"cull/polygon=5", "transform/vertex=5", "z-buffer/object=1", "shadow-buffer/light=1/polygon=0",
          "z-buffer/polygon=2/row=480", "z-buffer/polygon=2/row=9/x=640"}) {
        const auto done = run({"export", "pyramid", "-o", folder / "out", "--at", place});
        EXPECT_EQ(done.status, 2) << place;
        EXPECT_NE(done.err.find("and the scene has "), std::string::npos) << done.err;
    }
    EXPECT_EQ(run({"film", "pyramid", "-o", folder / "f.gif", "--from", "z-buffer/polygon=98"}).status, 2);
    EXPECT_EQ(run({"export", "pyramid", "-o", folder / "out", "--at", "cull", "--until", "cull"}).status, 2);
    EXPECT_EQ(run({"export", "pyramid", "-o", folder / "out", "--at", "cull", "--buffers", "color"}).status, 2);
    EXPECT_FALSE(fs::exists(folder / "out"));
}

// Polygons 0 and 1 of the pyramid are drawn, 2 is not yet, whatever the scene's own settings are.
TEST(ExportCue, WritesWhatTheCueShows) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "talk.cues",
                    "[[cue]]\nname = \"Start\"\nscene = \"pyramid\"\n"
                    "[[cue]]\nname = \"Two: polygons\"\nscene = \"pyramid\"\nset = [\"cull=none\"]\n"
                    "stage = \"z-buffer\"\nplace = \"z-buffer/polygon=1\"\n[[cue.view]]\nbuffer = \"polygon_id\"\n");
    for (const char* name : {":Two: polygons", ":2"}) {
        const auto done = run({"export", "--cue", (folder / "talk.cues").string() + name, "-o", folder / "out",
                               "--format", "npy", "--size", "320x240"});
        ASSERT_EQ(done.status, 0) << done.err;
        EXPECT_FALSE(fs::exists(folder / "out/depth.npy"));
        const test::Npy ids = test::readNpy(folder / "out/polygon_id.npy");
        EXPECT_EQ(ids.shape, (std::vector<std::size_t>{240, 320}));
        EXPECT_EQ(*std::max_element(ids.values.begin(), ids.values.end()), 1);
    }
    const auto none = run({"export", "--cue", (folder / "talk.cues").string() + ":Strt", "-o", folder / "none"});
    EXPECT_EQ(none.status, 2);
    EXPECT_NE(none.err.find("the nearest is \"Start\""), std::string::npos) << none.err;
    test::writeText(folder / "bad.cues", "[[cue]]\nname = \"a\"\nscene = \"pyramid\"\nstage = \"cul\"\n");
    const auto bad = run({"export", "--cue", (folder / "bad.cues").string() + ":a", "-o", folder / "none"});
    EXPECT_EQ(bad.status, 3);
    EXPECT_NE(bad.err.find("bad.cues:4:9: cue.0.stage is \"cul\""), std::string::npos) << bad.err;
    test::writeText(folder / "bad.cues", "[[cue]]\nname = \"a\"\nscene = \"pyramid\"\narrangement = \"2 buffers\"\n");
    const auto arranged = run({"export", "--cue", (folder / "bad.cues").string() + ":a", "-o", folder / "none"});
    EXPECT_EQ(arranged.status, bad.status);
    EXPECT_NE(arranged.err.find("bad.cues:4:15: cue.0.arrangement is \"2 buffers\""), std::string::npos)
        << arranged.err;
    EXPECT_EQ(run({"export", "pyramid", "--cue", (folder / "talk.cues").string() + ":1", "-o", folder / "none"}).status,
              2);
    const auto neither = run({"export", "-o", folder / "none"});
    EXPECT_EQ(neither.status, 2);
    EXPECT_EQ(neither.err, "shadescope export: SCENE or --cue is required\n");
    const auto noFile = run({"export", "--cue", (folder / "missing.cues").string() + ":1", "-o", folder / "none"});
    EXPECT_EQ(noFile.status, 3);
    EXPECT_EQ(noFile.err, (folder / "missing.cues").string() + ": no such file\n");
    EXPECT_FALSE(fs::exists(folder / "none"));
}

// Each names a scene, settings, a place and buffers that are there.
TEST(ExportCue, WritesEveryCueOfTheTalksThatComeWithTheProgram) {
    const test::TemporaryFolder folder;
    const fs::path manual = fs::path(test::scene("pyramid.scene")).parent_path().parent_path() / "manual";
    for (const char* name : {"tour.cues", "lecture1.cues", "lecture2.cues"}) {
        const std::string talk = (manual / name).string(), text = test::readText(talk);
        int cues = 0;
        for (std::size_t at = 0; (at = text.find("\n[[cue]]\n", at)) != text.npos; ++at) {
            const std::string cue = fmt::format("{}:{}", talk, ++cues);
            const auto done = run({"export", "--cue", cue, "-o", folder / "out", "--format", "npy"});
            EXPECT_EQ(done.status, 0) << cue << ": " << done.err;
        }
        EXPECT_GT(cues, 0) << talk;
    }
}

// One mistake a cue; the value that is wrong stands in the last line.
TEST(ExportCue, TellsAMistakeOfTheCueWithItsPlace) {
    const test::TemporaryFolder folder;
    const std::string file = (folder / "talk.cues").string();
    const auto refused = [&](const std::string& lines, std::vector<std::string> more = {}) {
        test::writeText(file, "[[cue]]\nname = \"a\"\n" + lines);
        std::vector<std::string> all{"export", "--cue", file + ":a", "-o", (folder / "out").string()};
        all.insert(all.end(), more.begin(), more.end());
        const auto done = run(all);
        EXPECT_EQ(done.status, 3) << done.err;
        EXPECT_TRUE(done.err.starts_with(file + ':')) << done.err;
        return done.err.substr(std::min(done.err.size(), file.size() + 1));
    };
    const std::string scene = "scene = \"pyramid\"\n";
    EXPECT_EQ(refused(scene + "set = [\"cull=none\", \"shading=flatt\"]\n"),
              "4:21: shading is \"flatt\", expected flat, gouraud or phong\n");
    EXPECT_EQ(refused(scene + "set = [\"camera.near=2\", \"camera.far=1\"]\n"),
              "4:8: camera.near is 2, expected less than camera.far, which is 1\n");
    EXPECT_TRUE(refused("scene = \"nope\"\n").starts_with("3:9: no file and no built-in scene \"nope\""));
    EXPECT_TRUE(refused("scene = \"missing.toml\"\n").starts_with("3:9: " + (folder / "missing.toml").string() + ": "));
    const std::string mixed = refused(scene + "mix = \"foo=1\"\n");
    EXPECT_TRUE(mixed.starts_with("4:7: there is no term \"foo\"")) << mixed;
    EXPECT_TRUE(refused(scene + "condition = \"foo >\"\n").starts_with("4:13: "));
    EXPECT_TRUE(refused(scene + "condition = \"foo >\"\n", {"--where", "depth > 0"}).starts_with("4:13: "));
    EXPECT_TRUE(refused(scene + "place = \"z-buffer/polygon=99\"\n").starts_with("4:9: found \"z-buffer/polygon=99\""));
    const auto view = [&](const char* buffer) {
        return refused(scene + "[[cue.view]]\n[[cue.view]]\nbuffer = \"" + buffer + "\"\n");
    };
    EXPECT_EQ(view("n_dot_l.7"), "6:10: no buffer \"n_dot_l.7\": this scene has 1 light\n");
    EXPECT_EQ(view("shadow_verdict.7"), "6:10: no buffer \"shadow_verdict.7\": this scene has 1 light\n");
    EXPECT_EQ(view("condition"), "6:10: There is no condition.\n");
    EXPECT_EQ(refused(scene + "pixel = [9999, 5]\n"),
              "4:9: found the pixel 9999, 5, expected x from 0 to 639 and y from 0 to 479\n");
    EXPECT_TRUE(refused(scene + "pins = [[1, 5, 480]]\n").starts_with("4:8: found the pixel 5, 480"));
    EXPECT_EQ(refused(scene + "selected = \"light 1\"\n"), "4:12: found light 1, expected 0\n");
    EXPECT_TRUE(refused(scene + "selected = \"polygon 99\"\n").starts_with("4:12: found polygon 99"));
    EXPECT_TRUE(refused(scene + "bookmarks = [\"cull\", \"cull/polygon=99\"]\n").starts_with("4:22: found "));
    const auto inView = [&](const std::string& line) { return refused(scene + "[[cue.view]]\n" + line + '\n'); };
    EXPECT_TRUE(inView("overlays = [\"edges\", \"a\"]").starts_with("5:22: no overlay \"a\"; "));
    EXPECT_EQ(inView("against = \"zz\""),
              "5:11: found \"zz\", expected before, previous stage, buffer NAME, setting KEY=VALUE, scene NAME or file "
              "FILE\n");
    EXPECT_TRUE(inView("against = \"setting shading=foo\"").starts_with("5:11: shading is \"foo\", expected "));
    EXPECT_TRUE(inView("against = \"file nope.npy\"").starts_with("5:11: " + (folder / "nope.npy").string() + ": "));
    const auto inSpace = [&](const std::string& line) { return refused(scene + "[cue.view3d]\n" + line + '\n'); };
    EXPECT_EQ(inSpace("space = \"moon\""),
              "5:9: no space \"moon\", expected world, eye, clip, screen, light 0, light 0 -x or point\n");
    EXPECT_EQ(inSpace("space = \"light 9\""), "5:9: found light 9, expected 0\n");
    EXPECT_TRUE(inSpace("options = { foo = 1 }").starts_with("5:19: no option \"foo\"; "));
    EXPECT_TRUE(inSpace("options = { normals = 3 }").starts_with("5:23: normals is 3, expected "));
    EXPECT_FALSE(fs::exists(folder / "out"));
    // The option's own mistake stays the option's.
    test::writeText(file, "[[cue]]\nname = \"a\"\n" + scene + "[[cue.view]]\nbuffer = \"condition\"\n");
    const auto option = run({"export", "--cue", file + ":a", "-o", folder / "out", "--where", "foo >"});
    EXPECT_EQ(option.status, 2);
    EXPECT_TRUE(option.err.starts_with("--where:1:")) << option.err;
}

// What the window writes of its own has every kind of word.
TEST(ExportCue, TakesEveryWordThatTheManualLists) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "reference.npy", "");
    test::writeText(
        folder / "talk.cues",
        "[[cue]]\nname = \"a\"\nscene = \"pyramid\"\npixel = [639, 479]\nselected = \"object 0\"\n"
        "[[cue.view]]\nrange = [5, 1]\nagainst = \"file reference.npy\"\n"
        "overlays = [\"edges\", \"edge_functions\", \"verdict\", \"fragments\", \"polygon_size\", "
        "\"depth_test\", \"strange\", \"condition\", \"shadow_verdict.0\"]\n"
        "[[cue.view]]\nagainst = \"buffer z_view\"\n[[cue.view]]\nagainst = \"setting shading=gouraud\"\n"
        "[[cue.view3d]]\nspace = \"light 0 -x\"\noptions = { lobe = 1 }\n[[cue.view3d]]\nspace = \"point\"\n");
    const auto done = run({"export", "--cue", (folder / "talk.cues").string() + ":a", "-o", folder / "out", "--size",
                           "16x12", "--format", "npy"});
    EXPECT_EQ(done.status, 0) << done.err;
}

// Numbers are no condition, and the window keeps one text for both.
TEST(ExportCue, TakesTextThatGivesNumbers) {
    const test::TemporaryFolder folder;
    const std::string cue = "[[cue]]\nname = \"a\"\nscene = \"pyramid\"\ncondition = \"2 * n_dot_l.0\"\n";
    const auto exported = [&](const std::string& text) {
        test::writeText(folder / "talk.cues", text);
        const auto done = run({"export", "--cue", (folder / "talk.cues").string() + ":a", "-o", folder / "out",
                               "--size", "16x12", "--format", "npy"});
        EXPECT_EQ(done.status, 0) << done.err;
    };
    exported(cue + "[[cue.view]]\nbuffer = \"color\"\n");
    EXPECT_FALSE(fs::exists(folder / "out/condition.npy"));
    exported(cue + "[[cue.view]]\nbuffer = \"expression\"\n");
    EXPECT_TRUE(fs::exists(folder / "out/expression.npy"));
}

// A cue was made for the window: what it looks at and the run does not reach was not asked for here.
TEST(ExportCue, LeavesOutWhatComesAfterItsPlace) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "talk.cues",
                    "[[cue]]\nname = \"bare\"\nscene = \"pyramid\"\nplace = \"z-buffer/polygon=2\"\n"
                    "[[cue]]\nname = \"shown\"\nscene = \"pyramid\"\ncondition = \"n_dot_l.0 > 0.5\"\n"
                    "[[cue.view]]\nbuffer = \"color\"\n[[cue.view]]\nbuffer = \"depth\"\n"
                    "[[cue.view]]\nbuffer = \"condition\"\n[[cue.view]]\nbuffer = \"mix\"\n");
    const auto exported = [&](const char* cue, const char* out, std::vector<std::string> more) {
        std::vector<std::string> all{"export",   "--cue", (folder / "talk.cues").string() + cue, "-o", folder / out,
                                     "--format", "npy"};
        all.insert(all.end(), more.begin(), more.end());
        return run(all);
    };
    // No view of its own: all that there is at its place.
    const auto bare = exported(":bare", "bare", {});
    EXPECT_EQ(bare.status, 0) << bare.err;
    EXPECT_TRUE(fs::exists(folder / "bare/depth.npy"));
    EXPECT_TRUE(fs::exists(folder / "bare/vertices.world.npy"));
    EXPECT_FALSE(fs::exists(folder / "bare/color.npy"));

    for (const char* end : {"--at", "--until"}) {
        const auto shown = exported(":shown", end, {end, "z-buffer"});
        EXPECT_EQ(shown.status, 0) << shown.err;
        EXPECT_NE(shown.err.find("left out: color comes from shading, and the run ends after z-buffer\n"),
                  std::string::npos)
            << shown.err;
        EXPECT_TRUE(fs::exists(folder / end / "depth.npy"));
        for (const char* late : {"color.npy", "condition.npy", "mix.npy", "vertices.world.npy"})
            EXPECT_FALSE(fs::exists(folder / end / late)) << late;
    }
    EXPECT_EQ(exported(":shown", "whole", {}).status, 0);
    for (const char* file : {"color.npy", "depth.npy", "condition.npy", "mix.npy"})
        EXPECT_TRUE(fs::exists(folder / "whole" / file)) << file;
    // Asked for by name, it is refused as ever.
    EXPECT_EQ(exported(":shown", "none", {"--at", "cull", "--buffers", "color"}).status, 2);
    EXPECT_EQ(exported(":shown", "none", {"--at", "cull", "--where", "n_dot_l.0 > 0.5"}).status, 2);
    EXPECT_FALSE(fs::exists(folder / "none"));
}

TEST(Film, IsAGifOrAFolderOfPictures) {
    const test::TemporaryFolder folder;
    const auto gif = run({"film", "pyramid", "--size", "320x240", "--buffer", "z_view", "-o", folder / "film.gif"});
    ASSERT_EQ(gif.status, 0) << gif.err;
    EXPECT_EQ(test::readText(folder / "film.gif").substr(0, 6), "GIF89a");
    const auto pictures =
        run({"film", "pyramid", "--size", "320x240", "--buffer", "z_view", "--no-captions", "-o", folder / "film"});
    ASSERT_EQ(pictures.status, 0) << pictures.err;
    // The beginning, and the three polygons that face the eye.
    EXPECT_NE(pictures.err.find("4 pictures"), std::string::npos) << pictures.err;
    EXPECT_EQ(test::readPng(folder / "film/step_0004.png").height, 240);
    EXPECT_FALSE(fs::exists(folder / "film/step_0005.png"));
}

TEST(Film, RefusesWhatCannotBeFilmed) {
    const test::TemporaryFolder folder;
    const std::vector<std::vector<std::string>> wrong{{"--buffer", "vertices.world"},
                                                      {"--buffer", "nothing"},
                                                      {"--from", "nowhere"},
                                                      {"--by", "row"},
                                                      {"--from", "shading", "--to", "shading/start"}};
    for (const auto& options : wrong) {
        std::vector<std::string> all{"film", "pyramid", "-o", (folder / "film.gif").string()};
        all.insert(all.end(), options.begin(), options.end());
        const auto done = run(all);
        EXPECT_EQ(done.status, 2) << options.back();
        EXPECT_NE(done.err, "") << options.back();
    }
    const auto derived = run({"film", "pyramid", "-o", folder / "film.gif", "--buffer", "mix"});
    EXPECT_EQ(derived.status, 2);
    EXPECT_EQ(derived.err, "shadescope film: mix is derived from a finished frame and cannot be filmed\n");
    EXPECT_NE(run({"bench", "pyramid", "--buffers", "z_ndc"}).err.find("z_ndc is derived"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder / "film.gif"));
}

// The inspector's ledger and the algorithm's line tell the same comparison of the same fragment.
TEST(InspectStep, ComparesTheDepthsThatTheInspectorLists) {
    const std::string file = "pyramid";
    for (const auto& [x, y] : {std::pair{250, 270}, {247, 290}, {262, 262}}) {
        const auto seen = run({"inspect", file, "--set", "cull=none", "--pixel", fmt::format("{},{}", x, y), "--json"});
        ASSERT_EQ(seen.status, 0) << seen.err;
        const auto fragments = nlohmann::json::parse(seen.out)["fragments"];
        ASSERT_GE(fragments.size(), 2u) << x << ' ' << y;
        for (const auto& fragment : fragments) {
            const std::string place =
                fmt::format("z-buffer/polygon={}/row={}/x={}/line=5", fragment["polygon"].get<int>(), y, x);
            const auto step = run({"inspect", file, "--set", "cull=none", "--step", place});
            ASSERT_EQ(step.status, 0) << step.err;
            // "671.9340 < 742.3430"
            const std::string text = fragment["text"].get<std::string>();
            const std::string z = text.substr(0, text.find(' '));
            EXPECT_TRUE(has(step.out, fmt::format("z = {} < zbuffer({}, {})", z, x, y))) << place << '\n' << step.out;
            const bool taken = text.find(" < ") != text.npos;
            EXPECT_TRUE(has(step.out, taken ? "true, taken" : "false, not taken")) << place << '\n' << step.out;
        }
    }
    EXPECT_EQ(run({"inspect", file, "--step", "z-bufer"}).status, 2);
}

}  // namespace
