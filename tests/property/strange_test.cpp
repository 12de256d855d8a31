// Values that are possible but strange: no buffer holds a number that is none, and leaving out changes no bit.
#include <gtest/gtest.h>

#include "pipeline/plan/needs.h"
#include "pipeline/plan/scene_remarks.h"
#include "pipeline/scene/settings_table.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

class Strange : public testing::TestWithParam<unsigned> {};
INSTANTIATE_TEST_SUITE_P(Seeds, Strange, testing::Range(0u, 120u));

TEST_P(Strange, NoBufferHoldsANumberThatIsNone) {
    Scene scene = test::strangeScene(GetParam());
    ASSERT_EQ(format(checkScene(scene)), "");
    EXPECT_LE(sceneRemarks(scene).size(), kMaxRemarks);
    for (Precision precision : {Precision::Float, Precision::Double}) {
        scene.settings.precision = precision;
        EXPECT_EQ(test::buffersWithoutNumbers(*test::frameOf(scene)), "");
    }
}

TEST_P(Strange, LeavingOutChangesNoBit) {
    Scene scene = test::strangeScene(GetParam());
    const BufferSet useful = usefulBuffers(scene), picture = setOf({BufferId::Color, BufferId::Intensity});
    const FramePtr planned = test::frameOf(scene, useful), small = test::frameOf(scene, picture);
    scene.settings.leaveOut = false;
    const FramePtr forced = test::frameOf(scene, useful);
    EXPECT_EQ(test::firstDifference(*planned, *forced, useful), "");
    EXPECT_EQ(test::firstDifference(*small, *forced, picture), "");
}

}  // namespace
}  // namespace pipeline
