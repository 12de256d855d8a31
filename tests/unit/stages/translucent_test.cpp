#include "pipeline/stages/translucent.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "pipeline/run/frame_data.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

// An upright square of side 2 around (0, y, 0), seen from the front.
std::shared_ptr<const Mesh> square(double y, double half = 1) {
    return test::mesh({{-half, y, -half}, {half, y, -half}, {half, y, half}, {-half, y, half}}, {{0, 1, 2, 3}});
}

// Seen from the origin along +y with z up; ambient light of 100 alone, so that a grey k_d of 0.2 is an intensity of 20.
Scene seenAlongY() {
    Scene scene;
    scene.settings.width = scene.settings.height = 64;
    scene.settings.precision = Precision::Double;
    scene.settings.cull = CullMode::None;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, 0, 0}, scene.camera.target = {0, 1, 0}, scene.camera.fovY = 60;
    scene.camera.near = 1, scene.camera.far = 100;
    scene.ambient.intensity = 100;
    return scene;
}
void add(Scene& scene, std::shared_ptr<const Mesh> mesh, double grey, double alpha = 1) {
    scene.objects.push_back({"object", std::move(mesh), {}, {Vec3d(grey), Vec3d(0), 1}});
    scene.objects.back().material.alpha = alpha;
}

// A wall of 80 behind a pane of 40 that hides a quarter, behind a pane of 20 that hides half. The nearer pane is
// drawn first: order must come from depth.
Scene twoPanes() {
    Scene scene = seenAlongY();
    add(scene, square(4), 0.2, 0.5);
    add(scene, square(8, 3), 0.4, 0.25);
    add(scene, square(12, 4), 0.8);
    return scene;
}

double value(const Frame& frame, BufferId id, glm::ivec2 pixel) {
    return frame.buffer({id})->value(std::size_t(pixel.x), std::size_t(pixel.y));
}
std::string difference(const Scene& a, const Scene& b, BufferSet compared) {
    return test::firstDifference(*test::frameOf(a), *test::frameOf(b), compared);
}
const BufferSet kColors = setOf({BufferId::Color, BufferId::Intensity});

// 0.25·40 + 0.75·80 = 70, then 0.5·20 + 0.5·70 = 45: of the wall 0.375 is left, 30, and the panes add 0.5·10 + 10.
TEST(Translucent, TwoPanesOverAWall) {
    for (int format = 0; format < 6; ++format) {
        for (const Translucency order : {Translucency::Exact, Translucency::Polygons}) {
            Scene scene = twoPanes();
            scene.settings.depthFormat = DepthFormat(format);
            scene.settings.translucency = order;
            const FramePtr frame = test::frameOf(scene);
            const glm::ivec2 middle{32, 32};
            EXPECT_NEAR(value(*frame, BufferId::Intensity, middle), 45, 1e-12);
            EXPECT_NEAR(value(*frame, BufferId::Transmittance, middle), 0.375, 1e-15);
            EXPECT_NEAR(value(*frame, BufferId::Translucent, middle), 15, 1e-12);
            EXPECT_EQ(value(*frame, BufferId::Layers, middle), 2);
            EXPECT_EQ(value(*frame, BufferId::Ambient, middle), 80);
            EXPECT_EQ(value(*frame, BufferId::PolygonId, middle), 2) << "the opaque surface's";
            EXPECT_EQ(value(*frame, BufferId::Overdraw, middle), 1);
        }
    }
}

TEST(Translucent, OverTheBackgroundOnlyTheLayersCount) {
    Scene scene = twoPanes();
    scene.objects.pop_back();
    const FramePtr frame = test::frameOf(scene);
    EXPECT_NEAR(value(*frame, BufferId::Intensity, {32, 32}), 15, 1e-12);
    EXPECT_EQ(value(*frame, BufferId::ObjectId, {32, 32}), -1);
    EXPECT_EQ(value(*frame, BufferId::ZView, {32, 32}), std::numeric_limits<double>::infinity());
    // I_max is 40: 255·15/40 = 95.6.
    EXPECT_EQ(value(*frame, BufferId::Color, {32, 32}), 96);
}

TEST(Translucent, WhatIsOpaqueHidesTheLayersBehindIt) {
    Scene scene = twoPanes();
    add(scene, square(6, 4), 0.6);  // between the panes
    const FramePtr frame = test::frameOf(scene);
    EXPECT_EQ(value(*frame, BufferId::Layers, {32, 32}), 1);
    EXPECT_NEAR(value(*frame, BufferId::Intensity, {32, 32}), 0.5 * 20 + 0.5 * 60, 1e-12);
    // A painted picture compares with what is seen.
    scene.settings.visibility = Visibility::Painter;
    EXPECT_EQ(difference(
                  scene,
                  [&] {
                      Scene other = scene;
                      other.settings.visibility = Visibility::ZBuffer;
                      return other;
                  }(),
                  kColors),
              "");
}

TEST(Translucent, AlphaOfOneOrMoreIsOpaque) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        Scene scene = test::randomScene(seed);
        for (Object& object : scene.objects) object.material.alpha = 1;
        Scene more = scene, forced = scene;
        for (Object& object : more.objects) object.material.alpha = 7;
        forced.settings.leaveOut = false;
        const FramePtr frame = test::frameOf(scene);
        EXPECT_EQ(test::firstDifference(*frame, *test::frameOf(more)), "") << seed;
        EXPECT_EQ(test::firstDifference(*frame, *test::frameOf(forced), kColors), "") << seed;
    }
}

// Also of the shadows, the depth range and I_max: the last object is far away, large and bright.
TEST(Translucent, AlphaOfZeroOrLessIsAsIfTheObjectWereNotThere) {
    BufferSet compared;
    for (const BufferInfo& info : bufferTable())
        compared[index(info.id)] = info.domain == Domain::Pixel || info.domain == Domain::Texel;
    int seen = 0;
    for (unsigned seed = 0; seed < 24; ++seed) {
        const Scene without = test::randomScene(seed);
        Scene with = without;
        with.objects.push_back({"ghost", test::sphere(3, 6, 8), {{2, 2, 2}, {}, {1, 9, 2}}, {Vec3d(1), Vec3d(1), 9}});
        for (const double alpha : {0.0, -5.0}) {
            with.objects.back().material.alpha = alpha;
            EXPECT_EQ(difference(with, without, compared), "") << seed;
        }
        with.settings.leaveOut = false;
        EXPECT_EQ(difference(with, without, kColors), "") << seed;
        with.objects.back().material.alpha = 0.5;
        seen += !difference(with, without, compared).empty();
    }
    EXPECT_GT(seen, 12) << "in most scenes something of it is there at all";
}

TEST(Translucent, CastsAFullShadow) {
    Scene scene = test::pyramid();
    scene.objects.push_back(scene.objects[0]);
    scene.objects[1].transform.translation = {200, 200, 100};
    Scene translucent = scene;
    translucent.objects[1].material.alpha = 0.25;
    EXPECT_EQ(difference(scene, translucent, setOf({BufferId::ShadowBuffer})), "");
}

TEST(Translucent, ExactOrderDoesNotDependOnTheOrderOfObjects) {
    std::mt19937 random(7);
    Scene scene = seenAlongY();
    for (int i = 0; i < 12; ++i) {
        const auto coordinate = [&] { return double(random() % 1000) / 500 - 1; };
        const auto corner = [&] { return Vec3d{2 * coordinate(), 8 + 3 * coordinate(), 2 * coordinate()}; };
        add(scene, test::mesh({corner(), corner(), corner()}, {{0, 1, 2}}), 0.05 * (i + 1), 0.1 + 0.07 * i);
    }
    const FramePtr first = test::frameOf(scene);
    EXPECT_GT(statistics(*first->buffer({BufferId::Layers})).max, 3);
    for (int run = 0; run < 10; ++run) {
        std::shuffle(scene.objects.begin(), scene.objects.end(), random);
        EXPECT_EQ(test::firstDifference(*first, *test::frameOf(scene), kColors), "") << run;
    }
}

TEST(Translucent, TiesAreLaidByNumber) {
    Scene scene = seenAlongY();
    add(scene, square(4), 0.2, 0.5);
    add(scene, square(4), 0.6, 0.5);
    for (const Translucency order : {Translucency::Exact, Translucency::Polygons}) {
        scene.settings.translucency = order;
        EXPECT_NEAR(value(*test::frameOf(scene), BufferId::Intensity, {32, 32}), 0.5 * 60 + 0.25 * 20, 1e-12);
    }
}

// Three bars around the line of sight, each before the next and behind the one before.
struct Bar {
    Vec3d corners[4];
    double grey, alpha;
};
std::vector<Bar> bars() {
    std::vector<Bar> out;
    for (int i = 0; i < 3; ++i) {
        const double angle = i * 2 * 3.14159265358979323846 / 3;
        const auto turned = [&](double x, double y, double z) {
            return Vec3d(x * std::cos(angle) - z * std::sin(angle), y, x * std::sin(angle) + z * std::cos(angle));
        };
        out.push_back({{turned(-4, 9, -1.5), turned(4, 11, -1.5), turned(4, 11, -0.5), turned(-4, 9, -0.5)},
                       0.2 + 0.3 * i,
                       0.4 + 0.15 * i});
    }
    return out;
}
Scene cycle(Translucency order) {
    Scene scene = seenAlongY();
    scene.settings.translucency = order;
    for (const Bar& bar : bars())
        add(scene, test::mesh({bar.corners[0], bar.corners[1], bar.corners[2], bar.corners[3]}, {{0, 1, 2, 3}}),
            bar.grey, bar.alpha);
    return scene;
}

// A ray from the eye through the pixel's centre, its crossings with the bars laid over one another from the farthest
// to the nearest. Nothing where it passes an edge so closely that snapping to 1/256 pixel may decide.
std::optional<double> rayIntensity(glm::ivec2 pixel) {
    const double scale = 32 / std::tan(3.14159265358979323846 / 6);  // pixels per unit at distance 1
    const Vec3d ray{(pixel.x + 0.5 - 32) / scale, 1, (32 - pixel.y - 0.5) / scale};
    std::vector<std::pair<double, const Bar*>> crossings;
    static const std::vector<Bar> kBars = bars();
    for (const Bar& bar : kBars) {
        const Vec3d normal = glm::cross(bar.corners[1] - bar.corners[0], bar.corners[3] - bar.corners[0]);
        const double t = glm::dot(normal, bar.corners[0]) / glm::dot(normal, ray);
        double inside = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 4; ++i) {
            const Vec3d from = bar.corners[i], along = bar.corners[(i + 1) % 4] - from;
            const Vec3d inwards = glm::normalize(glm::cross(normal, along));
            inside = std::min(inside, glm::dot(inwards, t * ray - from));
        }
        if (std::abs(inside) < 0.05) return {};  // 0.05 units at distance 9 to 11 is a quarter of a pixel
        if (inside > 0) crossings.push_back({t, &bar});
    }
    std::ranges::sort(crossings, [](const auto& a, const auto& b) { return a.first > b.first; });
    double intensity = 0;
    for (const auto& [t, bar] : crossings) intensity = bar->alpha * 100 * bar->grey + (1 - bar->alpha) * intensity;
    return intensity;
}

TEST(Translucent, ExactIsRightInACycleAndPolygonsAreNot) {
    const FramePtr exact = test::frameOf(cycle(Translucency::Exact));
    const FramePtr polygons = test::frameOf(cycle(Translucency::Polygons));
    int compared = 0, wrong = 0, doubled = 0;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const auto expected = rayIntensity({x, y});
            if (!expected) continue;
            ++compared;
            doubled += value(*exact, BufferId::Layers, {x, y}) == 2;
            ASSERT_NEAR(value(*exact, BufferId::Intensity, {x, y}), *expected, 1e-9) << x << ' ' << y;
            wrong += std::abs(value(*polygons, BufferId::Intensity, {x, y}) - *expected) > 1;
        }
    }
    EXPECT_GT(compared, 2000);
    EXPECT_GT(doubled, 50);
    // All three have the same mean depth and are laid by number: right at two of the crossings, wrong at the third.
    EXPECT_GT(wrong, doubled / 6);
    EXPECT_LT(wrong, doubled * 2 / 3);
}

TEST(Translucent, WithoutOverlapPolygonsAreExact) {
    Scene scene = seenAlongY();
    scene.settings.cull = CullMode::Back;
    scene.settings.shading = Shading::Phong;
    scene.lights.push_back({LightKind::Point, {1, 2, 3}, 50, Vec3d(1), false});
    add(scene, square(12, 9), 0.5);
    add(scene, test::sphere(2, 9, 13), 0.9, 0.4);
    scene.objects.back().transform.translation = {0, 8, 0};
    Scene polygons = scene;
    polygons.settings.translucency = Translucency::Polygons;
    EXPECT_EQ(difference(scene, polygons, test::everyBuffer()), "");
}

TEST(Translucent, TheBackMaterialHasAnAlphaOfItsOwn) {
    Scene scene = test::openGlCube();
    scene.settings.cull = CullMode::None;
    scene.settings.twoSided = true;
    scene.objects[0].backMaterial = scene.objects[0].material;
    scene.objects[0].backMaterial->alpha = 0.5;
    const FramePtr opaqueFront = test::frameOf(scene);
    // The front hides the translucent back faces.
    EXPECT_EQ(statistics(*opaqueFront->buffer({BufferId::Layers})).max, 0);
    scene.objects[0].material.alpha = 0.5;
    scene.objects[0].backMaterial->alpha = 1;
    const FramePtr opaqueBack = test::frameOf(scene);
    EXPECT_EQ(statistics(*opaqueBack->buffer({BufferId::Layers})).max, 1);
    scene.settings.twoSided = false;  // the back material does not count
    EXPECT_EQ(statistics(*test::frameOf(scene)->buffer({BufferId::Layers})).max, 2);
}

// A tile that has more layers than a task may hold is cut in halves, down to single pixels.
TEST(Translucent, TheLimitOfMemoryDoesNotChangeABit) {
    Scene scene = test::randomScene(7);
    for (Object& object : scene.objects) object.material.alpha = 0.5;
    scene.settings.cull = CullMode::None;
    for (const Translucency order : {Translucency::Exact, Translucency::Polygons}) {
        scene.settings.translucency = order;
        scene.settings.precision = Precision::Double;
        const FramePtr frame = test::frameOf(scene);
        const auto& data = *dataOf<double>(*frame);
        const ShadingInputs& inputs = data.keys.shading;
        const ShadingSources<double> in = data.shadingSources();
        const LayerBins<double> bins = binLayers(inputs, in);
        const auto drawn = [&](std::size_t limit) {
            auto out = prepareShading(inputs, in, test::everyBuffer());
            prepareElements(inputs, in, {}, out);
            shadePolygons(inputs, in, 0, out.polygons.count(), out);
            shadeVertices(inputs, in, 0, out.vertices.count(), out);
            for (std::size_t tile = 0; tile < bins.order.size(); ++tile)
                out.counts += drawLayers(inputs, in, bins, tile, out, &shadeLayers<double>, limit);
            return out;
        };
        const auto all = drawn(kLayersAtOnce), one = drawn(1), few = drawn(100);
        EXPECT_GT(all.counts.layers, 1000);
        for (const auto* other : {&one, &few}) {
            EXPECT_EQ(all.counts.layers, other->counts.layers);
            EXPECT_EQ(all.layers.pixels, other->layers.pixels);
            EXPECT_EQ(all.color.pixels, other->color.pixels);
            EXPECT_EQ(all.vectors[index(BufferId::Intensity)][0].pixels,
                      other->vectors[index(BufferId::Intensity)][0].pixels);
        }
    }
}

TEST(Translucent, StopsWhenAsked) {
    std::stop_source stop;
    stop.request_stop();
    FrameRequest request;
    request.stop = stop.get_token();
    EXPECT_EQ(runFrame(std::make_shared<const Scene>(twoPanes()), request, nullptr), nullptr);
}

// The pass runs from the first alpha below 1, and the sort from the second triangle.
TEST(TranslucentPlan, LeavesOutWhatNoSurfaceNeeds) {
    const auto part = [](const Scene& scene, std::string_view name) {
        const FramePtr frame = test::frameOf(scene, {});
        for (const PlanPart& p : frame->plan()[index(StageId::Shading)].parts)
            if (p.name == name) return p;
        return PlanPart{};
    };
    Scene scene = seenAlongY();
    add(scene, test::mesh({{-1, 4, -1}, {1, 4, -1}, {0, 4, 1}}, {{0, 1, 2}}), 0.5, 1);
    EXPECT_EQ(part(scene, "translucent pass").action, Action::LeaveOut);
    EXPECT_EQ(part(scene, "translucent pass").why, "Every surface is opaque.");
    EXPECT_EQ(part(scene, "sort of layers").why, "Every surface is opaque.");
    scene.objects[0].material.alpha = 1 - 1e-12;
    EXPECT_EQ(part(scene, "translucent pass").action, Action::Run);
    EXPECT_EQ(part(scene, "sort of layers").why, "There is one translucent triangle: no pixel has two layers.");
    scene.objects.push_back(scene.objects[0]);
    EXPECT_EQ(part(scene, "sort of layers").action, Action::Run);
    scene.objects[1].material.alpha = 0;  // as if it were not there
    EXPECT_EQ(part(scene, "sort of layers").action, Action::LeaveOut);
    scene.objects[1].material.alpha = 0.5;
    scene.settings.translucency = Translucency::Polygons;
    EXPECT_EQ(part(scene, "sort of layers").why, "Off in this scene: translucency = polygons.");
}

TEST(TranslucentPlan, RunsAgainOnlyWhatReadsAlpha) {
    Scene scene = twoPanes();
    const FramePtr first = test::frameOf(scene, {});
    scene.objects[0].material.alpha = 0.75;
    const FramePtr second = test::frameOf(scene, {}, 0, first);
    EXPECT_EQ(second->plan()[index(StageId::ZBuffer)].action, Action::Reuse);
    EXPECT_EQ(second->plan()[index(StageId::Shading)].why, "Material 0 changed.");
    scene.objects[0].material.alpha = 1;
    const FramePtr third = test::frameOf(scene, {}, 0, second);
    EXPECT_EQ(third->plan()[index(StageId::Transform)].action, Action::Reuse);
    EXPECT_EQ(third->plan()[index(StageId::ZBuffer)].why, "Other objects are translucent.");
    scene.objects[0].material.alpha = 0;
    const FramePtr fourth = test::frameOf(scene, {}, 0, third);
    EXPECT_EQ(fourth->plan()[index(StageId::Transform)].why, "Other objects are wholly transparent.");
}

}  // namespace
}  // namespace pipeline
