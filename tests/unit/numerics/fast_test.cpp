// The arithmetic `fast` against `exact`, and against double.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "pipeline/run/frame_data.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

using test::spheres;

Scene in(Scene scene, Arithmetic arithmetic) {
    scene.settings.arithmetic = arithmetic;
    return scene;
}

FramePtr picture(const Scene& scene) { return test::frameOf(scene, setOf({BufferId::Color, BufferId::Intensity})); }

bool ranFast(const Frame& frame) {
    return readStages(frame, [](const auto& data) { return data.keys.shading.parts[Part::FastVectors]; });
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

// Of triangles smaller than a pixel, each pixel is looked at for itself.
TEST(Fast, HasFineMeshes) {
    Scene scene = spheres();
    scene.settings.width = 111, scene.settings.height = 80;
    for (Object& object : scene.objects) object.mesh = test::sphere(150, 60, 90);
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

// Nothing stands between a floor and the light straight above it, where a shadow's bias is least: a position that were
// found from z_view would lie beside the floor, by a share of what snapping moves its corners.
TEST(Fast, ThrowsNoShadowOnAFloorBelowItsLight) {
    for (const LightKind kind : {LightKind::AtInfinity, LightKind::Point, LightKind::Area}) {
        Mesh mesh;
        mesh.positions = {{-6, -5, 0}, {6, -5, 0}, {6, 5, 0}, {-6, 5, 0}};
        mesh.addPolygon(std::array{0U, 1U, 2U, 3U});
        Scene scene;
        scene.objects.push_back({"floor", makeMesh(std::move(mesh)), {}, {Vec3d(0.8), Vec3d(0), 1}});
        scene.lights.push_back({kind, {0, 0, 4}, 100, Vec3d(1), true});
        scene.lights[0].area = {{0, 0, -1}, 1, 1, 2};
        scene.camera.kind = CameraKind::LookAt;
        scene.camera.eye = {3, -9, 7}, scene.camera.target = {0, 0, 0}, scene.camera.up = {0, 0, 1};
        scene.settings.width = 96, scene.settings.height = 72, scene.settings.shading = Shading::Phong;
        scene = in(scene, Arithmetic::Fast);
        const FramePtr shadowed = picture(scene);
        ASSERT_TRUE(ranFast(*shadowed));
        scene.lights[0].castsShadow = false;
        const Difference found = difference(*shadowed, *picture(scene));
        EXPECT_GT(found.pixels, 1000);
        EXPECT_EQ(found.beyond, 0) << "kind " << int(kind);
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

// Nobody asks for it and nothing reads it: the frame buffer is all that is left, and its bits do not change.
TEST(Fast, LeavesTheIntensityOutWhereNobodyAsks) {
    for (const Arithmetic arithmetic : {Arithmetic::Exact, Arithmetic::Fast}) {
        const Scene scene = in(spheres(), arithmetic);
        const FramePtr less = test::frameOf(scene, setOf({BufferId::Color})), more = picture(scene);
        EXPECT_FALSE(less->buffer({BufferId::Intensity}));
        EXPECT_EQ(less->whyAbsent({BufferId::Intensity}), "Nobody has asked for it yet.");
        EXPECT_EQ(test::firstDifference(*less, *more, setOf({BufferId::Color})), "");
        const FramePtr now = test::frameOf(scene, setOf({BufferId::Intensity}), 0, less);
        EXPECT_EQ(test::firstDifference(*now, *more, setOf({BufferId::Intensity})), "");
        const FramePtr again = test::frameOf(scene, setOf({BufferId::Color}), 0, now);
        EXPECT_EQ(again->plan()[index(StageId::Shading)].action, Action::Reuse);
    }
    Scene scene = spheres();
    scene.objects[0].material.alpha = 0.5;  // is laid over it
    EXPECT_TRUE(test::frameOf(scene, setOf({BufferId::Color}))->buffer({BufferId::Intensity}));
    scene = spheres();
    scene.settings.antialiasing = 2;  // the mean of several
    EXPECT_TRUE(test::frameOf(scene, setOf({BufferId::Color}))->buffer({BufferId::Intensity}));
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
            if (part.name == "pixels in vectors") return part.why;
        return std::string("not said");
    };
    const BufferSet color = setOf({BufferId::Color});
    Scene scene = spheres();
    scene.settings.shading = Shading::Gouraud;
    EXPECT_EQ(reason(scene, setOf({BufferId::NDotL})),
              "The buffer n_dot_l is asked for, which it leaves in Phong shading alone.");
    scene = spheres();
    scene.settings.precision = Precision::Double;
    EXPECT_EQ(reason(scene, color), "It computes in float alone.");
    scene = spheres();
    scene.settings.interpolation = Interpolation::Scanline;
    EXPECT_EQ(reason(scene, color), "It interpolates normals in perspective alone.");
    scene.settings.shading = Shading::Gouraud;
    EXPECT_EQ(reason(scene, color), "It does not interpolate along rows.");
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

}  // namespace
}  // namespace pipeline
