// Random scenes look the same by rays as by the stages.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "pipeline/stages/cull.h"
#include "pipeline/study/errors.h"
#include "pipeline/study/ray_caster.h"
#include "tests/support/rays.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

// Of a clipped triangle the weights in the picture go by its piece, which rays know nothing of.
bool clips(const Frame& frame) {
    const AnyBuffer verdicts = *frame.buffer({BufferId::PolygonsVerdict});
    for (std::size_t i = 0; i < verdicts.count(); ++i)
        if (verdicts.flat(i) == double(Verdict::Clipped)) return true;
    return false;
}

TEST(RandomScenes, LookTheSameByRays) {
    int compared = 0;
    std::array<int, 3> methods{};  // of interpolation
    for (unsigned seed = 0; seed < 120; ++seed) {
        Scene scene = test::randomScene(seed);
        scene.settings.precision = Precision::Double;
        scene.settings.visibility = Visibility::ZBuffer;
        scene.settings.depthFormat = DepthFormat::Linear;
        scene.settings.shadowSize = 512;
        // Coincident polygons: either may be in front.
        std::erase_if(scene.objects, [](const Object& o) { return o.mesh->facts.nonPlanar > 0; });
        for (Object& object : scene.objects)
            if (object.material.alpha > 0) object.material.alpha = 1;
        for (Light& light : scene.lights)
            if (light.kind == LightKind::Area) light.kind = LightKind::Point;
        if (!whyNoRays(scene, RaySurfaces::Polygons).empty()) continue;
        const BufferSet wanted = picturesNeed() | setOf({BufferId::PolygonsVerdict});
        FramePtr frame = test::frameOf(scene, wanted);
        if (clips(*frame) && scene.settings.interpolation != Interpolation::Perspective) {
            scene.settings.interpolation = Interpolation::Perspective;
            frame = test::frameOf(scene, wanted);
        }
        ++methods[std::size_t(scene.settings.interpolation)];
        const test::RayComparison found = test::compareWithRays(*frame, 0.05);
        compared += found.seen > 0;
        ASSERT_EQ(found.different, "") << "scene " << seed;
        // A centre lies within √2 / 512 pixel of an edge in one of some 200 pixels along it.
        ASSERT_LE(found.otherFacets, found.seen / 100 + 2) << "scene " << seed;
        // Texels beside an edge of a shadow.
        ASSERT_LE(found.otherShadows, found.seen / 50 + 4) << "scene " << seed;
    }
    EXPECT_GT(compared, 70);
    for (const int count : methods) EXPECT_GT(count, 12);
}

}  // namespace
}  // namespace pipeline
