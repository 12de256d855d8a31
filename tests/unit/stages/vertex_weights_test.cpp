#include "pipeline/stages/vertex_weights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "pipeline/export/buffers/gl_calls.h"
#include "pipeline/inspect/pixel_report.h"
#include "pipeline/scene/settings_table.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

// A polygon under a light from straight above, in Blinn-Phong's model without ambient light: a vertex with the normal
// (0, 0, 1) has intensity 1, one with a horizontal normal 0.
Scene withPolygon(std::vector<Vec3d> positions, const std::vector<double>& intensities) {
    Mesh m;
    m.positions = std::move(positions);
    std::vector<std::uint32_t> polygon;
    for (std::uint32_t i = 0; i < m.positions.size(); ++i) {
        polygon.push_back(i);
        m.normals.push_back(intensities[i] > 0 ? Vec3d(0, 0, 1) : Vec3d(1, 0, 0));
    }
    m.addPolygon(polygon);
    Scene scene;
    scene.settings.precision = Precision::Double;
    scene.settings.shading = Shading::Gouraud, scene.settings.model = Model::BlinnPhong;
    scene.settings.normalWeight = NormalWeight::Given, scene.settings.cull = CullMode::None;
    scene.camera.kind = CameraKind::LookAt;
    scene.objects.push_back({"polygon", makeMesh(std::move(m)), {}, {{1, 1, 1}, Vec3d(0), 1}});
    scene.lights.push_back({LightKind::AtInfinity, {0, 0, 1}, 1, Vec3d(1), false});
    return scene;
}

// Seen from the origin along +y with 100 pixels a unit at distance 1: a rectangle from distance 1 to 100 whose picture is
// the square from pixel 50 to 150.
Scene receding() {
    Scene scene = withPolygon({{-0.5, 1, -0.5}, {50, 100, -50}, {50, 100, 50}, {-0.5, 1, 0.5}}, {0, 1, 1, 0});
    scene.settings.width = scene.settings.height = 200;
    scene.camera.eye = {0, 0, 0}, scene.camera.target = {0, 1, 0}, scene.camera.fovY = 90;
    scene.camera.near = 0.5, scene.camera.far = 200;
    return scene;
}

// Seen from above, 10 pixels a unit, the origin in the middle of pixel 50, 50.
Scene sceneFromAbove(Scene scene) {
    scene.settings.width = scene.settings.height = 101;
    scene.camera.projection = ProjectionKind::Orthographic;
    scene.camera.eye = {0, 0, 5}, scene.camera.target = {0, 0, 0}, scene.camera.up = {0, 1, 0};
    scene.camera.height = 10.1;
    return scene;
}

std::map<int, double> weightsAt(const Scene& scene, glm::ivec2 pixel) {
    std::map<int, double> weights;
    for (const auto& [vertex, weight] : inspectPixel(*test::frameOf(scene), pixel).weights) weights[vertex] = weight;
    return weights;
}

// s is the place between the two edges in the picture, t the same place in space: t = s z0 / (s z0 + (1 - s) z1). In the
// middle of the picture 0.5 and 0.0099 (numerics: catalogue, C17).
TEST(VertexWeights, AreLinearInThePictureOrInSpace) {
    Scene scene = receding();
    for (const Interpolation mode : {Interpolation::Perspective, Interpolation::Affine, Interpolation::Scanline}) {
        scene.settings.interpolation = mode;
        const AnyBuffer intensity = *test::frameOf(scene)->buffer({BufferId::Intensity});
        for (std::size_t x = 50; x < 150; x += 7) {
            const double s = (double(x) + 0.5 - 50) / 100, t = s / (s + (1 - s) * 100);
            for (const std::size_t y : {std::size_t(57), std::size_t(100), std::size_t(131)})
                EXPECT_NEAR(intensity.value(x, y, 0), mode == Interpolation::Perspective ? t : s, 1e-12)
                    << x << ' ' << y;
        }
    }
}

TEST(VertexWeights, DepthAndPositionStayPerspectiveCorrect) {
    Scene scene = receding();
    const FramePtr perspective = test::frameOf(scene);
    for (const Interpolation mode : {Interpolation::Affine, Interpolation::Scanline}) {
        scene.settings.interpolation = mode;
        const FramePtr other = test::frameOf(scene);
        const BufferSet same =
            setOf({BufferId::Depth, BufferId::ZView, BufferId::Barycentric, BufferId::Position, BufferId::PolygonId});
        EXPECT_EQ(test::firstDifference(*perspective, *other, same), "");
        EXPECT_NE(test::firstDifference(*perspective, *other, setOf({BufferId::Intensity})), "");
    }
}

// On a square that stands straight the double interpolation is bilinear.
TEST(VertexWeights, OfASquareAreBilinear) {
    Scene scene = receding();
    scene.settings.interpolation = Interpolation::Scanline;
    const double s = (70.5 - 50) / 100, t = (120.5 - 50) / 100;  // from the left, from the top
    const auto w = weightsAt(scene, {70, 120});
    ASSERT_EQ(w.size(), 4u);
    EXPECT_NEAR(w.at(0), (1 - s) * t, 1e-12);  // left, below
    EXPECT_NEAR(w.at(1), s * t, 1e-12);
    EXPECT_NEAR(w.at(2), s * (1 - t), 1e-12);
    EXPECT_NEAR(w.at(3), (1 - s) * (1 - t), 1e-12);
    EXPECT_NE(
        toText(*test::frameOf(scene), inspectPixel(*test::frameOf(scene), {70, 120})).find("weights      scanline:"),
        std::string::npos);
}

// The known flaw of the double interpolation: what a pixel gets depends on how the polygon is turned. In the middle of a
// square with the intensities 1, 0, 1, 0 it is the mean 1/2 of all four; turned by 45 degrees the row through the middle
// meets the corners at its left and right alone: 0, or 1 when turned the other way. Given exactly: half a diagonal is 4.
TEST(VertexWeights, OfATurnedSquareDependOnTheTurn) {
    const auto middle = [](std::vector<Vec3d> corners, std::vector<double> intensities) {
        Scene scene = sceneFromAbove(withPolygon(std::move(corners), intensities));
        scene.settings.interpolation = Interpolation::Scanline;
        return test::frameOf(scene)->buffer({BufferId::Intensity})->value(50, 50, 0);
    };
    EXPECT_NEAR(middle({{-3, -3, 0}, {3, -3, 0}, {3, 3, 0}, {-3, 3, 0}}, {1, 0, 1, 0}), 0.5, 1e-12);
    EXPECT_NEAR(middle({{0, -4, 0}, {4, 0, 0}, {0, 4, 0}, {-4, 0, 0}}, {1, 0, 1, 0}), 0, 1e-12);
    EXPECT_NEAR(middle({{0, -4, 0}, {4, 0, 0}, {0, 4, 0}, {-4, 0, 0}}, {0, 1, 0, 1}), 1, 1e-12);
}

// A U: its rows above the notch have two spans. In the middle of the right arm the row is halfway up that arm's outer
// edge from 2 to -2 and three quarters up its inner one.
TEST(VertexWeights, OfAConcavePolygonAreThoseOfTheSpan) {
    Scene scene = sceneFromAbove(
        withPolygon({{-3, -2, 0}, {3, -2, 0}, {3, 2, 0}, {1, 2, 0}, {1, 0, 0}, {-1, 0, 0}, {-1, 2, 0}, {-3, 2, 0}},
                    {1, 0, 1, 0, 1, 0, 1, 0}));
    scene.settings.interpolation = Interpolation::Scanline;
    // Pixel (70, 40) is the point (2, 1): halfway between the edges from (1, 2) to (1, 0) and (3, -2) to (3, 2).
    const auto w = weightsAt(scene, {70, 40});
    ASSERT_EQ(w.size(), 4u);
    EXPECT_NEAR(w.at(3), 0.5 * 0.5, 1e-12);
    EXPECT_NEAR(w.at(4), 0.5 * 0.5, 1e-12);
    EXPECT_NEAR(w.at(1), 0.5 * 0.25, 1e-12);
    EXPECT_NEAR(w.at(2), 0.5 * 0.75, 1e-12);
}

// Over triangles the two are the same function: linear in the picture.
TEST(VertexWeights, OfATriangleScanlineIsAffine) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        Scene scene = test::randomScene(seed);
        scene.settings.precision = Precision::Double;
        scene.settings.shading = seed % 2 ? Shading::Gouraud : Shading::Phong;
        for (Object& object : scene.objects) {
            std::vector<std::vector<std::uint32_t>> triangles;
            for (const Triangle& t : object.mesh->triangles)
                triangles.push_back({t.vertices[0], t.vertices[1], t.vertices[2]});
            object.mesh = test::mesh(object.mesh->positions, triangles);
        }
        scene.settings.interpolation = Interpolation::Affine;
        const FramePtr affine = test::frameOf(scene);
        scene.settings.interpolation = Interpolation::Scanline;
        const FramePtr scanline = test::frameOf(scene);
        for (const BufferId id : {BufferId::Normal, BufferId::Intensity}) {
            const AnyBuffer a = *affine->buffer({id}), b = *scanline->buffer({id});
            for (std::size_t i = 0; i < a.count(); ++i)
                ASSERT_NEAR(a.flat(i), b.flat(i), 1e-7 * (1 + std::abs(a.flat(i)))) << seed << ' ' << i;
        }
    }
}

// A floor that runs under the eye: of three corners one lies behind it, and has no place in the picture.
TEST(VertexWeights, OfAClippedPolygonAreThoseOfThePiece) {
    Scene scene = withPolygon({{-8, 6, -1}, {0, -20, -1}, {8, 6, -1}}, {0, 1, 0});
    scene.settings.width = scene.settings.height = 64;
    scene.camera.eye = {0, 0, 0}, scene.camera.target = {0, 1, 0}, scene.camera.near = 0.25;
    scene.camera.fovY = 160;
    for (const Interpolation mode : {Interpolation::Affine, Interpolation::Scanline}) {
        scene.settings.interpolation = mode;
        const FramePtr frame = test::frameOf(scene);
        const AnyBuffer intensity = *frame->buffer({BufferId::Intensity});
        const BufferStatistics s = statistics(intensity);
        EXPECT_GE(s.min, 0);
        // At the near plane (6 - 0.25) / 26 of the way to the corner behind the eye; nothing is extrapolated from there.
        EXPECT_LE(s.max, 5.75 / 26 + 1e-12);
        EXPECT_GT(s.max, 0.15);
        const PixelReport r = inspectPixel(*frame, {32, 52});
        ASSERT_TRUE(r.covered);
        const bool instead = mode == Interpolation::Scanline;
        EXPECT_EQ(r.interpolation,
                  instead ? "affine, for scanline knows no polygon that is clipped or crosses itself" : "affine");
        EXPECT_EQ(frame->run(StageId::Shading).counts.find("affine") != std::string::npos, instead);
        double sum = 0;
        for (const auto& [vertex, weight] : r.weights) sum += weight;
        EXPECT_NEAR(sum, 1, 1e-12);
    }
}

TEST(VertexWeights, FlatShadingDoesNotReadThem) {
    Scene scene = receding();
    scene.settings.shading = Shading::Flat;
    const FramePtr first = test::frameOf(scene);
    scene.settings.interpolation = Interpolation::Scanline;
    const FramePtr second = test::frameOf(scene, test::everyBuffer(), 0, first);
    for (const PlanStep& step : second->plan()) EXPECT_NE(step.action, Action::Run);
    EXPECT_EQ(findSetting(scene, "interpolation")->setting->idle(scene), "Flat shading interpolates nothing.");
}

TEST(VertexWeights, OpenGlHasNoneButPerspectiveCorrectOnes) {
    Scene scene = test::openGlCube();
    scene.settings.shading = Shading::Gouraud;
    EXPECT_EQ(glRefuses(scene), "");
    scene.settings.interpolation = Interpolation::Affine;
    EXPECT_EQ(glRefuses(scene), "OpenGL interpolates perspective-correct: set interpolation to perspective");
}

}  // namespace
}  // namespace pipeline
