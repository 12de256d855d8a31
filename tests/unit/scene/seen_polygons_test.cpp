// Which polygon a pixel sees: left out where depths alone are asked for, and found all the same by who looks.
#include <gtest/gtest.h>

#include "pipeline/run/frame_data.h"
#include "pipeline/run/runner.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

FramePtr untilZBuffer(const Scene& scene, BufferSet wanted, const FramePtr& before = {}) {
    const FrameRequest request{.wanted = wanted, .until = StageId::ZBuffer, .threads = 2, .stop = {}};
    return runFrame(std::make_shared<const Scene>(scene), request, before);
}
const ZBufferOutput<float>& zBufferOf(const Frame& frame) { return *dataOf<float>(frame)->zBuffer; }
bool keepsNames(const Frame& frame) {
    return !zBufferOf(frame).seen || dataOf<float>(frame)->keys.zBuffer.parts[Part::SeenPolygons];
}

const BufferSet kDepths = setOf({BufferId::ZView, BufferId::Depth});

// Small triangles and some that are clipped, in perspective and without, culled and not, several objects one of which is
// translucent: as a frame says that shades, which has to know.
TEST(SeenPolygons, AreFoundWhereDepthsAloneWereAskedFor) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        Scene scene = test::smallScene(seed);
        scene.settings.precision = Precision::Float, scene.settings.rules.set();
        scene.settings.visibility = Visibility::ZBuffer, scene.settings.depthFormat = DepthFormat::Linear;
        const FramePtr depths = untilZBuffer(scene, kDepths), whole = test::frameOf(scene);
        EXPECT_FALSE(keepsNames(*depths)) << seed;
        EXPECT_TRUE(keepsNames(*whole)) << seed;
        EXPECT_EQ(zBufferOf(*depths).triangle->pixels, zBufferOf(*whole).triangle->pixels) << seed;
        EXPECT_EQ(zBufferOf(*depths).zView->pixels, zBufferOf(*whole).zView->pixels) << seed;
        EXPECT_EQ(zBufferOf(*depths).seenPixels, zBufferOf(*whole).seenPixels) << seed;
        EXPECT_EQ(zBufferOf(*depths).won, zBufferOf(*whole).won) << seed;
    }
}

TEST(SeenPolygons, AreKeptWhereSomebodyAsksOrTheRuleIsOff) {
    Scene scene = test::spheres();
    for (const BufferId id : {BufferId::ObjectId, BufferId::PolygonId, BufferId::Barycentric})
        EXPECT_TRUE(keepsNames(*untilZBuffer(scene, setOf({id})))) << bufferInfo(id).name;
    scene.settings.rules.reset(index(Rule::UnreadBuffers));
    EXPECT_TRUE(keepsNames(*untilZBuffer(scene, kDepths)));
}

// The stages before are reused; whoever has asked for less takes what is there.
TEST(SeenPolygons, AreFoundAgainWhereTheyAreAskedForLater) {
    const Scene scene = test::spheres();
    const FramePtr depths = untilZBuffer(scene, kDepths),
                   ids = untilZBuffer(scene, setOf({BufferId::PolygonId}), depths);
    EXPECT_EQ(ids->plan()[index(StageId::Transform)].action, Action::Reuse);
    EXPECT_EQ(ids->plan()[index(StageId::ZBuffer)].action, Action::Run);
    EXPECT_EQ(untilZBuffer(scene, kDepths, ids)->plan()[index(StageId::ZBuffer)].action, Action::Reuse);
}

}  // namespace
}  // namespace pipeline
