#include "pipeline/stages/outlines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "pipeline/inspect/pixel_report.h"
#include "pipeline/plan/needs.h"
#include "pipeline/scene/settings_table.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

using Pixels = std::set<std::pair<int, int>>;

Pixels drawn(const Frame& frame) {
    const AnyBuffer ids = *frame.buffer({BufferId::PolygonId});
    Pixels pixels;
    for (std::size_t y = 0; y < ids.rows(); ++y)
        for (std::size_t x = 0; x < ids.columns(); ++x)
            if (ids.value(x, y) >= 0) pixels.insert({int(x), int(y)});
    return pixels;
}

// Seen from above, a pixel a unit, the world's origin in the corner between the four pixels in the middle of 20 x 20.
Scene fromAbove(std::vector<Vec3d> positions) {
    std::vector<std::uint32_t> polygon(positions.size());
    for (std::uint32_t i = 0; i < polygon.size(); ++i) polygon[i] = i;
    Scene scene;
    scene.settings.width = scene.settings.height = 20;
    scene.settings.visibility = Visibility::None;
    scene.camera.kind = CameraKind::LookAt, scene.camera.projection = ProjectionKind::Orthographic;
    scene.camera.eye = {0, 0, 5}, scene.camera.target = {0, 0, 0}, scene.camera.up = {0, 1, 0};
    scene.camera.height = 20;
    scene.objects.push_back({"polygon", test::mesh(std::move(positions), {polygon}), {}, {}});
    return scene;
}

// From (-4.5, -2.5) to (4.5, 2.5): screen (5.5, 12.5) to (14.5, 7.5). In column i the centre i + 0.5 lies (i - 5) / 9 of
// the way, at y = 12.5 - 5 (i - 5) / 9: rows 12, 11, 11, 10, 10, 9, 9, 8, 8, 7. And straight sides for the rest.
TEST(Outlines, ALineHasOnePixelAColumn) {
    const FramePtr frame = test::frameOf(fromAbove({{-4.5, -2.5, 0}, {4.5, -2.5, 0}, {4.5, 2.5, 0}}));
    Pixels expected;
    const int rows[]{12, 11, 11, 10, 10, 9, 9, 8, 8, 7};
    for (int i = 0; i < 10; ++i) expected.insert({5 + i, rows[i]}), expected.insert({5 + i, 12});
    for (int y = 7; y <= 12; ++y) expected.insert({14, y});
    EXPECT_EQ(drawn(*frame), expected);
    EXPECT_EQ(frame->run(StageId::ZBuffer).counts, "26 fragments, 26 written; 1 outline");  // 10 + 10 + 6
    // The corner gets a fragment from both of its edges.
    EXPECT_EQ(frame->buffer({BufferId::Overdraw})->value(14, 12), 2);
    EXPECT_EQ(frame->buffer({BufferId::Overdraw})->value(9, 12), 1);
}

TEST(Outlines, AreWhiteOnBlackWhateverShines) {
    Scene scene = fromAbove({{-4.5, -2.5, 0}, {4.5, -2.5, 0}, {4.5, 2.5, 0}});
    for (int lights = 0; lights < 2; ++lights) {
        const FramePtr frame = test::frameOf(scene);
        const AnyBuffer color = *frame->buffer({BufferId::Color}), ids = *frame->buffer({BufferId::ObjectId});
        for (std::size_t i = 0; i < color.count(); ++i) ASSERT_EQ(color.flat(i), ids.flat(i / 3) < 0 ? 0 : 255);
        scene.lights.push_back({});
    }
}

// Which way round a polygon runs, and which polygon drew last, does not move a line.
TEST(Outlines, OfNeighboursShareTheirLine) {
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i) {
        const auto at = [&] { return Vec3d{int(random() % 4000) / 200.0 - 10, int(random() % 4000) / 200.0 - 10, 0}; };
        const Vec3d a = at(), b = at(), c = at();
        Scene scene = fromAbove({a, b, c}), turned = fromAbove({c, b, a});
        scene.settings.cull = turned.settings.cull = CullMode::None;
        ASSERT_EQ(drawn(*test::frameOf(scene)), drawn(*test::frameOf(turned))) << i;
    }
}

// 12 edges of a cube, each drawn by both of its polygons; from the front, culling leaves one polygon.
TEST(Outlines, CullingLeavesThoseThatFaceTheEye) {
    Scene scene = fromAbove({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    scene.objects[0].mesh = test::box({-6, -6, -40}, {6, 6, 0});
    scene.camera.projection = ProjectionKind::Perspective;
    scene.camera.eye = {0, 0, 30};
    scene.settings.cull = CullMode::None;
    const Pixels all = drawn(*test::frameOf(scene));
    scene.settings.cull = CullMode::Back;
    const FramePtr front = test::frameOf(scene);
    const Pixels kept = drawn(*front);
    EXPECT_LT(kept.size(), all.size());
    for (const auto& pixel : kept) EXPECT_TRUE(all.contains(pixel));
    EXPECT_EQ(statistics(*front->buffer({BufferId::PolygonId})).max, 1);  // the top alone
}

// A floor that runs under the eye: its sides end at the near plane, and no line appears along that plane.
TEST(Outlines, AreCutAtTheNearPlane) {
    Scene scene = fromAbove({{-2, 40, -1}, {-2, -40, -1}, {2, -40, -1}, {2, 40, -1}});
    scene.camera.projection = ProjectionKind::Perspective;
    scene.camera.eye = {0, 0, 0}, scene.camera.target = {0, 1, 0}, scene.camera.up = {0, 0, 1};
    scene.camera.near = 1;
    scene.camera.fovY = 120;
    scene.settings.cull = CullMode::None;
    scene.settings.width = scene.settings.height = 200;
    const FramePtr frame = test::frameOf(scene);
    const AnyBuffer z = *frame->buffer({BufferId::ZView});
    const BufferStatistics s = statistics(z);
    EXPECT_NEAR(s.max, 40, 1e-4);
    EXPECT_GE(s.min, 1);
    // tan 60° = 1.732 half the picture's height at distance 1: the sides leave the picture's floor at x = ±2 / z.
    for (const auto& [x, y] : drawn(*frame)) {
        const double distance = z.value(std::size_t(x), std::size_t(y));
        EXPECT_NEAR(y + 0.5, 100 + 100 / std::tan(std::acos(-1) / 3) / distance, 1.5);
        if (distance >= 39) continue;
        EXPECT_NEAR(std::abs(x + 0.5 - 100), 200 / std::tan(std::acos(-1) / 3) / distance, 1.5);
    }
}

// Whatever the threads, the tiles, what is left out, and whether a frame came before.
TEST(Outlines, HaveTheSameBitsAnyWay) {
    for (unsigned seed = 0; seed < 24; ++seed) {
        Scene scene = test::randomScene(seed);
        const FramePtr before = test::frameOf(scene);
        scene.settings.visibility = Visibility::None;
        const FramePtr one = test::frameOf(scene, test::everyBuffer(), 1);
        ASSERT_EQ(test::firstDifference(*one, *test::frameOf(scene, test::everyBuffer(), 7)), "") << seed;
        ASSERT_EQ(test::firstDifference(*one, *test::frameOf(scene, test::everyBuffer(), 0, before)), "") << seed;
        const BufferSet useful = usefulBuffers(scene);
        scene.settings.leaveOut = false;
        ASSERT_EQ(test::firstDifference(*one, *test::frameOf(scene, useful), useful), "") << seed;
        for (const AnyBuffer& buffer : one->buffers()) EXPECT_EQ(statistics(buffer).nan, 0u) << buffer.name.text();
    }
}

// The replay of a pixel tells the fragments that the frame counted, and what is seen.
TEST(Outlines, AReportAgreesWithTheFrame) {
    Scene scene = test::randomScene(5);
    scene.settings.visibility = Visibility::None, scene.settings.cull = CullMode::Back;
    const FramePtr frame = test::frameOf(scene);
    const AnyBuffer ids = *frame->buffer({BufferId::PolygonId}), came = *frame->buffer({BufferId::Overdraw});
    int seen = 0;
    for (int y = 0; y < scene.settings.height; ++y) {
        for (int x = 0; x < scene.settings.width; ++x) {
            const PixelReport r = inspectPixel(*frame, {x, y});
            ASSERT_EQ(r.polygon, ids.value(std::size_t(x), std::size_t(y)));
            ASSERT_EQ(double(r.fragments.size()), came.value(std::size_t(x), std::size_t(y)));
            seen += r.covered;
            if (!r.covered) continue;
            ASSERT_EQ(r.fragments.back().polygon, r.polygon);
            ASSERT_EQ(r.color, Color8(255));
            ASSERT_TRUE(r.evaluations.empty() && equation(frame->scene(), r, 0).empty());
            ASSERT_NE(toText(*frame, r).find("outline"), std::string::npos);
        }
    }
    EXPECT_GT(seen, 50);
}

TEST(Outlines, OfAnObjectThatIsAsIfNotThereAreNotDrawnWhateverIsCulled) {
    Scene scene = fromAbove({{-4.5, -2.5, 0}, {4.5, -2.5, 0}, {4.5, 2.5, 0}});
    scene.objects.push_back(scene.objects[0]);
    scene.objects[1].transform.translation = {0, 4, 0};
    scene.objects[0].material.alpha = 0;
    for (const CullMode cull : {CullMode::Back, CullMode::None}) {
        scene.settings.cull = cull;
        const AnyBuffer ids = *test::frameOf(scene)->buffer({BufferId::ObjectId});
        std::size_t seen = 0;
        for (std::size_t i = 0; i < ids.count(); ++i) {
            EXPECT_NE(ids.flat(i), 0);
            seen += ids.flat(i) == 1;
        }
        EXPECT_EQ(seen, 23u);  // of ALineHasOnePixelAColumn: 26 fragments, two at each of three corners
    }
}

TEST(Outlines, TheirPlanSaysWhatTheyDoNotNeed) {
    Scene scene = test::pyramid();
    scene.objects.push_back(scene.objects[0]);
    scene.settings.visibility = Visibility::None;
    scene.settings.shading = Shading::Phong;
    const FramePtr frame = test::frameOf(scene, usefulBuffers(scene));
    EXPECT_EQ(frame->plan()[index(StageId::ShadowBuffer)].why, "Outlines are not shaded.");
    EXPECT_FALSE(frame->buffer({BufferId::Depth}) || frame->buffer({BufferId::NDotL, 0}));
    EXPECT_EQ(frame->whyAbsent({BufferId::NDotL, 0}), "Outlines are not shaded.");
    EXPECT_EQ(frame->whyAbsent({BufferId::Depth}), "Outlines are drawn one over the other: no depths are compared.");
    for (const PlanPart& part : frame->plan()[index(StageId::Shading)].parts) {
        if (part.name == "tiles") continue;
        EXPECT_EQ(part.action, Action::LeaveOut) << part.name;
    }
    EXPECT_EQ(findSetting(scene, "shading")->setting->idle(scene), "Outlines are not shaded.");
}

}  // namespace
}  // namespace pipeline
