// A thousand scenes, each scaled by a power of two: the same picture to the last bit, and lengths times that power.
// Multiplying by a power of two rounds nothing, so any difference is a length that the code compares with a number of its
// own: an absolute epsilon.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pipeline/scene/opacity.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

struct MetamorphicScale : testing::TestWithParam<unsigned> {
    static constexpr unsigned kScenes = 1000, kShards = 10;
};
INSTANTIATE_TEST_SUITE_P(Shards, MetamorphicScale, testing::Range(0u, MetamorphicScale::kShards));

Scene scaledBy(Scene scene, double factor) {
    for (Object& object : scene.objects) object.transform.scale *= factor, object.transform.translation *= factor;
    for (Light& light : scene.lights) {
        if (light.kind != LightKind::AtInfinity) light.position *= factor;
        light.area.width *= factor, light.area.height *= factor;
        light.gl.linear /= factor, light.gl.quadratic /= factor * factor;
    }
    Camera& camera = scene.camera;
    for (double* length : {&camera.rho, &camera.height, &camera.near, &camera.far}) *length *= factor;
    camera.eye *= factor, camera.target *= factor;
    if (scene.settings.shadowBias == ShadowBias::Constant) scene.settings.shadowBiasValue *= factor;
    return scene;
}

bool isLength(BufferId id, DepthFormat format) {
    using enum BufferId;
    return id == VerticesWorld || id == VerticesView || id == ShadowBuffer || id == ZView || id == Position ||
           (id == Depth && format == DepthFormat::Linear);
}

// The first number of the plain frame that is not, times what it should be, that of the scaled one.
std::string firstNotScaled(const Frame& plain, const Frame& scaled, double factor) {
    const DepthFormat format = plain.scene().settings.depthFormat;
    for (const AnyBuffer& a : plain.buffers()) {
        const auto b = scaled.buffer(a.name);
        if (!b || b->count() != a.count()) return a.name.text() + " has another shape";
        const bool isScreen = a.name.id == BufferId::VerticesScreen;
        const std::vector<bool> with = isScreen ? rowsWithValue(a) : std::vector<bool>();
        for (std::size_t i = 0; i < a.count(); ++i) {
            const bool depth = isScreen && with[i / 3] && i % 3 == 2 && format == DepthFormat::Linear;
            const double should = a.flat(i) * (depth || isLength(a.name.id, format) ? factor : 1);
            if (b->flat(i) != should) return a.name.text() + " number " + std::to_string(i);
        }
    }
    return {};
}

// Float has an exponent of 8 bits: products of two lengths, squared, stay in range from 2^-20 to 2^33 and not at 2^-30
// or 2^40. Double likewise from 2^-200 to 2^257.
TEST_P(MetamorphicScale, ScaledByAPowerOfTwo) {
    std::size_t covered = 0;
    for (unsigned seed = GetParam(); seed < kScenes; seed += kShards) {
        Scene scene = test::smallScene(seed);
        const bool wide = seed % 2 == 1;
        scene.settings.precision = wide ? Precision::Double : Precision::Float;
        // Where everything is as if not there, the range of depths is that of no vertex at all: 1 to 2.
        if (std::ranges::all_of(scene.objects, [&](const Object& o) { return isTransparent(o, scene.settings); }))
            scene.camera.near = 1, scene.camera.far = 9;
        const int least = wide ? -200 : -20, most = wide ? 257 : 33;
        const FramePtr plain = test::frameOf(scene, test::everyBuffer(), 1);
        for (const int k : {least, least + int(seed / 2 * 7919 % unsigned(most - least)), most}) {
            const double factor = std::ldexp(1.0, k);
            const FramePtr scaled = test::frameOf(scaledBy(scene, factor), test::everyBuffer(), 1);
            ASSERT_EQ(firstNotScaled(*plain, *scaled, factor), "") << "seed " << seed << ", 2^" << k;
        }
        const AnyBuffer seen = *plain->buffer({BufferId::ObjectId});
        for (std::size_t i = 0; i < seen.count(); ++i) covered += seen.flat(i) >= 0;
    }
    EXPECT_GT(covered, 10000u);  // pixels that show something, so that the claim is not empty
}

}  // namespace
}  // namespace pipeline
