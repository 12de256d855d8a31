// Random scenes look the same by rays as by the stages.
#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/study/errors.h"
#include "pipeline/study/ray_caster.h"
#include "tests/support/rays.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

TEST(RandomScenes, LookTheSameByRays) {
    int compared = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
        Scene scene = test::randomScene(seed);
        scene.settings.precision = Precision::Double;
        scene.settings.visibility = Visibility::ZBuffer;
        scene.settings.depthFormat = DepthFormat::Linear;
        scene.settings.shadowSize = 512;
        // A clipped triangle's affine weights go by its piece, which rays know nothing of.
        scene.settings.interpolation = Interpolation::Perspective;
        // Coincident polygons: either may be in front.
        std::erase_if(scene.objects, [](const Object& o) { return o.mesh->facts.nonPlanar > 0; });
        for (Object& object : scene.objects)
            if (object.material.alpha > 0) object.material.alpha = 1;
        for (Light& light : scene.lights)
            if (light.kind == LightKind::Area) light.kind = LightKind::Point;
        if (!whyNoRays(scene, RaySurfaces::Polygons).empty()) continue;
        const test::RayComparison found = test::compareWithRays(*test::frameOf(scene, picturesNeed()), 0.05);
        compared += found.seen > 0;
        ASSERT_EQ(found.different, "") << "scene " << seed;
        // Texels beside an edge of a shadow.
        ASSERT_LE(found.otherShadows, found.seen / 50 + 4) << "scene " << seed;
    }
    EXPECT_GT(compared, 120);
}

}  // namespace
}  // namespace pipeline
