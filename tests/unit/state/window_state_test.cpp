// What the window shows as text: there and back the same, and what is wrong is told with its place.
#include "lessons/state/window_state.h"

#include <gtest/gtest.h>

#include "lessons/state/cue_list.h"
#include "lessons/state/state_scene.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/scene/settings_table.h"
#include "tests/support/files.h"
#include "tests/support/scenes.h"

namespace lessons {
namespace {

// Everything other than it begins, with numbers that have no short decimals.
WindowState rich() {
    WindowState state;
    state.scene = "folder/a \"b\".toml";
    state.set = {"camera.theta=50", "shading=phong"};
    state.stage = pipeline::StageId::ZBuffer;
    state.place = *pipeline::parsePlace("z-buffer/polygon=2/row=270/x=258");
    state.step = pipeline::StepLevel::Line;
    state.algorithm = true;
    state.sliders = {"eye.x", "light.0.intensity"};
    state.pixel = {268, 281};
    state.channel = 0;
    state.arrangement = "four";
    BufferShown view{"n_dot_l.0", ShownChannel::All, std::array{1e300, -1.0 / 3}, {"edges", "verdict"}};
    view.zoom = {12, {268.5, 1.0 / 7}, {801, 600}};
    view.logCounts = false, view.flipped = true, view.region = {3, 4, 99, 47};
    state.views = {view, {"normal", ShownChannel::Third}, {"color", ShownChannel::Luminance}};
    view.compared = {"setting shading=gouraud", "difference", 0.25, "RAE", std::array{-1e-3, 1.0 / 3}};
    state.views[0] = view, state.views[1].compared.emplace();
    state.pins = {{1, {268, 281}}, {9, {0, 0}}};
    state.selected = Selection{Selection::Kind::Polygon, 12};
    state.linked = false;
    state.spaces[0].space = "point";
    SpaceShown::Camera camera;
    camera.target = {0.1, -1.0 / 3, 1e-17};
    camera.right = {0.6, 0.8, -0.0}, camera.forward = {-0.8, 0.6, 0}, camera.up = {0, 0, 1};
    camera.distance = 719.1234567890123, camera.fov = 31.4, camera.orthographic = true;
    state.spaces[0].camera = camera;
    state.spaces[0].options = {{"boxes", 1}, {"normal_length", 12.5}};
    state.spaces.push_back({"light 0 -x"});
    state.bookmarks = {*pipeline::parsePlace("cull/polygon=1"), *pipeline::parsePlace("shading/layers")};
    return state;
}

std::string errorsIn(std::string_view text) {
    const auto state = readState(text, "s.toml");
    return state ? "" : format(state.errors());
}

TEST(WindowState, IsTheSameAfterWritingAndReading) {
    for (const WindowState& state : {WindowState(), rich()}) {
        const std::string text = toToml(state);
        const auto again = readState(text, "s.toml");
        ASSERT_TRUE(again) << format(again.errors()) << text;
        EXPECT_TRUE(*again == state) << text << "\nbecame\n" << toToml(*again);
    }
}

TEST(WindowState, WhatIsWrongIsToldWithItsPlace) {
    EXPECT_EQ(errorsIn("stage = \"shadng\"\n"),
              "s.toml:1:9: stage is \"shadng\", expected \"transform\", \"cull\", \"normals\", \"shadow-buffer\", "
              "\"z-buffer\" or \"shading\"\n");
    EXPECT_EQ(errorsIn("stage = \"cull\"\npixl = [1, 2]\n"), "s.toml:2:1: no key \"pixl\"; the nearest is \"pixel\"\n");
    EXPECT_TRUE(errorsIn("place = \"z-buffer/polygn=2\"\n").starts_with("s.toml:1:9: place: "));
    EXPECT_TRUE(errorsIn("[[view]]\nbuffer = \"dept\"\n").starts_with("s.toml:2:10: view.buffer is \"dept\""));
    EXPECT_TRUE(errorsIn("[[view]]\nbuffer = \"dept\"\n").find("the nearest is \"depth\"") != std::string::npos);
    EXPECT_TRUE(errorsIn("[[view]]\nrange = [2, 2]\n").starts_with("s.toml:2:9: view.range ends where it begins"));
    EXPECT_EQ(errorsIn("[[view]]\nchannel = 2\n"),
              "s.toml:2:11: view.channel is 2, expected \"first\", \"second\", \"third\" or \"luminance\"\n");
    EXPECT_TRUE(errorsIn("[[view]]\nzoom = 4\n").starts_with("s.toml:2:8: view.zoom stands without"));
    EXPECT_TRUE(errorsIn("[view3d]\ndistance = 4\ntarget = [0, 0, 0]\n").starts_with("s.toml:2:12: view3d.distance"));
    EXPECT_TRUE(errorsIn("pixel = [1]\n").starts_with("s.toml:1:9: pixel is an array of 1, expected an array of 2"));
    for (const char* text : {"pixel = [2.5, 3]\n", "pins = [[1, 4.5, 5]]\n", "[[view]]\nregion = [0, 0, 2, 1.5]\n"})
        EXPECT_NE(errorsIn(text).find("expected whole numbers from 0"), std::string::npos) << errorsIn(text);
    EXPECT_EQ(errorsIn("sliders = [\"a\", \"b\", \"c\"]\n"),
              "s.toml:1:11: sliders is an array of 3, expected at most 2 keys of settings\n");
    EXPECT_EQ(errorsIn("selected = \"polygn 3\"\n"),
              "s.toml:1:12: selected is \"polygn 3\", expected object, polygon, vertex or light, and its number\n");
    EXPECT_TRUE(errorsIn("pins = [[10, 3, 4]]\n").starts_with("s.toml:1:9: pins is "));
    EXPECT_TRUE(
        errorsIn("[[view]]\nagainst = \"before\"\ncompare = \"wype\"\n").starts_with("s.toml:3:11: view.compare"));
    EXPECT_EQ(
        errorsIn("arrangement = \"buffer |\"\n"),
        "s.toml:1:15: arrangement is \"buffer |\", expected a name, or buffer and 3d with | and / between them\n");
    EXPECT_TRUE(errorsIn("stage = \n").starts_with("s.toml:1:"));
}

// Written by hand, with its buffers alone.
TEST(WindowState, WithoutAnArrangementAllBuffersAreShown) {
    const std::string view = "[[view]]\nbuffer = \"depth\"\n";
    const auto arrangementOfMany = [&](int views) {
        std::string text;
        for (int i = 0; i < views; ++i) text += view;
        const auto state = readState(text, "s.toml");
        return state ? state->arrangement : format(state.errors());
    };
    EXPECT_EQ(arrangementOfMany(0), "one");
    EXPECT_EQ(arrangementOfMany(1), "one");
    EXPECT_EQ(arrangementOfMany(2), "two");
    EXPECT_EQ(arrangementOfMany(3), "four");
}

// As every file before there were more 3D views than one has it.
TEST(WindowState, OneView3dIsATable) {
    const auto state = readState("[view3d]\nspace = \"eye\"\n", "s.toml");
    ASSERT_TRUE(state) << format(state.errors());
    ASSERT_EQ(state->spaces.size(), 1u);
    EXPECT_EQ(state->spaces[0].space, "eye");
    EXPECT_NE(toToml(*state).find("\n[view3d]\n"), std::string::npos);
}

TEST(WindowState, ChangedSettingsAreKeptAsSettings) {
    const pipeline::Scene original = test::pyramid();
    pipeline::Scene changed = original;
    changed.camera.theta = 47.1234567890123;
    changed.objects[0].material.exponent = 4;
    WindowState state;
    EXPECT_TRUE(describeScene(state, changed, &original).empty());
    EXPECT_EQ(state.set.size(), 2u);
    EXPECT_TRUE(state.sceneText.empty());
    const auto again = sceneOf(state, original);
    ASSERT_TRUE(again);
    EXPECT_TRUE(*again == changed);
}

TEST(WindowState, WhatSettingsCannotSayIsKeptAsText) {
    const pipeline::Scene original = test::pyramid();
    pipeline::Scene changed = original;
    changed.objects.push_back(changed.objects[0]);
    changed.objects[1].name = "another", changed.objects[1].transform.translation.x = 3;
    WindowState state;
    EXPECT_TRUE(describeScene(state, changed, &original).empty());
    EXPECT_FALSE(state.sceneText.empty());
    const auto written = readState(toToml(state), "s.toml");
    ASSERT_TRUE(written) << format(written.errors());
    const auto again = sceneOf(*written, original);
    ASSERT_TRUE(again) << format(again.errors());
    EXPECT_EQ(test::firstDifference(*test::frameOf(changed), *test::frameOf(*again)), "");
}

TEST(WindowState, AScenesNameLeadsBackToIt) {
    const test::TemporaryFolder folder;
    const auto pyramid = pipeline::resourceFolder() / "scenes" / "pyramid.scene";
    EXPECT_EQ(sceneName(pyramid, folder.path()), "pyramid");
    EXPECT_TRUE(std::filesystem::equivalent(sceneFile("pyramid", folder.path()), pyramid));
    std::filesystem::create_directory(folder / "in");
    test::writeText(folder / "in" / "own.toml", "[[object]]\nshape = \"sphere\"\n");
    EXPECT_EQ(sceneName(folder / "in" / "own.toml", folder.path()), "in/own.toml");
    EXPECT_EQ(sceneName(folder / "in" / "own.toml", folder / "else"), (folder / "in" / "own.toml").string());
    EXPECT_TRUE(readNamedScene("in/own.toml", folder.path()));
    const auto none = readNamedScene("pyramit", folder.path());
    ASSERT_FALSE(none);
    EXPECT_EQ(format(none.errors()), "no file and no built-in scene \"pyramit\"; the nearest is \"pyramid\"\n");
}

// "export pyramid -o pyramid" makes a folder of that name.
TEST(WindowState, AFolderHidesNoBuiltInScene) {
    const test::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "pyramid");
    const auto scene = readNamedScene("pyramid", folder.path());
    ASSERT_TRUE(scene) << format(scene.errors());
    EXPECT_EQ(scene->name, "pyramid.scene");
    test::writeText(folder / "other", "1, 2");
    EXPECT_EQ(sceneFile("other", folder.path()), folder / "other");
}

TEST(WindowState, FilesThatAreComparedAreNamedFromTheFolder) {
    WindowState state;
    state.views[0].compared.emplace().with = "file /talks/in/a b.npy";
    const WindowState absolute = state;
    nameFilesFrom(state, "/talks");
    EXPECT_EQ(state.views[0].compared->with, "file in/a b.npy");
    findFilesFrom(state, "/talks");
    EXPECT_TRUE(state == absolute);
    nameFilesFrom(state, "/elsewhere");
    EXPECT_TRUE(state == absolute) << "it is not within the folder";
}

TEST(CueList, IsTheSameAfterWritingAndReading) {
    CueList list{"Lecture 1", 50, {{"Why no highlight?", "R leaves 66.6°", "Ask first.\nThen \"turn\" it.", rich()}}};
    list.cues.push_back({"Next", {}, "one line, it's", rich()});
    list.cues[1].state.set.clear();
    list.cues[0].ask = CueQuestion{"Which \"one\"?", {"A, B", "it's", "\\"}, 2};
    const std::string text = toToml(list);
    const auto again = readCues(text, "a.cues");
    ASSERT_TRUE(again) << format(again.errors()) << text;
    EXPECT_TRUE(*again == list) << text;
    EXPECT_NE(text.find("note = '''\nAsk first.\nThen \"turn\" it.'''"), std::string::npos) << "reads as a text";
}

TEST(CueList, WhatIsWrongIsToldWithItsPlace) {
    const auto wrong = [](std::string_view text) {
        const auto list = readCues(text, "a.cues");
        return list ? "" : format(list.errors());
    };
    EXPECT_EQ(wrong("[[cue]]\nname = \"a\"\n"),
              "a.cues:1:1: cue.0 has no scene, expected a file, or the name of a built-in scene\n");
    EXPECT_TRUE(wrong("[[cue]]\nscene = \"pyramid\"\n").starts_with("a.cues:1:1: cue.0 has no name"));
    EXPECT_TRUE(wrong("[[cue]]\nname = \"a\"\nscene = \"p\"\n[[cue]]\nname = \"a\"\nscene = \"p\"\n")
                    .starts_with("a.cues:4:1: cue.1: another cue is called \"a\""));
    EXPECT_TRUE(wrong("minutes = 0\n").starts_with("a.cues:1:11: minutes is 0, expected a whole number from 1 to 600"));
    // The window counts whole minutes: half of one would be gone from the talk, and from the file once it is written.
    EXPECT_EQ(wrong("\nminutes = 22.5\n"), "a.cues:2:11: minutes is 22.5, expected a whole number from 1 to 600\n");
    EXPECT_EQ(wrong("minutes = 45.0\n"), "");
    const auto asks = [&](std::string_view question) {
        return wrong("[[cue]]\nname = \"a\"\nscene = \"p\"\n" + std::string(question));
    };
    EXPECT_EQ(asks("ask = \"Q\"\nchoices = [\"1\", \"2\"]\nright = \"B\"\n"), "");
    EXPECT_EQ(asks("ask = \"Q\"\n"),
              "a.cues:1:1: cue.0 has a question without all of its parts, expected ask, choices and right\n");
    EXPECT_TRUE(asks("ask = \"Q\"\nright = \"A\"\nchoices = [\"1\"]\n").starts_with("a.cues:6:11: cue.0.choices is "));
    EXPECT_EQ(asks("ask = \"Q\"\nchoices = [\"1\", \"2\"]\nright = \"C\"\n"),
              "a.cues:6:9: cue.0.right is \"C\", expected a letter from A to B\n");
    EXPECT_TRUE(
        wrong("[[cue]]\nname = \"a\"\nscene = \"p\"\n[[cue.view]]\nbufer = \"color\"\n").starts_with("a.cues:5:1:"));
}

TEST(CueList, TheCueAfterAQuestionIsItsAnswer) {
    CueList list{{}, 45, {{"One"}, {"Question"}, {"Answer"}, {"Last"}}};
    list.cues[1].ask.emplace();
    EXPECT_EQ(asking(list, 0), std::nullopt);
    EXPECT_EQ(asking(list, 1), 1u);
    EXPECT_EQ(asking(list, 2), 1u);
    EXPECT_EQ(asking(list, 3), std::nullopt);
    EXPECT_EQ(asking(list, 9), std::nullopt);
}

TEST(CueList, ACueIsFoundByNameAndByNumber) {
    const CueList list{{}, 45, {{"One"}, {"3"}, {"Last"}}};
    EXPECT_EQ(*findCue(list, "Last"), 2u);
    EXPECT_EQ(*findCue(list, "1"), 0u);
    EXPECT_EQ(*findCue(list, "3"), 1u);  // a name goes before a number
    const auto none = findCue(list, "Lst");
    ASSERT_FALSE(none);
    EXPECT_EQ(format(none.errors()),
              "no cue \"Lst\", expected a number from 1 to 3, or a name; the nearest is \"Last\"\n");
    EXPECT_FALSE(findCue(list, "4"));
    EXPECT_EQ(freeName(list, "One"), "One 2");
    EXPECT_EQ(freeName(list, "Two"), "Two");
}

TEST(CueList, AFileAndACueInOneWord) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "a.cues", "");
    const auto name = parseCueName((folder / "a.cues").string() + ":Back: why");
    ASSERT_TRUE(name);
    EXPECT_EQ(name->file, folder / "a.cues");
    EXPECT_EQ(name->name, "Back: why");
    test::writeText(folder / "a: b.cues", "");
    EXPECT_EQ(parseCueName((folder / "a: b.cues").string() + ":1")->file, folder / "a: b.cues");
    EXPECT_EQ(parseCueName((folder / "b.cues").string() + ":1: why")->file, folder / "b.cues");
    EXPECT_FALSE(parseCueName((folder / "a.cues").string()));
}

// A talk that comes with the program needs no path, so that an installed program opens it too.
TEST(CueList, TheProgramsOwnListsAreFoundByName) {
    const auto own = pipeline::resourceFolder() / "manual" / "lecture1.cues";
    EXPECT_EQ(cueFileAt("lecture1"), own);
    EXPECT_EQ(cueFileAt("lecture1.cues"), own);
    EXPECT_EQ(parseCueName("lecture1:3")->file, own);
    // Neither in another folder nor by a path that leads out of the manual's.
    EXPECT_EQ(cueFileAt("./lecture1"), "./lecture1");
    EXPECT_EQ(cueFileAt("../manual/lecture1"), "../manual/lecture1");
    EXPECT_EQ(cueFileAt("no_such_talk"), "no_such_talk");
    // A file of the reader's own wins.
    const test::TemporaryFolder folder;
    test::writeText(folder / "lecture1", "");
    EXPECT_EQ(cueFileAt(folder / "lecture1"), folder / "lecture1");
}

// A model that was opened by itself: its size changes the camera along, its up axis every object and the camera. What is
// kept of it are settings, in an order that makes the same scene again, also where the camera was set by hand.
TEST(WindowState, AFramedModelIsKeptAsSettings) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "m.obj", "o a\nv 1 2 0\nv 2 2 1\nv 2 4 0\nf 1 2 3\no b\nv 1 4 2\nf 1 3 4\n");
    const auto original = pipeline::readScene(folder / "m.obj");
    ASSERT_TRUE(original);
    for (const std::vector<std::string>& set : {std::vector<std::string>{"up=y"},
                                                {"width=100", "height=50"},
                                                {"up=y", "width=100", "camera.distance=30", "object.1.tx=7"}}) {
        pipeline::Scene changed = *original;
        for (const std::string& one : set) changed = withSetting(std::move(changed), one).value();
        WindowState state;
        EXPECT_TRUE(describeScene(state, changed, &*original).empty());
        EXPECT_TRUE(state.sceneText.empty());
        const auto again = sceneOf(state, *original);
        ASSERT_TRUE(again) << format(again.errors());
        EXPECT_EQ(*again, changed) << set[0];
    }
}

}  // namespace
}  // namespace lessons
