#include <gtest/gtest.h>

#include "pipeline/run/runner.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

// 0.1 in float is 0.1 + 1.5e-9: with the near plane between the two the vertex has a place on the screen in float and
// none in double. The others lie within 640 pixels, where float's numbers are 2^-14 apart.
TEST(StageError, OfTransformLeavesOutAVertexThatHasAPlaceInOnePrecisionOnly) {
    Scene scene;
    scene.settings.shading = Shading::Phong;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, 0, 0}, scene.camera.target = {0, 0, -1}, scene.camera.up = {0, 1, 0};
    scene.camera.near = 0.1 + 0.75e-9, scene.camera.far = 10;
    scene.objects.push_back({"triangle", test::mesh({{0.02, 0, -0.1}, {1, 1, -3}, {-1, 1, -3}}, {{0, 1, 2}}), {}, {}});
    scene.settings.cull = CullMode::None;
    const FramePtr frame = test::frameOf(scene);
    const AnyBuffer screen = *frame->buffer({BufferId::VerticesScreen});
    ASSERT_GT(screen.value(0, 0, 0), 0);  // in float
    const auto errors = errorAgainstDouble(frame);
    ASSERT_TRUE(errors[index(StageId::Transform)]);
    EXPECT_LT(errors[index(StageId::Transform)]->value, 0x1p-12) << errors[index(StageId::Transform)]->text;
}

}  // namespace
}  // namespace pipeline
