// A frame that reused what it could equals one computed from nothing, bit for bit.
#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace pipeline {
namespace {

class Reuse : public testing::TestWithParam<unsigned> {};
INSTANTIATE_TEST_SUITE_P(Seeds, Reuse, testing::Range(0u, 24u));

BufferSet someBuffers(std::mt19937& random) {
    BufferSet set;
    for (std::size_t i = 0; i < kBufferCount; ++i) set[i] = random() % 3 == 0;
    return set;
}

TEST_P(Reuse, EqualsAFreshFrameAfterAnyChanges) {
    Scene scene = test::randomScene(GetParam());
    std::mt19937 random(GetParam());
    if (GetParam() % 3 == 0) test::giveNormals(scene, random);
    FramePtr frame;
    for (int step = 0; step < 20; ++step) {
        const BufferSet wanted = step % 3 == 0 ? test::everyBuffer() : someBuffers(random);
        frame = test::frameOf(scene, wanted, 0, frame);
        const FramePtr fresh = test::frameOf(scene, wanted);
        ASSERT_EQ(test::firstDifference(*frame, *fresh, wanted), "") << "seed " << GetParam() << " step " << step;
        test::changeSomething(scene, random);
    }
}

TEST(ReusePlan, NothingChangedRunsNothing) {
    const Scene scene = test::pyramid();
    const FramePtr first = test::frameOf(scene, {}), second = test::frameOf(scene, {}, 0, first);
    for (const PlanStep& step : second->plan()) EXPECT_NE(step.action, Action::Run) << stageInfo(step.stage).name;
}

TEST(ReusePlan, TheSameRequestForTheSameSceneIsTheSameFrame) {
    const auto scene = std::make_shared<const Scene>(test::pyramid());
    const FrameRequest request{.wanted = setOf({BufferId::Color}), .stop = {}};
    const FramePtr first = runFrame(scene, request, nullptr);
    EXPECT_EQ(runFrame(scene, request, first), first);
    EXPECT_NE(runFrame(scene, {.wanted = setOf({BufferId::Depth}), .stop = {}}, first), first);
    EXPECT_NE(runFrame(scene, {.wanted = request.wanted, .until = StageId::Cull, .stop = {}}, first), first);
    EXPECT_NE(runFrame(std::make_shared<const Scene>(*scene), request, first), first);
}

// The actions of the six stages as one word: R runs, = is reused, - is left out.
std::string actions(const Frame& frame) {
    std::string word;
    for (const PlanStep& step : frame.plan())
        word += step.action == Action::Run ? 'R' : step.action == Action::Reuse ? '=' : '-';
    return word;
}

TEST(ReusePlan, AMaterialReRunsShadingAlone) {
    Scene scene = test::pyramid();
    const FramePtr first = test::frameOf(scene, {});
    EXPECT_EQ(actions(*first), "RRR-RR");
    scene.objects[0].material.exponent = 4;
    const FramePtr second = test::frameOf(scene, {}, 0, first);
    EXPECT_EQ(actions(*second), "===-=R");
    EXPECT_EQ(second->plan()[index(StageId::Shading)].why, "Material 0 changed.");
    EXPECT_EQ(second->plan()[index(StageId::ZBuffer)].why, "Nothing that this stage reads has changed since frame 1.");
}

TEST(ReusePlan, ABackMaterialIsNamed) {
    Scene scene = test::openGlCube();
    scene.settings.width = scene.settings.height = 16, scene.settings.twoSided = true;
    scene.objects[0].backMaterial = scene.objects[0].material;
    const FramePtr first = test::frameOf(scene, {});
    scene.objects[0].backMaterial->diffuse = {0, 1, 0};
    const FramePtr second = test::frameOf(scene, {}, 0, first);
    EXPECT_EQ(second->plan()[index(StageId::Shading)].why, "Back material 0 changed.");
}

TEST(ReusePlan, ALightReRunsItsShadowBufferAndShading) {
    Scene scene = test::pyramid();
    scene.objects.push_back(scene.objects[0]);
    scene.objects[1].transform.translation = {0, 100, 0};  // overlaps the first as the light sees it
    const FramePtr first = test::frameOf(scene, {});
    EXPECT_EQ(actions(*first), "RRRRRR");
    scene.lights[0].position = {1, 2, 3};
    const FramePtr moved = test::frameOf(scene, {}, 0, first);
    EXPECT_EQ(actions(*moved), "===R=R");
    scene.lights[0].intensity = 7;  // does not move the light: its shadow buffer holds
    EXPECT_EQ(actions(*test::frameOf(scene, {}, 0, moved)), "=====R");
}

TEST(ReusePlan, TheCameraKeepsTheDepthsOfLights) {
    Scene scene = test::pyramid();
    scene.objects.push_back(scene.objects[0]);
    scene.objects[1].transform.translation = {0, 100, 0};  // overlaps the first as the light sees it
    const FramePtr first = test::frameOf(scene, {});
    scene.camera.theta = 50;
    const FramePtr second = test::frameOf(scene, {}, 0, first);
    EXPECT_EQ(actions(*second), "RRR=RR");
    EXPECT_EQ(second->plan()[index(StageId::Transform)].why, "The camera changed.");
    scene.objects[1].transform.translation = {0, 90, 0};  // what the light sees is another
    EXPECT_EQ(actions(*test::frameOf(scene, {}, 0, second)), "RRRRRR");
}

}  // namespace
}  // namespace pipeline
