#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "pipeline/inspect/edge_view.h"
#include "pipeline/inspect/overlay_values.h"
#include "tests/support/scenes.h"

using namespace pipeline;

namespace {

// Seen along −z from above, one world unit a pixel: x to the right, y up, the origin in the picture's middle.
Scene flatScene(std::shared_ptr<const Mesh> mesh, int side) {
    Scene scene;
    scene.settings.width = scene.settings.height = side;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.projection = ProjectionKind::Orthographic;
    scene.camera.eye = {0, 0, 10}, scene.camera.target = {0, 0, 0}, scene.camera.up = {0, 1, 0};
    scene.camera.height = side, scene.camera.near = 1, scene.camera.far = 20;
    scene.settings.cull = CullMode::None;
    scene.objects.push_back({"object", std::move(mesh), {}, {}});
    return scene;
}

}  // namespace

TEST(EdgeView, CoversWhatTheZBufferCovers) {
    const FramePtr frame = test::frameOf(test::pyramid());
    const auto ids = *frame->buffer({BufferId::PolygonId});
    int covered = 0;
    for (int y = 240; y < 330; ++y)
        for (int x = 220; x < 320; ++x) {
            const auto view = edgeViewAt(*frame, {x, y});
            const auto id = int(ids.value(std::size_t(x), std::size_t(y)));
            ASSERT_EQ(view.has_value(), id >= 0) << x << ", " << y;
            if (!view) continue;
            ++covered;
            EXPECT_EQ(int(view->polygon), id);
            const EdgeSample sample = edgesAt(*view, {x, y});
            EXPECT_TRUE(sample.covered());
            EXPECT_EQ(sample.values[0] + sample.values[1] + sample.values[2], view->area2);
        }
    EXPECT_GT(covered, 1000);
}

TEST(EdgeView, ATriangleOwnsItsTopAndItsLeftEdge) {
    // In the picture, y down: (2, 2), (6, 2), (2, 6). The edge at the top and the one at the left own their samples.
    const FramePtr frame = test::frameOf(flatScene(test::mesh({{-2, 2, 0}, {2, 2, 0}, {-2, -2, 0}}, {{0, 2, 1}}), 8));
    const auto view = edgeViewAt(*frame, {3, 3});
    ASSERT_TRUE(view);
    EXPECT_EQ(view->area2, 4 * 4 * kEdgeUnits * kEdgeUnits);  // twice the area of 8 px²
    int left = 0, top = 0, other = 0;
    for (int i = 0; i < 3; ++i) {
        const auto ends = edgeEnds(*view, i);
        const EdgeSide side = edgeSide(*view, i);
        left += side == EdgeSide::Left, top += side == EdgeSide::Top, other += side == EdgeSide::Other;
        for (const auto& end : ends) {
            if (side == EdgeSide::Left) {
                EXPECT_EQ(end.x, 2 * kEdgeUnits);
            }
            if (side == EdgeSide::Top) {
                EXPECT_EQ(end.y, 2 * kEdgeUnits);
            }
        }
    }
    EXPECT_EQ(left, 1);
    EXPECT_EQ(top, 1);
    EXPECT_EQ(other, 1);
    // The centres (2.5, 5.5), (3.5, 4.5)… lie on the long edge, which does not own them.
    EXPECT_FALSE(edgesAt(*view, {3, 4}).covered());
    EXPECT_TRUE(edgesAt(*view, {2, 4}).covered());
}

TEST(EdgeView, NothingIsSeenOutsideThePicture) {
    const FramePtr frame = test::frameOf(test::pyramid());
    EXPECT_EQ(edgeViewAt(*frame, {-1, 0}), std::nullopt);
    EXPECT_EQ(edgeViewAt(*frame, {640, 0}), std::nullopt);
    EXPECT_EQ(edgeViewAt(*frame, {0, 0}), std::nullopt);
}

TEST(ScreenAreas, OfASquareOfFourByFourPixels) {
    const FramePtr frame =
        test::frameOf(flatScene(test::mesh({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}}, {{0, 1, 2, 3}}), 8));
    const auto areas = screenAreas(*frame);
    ASSERT_EQ(areas.size(), 1u);
    EXPECT_EQ(areas[0], 16);
}

TEST(DepthTests, TellWhatTheOrderOfDrawingWasted) {
    // Two squares of the same place at z = 0 and z = 1, the eye at z = 10: the second is nearer.
    const std::vector<Vec3d> low{{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}};
    const std::vector<Vec3d> high{{-2, -2, 1}, {0, -2, 1}, {0, 2, 1}, {-2, 2, 1}};
    const auto both = [](std::vector<Vec3d> first, const std::vector<Vec3d>& second) {
        first.insert(first.end(), second.begin(), second.end());
        return test::mesh(first, {{0, 1, 2, 3}, {4, 5, 6, 7}});
    };
    const auto at = [](const FramePtr& frame, int x, int y) { return depthTests(*frame)[std::size_t(y * 8 + x)]; };
    const FramePtr farFirst = test::frameOf(flatScene(both(low, high), 8));
    const FramePtr nearFirst = test::frameOf(flatScene(both(high, low), 8));
    EXPECT_EQ(at(farFirst, 0, 0), DepthTests::None);
    EXPECT_EQ(at(farFirst, 5, 4), DepthTests::OneWon);  // right half: the low square alone
    EXPECT_EQ(at(farFirst, 3, 4), DepthTests::Overwritten);
    EXPECT_EQ(at(nearFirst, 3, 4), DepthTests::SomeLost);
}

TEST(StrangeNumbers, AreCountedOnceAnElement) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();
    const std::vector<float> numbers{1, 2, 3, kNan, kNan, -1, kInf, 0, 0, -1, -2, 0};
    const AnyBuffer buffer{
        {BufferId::Intensity}, &bufferInfo(BufferId::Intensity), {1, 4, 3}, std::span<const float>(numbers), nullptr};
    const StrangeNumbers all = strangeNumbers(buffer, -1, {}, ProjectionKind::Perspective);
    EXPECT_EQ(all.nan, 1u);
    EXPECT_EQ(all.infinite, 1u);
    EXPECT_EQ(all.negative, 2u);  // the one that is NaN in another channel too
    EXPECT_EQ(all.elements, (std::vector{Strange::No, Strange::Nan, Strange::Infinite, Strange::Negative}));
    EXPECT_EQ(strangeNumbers(buffer, 2, {}, ProjectionKind::Perspective).negative, 1u);
    EXPECT_EQ(strangeNumbers(buffer, -1, {true, false, false, true}, ProjectionKind::Perspective).nan, 0u);
}

TEST(StrangeNumbers, DotProductsAndNormalsMayBeNegative) {
    const auto mayBe = [](BufferId id) { return mayBeNegative(bufferInfo(id), ProjectionKind::Perspective); };
    EXPECT_TRUE(mayBe(BufferId::NDotL));
    EXPECT_TRUE(mayBe(BufferId::Normal));
    EXPECT_TRUE(mayBe(BufferId::PolygonId));
    EXPECT_TRUE(mayBe(BufferId::ZNdc));
    EXPECT_FALSE(mayBe(BufferId::Intensity));
    EXPECT_FALSE(mayBe(BufferId::ZView));
    for (const BufferId id : {BufferId::PolygonsIntensity, BufferId::VerticesIntensity}) EXPECT_FALSE(mayBe(id));
    for (const BufferId id : {BufferId::Position, BufferId::VerticesWorld, BufferId::VerticesNormal})
        EXPECT_TRUE(mayBe(id));
}

// A square half a unit behind the eye, in a view whose near plane lies one unit behind it: z_view is -1/2.
TEST(StrangeNumbers, AnOrthographicViewSeesWhatLiesBehindTheEye) {
    Scene scene = flatScene(test::mesh({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}}, {{0, 1, 2, 3}}), 8);
    scene.camera.eye = {0, 0, -0.5}, scene.camera.target = {0, 0, -1};
    scene.camera.near = scene.camera.far = 0;  // as far as the scene goes
    const FramePtr frame = test::frameOf(scene);
    for (const BufferId id : {BufferId::ZView, BufferId::Depth}) {
        const AnyBuffer depths = *frame->buffer({id});
        EXPECT_EQ(depths.value(4, 4), -0.5);
        EXPECT_EQ(strangeNumbers(depths, -1, {}, ProjectionKind::Orthographic).negative, 0u);
        EXPECT_EQ(strangeNumbers(depths, -1, {}, ProjectionKind::Perspective).negative, 16u) << "4 by 4 pixels";
    }
}
