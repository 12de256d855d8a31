#include "lessons/expression/condition.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/lessons/pyramid_scene.h"

namespace lessons {
namespace {

using pipeline::BufferId;

// Lecture 1's pyramid, with one light; asked for what the conditions below name.
class ConditionTest : public testing::Test {
protected:
    static void SetUpTestSuite() {
        s_scene = pyramidScene();
        pipeline::FrameRequest request;
        request.wanted = pipeline::setOf({BufferId::NDotL, BufferId::RDotV, BufferId::Normal, BufferId::Color,
                                          BufferId::ZView, BufferId::LightVector});
        s_frame = runFrame(std::make_shared<const pipeline::Scene>(s_scene), request, nullptr);
    }
    static std::string refusal(std::string_view text) {
        const auto read = parseCondition(text, {"--where", 1, 1}, {s_scene});
        return read ? "read" : format(read.errors().front());
    }
    static ConditionMask mask(std::string_view text) {
        const auto read = parseCondition(text, {"--where", 1, 1}, {s_scene});
        EXPECT_TRUE(read) << (read ? "" : format(read.errors()));
        if (!read) return {};
        const auto found = maskOf(*read, {.frame = *s_frame});
        EXPECT_TRUE(found) << (found ? "" : format(found.errors()));
        return found ? *found : ConditionMask{};
    }
    // The same question asked of every drawn pixel one by one.
    template <class Holds>
    static std::size_t counted(Holds holds) {
        const auto ids = *s_frame->buffer({BufferId::PolygonId});
        std::size_t count = 0;
        for (std::size_t y = 0; y < ids.rows(); ++y)
            for (std::size_t x = 0; x < ids.columns(); ++x) count += ids.value(x, y) >= 0 && holds(x, y);
        return count;
    }
    static pipeline::AnyBuffer buffer(const pipeline::BufferName& name) { return *s_frame->buffer(name); }

    static inline pipeline::Scene s_scene;
    static inline pipeline::FramePtr s_frame;
};

TEST_F(ConditionTest, CountsTheDrawnPixelsForWhichItHolds) {
    const auto z = buffer({BufferId::ZView});
    const ConditionMask near = mask("z_view < 700");
    EXPECT_EQ(near.count, counted([&](std::size_t x, std::size_t y) { return z.value(x, y) < 700; }));
    EXPECT_GT(near.count, 0u);
    EXPECT_LT(near.count, near.drawn);
    EXPECT_EQ(near.drawn, counted([](std::size_t, std::size_t) { return true; }));
    // The background is +∞ far away, but nothing is drawn there.
    EXPECT_EQ(mask("z_view > 0").count, near.drawn);
}

TEST_F(ConditionTest, AndOrAndNotBindAsInC) {
    const auto all = mask("z_view > 0").count, near = mask("z_view < 700").count, left = mask("x < 260").count;
    const auto both = mask("z_view < 700 && x < 260").count;
    EXPECT_EQ(mask("z_view < 700 || x < 260").count, near + left - both);
    EXPECT_EQ(mask("!(z_view < 700)").count, all - near);
    EXPECT_EQ(mask("x < 0 && x < 0 || z_view < 700").count, near);  // && first
    EXPECT_EQ(mask("x < 0 && (x < 0 || z_view < 700)").count, 0u);
    EXPECT_EQ(mask("1 + 2 * 3 ^ 2 == 19").count, all);
    EXPECT_EQ(mask("-2 ^ 2 == -4").count, all);
}

TEST_F(ConditionTest, ALightsIndexMayBeLeftAwayWhereThereIsOneLight) {
    const auto lit = buffer({BufferId::NDotL, 0});
    const auto bright = counted([&](std::size_t x, std::size_t y) { return lit.value(x, y) > 0.5; });
    EXPECT_GT(bright, 0u);
    EXPECT_EQ(mask("n_dot_l.0 > 0.5").count, bright);
    EXPECT_EQ(mask("n_dot_l > 0.5").count, bright);
}

TEST_F(ConditionTest, ChannelsAndVectors) {
    const auto all = mask("z_view > 0").count;
    const auto color = buffer({BufferId::Color}), normal = buffer({BufferId::Normal});
    EXPECT_EQ(mask("color.b > color.r + 50").count,
              counted([&](std::size_t x, std::size_t y) { return color.value(x, y, 2) > color.value(x, y, 0) + 50; }));
    EXPECT_EQ(mask("normal.z > 0.2").count,
              counted([&](std::size_t x, std::size_t y) { return normal.value(x, y, 2) > 0.2; }));
    EXPECT_EQ(mask("abs(length(normal) - 1) < 1e-6").count, all);  // unit vectors
    // N·L is the dot product of N and L, to a few units of float's last place.
    EXPECT_EQ(mask("abs(dot(normal, light_vector) - n_dot_l) < 1e-6").count, all);
    EXPECT_EQ(mask("length(2 * normal - normal * 2) == 0").count, all);
    EXPECT_EQ(mask("max(x, y) >= x && min(x, y) <= y").count, all);
}

TEST_F(ConditionTest, SpeaksTheLanguageOfLessons) {
    const auto bright = mask("n_dot_l > 0.5").count, left = mask("n_dot_l > 0.5 && x < 260").count;
    EXPECT_EQ(mask("n_dot_l > 0.5 and x < 260").count, left);
    EXPECT_EQ(mask("not n_dot_l > 0.5 or x < 260").count, mask("!(n_dot_l > 0.5) || x < 260").count);
    EXPECT_EQ(mask("if(x < 260, n_dot_l, -1) > 0.5").count, left);
    EXPECT_EQ(mask("n_dot_l > buffer(n_dot_l.0, 268, 281) - 0.25").count, counted([&](std::size_t x, std::size_t y) {
                  const auto lit = buffer({BufferId::NDotL, 0});
                  return lit.value(x, y) > lit.value(268, 281) - 0.25;
              }));
    EXPECT_EQ(mask("length(cross(normal, light_vector)) ^ 2 + dot(normal, light_vector) ^ 2 > 0.999").count,
              mask("x >= 0").count);
    EXPECT_EQ(mask("color = color and color != [1, 2, 3] and setting(shading) = flat").count, mask("x >= 0").count);
    EXPECT_EQ(mask("pixels(n_dot_l > 0.5) = 0").count, bright == 0 ? mask("x >= 0").count : 0u);
    EXPECT_EQ(refusal("buffer(depth, x, y) > 0"),
              "--where:1:15: buffer is asked of one place, not of each pixel, expected numbers that are the same for "
              "every pixel");
}

TEST_F(ConditionTest, WhatHasNoNumberIsFalse) {
    EXPECT_EQ(mask("sqrt(0 - z_view) < 1").count, 0u);
    EXPECT_EQ(mask("sqrt(0 - z_view) >= 1").count, 0u);
    EXPECT_EQ(mask("sqrt(0 - z_view) != 1").count, 0u);
}

TEST_F(ConditionTest, ErrorsSayInWhichColumn) {
    EXPECT_EQ(refusal("n_dot_l.0"), "--where:1:1: found a number, expected a comparison such as n_dot_l.0 > 0.5");
    EXPECT_EQ(refusal("z_vew < 1"), "--where:1:1: no buffer \"z_vew\"; the nearest is \"z_view\"");
    EXPECT_EQ(refusal("x > 1 && normal > 0"),
              "--where:1:10: found a vector, expected a number: one of its channels (.x), or length(…)");
    EXPECT_EQ(refusal("n_dot_l.3 > 0"), "--where:1:1: no buffer \"n_dot_l.3\": this scene has 1 light");
    EXPECT_EQ(refusal("vertices.world.x > 0"),
              "--where:1:1: \"vertices.world.x\" does not stand on pixels, expected a buffer of the picture");
    EXPECT_EQ(refusal("x > 1 &&"), "--where:1:9: found the end, expected a number, a buffer, a function or '('");
    EXPECT_EQ(refusal("sqr(x) > 1"), "--where:1:1: no function \"sqr\"; the nearest is \"sqrt\"");
    EXPECT_EQ(refusal("x > 1 1"), "--where:1:7: found \"1\", expected an operator or the end");
    EXPECT_EQ(refusal("z_view.y > 1"), "--where:1:1: no channel \"y\": z_view has one value a pixel");
    EXPECT_NE(refusal(std::string(200, '(')).find("more than 50"), std::string::npos);
    EXPECT_NE(refusal(std::string(200, '!')).find("more than 50"), std::string::npos);
}

// What a chain is kept as is as deep as the chain is long.
TEST_F(ConditionTest, RefusesAChainWithoutEnd) {
    const auto chain = [](int operators) {
        std::string text = "x";
        for (int i = 0; i < operators; ++i) text += i % 2 ? " + 1" : " * 1";
        return text;
    };
    EXPECT_EQ(mask(chain(499) + " > 0").count, mask("x > 0").count) << "500 operators with the comparison";
    EXPECT_NE(refusal(chain(800) + " > 0").find("more than 500 operators"), std::string::npos);
    std::string either = "x > 1";
    for (int i = 0; i < 300; ++i) either += " || x > 1";
    EXPECT_NE(refusal(either).find("more than 500 operators"), std::string::npos);
}

TEST_F(ConditionTest, IsABufferOfOnesAndZeros) {
    const ConditionMask found = mask("z_view < 700");
    const pipeline::AnyBuffer buffer = bufferOf(found);
    EXPECT_EQ(buffer.name.text(), "condition");
    EXPECT_EQ(buffer.shape, (std::vector<std::size_t>{480, 640}));
    for (std::size_t i = 0; i < buffer.count(); ++i) ASSERT_EQ(buffer.flat(i), found.holds[i] ? 1 : 0) << i;
}

// A number without a comparison; nothing drawn is 0, and what has no number stays so.
TEST_F(ConditionTest, NumbersAreABufferToo) {
    const auto numbers = [](std::string_view text) {
        const auto read = parseNumbers(text, {"--where", 1, 1}, {s_scene});
        EXPECT_TRUE(read) << (read ? "" : format(read.errors()));
        return numbersOf(*read, {.frame = *s_frame}).value();
    };
    const pipeline::AnyBuffer twice = numbers("2 * n_dot_l - x");
    const auto ids = *s_frame->buffer({BufferId::PolygonId}), dots = *s_frame->buffer({BufferId::NDotL, 0});
    EXPECT_EQ(twice.name.text(), "expression");
    for (std::size_t i = 0; i < ids.count(); ++i)
        ASSERT_EQ(twice.flat(i), ids.flat(i) < 0 ? 0 : 2 * dots.flat(i) - double(i % 640)) << i;
    EXPECT_TRUE(std::isinf(numbers("1 / (x - 268)").value(268, 281)));
    const auto refused = [](std::string_view text) {
        return format(parseNumbers(text, {"--where", 1, 1}, {s_scene}).errors().front());
    };
    EXPECT_EQ(refused("x < 3"), "--where:1:1: found a comparison, expected a number");
    EXPECT_EQ(refused("normal"),
              "--where:1:1: found a vector, expected a number: one of its channels (.x), or length(…)");
}

TEST_F(ConditionTest, AFrameWithoutTheBufferIsAnError) {
    const auto read = parseCondition("specular.r > 1", {}, {s_scene});
    ASSERT_TRUE(read);
    EXPECT_TRUE(read->buffers[index(BufferId::Specular)]);
    pipeline::FrameRequest request;
    request.until = pipeline::StageId::ZBuffer;
    const auto frame = runFrame(std::make_shared<const pipeline::Scene>(s_scene), request, nullptr);
    EXPECT_FALSE(maskOf(*read, {.frame = *frame}));
}

TEST(NextHolding, GoesRoundInReadingOrder) {
    const ConditionMask mask{{3, 2}, {false, true, false, false, true, false}, 2, 6};
    EXPECT_EQ(nextHolding(mask, std::nullopt), glm::ivec2(1, 0));
    EXPECT_EQ(nextHolding(mask, glm::ivec2(1, 0)), glm::ivec2(1, 1));
    EXPECT_EQ(nextHolding(mask, glm::ivec2(1, 1)), glm::ivec2(1, 0));
    EXPECT_EQ(nextHolding(mask, glm::ivec2(1, 0), false), glm::ivec2(1, 1));
    EXPECT_EQ(nextHolding(ConditionMask{{3, 2}, std::vector<bool>(6), 0, 6}, std::nullopt), std::nullopt);
}

// A pane over nothing: no polygon stands there, and what is seen is the pane's.
TEST(Condition, CountsPixelsThatOnlyTranslucentSurfacesShow) {
    pipeline::Scene scene = pyramidScene();
    scene.objects[0].material.alpha = 0.5;
    const auto holding = [&](const char* text) {
        const auto condition = parseCondition(text, {"--where", 1, 1}, {scene});
        EXPECT_TRUE(condition) << (condition ? "" : format(condition.errors()));
        const auto frame = frameOf(scene, condition->buffers);
        const auto mask = maskOf(*condition, {.frame = *frame});
        EXPECT_TRUE(mask) << (mask ? "" : format(mask.errors()));
        return mask->count;
    };
    // tests/reference/lecture1_pyramid_test.cpp: three faces are seen, each pixel by one.
    EXPECT_EQ(holding("layers == 1"), 2686u);
    EXPECT_EQ(holding("intensity.b > 0"), 2686u);
    EXPECT_EQ(holding("x >= 0"), 2686u) << "whatever it names";
    EXPECT_EQ(holding("overdraw == 0"), 2686u) << "nothing of it arrives at the z-buffer";
}

}  // namespace
}  // namespace lessons
