// What a frame may take: counted for what is asked for, by hand.
#include "pipeline/plan/memory_limit.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/scene/settings_table.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

std::string found(const Scene& scene, BufferSet wanted, StageId until = StageId::Shading) {
    const Errors errors = checkMemory(scene, wanted, until);
    return errors.empty() ? "fits" : format(errors[0]);
}
bool has(const std::string& text, std::string_view words) { return text.find(words) != text.npos; }

Scene huge() {
    Scene scene = test::boxOverGround();
    scene.lights.push_back(scene.lights[0]);
    scene.settings.width = scene.settings.height = 16384;
    return scene;
}

// 2^28 pixels of 30 numbers, 19 more a light, 5 counts and ids and a colour: (30 + 2 · 19) · 4 + 5 · 4 + 3 = 295 bytes
// are 73.75 GiB; two shadow buffers of 1024² floats add 8 MiB.
TEST(MemoryLimit, OfEveryBufferIsTheirSum) {
    const std::string all = found(huge(), BufferSet().set());
    EXPECT_TRUE(has(all, "the buffers of a 16384 × 16384 picture with 2 lights and 2 shadow buffers of 1024 × 1024"));
    EXPECT_TRUE(has(all, "take 73.8 GiB, expected at most 4 GiB;")) << all;
    EXPECT_EQ(checkMemory(huge(), BufferSet().set())[0].keys[0], "width");
    EXPECT_TRUE(checkScene(huge()).empty());
    EXPECT_FALSE(checkSceneAndMemory(huge()).empty());
}

// The colour alone: z_view 4, the triangle 4 and the colour 3 bytes are 2.75 GiB, a float of each pixel's depth 1 more,
// a position 3 more.
TEST(MemoryLimit, CountsWhatIsAskedFor) {
    const Scene scene = huge();
    EXPECT_EQ(found(scene, setOf({BufferId::Color})), "fits");
    EXPECT_EQ(found(scene, setOf({BufferId::Depth})), "fits");
    EXPECT_TRUE(has(found(scene, setOf({BufferId::Position})), "take 5.8 GiB, expected at most 4 GiB; ask for fewer"));
    EXPECT_EQ(found(scene, setOf({BufferId::VerticesScreen}), StageId::Transform), "fits") << "no picture is made";
    Scene forced = scene;
    forced.settings.leaveOut = false;
    EXPECT_FALSE(has(found(forced, setOf({BufferId::Color})), "fits"));
    EXPECT_TRUE(has(found(forced, {}), "at most 4 GiB; make the picture smaller"));
}

// A plane of 256 × 256 squares has 257² = 66 049 vertices, 65 536 polygons and twice as many triangles. Up to stage 2, in
// float, a vertex takes 12 bytes in the world and 16 snapped, a polygon its object's number and 2, a triangle 12 and its
// polygon's number: 28 · 66 049 + 6 · 65 536 + 16 · 131 072 = 4 339 740 bytes an object, 4 GiB after 989 of them.
TEST(MemoryLimit, CountsVerticesPolygonsAndTriangles) {
    Scene scene;
    scene.settings.width = scene.settings.height = 16;
    Object plane;
    plane.shape = Shape{ShapeKind::Plane, 256};
    plane.mesh = makeShape(*plane.shape);
    scene.objects.assign(980, plane);
    EXPECT_EQ(found(scene, {}, StageId::Cull), "fits");
    scene.objects.assign(1000, plane);
    const std::string refused = found(scene, {}, StageId::Cull);
    EXPECT_TRUE(has(refused, "1000 objects with 66049000 vertices, 65536000 polygons and 131072000 triangles"))
        << refused;
    EXPECT_TRUE(has(refused, "takes 4.0 GiB, expected at most 4 GiB; fewer objects, or a smaller tessellation"));
    EXPECT_EQ(checkMemory(scene, {}, StageId::Cull)[0].keys[0], "object.999.tessellation");
}

// 16² samples of an area light, 6 faces, 1024² floats are 6 GiB, and once more where they are asked for.
TEST(MemoryLimit, OfAreaLightsIsTheirSamples) {
    Scene scene = test::boxOverGround();
    Light& light = scene.lights[0];
    light.kind = LightKind::Area, light.position = {0, 0, 9}, light.area.facing = {0, 0, -1};
    light.area.width = light.area.height = 2, light.area.samples = 16;
    EXPECT_TRUE(has(found(scene, {}), "1 light and 1536 shadow buffers of 1024 × 1024 take 6.0 GiB"));
    const std::string twice = found(scene, setOf({BufferId::ShadowBuffer}));
    EXPECT_TRUE(has(twice, "take 12.0 GiB, expected at most 4 GiB; make shadow.size or the samples of the area lights"))
        << twice;
    EXPECT_EQ(checkMemory(scene, {})[0].keys[0], "shadow.size");
    light.castsShadow = false;
    EXPECT_EQ(found(scene, {}), "fits");
}

}  // namespace
}  // namespace pipeline
