// The arithmetic `fast` against `exact`, and against double.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>

#include "pipeline/fast/shade_pixels.h"
#include "pipeline/run/frame_data.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

// Three spheres of different materials in and out of each other's shadow, Phong shaded, in a picture whose width no
// vector divides.
Scene spheres() {
    Scene scene = test::pyramid();
    scene.settings.width = 333, scene.settings.height = 241;
    scene.settings.shading = Shading::Phong;
    scene.settings.shadowSize = 256;
    Object object = scene.objects[0];
    object.transform = {Vec3d(1), Vec3d(0), Vec3d(0)};
    object.mesh = test::sphere(150, 24, 40);
    scene.objects.assign(3, object);
    scene.objects[1].transform.translation = {180, 60, 90};
    scene.objects[1].material = {{0.9, 0.3, 0.2}, Vec3d(0), 1};
    scene.objects[2].transform.translation = {-160, 120, 30};
    scene.objects[2].material.exponent = 300;
    scene.lights.push_back({LightKind::Point, {300, 300, 500}, 60, {0.5, 1, 0.7}, false});
    return scene;
}

Scene in(Scene scene, Arithmetic arithmetic) {
    scene.settings.arithmetic = arithmetic;
    return scene;
}

FramePtr picture(const Scene& scene) { return test::frameOf(scene, setOf({BufferId::Color})); }

bool ranFast(const Frame& frame) {
    return readStages(frame, [](const auto& data) { return data.keys.shading.parts.fast; });
}

// Of the intensities, in units of the one that 255 stands for: how many differ by more than 1/255, and of how many.
struct Difference {
    int beyond = 0, pixels = 0;
};
Difference difference(const Frame& a, const Frame& b) {
    const auto p = a.buffer({BufferId::Intensity}), q = b.buffer({BufferId::Intensity});
    const auto polygonA = a.buffer({BufferId::PolygonId}), polygonB = b.buffer({BufferId::PolygonId});
    const double iMax = readStages(a, [](const auto& data) { return data.shading->iMax; });
    Difference found;
    for (std::size_t i = 0; i < polygonA->count(); ++i) {
        if (polygonA->flat(i) < 0 || polygonA->flat(i) != polygonB->flat(i)) continue;
        ++found.pixels;
        bool far = false;
        for (std::size_t c = 0; c < 3; ++c)
            far = far || !(std::abs(p->flat(3 * i + c) - q->flat(3 * i + c)) <= iMax / 255);
        found.beyond += far;
    }
    return found;
}

// Where no shadow's edge runs, every pixel; the edges are compared below.
void expectAlike(Scene scene) {
    for (Light& light : scene.lights) light.castsShadow = false;
    const FramePtr fast = picture(in(scene, Arithmetic::Fast));
    ASSERT_TRUE(ranFast(*fast));
    const Difference toExact = difference(*fast, *picture(in(scene, Arithmetic::Exact)));
    EXPECT_GT(toExact.pixels, 1000);
    EXPECT_EQ(toExact.beyond, 0);
    scene.settings.precision = Precision::Double;
    EXPECT_EQ(difference(*fast, *picture(scene)).beyond, 0);
}

TEST(Fast, IsWithinOneOf255OfExactAndOfDouble) { expectAlike(spheres()); }

TEST(Fast, HasBothModelsAndBothLobes) {
    Scene scene = spheres();
    scene.settings.model = Model::BlinnPhong;
    scene.lights[0].intensity = 0.8, scene.lights[1].intensity = 0.4, scene.ambient.intensity = 0.2;
    scene.objects[1].material.specular = Vec3d(0.5), scene.objects[1].material.highlight = Highlight::Phong;
    expectAlike(scene);
}

TEST(Fast, HasFlatAndGouraudShadingInEveryModel) {
    for (const Shading shading : {Shading::Flat, Shading::Gouraud}) {
        for (const Model model : {Model::Phong, Model::BlinnPhong, Model::OpenGl}) {
            Scene scene = spheres();
            scene.settings.shading = shading, scene.settings.model = model;
            if (model != Model::Phong)
                scene.lights[0].intensity = 0.8, scene.lights[1].intensity = 0.4, scene.ambient.intensity = 0.2;
            expectAlike(scene);
        }
    }
}

TEST(Fast, HasOrthographicViews) {
    Scene scene = spheres();
    scene.camera.projection = ProjectionKind::Orthographic;
    expectAlike(scene);
}

// Highlights of a great exponent lie in a few pixels, where 1 - a·b has to keep its digits.
TEST(Fast, KeepsNarrowHighlights) {
    Scene scene = spheres();
    for (Object& object : scene.objects) object.material.specular = Vec3d(1), object.material.exponent = 1e5;
    expectAlike(scene);
}

// A camera among the polygons: the near plane cuts some.
TEST(Fast, HasPolygonsThatTheNearPlaneCuts) {
    Scene scene = spheres();
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, 0, 151}, scene.camera.target = {180, 60, 90}, scene.camera.near = 5;
    expectAlike(scene);
}

// A shadow's edge is decided by comparing distances, and a rounding may decide it: of twenty pixels in shadow at most one
// differs.
TEST(Fast, ThrowsTheSameShadows) {
    for (const Shading shading : {Shading::Flat, Shading::Gouraud, Shading::Phong}) {
        for (const LightKind kind : {LightKind::AtInfinity, LightKind::Point, LightKind::Area}) {
            const int filter = shading == Shading::Flat ? 0 : 1;
            Scene scene = spheres();
            scene.settings.shading = shading;
            scene.lights[0].kind = kind;
            scene.lights[0].area = {{-1, -1, -1}, 80, 80, 2};
            scene.lights[1].castsShadow = true;
            scene.settings.shadowFilter = filter;
            const FramePtr fast = picture(in(scene, Arithmetic::Fast)), exact = picture(in(scene, Arithmetic::Exact));
            ASSERT_TRUE(ranFast(*fast));
            const Difference found = difference(*fast, *exact);
            for (Light& light : scene.lights) light.castsShadow = false;
            const int shadowed = difference(*fast, *picture(in(scene, Arithmetic::Exact))).beyond;
            EXPECT_GT(shadowed * 100, found.pixels);  // there are shadows
            EXPECT_LE(found.beyond * 20, shadowed) << "shading " << int(shading) << ", kind " << int(kind);
        }
    }
}

TEST(Fast, LeavesTheOtherBuffersToTheBit) {
    const Scene scene = spheres();
    BufferSet others;
    for (const BufferInfo& info : bufferTable()) others[index(info.id)] = info.stage != StageId::Shading;
    const BufferSet wanted = others | setOf({BufferId::Color});
    EXPECT_EQ(test::firstDifference(*test::frameOf(in(scene, Arithmetic::Fast), wanted),
                                    *test::frameOf(in(scene, Arithmetic::Exact), wanted), others),
              "");
}

// Weights and counts are kept where somebody asks for them, and a frame that has them serves one that needs less.
TEST(Fast, KeepsWeightsAndCountsForWhoAsks) {
    const Scene scene = in(spheres(), Arithmetic::Fast);
    const FramePtr less = test::frameOf(scene, setOf({BufferId::Color}));
    EXPECT_FALSE(less->buffer({BufferId::Overdraw}));
    EXPECT_EQ(less->whyAbsent({BufferId::Overdraw}), "Nobody has asked for it yet.");
    EXPECT_FALSE(less->buffer({BufferId::Barycentric}));
    const FramePtr more = test::frameOf(scene, setOf({BufferId::Overdraw, BufferId::Barycentric}), 0, less);
    EXPECT_EQ(more->plan()[index(StageId::ZBuffer)].why, "Other buffers are asked for.");
    EXPECT_TRUE(more->buffer({BufferId::Overdraw}) && more->buffer({BufferId::Barycentric}));
    const FramePtr again = test::frameOf(scene, setOf({BufferId::Color}), 0, more);
    EXPECT_EQ(again->plan()[index(StageId::ZBuffer)].action, Action::Reuse);
}

TEST(Fast, CountsWhatExactCounts) {
    const auto tallies = [](const Scene& scene) {
        const FramePtr frame = picture(scene);
        std::map<std::string_view, long long> done;
        for (const Tally& tally : frame->run(StageId::Shading).tallies) done[tally.what] = tally.done;
        return done;
    };
    auto fast = tallies(in(spheres(), Arithmetic::Fast)), exact = tallies(in(spheres(), Arithmetic::Exact));
    for (const auto what : {"light evaluations", "tiles"}) EXPECT_EQ(fast[what], exact[what]) << what;
    // Where a dot product is 0 but for its rounding, one of the two may see it above 0.
    for (const auto what : {"powers", "shadow look-ups"})
        EXPECT_NEAR(double(fast[what]), double(exact[what]), double(exact[what]) / 100) << what;
}

TEST(Fast, GivesWayWhereItHasNoKernel) {
    const auto reason = [](const Scene& scene, BufferSet wanted) {
        const FramePtr frame = test::frameOf(in(scene, Arithmetic::Fast), wanted);
        EXPECT_FALSE(ranFast(*frame));
        for (const PlanPart& part : frame->plan()[index(StageId::Shading)].parts)
            if (part.name == "fast arithmetic") return part.why;
        return std::string("not said");
    };
    const BufferSet color = setOf({BufferId::Color});
    EXPECT_EQ(reason(spheres(), setOf({BufferId::NDotL})), "The buffer n_dot_l is asked for, which it does not leave.");
    Scene scene = spheres();
    scene.settings.precision = Precision::Double;
    EXPECT_EQ(reason(scene, color), "It computes in float alone.");
    scene = spheres();
    scene.settings.interpolation = Interpolation::Scanline;
    EXPECT_EQ(reason(scene, color), "It interpolates in perspective alone.");
    scene = spheres();
    scene.settings.model = Model::OpenGl;
    EXPECT_EQ(reason(scene, color), "In OpenGL's model it shades by polygon or by vertex alone.");
    scene = spheres();
    scene.settings.forms.power = PowerForm::Schlick;
    EXPECT_EQ(reason(scene, color), "It has the stable forms of formulas alone.");
    // And then every bit is that of exact arithmetic.
    EXPECT_EQ(
        test::firstDifference(*picture(in(scene, Arithmetic::Fast)), *picture(in(scene, Arithmetic::Exact)), color),
        "");
}

// The stages' own text, a pixel at a time, against the vectors that the runner takes in float.
void expectTheSameBits(const Scene& scene) {
    const FramePtr frame = test::frameOf(scene, setOf({BufferId::Color, BufferId::Overdraw, BufferId::Barycentric}));
    const FrameData<float>& data = *dataOf<float>(*frame);
    const TransformOutput<float>& in = *data.transform;
    TransformOutput<float> transformed = prepareTransform<float>(data.keys.transform);
    for (std::size_t object = 0; object < scene.objects.size(); ++object)
        transform(data.keys.transform, object, 0, in.topology->meshes[object]->positions.size(), transformed);
    EXPECT_EQ(transformed.world, in.world);
    EXPECT_EQ(transformed.viewSpace, in.viewSpace);
    EXPECT_EQ(transformed.screen, in.screen);
    if (data.cull) {
        CullOutput culled = prepareCull(in.topology->polygonCount());
        cull(data.keys.cull, in, 0, in.topology->polygonCount(), culled);
        EXPECT_EQ(culled.verdicts, data.cull->verdicts);
        EXPECT_EQ(culled.signedAreas, data.cull->signedAreas);
        EXPECT_EQ(culled.inside, data.cull->inside);
    }
    const TriangleBins<float> bins = binTriangles<float>(*in.topology, in.view, in.viewSpace, data.verdicts());
    ZBufferOutput<float> out = prepareZBuffer<float>({{0, 0}, in.view.size}, DepthFormat::Linear);
    for (std::size_t tile = 0; tile < bins.bins.size(); ++tile)
        zBuffer(in.view, DepthFormat::Linear, bins, bins.bins[tile], bins.tile(tile), out);
    EXPECT_EQ(out.zView.pixels, data.zBuffer->zView.pixels);
    EXPECT_EQ(out.triangle.pixels, data.zBuffer->triangle.pixels);
    EXPECT_EQ(out.barycentric.pixels, data.zBuffer->barycentric.pixels);
    EXPECT_EQ(out.overdraw.pixels, data.zBuffer->overdraw.pixels);
    EXPECT_EQ(out.depthWrites.pixels, data.zBuffer->depthWrites.pixels);
    const auto sum = [](const Buffer2D<std::int32_t>& counts) {
        return std::accumulate(counts.pixels.begin(), counts.pixels.end(), 0LL);
    };
    EXPECT_EQ(sum(out.overdraw), data.zBuffer->arrived);
    EXPECT_EQ(sum(out.depthWrites), data.zBuffer->won);
    for (int y = 0; y < in.view.size.y; y += 7)
        for (int x = 0; x < in.view.size.x; x += 5) {
            const std::uint32_t id = out.triangle.at({x, y});
            if (id == kNoTriangle) continue;
            EXPECT_EQ(barycentricAt(in, id, {x, y}), out.barycentric.at({x, y}));
        }
    if (!data.shadowBuffer) return;
    for (const auto& samples : data.shadowBuffer->lights) {
        for (const LightView<float>& light : samples) {
            for (std::size_t face = 0; face < light.faces.size(); ++face) {
                const TriangleBins<float> seen = binForLight(in, light.faces[face]);
                Buffer2D<float> depth(light.faces[face].size, std::numeric_limits<float>::infinity());
                for (std::size_t tile = 0; tile < seen.bins.size(); ++tile)
                    shadowBuffer(light.faces[face], seen, tile, depth);
                EXPECT_EQ(depth.pixels, light.depth[face].pixels);
            }
        }
    }
}

TEST(Vectors, RasterizeToTheSameBits) {
    Scene scene = spheres();
    scene.objects.push_back(scene.objects[0]);  // ties at every pixel of it
    expectTheSameBits(scene);
    scene.lights[0].kind = LightKind::Point;
    scene.camera.projection = ProjectionKind::Orthographic;
    expectTheSameBits(scene);
    for (unsigned seed = 0; seed < 60; ++seed) {
        Scene random = test::randomScene(seed);
        random.settings.precision = Precision::Float, random.settings.depthFormat = DepthFormat::Linear;
        random.settings.visibility = Visibility::ZBuffer;
        for (Object& object : random.objects) object.material.alpha = 1;
        if (random.settings.antialiasing == 1) expectTheSameBits(random);
    }
}

// Edge functions beyond what double holds: a triangle from one end of the guard band to the other.
TEST(Vectors, RasterizeHugeTrianglesToTheSameBits) {
    Scene scene = test::pyramid();
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {1, 1, 10}, scene.camera.target = {1.3, 1.1, 0}, scene.camera.up = {0, 1, 0};
    scene.camera.near = 1e-3, scene.camera.far = 1e6;
    scene.objects[0].transform.scale = Vec3d(1000);
    for (const int bits : {1, 8, 12, 16}) {
        scene.settings.subPixelBits = bits;
        expectTheSameBits(scene);
    }
}

TEST(Fast, TakesSeveralPixelsAtATime) {
    EXPECT_GE(fastLanes(), 4);
    EXPECT_LE(fastLanes(), 16);
}

}  // namespace
}  // namespace pipeline
