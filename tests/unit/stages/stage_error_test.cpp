#include <gtest/gtest.h>

#include "pipeline/run/runner.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

// 1 - 1e-9 in float is 1, where the eye is: the vertex has a position in the picture in double and none in float. The
// others lie within 640 pixels, where float's numbers are 2^-14 apart.
TEST(StageError, OfTransformLeavesOutAVertexThatHasAPositionInOnePrecisionOnly) {
    Scene scene;
    scene.settings.shading = Shading::Phong;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, 0, 1}, scene.camera.target = {0, 0, 0}, scene.camera.up = {0, 1, 0};
    scene.camera.near = 0.1, scene.camera.far = 10;
    scene.objects.push_back(
        {"triangle", test::mesh({{0.02, 0, 1 - 1e-9}, {1, 1, -2}, {-1, 1, -2}}, {{0, 1, 2}}), {}, {}});
    scene.settings.cull = CullMode::None;
    const FramePtr frame = test::frameOf(scene);
    const AnyBuffer screen = *frame->buffer({BufferId::VerticesScreen});
    ASSERT_EQ(statistics(screen).withoutValue, 1u);  // in float
    const auto errors = errorAgainstDouble(frame);
    ASSERT_TRUE(errors[index(StageId::Transform)]);
    EXPECT_LT(errors[index(StageId::Transform)]->value, 0x1p-12) << errors[index(StageId::Transform)]->text;
}

}  // namespace
}  // namespace pipeline
