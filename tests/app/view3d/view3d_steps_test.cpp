// What the 3D view shows while a stage is stepped through.
#include <algorithm>

#include "tests/app/view3d/shown_view3d.h"

namespace {

class View3dSteps : public ShownView3d {};

}  // namespace

// Without culling, polygon 1 is tested at pixel 250, 270 where polygon 0 is stored already. The z-buffer stage interpolates
// its depth on the screen: 671.9340. The ray meets the polygon's plane in the world. The stage's corners are
// on a grid of 1/256 pixel, and z grows by 2.8 a pixel: both differ by 2.8 / 256 at most.
TEST_F(View3dSteps, TheRayOfTheStepsPixelReachesThePolygonThatIsTested) {
    pipeline::Scene scene = test::pyramid();
    scene.settings.cull = pipeline::CullMode::None;
    QSignalSpy ready(&document.frames(), &app::FrameFeed::frameReady);
    document.setScene(scene);
    ASSERT_TRUE(ready.wait());
    document.stepper().setLevel(pipeline::StepLevel::Line);
    ASSERT_TRUE(QTest::qWaitFor([&] { return document.stepper().steps() != nullptr; }, 10000));
    document.stepper().goTo(*pipeline::parsePlace("z-buffer/polygon=1/row=270/x=250/line=5"));
    ASSERT_TRUE(QTest::qWaitFor([this] { return document.stepper().isSettled(); }, 10000));
    ASSERT_TRUE(waitUntilDrawn());
    const app::ViewContent& content = *view.space().content();
    ASSERT_TRUE(content.stepRay);
    EXPECT_EQ(content.stepRay->pixel, glm::ivec2(250, 270));
    EXPECT_NEAR(glm::dot(content.stepRay->to - content.eye.eye, content.eye.forward), 671.9340, 2.8 / 256);
    document.stepper().leave();
    ASSERT_TRUE(QTest::qWaitFor([this] { return !document.frames().busy(); }, 10000));
    ASSERT_TRUE(waitUntilDrawn());
    EXPECT_FALSE(view.space().content()->stepRay);
}

// Of the pyramid, inside the transform stage: nothing of what later stages find, and a colour where all corners are.
TEST_F(View3dSteps, InsideTheTransformStageItShowsNothingOfLaterStages) {
    openPyramid();
    document.pointing().pick(glm::ivec2(268, 281));
    ASSERT_TRUE(waitUntilDrawn());
    const auto positions = view.space().content()->mesh->positions;
    for (const char* place : {"transform/start", "transform/vertex=3", "transform"}) {
        SCOPED_TRACE(place);
        document.stepper().goTo(*pipeline::parsePlace(place));
        ASSERT_TRUE(QTest::qWaitFor(
            [this] {
                return document.stepper().isSettled() &&
                       document.frames().shown()->until() == pipeline::StageId::Transform;
            },
            10000));
        ASSERT_TRUE(waitUntilDrawn());
        const app::ViewContent& content = *view.space().content();
        EXPECT_EQ(content.mesh->positions, positions);
        EXPECT_TRUE(content.mesh->polygonNormals.empty());
        EXPECT_TRUE(content.mesh->picture.pixels.empty());
        EXPECT_TRUE(content.vectors.empty());
        EXPECT_TRUE(content.pickedLoop.empty());
        const auto& vertices = *document.frames().shown()->buffer({pipeline::BufferId::VerticesWorld});
        for (const app::Face& face : content.mesh->faces) {
            const bool isThere = std::ranges::all_of(face.vertices, [&](std::uint32_t v) {
                return vertices.flat(3 * v) != 0 || vertices.flat(3 * v + 1) != 0 || vertices.flat(3 * v + 2) != 0;
            });
            EXPECT_EQ(face.shaded, isThere);
            EXPECT_EQ(content.mesh->colorOf(face, 0), glm::vec3(document.scene().objects[0].material.diffuse));
        }
    }
}
