// Places and normals that stages would only copy are read where the mesh has them; with the bits of copies.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "pipeline/core/numerics.h"
#include "pipeline/run/frame_data.h"
#include "pipeline/run/runner.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

VertexVectors inFloat(const VertexVectors& from) {
    VertexVectors out;
    for (const Vec3d& v : from) out.push_back(glm::vec3(v));
    return out;
}

// A sphere that gives its normals, all of its numbers in the scene's precision.
Scene ball(Precision precision) {
    Scene scene;
    scene.settings.width = 96, scene.settings.height = 80;
    scene.settings.precision = precision;
    scene.settings.shading = Shading::Phong, scene.settings.normalWeight = NormalWeight::Given;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {1, 2, 5};
    Mesh mesh = *test::sphere(1, 12, 16);
    mesh.normals = mesh.positions;
    if (precision == Precision::Float) mesh.positions = inFloat(mesh.positions), mesh.normals = inFloat(mesh.normals);
    scene.objects = {{"ball", makeMesh(std::move(mesh)), {}, {Vec3d(0.5), Vec3d(0.4), 9}}};
    scene.lights.push_back({LightKind::AtInfinity, {1, 2, 3}, 1, Vec3d(1), false});
    return scene;
}

struct AreGiven {
    bool places, normals;
};
AreGiven areGiven(const Scene& scene) {
    const FramePtr frame = test::frameOf(scene, {});
    return readStages(*frame, [](const auto& data) {
        return AreGiven{data.transform->world.areGiven(), data.normals->vertex.areGiven()};
    });
}
AreGiven areGivenAfter(Precision precision, const std::function<void(Scene&)>& change) {
    Scene scene = ball(precision);
    change(scene);
    return areGiven(scene);
}
void setNormal(Scene& scene, std::size_t vertex, Vec3d normal) {
    Mesh mesh = *scene.objects[0].mesh;
    mesh.normals.set(vertex, normal);
    scene.objects[0].mesh = makeMesh(std::move(mesh));
}

TEST(AsGiven, IsWhatTheOnlyObjectHasWhereItsMatrixIsTheIdentity) {
    for (const Precision precision : {Precision::Float, Precision::Double}) {
        EXPECT_TRUE(areGiven(ball(precision)).places);
        const auto after = [&](const std::function<void(Scene&)>& change) { return areGivenAfter(precision, change); };
        EXPECT_FALSE(after([](Scene& s) { s.objects.push_back(s.objects[0]); }).places);
        EXPECT_FALSE(after([](Scene& s) { s.objects[0].transform.scale.z = 1 + 0x1p-52; }).places);
        EXPECT_FALSE(after([](Scene& s) { s.objects[0].transform.rotation.y = 1e-300; }).places);
        EXPECT_FALSE(after([](Scene& s) { s.settings.rules.reset(index(Rule::ModelTransform)); }).places);
        // A whole turn comes back to the same bits.
        EXPECT_TRUE(after([](Scene& s) { s.objects[0].transform.rotation.y = 360; }).places);
    }
    EXPECT_FALSE(areGivenAfter(Precision::Float, [](Scene& s) { s.settings.precision = Precision::Double; }).places);
    EXPECT_FALSE(areGivenAfter(Precision::Double, [](Scene& s) { s.settings.precision = Precision::Float; }).places);
    EXPECT_FALSE(areGivenAfter(Precision::Double, [](Scene& s) { s.settings.precision = Precision::Extended; }).places);
}

// In float the square of a rounded unit vector is off by up to sqrt(3)/2 · 2^-23, which is below the bound of 2 · 2^-23; that
// of one of length 1 + 2^-22 by four times 2^-23. In double rounded ones may be off by that bound, so only axes are sure.
TEST(AsGiven, NormalsHaveLengthOneAndAreAskedForAsTheyAre) {
    EXPECT_TRUE(areGiven(ball(Precision::Float)).normals);
    const auto after = [&](const std::function<void(Scene&)>& change) {
        return areGivenAfter(Precision::Float, change).normals;
    };
    EXPECT_FALSE(after([](Scene& s) { setNormal(s, 3, Vec3d(0, 1 + 0x1p-22, 0)); }));
    EXPECT_TRUE(after([](Scene& s) { setNormal(s, 3, Vec3d(0, 1 - 0x1p-24, 0)); }));
    EXPECT_FALSE(after([](Scene& s) { setNormal(s, 3, Vec3d(0)); }));
    EXPECT_FALSE(after([](Scene& s) { s.objects[0].transform.scale = Vec3d(2); }));
    EXPECT_FALSE(after([](Scene& s) { s.settings.normalWeight = NormalWeight::Area; }));
    EXPECT_FALSE(after([](Scene& s) { s.settings.forms.unit = UnitForm::Direct; }));
    EXPECT_FALSE(after([](Scene& s) { s.settings.rules.reset(index(Rule::ModelTransform)); }));
    EXPECT_TRUE(after([](Scene& s) { s.settings.forms.normalMatrix = NormalMatrixForm::InverseTranspose; }));
}

TEST(AsGiven, LeavesTheBitsOfCopies) {
    const BufferSet asked = setOf({BufferId::VerticesWorld, BufferId::VerticesNormal, BufferId::Intensity,
                                   BufferId::PolygonsVerdict, BufferId::VerticesScreen});
    for (const Precision precision : {Precision::Float, Precision::Double}) {
        Scene scene = ball(precision);
        // -0 is a place like any other; sums of products give it as 0.
        Mesh mesh = *scene.objects[0].mesh;
        mesh.positions.set(5, {-0.0, 1.5, -0.0}), mesh.normals.set(5, {-0.0, 1, -0.0});
        scene.objects[0].mesh = makeMesh(std::move(mesh));
        const FramePtr given = test::frameOf(scene, asked);
        scene.settings.rules.reset(index(Rule::ModelTransform));
        const FramePtr copied = test::frameOf(scene, asked);
        ASSERT_TRUE(areGivenAfter(precision, [&](Scene& s) { s.objects[0].mesh = scene.objects[0].mesh; }).places);
        for (const BufferInfo& info : bufferTable()) {
            if (!asked[index(info.id)]) continue;
            const auto one = given->buffer({info.id}), other = copied->buffer({info.id});
            ASSERT_TRUE(one && other) << info.name;
            ASSERT_EQ(one->shape, other->shape) << info.name;
            for (std::size_t i = 0; i < one->count(); ++i) {
                ASSERT_EQ(one->flat(i), other->flat(i)) << info.name << " " << i;
                ASSERT_EQ(std::signbit(one->flat(i)), std::signbit(other->flat(i))) << info.name << " " << i;
            }
        }
    }
}

// What a frame has left outlives the scene and the frame: buffers are handed on.
TEST(AsGiven, BuffersKeepTheMesh) {
    std::optional<AnyBuffer> world;
    Vec3d first;
    {
        const Scene scene = ball(Precision::Float);
        first = scene.objects[0].mesh->positions[7];
        world = test::frameOf(scene, setOf({BufferId::VerticesWorld}))->buffer({BufferId::VerticesWorld});
    }
    EXPECT_EQ(Vec3d(world->value(0, 7, 0), world->value(0, 7, 1), world->value(0, 7, 2)), first);
}

// A given normal of length 1, as far as Real can tell, stays; in double one that was rounded to float has another length.
TEST(AsGiven, NormalsOfLengthOneAreNotNormalised) {
    const Vec3d rounded(glm::vec3(Vec3d(1, 2, 3) / std::sqrt(14.0)));
    ASSERT_GT(offUnit(rounded), kOffUnit<double>);
    for (const Precision precision : {Precision::Float, Precision::Double}) {
        Scene scene = ball(Precision::Float);
        scene.settings.precision = precision;
        setNormal(scene, 4, rounded);
        const FramePtr frame = test::frameOf(scene, setOf({BufferId::VerticesNormal}));
        const auto normals = frame->buffer({BufferId::VerticesNormal});
        const Vec3d normal{normals->value(0, 4, 0), normals->value(0, 4, 1), normals->value(0, 4, 2)};
        if (precision == Precision::Float)
            EXPECT_EQ(normal, rounded);
        else
            EXPECT_LE(offUnit(normal), 4 * std::numeric_limits<double>::epsilon());
    }
}

// Infinite, so that nobody takes it for a length of 1.
TEST(AsGiven, ANormalThatIsNotFiniteIsOffUnit) {
    Mesh mesh = *test::sphere(1, 6, 8);
    mesh.normals = mesh.positions;
    mesh.normals.set(2, Vec3d(std::numeric_limits<double>::quiet_NaN(), 0, 1));
    EXPECT_EQ(makeMesh(mesh)->facts.offUnit, std::numeric_limits<double>::infinity());
    mesh.normals.set(2, Vec3d(0, 0, 1.5));
    EXPECT_EQ(makeMesh(mesh)->facts.offUnit, 1.25);  // 1.5² - 1
}

}  // namespace
}  // namespace pipeline
