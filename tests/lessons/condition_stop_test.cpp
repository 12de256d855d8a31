#include "lessons/expression/condition_stop.h"

#include <gtest/gtest.h>

#include "tests/lessons/pyramid_scene.h"

namespace lessons {
namespace {

using pipeline::BufferId;
using pipeline::Moment;
using pipeline::StageId;

// Lecture 1's pyramid: of polygons 0 to 4 the z-buffer draws 1, 2 and 3, in that order.
class ConditionStopTest : public testing::Test {
protected:
    static void SetUpTestSuite() {
        s_scene = pyramidScene();
        pipeline::FrameRequest request;
        request.wanted = pipeline::setOf({BufferId::NDotL, BufferId::ZView});
        s_steps = std::make_shared<const pipeline::Steps>(
            runFrame(std::make_shared<const pipeline::Scene>(s_scene), request, nullptr));
    }
    static std::optional<ConditionStop> stop(std::string_view text, std::optional<Moment> from = {}) {
        const auto condition = parseCondition(text, {"--where", 1, 1}, {s_scene});
        EXPECT_TRUE(condition) << (condition ? "" : format(condition.errors()));
        return nextStop(*s_steps, from.value_or(s_steps->first()), *condition);
    }
    // Whether it holds at a pixel in the state at a moment: asked of the whole state, one moment alone.
    static bool holds(std::string_view text, Moment moment, glm::ivec2 pixel) {
        const auto frame = s_steps->frameAt(moment);
        const auto mask = maskOf(*parseCondition(text, {"--where", 1, 1}, {s_scene}), {.frame = *frame});
        return mask && mask->holds[std::size_t(pixel.y) * std::size_t(mask->size.x) + std::size_t(pixel.x)];
    }

    static inline pipeline::Scene s_scene;
    static inline std::shared_ptr<const pipeline::Steps> s_steps;
};

}  // namespace

TEST_F(ConditionStopTest, StopsRightAfterTheFragmentThatMakesItHold) {
    for (const char* text : {"polygon_id == 2", "z_view < 690", "polygon_id == 1 && y > 290", "x > 270"}) {
        const auto found = stop(text);
        ASSERT_TRUE(found) << text;
        EXPECT_EQ(found->moment.stage, StageId::ZBuffer) << text;
        EXPECT_TRUE(holds(text, found->moment, found->pixel)) << text;
        // One step before, it holds nowhere: nothing earlier was missed.
        const auto before = s_steps->frameAt({found->moment.stage, found->moment.done - 1});
        EXPECT_EQ(maskOf(*parseCondition(text, {"--where", 1, 1}, {s_scene}), {.frame = *before})->count, 0u) << text;
    }
}

TEST_F(ConditionStopTest, GoesOnFromWhereItStands) {
    const auto first = stop("polygon_id == 2");
    const auto second = stop("polygon_id == 2", first->moment);
    ASSERT_TRUE(second);
    EXPECT_EQ(second->moment.done, first->moment.done + 1) << "the next fragment of the polygon";
    EXPECT_NE(second->pixel, first->pixel);
}

// What reads a buffer of the shading stage holds when its pixel is shaded.
TEST_F(ConditionStopTest, WaitsForTheStageThatMakesItsBuffers) {
    const char* text = "n_dot_l.0 > 0.5 && x > 280";
    const auto found = stop(text);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->moment.stage, StageId::Shading);
    EXPECT_GT(found->pixel.x, 280);
    EXPECT_TRUE(holds(text, found->moment, found->pixel));
    EXPECT_FALSE(holds(text, {StageId::Shading, found->moment.done - 1}, found->pixel));
}

TEST_F(ConditionStopTest, SaysWhereNoneComes) {
    EXPECT_FALSE(stop("z_view < 0"));
    EXPECT_FALSE(stop("polygon_id == 2", s_steps->last()));
}

}  // namespace lessons
