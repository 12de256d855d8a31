// Every rule of leaving out: the smallest scene in which it must fire, and the neighbour in which it must not.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "pipeline/inspect/pixel_report.h"
#include "pipeline/plan/needs.h"
#include "pipeline/scene/model_facts.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

// Whether the frame left something out by the rule.
bool fired(const Frame& frame, Rule rule) {
    for (const PlanStep& step : frame.plan()) {
        const auto left = [&](const PlanPart& part) { return part.action == Action::LeaveOut && part.rule == rule; };
        if (step.rule == rule || std::ranges::any_of(step.parts, left)) return true;
        for (const Tally& tally : frame.run(step.stage).tallies)
            if (tally.rule == rule && tally.leftOut > 0) return true;
    }
    return false;
}

// A box in the middle of an orthographic view from obliquely above, one light at infinity.
Scene boxScene() {
    Scene scene;
    scene.settings.width = 96, scene.settings.height = 80, scene.settings.shadowSize = 64;
    scene.settings.precision = Precision::Double;  // in float 1e-300 is 0
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.projection = ProjectionKind::Orthographic;
    scene.camera.eye = {5, -6, 7}, scene.camera.height = 4;
    scene.objects.push_back({"box", test::box(Vec3d(-0.5), Vec3d(0.5)), {}, {Vec3d(0.5), Vec3d(0.4), 4}});
    scene.lights.push_back({LightKind::AtInfinity, {1, -2, 3}, 1, Vec3d(1), true});
    scene.ambient.intensity = 0.2;
    return scene;
}
// Another box beside the first, `along` x; without it the shadow buffer is not needed.
Scene twoBoxes(double along) {
    Scene scene = boxScene();
    scene.objects.push_back(scene.objects[0]);
    scene.objects[1].transform.translation = {along, 0, 0};
    return scene;
}
// A mesh around the origin, every normal along its position, `length` times as long.
std::shared_ptr<const Mesh> withNormals(Mesh mesh, double length) {
    mesh.normals.clear();
    for (const Vec3d& p : mesh.positions) mesh.normals.push_back(length * p);
    return makeMesh(std::move(mesh));
}
// Seen from below a lid by an eye that looks straight down: the floor fills the picture, all of it is lit from
// the side, and the lid casts a shadow elsewhere.
Scene floorUnderLid() {
    Scene scene = boxScene();
    const auto square = [](double half, double z) {
        return test::mesh({{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}}, {{0, 1, 2, 3}});
    };
    scene.objects[0].mesh = square(100, 0);
    scene.objects.push_back({"lid", square(1, 5), {}, {}});
    scene.camera.eye = {0, 0, 3}, scene.camera.up = {0, 1, 0};
    return scene;
}

// A sphere in Phong shading whose mesh gives the exact normals, in a light without shadows.
Scene roundBall() {
    Scene scene = boxScene();
    scene.objects[0].mesh = withNormals(*test::sphere(1, 6, 8), 1);
    scene.settings.shading = Shading::Phong;
    scene.settings.normalWeight = NormalWeight::Given;
    scene.lights[0].castsShadow = false;
    return scene;
}

struct Case {
    Rule rule;
    std::function<Scene()> scene;
    std::function<void(Scene&)> neighbour;  // the smallest change after which the rule must not fire
    BufferSet wanted{}, neighbourWanted{};
};

const std::vector<Case>& cases() {
    using S = Scene;
    static const std::vector<Case> kCases{
        {Rule::ModelTransform, roundBall, [](S& s) { s.objects[0].transform.translation.x = 1e-300; }},
        {Rule::Culling,
         [] {
             S s = boxScene();
             s.settings.cull = CullMode::None;
             return s;
         },
         [](S& s) { s.settings.cull = CullMode::Back; }},
        // The sphere's first vertex is a pole.
        {Rule::PolygonNormals, roundBall,
         [](S& s) {
             Mesh one = *s.objects[0].mesh;
             one.normals.set(0, Vec3d(0));
             s.objects[0].mesh = makeMesh(one);
         }},
        {Rule::VertexNormals, boxScene, [](S& s) { s.settings.shading = Shading::Phong; }},
        {Rule::PolygonTerms,
         [] {
             S s = boxScene();
             s.settings.shading = Shading::Gouraud;
             return s;
         },
         [](S& s) { s.settings.shading = Shading::Flat; }},
        {Rule::VertexTerms, boxScene, [](S& s) { s.settings.shading = Shading::Gouraud; }},
        // Three of the six faces of a box look away, and are dropped; of a triangle that faces the eye none.
        {Rule::HiddenPolygons, boxScene,
         [](S& s) {
             s.objects[0].mesh = test::mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
         }},
        // The corner where the three meet is seen by none of the others; without culling each belongs to some that go on.
        {Rule::HiddenVertices,
         [] {
             S s = boxScene();
             s.settings.shading = Shading::Gouraud;
             return s;
         },
         [](S& s) { s.settings.cull = CullMode::None; }},
        {Rule::DarkLight,
         [] {
             S s = boxScene();
             s.lights[0].intensity = 0;
             return s;
         },
         [](S& s) { s.lights[0].intensity = 1e-300; }},
        {Rule::Unreflected,
         [] {
             S s = boxScene();
             s.objects[0].material.diffuse = s.objects[0].material.specular = Vec3d(0);
             return s;
         },
         [](S& s) { s.objects[0].material.diffuse.g = 1e-300; }},
        {Rule::ConvexShadow,
         [] {
             S s = boxScene();
             s.lights[0].kind = LightKind::Point;
             return s;
         },
         [](S& s) {
             s.objects.push_back(s.objects[0]), s.objects[1].transform.translation = {1.5, 0, 0};
         }},
        // Seen along (1, -2, 3) the boxes are about 1.6 wide: 5 apart they do not overlap, 1.2 apart they do.
        {Rule::DistantShadow, [] { return twoBoxes(5); },
         [](S& s) {
             s.objects[1].transform.translation = {1.2, 0, 0};
         }},
        // Of the box's own sides some look away from the light: nothing to multiply there.
        {Rule::ShadowLookup,
         [] {
             S s = twoBoxes(1.2);
             s.lights[0].position = {-1, 2, 0.5};
             return s;
         },
         [](S& s) { s = floorUnderLid(); }},
        {Rule::Clipping, boxScene,
         [](S& s) {
             s.objects[0].mesh = test::mesh({{-99, -99, 0}, {99, -99, 0}, {0, 99, 0}}, {{0, 1, 2}});
         }},
        // 96 x 80 pixels are four tiles; the box, 20 pixels high, stands in the corner of one.
        {Rule::EmptyTiles,
         [] {
             S s = boxScene();
             s.camera.height = 40;
             s.camera.target = {4, -4, 0};
             return s;
         },
         [](S& s) { s = floorUnderLid(); }},
        {Rule::Position, boxScene,
         [](S& s) { s.settings.shading = Shading::Phong, s.lights[0].kind = LightKind::Point; }},
        {Rule::ViewVector,
         [] {
             S s = boxScene();
             s.objects[0].material.specular = Vec3d(0);
             return s;
         },
         [](S& s) { s.objects[0].material.specular = Vec3d(1e-300); }},
        {Rule::Directions, boxScene, [](S&) {}, {}, setOf({BufferId::HalfwayVector, BufferId::ReflectionVector})},
        {Rule::Specular,
         [] {
             S s = boxScene();
             s.objects[0].material.specular = Vec3d(0);
             return s;
         },
         [](S& s) { s.objects[0].material.specular = Vec3d(1e-300); }},
        {Rule::VanishingPower,
         [] {
             S s = boxScene();
             s.settings.model = Model::BlinnPhong;
             s.objects[0].material.exponent = 1e6;
             return s;
         },
         [](S& s) { s.objects[0].material.exponent = 1; }},
        {Rule::Attenuation,
         [] {
             S s = boxScene();
             s.settings.model = Model::OpenGl;
             s.lights[0].kind = LightKind::Point;
             return s;
         },
         [](S& s) { s.lights[0].gl.linear = 1e-300; }},
        {Rule::Ambient,
         [] {
             S s = boxScene();
             s.ambient.intensity = 0;
             return s;
         },
         [](S& s) { s.ambient.intensity = 1e-300; }},
        {Rule::UnreadBuffers, boxScene, [](S&) {}, {}, test::everyBuffer()},
        {Rule::TranslucentPass, boxScene, [](S& s) { s.objects[0].material.alpha = 1 - 1e-12; }},
        {Rule::LayerSort,
         [] {
             S s = boxScene();
             s.objects[0].mesh = test::mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
             s.objects[0].material.alpha = 0.5;
             return s;
         },
         [](S& s) { s.objects.push_back(s.objects[0]); }},
    };
    return kCases;
}

TEST(Rules, EachHasACase) {
    for (std::size_t i = 0; i < kRuleCount; ++i)
        EXPECT_EQ(std::ranges::count(cases(), Rule(i), &Case::rule), 1) << name(Rule(i));
}

TEST(Rules, FireWhereTheyMust) {
    for (const Case& c : cases()) EXPECT_TRUE(fired(*test::frameOf(c.scene(), c.wanted), c.rule)) << name(c.rule);
}

TEST(Rules, DoNotFireInTheNeighbour) {
    for (const Case& c : cases()) {
        Scene scene = c.scene();
        c.neighbour(scene);
        EXPECT_FALSE(fired(*test::frameOf(scene, c.neighbourWanted), c.rule)) << name(c.rule);
    }
}

// Each change alone brings polygon normals back: flat shading, a light that casts a shadow, means of
// polygon normals, a mesh without normals beside the first, an object flattened so far that a normal may vanish, normals
// that are 0 or so short that they may become 0, the buffer.
TEST(Rules, PolygonNormalsStayWhereSomethingReadsThem) {
    const auto normals = [](const Scene& scene, BufferSet wanted = {}) {
        const FramePtr frame = test::frameOf(scene, wanted);
        return frame->buffer({BufferId::PolygonsNormal}).has_value();
    };
    ASSERT_FALSE(normals(roundBall()));
    EXPECT_TRUE(normals(roundBall(), setOf({BufferId::PolygonsNormal})));
    using S = Scene;
    const auto changed = [&](auto change) {
        Scene scene = roundBall();
        change(scene);
        return normals(scene);
    };
    EXPECT_TRUE(changed([](S& s) { s.settings.shading = Shading::Flat; }));
    EXPECT_TRUE(changed([](S& s) { s.settings.normalWeight = NormalWeight::Mean; }));
    EXPECT_TRUE(changed([](S& s) { s.objects.push_back({"box", test::box(Vec3d(2), Vec3d(3)), {}, {}}); }));
    EXPECT_TRUE(changed([](S& s) { s.objects[0].transform.scale.z = 0; }));
    EXPECT_TRUE(changed([](S& s) { s.objects[0].mesh = withNormals(*s.objects[0].mesh, 0); }));
    EXPECT_TRUE(changed([](S& s) { s.objects[0].mesh = withNormals(*s.objects[0].mesh, 1e-200); }));
    EXPECT_TRUE(changed([](S& s) { s.lights[0].castsShadow = true; }));
    EXPECT_FALSE(changed([](S& s) { s.settings.shading = Shading::Gouraud; }));
    EXPECT_FALSE(changed([](S& s) { s.objects[0].transform.scale = {1e-20, -1e-20, 2e-20}; }));
    EXPECT_FALSE(changed([](S& s) { s.settings.model = Model::OpenGl, s.lights[0].castsShadow = true; }));
}

// Who looks at a pixel is told the same, fragment by fragment.
TEST(Rules, WithoutPolygonNormalsAPixelsReportIsTheSame) {
    Scene scene = roundBall();
    scene.lights.push_back({LightKind::Point, {3, -2, 3}, 1, Vec3d(1), false});
    const FramePtr without = test::frameOf(scene, {});
    scene.settings.rules.reset(index(Rule::PolygonNormals));
    const FramePtr with = test::frameOf(scene, {});
    ASSERT_FALSE(without->buffer({BufferId::PolygonsNormal}));
    ASSERT_TRUE(with->buffer({BufferId::PolygonsNormal}));
    const glm::ivec2 middle{48, 40};
    const PixelReport report = inspectPixel(*without, middle);
    EXPECT_TRUE(report.covered);
    EXPECT_EQ(toText(*without, report), toText(*with, inspectPixel(*with, middle)));
}

// exp(-n q) falls to 2^-26 of a base as bright as the highlight at n q = 18, and to 2^-55 at 38; at n = 40 nothing is
// rounded to 0, which takes 88 and 750.
TEST(Rules, APowerIsLeftOutWhereItChangesNoBitThatIsAskedFor) {
    for (const Precision precision : {Precision::Float, Precision::Double}) {
        Scene scene = roundBall();
        scene.settings.shading = Shading::Phong, scene.settings.precision = precision;
        scene.objects[0].material = {Vec3d(0.8), Vec3d(0.1), 40}, scene.ambient.intensity = 1;
        const BufferSet intensity = setOf({BufferId::Intensity});
        const auto fires = [](const Scene& s, BufferSet wanted) {
            return fired(*test::frameOf(s, wanted), Rule::VanishingPower);
        };
        EXPECT_TRUE(fires(scene, intensity));
        EXPECT_FALSE(fires(scene, setOf({BufferId::Specular})));
        const auto without = test::frameOf(scene, intensity)->buffer({BufferId::Intensity});
        scene.settings.rules.reset(index(Rule::VanishingPower));
        const auto with = test::frameOf(scene, intensity)->buffer({BufferId::Intensity});
        for (std::size_t i = 0; i < 96 * 80 * 3; ++i) ASSERT_EQ(without->flat(i), with->flat(i)) << i;
        scene.settings.rules.set(index(Rule::VanishingPower)), scene.ambient.intensity = 0;
        EXPECT_FALSE(fires(scene, intensity));
    }
}

// Where a run ends before shading nobody reads normals, unless it ends at them or they are asked for.
TEST(Rules, NormalsAreLeftOutWhereTheRunEndsBeforeShading) {
    const auto step = [](StageId until, BufferSet wanted) {
        FrameRequest request;
        request.until = until, request.wanted = wanted;
        return runFrame(std::make_shared<const Scene>(boxScene()), request, nullptr)->plan()[index(StageId::Normals)];
    };
    for (const StageId until : {StageId::ShadowBuffer, StageId::ZBuffer}) {
        const PlanStep left = step(until, {});
        EXPECT_EQ(left.action, Action::LeaveOut);
        EXPECT_EQ(left.rule, Rule::PolygonNormals);
        EXPECT_EQ(left.why, "The run ends after " + std::string(stageInfo(until).name) + ", and nobody asks for them.");
        EXPECT_EQ(step(until, setOf({BufferId::PolygonsNormal})).action, Action::Run);
        EXPECT_EQ(step(until, setOf({BufferId::VerticesNormal})).action, Action::Run);
    }
    EXPECT_EQ(step(StageId::Normals, {}).action, Action::Run);
    EXPECT_EQ(step(StageId::Shading, {}).action, Action::Run);
}

// A light is left out where no material reflects any of it; one coefficient is enough to need it, in every model whose
// material can be without a specular term. Only OpenGL's lights have an ambient term of their own.
TEST(Rules, AnyOneCoefficientNeedsTheLight) {
    for (std::size_t model = 0; model < kModelCount; ++model)
        for (Vec3d Material::*coefficient : {&Material::diffuse, &Material::specular, &Material::ambient}) {
            const ModelFacts& facts = modelFacts(Model(model));
            if (!facts.dullWithoutKs || (coefficient == &Material::ambient && !facts.found.glLights)) continue;
            Scene scene = boxScene();
            scene.settings.model = Model(model);
            scene.lights[0].gl.ambient = Vec3d(1);
            Material& material = scene.objects[0].material;
            material.diffuse = material.specular = material.ambient = Vec3d(0);
            EXPECT_TRUE(fired(*test::frameOf(scene, {}), Rule::Unreflected)) << model;
            (material.*coefficient).b = 1e-300;
            EXPECT_FALSE(fired(*test::frameOf(scene, {}), Rule::Unreflected)) << model;
        }
}

TEST(Rules, DoNotFireWhenSwitchedOff) {
    for (const Case& c : cases()) {
        Scene scene = c.scene();
        scene.settings.rules.reset(index(c.rule));
        EXPECT_FALSE(fired(*test::frameOf(scene, c.wanted), c.rule)) << name(c.rule);
        scene = c.scene();
        scene.settings.leaveOut = false;
        EXPECT_FALSE(fired(*test::frameOf(scene, c.wanted), c.rule)) << name(c.rule);
    }
}

TEST(Rules, ChangeNoBitWhereTheyFire) {
    const BufferSet compared = setOf({BufferId::Color, BufferId::Intensity, BufferId::PolygonId});
    for (const Case& c : cases()) {
        Scene scene = c.scene();
        const FramePtr with = test::frameOf(scene, c.wanted);
        scene.settings.rules.reset(index(c.rule));
        EXPECT_EQ(test::firstDifference(*with, *test::frameOf(scene, c.wanted), compared), "") << name(c.rule);
    }
}

// Counters of the lecture's pyramid by hand: five polygons, three of them face the eye, five vertices, one light.
TEST(Rules, CountersOfThePyramid) {
    Scene scene = test::pyramid();
    const auto tally = [](const Frame& frame, std::string_view what) {
        for (const StageId stage : kStages)
            for (const Tally& t : frame.run(stage).tallies)
                if (t.what == what) return std::pair(t.done, t.leftOut);
        return std::pair(-1ll, -1ll);
    };
    using P = std::pair<long long, long long>;
    const FramePtr frame = test::frameOf(scene, {});
    EXPECT_EQ(tally(*frame, "polygons evaluated"), P(3, 2));
    EXPECT_EQ(tally(*frame, "light evaluations"), P(3, 0));
    EXPECT_EQ(tally(*frame, "shadow look-ups"), P(0, 0));  // no shadow buffer
    scene.settings.leaveOut = false;
    const FramePtr forced = test::frameOf(scene, {});
    // Five polygons and five vertices for one light.
    EXPECT_EQ(tally(*forced, "polygons evaluated"), P(5, 0));
    EXPECT_EQ(tally(*forced, "vertices evaluated"), P(5, 0));
    EXPECT_EQ(tally(*forced, "light evaluations"), P(10, 0));
    // 640 x 480 in tiles of 64: 10 columns, 8 rows.
    EXPECT_EQ(tally(*forced, "tiles"), P(80, 0));
}

// What is asked for by name is computed, whatever the rules say, and is what it is without them.
TEST(Rules, WhatIsAskedForIsNotLeftOut) {
    for (const Case& c : cases()) {
        Scene scene = c.scene();
        const FramePtr with = test::frameOf(scene, test::everyBuffer());
        scene.settings.leaveOut = false;
        EXPECT_EQ(test::firstDifference(*with, *test::frameOf(scene, test::everyBuffer())), "") << name(c.rule);
    }
}

}  // namespace
}  // namespace pipeline
