// Every scene that comes with the program, as its stages draw it and as rays see its polygons: the two share no code
// above the scene itself, so that where they agree both are right.
#include <gtest/gtest.h>

#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/study/ray_caster.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

class RayScenes : public testing::TestWithParam<BuiltInScene> {};
INSTANTIATE_TEST_SUITE_P(Scenes, RayScenes, testing::ValuesIn(builtInScenes()),
                         [](const auto& of) { return of.param.name; });

// What a buffer of the reference takes on in the nine pixels around one, if they all show the same object.
struct Around {
    bool isOneObject = true;
    Vec3d low{std::numeric_limits<double>::infinity()}, high = -low;
    double range() const { return largest(high - low); }
    static double largest(Vec3d v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }
};
template <class Value>
Around around(const Picture& picture, glm::ivec2 p, Value value) {
    Around out;
    for (int y = std::max(0, p.y - 1); y <= std::min(picture.size.y - 1, p.y + 1); ++y)
        for (int x = std::max(0, p.x - 1); x <= std::min(picture.size.x - 1, p.x + 1); ++x) {
            out.isOneObject = out.isOneObject && picture.object.at({x, y}) == picture.object.at(p);
            const Vec3d v = value(picture.object.offset({x, y}));
            out.low = glm::min(out.low, v), out.high = glm::max(out.high, v);
        }
    return out;
}

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
    if (!whyNoRays(scene, RaySurfaces::Polygons).empty()) GTEST_SKIP() << whyNoRays(scene, RaySurfaces::Polygons);

    const Picture rays = rayCast(scene, RaySurfaces::Polygons, 0)->picture;
    const FramePtr frame = test::frameOf(scene);
    const AnyBuffer ids = *frame->buffer({BufferId::ObjectId}), z = *frame->buffer({BufferId::ZView});
    const AnyBuffer intensity = *frame->buffer({BufferId::Intensity});
    // Snapping moves a sample by up to sqrt 2 / 512 pixel against its triangle, and turns triangles of a few pixels by
    // as much: a few hundredths of what neighbours differ by, where they show the same thing.
    constexpr double kSnapped = 0.02;
    int seen = 0, shadows = 0;
    for (std::size_t i = 0; i < ids.count(); ++i) {
        const glm::ivec2 p{int(i % 160), int(i / 160)};
        const Around depth = around(rays, p, [&](std::size_t at) { return Vec3d(rays.zView.pixels[at]); });
        if (!depth.isOneObject) continue;
        ASSERT_EQ(ids.flat(i), rays.object.pixels[i]) << p.x << ", " << p.y;
        if (ids.flat(i) < 0) continue;
        ++seen;
        const double zError = std::abs(z.flat(i) - rays.zView.pixels[i]);
        ASSERT_LE(zError, kSnapped * depth.range() + 1e-13 * rays.zView.pixels[i]) << p.x << ", " << p.y;
        bool sameShadows = true;
        for (std::size_t k = 0; k < scene.lights.size(); ++k) {
            const double s = frame->buffer({BufferId::Shadow, int(k)})->flat(i);
            sameShadows = sameShadows && (scene.lights[k].intensity == 0 || s == rays.shadow[k].pixels[i]);
        }
        shadows += !sameShadows;
        if (!sameShadows) continue;
        const Around light = around(rays, p, [&](std::size_t at) { return rays.intensity.pixels[at]; });
        const Vec3d ours{intensity.flat(3 * i), intensity.flat(3 * i + 1), intensity.flat(3 * i + 2)};
        ASSERT_LE(Around::largest(ours - rays.intensity.pixels[i]),
                  kSnapped * light.range() + 1e-12 * Around::largest(ours))
            << p.x << ", " << p.y;
    }
    EXPECT_GT(seen, 60);
    const bool soft = std::ranges::any_of(scene.lights, [](const Light& l) { return l.kind == LightKind::Area; });
    EXPECT_LE(shadows, soft ? seen / 5 : seen / 100);
}

}  // namespace
}  // namespace pipeline
