// A thousand scenes, each turned about z by a right angle with its camera and lights, and each mirrored.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/run/frame_data.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

struct MetamorphicTurn : testing::TestWithParam<unsigned> {
    static constexpr unsigned kScenes = 1000, kShards = 10;
};
INSTANTIATE_TEST_SUITE_P(Shards, MetamorphicTurn, testing::Range(0u, MetamorphicTurn::kShards));

Vec3d turned(Vec3d v) { return {-v.y, v.x, v.z}; }

Scene turned(Scene scene) {
    for (Object& object : scene.objects) {
        object.transform.rotation.z += 90;
        object.transform.translation = turned(object.transform.translation);
    }
    for (Light& light : scene.lights) {
        light.position = turned(light.position);
        light.area.facing = turned(light.area.facing);
        light.gl.spotDirection = turned(light.gl.spotDirection);
    }
    scene.camera.eye = turned(scene.camera.eye), scene.camera.target = turned(scene.camera.target);
    scene.camera.theta += 90;
    return scene;
}

bool isInWorldSpace(BufferId id) {
    using enum BufferId;
    return id == VerticesWorld || id == PolygonsNormal || id == VerticesNormal || id == Position || id == Normal ||
           id == ViewVector || id == LightVector || id == ReflectionVector || id == HalfwayVector;
}

std::string firstNotTurned(const Frame& plain, const Frame& other) {
    for (const AnyBuffer& a : plain.buffers()) {
        if (a.name.id == BufferId::ShadowBuffer) continue;  // a point light's sides change places
        const auto b = other.buffer(a.name);
        if (!b || b->count() != a.count()) return a.name.text() + " has another shape";
        for (std::size_t i = 0; i < a.count(); ++i) {
            double should = a.flat(i);
            if (isInWorldSpace(a.name.id) && i % 3 < 2) should = i % 3 == 0 ? -a.flat(i + 1) : a.flat(i - 1);
            if (b->flat(i) != should)
                return fmt::format("{} number {}: {} and {}", a.name.text(), i, b->flat(i), should);
        }
    }
    return {};
}

// sin and cos of degrees are exact here (90 is taken off before the irrational factor comes in), a row of the turned
// matrix is another one or its negative, and the three terms of a dot product are added as (x + y) + z: with x and y
// exchanged the same sum. So nothing is within a bound, all is the same bits. But what a light sees is drawn on axes of
// the world's own, which do not turn with the scene: only a light at infinity whose axes are built on z sees the same
// picture, one for which the direction's z is the least. The others cast no shadow here.
TEST_P(MetamorphicTurn, TurnedByARightAngle) {
    for (unsigned seed = GetParam(); seed < kScenes; seed += kShards) {
        Scene scene = test::smallScene(seed);
        if (seed % 3 == 0) scene.settings.precision = Precision::Double;
        if (seed % 7 == 0) scene.settings.visibility = Visibility::Painter;
        for (Light& light : scene.lights) {
            const Vec3d p = glm::abs(light.position);
            if (light.kind != LightKind::AtInfinity) light.castsShadow = false;
            if (!(p.z < p.x && p.z < p.y)) light.position.z = std::min(p.x, p.y) / 2;
        }
        const FramePtr plain = test::frameOf(scene, test::everyBuffer(), 1);
        for (int turns = 1; turns <= 3; ++turns) {
            const FramePtr before = test::frameOf(scene, test::everyBuffer(), 1);
            scene = turned(scene);
            ASSERT_EQ(firstNotTurned(*before, *test::frameOf(scene, test::everyBuffer(), 1)), "") << "seed " << seed;
        }
    }
}

// x of the world becomes -x: in scale, two of the three rotations, places and directions. The camera's right becomes
// the negative of its mirror image, as it must: the picture is mirrored.
Scene mirrored(Scene scene) {
    for (Object& object : scene.objects) {
        ObjectTransform& t = object.transform;
        t.scale.x = -t.scale.x, t.translation.x = -t.translation.x;
        t.rotation.y = -t.rotation.y, t.rotation.z = -t.rotation.z;
    }
    for (Light& light : scene.lights) {
        light.position.x = -light.position.x;
        light.gl.spotDirection.x = -light.gl.spotDirection.x;
    }
    scene.camera.eye.x = -scene.camera.eye.x, scene.camera.target.x = -scene.camera.target.x;
    return scene;
}

// The pixels whose sample lies exactly on an edge of a triangle, snapped; the top-left rule gives those to one side,
// and in a mirror to the other.
std::vector<bool> samplesOnEdges(const Frame& frame) {
    const FrameData<double>& data = *dataOf<double>(frame);
    const View& view = data.transform->view;
    std::vector<bool> on(std::size_t(view.size.x) * std::size_t(view.size.y));
    const std::vector<Vec3d> places = viewPlaces(*data.transform);
    const auto mark = [&](const RasterTriangle<double>& triangle) {
        const auto& c = triangle.snapped.corners;
        for (int y = 0; y < view.size.y; ++y)
            for (int x = 0; x < view.size.x; ++x) {
                const std::int64_t e[]{EdgeFunction(c[0], c[1]).atPixel({x, y}),
                                       EdgeFunction(c[1], c[2]).atPixel({x, y}),
                                       EdgeFunction(c[2], c[0]).atPixel({x, y})};
                if (e[0] >= 0 && e[1] >= 0 && e[2] >= 0 && (e[0] == 0 || e[1] == 0 || e[2] == 0))
                    on[std::size_t(y * view.size.x + x)] = true;
            }
    };
    for (const Triangle& t : data.transform->topology->triangles)
        setUpTriangle<double>(view, {places[t.vertices[0]], places[t.vertices[1]], places[t.vertices[2]]}, 0, mark);
    return on;
}

// Every coordinate is the same but for its sign, so every sample that lies on no edge has the same fragments, and flat
// shading the same intensities, bit for bit. A triangle's corners run the other way round, so its depth is summed in
// another order: w = w0 + l1 (w1 - w0) + l2 (w2 - w0), where all terms are >= 0 in perspective and at most 3 max |z| in
// all in orthographic projection. Two roundings on either side are within 4 u of that, and the reciprocal within 2 u
// more (u = 2^-53).
TEST_P(MetamorphicTurn, Mirrored) {
    std::size_t covered = 0, onEdges = 0;
    for (unsigned seed = GetParam(); seed < kScenes; seed += kShards) {
        Scene scene = test::smallScene(seed);
        scene.settings.precision = Precision::Double;
        scene.settings.depthFormat = DepthFormat::Linear;
        scene.settings.shading = Shading::Flat;
        scene.camera.kind = CameraKind::LookAt;
        for (Light& light : scene.lights) light.castsShadow = false;  // what a light sees is not mirrored: see above
        for (Object& object : scene.objects) object.material.alpha = 1;
        const FramePtr plain = test::frameOf(scene, test::everyBuffer(), 1);
        const FramePtr other = test::frameOf(mirrored(scene), test::everyBuffer(), 1);
        double deepest = 0;
        for (const Vec3d& v : viewPlaces(*dataOf<double>(*plain)->transform))
            deepest = std::max(deepest, std::abs(v.z));
        const std::vector<bool> on = samplesOnEdges(*plain);
        const int width = scene.settings.width, height = scene.settings.height;
        const auto same = [&](BufferId id, int x, int y) {
            const AnyBuffer a = *plain->buffer({id}), b = *other->buffer({id});
            const auto column = std::size_t(x), row = std::size_t(y), back = std::size_t(width - 1 - x);
            for (int c = 0; c < a.channels(); ++c)
                if (a.value(column, row, c) != b.value(back, row, c)) return false;
            return true;
        };
        const AnyBuffer z = *plain->buffer({BufferId::ZView}), zOther = *other->buffer({BufferId::ZView});
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                if (on[std::size_t(y * width + x)]) {
                    ++onEdges;
                    continue;
                }
                for (const BufferId id : {BufferId::ObjectId, BufferId::PolygonId, BufferId::Overdraw,
                                          BufferId::Intensity, BufferId::Color})
                    ASSERT_TRUE(same(id, x, y)) << bufferInfo(id).name << " at " << x << ' ' << y << ", seed " << seed;
                const double a = z.value(std::size_t(x), std::size_t(y));
                if (!std::isfinite(a)) continue;
                ++covered;
                ASSERT_LE(std::abs(a - zOther.value(std::size_t(width - 1 - x), std::size_t(y))), 0x1p-49 * deepest)
                    << "seed " << seed;
            }
    }
    EXPECT_GT(covered, 10000u);
    EXPECT_LT(onEdges, covered / 20);
}

}  // namespace
}  // namespace pipeline
