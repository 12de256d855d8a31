#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "app/drawing3d/aids_drawing.h"
#include "app/drawing3d/label_places.h"
#include "app/drawing3d/point_drawing.h"
#include "app/drawing3d/space_content.h"
#include "app/drawing3d/space_drawing.h"
#include "app/drawing3d/view_content.h"
#include "app/drawing3d/world_drawing.h"
#include "tests/app/view3d/view3d_fixture.h"
#include "tests/support/scenes.h"

using namespace view3d;

// x from 200 to 470, y and z from 0 to 150.
TEST(View3dAids, ObjectsHaveBoundsThatHoldTheirVertices) {
    const ViewContent content = contentOf(test::pyramid());
    ASSERT_EQ(content.mesh->objects.size(), 1u);
    const app::ObjectBounds& bounds = content.mesh->objects[0];
    expectNear(bounds.box.min, {200, 0, 0}, 1e-4);
    expectNear(bounds.box.max, {470, 150, 150}, 1e-4);
    for (const Vec3d& p : content.mesh->positions)
        EXPECT_LE(glm::length(p - bounds.sphere.centre), bounds.sphere.radius);
}

// Boxes are drawn around every object, and nothing of it is hidden by leaving the vectors out.
TEST(View3dAids, AidsAreSwitchedOneByOne) {
    const ViewContent content = contentOf(test::pyramid());
    const app::ViewFrame view{app::presetCamera(app::ViewPreset::Iso, content, {}, {640, 480}, false), {640, 480}};
    const auto lines = [&](const app::ViewOptions& options) {
        return app::drawWorld(content, options, view).lines.size();
    };
    const std::size_t plain = lines({});
    EXPECT_EQ(lines({.boxes = true}), plain + 12);
    EXPECT_EQ(lines({.spheres = true}), plain + 4 * 72);
    EXPECT_EQ(lines({.frustum = true}), plain + 16);  // two rectangles, four edges, four lines to the eye
}

// At z_view the picture's corner is ±320 z / 200 to the side and ±240 z / 200 up: d = 200, 640 × 480.
TEST(View3dAids, TheFrustumIsWhatTheCameraSees) {
    const ViewContent content = contentOf(test::pyramid());
    const pipeline::View& eye = content.eye;
    const auto corners = app::frustumCorners(eye);
    for (std::size_t i = 0; i < 8; ++i) {
        const double z = i < 4 ? eye.near : eye.far;
        const Vec3d d = corners[i] - eye.eye;
        EXPECT_NEAR(glm::dot(d, eye.forward), z, 1e-9 * z);
        EXPECT_NEAR(std::abs(glm::dot(d, eye.right)), 320 * z / 200, 1e-9 * z);
        EXPECT_NEAR(std::abs(glm::dot(d, eye.up)), 240 * z / 200, 1e-9 * z);
    }
    pipeline::Scene scene = test::openGlCube();
    scene.camera.projection = pipeline::ProjectionKind::Orthographic;
    scene.camera.height = 3;  // world units from top to foot
    const auto box = app::frustumCorners(contentOf(scene).eye);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(std::abs(box[i].x), 2, 1e-9) << "3 · 640 / 480 / 2";
        EXPECT_NEAR(std::abs(box[i].y), 1.5, 1e-9);
        expectNear(box[i + 4] - box[i], {0, 0, -9}, 1e-9);  // from near = 1 to far = 10, looking along −z
    }
}

TEST(View3dAids, OutsideShowsTheWholeFrustumInEveryProjection) {
    for (const auto projection : {pipeline::ProjectionKind::Perspective, pipeline::ProjectionKind::Orthographic})
        for (const bool orthographic : {false, true}) {
            pipeline::Scene scene = test::openGlCube();
            scene.camera.projection = projection;
            const ViewContent content = contentOf(scene);
            const glm::dvec2 size{640, 480};
            const auto camera = app::presetCamera(app::ViewPreset::Outside, content, {}, size, orthographic);
            EXPECT_NEAR(glm::length(glm::cross(camera.right, camera.up) + camera.forward), 0, 1e-12);
            for (const Vec3d& corner : app::frustumCorners(content.eye)) {
                const app::Projected p = app::project(camera, size, corner);
                EXPECT_TRUE(p.inFront && p.at.x > 0 && p.at.y > 0 && p.at.x < size.x && p.at.y < size.y);
            }
            EXPECT_GT(glm::dot(camera.forward, content.eye.forward), 0.5) << "from behind the eye";
        }
}

TEST(View3dAids, MarksWhatIsSelected) {
    const pipeline::FramePtr frame = test::frameOf(test::pyramid());
    const ViewContent content = app::contentOf(*frame, kRightFace);
    using Kind = lessons::Selection::Kind;
    const auto marked = [&](Kind kind, std::size_t index) {
        return app::withSelection(content, *frame, lessons::Selection{kind, index});
    };
    EXPECT_EQ(marked(Kind::Polygon, 0).outlinedLoop(), (std::vector<std::uint32_t>{0, 1, 4}));
    expectNear(*marked(Kind::Vertex, 4).markedVertex, {335, 75, 150}, 1e-4);
    expectNear(marked(Kind::Object, 0).markedBox->max, {470, 150, 150}, 1e-4);
    EXPECT_EQ(app::withSelection(marked(Kind::Polygon, 0), *frame, {}).outlinedLoop(), content.pickedLoop);
    EXPECT_FALSE(marked(Kind::Vertex, 5).markedVertex) << "there is no such vertex";
}

// The box's twelve edges, x from 200 to 470, y and z from 0 to 150, beside the picked polygon's three; in clip space,
// where they are projected, as many.
TEST(View3dAids, AMarkedObjectIsOutlinedByItsBox) {
    const pipeline::FramePtr frame = test::frameOf(test::pyramid());
    const ViewContent content = app::contentOf(*frame, kRightFace);
    EXPECT_EQ(app::markedOutline(content).size(), 3u) << "the picked triangle";
    const ViewContent marked =
        app::withSelection(content, *frame, lessons::Selection{lessons::Selection::Kind::Object, 0});
    const auto outline = app::markedOutline(marked);
    ASSERT_EQ(outline.size(), 15u);
    std::array<int, 3> along{};
    for (const app::Segment& edge : std::span(outline).subspan(3)) {
        const Vec3d d = glm::abs(edge.b - edge.a);
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_TRUE(std::abs(edge.a[axis] - (axis == 0 ? 200 : 0)) < 1e-4 ||
                        std::abs(edge.a[axis] - (axis == 0 ? 470 : 150)) < 1e-4);
            along[std::size_t(axis)] += d[axis] > 1e-4;
        }
        EXPECT_NEAR(d.x + d.y + d.z, d.x > 1 ? 270 : 150, 1e-4);
    }
    EXPECT_EQ(along, (std::array<int, 3>{4, 4, 4}));
    const auto clip = app::mapOf(marked, {app::ViewSpace::Clip});
    ASSERT_TRUE(clip);
    EXPECT_EQ(app::markedOutline(app::inSpace(marked, *clip)).size(), 15u);
}

// (N·L) N ends where the plane through L's tip across N cuts N; N·L = 3/√15 = 0.7746.
TEST(View3dAids, ProjectionAndReflectionAreConstructed) {
    const auto point = app::pointContent(contentOf(test::pyramid(), kRightFace));
    ASSERT_TRUE(point);
    const app::ViewFrame view{app::pointCamera(app::ViewPreset::Iso, *point, {.reflection = true}, {640, 480}, false),
                              {640, 480}};
    const auto labelled = [&](const app::ViewOptions& options, const std::string& words) -> std::optional<Vec3d> {
        for (const app::Label& label : app::drawPoint(*point, options, view).labels)
            if (label.text == words) return label.at;
        return {};
    };
    EXPECT_FALSE(labelled({}, "(N·L)N = 0.7746 N"));
    EXPECT_TRUE(labelled({.projection = true}, "(N·L)N = 0.7746 N"));
    // The thick part of N ends there: the farthest corner of the first solid that is added, less its radius.
    const auto solids = app::drawPoint(*point, {.projection = true}, view).solids;
    ASSERT_FALSE(solids.empty());
    double top = 0;
    for (const Vec3d& p : solids[0].solid.positions) top = std::max(top, p.z);
    EXPECT_NEAR(top, 3 / std::sqrt(15.0), 1e-6);
    const auto twice = labelled({.reflection = true}, "2(N·L)N = 1.5492 N");
    ASSERT_TRUE(twice);
    expectNear(*twice, {0, 0, 6 / std::sqrt(15.0)}, 1e-6);
    EXPECT_TRUE(labelled({.reflection = true}, "R = 2(N·L)N − L"));
    const auto side = labelled({.reflection = true}, "−L");  // in the middle of the side from there to R
    ASSERT_TRUE(side);
    expectNear(2.0 * *side - *twice, vectorOf(*point, VectorCode::R).direction, 1e-6);
    const app::Projected end = app::project(view.camera, view.size, *twice);
    EXPECT_TRUE(end.at.y > 0 && end.at.y < 480) << "the construction fits into the view";
}

// V leads to the eye: where the view looks from there, its tip has no place in it.
TEST(View3dAids, LabelsStandInTheViewThatLooksFromTheScenesOwnEye) {
    const std::pair<pipeline::Scene, glm::ivec2> cases[]{{test::pyramid(), kRightFace},
                                                         {test::openGlCube(), {320, 240}}};
    for (const auto& [scene, pixel] : cases) {
        const ViewContent content = contentOf(scene, pixel);
        const glm::dvec2 size{640, 480};
        const app::ViewFrame view{app::presetCamera(app::ViewPreset::Eye, content, {}, size, false), size};
        const auto labels = placeLabels(app::drawWorld(content, {}, view), view);
        EXPECT_FALSE(labels.empty());
        for (const app::PlacedLabel& placed : labels)
            EXPECT_TRUE(QRectF(0, 0, size.x, size.y).contains(boxOf(placed)))
                << placed.label.text << ' ' << placed.at.x << ' ' << placed.at.y;
    }
}
