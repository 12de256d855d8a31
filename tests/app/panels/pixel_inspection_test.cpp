// What is known about the picked pixel is found once, and beside the window where there are many polygons.
#include "app/frames/pixel_inspection.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "app/document/document.h"
#include "app/frames/large_frame.h"
#include "tests/app/large_scene.h"

namespace {

using app::Document;
using app::PixelInspection;

constexpr glm::ivec2 kOnPyramid{268, 281};  // on polygon 2

struct PixelInspectionTest : testing::Test {
    Document document;
    PixelInspection& inspection = document.inspection();

    void open(const pipeline::Scene& scene) {
        document.setScene(scene);
        ASSERT_TRUE(QTest::qWaitFor([&] { return document.frames().shown() && !document.frames().busy(); }, 20000));
    }
    bool finished() {
        return QTest::qWaitFor([&] { return !inspection.busy(); }, 10000);
    }
};

}  // namespace

TEST_F(PixelInspectionTest, ASmallSceneIsInspectedAtOnceAndOnce) {
    open(test::pyramid());
    QSignalSpy changed(&inspection, &PixelInspection::changed);
    document.pointing().pick(kOnPyramid);
    ASSERT_TRUE(inspection.newest());
    EXPECT_EQ(inspection.newest()->report.polygon, 2);
    EXPECT_EQ(inspection.newest()->frame, document.frames().shown());
    EXPECT_EQ(changed.size(), 1);
    document.pointing().pick({});
    EXPECT_FALSE(inspection.newest());
}

TEST_F(PixelInspectionTest, OfManyPolygonsItComesFromElsewhereAndIsTheSame) {
    open(test::manyPolygons());
    ASSERT_TRUE(app::isLarge(*document.frames().shown()));
    document.pointing().pick(kOnPyramid);
    EXPECT_TRUE(inspection.busy());
    EXPECT_FALSE(inspection.newest()) << "the window does not wait for it";
    ASSERT_TRUE(finished());
    ASSERT_TRUE(inspection.newest());
    const auto expected = inspectPixel(*document.frames().shown(), kOnPyramid);
    EXPECT_EQ(inspection.newest()->report.polygon, expected.polygon);
    EXPECT_EQ(inspection.newest()->report.color, expected.color);
    EXPECT_EQ(inspection.newest()->report.fragments.size(), expected.fragments.size());
}

// Of what the pointer passes over in one go, the first, which has begun, and the last.
TEST_F(PixelInspectionTest, OfManyPixelsInARowTheNewestComesLast) {
    open(test::manyPolygons());
    QSignalSpy changed(&inspection, &PixelInspection::changed);
    for (int x = 0; x < 50; ++x) document.pointing().pick(kOnPyramid + glm::ivec2(x, 0));
    ASSERT_TRUE(finished());
    EXPECT_EQ(inspection.newest()->report.pixel, kOnPyramid + glm::ivec2(49, 0));
    EXPECT_LE(changed.size(), 2);
}

TEST_F(PixelInspectionTest, AnotherSceneHasNoPixelOfTheOneBefore) {
    open(test::manyPolygons());
    document.pointing().pick(kOnPyramid);
    document.setScene(test::pyramid());
    EXPECT_FALSE(inspection.busy());
    EXPECT_FALSE(inspection.newest());
}
