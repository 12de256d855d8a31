// Shadow factors against exact rays.
#include "pipeline/study/shadow_verdict.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pipeline/buffers/palette.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

using test::boxOverGround;

FramePtr frameWithShadow(const Scene& scene) {
    return test::frameOf(scene, setOf({BufferId::Shadow, BufferId::Position}));
}

std::size_t count(const ShadowVerdicts& found, ShadowVerdict verdict) { return found.counts[std::size_t(verdict)]; }

ShadowVerdicts judge(const Scene& scene) {
    return judgeShadows(*frameWithShadow(scene), exactShadows(scene, 0, 1).value()).value();
}

}  // namespace

// Light from straight above: a place on the ground (z = 0) lies in the box's shadow where |x| < 1 and |y| < 1, every
// place on a top is lit. So the rays are held against what anybody can say.
TEST(ShadowVerdict, RaysSayWhatTheGeometrySays) {
    const Scene scene = boxOverGround();
    const ExactShadows exact = exactShadows(scene, 0, 1).value();
    const FramePtr frame = frameWithShadow(scene);
    const AnyBuffer position = *frame->buffer({BufferId::Position});
    std::size_t shadowed = 0;
    for (int y = 0; y < scene.settings.height; ++y)
        for (int x = 0; x < scene.settings.width; ++x) {
            const auto at = [&](int c) { return position.value(std::size_t(x), std::size_t(y), c); };
            const std::size_t i = exact.seen.offset({x, y});
            const double edge = std::abs(std::max(std::abs(at(0)), std::abs(at(1))) - 1);
            if (exact.object.pixels[i] != 0 || std::abs(at(2)) > 1e-4 || edge < 1e-3) continue;  // the ground's top
            const bool below = std::max(std::abs(at(0)), std::abs(at(1))) < 1;
            ASSERT_EQ(exact.seen.pixels[i], below ? 0.0f : 1.0f) << x << ',' << y;
            shadowed += below;
        }
    EXPECT_GT(shadowed, 50u);
}

TEST(ShadowVerdict, AFineBufferWithItsOwnBiasIsRightAlmostEverywhere) {
    const ShadowVerdicts found = judge(boxOverGround());
    EXPECT_GT(count(found, ShadowVerdict::Lit), 1000u);
    EXPECT_GT(count(found, ShadowVerdict::Shadowed), 50u);
    EXPECT_LT(found.percent(ShadowVerdict::Acne) + found.percent(ShadowVerdict::Leak), 1.0);
    const AnyBuffer objects = *frameWithShadow(boxOverGround())->buffer({BufferId::ObjectId});
    std::size_t drawn = 0;
    for (std::size_t i = 0; i < objects.count(); ++i) drawn += objects.flat(i) >= 0;
    EXPECT_EQ(found.judged() + found.elsewhere, drawn) << "every drawn pixel, or its ray meets another object";
}

// Without a bias a slanting light finds its own surface in the coarse buffer: acne. With a bias larger than everything
// nothing is in shadow any more: all that was shadowed leaks.
TEST(ShadowVerdict, ABiasTradesAcneForLeaks) {
    Scene scene = boxOverGround();
    scene.lights[0].position = {1, -0.5, 1};
    scene.settings.shadowSize = 64;
    scene.settings.shadowBias = ShadowBias::Constant;
    scene.settings.shadowBiasValue = 0;
    const ShadowVerdicts none = judge(scene);
    EXPECT_GT(none.percent(ShadowVerdict::Acne), 5.0);
    scene.settings.shadowBiasValue = 100;
    const ShadowVerdicts large = judge(scene);
    EXPECT_EQ(count(large, ShadowVerdict::Acne), 0u);
    EXPECT_GT(count(large, ShadowVerdict::Leak), 50u);
}

TEST(ShadowVerdict, RaysHoldWhileOnlyTheBufferChanges) {
    const Scene scene = boxOverGround();
    Scene other = scene;
    other.settings.shadowBiasValue = 3, other.settings.shadowSize = 32, other.settings.shadowFilter = 2;
    other.settings.shadowCull = ShadowCull::Front, other.settings.shadowBias = ShadowBias::Slope;
    EXPECT_TRUE(haveSameRays(scene, other));
    other.lights[0].position.x = 1;
    EXPECT_FALSE(haveSameRays(scene, other));
}

TEST(ShadowVerdict, SaysWhyThereIsNone) {
    Scene scene = boxOverGround();
    EXPECT_EQ(whyNoShadowVerdicts(scene, 0), "");
    EXPECT_EQ(whyNoShadowVerdicts(scene, 1), "The scene has no light 1.");
    scene.lights[0].castsShadow = false;
    EXPECT_EQ(whyNoShadowVerdicts(scene, 0), "Light 0 casts no shadow.");
    scene.settings.model = Model::OpenGl;
    EXPECT_EQ(whyNoShadowVerdicts(scene, 0), "OpenGL's model has no shadows.");
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(exactShadows(boxOverGround(), 0, 1, stop.get_token()));
}

TEST(ShadowVerdict, IsABufferOfNames) {
    const ShadowVerdicts found = judge(boxOverGround());
    const AnyBuffer buffer = bufferOf(found);
    EXPECT_EQ(buffer.name, (BufferName{BufferId::ShadowVerdict, 0}));
    EXPECT_EQ(buffer.name.text(), "shadow_verdict.0");
    EXPECT_EQ(buffer.shape, (std::vector<std::size_t>{90, 120}));
    EXPECT_TRUE(isOfNames(*buffer.info));
    const auto first = std::ranges::find(found.verdicts.pixels, int(ShadowVerdict::Shadowed));
    ASSERT_NE(first, found.verdicts.pixels.end());
    EXPECT_EQ(buffer.flat(std::size_t(first - found.verdicts.pixels.begin())), 1);
    EXPECT_EQ(paletteStops(Palette::ShadowVerdict).size(), kShadowVerdictCount);
    EXPECT_EQ(paletteColor(Palette::ShadowVerdict, 1, 0, 1), paletteStops(Palette::ShadowVerdict)[1]);
    EXPECT_EQ(paletteColor(Palette::ShadowVerdict, -1, 0, 1), Color8(0)) << "no verdict: the ground of a picture";
}

}  // namespace pipeline
