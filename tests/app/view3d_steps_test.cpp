// What the 3D view shows while a stage is stepped through.
#include <algorithm>

#include "tests/app/shown_view3d.h"

namespace {

class View3dSteps : public ShownView3d {};

}  // namespace

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
