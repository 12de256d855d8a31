// What must not change a single bit: threads, leave-outs, the order of polygons. Scales, turns, mirrors and the order of
// objects stand in metamorphic_*_test.cpp, each leave-out on and off in rules_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/plan/needs.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

class SameBits : public testing::TestWithParam<unsigned> {};
INSTANTIATE_TEST_SUITE_P(Seeds, SameBits, testing::Range(0u, 40u));

TEST_P(SameBits, OnOneTwoAndSevenThreads) {
    const Scene scene = test::randomScene(GetParam());
    const FramePtr one = test::frameOf(scene, test::everyBuffer(), 1);
    for (int threads : {2, 7})
        ASSERT_EQ(test::firstDifference(*one, *test::frameOf(scene, test::everyBuffer(), threads)), "") << threads;
}

TEST_P(SameBits, WithEverythingForcedIn) {
    Scene scene = test::randomScene(GetParam());
    scene.objects.resize(1 + GetParam() % 2 * (scene.objects.size() - 1));  // half of them one object: often convex
    const BufferSet useful = usefulBuffers(scene);
    const FramePtr planned = test::frameOf(scene, useful);
    scene.settings.leaveOut = false;
    const FramePtr forced = test::frameOf(scene, useful);
    ASSERT_EQ(test::firstDifference(*planned, *forced, useful), "");
}

// A convex object under every kind of light: the plan leaves its shadow buffers out, and is right to.
TEST_P(SameBits, AConvexObjectCannotShadowItself) {
    Scene scene = test::randomScene(GetParam());
    scene.objects.resize(1);
    scene.objects[0].mesh = GetParam() % 2 ? test::sphere(1, 3 + int(GetParam() % 9), 4 + int(GetParam() % 13))
                                           : test::box({-1, -1, -1}, {1, 1, 1});
    for (Light& light : scene.lights) light.castsShadow = true, light.intensity = 3;
    if (scene.settings.model == Model::OpenGl) scene.settings.model = Model::Phong;  // which has shadows
    scene.settings.twoSided = false;  // an eye within the body would see lit backs, which its front shadows
    if (scene.lights.empty()) scene.lights.push_back({});
    scene.settings.precision = GetParam() % 3 ? Precision::Float : Precision::Double;
    scene.settings.shadowSize = 16 << GetParam() % 5;
    const BufferSet compared = setOf({BufferId::Color, BufferId::Intensity});
    const FramePtr planned = test::frameOf(scene, compared);
    ASSERT_EQ(planned->plan()[index(StageId::ShadowBuffer)].action, Action::LeaveOut);
    scene.settings.leaveOut = false;
    const FramePtr forced = test::frameOf(scene, compared);
    ASSERT_EQ(forced->plan()[index(StageId::ShadowBuffer)].action, Action::Run);
    ASSERT_EQ(test::firstDifference(*planned, *forced, compared), "");
}

TEST(SameBitsOf, PolygonsInAnyOrder) {
    std::mt19937 random(5);
    Scene scene = test::randomScene(8);
    scene.settings.cull = CullMode::Back, scene.settings.shading = Shading::Flat;
    scene.settings.depthFormat = DepthFormat::Linear;
    scene.objects = {scene.objects[0]};
    const auto withOrder = [&](const std::vector<std::uint32_t>& order) {
        const auto ball = test::sphere(1, 8, 12);
        std::vector<std::vector<std::uint32_t>> polygons;
        for (std::uint32_t p : order) polygons.emplace_back(ball->polygon(p).begin(), ball->polygon(p).end());
        scene.objects[0].mesh = test::mesh(ball->positions, polygons);
        return test::frameOf(scene);
    };
    std::vector<std::uint32_t> order(test::sphere(1, 8, 12)->polygonCount());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    const FramePtr sorted = withOrder(order);
    for (int i = 0; i < 20; ++i) {
        std::shuffle(order.begin(), order.end(), random);
        ASSERT_EQ(test::firstDifference(*sorted, *withOrder(order), setOf({BufferId::Color, BufferId::ZView})), "");
    }
}

TEST_P(SameBits, NoBufferHoldsANumberThatIsNone) {
    for (Precision precision : {Precision::Float, Precision::Double}) {
        Scene scene = test::randomScene(GetParam());
        scene.settings.precision = precision;
        EXPECT_EQ(test::buffersWithoutNumbers(*test::frameOf(scene)), "");
    }
}

// The terms' buffers sum to the intensity to the last bit, in the order emission, ambient, then each
// light's diffuse and specular; and what translucent surfaces leave of the sum, with what they add.
TEST_P(SameBits, TheTermsSumToTheIntensity) {
    const Scene scene = test::randomScene(GetParam());
    const FramePtr frame = test::frameOf(scene);
    const AnyBuffer intensity = *frame->buffer({BufferId::Intensity}), ambient = *frame->buffer({BufferId::Ambient});
    const AnyBuffer emission = *frame->buffer({BufferId::Emission});
    const AnyBuffer seen = *frame->buffer({BufferId::ObjectId});
    const AnyBuffer translucent = *frame->buffer({BufferId::Translucent});
    const AnyBuffer left = *frame->buffer({BufferId::Transmittance}), layers = *frame->buffer({BufferId::Layers});
    for (std::size_t i = 0; i < intensity.count(); ++i) {
        if (seen.flat(i / 3) < 0) {
            ASSERT_EQ(translucent.flat(i), intensity.flat(i)) << i;
            continue;
        }
        float sum = float(emission.flat(i)) + float(ambient.flat(i));
        for (int k = 0; k < int(scene.lights.size()); ++k) {
            sum += float(frame->buffer({BufferId::Diffuse, k})->flat(i));
            sum += float(frame->buffer({BufferId::Specular, k})->flat(i));
        }
        if (layers.flat(i / 3) == 0) {
            ASSERT_EQ(left.flat(i / 3), 1) << i;
            ASSERT_EQ(translucent.flat(i), 0) << i;
        }
        const float rest = float(left.flat(i / 3)) * sum;
        ASSERT_EQ(rest + float(translucent.flat(i)), float(intensity.flat(i))) << i;
    }
}

}  // namespace
}  // namespace pipeline
