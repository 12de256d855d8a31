// Errors whose origin is known, put to the stages.
#include "pipeline/study/blame.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/study/errors.h"
#include "pipeline/study/ray_caster.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

// A sphere over a plane, lit from the side.
Scene sphereOnPlane(Shading shading, int tessellation, double exponent) {
    Scene scene;
    scene.settings.width = scene.settings.height = 96;
    scene.settings.precision = Precision::Double;
    scene.settings.shading = shading;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0.3, -7, 3}, scene.camera.target = {0, 0, 0}, scene.camera.fovY = 40;
    const auto add = [&](ShapeKind kind, ObjectTransform transform, int n) {
        scene.objects.push_back({std::string(name(kind)), makeShape({kind, n}), transform, {}, {}, Shape{kind, n}});
        scene.objects.back().material.specular = Vec3d(0.6);
        scene.objects.back().material.exponent = exponent;
    };
    add(ShapeKind::Plane, {Vec3d(6), {}, {0, 0, -1}}, 1);
    add(ShapeKind::Sphere, {Vec3d(1), {11, 7, 3}, {}}, tessellation);
    scene.lights.push_back({LightKind::AtInfinity, {-0.4, -0.7, 1}, 1, Vec3d(1), true});
    scene.ambient.intensity = 0.2;
    return scene;
}

std::vector<StageBlame> blameOf(const Scene& scene) {
    const Picture ours = pictureOf(*test::frameOf(scene, picturesNeed()));
    return blame(scene, ours, rayCast(scene, RaySurfaces::Exact, 0)->picture);
}
StageId worst(const std::vector<StageBlame>& rows) {
    return std::ranges::max_element(rows, {}, &StageBlame::share)->stage;
}

TEST(Blame, AFlatSphereIsTheNormalsFault) {
    const auto rows = blameOf(sphereOnPlane(Shading::Flat, 12, 8));
    ASSERT_EQ(rows.size(), 4u);
    EXPECT_EQ(worst(rows), StageId::Normals);
    EXPECT_GT(rows[0].share, 0.5);
}

TEST(Blame, TheHighlightThatGouraudLosesIsTheShadings) {
    const auto rows = blameOf(sphereOnPlane(Shading::Gouraud, 24, 1000));
    EXPECT_EQ(worst(rows), StageId::Shading);
    EXPECT_GT(rows[3].share, 0.3);
}

TEST(Blame, ACoarseShadowBuffersEdgeIsTheShadowBuffers) {
    Scene scene = sphereOnPlane(Shading::Phong, 64, 8);
    scene.settings.shadowSize = 16;
    const auto rows = blameOf(scene);
    EXPECT_EQ(worst(rows), StageId::ShadowBuffer);
    EXPECT_GT(rows[1].share, 0.5);
}

TEST(Blame, TheOutlineOfAFewPolygonsIsTheZBuffers) {
    Scene scene = sphereOnPlane(Shading::Phong, 2, 8);
    scene.objects.erase(scene.objects.begin());
    scene.settings.normalWeight = NormalWeight::Given;
    const auto rows = blameOf(scene);
    EXPECT_EQ(worst(rows), StageId::ZBuffer);
}

// Exchanging everything leaves nothing: the reference is what the formula says of its own ingredients.
TEST(Blame, TheReferenceItselfHasNoError) {
    const Scene scene = sphereOnPlane(Shading::Flat, 4, 8);
    const Picture reference = rayCast(scene, RaySurfaces::Exact, 0)->picture;
    for (const StageBlame& row : blame(scene, reference, reference)) {
        EXPECT_LT(row.error, 1e-15);
        EXPECT_EQ(row.share, 0);
    }
    EXPECT_TRUE(blame(scene, Picture{}, reference).empty());
}

}  // namespace
}  // namespace pipeline
