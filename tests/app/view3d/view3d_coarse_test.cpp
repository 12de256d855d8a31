// Of a large mesh a view that moves shows few triangles, and says so.
#include <cmath>

#include "tests/app/view3d/shown_view3d.h"
#include "tests/app/view3d/view3d_fixture.h"

namespace {

using app::Vec3d;
using pipeline::Triangle;

constexpr int kSide = 200, kCells = 8;

// A flat grid of 2·200² triangles over the unit square, 25 of its squares along each of 8 cells.
struct Grid {
    std::vector<Vec3d> positions;
    std::vector<Triangle> triangles;

    Grid() {
        for (int y = 0; y <= kSide; ++y)
            for (int x = 0; x <= kSide; ++x) positions.emplace_back(double(x) / kSide, double(y) / kSide, 0);
        for (std::uint32_t y = 0; y < kSide; ++y)
            for (std::uint32_t x = 0; x < kSide; ++x) {
                const std::uint32_t a = y * (kSide + 1) + x, b = a + kSide + 1;
                triangles.push_back({{a, a + 1, b + 1}});
                triangles.push_back({{a, b + 1, b}});
            }
    }
    static double area(Vec3d a, Vec3d b, Vec3d c) { return glm::length(glm::cross(b - a, c - a)) / 2; }
};

}  // namespace

// The first vertices of the cells stand on a grid from 0 to 7/8, 1/8 apart; between them the plane is whole. Only
// where four cells meet have the three corners of a triangle three cells: 2 triangles for each of 7² such places.
TEST(View3dCoarse, AFlatGridStaysOne) {
    const Grid grid;
    const auto coarse = app::coarseMesh(grid.positions, grid.triangles, kCells);
    EXPECT_EQ(coarse.size(), 2u * 49u);
    double area = 0;
    for (const auto& face : coarse) {
        const auto& [a, b, c] = face.vertices;
        area += Grid::area(grid.positions[a], grid.positions[b], grid.positions[c]);
    }
    EXPECT_NEAR(area, 49.0 / 64, 1e-12);
}

// Within a cell, whose diagonal is √3 / 8 of the longest side.
TEST(View3dCoarse, NoCornerMovesOutOfItsCell) {
    const Grid grid;
    for (const auto& face : app::coarseMesh(grid.positions, grid.triangles, kCells))
        for (std::size_t i = 0; i < 3; ++i) {
            const auto from = grid.triangles[face.face].vertices[i];
            EXPECT_LE(glm::length(grid.positions[from] - grid.positions[face.vertices[i]]), std::sqrt(3.0) / kCells);
        }
}

TEST(View3dCoarse, WhatIsNoNumberAndWhatHasNoExtentLeavesNothing) {
    Grid grid;
    for (auto& p : grid.positions) p = {NAN, 0, 0};
    EXPECT_TRUE(app::coarseMesh(grid.positions, grid.triangles, kCells).empty());
    for (auto& p : grid.positions) p = {1, 2, 3};
    EXPECT_TRUE(app::coarseMesh(grid.positions, grid.triangles, kCells).empty());
}

TEST(View3dCoarse, ASmallMeshHasNone) { EXPECT_FALSE(view3d::contentOf(test::pyramid()).mesh->coarse); }

// 400·800 quads and more, 639,200 triangles: no machine without a graphics card draws them smoothly within 40 ms, which
// is what a view that moves has.
TEST_F(ShownView3d, ALargeMeshIsCoarseWhileItMovesAndWholeAtRest) {
    pipeline::Scene scene = test::pyramid();
    scene.objects[0].mesh = test::sphere(150, 400, 800);
    document.setScene(scene);
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return view.space().content() && !document.frames().busy() && view.isDrawn(); }, 60000));
    ASSERT_TRUE(view.space().content()->mesh->coarse);
    EXPECT_LT(view.space().content()->mesh->coarse->size(), view.space().content()->mesh->faces.size() / 10);
    const auto* said = view.findChild<QLabel*>("coarse");
    EXPECT_FALSE(said->isVisible());

    bool wasCoarse = false;
    QObject::connect(&view, &app::SceneView::drawn, [&] { wasCoarse = wasCoarse || said->isVisible(); });
    for (int i = 0; i < 300 && !wasCoarse; ++i) {
        app::OrbitCamera camera = view.camera().now();
        app::orbit(camera, 3, 0);
        view.camera().set(camera);
        QTest::qWait(10);
    }
    EXPECT_TRUE(wasCoarse);
    EXPECT_TRUE(said->text().endsWith("triangles until it rests")) << said->text().toStdString();
    // The whole picture takes far longer than the moments between which it is told to stop.
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            document.work().cancel();
            return document.work().stopped().contains("the 3D view");
        },
        10000));
    QTest::qWait(1000);
    EXPECT_TRUE(said->isVisible());
    EXPECT_TRUE(said->text().endsWith("triangles: the rest was stopped")) << said->text().toStdString();
    document.work().resume();
    ASSERT_TRUE(waitUntilDrawn());
    EXPECT_FALSE(said->isVisible());
}
