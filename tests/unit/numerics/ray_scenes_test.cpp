// Every scene that comes with the program, as its stages draw it and as rays see its polygons: the two share no code
// above the scene itself, so that where they agree both are right.
#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/study/errors.h"
#include "pipeline/study/ray_caster.h"
#include "tests/support/rays.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

class RayScenes : public testing::TestWithParam<BuiltInScene> {};
INSTANTIATE_TEST_SUITE_P(Scenes, RayScenes, testing::ValuesIn(builtInScenes()),
                         [](const auto& of) { return of.param.name; });

TEST_P(RayScenes, LookTheSameByRays) {
    auto read = readScene(GetParam().file);
    ASSERT_TRUE(read);
    Scene scene = *read;
    scene.camera.pixelsPerUnit *= 120.0 / scene.settings.height;
    scene.settings.width = 160, scene.settings.height = 120;
    scene.settings.precision = Precision::Double;
    scene.settings.depthFormat = DepthFormat::Linear;  // others store less than they compute
    scene.settings.shadowBias = ShadowBias::Automatic;
    scene.settings.visibility = Visibility::ZBuffer;
    // Translucent scenes are the only ones that have no such reference; no other may slip through.
    const bool translucent =
        std::ranges::any_of(scene.objects, [](const Object& object) { return object.material.alpha < 1; });
    ASSERT_EQ(whyNoRays(scene, RaySurfaces::Polygons),
              translucent ? "rays stop at the first surface, which here is translucent" : "");
    if (translucent) return;
    const test::RayComparison found = test::compareWithRays(*test::frameOf(scene, picturesNeed()));
    EXPECT_EQ(found.different, "");
    EXPECT_LE(found.otherFacets, found.seen / 100 + 2);
    EXPECT_GT(found.seen, 60);
    const bool soft = std::ranges::any_of(scene.lights, [](const Light& l) { return l.kind == LightKind::Area; });
    EXPECT_LE(found.otherShadows, soft ? found.seen / 5 : found.seen / 100);
}

}  // namespace
}  // namespace pipeline
