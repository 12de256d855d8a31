#include <gtest/gtest.h>

#include <array>

#include <cmath>

#include "app/drawing3d/lobe_drawing.h"
#include "app/drawing3d/normal_arrows.h"
#include "app/drawing3d/overlay.h"
#include "app/drawing3d/point_drawing.h"
#include "app/drawing3d/space_content.h"
#include "app/drawing3d/space_drawing.h"
#include "app/drawing3d/world_drawing.h"
#include "tests/app/view3d/view3d_fixture.h"
#include "tests/support/scenes.h"

using namespace view3d;
using app::SpaceMap;
using app::ViewSpace;

namespace {

// The pyramid over a floor that it shadows.
pipeline::Scene overFloor() {
    pipeline::Scene scene = test::pyramid();
    pipeline::Object floor;
    floor.name = "floor";
    floor.mesh = pipeline::makeShape({.kind = pipeline::ShapeKind::Plane});
    floor.transform.scale = Vec3d(600.0);
    floor.transform.translation = {335, 75, -20};
    scene.objects.push_back(floor);
    return scene;
}

// Looks from (10, 0, 0) along −x: 200 by 100 pixels, 100 pixels a unit at z_view = 1, near 2, far 18.
pipeline::View alongMinusX() {
    pipeline::View view;
    view.eye = {10, 0, 0};
    view.right = {0, 1, 0};
    view.up = {0, 0, 1};
    view.forward = {-1, 0, 0};
    view.scale = {100, 100};
    view.size = {200, 100};
    view.centre = {100, 50};
    view.near = 2;
    view.far = 18;
    return view;
}

ViewContent lit(const pipeline::Scene& scene, std::optional<glm::ivec2> pixel = {}) {
    const auto buffers = app::contentBuffers(scene, true) | pipeline::setOf({pipeline::BufferId::ShadowBuffer});
    const pipeline::FramePtr frame = test::frameOf(scene, buffers);
    ViewContent content = app::contentOf(*frame, pixel);
    content.frusta = app::lightFrusta(*frame);
    return content;
}

}  // namespace

// (6, 1, 0.5): 4 before the eye, 1 to its right, 0.5 above.
TEST(View3dSpace, PointsStandWhereEverySpaceHasThem) {
    const Vec3d p{6, 1, 0.5};
    const auto in = [&](ViewSpace space) { return SpaceMap{.space = space, .view = alongMinusX()}.toSpace(p); };
    expectNear(in(ViewSpace::World), p, 0);
    expectNear(in(ViewSpace::Eye), {1, 4, 0.5}, 1e-12);
    // Pixel x = 100 + 100 · 1 / 4 = 125, y = 50 − 100 · 0.5 / 4 = 37.5; of 200 by 100 that is 0.25 to the right
    // of the middle's 0 and 0.25 above. OpenGL's z: (f + n) / (f − n) − 2 f n / ((f − n) z) = 20/16 − 72/(16 · 4) = 0.125.
    expectNear(in(ViewSpace::Clip), {0.25, 0.125, 0.25}, 1e-12);
    // Window z (0.125 + 1) / 2 = 0.5625, drawn 100 deep; y counts downwards from the top.
    expectNear(in(ViewSpace::Screen), {125, 56.25, 100 - 37.5}, 1e-12);
}

TEST(View3dSpace, EverySpaceLeadsBackToTheWorld) {
    for (const bool perspective : {true, false})
        for (const ViewSpace space : {ViewSpace::World, ViewSpace::Eye, ViewSpace::Clip, ViewSpace::Screen}) {
            SpaceMap map{.space = space, .view = alongMinusX()};
            map.view.perspective = perspective;
            for (const Vec3d p : {Vec3d(7, 1, -0.3), Vec3d(-7.9, 0, 2), Vec3d(0, 0, 0)})
                expectNear(map.toWorld(map.toSpace(p)), p, 1e-9);
        }
}

// z is affine in 1/z_view, so that three points of a line stay on a line, and the near and the far plane are flat.
TEST(View3dSpace, LinesStayLines) {
    const SpaceMap map{.space = ViewSpace::Screen, .view = alongMinusX()};
    const Vec3d a = map.toSpace({7, -1, 0.2}), b = map.toSpace({-6, 2, -1}), c = map.toSpace({0.5, 0.5, -0.4});
    EXPECT_NEAR(glm::length(glm::cross(glm::normalize(b - a), glm::normalize(c - a))), 0, 1e-12);
}

TEST(View3dSpace, NothingIsMirrored) {
    for (const ViewSpace space : {ViewSpace::Eye, ViewSpace::Clip, ViewSpace::Screen}) {
        const SpaceMap map{.space = space, .view = alongMinusX()};
        const Vec3d o = map.toSpace({5, 0, 0});
        const glm::dmat3 axes(map.toSpace({5.1, 0, 0}) - o, map.toSpace({5, 0.1, 0}) - o, map.toSpace({5, 0, 0.1}) - o);
        EXPECT_GT(glm::determinant(axes), 0);
    }
}

TEST(View3dSpace, EyeSpaceKeepsLengthsAndAngles) {
    const ViewContent world = contentOf(test::pyramid(), kRightFace);
    const ViewContent eye = app::inSpace(world, *app::mapOf(world, {ViewSpace::Eye}));
    expectNear(eye.eye.eye, {0, 0, 0}, 1e-9);
    expectNear(eye.eye.forward, {0, 1, 0}, 1e-12);
    ASSERT_EQ(eye.vectors.size(), world.vectors.size());
    for (std::size_t i = 0; i < world.vectors.size(); ++i)
        EXPECT_NEAR(glm::dot(eye.vectors[i].direction, eye.vectors[0].direction),
                    glm::dot(world.vectors[i].direction, world.vectors[0].direction), 1e-12);
    EXPECT_NEAR(glm::length(eye.mesh->positions[0] - eye.mesh->positions[4]),
                glm::length(world.mesh->positions[0] - world.mesh->positions[4]), 1e-9);
    EXPECT_EQ(eye.pickedLoop, world.pickedLoop);
}

// What a vertex has in clip and screen space is what the pipeline's own buffers say.
TEST(View3dSpace, ScreenSpaceAgreesWithTheTransformStage) {
    const pipeline::Scene scene = test::pyramid();
    const auto frame =
        test::frameOf(scene, app::contentBuffers(scene, false) | pipeline::setOf({pipeline::BufferId::VerticesScreen}));
    const ViewContent world = app::contentOf(*frame, {});
    const ViewContent screen = app::inSpace(world, *app::mapOf(world, {ViewSpace::Screen}));
    const auto buffer = frame->buffer({pipeline::BufferId::VerticesScreen});
    ASSERT_TRUE(buffer);
    for (std::size_t v = 0; v < 5; ++v) {
        EXPECT_NEAR(screen.mesh->positions[v].x, buffer->flat(3 * v), 1e-3);
        EXPECT_NEAR(480 - screen.mesh->positions[v].z, buffer->flat(3 * v + 1), 1e-3);
        EXPECT_TRUE(screen.mesh->positions[v].y >= 0 && screen.mesh->positions[v].y <= 480);
    }
    EXPECT_TRUE(screen.vectors.empty() && normalCount(*screen.mesh, app::NormalsShown::Polygons) == 0)
        << "it keeps no angles";
}

// A triangle with two corners before the near plane and one behind it: a quadrangle stays, two triangles.
TEST(View3dSpace, PolygonsAreCutAtTheNearPlane) {
    ViewContent world;
    world.eye = alongMinusX();
    auto mesh = std::make_shared<app::ViewMesh>();
    mesh->positions = {{0, -1, 0}, {0, 1, 0}, {12, 0, 0}};  // z_view 10, 10, −2; near is 2
    mesh->faces.push_back({{0, 1, 2}, 0, true});
    mesh->edges = {{0, 1}, {0, 2}, {1, 2}};
    world.mesh = mesh;
    world.pickedLoop = {0, 1, 2};
    const ViewContent cut = app::clippedAtNear(world);
    EXPECT_EQ(cut.mesh->faces.size(), 2u);
    EXPECT_EQ(cut.mesh->edges.size(), 3u);
    EXPECT_EQ(cut.pickedLoop.size(), 4u);
    ASSERT_EQ(cut.mesh->positions.size(), 5u) << "an edge is cut once";
    // Two thirds of the way from z_view 10 to −2.
    for (std::size_t i = 3; i < 5; ++i) {
        EXPECT_NEAR(cut.mesh->positions[i].x, 8, 1e-12);
        EXPECT_NEAR(std::abs(cut.mesh->positions[i].y), 1 / 3.0, 1e-12);
    }
    const ViewContent clip = app::inSpace(world, *app::mapOf(world, {ViewSpace::Clip}));
    for (const app::Face& face : clip.mesh->faces)
        for (const std::uint32_t v : face.vertices) EXPECT_GE(clip.mesh->positions[v].y, -1 - 1e-12);
    const ViewContent whole = contentOf(test::pyramid());
    EXPECT_EQ(app::clippedAtNear(whole).mesh, whole.mesh) << "nothing to cut";
}

// The first picture of the change is the one that was there, the last the one that comes; half way a corner is
// half way on the screen where both cameras are orthographic.
TEST(View3dSpace, AChangeOfSpaceBeginsAndEndsWithTheTwoPictures) {
    const ViewContent world = contentOf(test::pyramid());
    const SpaceMap from{}, to = *app::mapOf(world, {ViewSpace::Clip});
    const ViewContent clip = app::inSpace(world, to);
    for (const bool orthographic : {false, true}) {
        const auto a = app::presetCamera(app::ViewPreset::Iso, world, {}, kView, orthographic);
        const auto b = app::presetCamera(app::ViewPreset::Iso, clip, {}, kView, orthographic);
        const app::SpaceMorph morph(world, from, a, to, b);
        const auto at = [&](double t, std::size_t v) {
            return app::project(morph.camera(t), kView, morph.content(t).mesh->positions[v]).at;
        };
        for (std::size_t v = 0; v < 5; ++v) {
            const glm::dvec2 begin = app::project(a, kView, world.mesh->positions[v]).at;
            const glm::dvec2 end = app::project(b, kView, clip.mesh->positions[v]).at;
            EXPECT_NEAR(glm::length(at(0, v) - begin), 0, 1e-6);
            EXPECT_NEAR(glm::length(at(1, v) - end), 0, 1e-6);
            if (orthographic) {
                EXPECT_NEAR(glm::length(at(0.5, v) - (begin + end) / 2.0), 0, 1e-6);
            }
        }
        EXPECT_EQ(morph.content(0.5).mesh->faces.size(), world.mesh->faces.size()) << "the same polygons";
    }
}

TEST(View3dSpace, ALightLooksAsItsShadowBufferDoes) {
    const ViewContent world = lit(overFloor());
    ASSERT_FALSE(world.frusta.empty());
    const app::LightFrustum& frustum = world.frusta[0];
    const auto map = app::mapOf(world, {ViewSpace::Light, 0});
    ASSERT_TRUE(map);
    const ViewContent light = app::inSpace(world, *map);
    // The shadow buffer's range is that of the vertices: the second drawn coordinate is Z'.
    double least = 1e300, most = -1e300;
    for (const Vec3d& p : light.mesh->positions) least = std::min(least, p.y), most = std::max(most, p.y);
    EXPECT_NEAR(least, frustum.begin, 0.02 * (most - least)) << "but for the texels' size";
    EXPECT_NEAR(most, frustum.end, 0.02 * (most - least));
    EXPECT_LT(frustum.plane, frustum.begin) << "the buffer stands before what it shows";
    EXPECT_EQ(frustum.picture.pixels.size(), std::size_t(frustum.picture.size.x * frustum.picture.size.y));
    EXPECT_FALSE(app::mapOf(world, {ViewSpace::Light, 5})) << "there is no such light";
    EXPECT_FALSE(app::mapOf(contentOf(test::pyramid()), {ViewSpace::Light, 0})) << "a convex object casts none";
}

// Beside the pyramid, over the floor: the face downwards sees it, the one upwards nothing. Each face looks along its axis.
TEST(View3dSpace, APointLightHasSixFaces) {
    pipeline::Scene scene = overFloor();
    scene.lights[0].kind = pipeline::LightKind::Point;
    scene.lights[0].position = {300, 0, 900};
    const ViewContent world = lit(scene);
    ASSERT_EQ(world.frusta.size(), 6u);
    const std::array<Vec3d, 6> axes{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
    for (int face = 0; face < 6; ++face) {
        const auto map = app::mapOf(world, {ViewSpace::Light, 0, face});
        ASSERT_TRUE(map) << face;
        EXPECT_EQ(map->face, face);
        EXPECT_EQ(map->view.forward, axes[std::size_t(face)]);
        const auto frustum = std::ranges::find(world.frusta, face, &app::LightFrustum::face);
        EXPECT_EQ(frustum->faces, 6);
        EXPECT_LT(frustum->plane, frustum->end);
        if (face == 4) {
            EXPECT_EQ(frustum->texels, 0u) << "upwards";
            EXPECT_EQ(frustum->plane, frustum->end / 4) << "drawn, and not from a point";
        }
    }
    EXPECT_EQ(app::mapOf(world, {ViewSpace::Light, 0})->face, 5) << "the fullest looks down";
    EXPECT_EQ(app::nameOf({ViewSpace::Light, 0, 5}), "Light 0's space, face −z");
    const ViewContent down = app::inSpace(world, *app::mapOf(world, {ViewSpace::Light, 0, 5}));
    std::size_t drawn = 0;
    for (const app::LightFrustum& frustum : down.frusta) drawn += app::isShown(frustum, down, {});
    EXPECT_EQ(drawn, 1u) << "its own alone, unless all are asked for";
}

TEST(View3dSpace, CornersOfTheCubeAreNamedByTheSpace) {
    using app::CubeFace;
    EXPECT_EQ(app::letterOf(CubeFace::Z, ViewSpace::World), "z");
    EXPECT_EQ(app::letterOf(CubeFace::Z, ViewSpace::Eye), "y") << "the eye's y is up";
    EXPECT_EQ(app::letterOf(CubeFace::Y, ViewSpace::Eye), "z") << "and its z away";
    EXPECT_EQ(app::letterOf(CubeFace::Z, ViewSpace::Screen), "−y") << "pixels count downwards";
}

// cos^8: at 60° it is 2^-8; where it is a hundredth the profile ends: acos(0.01^(1/8)) = 55.78°.
TEST(View3dLobe, ItsSurfaceIsThePowerOfTheCosine) {
    const auto profile = app::lobeProfile(8, 20);
    EXPECT_EQ(profile.front(), glm::dvec2(0, 1));
    EXPECT_NEAR(glm::degrees(profile[20].x), 55.78, 0.01);
    EXPECT_NEAR(profile[20].y, 0.01, 1e-12);
    EXPECT_EQ(profile.back().y, 0);
    for (std::size_t i = 1; i + 1 < profile.size(); ++i)
        EXPECT_NEAR(std::log(profile[i].y), 8 * std::log(std::cos(profile[i].x)), 1e-9);
    EXPECT_EQ(app::lobeProfile(0, 4).back().y, 1) << "n = 0 counts up to the edge";
}

// Lecture 1's pyramid: (R·V)^8 at the picked pixel is the specular factor that the pixel report has.
TEST(View3dLobe, TheProbeCutsItAtTheSpecularFactor) {
    const pipeline::Scene scene = test::pyramid();
    const auto frame = test::frameOf(scene);
    const ViewContent world = app::contentOf(*frame, kRightFace);
    ASSERT_EQ(world.lobes.size(), 1u);
    const app::SpecularLobe& lobe = world.lobes[0];
    EXPECT_EQ(lobe.code, VectorCode::R);
    const double cosine = glm::dot(vectorOf(world, VectorCode::R).direction, vectorOf(world, VectorCode::V).direction);
    EXPECT_NEAR(lobe.power, std::pow(cosine, scene.objects[0].material.exponent), 1e-9);
    pipeline::Scene blinn = scene;
    blinn.settings.model = pipeline::Model::BlinnPhong;
    blinn.settings.exponentFactor = 4;
    const ViewContent half = contentOf(blinn, kRightFace);
    ASSERT_EQ(half.lobes.size(), 1u);
    EXPECT_EQ(half.lobes[0].code, VectorCode::H);
    EXPECT_EQ(half.lobes[0].exponent, 4 * scene.objects[0].material.exponent);
    EXPECT_NEAR(half.lobes[0].power,
                std::pow(glm::dot(half.lobes[0].axis, half.lobes[0].probe), half.lobes[0].exponent), 1e-6)
        << "in float";
    blinn.objects[0].material.specular = Vec3d(0.0);
    EXPECT_TRUE(contentOf(blinn, kRightFace).lobes.empty()) << "a dull material has no highlight";
}

TEST(View3dLobe, IsDrawnWhereItIsAskedFor) {
    const ViewContent world = contentOf(test::pyramid(), kRightFace);
    const auto point = app::pointContent(world);
    const app::ViewFrame view{app::presetCamera(app::ViewPreset::Iso, world, {}, kView, false), kView};
    EXPECT_GT(app::drawWorld(world, {.lobe = true}, view).lines.size(),
              app::drawWorld(world, {}, view).lines.size() + 300);
    const app::ViewFrame near{app::pointCamera(app::ViewPreset::Iso, *point, {}, kView, false), kView};
    bool told = false;
    for (const app::Label& label : app::drawPoint(*point, {.lobe = true}, near).labels)
        told |= label.text.starts_with("(R·V)^8 = ");
    EXPECT_TRUE(told);
}
