#include <gtest/gtest.h>

#include <cmath>

#include "app/view3d/handles.h"
#include "app/view3d/world_drawing.h"
#include "pipeline/stages/view.h"
#include "tests/app/view3d_fixture.h"
#include "tests/support/scenes.h"

using namespace view3d;
using app::DragAxis;
using app::Handle;
using Kind = app::Handle::Kind;

namespace {

const glm::dvec2 kView{640, 480};

app::ViewFrame lookAt(const ViewContent& content, bool orthographic) {
    return {app::presetCamera(app::ViewPreset::Everything, content, {}, kView, orthographic), kView};
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
    const auto handles = app::handlesOf(scene, world, 0);
    expectNear(handleOf(handles, Kind::Light).at, {300, -200, 400}, 0);
    expectNear(handleOf(handles, Kind::Eye).at, pipeline::makeView(scene).eye, 0);
    expectNear(handleOf(handles, Kind::Object).at, {335, 75, 75}, 1e-4);  // of 200..470, 0..150, 0..150
    EXPECT_EQ(app::handlesOf(scene, world, {}).size(), 2u) << "no object is meant";
    EXPECT_EQ(app::handlesOf(test::pyramid(), contentOf(test::pyramid()), {})[0].kind, Kind::LightDirection);
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
    for (const Handle& handle : app::handlesOf(scene, world, {})) EXPECT_NE(handle.kind, Kind::Light);
}

TEST(View3dHandles, FollowTheCursor) {
    const pipeline::Scene scene = withPointLight();
    const ViewContent world = contentOf(scene);
    for (const bool orthographic : {false, true})
        for (const Handle& handle : app::handlesOf(scene, world, 0)) {
            const app::ViewFrame view = lookAt(world, orthographic);
            const glm::dvec2 begin = app::project(view.camera, kView, handle.at).at, moved{37, -21};
            EXPECT_EQ(app::draggedTo(handle, DragAxis::Screen, view, {0, 0}), handle.at);
            const Vec3d to = app::draggedTo(handle, DragAxis::Screen, view, moved);
            const glm::dvec2 end = app::project(view.camera, kView, to).at;
            EXPECT_LT(glm::length(end - begin - moved), 1.01) << handle.name << ": rounded to less than a pixel";
        }
}

TEST(View3dHandles, AnAxisMovesOneNumberAlone) {
    const pipeline::Scene scene = withPointLight();
    const ViewContent world = contentOf(scene);
    const app::ViewFrame view = lookAt(world, false);
    const Handle handle = handleOf(app::handlesOf(scene, world, 0), Kind::Object);
    for (int axis = 0; axis < 3; ++axis) {
        // 30 pixels along the axis as it lies on the screen.
        const glm::dvec2 tip = app::axisTips(handle, view)[std::size_t(axis)];
        const glm::dvec2 along = tip - app::project(view.camera, kView, handle.at).at;
        const Vec3d to = app::draggedTo(handle, DragAxis(axis + 1), view, 30.0 / glm::length(along) * along);
        for (int i = 0; i < 3; ++i) {
            if (i == axis)
                EXPECT_GT(to[i], handle.at[i] + 1);
            else
                EXPECT_EQ(to[i], handle.at[i]);
        }
    }
    // Seen from straight above z has no direction on the screen: nothing moves, and nothing is infinite.
    const app::ViewFrame top{app::presetCamera(app::ViewPreset::Top, world, {}, kView, true), kView};
    EXPECT_EQ(app::draggedTo(handle, DragAxis::Z, top, {10, 10}), handle.at);
}

TEST(View3dHandles, ADirectionTurnsAndKeepsItsLength) {
    const pipeline::Scene scene = test::pyramid();  // towards (500, 500, 500)
    const ViewContent world = contentOf(scene);
    const app::ViewFrame view = lookAt(world, false);
    const Handle handle = handleOf(app::handlesOf(scene, world, {}), Kind::LightDirection);
    for (const glm::dvec2 moved : {glm::dvec2(15, 8), glm::dvec2(-400, 300)}) {
        const Vec3d to = app::draggedTo(handle, DragAxis::Screen, view, moved);
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
    const Handle eye = handleOf(app::handlesOf(scene, contentOf(scene), {}), Kind::Eye);
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
    const Handle place = handleOf(app::handlesOf(look, contentOf(look), {}), Kind::Eye);
    EXPECT_EQ(app::withHandleAt(look, place, {1, 2, 3}).camera.eye, Vec3d(1, 2, 3));
}

TEST(View3dHandles, AnObjectIsMovedByWhatItsHandleMoves) {
    const pipeline::Scene scene = test::pyramid();
    const Handle object = handleOf(app::handlesOf(scene, contentOf(scene), 0), Kind::Object);
    const pipeline::Scene moved = app::withHandleAt(scene, object, object.at + Vec3d(10, 0, -5));
    expectNear(moved.objects[0].transform.translation - scene.objects[0].transform.translation, {10, 0, -5}, 1e-9);
}

TEST(View3dHandles, ThePressTakesTheNearestWithinReach) {
    const pipeline::Scene scene = withPointLight();
    const ViewContent world = contentOf(scene);
    const app::ViewFrame view = lookAt(world, false);
    const auto handles = app::handlesOf(scene, world, 0);
    for (std::size_t i = 0; i < handles.size(); ++i) {
        const glm::dvec2 at = app::project(view.camera, kView, handles[i].at).at;
        EXPECT_EQ(app::gripAt(handles, {}, view, at + glm::dvec2(4, -4)), (app::Grip{i, DragAxis::Screen}));
        const glm::dvec2 tip = app::axisTips(handles[i], view)[2];
        EXPECT_EQ(app::gripAt(handles, i, view, tip), (app::Grip{i, DragAxis::Z})) << "its axes are on show";
    }
    EXPECT_FALSE(app::gripAt(handles, {}, view, {-500, -500}));
}

TEST(View3dHandles, TheNumbersAreTheSettings) {
    const pipeline::Scene scene = withPointLight();
    const auto handles = app::handlesOf(scene, contentOf(scene), 0);
    EXPECT_EQ(app::numbersOf(scene, handleOf(handles, Kind::Light)), "x 300  y −200  z 400");
    EXPECT_EQ(app::numbersOf(scene, handleOf(handles, Kind::Eye)), "ρ 1 000  θ 45.0°  φ 60.0°");
}
