// Leaving out changes no bit of any scene that comes with the program.
#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/plan/needs.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

class BuiltInRules : public testing::TestWithParam<BuiltInScene> {};
INSTANTIATE_TEST_SUITE_P(Scenes, BuiltInRules, testing::ValuesIn(builtInScenes()),
                         [](const auto& of) { return of.param.name; });

// All rules, none, each alone, all but each: the pictures, and what else is always there.
TEST_P(BuiltInRules, GiveTheSameBits) {
    auto read = readScene(GetParam().file);
    ASSERT_TRUE(read);
    Scene scene = *read;
    scene.camera.pixelsPerUnit *= 96.0 / scene.settings.height;
    scene.settings.width = 128, scene.settings.height = 96, scene.settings.shadowSize = 32;
    const BufferSet wanted = setOf({BufferId::Color, BufferId::Intensity, BufferId::PolygonId, BufferId::ZView});
    const FramePtr all = test::frameOf(scene, wanted);
    const auto differs = [&](RuleSet rules) {
        scene.settings.rules = rules;
        return test::firstDifference(*all, *test::frameOf(scene, wanted), wanted);
    };
    ASSERT_EQ(differs({}), "") << "without any rule";
    for (std::size_t i = 0; i < kRuleCount; ++i) {
        ASSERT_EQ(differs(RuleSet().set(i)), "") << "with " << name(Rule(i)) << " alone";
        ASSERT_EQ(differs(RuleSet().set().reset(i)), "") << "without " << name(Rule(i));
    }
}

// Else the plan says of a shadow buffer that nobody has a use for it, and draws it for S of a light that adds nothing.
TEST(UsefulBuffers, NeedNothingThatIsUseless) {
    int left = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        Scene scene = test::randomScene(seed);
        scene.settings.leaveOut = true, scene.settings.rules = RuleSet().set();
        for (Light& light : scene.lights) light.intensity = seed % 2;
        const auto plan = test::frameOf(scene, usefulBuffers(scene))->plan();
        if (whyUseless(scene, BufferId::ShadowBuffer).empty()) continue;
        EXPECT_EQ(plan[index(StageId::ShadowBuffer)].action, Action::LeaveOut) << seed;
        left += std::ranges::any_of(scene.lights, &Light::castsShadow);
    }
    EXPECT_GT(left, 5);
}

// They read of culling which polygons are dropped; where it drops none, they are there all the same.
TEST(UsefulBuffers, AreIntensitiesAlsoWhereNothingIsCulled) {
    Scene scene = test::pyramid();
    scene.settings.cull = CullMode::None;
    scene.settings.shading = Shading::Gouraud;
    EXPECT_EQ(whyUseless(scene, BufferId::VerticesIntensity), "");
    EXPECT_NE(whyUseless(scene, BufferId::PolygonsIntensity), "") << "only flat shading evaluates polygons";
    EXPECT_NE(whyUseless(scene, BufferId::PolygonsVerdict), "");
    scene.settings.shading = Shading::Flat;
    EXPECT_EQ(whyUseless(scene, BufferId::PolygonsIntensity), "");
}

}  // namespace
}  // namespace pipeline
