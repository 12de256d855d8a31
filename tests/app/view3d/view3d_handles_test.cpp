#include <gtest/gtest.h>

#include <cmath>

#include "app/drawing3d/space_content.h"
#include "app/drawing3d/world_drawing.h"
#include "app/view3d/handle_drag.h"
#include "pipeline/scene/view.h"
#include "tests/app/view3d/view3d_fixture.h"
#include "tests/support/scenes.h"

using namespace view3d;
using app::DragStep;
using app::Handle;
using app::HandleTool;
using app::SpaceMap;
using Kind = app::Handle::Kind;

namespace {

app::HandleView lookAt(const ViewContent& content, bool orthographic,
                       app::ViewPreset preset = app::ViewPreset::Everything) {
    return app::handleView({app::presetCamera(preset, content, {}, kView, orthographic), kView}, content.map);
}

std::vector<Handle> handlesIn(const pipeline::Scene& scene, const ViewContent& shown, std::optional<std::size_t> object,
                              HandleTool tool = HandleTool::Move) {
    return app::handlesOf(scene, shown, object, tool);
}

Vec3d dragged(const Handle& handle, std::optional<std::size_t> arm, const app::HandleView& view, glm::dvec2 moved,
              DragStep step = DragStep::Usual) {
    return app::draggedTo(handle, arm, view, app::placeOf(view, handle.at).at, moved, step);
}

const Handle& handleOf(const std::vector<Handle>& handles, Kind kind) {
    const auto found = std::ranges::find(handles, kind, &Handle::kind);
    EXPECT_NE(found, handles.end());
    return *found;
}

pipeline::Scene withPointLight() {
    pipeline::Scene scene = test::pyramid();
    scene.lights[0].kind = pipeline::LightKind::Point;
    scene.lights[0].position = {300, -200, 400};
    return scene;
}

}  // namespace

TEST(View3dHandles, StandOnWhatTheyMove) {
    const pipeline::Scene scene = withPointLight();
    const ViewContent world = contentOf(scene);
    const auto handles = handlesIn(scene, world, 0);
    expectNear(handleOf(handles, Kind::Light).at, {300, -200, 400}, 0);
    expectNear(handleOf(handles, Kind::Eye).at, pipeline::makeView(scene).eye, 0);
    expectNear(handleOf(handles, Kind::Object).at, {335, 75, 75}, 1e-4);  // of 200..470, 0..150, 0..150
    EXPECT_EQ(handlesIn(scene, world, {}).size(), 2u) << "no object is meant";
    EXPECT_EQ(handlesIn(test::pyramid(), contentOf(test::pyramid()), {})[0].kind, Kind::LightDirection);
}

// A light of eye space moves with the camera; the view shows where it is, but it has no place to be dragged to.
TEST(View3dHandles, ALightOfTheEyeHasNone) {
    pipeline::Scene scene = test::openGlCube();
    ASSERT_FALSE(scene.lights.empty());
    scene.lights[0].kind = pipeline::LightKind::Point;
    scene.lights[0].position = {0, 0, 0};
    scene.lights[0].gl.space = pipeline::LightSpace::Eye;
    const ViewContent world = contentOf(scene);
    expectNear(world.lights[0].position, world.eye.eye, 1e-12);
    for (const Handle& handle : handlesIn(scene, world, {})) EXPECT_NE(handle.kind, Kind::Light);
}

TEST(View3dHandles, FollowTheCursor) {
    const pipeline::Scene scene = withPointLight();
    const ViewContent world = contentOf(scene);
    for (const bool orthographic : {false, true})
        for (const Handle& handle : handlesIn(scene, world, 0)) {
            const app::HandleView view = lookAt(world, orthographic);
            const glm::dvec2 begin = app::placeOf(view, handle.at).at, moved{37, -21};
            EXPECT_EQ(dragged(handle, {}, view, {0, 0}), handle.at);
            const Vec3d to = dragged(handle, {}, view, moved);
            const glm::dvec2 end = app::placeOf(view, to).at;
            EXPECT_LT(glm::length(end - begin - moved), 1.01) << handle.name << ": rounded to less than a pixel";
        }
}

TEST(View3dHandles, AnAxisMovesOneNumberAlone) {
    const pipeline::Scene scene = withPointLight();
    const ViewContent world = contentOf(scene);
    const app::HandleView view = lookAt(world, false);
    const Handle handle = handleOf(handlesIn(scene, world, 0), Kind::Object);
    for (int axis = 0; axis < 3; ++axis) {
        // 30 pixels along the axis as it lies on the screen.
        const glm::dvec2 tip = app::armTips(handle, view)[std::size_t(axis)];
        const glm::dvec2 along = tip - app::placeOf(view, handle.at).at;
        const Vec3d to = dragged(handle, std::size_t(axis), view, 30.0 / glm::length(along) * along);
        for (int i = 0; i < 3; ++i) {
            if (i == axis)
                EXPECT_GT(to[i], handle.at[i] + 1);
            else
                EXPECT_EQ(to[i], handle.at[i]);
        }
    }
    // Seen from straight above z has no direction on the screen: nothing moves, and nothing is infinite.
    const app::HandleView top = lookAt(world, true, app::ViewPreset::Top);
    EXPECT_EQ(dragged(handle, 2, top, {10, 10}), handle.at);
}

TEST(View3dHandles, ADirectionTurnsAndKeepsItsLength) {
    const pipeline::Scene scene = test::pyramid();  // towards (500, 500, 500)
    const ViewContent world = contentOf(scene);
    const app::HandleView view = lookAt(world, false);
    const Handle handle = handleOf(handlesIn(scene, world, {}), Kind::LightDirection);
    for (const glm::dvec2 moved : {glm::dvec2(15, 8), glm::dvec2(-400, 300)}) {
        const Vec3d to = dragged(handle, {}, view, moved);
        EXPECT_NEAR(glm::length(to - handle.centre), glm::length(handle.at - handle.centre), 1e-6);
        const Vec3d direction = app::withHandleAt(scene, handle, to).lights[0].position;
        EXPECT_NEAR(glm::length(direction), glm::length(scene.lights[0].position), 1e-3 * glm::length(direction));
        EXPECT_NEAR(glm::dot(glm::normalize(direction), glm::normalize(to - handle.centre)), 1, 1e-4);
    }
    EXPECT_EQ(app::withHandleAt(scene, handle, handle.at), scene) << "not moved, not rounded";
}

// Lecture 1's camera stands at (ρ sin φ cos θ, ρ sin φ sin θ, ρ cos φ).
TEST(View3dHandles, ASphericalCameraTakesItsAngles) {
    const pipeline::Scene scene = test::pyramid();
    const Handle eye = handleOf(handlesIn(scene, contentOf(scene), {}), Kind::Eye);
    const Vec3d to{500, 500, 707.1068};  // ρ = 1000, θ = 45°, φ = 45°
    const pipeline::Scene moved = app::withHandleAt(scene, eye, to);
    EXPECT_NEAR(moved.camera.rho, 1000, 1);
    EXPECT_NEAR(moved.camera.theta, 45, 0.05);
    EXPECT_NEAR(moved.camera.phi, 45, 0.05);
    EXPECT_NEAR(glm::length(pipeline::makeView(moved).eye - to), 0, 5);
    pipeline::Scene turned = scene;
    turned.camera.theta = 405;  // a full turn further
    EXPECT_NEAR(app::withHandleAt(turned, eye, to).camera.theta, 405, 0.05) << "it does not jump back";
    pipeline::Scene look = test::openGlCube();
    const Handle place = handleOf(handlesIn(look, contentOf(look), {}), Kind::Eye);
    EXPECT_EQ(app::withHandleAt(look, place, {1, 2, 3}).camera.eye, Vec3d(1, 2, 3));
}

TEST(View3dHandles, AnObjectIsMovedByWhatItsHandleMoves) {
    const pipeline::Scene scene = test::pyramid();
    const Handle object = handleOf(handlesIn(scene, contentOf(scene), 0), Kind::Object);
    const pipeline::Scene moved = app::withHandleAt(scene, object, object.at + Vec3d(10, 0, -5));
    expectNear(moved.objects[0].transform.translation - scene.objects[0].transform.translation, {10, 0, -5}, 1e-9);
}

TEST(View3dHandles, ThePressTakesTheNearestWithinReach) {
    const pipeline::Scene scene = withPointLight();
    const ViewContent world = contentOf(scene);
    const app::HandleView view = lookAt(world, false);
    const auto handles = handlesIn(scene, world, 0);
    for (std::size_t i = 0; i < handles.size(); ++i) {
        const glm::dvec2 at = app::placeOf(view, handles[i].at).at;
        EXPECT_EQ(app::gripAt(handles, {}, view, at + glm::dvec2(4, -4)), (app::Grip{i, {}}));
        const glm::dvec2 tip = app::armTips(handles[i], view)[2];
        EXPECT_EQ(app::gripAt(handles, i, view, tip), (app::Grip{i, 2})) << "its arms are on show";
    }
    EXPECT_FALSE(app::gripAt(handles, {}, view, {-500, -500}));
}

TEST(View3dHandles, TheNumbersAreTheSettings) {
    const pipeline::Scene scene = withPointLight();
    const auto handles = handlesIn(scene, contentOf(scene), 0);
    EXPECT_EQ(app::numbersOf(scene, handleOf(handles, Kind::Light)), "x 300  y −200  z 400");
    EXPECT_EQ(app::numbersOf(scene, handleOf(handles, Kind::Eye)), "ρ 1 000  θ 45.0°  φ 60.0°");
}

// Turned about x by 90° and then about z by 90° the object's own x stands along the world's y, so that what is
// written first turns about y; what is written last about z itself.
TEST(View3dHandles, AnArmOfATurnIsWhatItsNumberTurnsAbout) {
    pipeline::Scene scene = test::pyramid();
    scene.objects[0].transform.rotation = {90, 0, 90};
    const Handle handle = handleOf(handlesIn(scene, contentOf(scene), 0, HandleTool::Turn), Kind::Object);
    ASSERT_EQ(handle.arms.size(), 3u);
    expectNear(handle.arms[0].axis, {0, 1, 0}, 1e-12);
    expectNear(handle.arms[1].axis, {-1, 0, 0}, 1e-12);
    expectNear(handle.arms[2].axis, {0, 0, 1}, 1e-12);
    expectNear(handle.at, scene.objects[0].transform.translation, 0);
    EXPECT_EQ(app::numbersOf(scene, handle), "rotation x 90.0°  y 0.0°  z 90.0°");
}

// Seen from above, a quarter of the ring around z, counter-clockwise, is 90°; y goes downwards on the screen.
TEST(View3dHandles, ATurnFollowsTheCursorAroundItsArm) {
    const pipeline::Scene scene = test::pyramid();
    const ViewContent world = contentOf(scene);
    const Handle handle = handleOf(handlesIn(scene, world, 0, HandleTool::Turn), Kind::Object);
    const app::HandleView top = lookAt(world, true, app::ViewPreset::Top);
    const glm::dvec2 middle = app::placeOf(top, handle.at).at, from = middle + glm::dvec2(46, 0);
    const auto turnedTo = [&](glm::dvec2 to, DragStep step) {
        return app::draggedTo(handle, 2, top, from, to - from, step);
    };
    EXPECT_EQ(turnedTo(middle + glm::dvec2(0, -46), DragStep::Usual), Vec3d(0, 0, 90));
    EXPECT_EQ(turnedTo(middle + glm::dvec2(0, -80), DragStep::Usual), Vec3d(0, 0, 90)) << "however far out";
    EXPECT_EQ(turnedTo(middle + glm::dvec2(0, -46), DragStep::Fine), Vec3d(0, 0, 9));
    // 46 to the right and 33 up: 35.7°, nearest to 30 of the multiples of 15.
    EXPECT_EQ(turnedTo(middle + glm::dvec2(46, -33), DragStep::Coarse), Vec3d(0, 0, 30));
    EXPECT_EQ(turnedTo(middle + glm::dvec2(46, -33), DragStep::Usual), Vec3d(0, 0, 36));
    // The ring around x is seen from its edge: along it is still a turn, and a finite one.
    const Vec3d aboutX = app::draggedTo(handle, 0, top, middle, {0, -20});
    EXPECT_NE(aboutX.x, 0);
    EXPECT_LT(std::abs(aboutX.x), 60);
    EXPECT_EQ(app::draggedTo(handle, {}, top, middle, {30, 30}), handle.value) << "nothing to turn about";
    const pipeline::Scene turned = app::withHandleAt(scene, handle, {0, 0, 90});
    EXPECT_EQ(turned.objects[0].transform.rotation, Vec3d(0, 0, 90));
    EXPECT_EQ(turned.objects[0].transform.translation, scene.objects[0].transform.translation);
}

// glRotate's turns take the place of the rotation: each has an arm, the first of them the outermost.
TEST(View3dHandles, TurnsHaveAnArmEach) {
    pipeline::Scene scene = test::pyramid();
    scene.objects[0].transform.turns = {{90, {0, 0, 1}}, {30, {2, 0, 0}}};
    const Handle handle = handleOf(handlesIn(scene, contentOf(scene), 0, HandleTool::Turn), Kind::Object);
    ASSERT_EQ(handle.arms.size(), 2u);
    expectNear(handle.arms[0].axis, {0, 0, 1}, 1e-12);
    expectNear(handle.arms[1].axis, {0, 1, 0}, 1e-12);
    const pipeline::Scene turned = app::withHandleAt(scene, handle, {90, 45, 0});
    EXPECT_EQ(turned.objects[0].transform.turns[0].angle, 90);
    EXPECT_EQ(turned.objects[0].transform.turns[1].angle, 45);
    EXPECT_EQ(app::numbersOf(turned, handle), "turns 0 90.0°  1 45.0°");
}

// An arm as long again doubles its own number; the ring takes all three, to the right and up.
TEST(View3dHandles, AScaleGrowsWithItsArm) {
    pipeline::Scene scene = test::pyramid();
    scene.objects[0].transform.scale = {1, 2, -1};
    const ViewContent world = contentOf(scene);
    const app::HandleView view = lookAt(world, true);
    const Handle handle = handleOf(handlesIn(scene, world, 0, HandleTool::Scale), Kind::Object);
    const glm::dvec2 along = app::armTips(handle, view)[1] - app::placeOf(view, handle.at).at;
    EXPECT_EQ(dragged(handle, 1, view, along), Vec3d(1, 4, -1));
    EXPECT_EQ(dragged(handle, {}, view, {23, -23}), Vec3d(2, 4, -2));
    const Vec3d least = dragged(handle, {}, view, {-500, 500});
    EXPECT_GT(least.x, 0) << "never through 0";
    EXPECT_LT(least.z, 0) << "a mirror stays one";
    // 1.3 of 2 is 2.6, a multiple of 0.1 already; 1.33 of it goes to 2.7.
    EXPECT_NEAR(dragged(handle, 1, view, 0.33 * along, DragStep::Coarse).y, 2.7, 1e-12);
    EXPECT_EQ(app::withHandleAt(scene, handle, {1, 4, -1}).objects[0].transform.scale, Vec3d(1, 4, -1));
}

TEST(View3dHandles, ShiftIsFineAndControlIsCoarse) {
    const pipeline::Scene scene = withPointLight();
    const ViewContent world = contentOf(scene);
    const app::HandleView view = lookAt(world, true, app::ViewPreset::Front);
    const Handle handle = handleOf(handlesIn(scene, world, 0), Kind::Light);
    const Vec3d usual = dragged(handle, 0, view, {100, 0}), fine = dragged(handle, 0, view, {100, 0}, DragStep::Fine),
                coarse = dragged(handle, 0, view, {100, 0}, DragStep::Coarse);
    const double unit = view.view.camera.unitsPerPixel(kView.y);  // from 0.1 to 1: steps of 0.1, 0.01 and 1
    ASSERT_GT(unit, 0.1);
    ASSERT_LT(unit, 1);
    EXPECT_NEAR(usual.x - handle.at.x, 100 * unit, 0.05 + 1e-9);
    EXPECT_NEAR(fine.x - handle.at.x, 10 * unit, 0.005 + 1e-9);
    EXPECT_EQ(coarse.x, std::round(coarse.x));
    EXPECT_NEAR(coarse.x - handle.at.x, 100 * unit, 0.5);
}

// A spot shines from its place along its direction, and turns about its place.
TEST(View3dHandles, ASpotAndAnAreaHaveADirection) {
    pipeline::Scene scene = test::openGlCube();
    scene.lights[0].kind = pipeline::LightKind::Point;
    scene.lights[0].position = {2, 1, 5};
    scene.lights[0].gl.space = pipeline::LightSpace::World;
    EXPECT_EQ(handlesIn(scene, contentOf(scene), {})[1].kind, Kind::Eye) << "no spot: it shines all around";
    scene.lights[0].gl.spotCutoff = 30;
    scene.lights[0].gl.spotDirection = {0, 0, -2};
    const Handle spot = handleOf(handlesIn(scene, contentOf(scene), {}), Kind::LightFacing);
    expectNear(spot.centre, {2, 1, 5}, 0);
    expectNear(glm::normalize(spot.at - spot.centre), {0, 0, -1}, 1e-12);
    const pipeline::Scene turned = app::withHandleAt(scene, spot, spot.centre + Vec3d(3, 0, 0));
    expectNear(turned.lights[0].gl.spotDirection, {2, 0, 0}, 1e-12);
    EXPECT_EQ(turned.lights[0].position, scene.lights[0].position);
    scene.lights[0].kind = pipeline::LightKind::Area;
    const Handle area = handleOf(handlesIn(scene, contentOf(scene), {}), Kind::LightFacing);
    expectNear(app::withHandleAt(scene, area, area.centre + Vec3d(0, 4, 0)).lights[0].area.facing, {0, 1, 0}, 1e-12);
}

// Eye space is the world seen from elsewhere: the same ring, on the same point of the picture.
TEST(View3dHandles, StandWhereTheirSpaceShowsThem) {
    const pipeline::Scene scene = withPointLight();
    const ViewContent world = contentOf(scene);
    const SpaceMap map = *app::mapOf(world, {app::ViewSpace::Eye});
    const ViewContent eye = app::inSpace(world, map);
    const app::ViewFrame frame{app::presetCamera(app::ViewPreset::Iso, eye, {}, kView, false), kView};
    const app::HandleView view = app::handleView(frame, map);
    const auto handles = handlesIn(scene, eye, 0);
    ASSERT_EQ(handles.size(), 2u) << "the light and the object; the camera is what the space is built on";
    for (const Handle& handle : handles) {
        const glm::dvec2 drawn = app::project(frame.camera, kView, map.toSpace(handle.at)).at;
        EXPECT_LT(glm::length(app::placeOf(view, handle.at).at - drawn), 1e-6) << handle.name;
        const glm::dvec2 moved{25, 14};
        const Vec3d to = dragged(handle, {}, view, moved);
        EXPECT_LT(glm::length(app::project(frame.camera, kView, map.toSpace(to)).at - drawn - moved), 1.01);
    }
    // The disc of a light at infinity stands elsewhere there, and its ring on it.
    const ViewContent far = contentOf(test::pyramid()), farEye = app::inSpace(far, map);
    const Handle disc = handleOf(handlesIn(test::pyramid(), farEye, {}), Kind::LightDirection);
    expectNear(map.toSpace(disc.at), app::lightDisc(farEye.lights[0], farEye), 1e-6);
}

// In screen space, seen from the front, a pixel of the view is some pixels of the picture, and the depth stays.
TEST(View3dHandles, ClipAndScreenSpaceMoveThroughTheDivision) {
    const pipeline::Scene scene = test::pyramid();
    const ViewContent world = contentOf(scene);
    for (const app::ViewSpace space : {app::ViewSpace::Clip, app::ViewSpace::Screen}) {
        const SpaceMap map = *app::mapOf(world, {space});
        const ViewContent flat = app::inSpace(world, map);
        const auto handles = handlesIn(scene, flat, 0, HandleTool::Turn);
        ASSERT_EQ(handles.size(), 1u) << "the object alone";
        const Handle& handle = handles[0];
        EXPECT_EQ(handle.tool, HandleTool::Move) << "there are no angles";
        EXPECT_TRUE(handle.arms.empty());
        const app::HandleView front = lookAt(flat, true, app::ViewPreset::Front);
        const glm::dvec2 begin = app::placeOf(front, handle.at).at, moved{40, -25};
        const Vec3d to = dragged(handle, {}, front, moved);
        EXPECT_LT(glm::length(app::placeOf(front, to).at - begin - moved), 1.01);
        EXPECT_NEAR(app::depthOf(map.view, to), app::depthOf(map.view, handle.at), 2);
        // From the side the cursor can leave the range of depths: nothing comes of that, least of all an infinity.
        const app::HandleView side = lookAt(flat, true, app::ViewPreset::Side);
        for (const double x : {-4000.0, 4000.0}) EXPECT_TRUE(app::finite(dragged(handle, {}, side, {x, 0})));
    }
}
