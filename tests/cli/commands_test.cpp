#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"

namespace {

using Json = nlohmann::json;
using test::has;
using test::run;
using test::scene;

TEST(Commands, ASceneComesFromStandardInput) {
    const auto piped = test::runReading(scene("lambert.toml"), {"inspect", "-", "--pixel", "320,240"});
    EXPECT_EQ(piped.status, 0) << piped.err;
    EXPECT_EQ(piped.out, run({"inspect", "lambert", "--pixel", "320,240"}).out);
    const auto other = test::runReading(scene("pyramid.des"), {"inspect", "-", "--pixel", "320,240"});
    EXPECT_EQ(other.status, 3);
    EXPECT_TRUE(has(other.err, "standard input:")) << other.err;
}

TEST(Commands, AUsageErrorPointsToTheHelpOfItsCommand) {
    const auto wrong = run({"inspect", "pyramid", "--nothing"});
    EXPECT_EQ(wrong.status, 2);
    EXPECT_TRUE(has(wrong.err, "\nRun shadescope inspect --help to see what there is.\n")) << wrong.err;
    EXPECT_EQ(run({"inspect", "--help"}).status, 0);
}

TEST(Commands, HelpSpeaksOfASceneWhereTheCommandTakesOne) {
    for (const char* command : {"plan", "check", "drill", "grade", "inspect", "sheet"}) {
        const std::string help = run({command, "--help"}).out;
        const std::string usage = help.substr(0, help.find("SCENE is a scene file"));
        EXPECT_EQ(usage.size() < help.size(), has(usage, "SCENE")) << command;
        EXPECT_TRUE(has(help, "Exit status: 0 done")) << command;
    }
}

// A message that names some of many says which command names all.
TEST(Commands, UnknownSettingsAndBuffersPointToTheListOfAll) {
    const std::string list = "; shadescope plan --json SCENE lists all\n";
    const auto json = nlohmann::json::parse(run({"plan", "pyramid", "--json"}).out);
    const auto expected = [&](const std::string& what, const char* of) {
        return "no " + what + "; there are " + std::to_string(json[of].size()) + ", the nearest are ";
    };
    const std::string setting = run({"plan", "pyramid", "--set", "qqqq=1"}).err;
    EXPECT_TRUE(setting.starts_with(expected("setting \"qqqq\"", "settings"))) << setting;
    EXPECT_TRUE(setting.ends_with(list)) << setting;
    const std::string buffer = run({"figure", "pyramid", "--buffer", "qqqq", "-o", "never.svg"}).err;
    EXPECT_TRUE(buffer.starts_with(expected("buffer \"qqqq\"", "buffers"))) << buffer;
    EXPECT_TRUE(buffer.ends_with(list)) << buffer;
}

TEST(Program, HelpAndVersionGoToStandardOutput) {
    for (const char* option : {"-h", "--help"}) {
        const auto done = run({option});
        EXPECT_EQ(done.status, 0);
        for (const char* word : {"export", "present"}) EXPECT_TRUE(has(done.out, word)) << done.out;
#ifdef SHADESCOPE_WINDOW
        EXPECT_TRUE(has(done.out, "--no-session")) << done.out;
#endif
        EXPECT_EQ(done.err, "");
    }
    EXPECT_EQ(run({"--version"}).out, "shadescope " SHADESCOPE_VERSION "\n");
    for (const char* command : {"export", "plan", "inspect", "bench", "check", "lesson", "present"}) {
        const auto done = run({command, "--help"});
        EXPECT_EQ(done.status, 0) << command;
        EXPECT_TRUE(has(done.out, "Usage: shadescope " + std::string(command))) << done.out;
    }
}

TEST(Program, WrongUsageIsStatus2) {
    const auto typo = run({"expotr", "x"});
    EXPECT_EQ(typo.status, 2);
    EXPECT_TRUE(has(typo.err, "there is no file and no command \"expotr\"; the nearest command is export"));
    EXPECT_EQ(run({"--bogus"}).status, 2);
    EXPECT_EQ(run({"export"}).status, 2);
    EXPECT_EQ(run({"export", "pyramid"}).status, 2);  // no -o
    EXPECT_EQ(run({"export", "pyramid", "-o", ""}).err, "shadescope export: -o needs the name of a folder\n");
    const auto film = run({"film", "pyramid", "-o", ""});
    EXPECT_EQ(film.status, 2);
    EXPECT_EQ(film.err, "shadescope film: -o needs the name of a file or a folder\n");
    EXPECT_EQ(run({"plan", "pyramid", "surplus"}).status, 2);
    const auto two = run({"a.toml", "b.toml"});
    EXPECT_EQ(two.status, 2);
    EXPECT_TRUE(has(two.err, "the window takes one file, not also \"b.toml\"")) << two.err;
    EXPECT_EQ(run({"lesson"}).status, 2);
    EXPECT_EQ(run({}).status, 2);  // no display, or no window at all
}

TEST(Program, BadInputIsStatus3WithItsPlace) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "broken.scene",
                    "200, 1000, 45, 60\n1\nmissing.des\n1, 1, 1\n0, 0, 0\n0, 0, 0\n1\n1, 1, 1, 100\n50\n");
    const auto done = run({"plan", folder / "broken.scene"});
    EXPECT_EQ(done.status, 3);
    EXPECT_TRUE(done.err.starts_with((folder / "broken.scene").string() + ":3:1: ")) << done.err;
    EXPECT_EQ(done.out, "");
    EXPECT_EQ(run({"plan", folder / "nothing.scene"}).status, 3);
    EXPECT_EQ(run({"plan", folder.path()}).status, 3);
    const auto unknown = run({"plan", "pyramyd"});
    EXPECT_EQ(unknown.status, 3);
    EXPECT_EQ(unknown.err, "no file and no built-in scene \"pyramyd\"; the nearest is \"pyramid\"\n");
}

// A model says what is wrong with it, and the scene's file where it is named.
TEST(Program, AModelsMistakeHasThePlaceThatNamesIt) {
    const test::TemporaryFolder folder;
    const std::string file = (folder / "s.toml").string();
    test::writeText(folder / "empty.obj", "");
    test::writeText(folder / "text.gltf", "no glTF");
    const auto refusal = [&](const std::string& model) {
        test::writeText(file, "[[object]]\nmodel = \"" + model + "\"\n");
        const auto done = run({"plan", file});
        EXPECT_EQ(done.status, 3);
        return done.err;
    };
    EXPECT_TRUE(refusal("empty.obj").starts_with(file + ":2:9: " + (folder / "empty.obj").string() + ": "))
        << refusal("empty.obj");
    EXPECT_EQ(refusal("text.gltf"), (folder / "text.gltf").string() + ":1:2: this is not JSON, expected a glTF file\n");
}

// What the scene's values together are refused for: in the file with the place of one, and as the option that gave it.
TEST(Program, ValuesThatDoNotGoTogetherHaveTheirPlaceOrOption) {
    const test::TemporaryFolder folder;
    const std::string file = (folder / "s.toml").string();
    test::writeText(file, "[camera]\nnear = 5\nfar = 4\n");
    const auto done = run({"plan", file});
    EXPECT_EQ(done.status, 3);
    EXPECT_EQ(done.err, file + ":2:8: camera.near is 5, expected less than camera.far, which is 4\n");
    const auto refusal = [](std::vector<std::string> more) {
        more.insert(more.begin(), {"plan", "pyramid"});
        const auto refused = run(more);
        EXPECT_EQ(refused.status, 2) << refused.err;
        return refused.err;
    };
    EXPECT_EQ(refusal({"--set", "camera.near=2", "--set", "camera.far=1"}),
              "--set camera.near=2: camera.near is 2, expected less than camera.far, which is 1\n");
    EXPECT_EQ(refusal({"--set", "model=opengl", "--set", "material.0.n=129"}),
              "--set material.0.n=129: material.0.n is 129, expected at most 128 in OpenGL's model\n");
    EXPECT_EQ(refusal({"--set", "object.0.tessellation=4"}),
              "no setting \"object.0.tessellation\": the object is a mesh, not a built-in shape\n");
    EXPECT_TRUE(refusal({"--size", "0x10"}).starts_with("--size 0x10: width is \"0\", expected "));
    EXPECT_TRUE(refusal({"--size", "16384x16384", "--counts"}).starts_with("--size 16384x16384: the buffers of a "));
}

TEST(Program, AFullDiskBehindStandardOutputIsStatus4) {
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"plan", "pyramid"},
                                                      {"plan", "pyramid", "--json"},
                                                      {"--help"},
                                                      {"inspect", "pyramid", "--pixel", "268,281"}}) {
        const auto done = test::runInto("/dev/full", arguments);
        EXPECT_EQ(done.status, 4) << arguments[0];
        EXPECT_EQ(done.err, "standard output: could not write: No space left on device\n");
    }
}

// Nobody can be told; what happened is the same.
TEST(Program, AMessageThatCannotBeWrittenChangesNoStatus) {
    const test::TemporaryFolder folder;
    for (const char* closed : {"/dev/full", ""}) {
        const auto status = [&](const std::vector<std::string>& arguments) {
            return test::runTellingInto(closed, arguments).status;
        };
        const auto out = (folder / (std::string("out") + (*closed ? "Full" : "Closed"))).string();
        EXPECT_EQ(status({"export", "pyramid", "--size", "8x8", "--format", "npy,scene", "-o", out}), 0) << closed;
        const std::string scene = test::readText(out + "/pyramid.toml");
        EXPECT_FALSE(has(scene, "files, ")) << "a message in a file that was given standard error's number";
        EXPECT_EQ(status({"export", "pyramid", "--size", "0x1", "-o", out}), 2) << closed;
        EXPECT_EQ(status({"plan", "--bogus"}), 2) << closed;
        EXPECT_EQ(status({"bench", "pyramid", "--scaling"}), 2) << closed;
        EXPECT_EQ(status({"plan", "nosuch"}), 3) << closed;
        EXPECT_EQ(status({"export", "pyramid", "--size", "8x8", "-o", "/proc/out"}), 4) << closed;
        EXPECT_EQ(status({"film", "pyramid", "--size", "8x8", "-o", out + ".gif"}), 0) << closed;
    }
}

// What a file says, or is called, does nothing to the terminal.
TEST(Program, PrintsNoControlCharactersOfNames) {
    const test::TemporaryFolder folder;
    for (const char* escape : {"\\u001b[31m", "\\n", "\\u0000", "\\u202e"}) {
        test::writeText(folder / "scene.toml", std::string("title = \"a") + escape + "b\"\n");
        const auto done = run({"plan", folder / "scene.toml"});
        EXPECT_EQ(done.status, 3);
        EXPECT_TRUE(has(done.err, "scene.toml:1:9: title is \"a\\x")) << done.err;
        EXPECT_TRUE(has(done.err, "expected one line without control characters")) << done.err;
    }
    test::writeText(folder / "scene.toml", "[[object]]\nshape = \"plane\"\nname = \"a\\tb\"\n");
    EXPECT_TRUE(has(run({"plan", folder / "scene.toml"}).err, "scene.toml:3:8: object.0.name is "));
    const auto file = folder / "a\x1b[31m\xe9.toml";
    test::writeText(file, "[[object]]\nshape = \"plane\"\n");
    EXPECT_TRUE(run({"plan", file}).out.starts_with("a?[31m?.toml, "));
}

TEST(Plan, SaysWhatIsLeftOutAndWhy) {
    const auto done = run({"plan", scene("pyramid.scene")});
    EXPECT_EQ(done.status, 0);
    EXPECT_TRUE(has(done.out, "The only object is convex: it cannot shadow itself."));
    EXPECT_TRUE(has(done.out, "Flat shading needs polygon normals only."));
    const auto gouraud = run({"plan", scene("pyramid.scene"), "--set", "shading=gouraud"});
    EXPECT_FALSE(has(gouraud.out, "Flat shading"));
}

TEST(Plan, AsJson) {
    const auto done = run({"plan", "pyramid", "--json"});
    EXPECT_EQ(done.status, 0);
    const Json json = Json::parse(done.out);
    ASSERT_EQ(json["plan"].size(), 6u);
    const char* names[] = {"transform", "cull", "normals", "shadow-buffer", "z-buffer", "shading"};
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(json["plan"][i]["stage"], names[i]);
    EXPECT_EQ(json["plan"][3]["action"], "left out");
    EXPECT_FALSE(json["absent"].empty());
}

TEST(Plan, EndsWithRemarksAboutWhatIsStrange) {
    EXPECT_FALSE(has(run({"plan", "pyramid"}).out, "Remarks"));
    const auto dark = run({"plan", "pyramid", "--set", "light.0.intensity=-5"});
    EXPECT_EQ(dark.status, 0);
    EXPECT_TRUE(has(dark.out, "\nRemarks\n    light.0.intensity    The intensity of light 0 is -5, below 0"))
        << dark.out;
    const Json json = Json::parse(run({"plan", "pyramid", "--json", "--set", "light.0.intensity=-5"}).out);
    ASSERT_EQ(json["remarks"].size(), 1u);
    EXPECT_EQ(json["remarks"][0]["about"], "light.0.intensity");
}

TEST(Plan, WhatIsNamedIsNotLeftOut) {
    const Json json = Json::parse(run({"plan", "pyramid", "--json", "--buffers", "shadow_buffer.0"}).out);
    EXPECT_EQ(json["plan"][3]["action"], "runs");
    EXPECT_EQ(json["plan"][5]["why"], "The run ends after shadow-buffer.");
}

TEST(Bench, MeasuresEveryStageThatRuns) {
    const auto done = run({"bench", "pyramid", "--json", "--repeat", "7", "--warm-up", "1", "--threads", "1"});
    ASSERT_EQ(done.status, 0) << done.err;
    const Json json = Json::parse(done.out);
    EXPECT_EQ(json["threads"], 1);
    EXPECT_EQ(json["repeats"], 7);
    EXPECT_GT(json["peak_memory_bytes"].get<double>(), 640 * 480 * 3);
    // The picture is among the buffers that the frame keeps; the share is their bytes over what memset writes meanwhile.
    const double kept = json["buffer_bytes"].get<double>(), rate = json["memset_bytes_per_second"].get<double>();
    EXPECT_GE(kept, 640 * 480 * 3);
    EXPECT_NEAR(json["share_of_memset"].get<double>() * rate * json["milliseconds"]["median"].get<double>() / 1000,
                kept, 1e-6 * kept);
    ASSERT_EQ(json["stages"].size(), 6u);
    EXPECT_FALSE(json["stages"][3].contains("milliseconds"));  // left out
    double sum = 0;
    for (const Json& stage : json["stages"]) {
        if (!stage.contains("milliseconds")) continue;
        const Json& time = stage["milliseconds"];
        EXPECT_LE(time["min"], time["median"]);
        EXPECT_LE(time["median"], time["p95"]);
        EXPECT_LE(time["median_interval"][0], time["median"]);
        EXPECT_GE(time["median_interval"][1], time["median"]);
        sum += time["min"].get<double>();
    }
    EXPECT_GT(sum, 0);
    EXPECT_LE(sum, json["milliseconds"]["median"].get<double>());
    const auto table = run({"bench", "pyramid", "--repeat", "2"});
    EXPECT_EQ(table.status, 0);
    EXPECT_TRUE(has(table.out, "z-buffer")) << table.out;
}

TEST(Bench, EndsAfterAStage) {
    for (const char* more : {"--json", "--leave-out"}) {
        const auto done = run({"bench", "pyramid", "--until", "z-buffer", "--repeat", "1", "--warm-up", "0", more});
        EXPECT_EQ(done.status, 0) << done.err;
    }
    const Json json = Json::parse(run({"bench", "pyramid", "--until", "z-buffer", "--repeat", "1", "--json"}).out);
    EXPECT_EQ(json["stages"][4]["action"], "runs");
    EXPECT_EQ(json["stages"][5]["why"], "The run ends after z-buffer.");
    const auto asked = run({"bench", "pyramid", "--until", "z-buffer", "--buffers", "color"});
    EXPECT_EQ(asked.status, 2);
    EXPECT_EQ(asked.err, "color comes from shading, and the run ends after z-buffer\n");
}

// Every stage that runs has its share, and none of them more than the frame.
TEST(Bench, SaysTheShareOfEveryStage) {
    const Json json = Json::parse(run({"bench", "pyramid", "--json", "--repeat", "3", "--threads", "1"}).out);
    for (const Json& stage : json["stages"]) {
        if (!stage.contains("milliseconds")) continue;
        EXPECT_GE(stage["share"].get<double>(), 0);
        EXPECT_LE(stage["share"].get<double>(), 1) << stage["stage"];
    }
    EXPECT_EQ(json["stages"][4]["tallies"][0]["what"], "triangles clipped");
    EXPECT_EQ(json["stages"][4]["tallies"][0]["left_out"], 3);
}

TEST(Bench, FitsHowTimeGrows) {
    const auto done = run({"bench", "--scaling", "--repeat", "1", "--json"});
    ASSERT_EQ(done.status, 0) << done.err;
    const Json json = Json::parse(done.out);
    ASSERT_EQ(json.size(), 2u);
    EXPECT_EQ(json[0]["over"], "polygons");
    EXPECT_EQ(json[1]["over"], "pixels");
    for (const Json& series : json) {
        EXPECT_EQ(series["sizes"].size(), series["milliseconds"].size());
        EXPECT_TRUE(series["exponent"].is_number());
        EXPECT_EQ(series["stages"].size(), 6u);
    }
}

// What would change nothing is refused, so that nobody takes the answer for one that it has changed.
TEST(Program, OptionsThatDoNothingThereAreRefused) {
    const auto threads = run({"plan", "pyramid", "--threads", "2"});
    EXPECT_EQ(threads.status, 2);
    EXPECT_TRUE(has(threads.err, "--threads requires --counts")) << threads.err;
    EXPECT_EQ(run({"plan", "pyramid", "--threads", "2", "--counts"}).status, 0);
    const auto both = run({"bench", "pyramid", "--leave-out", "--no-leave-out"});
    EXPECT_EQ(both.status, 2);
    EXPECT_TRUE(has(both.err, "--no-leave-out excludes --leave-out")) << both.err;
}

TEST(Bench, RefusesWhatSaysNothingToItsOwnSpheres) {
    for (const std::vector<std::string>& more : {std::vector<std::string>{"no_such_scene"},
                                                 {"pyramid"},
                                                 {"--set", "shading=phong"},
                                                 {"--set", "nothing"},
                                                 {"--size", "9x9"},
                                                 {"--no-leave-out"},
                                                 {"--leave-out"},
                                                 {"--buffers", "depth"},
                                                 {"--until", "cull"},
                                                 {"--warm-up", "1"}}) {
        std::vector<std::string> arguments{"bench", "--scaling"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const auto done = run(arguments);
        EXPECT_EQ(done.status, 2) << more[0];
        EXPECT_EQ(done.out, "") << more[0];
        EXPECT_TRUE(has(done.err, more[0].starts_with('-') ? more[0] : "SCENE")) << done.err;
        EXPECT_TRUE(has(done.err, "does not go with --scaling")) << done.err;
    }
}

TEST(Bench, CtrlCIsStatus130) {
    const auto done = test::runAndInterrupt({"bench", "pyramid", "--repeat", "100000"}, 300);
    EXPECT_EQ(done.status, 130);
    EXPECT_EQ(done.out, "");
    EXPECT_EQ(done.err, "Cancelled.\n");
}

TEST(Check, PrintsARowACaseAndHowManyHold) {
    const auto done = run({"check", "--case", "S10", "--case", "g1"});
    EXPECT_EQ(done.status, 0) << done.err;
    EXPECT_NE(done.out.find("Specular exponent"), std::string::npos);
    EXPECT_NE(done.out.find("Triangle with equal corners"), std::string::npos);
    EXPECT_NE(done.out.find("\n2 of 2 hold, in "), std::string::npos);
}

TEST(Check, JsonHasBothForms) {
    const auto done = run({"check", "--group", "depth", "--json"});
    EXPECT_EQ(done.status, 0) << done.err;
    const auto json = nlohmann::json::parse(done.out);
    EXPECT_EQ(json["cases"], json["hold"]);
    for (const auto& result : json["results"]) EXPECT_EQ(result["group"], "depth");
}

TEST(Check, ListRunsNothing) {
    const auto done = run({"check", "--list", "--group", "shadow"});
    EXPECT_EQ(done.status, 0);
    EXPECT_NE(done.out.find("H1 "), std::string::npos);
    EXPECT_EQ(done.out.find("S10"), std::string::npos);
}

TEST(Check, UnknownNamesAreAnsweredWithTheNearest) {
    const auto id = run({"check", "--case", "S100"});
    EXPECT_EQ(id.status, 2);
    EXPECT_EQ(id.err, "there is no case \"S100\"; the nearest is S10\n");
    const auto group = run({"check", "--group", "shadows"});
    EXPECT_EQ(group.status, 2);
    EXPECT_EQ(group.err, "there is no group \"shadows\"; the nearest is shadow\n");
}

}  // namespace
