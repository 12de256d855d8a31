// What a hand can move: from a place to values and back to the place, limits, keys.
#include <cmath>

#include <gtest/gtest.h>

#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/scene/hold/code_figure.h"
#include "pipeline/scene/hold/hold.h"
#include "pipeline/scene/view.h"

namespace pipeline {
namespace {

using Kind = Hold::Kind;

Scene builtIn(std::string_view name) { return readScene(builtInScene(name)->file).value(); }
Scene sceneOfBall() {
    Scene scene = builtIn("ambient");
    scene.camera.eye = {1, -6, 3};
    return scene;
}
Scene after(const Scene& scene, const Assignments& values) { return withSettings(scene, toText(values)).value(); }

const Hold kLamp{Kind::LampAtInfinity, 0, {"light.0.x", "light.0.y", "light.0.z"}, {}, {0, 0, 1}, 0, 0, "Lamp", ""};
const Hold kFoot{Kind::LampFoot, 0, {"light.0.x", "light.0.y"}, {}, {0, 0, 1}, 0, 0, "Lamp", ""};
const Hold kTop{Kind::LampTop, 0, {"light.0.z"}, {}, {0, 0, 1}, 0, 0, "Lamp, height", ""};
const Hold kAlong{Kind::Along, 0, {"object.0.tx", "object.0.ty", "object.0.tz"}, {}, {1, 0, 0}, -2, 2, "Ball", ""};
const Hold kTurn{Kind::Turn, 0, {"object.0.rz"}, {}, {0, 0, 1}, 0, 0, "Ball", ""};
const Hold kEye{Kind::Eye, 0, {"camera.eye_x", "camera.eye_y", "camera.eye_z"}, {}, {0, 0, 1}, 0, 0, "Eye", ""};
const Hold kNear{Kind::Number, 0, {"camera.near"}, {}, {0, 0, 1}, 0.05, 15, "Near plane", "n"};
const Hold kPieces{Kind::Number, 0, {"object.0.tessellation"}, {}, {0, 0, 1}, 2, 12, "Pieces", ""};

// A drag from the grip's own place to any place in the picture leads there: within 0.5 px, and what the power of ten that
// the values are rounded to is worth in the picture.
TEST(Hold, WhatIsUnderThePointerStaysUnderIt) {
    Scene scene = sceneOfBall();
    for (const Hold& hold : {kLamp, kFoot}) {
        if (hold.kind == Kind::LampFoot) scene.lights[0].kind = LightKind::Point, scene.lights[0].position = {1, 0, 2};
        const auto from = placeOf(scene, hold);
        ASSERT_TRUE(from);
        for (double x = 160; x <= 480; x += 40)
            for (double y = 160; y <= 320; y += 40) {
                const Scene moved = after(scene, valuesAt(scene, hold, from->at, {x, y}));
                const auto to = placeOf(moved, hold);
                ASSERT_TRUE(to) << x << ", " << y;
                EXPECT_NEAR(to->at.x, x, 0.8) << x << ", " << y;
                EXPECT_NEAR(to->at.y, y, 0.8) << x << ", " << y;
            }
    }
}

// One unknown, no closed form: the place is the nearest one on a line of the picture.
TEST(Hold, AnObjectGoesAlongItsAxisToTheNearestPlace) {
    Scene scene = sceneOfBall();
    const auto from = placeOf(scene, kAlong);
    ASSERT_TRUE(from);
    double before = -INFINITY;
    for (double x = from->at.x - 120; x <= from->at.x + 120; x += 30) {
        const Scene moved = after(scene, valuesAt(scene, kAlong, from->at, {x, from->at.y}));
        const Vec3d at = moved.objects[0].transform.translation;
        EXPECT_EQ(at.y, 0);
        EXPECT_EQ(at.z, 0);
        EXPECT_GT(at.x, before) << "farther to the right";
        before = at.x;
        // A step of 0.1 is 0.05 off at most; a world unit at 6.8 from the eye is 480 / 2 / tan(17.5°) / 6.8 = 112 px.
        EXPECT_NEAR(placeOf(moved, kAlong)->at.x, x, 0.05 * 130 + 12) << "along a line that is not quite level";
    }
    EXPECT_EQ(valuesAt(scene, kAlong, from->at, from->at + glm::dvec2(4000, 0))[0].second, 2) << "its limit";
}

// Along the line of sight nothing moves in the picture: up is farther away, the whole height the whole range.
TEST(Hold, AlongTheLineOfSightUpIsFarther) {
    Scene scene = sceneOfBall();
    Hold hold = kAlong;
    hold.axis = makeView(scene).forward;
    const Scene moved = after(scene, valuesAt(scene, hold, {320, 240}, {320, 120}));
    EXPECT_NEAR(glm::dot(moved.objects[0].transform.translation, hold.axis), 1, 0.06);
}

TEST(Hold, ALampIsBehindBeyondTheRim) {
    Scene scene = sceneOfBall();
    const View view = makeView(scene);
    scene.lights[0].position = -view.forward;
    const auto middle = placeOf(scene, kLamp);
    EXPECT_NEAR(glm::length(middle->at - *projected(view, Vec3d(0))), 0, 1e-3) << "towards the eye: in the middle";
    EXPECT_FALSE(middle->isBehind);
    scene.lights[0].position = view.right;
    const double rim = glm::length(placeOf(scene, kLamp)->at - middle->at);
    scene.lights[0].position = view.right + view.forward;  // 135°
    EXPECT_TRUE(placeOf(scene, kLamp)->isBehind);
    EXPECT_NEAR(glm::length(placeOf(scene, kLamp)->at - middle->at), 1.5 * rim, 1e-6);
}

TEST(Hold, ALampKeepsItsLength) {
    Scene scene = sceneOfBall();
    scene.lights[0].position = {30, 40, 120};  // 130 long
    const auto from = placeOf(scene, kLamp);
    const Scene moved = after(scene, valuesAt(scene, kLamp, from->at, {200, 300}));
    EXPECT_NEAR(glm::length(moved.lights[0].position), 130, 0.2);
}

// The front of a ball moves to the right with a positive turn about z.
TEST(Hold, ABallTurnsWithItsSurface) {
    const Scene scene = sceneOfBall();
    EXPECT_GT(valuesAt(scene, kTurn, {320, 240}, {380, 240})[0].second, 10);
    EXPECT_LT(valuesAt(scene, kTurn, {320, 240}, {260, 240})[0].second, -10);
    Scene almost = scene;
    almost.objects[0].transform.rotation.z = 179;
    EXPECT_EQ(nudged(almost, kTurn, {1, 0}, true)[0].second, -171) << "180 is -180";
}

TEST(Hold, AnEyeKeepsItsDistance) {
    const Scene scene = sceneOfBall();
    for (const Assignments& values : {valuesAt(scene, kEye, {320, 240}, {420, 300}), nudged(scene, kEye, {0, -1}, true),
                                      nudged(scene, kEye, {1, 0}, false)}) {
        const Scene moved = after(scene, values);
        EXPECT_NEAR(glm::length(moved.camera.eye), glm::length(scene.camera.eye), 0.01);
        EXPECT_NE(moved.camera.eye, scene.camera.eye);
    }
}

// 0.05 to 15 is a factor of 300: equal ways are equal factors, and the middle is sqrt(0.05 · 15) = 0.866.
TEST(Hold, ALargeRangeHasATrackOfFactors) {
    Scene scene = builtIn("z_fighting");
    EXPECT_TRUE(isLogarithmic(kNear));
    scene.camera.near = 0.05;
    EXPECT_EQ(placeOf(scene, kNear)->at.x, 0);
    EXPECT_EQ(valuesAt(scene, kNear, {0, 0}, {0.5, 0.5})[0].second, 0.87) << "two digits";
    EXPECT_EQ(valuesAt(scene, kNear, {0, 0}, {7, 7})[0].second, 15);
    EXPECT_EQ(nudged(scene, kNear, {-1, 0}, true)[0].second, 0.05) << "its lower limit";
    EXPECT_EQ(nudged(scene, kNear, {1, 0}, true)[0].second, 0.1) << "twice";
    EXPECT_EQ(wordsOf(scene, kNear), "n = 0.05");
}

TEST(Hold, ANumberOfPiecesIsWhole) {
    const Scene scene = builtIn("flat_gouraud_phong");  // 2 pieces
    EXPECT_EQ(valuesAt(scene, kPieces, {0, 0}, {0.33, 0.33})[0].second, 5) << "2 + 3.3";
    EXPECT_EQ(nudged(scene, kPieces, {0, -1}, false)[0].second, 3) << "up is more";
    EXPECT_EQ(wordsOf(scene, kPieces), "2 pieces");
}

TEST(Hold, EveryArrowKeyMoves) {
    Scene scene = sceneOfBall();
    for (const Hold& hold : {kLamp, kAlong, kTurn, kEye})
        for (const glm::ivec2 by : {glm::ivec2(1, 0), {-1, 0}, {0, 1}, {0, -1}})
            for (const bool coarse : {false, true})
                EXPECT_NE(nudged(scene, hold, by, coarse), valuesOf(scene, hold)) << hold.name << by.x << by.y;
    scene.lights[0].kind = LightKind::Point, scene.lights[0].position = {1, 0, 2};
    EXPECT_EQ(nudged(scene, kTop, {0, -1}, false)[0].second > 2, true) << "up is up";
}

TEST(Hold, NoPlaceGivesAValueThatIsNone) {
    const Scene scene = sceneOfBall();
    for (const Hold& hold : {kLamp, kAlong, kTurn, kEye, kPieces})
        for (const double odd : {double(NAN), double(INFINITY), -double(INFINITY), 1e300})
            for (const auto& [key, value] : valuesAt(scene, hold, {0, 0}, {odd, odd}))
                EXPECT_TRUE(std::isfinite(value)) << hold.name << ' ' << odd;
}

// n = 0.05, f = 2000: half of all codes lie between n and 2 n, so the 32nd mark of 64 is at 2 n f / (n + f) = 0.1.
TEST(CodeFigure, HalfOfAllCodesEndsAtTwiceTheNearPlane) {
    Scene scene = builtIn("z_fighting");
    scene.camera.near = 0.05;
    const CodeFigure figure = codeFigure(scene);
    ASSERT_EQ(figure.marks.size(), 65u);
    EXPECT_NEAR(figure.marks[0], 0.05, 1e-12);
    EXPECT_NEAR(figure.marks[32], 0.1, 1e-5);
    EXPECT_NEAR(figure.marks[64], 2000, 1e-6);
    // 65535 · (f / (f - n)) n (1 / z0 - 1 / z1) codes, and one more.
    const double codes = 65535 * 0.05 * (1 / figure.nearest - 1 / figure.farthest);
    EXPECT_NEAR(figure.codes, codes + 1, 1);
}

}  // namespace
}  // namespace pipeline
