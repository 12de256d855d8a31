// Leaving out changes no bit: 1,000 random scenes with all rules, with none, with one alone and with all but one.
#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace pipeline {
namespace {

struct LeavingOut : testing::TestWithParam<unsigned> {
    static constexpr unsigned kScenes = 1000, kShards = 20;
};
INSTANTIATE_TEST_SUITE_P(Shards, LeavingOut, testing::Range(0u, LeavingOut::kShards));

BufferSet someBuffers(unsigned seed) {
    std::mt19937 random(seed);
    BufferSet set = setOf({BufferId::Color, BufferId::Intensity});
    for (std::size_t i = 0; i < kBufferCount; ++i)
        if (random() % 8 == 0) set.set(i);
    return set;
}

TEST_P(LeavingOut, ChangesNoBit) {
    for (unsigned seed = GetParam(); seed < kScenes; seed += kShards) {
        Scene scene = test::randomScene(seed);
        if (seed % 3 == 0) scene.settings.shadowBias = ShadowBias::Constant;  // of 0: everything shadows itself
        for (Object& object : scene.objects)                                  // nothing but highlights
            if (seed % 11 == 0) object.material.diffuse = Vec3d(0);
        std::mt19937 random(seed);
        if (seed / 2 % 3 == 0) test::giveNormals(scene, random);
        if (seed % 5 == 0) test::giveColors(scene, random);
        if (seed % 7 < 2) scene.settings.forms = test::randomForms(random);
        // Each rule with every kind of scene: their number has factors in common with those above.
        const Rule rule = Rule((seed + seed / kRuleCount) % kRuleCount);
        const BufferSet wanted = seed % 4 == 0 ? setOf({BufferId::Color, BufferId::Intensity}) : someBuffers(seed);
        const FramePtr all = test::frameOf(scene, wanted);
        const auto differs = [&](RuleSet rules) {
            scene.settings.rules = rules;
            return test::firstDifference(*all, *test::frameOf(scene, wanted), wanted);
        };
        ASSERT_EQ(differs({}), "") << "seed " << seed << " without any rule";
        ASSERT_EQ(differs(RuleSet().set(index(rule))), "") << "seed " << seed << " with " << name(rule) << " alone";
        ASSERT_EQ(differs(RuleSet().set().reset(index(rule))), "") << "seed " << seed << " without " << name(rule);
    }
}

// Also where the run ends early, so that nobody reads what the last stages alone would.
TEST_P(LeavingOut, ChangesNoBitOfARunThatEndsEarly) {
    for (unsigned seed = GetParam(); seed < kScenes / 4; seed += kShards) {
        Scene scene = test::randomScene(seed);
        std::mt19937 random(seed);
        if (seed / 2 % 3 == 0) test::giveNormals(scene, random);
        FrameRequest request;
        request.until = StageId(random() % (kStageCount - 1));
        BufferSet left;  // by the stages that run
        for (const BufferInfo& info : bufferTable()) left[index(info.id)] = info.stage <= request.until;
        request.wanted = someBuffers(seed) & left;
        const FramePtr with = runFrame(std::make_shared<const Scene>(scene), request, nullptr);
        scene.settings.leaveOut = false;
        const FramePtr without = runFrame(std::make_shared<const Scene>(scene), request, nullptr);
        ASSERT_EQ(test::firstDifference(*with, *without, request.wanted), "") << "seed " << seed;
    }
}

}  // namespace
}  // namespace pipeline
