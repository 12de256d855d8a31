#include "app/frames/shadow_texel.h"

#include <gtest/gtest.h>

#include <QTest>

#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "pipeline/run/frame_data.h"
#include "tests/support/scenes.h"

// Where the point of a pixel stands in a shadow buffer.
namespace {

pipeline::Scene boxLitFrom(pipeline::LightKind kind) {
    pipeline::Scene scene = test::boxOverGround();
    scene.settings.precision = pipeline::Precision::Double;
    scene.settings.shadowSize = 64;
    scene.lights[0].kind = kind;
    scene.lights[0].position =
        kind == pipeline::LightKind::AtInfinity ? pipeline::Vec3d(1, -0.5, 1) : pipeline::Vec3d(3, -3, 4);
    return scene;
}

// The line through a texel's centre passes the point by half a texel at most, across each axis; rounding may add a millionth
// of a texel.
void expectTexelsMeetTheirPoints(const pipeline::Scene& scene) {
    const pipeline::FramePtr frame =
        test::frameOf(scene, pipeline::setOf({pipeline::BufferId::Position, pipeline::BufferId::ShadowBuffer}));
    const auto positions = frame->buffer({pipeline::BufferId::Position});
    const auto ids = frame->buffer({pipeline::BufferId::PolygonId});
    ASSERT_TRUE(positions && ids);
    const auto& light = pipeline::dataOf<double>(*frame)->shadowBuffer->lights[0][0];
    int found = 0;
    for (int y = 0; y < scene.settings.height; y += 3)
        for (int x = 0; x < scene.settings.width; x += 3) {
            const auto texel = app::shadowTexel(*frame, 0, {x, y});
            if (ids->value(std::size_t(x), std::size_t(y)) < 0) {
                EXPECT_FALSE(texel);
                continue;
            }
            if (!texel) continue;  // beside the buffer
            ++found;
            const auto at = [&](int c) { return positions->value(std::size_t(x), std::size_t(y), c); };
            const pipeline::Vec3d point{at(0), at(1), at(2)};
            const int rows = light.depth[0]->size.y;
            const pipeline::View& face = light.faces[std::size_t(texel->y / rows)];
            const double z = glm::dot(point - face.eye, face.forward);
            const glm::dvec2 centre(texel->x + 0.5, texel->y % rows + 0.5);
            const pipeline::Vec3d miss = point - worldPoint(face, centre, z);
            const double spread = face.perspective ? z : 1;
            EXPECT_LE(std::abs(glm::dot(miss, face.right)) * face.scale.x / spread, 0.5 + 1e-6) << x << ' ' << y;
            EXPECT_LE(std::abs(glm::dot(miss, face.up)) * face.scale.y / spread, 0.5 + 1e-6) << x << ' ' << y;
        }
    EXPECT_GT(found, 100);
}

TEST(ShadowTexel, IsTheOneThatTheLightSeesThePointIn) {
    expectTexelsMeetTheirPoints(boxLitFrom(pipeline::LightKind::AtInfinity));
    expectTexelsMeetTheirPoints(boxLitFrom(pipeline::LightKind::Point));
}

TEST(ShadowTexel, IsMarkedWhereThePixelIs) {
    app::Document document;
    app::BufferView view(document);
    view.resize(600, 500);
    view.show();
    const pipeline::Scene scene = boxLitFrom(pipeline::LightKind::AtInfinity);
    document.setScene(scene);
    view.setBuffer({pipeline::BufferId::ShadowBuffer, 0});
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document.frames().busy() && view.shown(); }, 10000));
    const glm::ivec2 pixel(scene.settings.width / 2, scene.settings.height / 2);
    const auto texel = app::shadowTexel(*document.frames().shown(), 0, pixel);
    ASSERT_TRUE(texel);
    document.pointing().hover(pixel);
    EXPECT_EQ(view.canvas()->content().hovered, QPoint(texel->x, texel->y));
    document.pointing().hover(std::nullopt);
    EXPECT_FALSE(view.canvas()->content().hovered);
    document.pointing().pick(pixel);
    EXPECT_EQ(view.canvas()->content().picked, QPoint(texel->x, texel->y));
}

}  // namespace
